//! Runs that change their charts: no accuracy is lost, whatever the chart; what is told of them is right in every one.

mod models;

use holonomy::prelude::*;
use holonomy::simulate::{Chart, Charts};
use holonomy::{Error, Trajectory};
use models::*;

const METHODS: [(Method, f64); 3] =
    [(Method::Rk4 { step: 5e-4 }, 1e-8), (Method::DormandPrince, 1e-8), (Method::Dop853, 1e-8)];

fn pendulum() -> Prepared<Pendulum> {
    Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap()
}

fn swing() -> Prepared<Swing> {
    Swing { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap()
}

/// The pendulum goes over the top with this speed at the bottom.
const FAST: f64 = 5.5;

/// The largest distance of a run in x, y from the run in the angle, at the ends of its steps and between them.
fn distance(run: &Trajectory<Pendulum>, exact: &Trajectory<Swing>) -> f64 {
    let (model, mut worst) = (swing(), 0.0_f64);
    for i in 0..=3000 {
        let t = run.last().0 * f64::from(i) / 3000.0;
        let (s, v, angle) = (run.at(t).unwrap(), run.velocities_at(t).unwrap(), exact.at(t).unwrap());
        let ([x, y], expected) = (model.coordinates(t, &angle), model.velocities(t, &angle));
        for error in [s.x - x, s.y - y, v.dot_x - expected.dot_x, v.dot_y - expected.dot_y] {
            worst = worst.max(error.abs());
        }
    }
    worst
}

#[test]
fn the_pendulum_goes_over_the_top_in_its_charts() {
    let angle = SwingState { alpha: 0.0, dot_alpha: FAST / 0.5 };
    let exact = swing().simulate(angle).tolerance(1e-13, 1e-13).until(5.0).unwrap();
    for (method, tolerance) in METHODS {
        let model = pendulum();
        let start = PendulumState { x: 0.0, y: -0.5, dot_x: FAST };
        for charts in [Charts::Change, Charts::General] {
            let run = model.simulate(start).charts(charts).method(method).tolerance(1e-12, 1e-12).until(5.0).unwrap();
            let error = distance(&run, &exact);
            println!("{method:?} {charts:?}: {error:.1e}, {:?}, {:?}", run.statistics(), run.charts());
            assert!(error < tolerance, "{method:?} {charts:?}: {error:e}");
            assert!(run.largest_residuals().position < 1e-14);
            match charts {
                Charts::General => assert_eq!(run.charts(), [(Chart::General, run.statistics().accepted)]),
                _ => {
                    // Twice a turn into either chart, and never into the general one: one of the two is always flat.
                    assert!(run.statistics().chart_changes > 20, "{:?}", run.statistics());
                    let [(Chart::Emitted(0), across), (Chart::Emitted(1), along)] = run.charts() else {
                        panic!("{:?}", run.charts())
                    };
                    assert_eq!(across + along, run.statistics().accepted);
                }
            }
        }
    }
}

#[test]
fn a_thousand_changes_lose_nothing() {
    let model = pendulum();
    let start = PendulumState { x: 0.0, y: -0.5, dot_x: FAST };
    let energy = model.energy(0.0, &start);
    let run = model.simulate(start).tolerance(1e-14, 1e-14).dense(false).until(190.0).unwrap();
    assert!(run.statistics().chart_changes >= 1000, "{:?}", run.statistics());
    let mut worst = 0.0_f64;
    for ((t, s), v) in run.iter().zip(run.velocities()) {
        let found = model.kinetic_energy(t, &[s.x, s.y], v) + 2.0 * 9.81 * s.y;
        worst = worst.max((found - energy).abs());
        assert!(model.position_residual_at(t, s)[0].abs() < 1e-15);
        assert!(model.velocity_residual(t, &[s.x, s.y], v)[0].abs() < 1e-14);
    }
    let angle = SwingState { alpha: 0.0, dot_alpha: FAST / 0.5 };
    let exact = swing().simulate(angle).tolerance(1e-14, 1e-14).until(190.0).unwrap();
    let [x, y] = swing().coordinates(190.0, exact.last().1);
    let (_, end) = run.last();
    println!("energy {worst:.1e}, place {:.1e} {:.1e}, {:?}", end.x - x, end.y - y, run.statistics());
    assert!(worst < 1e-9 && (end.x - x).abs() < 1e-8 && (end.y - y).abs() < 1e-8, "{worst:e}");
}

/// A model with one chart goes through the general one, here with a constraint that moves.
#[test]
fn the_bead_turns_with_its_rod_through_the_general_chart() {
    let (w, g, rho, speed) = (1.1f64, 9.81, 0.7, 0.1);
    let model = Bead { m: 1.5, w, g }.prepare().unwrap();
    let exact = |t: f64| {
        rho * (w * t).cosh() + (speed - g / (2.0 * w)) * (w * t).sinh() / w + g * (w * t).sin() / (2.0 * w * w)
    };
    let start = BeadState { x: rho, y: 0.0, dot_x: speed };
    for (method, tolerance) in METHODS {
        let run = model.simulate(start).method(method).tolerance(1e-12, 1e-12).until(3.0).unwrap();
        for i in 0..=300 {
            let t = 0.01 * f64::from(i);
            let s = run.at(t).unwrap();
            let along = s.x * (w * t).cos() + s.y * (w * t).sin();
            assert!((along - exact(t)).abs() < 100.0 * tolerance, "{method:?} at {t}: {along} {}", exact(t));
        }
        assert!(run.charts().iter().any(|(chart, steps)| *chart == Chart::General && *steps > 3), "{:?}", run.charts());
        // It came back, with cos wt of the other sign.
        assert_eq!(run.statistics().chart_changes, 2, "{method:?}");
        let largest = run.largest_residuals();
        assert!(largest.position < 1e-14 && largest.velocity < 1e-14, "{largest:?}");
    }
}

#[test]
fn reactions_are_right_where_the_chart_breaks_down() {
    let model = pendulum();
    let start = PendulumState { x: 0.0, y: -0.5, dot_x: FAST };
    let run = model.simulate(start).charts(Charts::General).tolerance(1e-12, 1e-12).until(2.0).unwrap();
    // λ = −m (v² − g y)/l², at every height
    for i in 0..=200 {
        let t = 0.01 * f64::from(i);
        let (s, v) = (run.at(t).unwrap(), run.velocities_at(t).unwrap());
        let square = v.dot_x * v.dot_x + v.dot_y * v.dot_y;
        let exact = -2.0 * (square - 9.81 * s.y) / (s.x * s.x + s.y * s.y);
        assert!((run.multipliers_at(t, &[]).unwrap().rod - exact).abs() < 1e-10, "{t}");
    }
    assert!(matches!(run.multipliers_at(3.0, &[]), Err(Error::OutOfRange { .. })));
    // Names that share a row share its reaction; f of `again` is three times that of `rod`.
    let bead = Bead { m: 1.5, w: 1.1, g: 9.81 }.prepare().unwrap();
    let run = bead.simulate(BeadState { x: 0.7, y: 0.0, dot_x: 0.1 }).until(0.5).unwrap();
    let (found, here) = (run.multipliers_at(0.5, &[]).unwrap(), bead.multipliers(0.5, run.last().1, &[]));
    assert!((found.rod - here.rod).abs() < 1e-11 && (found.again - here.rod).abs() < 1e-11, "{found:?} {here:?}");
    // A configuration: the general form in its rates.
    let model = swing();
    let s = SwingState { alpha: 1.1, dot_alpha: -2.0 };
    let run = model.simulate(s).until(0.0).unwrap();
    assert!((run.multipliers_at(0.0, &[]).unwrap().rod - model.multipliers(0.0, &s, &[]).rod).abs() < 1e-11);
}

#[test]
fn a_configuration_runs_in_the_general_chart_too() {
    let model = swing();
    let start = SwingState { alpha: 0.3, dot_alpha: 9.0 };
    let plain = model.simulate(start).tolerance(1e-12, 1e-12).until(3.0).unwrap();
    let general = model.simulate(start).charts(Charts::General).tolerance(1e-12, 1e-12).until(3.0).unwrap();
    assert_eq!(general.charts()[0].0, Chart::General);
    for i in 0..=30 {
        let t = 0.1 * f64::from(i);
        let (a, b) = (plain.at(t).unwrap(), general.at(t).unwrap());
        assert!((a.alpha - b.alpha).abs() < 1e-9 && (a.dot_alpha - b.dot_alpha).abs() < 1e-9, "{t}: {a:?} {b:?}");
    }
}

#[test]
fn inputs_see_the_state_in_every_chart() {
    // Damping through the inputs, by a speed of the first chart.
    let model = Oscillator { m: 1.0, a: 0.1, k: 2.0, c: 0.3, b: 0.4 }.prepare().unwrap();
    let start = OscillatorState { x: 1.0, dot_x: 1.0 };
    let source = |t: f64, s: &OscillatorState| OscillatorInputs { tau: t.sin() - 0.5 * s.dot_x };
    let plain = model.simulate(start).inputs(source).tolerance(1e-12, 1e-12).until(3.0).unwrap();
    let general = model.simulate(start).inputs(source).charts(Charts::General).tolerance(1e-12, 1e-12);
    let general = general.until(3.0).unwrap();
    let (a, b) = (plain.last().1, general.last().1);
    assert!((a.x - b.x).abs() < 1e-10 && (a.dot_x - b.dot_x).abs() < 1e-10, "{a:?} {b:?}");
}

/// With Baumgarte's terms f obeys f̈ + 2α ḟ + β² f = 0 (C v̇ + c0* is f̈).
#[test]
fn stabilised_residuals_decay_as_their_equation_says() {
    let model = pendulum();
    // As far off as a start may be.
    let start = PendulumState { x: 0.3, y: -0.4 - 3e-10, dot_x: 0.0 };
    let first = model.position_residual_at(0.0, &start)[0];
    assert!(first.abs() > 1e-10);
    let run = model.simulate(start).baumgarte(3.0, 3.0).tolerance(1e-14, 1e-14).until(1.0).unwrap();
    for (t, s) in run.iter() {
        let exact = first * (1.0 + 3.0 * t) * (-3.0 * t).exp();
        assert!((model.position_residual_at(t, s)[0] - exact).abs() < 1e-13, "{t}");
    }
}

#[test]
fn noise_at_zero_is_no_residual() {
    // y = 0 at t = 0, of which rounding may leave anything.
    let model = Bead { m: 1.5, w: 1.1, g: 9.81 }.prepare().unwrap();
    for (x, y) in [(0.7, 1e-17), (0.0, 1e-17), (0.0, 0.0)] {
        model.simulate(BeadState { x, y, dot_x: 0.1 }).until(0.5).unwrap();
    }
    let error = model.simulate(BeadState { x: 0.7, y: 1e-12, dot_x: 0.1 }).until(0.5).unwrap_err().error;
    assert_eq!(error, Error::Unmet { constraint: "rod", residual: 1e-12 });
}
