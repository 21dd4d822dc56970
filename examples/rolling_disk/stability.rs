//! The threshold of straight rolling, found by running the equations.

use crate::models::StagedDisk;
use crate::motion::{Disks, Posture};
use holonomy::{Error, Trajectory};
use indicatif::{ProgressBar, ProgressStyle};

/// Whether a disk that rolls straight ahead at the rate ψ̇ falls away from the upright after a small push.
fn falls(disks: &Disks, rate: f64) -> Result<bool, Error> {
    let push = 1e-7;
    let start = Posture { x: 0.0, y: 0.0, phi: 0.0, theta: 0.0, psi: 0.0, rates: [0.0, push, rate] };
    // 0.05 % below the threshold the lean reaches 600 times the push in this time; as far above, it swings within 8.
    let leans = |run: &Trajectory<StagedDisk>| run.iter().any(|(_, s)| s.theta.abs() > 100.0 * push);
    match disks.staged.simulate(start.staged()).tolerance(1e-9, 1e-13).every(0.05).until(40.0) {
        Ok(run) => Ok(leans(&run)),
        // A disk that falls flat ends its run at cos θ = 0.
        Err(interrupted) if leans(&interrupted.trajectory) => Ok(true),
        Err(interrupted) => Err(interrupted.error),
    }
}

/// The smallest rate of stable straight rolling, by bisection between the two rates, to a relative `accuracy`.
pub fn threshold(disks: &Disks, slow: f64, fast: f64, accuracy: f64) -> Result<f64, Error> {
    let steps = ((fast - slow) / (accuracy * slow)).log2().ceil().max(1.0) as u64;
    let bar = ProgressBar::new(steps).with_style(
        ProgressStyle::with_template("  bisecting [{bar:32}] {pos}/{len} runs").expect("the template is fixed"),
    );
    let (mut unstable, mut stable) = (slow, fast);
    for _ in 0..steps {
        let middle = 0.5 * (unstable + stable);
        if falls(disks, middle)? {
            unstable = middle;
        } else {
            stable = middle;
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok(0.5 * (unstable + stable))
}
