//! What an assembly met, and what it could not.

use alloc::vec::Vec;

/// What was asked for and what became of it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AssemblyReport {
    /// The constraints and the other quantities, those of positions first.
    pub entries: Vec<Met>,
    /// Where something is not met, what is in the way: the entries of the state that were held or set and without which the
    /// rest could come nearer, and the other values asked for that are missed.
    pub conflicts: Vec<&'static str>,
}

/// One constraint or quantity of an assembly.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Met {
    /// The constraint's or the quantity's name.
    pub name: &'static str,
    /// What remains: left side minus right side, or the quantity minus the value that it was to have.
    pub residual: f64,
    /// The size of its terms: residuals of a few units of rounding of it count as zero.
    pub size: f64,
    /// Whether it is met.
    pub met: bool,
}

impl AssemblyReport {
    /// What is not met, with what remains.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState};
    /// use holonomy::prelude::*;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let guess = PendulumState { x: 0.4, y: -0.4, dot_x: 0.0 };
    /// let error = pendulum.assemble(guess).hold("x").hold("y").solve().unwrap_err();
    /// if let Error::Assembly { report, .. } = error {
    ///     let missed: Vec<_> = report.unmet().map(|entry| entry.name).collect();
    ///     assert_eq!(missed, ["rod"]);
    ///     assert_eq!(report.conflicts, ["x", "y"]);
    /// }
    /// # Ok::<(), Error>(())
    /// ```
    pub fn unmet(&self) -> impl Iterator<Item = &Met> {
        self.entries.iter().filter(|entry| !entry.met)
    }

    pub(super) fn append(&mut self, other: AssemblyReport) {
        self.entries.extend(other.entries);
        self.conflicts.extend(other.conflicts);
    }
}
