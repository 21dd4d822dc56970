//! Models whose independent speeds are combinations: names, values, runs, assemblies, changes of chart.

mod support;

#[path = "models/combined.rs"]
mod combined;
#[path = "models/rolling_disc.rs"]
mod rolling_disc;

use combined::{
    DiscByRates, DiscByRatesState, PacedBlade, PacedBladeState, SphericalByTurning, SphericalByTurningState,
};
use holonomy::simulate::Charts;
use holonomy::{ConstrainedSystem, Error, Vector};
use rolling_disc::{RollingDisc, RollingDiscState};
use support::running::entries;
use support::splitmix::SplitMix;

const G: f64 = 9.81;

/// Kane's speeds of the disc by combinations of rates, and as speeds with kinematics of their own: one and the same system.
#[test]
fn a_disc_by_its_rates_is_the_disc_by_its_speeds() {
    let by_rates = DiscByRates { m: 2.0, r: 0.5, g: G, d: 0.125, a: 0.25 }.prepare().unwrap();
    let by_speeds = RollingDisc { m: 2.0, r: 0.5, g: G, d: 0.125, a: 0.25 }.prepare().unwrap();
    assert_eq!(DiscByRates::MODEL.state_speeds, ["w1", "w2", "w3"]);
    assert_eq!(<DiscByRatesState as Vector<f64>>::NAMES, <RollingDiscState as Vector<f64>>::NAMES);
    let mut random = SplitMix::new(8);
    for _ in 0..50 {
        let y = random.vector(9, -1.0, 1.0);
        let (s, r) = (DiscByRatesState::from_fn(|i| y[i]), RollingDiscState::from_fn(|i| y[i]));
        let close = |what: &str, a: &[f64], b: &[f64], scale: f64| {
            for (a, b) in a.iter().zip(b) {
                assert!((a - b).abs() <= 1e-12 * scale, "{what} at {y:?}: {a} and {b}");
            }
        };
        let rates = [entries(&by_rates.derivative(0.0, &s, &[]).0), entries(&by_speeds.derivative(0.0, &r, &[]).0)];
        close("rates", &rates[0], &rates[1], 100.0);
        let lambda = [entries(&by_rates.multipliers(0.0, &s, &[])), entries(&by_speeds.multipliers(0.0, &r, &[]))];
        close("reactions", &lambda[0], &lambda[1], 100.0);
        close("energy", &[by_rates.energy(0.0, &s)], &[by_speeds.energy(0.0, &r)], 100.0);
        // u of v is the state's own, whatever a run arrives with
        let v = by_rates.velocities(0.0, &s);
        close("u of v", &entries(&by_rates.chart_speeds(0, 0.0, &s, &v)), &y[6..], 10.0);
    }
    let said = |text: &str| DiscByRates::MODEL.equations.iter().any(|e| e.symbol == text && e.source == "(5.2)");
    assert!(said("w1") && said("w2") && said("w3"), "what the names stand for is told");
    assert!(DiscByRates::MODEL.notes.iter().any(|note| note.contains("w3 = ")), "{:?}", DiscByRates::MODEL.notes);
}

/// Over the poles of both axes in turn: the run changes between charts of combinations, and ends where the run in all
/// velocities ends.
#[test]
fn a_run_changes_between_charts_of_combinations() {
    let model = SphericalByTurning { m: 1.3, l: 0.8, g: G }.prepare().unwrap();
    let [first, second] = SphericalByTurning::MODEL.charts else { panic!("two charts") };
    assert_eq!((first.speeds, second.speeds), (["turn", "dot_z"].as_slice(), ["roll", "dot_x"].as_slice()));
    // x = 0.64, z = -0.48, and (v_x, v_y, v_z) = (1.8, 0.6, 2.4): turn = x v_y / l. It rises to the level of the hinge.
    let start = SphericalByTurningState { x: 0.64, y: 0.0, z: -0.48, turn: 0.48, dot_z: 2.4 };
    let v = model.velocities(0.0, &start);
    assert!((v.dot_y - 0.6).abs() < 1e-14 && (v.dot_x - 1.8).abs() < 1e-14, "{v:?}");
    let run = |charts| model.simulate(start).charts(charts).tolerance(1e-12, 1e-12).until(20.0).unwrap();
    let (changing, general) = (run(Charts::Change), run(Charts::General));
    assert!(changing.statistics().chart_changes > 10, "{:?}", changing.statistics());
    let ((_, a), (_, b)) = (changing.last(), general.last());
    for (a, b) in entries(a).iter().zip(entries(b)) {
        assert!((a - b).abs() < 1e-7, "{a} {b}");
    }
    // The turning about the vertical is the angular momentum, and the state is read in the first chart everywhere.
    for (t, s) in changing.iter() {
        assert!((s.turn - 0.48).abs() < 1e-9, "{} at {t}", s.turn);
        let v = changing.velocities_at(t).unwrap();
        assert!((s.turn - (s.x * v.dot_y - s.y * v.dot_x) / 0.8).abs() < 1e-9 && (s.dot_z - v.dot_z).abs() < 1e-9);
    }
}

/// A nonlinear row binds combinations: an assembly finds them, and a run stays on the row.
#[test]
fn nonlinear_rows_on_combinations() {
    let blade = PacedBlade { m: 1.1, i: 0.4, g: G, tilt: 0.1, drift: 0.3, pace: 0.7 }.prepare().unwrap();
    assert_eq!((PacedBlade::MODEL.state_speeds, PacedBlade::MODEL.reduced_speeds.len()), (["u", "o"].as_slice(), 1));
    let guess = PacedBladeState { phi: 0.4, u: 1.0, o: 1.0, ..Default::default() };
    let start = blade.solve_velocities(0.0, &guess, &["u"]).unwrap();
    assert!((start.o - 0.7).abs() < 1e-14 && start.u == 1.0);
    let set = blade.assemble(guess).set("o", 0.5).solve().unwrap();
    assert!((set.u - 1.4).abs() < 1e-13 && set.o == 0.5);
    let unknown = blade.solve_velocities(0.0, &guess, &["dot_x"]).unwrap_err();
    assert!(matches!(unknown, Error::UnknownName { .. }));
    let run = blade.simulate(start).tolerance(1e-11, 1e-11).until(5.0).unwrap();
    assert!(run.largest_residuals().velocity < 1e-12, "{:?}", run.largest_residuals());
    for (t, s) in run.iter() {
        let v = run.velocities_at(t).unwrap();
        let along = (v.dot_x - 0.3 * t.cos()) * s.phi.cos() + v.dot_y * s.phi.sin();
        assert!((along - s.u).abs() < 1e-10 && (v.dot_phi - s.o).abs() < 1e-10 && (s.u * s.o - 0.7).abs() < 1e-10);
    }
}
