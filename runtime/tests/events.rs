//! Events against closed forms, and what a digital controller holds.

mod models;

use holonomy::prelude::*;
use holonomy::simulate::Event;
use models::{Oscillator, OscillatorInputs, OscillatorState, Pendulum, PendulumState};

fn mass() -> Prepared<Oscillator> {
    Oscillator { m: 1.0, a: 0.0, k: 0.0, c: 0.0, b: 0.0 }.prepare().unwrap()
}

fn no_force(_: f64, _: &OscillatorState) -> OscillatorInputs {
    OscillatorInputs { tau: 0.0 }
}

fn gravity(_: f64, _: &OscillatorState) -> OscillatorInputs {
    OscillatorInputs { tau: -10.0 }
}

#[test]
fn the_pendulum_passes_its_lowest_point_every_half_period() {
    // K(1/√2) by the arithmetic-geometric mean: released level, k = sin 45°.
    let (mut a, mut b) = (1.0, std::f64::consts::FRAC_1_SQRT_2);
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), f64::sqrt(a * b));
    }
    let quarter = std::f64::consts::FRAC_PI_2 / a * (0.5f64 / 9.81).sqrt();
    let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap();
    let start = PendulumState { x: 0.0, y: -0.5, dot_x: (2.0 * 9.81 * 0.5f64).sqrt() };
    let run = pendulum
        .simulate(start)
        .tolerance(1e-12, 1e-12)
        .event(Event::<Pendulum>::new("lowest", |_, s| s.x))
        .until(10.5 * quarter)
        .unwrap();
    // The zero at the start is where the run begins, not an event.
    let times: Vec<f64> = run.events().iter().map(|event| event.time).collect();
    assert_eq!(times.len(), 5, "{times:?}");
    for (i, time) in times.iter().enumerate() {
        assert!((time - 2.0 * quarter * (i + 1) as f64).abs() < 1e-9, "{i}: {time}");
    }
    assert_eq!(run.events().iter().map(|event| event.rising).collect::<Vec<_>>(), [false, true, false, true, false]);
    assert!(run.events().iter().all(|event| event.state.x.abs() < 1e-14));
}

#[test]
fn many_events_of_one_step_come_in_their_order() {
    let mass = mass();
    let at = [3.7, 0.9, 2.2, 9.1, 0.25];
    let names = ["a", "b", "c", "d", "e"];
    let mut simulation = mass.simulate(OscillatorState { x: 0.0, dot_x: 1.0 }).inputs(no_force);
    for (name, x) in names.into_iter().zip(at) {
        simulation = simulation.event(Event::<Oscillator>::new(name, move |_, s| x - s.x));
    }
    let run = simulation.until(10.0).unwrap();
    assert!(run.statistics().accepted < 10, "the steps are long");
    let found: Vec<_> = run.events().iter().map(|event| event.name).collect();
    assert_eq!(found, ["e", "b", "c", "a", "d"]);
    for event in run.events() {
        let x = at[names.iter().position(|name| *name == event.name).unwrap()];
        // Rounding of a position that grows to ten within one step.
        assert!((event.time - x).abs() < 4.0 * f64::EPSILON * 10.0, "{event:?}");
    }
}

#[test]
fn a_zero_on_the_end_of_a_step_is_found_once() {
    let mass = mass();
    let run = mass
        .simulate(OscillatorState { x: -0.5, dot_x: 1.0 })
        .inputs(no_force)
        .method(Method::Rk4 { step: 0.25 })
        .event(Event::<Oscillator>::new("zero", |_, s| s.x))
        .until(1.0)
        .unwrap();
    assert_eq!(run.events().len(), 1);
    assert_eq!((run.events()[0].time, run.events()[0].rising), (0.5, true));
}

#[test]
fn only_the_direction_that_is_asked_for_counts_and_backwards_too() {
    let oscillator = Oscillator { m: 1.0, a: 0.0, k: 1.0, c: 0.0, b: 0.0 }.prepare().unwrap();
    for end in [10.0, -10.0] {
        let run = oscillator
            .simulate(OscillatorState { x: 1.0, dot_x: 0.0 })
            .inputs(no_force)
            .tolerance(1e-12, 1e-12)
            .event(Event::<Oscillator>::new("falls", |_, s| s.x).falling())
            .event(Event::<Oscillator>::new("rises", |_, s| s.x).rising())
            .until(end)
            .unwrap();
        let times: Vec<f64> = run.events().iter().map(|event| event.time.abs()).collect();
        let names: Vec<_> = run.events().iter().map(|event| event.name).collect();
        assert_eq!(names, ["falls", "rises", "falls"]);
        for (time, turns) in times.iter().zip([0.5, 1.5, 2.5]) {
            assert!((time - turns * std::f64::consts::PI).abs() < 1e-9, "{time}");
        }
    }
}

#[test]
fn a_run_that_stops_ends_at_the_event_and_is_dense_up_to_there() {
    let ball = mass();
    let run = ball
        .simulate(OscillatorState { x: 5.0, dot_x: 0.0 })
        .inputs(gravity)
        .every(0.4)
        .stop_at("ground", |_, s| s.x)
        .until(100.0)
        .unwrap();
    assert_eq!(run.times().len(), 4, "{:?}", run.times());
    let (t, s) = run.last();
    assert!((t - 1.0).abs() < 1e-13 && s.x.abs() < 1e-12 && (s.dot_x + 10.0).abs() < 1e-11);
    assert!((run.at(0.5).unwrap().x - 3.75).abs() < 1e-12);
    assert!(run.at(1.1).is_err());
}

#[test]
fn a_bouncing_ball_keeps_its_times_until_it_rests() {
    let ball = mass();
    let bounce = Event::<Oscillator>::new("impact", |_, s| s.x)
        .falling()
        .reset(|_, s| OscillatorState { x: 0.0, dot_x: -0.8 * s.dot_x });
    let interrupted =
        ball.simulate(OscillatorState { x: 5.0, dot_x: 0.0 }).inputs(gravity).event(bounce).until(20.0).unwrap_err();
    let run = &interrupted.trajectory;
    let mut expected = 1.0;
    for (i, event) in run.events().iter().take(40).enumerate() {
        assert!((event.time - expected).abs() < 1e-10, "{i}: {} for {expected}", event.time);
        expected += 2.0 * 0.8f64.powi(i as i32 + 1);
    }
    // The impacts gather at t = 1 + 2·0.8/(1 − 0.8) = 9: no run leads beyond, and the error says where.
    match interrupted.error {
        Error::StepTooSmall { time, .. } => assert!((time - 9.0).abs() < 1e-9, "{time}"),
        other => panic!("{other}"),
    }
    assert!(run.iter().all(|(_, s)| s.x > -1e-12));
    // On both sides of a reset.
    let first = run.events()[0].time;
    assert!(run.at(first - 1e-9).unwrap().dot_x < 0.0 && run.at(first + 1e-9).unwrap().dot_x > 0.0);
}

#[test]
fn a_reset_must_satisfy_the_constraints() {
    let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap();
    let start = PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 };
    let off = Event::<Pendulum>::new("lowest", |_, s| s.x).reset(|_, s| PendulumState { y: -0.6, ..*s });
    let interrupted = pendulum.simulate(start).event(off).until(5.0).unwrap_err();
    assert!(matches!(interrupted.error, Error::Unmet { constraint: "rod", .. }));
    assert_eq!(interrupted.trajectory.events().len(), 1);

    // A plate that turns the mass back without loss: the energy stays.
    let plate = Event::<Pendulum>::new("plate", |_, s| s.x - 0.1)
        .falling()
        .reset(|_, s| PendulumState { dot_x: -s.dot_x, ..*s });
    let run = pendulum.simulate(start).tolerance(1e-12, 1e-12).event(plate).until(5.0).unwrap();
    assert!(run.events().len() > 3);
    let energy = pendulum.energy(0.0, &start);
    assert!(run.iter().all(|(t, s)| (pendulum.energy(t, s) - energy).abs() < 1e-9));
}

#[test]
fn a_sampled_controller_holds_what_it_gave() {
    // x⁺ = x + h ẋ + h² τ/2, ẋ⁺ = ẋ + h τ: exact for a force that is held.
    let (period, mass) = (0.1, mass());
    let law = |s: &OscillatorState| -3.0 * s.x - 2.0 * s.dot_x;
    for method in [Method::Dop853, Method::DormandPrince, Method::Rk4 { step: 0.03 }] {
        let run = mass
            .simulate(OscillatorState { x: 1.0, dot_x: 0.0 })
            .method(method)
            .sampled(period, |_, s| OscillatorInputs { tau: law(s) })
            .until(2.05)
            .unwrap();
        let mut s = OscillatorState { x: 1.0, dot_x: 0.0 };
        for i in 0..20 {
            let found = run.at(period * f64::from(i)).unwrap();
            assert!((found.x - s.x).abs() < 1e-12 && (found.dot_x - s.dot_x).abs() < 1e-12, "{method:?}, {i}");
            let tau = law(&s);
            s.x += period * s.dot_x + 0.5 * period * period * tau;
            s.dot_x += period * tau;
        }
        assert_eq!(run.last().0, 2.05);
    }
    let refused = mass.simulate(OscillatorState { x: 1.0, dot_x: 0.0 }).sampled(0.0, no_force).until(1.0);
    assert!(matches!(refused.unwrap_err().error, Error::NotPositive { name: "sampling period", .. }));
}
