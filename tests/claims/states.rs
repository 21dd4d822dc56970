//! Random states of a derived model, on its constraints.

use crate::support::running::entries;
use crate::support::splitmix::SplitMix;
use holonomy::{ConstrainedSystem, Prepared, Vector};
use oracle::{Declaration, System, closed, onto_nonlinear_rows};

/// A point near the start that the model names, or near one of order one.
pub fn guess(declared: &Declaration, random: &mut SplitMix, [low, high]: [f64; 2]) -> Vec<f64> {
    let coordinate = |x: &String| match declared.start.get(x) {
        Some(start) => start + random.between(-0.1, 0.1),
        None => random.between(low, high),
    };
    declared.state_coordinates().iter().map(coordinate).collect()
}

/// Time, the state's coordinates and its speeds.
pub type Point = (f64, Vec<f64>, Vec<f64>);

/// A state with f = 0 and φ = 0, or `None` if Newton's method does not get there.
pub fn random_state<M: ConstrainedSystem>(
    model: &Prepared<M>,
    system: &System<'_>,
    random: &mut SplitMix,
    range: [f64; 2],
) -> Option<Point> {
    let t = random.between(0.0, 2.0);
    let q = closed(system, t, &guess(system.model, random, range))?;
    let u = random.vector(M::MODEL.state_speeds.len(), -1.0, 1.0);
    let x = system.coordinates(t, &q);
    let velocities = |u: &[f64]| {
        let y: Vec<f64> = q.iter().chain(u).copied().collect();
        entries(&model.velocities(t, &M::State::<f64>::from_fn(|i| y[i])))
    };
    // Where the model gives v = g(u, x, t), any u will do, and v is not linear in it.
    let u = if system.model.gives_velocities { u } else { onto_nonlinear_rows(system, t, &x, &u, velocities)? };
    (system.to_next_case(t, &q, &x, &velocities(&u)) > 1e-9).then_some((t, q, u))
}
