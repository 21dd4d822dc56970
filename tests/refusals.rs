//! What derived models refuse, each with an error of its own: singular charts, starts off the constraints, figures that are not
//! finite, parameters without an inertia.

#[path = "../examples/rolling_disk/models.rs"]
mod disks;
mod models;

use disks::{FloorDisk, FloorDiskInputs, FloorDiskState, RollingDisk, RollingDiskState, StagedDisk, StagedDiskState};
use holonomy::prelude::*;
use holonomy::{Dual, Error, Interrupted, State};
use models::{Atwood, DoublePendulum, HangingPendulum, HangingPendulumState, Sleigh, SleighInPlane};
use std::f64::consts::{FRAC_PI_2, PI};

const METHODS: [Method; 4] =
    [Method::Dop853, Method::DormandPrince, Method::Rk4 { step: 1e-3 }, Method::Rk4 { step: 0.05 }];

const NO_FORCE: FloorDiskInputs = FloorDiskInputs { fx: 0.0, fy: 0.0 };

fn rolling() -> Prepared<RollingDisk> {
    RollingDisk { m: 2.0, r: 0.5, j: 0.125, g: 9.81 }.prepare().expect("a disk")
}

fn floor() -> Prepared<FloorDisk> {
    FloorDisk { m: 2.0, r: 0.5, j: 0.125, g: 9.81 }.prepare().expect("a disk")
}

fn staged() -> Prepared<StagedDisk> {
    StagedDisk { m: 2.0, r: 0.5, j: 0.125, g: 9.81 }.prepare().expect("a disk")
}

/// The chart ends where the disk lies flat; the error names that pivot, and what there is of the run stands before it.
fn lies_flat<M: ConstrainedSystem>(interrupted: &Interrupted<M>, lean: impl Fn(&State<M>) -> f64) -> f64 {
    let Error::ChartSingularity { guard, value, time } = interrupted.error else {
        panic!("{}: {:?}", M::MODEL.name, interrupted.error);
    };
    assert_eq!(guard, "cos(theta)", "{}", M::MODEL.name);
    assert!(value.abs() < 0.5, "{}: {value}", M::MODEL.name);
    assert!(interrupted.error.to_string().contains("cos(theta)"));
    for (t, s) in interrupted.trajectory.iter() {
        assert!(t <= time && (time == 0.0 || lean(s).abs() < FRAC_PI_2), "{}: {} at {t}", M::MODEL.name, lean(s));
    }
    time
}

#[test]
fn a_disk_that_starts_flat() {
    for theta in [FRAC_PI_2, -FRAC_PI_2, 3.0 * FRAC_PI_2, FRAC_PI_2 + 2.0 * PI] {
        let start = RollingDiskState { theta, phi: 0.4, v6: 1.0, ..Default::default() };
        let refused = rolling().simulate(start).until(1.0).expect_err("a flat disk");
        assert_eq!(lies_flat(&refused, |s| s.theta), 0.0);
        let start = FloorDiskState { theta, phi: 0.4, dot_psi: 1.0, ..Default::default() };
        let refused = floor().simulate(start).inputs(|_, _| NO_FORCE).until(1.0).expect_err("a flat disk");
        assert_eq!(lies_flat(&refused, |s| s.theta), 0.0);
        let start = StagedDiskState { theta, phi: 0.4, dot_psi: 1.0, ..Default::default() };
        let refused = staged().simulate(start).until(1.0).expect_err("a flat disk");
        assert_eq!(lies_flat(&refused, |s| s.theta), 0.0);
    }
}

/// Without spin the disk falls through the singularity with finite figures all the way: only the change of sign tells.
#[test]
fn a_disk_that_falls_flat() {
    for method in METHODS {
        let falling = RollingDiskState { theta: 0.3, phi: 0.4, ..Default::default() };
        let fallen = rolling().simulate(falling).method(method).until(10.0).expect_err("it falls");
        let rolling = lies_flat(&fallen, |s| s.theta);
        let falling = StagedDiskState { theta: 0.3, phi: 0.4, ..Default::default() };
        let fallen = staged().simulate(falling).method(method).until(10.0).expect_err("it falls");
        let staged = lies_flat(&fallen, |s| s.theta);
        let falling = FloorDiskState { theta: 0.3, phi: 0.4, ..Default::default() };
        let fallen =
            floor().simulate(falling).method(method).inputs(|_, _| NO_FORCE).until(10.0).expect_err("it falls");
        let sliding = lies_flat(&fallen, |s| s.theta);
        // the lean of a falling disk obeys θ'' = m g r sin θ / (m r² + j) where it rolls; where it slides it falls sooner
        assert!(
            (0.4..0.9).contains(&rolling) && (rolling - staged).abs() < 0.1 && sliding < rolling + 0.06,
            "{method:?}"
        );
    }
}

#[test]
fn starts_off_the_constraints() {
    for z in [1e-3, -0.2, 1e-7] {
        let start = RollingDiskState { z, theta: 0.2, x: 1.0, ..Default::default() };
        let refused = rolling().simulate(start).until(1.0).expect_err("a disk in the air");
        assert_eq!(refused.error, Error::Unmet { constraint: "height", residual: z });
        assert_eq!(refused.trajectory.times(), [0.0]);
    }
    let pendulum = HangingPendulum { m: 1.5, l: 0.8, g: 9.81 }.prepare().expect("a pendulum");
    let start = HangingPendulumState { x: 0.1, y: -0.8, dot_x: 0.0 };
    let refused = pendulum.simulate(start).until(1.0).expect_err("a rod too long");
    let Error::Unmet { constraint: "rod", residual } = refused.error else { panic!("{:?}", refused.error) };
    assert!((residual - 0.005).abs() < 1e-15, "{residual}");
    // rounding is no reason to refuse
    let start = HangingPendulumState { x: 0.8 * 0.3_f64.sin(), y: -0.8 * 0.3_f64.cos(), dot_x: 0.1 };
    pendulum.simulate(start).until(0.1).expect("on the rod");
}

/// Each parameter by itself, as it stands in the struct and over other scalars.
fn parameters_are_finite<M: ConstrainedSystem>(good: &Prepared<M>) {
    for (j, name) in M::MODEL.parameters.iter().enumerate() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let given: <M::Parameters<f64> as Vector<f64>>::Array = (*good.parameters()).into();
            let given = given.as_ref();
            let parameters = M::Parameters::<f64>::from_fn(|i| if i == j { bad } else { given[i] });
            let refused = Prepared::with_parameters(good.system().clone(), parameters).expect_err("not finite");
            assert_eq!(refused, Error::NonFinite { name });
            // a derivative that is not finite spoils everything as well
            let parameters = M::Parameters::<Dual>::from_fn(|i| Dual::new(given[i], if i == j { bad } else { 0.0 }));
            let refused = Prepared::with_parameters(good.system().clone(), parameters).expect_err("not finite");
            assert_eq!(refused, Error::NonFinite { name });
        }
    }
}

/// Each entry of the start by itself.
fn starts_are_finite<M: ConstrainedSystem>(model: &Prepared<M>) {
    for (j, name) in M::State::<f64>::NAMES.iter().enumerate() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let start = M::State::<f64>::from_fn(|i| if i == j { bad } else { 0.0 });
            let source = |_: f64, _: &State<M>| M::Inputs::<f64>::from_fn(|_| 0.0);
            let refused = model.simulate(start).inputs(source).until(1.0).expect_err("not finite");
            assert_eq!(refused.error, Error::NonFinite { name });
        }
    }
}

#[test]
fn parameters_and_starts_that_are_not_finite() {
    parameters_are_finite(&rolling());
    parameters_are_finite(&floor());
    parameters_are_finite(&staged());
    starts_are_finite(&rolling());
    starts_are_finite(&floor());
    starts_are_finite(&staged());
    let refused = RollingDisk { m: 2.0, r: f64::NAN, j: 0.125, g: 9.81 }.prepare().expect_err("no radius");
    assert_eq!(refused, Error::NonFinite { name: "r" });
    // finite in double precision, infinite in single
    let refused = RollingDisk { m: 1e39, r: 0.5, j: 0.125, g: 9.81 }.prepare_as::<f32>().expect_err("too heavy");
    assert_eq!(refused, Error::NonFinite { name: "m" });
}

#[test]
fn inputs_that_are_not_finite() {
    let start = FloorDiskState { theta: 0.2, dot_psi: 4.0, ..Default::default() };
    for method in METHODS {
        for bad in [f64::NAN, f64::INFINITY] {
            for from in [0.0, 0.21] {
                let source =
                    |t: f64, _: &FloorDiskState| FloorDiskInputs { fy: if t < from { 0.5 } else { bad }, ..NO_FORCE };
                let refused = floor().simulate(start).method(method).inputs(source).until(0.5).expect_err("no force");
                assert_eq!(refused.error, Error::NonFinite { name: "fy" }, "{method:?} {bad} from {from}");
                let (t, last) = refused.trajectory.last();
                assert!(t <= from && last.dot_y.is_finite());
            }
        }
    }
    let refused = floor().simulate(start).until(1.0).expect_err("no inputs");
    assert_eq!(refused.error, Error::MissingInputs { inputs: &["fx", "fy"] });
}

/// A cart that loses mass as it moves.
#[derive(ConstrainedSystem, Clone)]
#[coordinates(x, y)]
#[inertia(matrix([m*(1 - a*x), m/2], [_, m]))]
#[forces(0, 0)]
struct Leaking {
    m: f64,
    a: f64,
}

#[test]
fn parameters_that_make_the_inertia_indefinite() {
    // M_d of the rolling disk is diag(2 j + m r², j, j + m r²)
    let disk = |m: f64, j: f64| RollingDisk { m, r: 0.5, j, g: 9.81 };
    let refused = disk(2.0, -0.125).prepare().expect_err("a negative moment of inertia");
    assert_eq!(refused, Error::Indefinite { pivot: "j", value: -0.125, time: None });
    let refused = disk(2.0, 0.0).prepare().expect_err("no moment of inertia");
    assert_eq!(refused, Error::Indefinite { pivot: "j", value: 0.0, time: None });
    let refused = disk(-2.0, 0.125).prepare().expect_err("a negative mass");
    assert_eq!(refused, Error::Indefinite { pivot: "2*j + m*powi(r, 2)", value: -0.25, time: None });
    assert!(refused.to_string().contains("check masses"));
    let indefinite = |error: Option<Error>| matches!(error, Some(Error::Indefinite { time: None, .. }));
    for (m, j) in [(0.0, 0.125), (-2.0, 0.125), (2.0, 0.0), (2.0, -0.125)] {
        assert!(indefinite(FloorDisk { m, r: 0.5, j, g: 9.81 }.prepare().err()), "{m} {j}");
    }
    for (m, j) in [(-2.0, 0.125), (2.0, 0.0), (2.0, -0.125)] {
        assert!(indefinite(StagedDisk { m, r: 0.5, j, g: 9.81 }.prepare().err()), "{m} {j}");
    }
    // positive on the diagonal, but not definite
    assert!(indefinite(Sleigh { m: 1.0, i: -1.0, a: 0.9 }.prepare().err()));
    assert!(indefinite(SleighInPlane { m: 1.0, i: -1.0, a: 0.9 }.prepare().err()));
    assert!(indefinite(Atwood { m1: 2.0, m2: -2.0, c: 0.0, g: 9.81 }.prepare().err()));
    // a length is no inertia
    let refused = DoublePendulum { m1: 1.0, m2: 1.0, l1: 1.0, l2: 0.0, g: 9.81 }.prepare().expect_err("no length");
    assert!(matches!(refused, Error::SingularParameter { guard: "l2", .. }), "{refused:?}");
}

#[test]
fn an_inertia_that_becomes_indefinite() {
    let cart = Leaking { m: 2.0, a: 0.5 }.prepare().expect("a cart");
    // M = m [[1 - a x, 1/2], [1/2, 1]] is definite up to x = 1.5
    let at = |x: f64, dot_x: f64| LeakingState { x, dot_x, ..Default::default() };
    let refused = cart.simulate(at(1.75, 0.0)).until(1.0).expect_err("indefinite from the start");
    assert!(matches!(refused.error, Error::Indefinite { time: Some(0.0), .. }), "{:?}", refused.error);
    for method in METHODS {
        let stopped = cart.simulate(at(0.0, 5.0)).method(method).until(2.0).expect_err("it runs out of mass");
        let (t, last) = stopped.trajectory.last();
        assert!(last.x < 1.5 && t > 0.0, "{method:?}: x = {} at {t}", last.x);
        // a step that comes close to the zero finds a singular state, one that jumps over it an indefinite one
        assert!(
            matches!(
                stopped.error,
                Error::Indefinite { time: Some(_), .. } | Error::ChartSingularity { .. } | Error::StepTooSmall { .. }
            ),
            "{method:?}: {:?}",
            stopped.error
        );
        println!("{method:?}: {:?}", stopped.error);
    }
}
