//! Runs through points where constraints lose their rank, against the motion on one branch without constraints.

#[path = "models/meeting.rs"]
mod meeting;

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use holonomy::prelude::*;
use holonomy::simulate::{Chart, Charts, Crossing, Event};
use holonomy::{Error, Obstacle, State, Trajectory};
use meeting::*;

const BAR: Parallelogram = Parallelogram { l: 0.8, d: 1.3, m1: 0.7, m2: 1.1, g: 9.81 };
const PENDULUM: AsPendulum = AsPendulum { l: 0.8, m1: 0.7, m2: 1.1, g: 9.81 };

fn flat_bar(q: f64, rate: f64) -> State<Parallelogram> {
    State::<Parallelogram> { q1: q, q2: 0.0, q3: q, dot_q1: rate }
}

fn no_torque(_: f64, _: &State<Parallelogram>) -> ParallelogramInputs {
    ParallelogramInputs { tau: 0.0 }
}

/// The same motion as that of a pendulum, at all times of the run and in between.
fn compare(run: &Trajectory<Parallelogram>, exact: &Trajectory<AsPendulum>) -> f64 {
    let (from, to) = (run.times()[0], run.last().0);
    let between = (0..=2000).map(|i| from + (to - from) * f64::from(i) / 2000.0);
    let errors = run.times().iter().copied().chain(between).map(|t| {
        let (s, v, q) = (run.at(t).unwrap(), run.velocities_at(t).unwrap(), exact.at(t).unwrap());
        let places = [s.q1 - q.q, s.q2, s.q3 - q.q];
        let rates = [v.dot_q1 - q.dot_q, v.dot_q2, v.dot_q3 - q.dot_q];
        places.into_iter().chain(rates).fold(0.0, |worst: f64, error| worst.max(error.abs()))
    });
    errors.fold(0.0, f64::max)
}

#[test]
fn a_parallelogram_stays_one_over_many_turns() {
    let (bar, pendulum) = (BAR.prepare().unwrap(), PENDULUM.prepare().unwrap());
    let (start, alone) = (flat_bar(0.7, 9.0), State::<AsPendulum> { q: 0.7, dot_q: 9.0 });
    for (charts, end, tolerance, allowed) in [
        (Charts::Change, 5.0, 1e-12, 1e-8),
        (Charts::General, 2.0, 1e-12, 1e-9),
        (Charts::Change, -2.0, 1e-12, 1e-9),
        (Charts::Change, 5.0, 1e-7, 1e-3),
    ] {
        let run = bar.simulate(start).inputs(no_torque).charts(charts).tolerance(tolerance, tolerance).until(end);
        let run = run.unwrap_or_else(|stopped| panic!("{charts:?}: {stopped}"));
        let exact = pendulum.simulate(alone).inputs(|_, _| AsPendulumInputs { tau: 0.0 });
        let exact = exact.tolerance(1e-14, 1e-14).until(end).unwrap();
        let worst = compare(&run, &exact);
        let passed = (run.last().1.q1 / PI).floor().abs() as usize;
        println!("{charts:?} to {end}: {worst:.1e}, {:?} {:?}", run.statistics(), run.charts());
        assert!(worst < allowed, "{worst:e}");
        assert!(run.statistics().crossings == passed, "{passed} turns by half: {:?}", run.statistics());
        assert!(run.largest_residuals().position < 1e-14);
    }
}

#[test]
fn two_degrees_of_freedom() {
    let (l, m0, m1, m2, m3, g, k, l0) = (0.8, 3.0, 1.0, 1.2, 2.0, 9.81, 40.0, 2.0);
    let model = CrankOnCart { l, m0, m1, m2, m3, g, k, l0 }.prepare().unwrap();
    let alone = CrankOnCartAlone { l, m0, m1, m2, m3, g, k, l0 }.prepare().unwrap();
    let (alpha, dot_c, dot_alpha) = (0.5_f64, -0.4, 7.0);
    let x = 2.0 * l * alpha.cos();
    let start = State::<CrankOnCart> { c: 2.1, alpha, beta: alpha, x, dot_c, dot_alpha };
    let run = model.simulate(start).tolerance(1e-12, 1e-12).until(4.0).unwrap();
    let exact = alone.simulate(State::<CrankOnCartAlone> { c: 2.1, alpha, dot_c, dot_alpha });
    let exact = exact.tolerance(1e-14, 1e-14).until(4.0).unwrap();
    let (mut worst, mut passed, mut before) = (0.0_f64, 0, alpha.cos());
    for i in 0..=4000 {
        let t = 1e-3 * f64::from(i);
        let (s, v, e) = (run.at(t).unwrap(), run.velocities_at(t).unwrap(), exact.at(t).unwrap());
        let places = [s.c - e.c, s.alpha - e.alpha, s.beta - e.alpha, s.x - 2.0 * l * e.alpha.cos()];
        let rates = [v.dot_c - e.dot_c, v.dot_alpha - e.dot_alpha, v.dot_beta - e.dot_alpha];
        worst = places.into_iter().chain(rates).fold(worst, |worst, error| worst.max(error.abs()));
        passed += usize::from(before * e.alpha.cos() < 0.0);
        before = e.alpha.cos();
    }
    println!("{worst:.1e}, {passed} passed, {:?} {:?}", run.statistics(), run.charts());
    assert!(worst < 1e-8 && run.statistics().crossings == passed && passed > 3, "{worst:e} {passed}");
}

/// Two rows that become parallel; by every method; the energy is that of the start, but for what the steps between lose.
#[test]
fn a_kite_by_every_method() {
    let (a, b, mp, m, g) = (1.0, 1.7, 2.0, 0.7, 9.81);
    let (kite, alone) = (Kite { a, b, mp, m, g }.prepare().unwrap(), KiteAlone { a, b, mp, m, g }.prepare().unwrap());
    let (q, dot_q) = (1.0_f64, 8.0);
    let s = a * (0.5 * q).cos() + (b * b - (a * (0.5 * q).sin()).powi(2)).sqrt();
    let start = State::<Kite> { q, x: s * (0.5 * q).cos(), y: s * (0.5 * q).sin(), dot_q };
    let exact = alone.simulate(State::<KiteAlone> { q, dot_q }).tolerance(1e-14, 1e-14).until(3.0).unwrap();
    let passed = (exact.last().1.q / TAU).floor() as usize;
    let energy = |s: &State<Kite>, v: &KiteVelocities| {
        let moving = mp * (a * v.dot_q).powi(2) + m * (v.dot_x.powi(2) + v.dot_y.powi(2));
        0.5 * moving + g * (mp * a * s.q.sin() + m * s.y)
    };
    let at_start = energy(&start, &kite.velocities(0.0, &start));
    for (method, allowed, lost) in
        [(Method::Dop853, 1e-9, 1e-11), (Method::DormandPrince, 1e-9, 1e-11), (Method::Rk4 { step: 1e-3 }, 1e-7, 1e-8)]
    {
        let run = kite.simulate(start).method(method).tolerance(1e-11, 1e-11).until(3.0);
        let run = run.unwrap_or_else(|stopped| panic!("{method:?}: {stopped}"));
        let (mut worst, mut change) = (0.0_f64, 0.0_f64);
        for i in 0..=3000 {
            let t = 1e-3 * f64::from(i);
            let (s, v, e) = (run.at(t).unwrap(), run.velocities_at(t).unwrap(), exact.at(t).unwrap());
            worst = worst.max((s.q - e.q).abs()).max((v.dot_q - e.dot_q).abs());
            change = change.max((energy(&s, &v) / at_start - 1.0).abs());
        }
        println!("{method:?}: {worst:.1e}, energy {change:.1e}, {passed} passed, {:?}", run.statistics());
        assert!(worst < allowed && change < lost, "{method:?}: {worst:e} {change:e}");
        assert!(run.statistics().crossings == passed && passed > 3, "{:?}", run.statistics());
    }
}

/// A swing that turns shortly before, or shortly behind, the crossing.
#[test]
fn a_swing_that_turns_beside_the_crossing() {
    let (bar, pendulum) = (BAR.prepare().unwrap(), PENDULUM.prepare().unwrap());
    let AsPendulum { l, m1, m2, g } = PENDULUM;
    // As a pendulum: (2/3 m1 + m2) l² q'²/2 = g (m1 + m2) l (sin highest − sin q).
    for highest in [-0.1_f64, -0.01, -1e-3, 1e-3, 0.01, 0.1] {
        let square = 2.0 * g * (m1 + m2) * (highest.sin() + 1.0) / ((2.0 * m1 / 3.0 + m2) * l);
        let (start, alone) =
            (flat_bar(-FRAC_PI_2, square.sqrt()), State::<AsPendulum> { q: -FRAC_PI_2, dot_q: square.sqrt() });
        let run = bar.simulate(start).inputs(no_torque).tolerance(1e-11, 1e-11).until(1.5);
        let exact = pendulum.simulate(alone).inputs(|_, _| AsPendulumInputs { tau: 0.0 });
        let exact = exact.tolerance(1e-14, 1e-14).until(1.5).unwrap();
        let run = run.unwrap_or_else(|stopped| panic!("{highest}: {stopped}"));
        let worst = compare(&run, &exact);
        println!("{highest}: {worst:.1e}, {:?}", run.statistics());
        assert!(worst < 1e-7, "{highest}: {worst:e}");
        let flat: Vec<bool> = (0..=15_000).map(|i| exact.at(1e-4 * f64::from(i)).unwrap().q.sin() > 0.0).collect();
        let passed = flat.windows(2).filter(|pair| pair[0] != pair[1]).count();
        // Two losses of rank so close to each other that no point of the passage lies between them are none to it.
        let told = run.statistics().crossings;
        let all = if highest.abs() < 0.01 { told <= passed && (passed - told) % 2 == 0 } else { told == passed };
        assert!(all && (passed > 1) == (highest > 0.0), "{highest}: {told} of {passed}");
    }
}

/// Loose tolerances make steps that leap over a crossing from afar; they are taken again, shorter.
#[test]
fn steps_that_would_leap_over_a_crossing() {
    let bar = BAR.prepare().unwrap();
    for (charts, tolerance) in [(Charts::Change, 1e-3), (Charts::Change, 1e-5), (Charts::General, 1e-5)] {
        for rate in [8.0, 9.0, 11.0, 17.0] {
            let run =
                bar.simulate(flat_bar(0.7, rate)).inputs(no_torque).charts(charts).tolerance(tolerance, tolerance);
            let run = run.until(5.0).unwrap_or_else(|stopped| panic!("{charts:?} {tolerance:e} {rate}: {stopped}"));
            let apart = run.states().iter().map(|s| s.q2.abs().max((s.q3 - s.q1).abs())).fold(0.0, f64::max);
            assert!(apart < 1e-9, "{charts:?} {tolerance:e} {rate}: {apart:e}");
            let passed = (run.last().1.q1 / PI).floor() as usize;
            assert!(tolerance > 1e-5 || run.statistics().crossings == passed, "{passed}, {:?}", run.statistics());
        }
    }
}

#[test]
fn a_run_may_be_told_not_to_pass() {
    let bar = BAR.prepare().unwrap();
    for charts in [Charts::Change, Charts::General] {
        let run = bar.simulate(flat_bar(0.7, 9.0)).inputs(no_torque).charts(charts).crossing(Crossing::Refuse);
        let stopped = run.until(5.0).unwrap_err();
        assert!(matches!(stopped.error, Error::Dependent { .. }), "{}", stopped.error);
        assert!(stopped.trajectory.last().1.q1 < PI && stopped.trajectory.statistics().crossings == 0);
    }
}

#[test]
fn a_start_where_branches_meet_is_refused() {
    let bar = BAR.prepare().unwrap();
    let along = ParallelogramVelocities { dot_q1: 9.0, dot_q2: 0.0, dot_q3: 9.0 };
    for q in [0.0, PI, PI + 1e-10, TAU] {
        let start = flat_bar(q, 9.0);
        for run in [bar.simulate(start), bar.simulate(start).velocities(along)] {
            let error = run.inputs(no_torque).until(1.0).unwrap_err().error;
            assert!(matches!(error, Error::Impassable { obstacle: Obstacle::Start, time: 0.0, .. }), "{q}: {error}");
            assert!(error.to_string().contains("starts there"), "{error}");
        }
    }
    // Beside it a start is as good as any.
    assert!(bar.simulate(flat_bar(PI - 0.01, 9.0)).inputs(no_torque).until(0.1).is_ok());
}

/// Events, outputs and samples of a controller fall anywhere in a passage, its middle included.
#[test]
fn events_outputs_and_samples_within_a_passage() {
    let (bar, pendulum) = (BAR.prepare().unwrap(), PENDULUM.prepare().unwrap());
    let (start, alone) = (flat_bar(2.5, 6.0), State::<AsPendulum> { q: 2.5, dot_q: 6.0 });
    for period in [0.011, 0.002] {
        let torque = |q: f64, rate: f64| 3.0 * q.cos() - 0.4 * rate;
        let lean = |offset: f64| move |_: f64, s: &State<Parallelogram>| s.q1 - PI - offset;
        let run = bar.simulate(start).sampled(period, |_, s| ParallelogramInputs { tau: torque(s.q1, s.dot_q1) });
        let run = run.event(Event::new("before", lean(-0.01))).event(Event::new("beside", lean(1e-5)));
        let run = run.event(Event::new("flat", lean(0.0))).event(Event::new("after", lean(0.05)));
        let run = run.every(1e-3).tolerance(1e-11, 1e-11).until(0.3).unwrap_or_else(|stopped| panic!("{stopped}"));
        let exact = pendulum.simulate(alone).sampled(period, |_, s| AsPendulumInputs { tau: torque(s.q, s.dot_q) });
        let exact = exact.tolerance(1e-13, 1e-13).until(0.3).unwrap();
        let worst = compare(&run, &exact);
        println!("every {period}: {worst:.1e}, {:?}", run.statistics());
        assert!(run.statistics().crossings == 1 && worst < 1e-8, "{worst:e} {:?}", run.statistics());
        assert_eq!(run.times().len(), 301);
        let names: Vec<_> = run.events().iter().map(|event| event.name).collect();
        assert_eq!(names, ["before", "flat", "beside", "after"]);
        for (event, offset) in run.events().iter().zip([-0.01, 0.0, 1e-5, 0.05]) {
            assert!((exact.at(event.time).unwrap().q - PI - offset).abs() < 1e-8 && event.rising);
        }
    }
}

/// A run may end, or be stopped by an event, where it stands on the crossing.
#[test]
fn a_run_may_end_on_the_crossing() {
    let (bar, pendulum) = (BAR.prepare().unwrap(), PENDULUM.prepare().unwrap());
    let run = bar.simulate(flat_bar(2.5, 6.0)).inputs(no_torque).tolerance(1e-12, 1e-12);
    let run = run.stop_at("flat", |_, s| s.q1 - PI).until(1.0).unwrap();
    let (t, flat) = run.last();
    let alone = State::<AsPendulum> { q: 2.5, dot_q: 6.0 };
    let exact = pendulum.simulate(alone).inputs(|_, _| AsPendulumInputs { tau: 0.0 }).tolerance(1e-14, 1e-14);
    let exact = exact.until(1.0).unwrap();
    assert!((exact.at(t).unwrap().q - PI).abs() < 1e-10 && flat.q2.abs() < 1e-10, "{flat:?}");
    let run = bar.simulate(flat_bar(2.5, 6.0)).inputs(no_torque).tolerance(1e-12, 1e-12).until(t).unwrap();
    let (off, worst) = (run.last().1.q1 - PI, compare(&run, &exact));
    assert!(off.abs() < 1e-10 && worst < 1e-10, "{off:e} {worst:e} {:?}", run.statistics());
}

/// Wires that nearly meet are two ways round, not a crossing: the bead turns with its wire.
#[test]
fn branches_that_do_not_meet_are_not_passed() {
    for gap in [1e-3, 1e-5, 1e-7] {
        let model = Wires { m: 1.0, gap }.prepare().unwrap();
        let start = State::<Wires> { x: -1.0, y: -(1.0_f64 - gap).sqrt(), dot_x: 1.0 };
        let run =
            model.simulate(start).tolerance(1e-10, 1e-10).until(2.0).unwrap_or_else(|stopped| panic!("{stopped}"));
        let (s, v) = (run.last().1, run.velocities().last().unwrap());
        println!("{gap:e}: {s:?}, {v:?}, {:?}", run.statistics());
        assert!(s.x < -0.9 && s.y > 0.9 && run.statistics().crossings == 0, "{gap:e}: {s:?}");
        let speed = v.dot_x.hypot(v.dot_y);
        let at_start = run.velocities()[0];
        assert!((speed - at_start.dot_x.hypot(at_start.dot_y)).abs() < 1e-6, "{gap:e}: {speed}");
    }
}

#[test]
fn a_dead_end_is_told() {
    let model = Cusp { m: 1.0 }.prepare().unwrap();
    for tolerance in [1e-3, 1e-6, 1e-9, 1e-12] {
        let run = model.simulate(State::<Cusp> { x: 1.0, y: 1.0, dot_x: -1.0 }).tolerance(tolerance, tolerance);
        let stopped = run.until(5.0).unwrap_err();
        let Error::Impassable { rows, obstacle, time, .. } = &stopped.error else {
            panic!("{tolerance:e}: {}", stopped.error)
        };
        assert!(*rows == ["cusp"] && *obstacle != Obstacle::Start && *time > 0.5, "{}", stopped.error);
        let (_, last) = stopped.trajectory.last();
        // Beyond the tip f = y² + |x|³ is met to rounding as far as this.
        assert!(last.x > -1e-4 && last.x < 0.1, "{tolerance:e}: {last:?}");
    }
}

/// The way through is a step of the general chart, and the run goes on in an emitted one.
#[test]
fn the_chart_is_entered_again_behind_a_crossing() {
    let bar = BAR.prepare().unwrap();
    let run = bar.simulate(flat_bar(FRAC_PI_2, 9.0)).inputs(no_torque).until(2.0).unwrap();
    let general = run.charts().iter().find(|(chart, _)| *chart == Chart::General).expect("passages").1;
    assert!(general < 3 * run.statistics().crossings, "{:?} {:?}", run.charts(), run.statistics());
}
