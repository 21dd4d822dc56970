//! The prepared model: parameters, names, energies, velocities' rates, reactions.

mod models;

use holonomy::prelude::*;
use holonomy::{Dual, State};
use models::*;

fn bead() -> Prepared<Bead> {
    Bead { m: 1.5, w: 0.8, g: 9.81 }.prepare().unwrap()
}

/// The bead on its rod at a distance, with a speed along the rod.
fn on_rod(t: f64, distance: f64, speed: f64) -> BeadState {
    let (sin, cos) = (0.8 * t).sin_cos();
    BeadState { x: distance * cos, y: distance * sin, dot_x: speed * cos - distance * 0.8 * sin }
}

#[test]
fn names_find_entries() {
    let s = State::<Pendulum> { x: 0.3, y: -0.4, dot_x: 0.7 };
    assert_eq!(s.get("dot_x"), Some(0.7));
    assert_eq!(s.get("dot_y"), None);
    assert_eq!(<PendulumState as Vector<f64>>::NAMES, ["x", "y", "dot_x"]);
}

#[test]
fn parameters_are_kept() {
    let model = bead();
    assert_eq!(*model.parameters(), BeadParameters { m: 1.5, w: 0.8, g: 9.81 });
    assert_eq!(model.system().g, 9.81);
    assert!(format!("{model:?}").contains("Bead"));
}

#[test]
fn residuals_vanish_on_the_manifold_and_only_there() {
    let (model, t) = (bead(), 0.6);
    let s = on_rod(t, 1.2, 0.3);
    assert!(model.position_residual_at(t, &s).iter().all(|f| f.abs() < 1e-15));
    assert!(model.velocity_residual_at(t, &s)[0].abs() < 1e-15);
    let off = BeadState { y: s.y + 0.1, ..s };
    assert!((model.position_residual_at(t, &off)[0] - 0.1 * (0.48f64).cos()).abs() < 1e-15);
}

#[test]
fn energy_is_kinetic_where_no_potential_is_declared() {
    let (model, t) = (bead(), 0.6);
    let s = on_rod(t, 1.2, 0.3);
    let expected = 0.5 * 1.5 * (0.3f64.powi(2) + (1.2f64 * 0.8).powi(2));
    assert!((model.energy(t, &s) - expected).abs() < 1e-14);
}

#[test]
fn velocity_rates_are_the_derivative_of_the_velocities_along_the_motion() {
    let (model, t) = (bead(), 0.6);
    let s = on_rod(t, 1.2, 0.3);
    let (rate, _) = model.derivative(t, &s, &[]);
    let dual = Bead { m: 1.5, w: 0.8, g: 9.81 }.prepare_as::<Dual>().unwrap();
    let along =
        BeadState { x: Dual::new(s.x, rate.x), y: Dual::new(s.y, rate.y), dot_x: Dual::new(s.dot_x, rate.dot_x) };
    let expected = dual.velocities(Dual::variable(t), &along);
    let found = model.velocity_rates(t, &s, &[]);
    assert!((found.dot_x - expected.dot_x.derivative).abs() < 1e-13);
    assert!((found.dot_y - expected.dot_y.derivative).abs() < 1e-13);
}

#[test]
fn the_bead_presses_on_its_rod_as_coriolis_says() {
    // P2: λ = m (2 W ρ̇ + g cos Wt)
    let (model, t) = (bead(), 0.6);
    let lambda = model.multipliers(t, &on_rod(t, 1.2, 0.3), &[]).rod;
    assert!((lambda - 1.5 * (2.0 * 0.8 * 0.3 + 9.81 * (0.48f64).cos())).abs() < 1e-13);
}

#[test]
fn merged_names_share_a_row_and_count_once_in_the_total() {
    let (model, t) = (bead(), 0.6);
    let s = on_rod(t, 1.2, 0.3);
    let reactions = model.reactions(t, &s, &[]);
    let names: Vec<_> = reactions.iter().map(|(name, _)| name).collect();
    assert_eq!(names, ["rod", "again"]);
    assert_eq!(reactions.get("rod"), reactions.get("again"));
    assert_eq!(reactions.get("nowhere"), None);
    assert_eq!(reactions.get("nothing"), None);
    assert_eq!(Some(reactions.total()), reactions.get("rod"));
    // Newton's law for the bead
    let rates = model.velocity_rates(t, &s, &[]);
    assert!((1.5 * rates.dot_x - reactions.total().dot_x).abs() < 1e-13);
    assert!((1.5 * (rates.dot_y + 9.81) - reactions.total().dot_y).abs() < 1e-13);
}
