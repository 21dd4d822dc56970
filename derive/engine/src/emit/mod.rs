//! From programs to tokens. Decides nothing.
//!
//! | file | idea |
//! |---|---|
//! | [`target`] | what the user's struct gives |
//! | [`shape`] | the names and sizes of the emitted types |
//! | [`types`] | the emitted structs |
//! | [`text`] | function bodies as text |
//! | [`functions`] | the functions of the trait |
//! | [`charts`] | the functions that choose a chart |
//! | [`equations`] | the derived equations as text |
//! | [`layout`] | matrices in text |
//! | [`description`] | `MODEL` |
//! | `recursive` | the functions of mechanisms without M, in terms of others |
//! | [`system`] | the implementation of the trait |

pub mod charts;
pub mod description;
pub mod equations;
pub mod functions;
pub mod layout;
mod recursive;
pub mod shape;
pub mod system;
pub mod target;
#[cfg(test)]
mod tests;
pub mod text;
pub mod types;

pub use shape::Known;
pub use system::{diverging, implementation};
pub use target::{Declared, Target};
