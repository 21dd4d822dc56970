//! What is compared between the formulations.

use holonomy::prelude::*;
use holonomy::{State, Trajectory};

/// Mass, length of the rod, gravity.
pub const M: f64 = 1.3;
pub const L: f64 = 0.8;
pub const G: f64 = 9.81;

/// x, y, z and their rates of the angles θ, φ and their rates.
pub fn place([theta, phi, theta_rate, phi_rate]: [f64; 4]) -> ([f64; 3], [f64; 3]) {
    let ((st, ct), (sp, cp)) = (theta.sin_cos(), phi.sin_cos());
    let (along, across) = (L * ct * theta_rate, L * st * phi_rate);
    ([L * st * cp, L * st * sp, -L * ct], [along * cp - across * sp, along * sp + across * cp, L * st * theta_rate])
}

/// The largest relative changes along a run.
pub struct Drift {
    pub energy: f64,
    pub rod: f64,
}

/// By all velocities, as the speeds of the state do not tell them everywhere.
pub fn drift<Model: ConstrainedSystem>(model: &Prepared<Model>, run: &Trajectory<Model>) -> Drift {
    let energy = |t: f64, s: &State<Model>, v: &Model::Velocities<f64>| {
        let x = model.coordinates(t, s);
        model.kinetic_energy(t, &x, v) + model.potential_energy(t, &x).unwrap_or(0.0)
    };
    let first = energy(run.times()[0], &run.states()[0], &run.velocities()[0]);
    let mut worst = Drift { energy: 0.0, rod: 0.0 };
    for ((t, s), v) in run.iter().zip(run.velocities()) {
        let array: <State<Model> as Vector<f64>>::Array = (*s).into();
        let length = array.as_ref()[..3].iter().map(|x| x * x).sum::<f64>().sqrt();
        worst.energy = worst.energy.max((energy(t, s, v) / first - 1.0).abs());
        worst.rod = worst.rod.max((length / L - 1.0).abs());
    }
    worst
}
