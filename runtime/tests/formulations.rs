//! One mechanism in two formulations: x, y with a row, and the angle with the coordinates given (4.2).

mod models;

use holonomy::prelude::*;
use models::*;

const M: f64 = 2.0;
const L: f64 = 0.5;
const G: f64 = 9.81;

fn both() -> (Prepared<Pendulum>, Prepared<Swing>) {
    let (m, l, g) = (M, L, G);
    (Pendulum { m, l, g }.prepare().unwrap(), Swing { m, l, g }.prepare().unwrap())
}

#[test]
fn velocities_rates_and_reactions_agree() {
    let (plane, angle) = both();
    for (alpha, rate) in [(0.3, 1.0), (-1.2, 3.0), (2.5, -0.4)] {
        let s = SwingState { alpha, dot_alpha: rate };
        let [x, y] = angle.coordinates(0.0, &s);
        let v = angle.velocities(0.0, &s);
        let r = PendulumState { x, y, dot_x: v.dot_x };
        assert!((plane.velocities(0.0, &r).dot_y - v.dot_y).abs() < 1e-14);
        let (a, b) = (plane.velocity_rates(0.0, &r, &[]), angle.velocity_rates(0.0, &s, &[]));
        assert!((a.dot_x - b.dot_x).abs() < 1e-12 && (a.dot_y - b.dot_y).abs() < 1e-12);
        let (a, b) = (plane.reactions(0.0, &r, &[]), angle.reactions(0.0, &s, &[]));
        assert!((a.total().dot_y - b.total().dot_y).abs() < 1e-12);
        assert!((plane.energy(0.0, &r) - angle.energy(0.0, &s)).abs() < 1e-14);
        // The tangent form in the initial velocities knows no chart.
        let full = plane.initial_equations_at(0.0, &r, &[]);
        let rates = full.tangent_rates(&angle.complement_at(0.0, &s)).unwrap();
        let expected = angle.velocity_rates(0.0, &s, &[]);
        assert!((rates[0] - expected.dot_x).abs() < 1e-12);
        assert!((rates[1] - expected.dot_y).abs() < 1e-12);
    }
}

#[test]
fn the_motions_agree() {
    let (plane, angle) = both();
    let start = SwingState { alpha: 1.2, dot_alpha: 0.5 };
    let [x, y] = angle.coordinates(0.0, &start);
    let same = PendulumState { x, y, dot_x: angle.velocities(0.0, &start).dot_x };
    let a = plane.simulate(same).tolerance(1e-12, 1e-12).until(10.0).unwrap();
    let b = angle.simulate(start).tolerance(1e-12, 1e-12).until(10.0).unwrap();
    for i in 0..=100 {
        let t = 0.1 * f64::from(i);
        let (r, s) = (a.at(t).unwrap(), b.at(t).unwrap());
        let [x, y] = angle.coordinates(t, &s);
        assert!((r.x - x).abs() < 1e-9 && (r.y - y).abs() < 1e-9, "at {t}");
    }
}

#[test]
fn a_better_chart_goes_over_the_top() {
    let (_, angle) = both();
    let energy = |s: &SwingState| angle.energy(0.0, s);
    let start = SwingState { alpha: 0.0, dot_alpha: 10.0 };
    let run = angle.simulate(start).tolerance(1e-12, 1e-12).until(5.0).unwrap();
    let (_, end) = run.last();
    assert!(end.alpha > 6.3 && (energy(end) - energy(&start)).abs() < 1e-10);
    // Independent coordinates need no way back, and no assembly.
    assert_eq!(angle.assemble(start).solve().unwrap(), start);
    assert_eq!(run.statistics().evaluations, 2 + 15 * run.statistics().accepted + 12 * run.statistics().rejected);
}
