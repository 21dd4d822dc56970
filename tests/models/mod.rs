//! The models that have an answer of their own: golden data, a closed form, or a published set.
//!
//! The larger ones, bodies and linkages, are derived only where they are used.
#![allow(dead_code, unused_imports, reason = "every test file uses its own models")]

pub mod blades;
pub mod energies;
pub mod kinds;
pub mod particles;
pub mod rolling_disc;
pub mod rolling_disk;
pub mod speeds;

pub use blades::*;
pub use energies::*;
pub use kinds::*;
pub use particles::*;
pub use rolling_disc::*;
pub use rolling_disk::*;
pub use speeds::*;
