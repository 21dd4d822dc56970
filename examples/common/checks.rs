//! What a run promises; a promise that fails makes the program fail.

use std::process::ExitCode;

/// The promises of one example, told as they are checked.
#[derive(Default)]
pub struct Checks {
    failed: usize,
}

impl Checks {
    /// A figure and its bound; a figure that is not a number fails.
    pub fn below(&mut self, what: &str, value: f64, bound: f64) {
        println!("  {what}: {value:.2e} (at most {bound:.0e})");
        self.hold(what, value <= bound);
    }

    /// Anything else that must be true.
    pub fn hold(&mut self, what: &str, holds: bool) {
        if !holds {
            println!("  FAILED: {what}");
            self.failed += 1;
        }
    }

    /// The program's own result.
    pub fn verdict(&self) -> ExitCode {
        if self.failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
    }
}
