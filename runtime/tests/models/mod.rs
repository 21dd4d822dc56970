//! Models written by hand as the derive would write them. They stand in one module, so that the first file's imports and
//! macro serve all; the examples in the documentation include the pendulum alone.

#![allow(missing_docs, dead_code)]

include!("pendulum.rs");
include!("oscillator.rs");
include!("bead.rs");
include!("swing.rs");
