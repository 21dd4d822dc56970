//! From declarations to the initial system.

mod system;

pub use system::{ComplementRow, Configuration, InitialSystem, Kinematics, Row, RowKind};
