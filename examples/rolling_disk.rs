//! The rolling disk.
fn main() {}
