//! Mechanisms of the literature from geometry alone.

pub mod arms;
pub mod balls;
pub mod bobs;
pub mod disc;
pub mod joints;
pub mod loops;
pub mod rods;
pub mod sleigh;
pub mod top;
pub mod whipple;
