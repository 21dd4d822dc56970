//! From the initial system to the equations of motion: constraints differentiated, the tangent basis found, both
//! projections (Blajer 1992, sections 3 to 5).

pub mod equations;

pub use equations::{Equations, Guard, GuardKind};
