//! Derived models that leave their charts during a run, and come back: the spherical pendulum against the same motion in angles;
//! long runs in dependent coordinates; nonlinear constraints in (x, v); true singularities.

#[path = "models/spherical.rs"]
mod spherical;

use holonomy::prelude::*;
use holonomy::simulate::{Chart, Charts};
use holonomy::{Error, Trajectory};
use spherical::*;

const L: f64 = 0.8;
const G: f64 = 9.81;

/// A motion about the level rod: θ swings about 90°, and φ goes round.
const THETA: f64 = 1.35;
const RATES: [f64; 2] = [0.4, 9.0];

/// x, y, z and their rates.
fn place([theta, phi, theta_rate, phi_rate]: [f64; 4]) -> ([f64; 3], [f64; 3]) {
    let ((st, ct), (sp, cp)) = (theta.sin_cos(), phi.sin_cos());
    let (along, across) = (L * ct * theta_rate, L * st * phi_rate);
    ([L * st * cp, L * st * sp, -L * ct], [along * cp - across * sp, along * sp + across * cp, L * st * theta_rate])
}

fn in_angles(end: f64) -> Trajectory<SphericalInAngles> {
    let model = SphericalInAngles { m: 1.3, l: L, g: G }.prepare().unwrap();
    let start = SphericalInAnglesState { theta: THETA, phi: 0.2, dot_theta: RATES[0], dot_phi: RATES[1] };
    model.simulate(start).tolerance(1e-14, 1e-14).until(end).unwrap()
}

/// The largest distance in place and velocity from the run in angles, the largest change of the energy, and the largest |f|.
fn compare<M>(run: &Trajectory<M>, model: &Prepared<M>, exact: &Trajectory<SphericalInAngles>) -> [f64; 3]
where
    M: ConstrainedSystem,
{
    let entries = |v: &M::Velocities<f64>| -> Vec<f64> { (*v).into().as_ref().to_vec() };
    let mut worst = [0.0_f64; 3];
    let mut first = None;
    for ((t, s), v) in run.iter().zip(run.velocities()) {
        let a = exact.at(t).unwrap();
        let (x, dot_x) = place([a.theta, a.phi, a.dot_theta, a.dot_phi]);
        let array: <M::State<f64> as Vector<f64>>::Array = (*s).into();
        let v_array = entries(v);
        let errors = array.as_ref()[..3].iter().zip(x).chain(v_array.iter().zip(dot_x)).map(|(a, b)| (a - b).abs());
        worst[0] = errors.fold(worst[0], f64::max);
        let x = model.coordinates(t, s);
        let energy = model.kinetic_energy(t, &x, v) + model.potential_energy(t, &x).unwrap();
        let first = *first.get_or_insert(energy);
        worst[1] = worst[1].max((energy - first).abs());
        let f: <M::PositionRows<f64> as Vector<f64>>::Array = model.position_residual(t, &x).into();
        worst[2] = f.as_ref().iter().fold(worst[2], |worst, f| worst.max(f.abs()));
    }
    worst
}

/// A run of a model in x, y, z from the same start, given by all velocities.
fn run<M>(model: &Prepared<M>, charts: Charts, tolerance: f64, end: f64) -> Trajectory<M>
where
    M: ConstrainedSystem,
{
    let (x, v) = place([THETA, 0.2, RATES[0], RATES[1]]);
    let start = M::State::from_fn(|i| if i < 3 { x[i] } else { 0.0 });
    let velocities = M::Velocities::from_fn(|i| v[i]);
    let run = model.simulate(start).velocities(velocities).charts(charts).tolerance(tolerance, tolerance);
    run.dense(false).until(end).unwrap()
}

#[test]
fn a_thousand_changes_between_three_charts() {
    let model = SphericalInCharts { m: 1.3, l: L, g: G }.prepare().unwrap();
    let exact = in_angles(185.0);
    let run = run(&model, Charts::Change, 1e-14, 185.0);
    let [motion, energy, f] = compare(&run, &model, &exact);
    println!("motion {motion:.1e}, energy {energy:.1e}, f {f:.1e}, {:?}, {:?}", run.statistics(), run.charts());
    assert!(run.statistics().chart_changes >= 1000, "{:?}", run.statistics());
    assert!(!run.charts().iter().any(|(chart, _)| *chart == Chart::General), "one of the three is always flat");
    assert!(motion < 2e-8 && energy < 1e-9 && f < 1e-14, "{motion:e} {energy:e} {f:e}");
}

#[test]
fn one_chart_goes_through_the_general_one_by_itself() {
    let model = Spherical { m: 1.3, l: L, g: G }.prepare().unwrap();
    let exact = in_angles(20.0);
    for charts in [Charts::Change, Charts::General] {
        let run = run(&model, charts, 1e-13, 20.0);
        let [motion, energy, f] = compare(&run, &model, &exact);
        println!("motion {motion:.1e}, energy {energy:.1e}, f {f:.1e}, {:?}, {:?}", run.statistics(), run.charts());
        assert!(motion < 1e-9 && energy < 1e-9 && f < 1e-14, "{motion:e} {energy:e} {f:e}");
        let largest = run.largest_residuals();
        assert!(largest.position < 1e-14 && largest.velocity < 1e-14, "{largest:?}");
    }
}

/// From below the level to above it and back, many times: out of the one chart, and back into it.
#[test]
fn a_swing_through_the_level_enters_its_chart_again() {
    let model = Spherical { m: 1.3, l: L, g: G }.prepare().unwrap();
    let start = SphericalState { x: 0.0, y: 0.0, z: -L, dot_x: 7.5, dot_y: 0.0 };
    let run = model.simulate(start).tolerance(1e-12, 1e-12).until(20.0).unwrap();
    assert!(run.statistics().chart_changes > 50, "{:?}", run.statistics());
    let energy = 0.5 * 1.3 * 7.5 * 7.5 - 1.3 * G * L;
    for ((t, s), v) in run.iter().zip(run.velocities()) {
        let x = model.coordinates(t, s);
        assert!((model.kinetic_energy(t, &x, v) + 1.3 * G * s.z - energy).abs() < 1e-8, "{t}");
    }
    // On the level the state alone does not tell the reaction; place and velocities do.
    for i in 0..200 {
        let t = 0.1 * f64::from(i);
        let (s, v) = (run.at(t).unwrap(), run.velocities_at(t).unwrap());
        let square = v.dot_x * v.dot_x + v.dot_y * v.dot_y + v.dot_z * v.dot_z;
        let exact = -1.3 * (square - G * s.z) / (L * L);
        assert!((run.multipliers_at(t, &[]).unwrap().rod - exact).abs() < 1e-6, "{t}");
    }
}

/// A short version of what the example `spherical_pendulum` does for 1,000 s.
/// The pivot of D M Dᵀ contains 1/z² and vanishes with it, often before it: the chart's own pivot is the one to name.
#[test]
fn a_chart_that_breaks_down_is_told_by_its_own_pivot() {
    let model = Spherical { m: 1.3, l: L, g: G }.prepare().unwrap();
    for number in 0..300 {
        let dot_x = 7.0 + 0.01 * f64::from(number);
        let start = SphericalState { x: 0.0, y: 0.0, z: -L, dot_x, dot_y: 0.0 };
        let stopped = model.simulate(start).charts(Charts::Stay).until(20.0).unwrap_err();
        assert!(matches!(stopped.error, Error::ChartSingularity { guard: "z", .. }), "{dot_x}: {}", stopped.error);
    }
}

#[test]
fn an_undriven_run_keeps_its_energy_and_its_constraint() {
    let model = SphericalInCharts { m: 1.3, l: L, g: G }.prepare().unwrap();
    let start = SphericalInChartsState { x: 0.48, y: 0.0, z: -0.64, dot_x: 0.0, dot_y: 1.2 };
    let energy = model.energy(0.0, &start);
    let run = model.simulate(start).tolerance(1e-10, 1e-10).dense(false).until(60.0).unwrap();
    let found = run.iter().zip(run.velocities()).map(|((t, s), v)| {
        let x = model.coordinates(t, s);
        model.kinetic_energy(t, &x, v) + 1.3 * G * s.z
    });
    let worst = found.fold(0.0_f64, |worst, found| worst.max((found / energy - 1.0).abs()));
    println!("energy {worst:.1e}, {:?}, {:?}", run.largest_residuals(), run.statistics());
    assert!(run.largest_residuals().position < 1e-10 && worst < 6e-9, "{worst:e}");
}

/// Appell and Hamel's machine: φ = ẋ² + ẏ² − c² ż² by Chetaev's rule (P7).
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, -m*g)]
#[potential_energy(m*g*z)]
#[constraint(cone: (powi(dot(x), 2) + powi(dot(y), 2) - powi(c*dot(z), 2))/2 == 0)]
#[start(x = 0, y = 0, z = 0)]
struct AppellHamel {
    m: f64,
    g: f64,
    c: f64,
}

/// z̈ = −g/(1 + c²), and the horizontal speed is c |ż| in a fixed direction.
#[test]
fn appell_hamel_in_places_and_velocities() {
    let (m, c, turn) = (1.3, 1.6, 0.6_f64);
    let model = AppellHamel { m, g: G, c }.prepare().unwrap();
    let (fall, rate) = (G / (1.0 + c * c), -0.5_f64);
    let speeds =
        AppellHamelVelocities { dot_x: c * rate.abs() * turn.cos(), dot_y: c * rate.abs() * turn.sin(), dot_z: rate };
    for charts in [Charts::Change, Charts::General] {
        let run = model.simulate(AppellHamelState::default()).velocities(speeds).charts(charts);
        let run = run.tolerance(1e-12, 1e-12).until(2.0).unwrap();
        for i in 0..=20 {
            let t = 0.1 * f64::from(i);
            let (s, v) = (run.at(t).unwrap(), run.velocities_at(t).unwrap());
            let z = rate * t - 0.5 * fall * t * t;
            let exact = [c * -z * turn.cos(), c * -z * turn.sin(), z];
            let fast = rate - fall * t;
            let lambda = -m * G / ((1.0 + c * c) * fast);
            assert!((s.x - exact[0]).abs() + (s.y - exact[1]).abs() + (s.z - exact[2]).abs() < 1e-9, "{charts:?} {t}");
            assert!((v.dot_z - fast).abs() < 1e-9 && (v.dot_x - c * -fast * turn.cos()).abs() < 1e-9);
            assert!((run.multipliers_at(t, &[]).unwrap().cone - lambda).abs() < 1e-9 * lambda.abs().max(1.0));
        }
        assert!(run.largest_residuals().velocity < 1e-14, "{:?}", run.largest_residuals());
    }
}

/// Thrown upwards it comes to rest, where the gradient of φ vanishes and the reaction is not finite: an error.
#[test]
fn appell_hamel_at_rest_is_an_error_that_names_the_constraint() {
    let (c, rate) = (1.6, 1.0);
    let model = AppellHamel { m: 1.3, g: G, c }.prepare().unwrap();
    let speeds = AppellHamelVelocities { dot_x: c * rate, dot_y: 0.0, dot_z: rate };
    let rest = rate * (1.0 + c * c) / G;
    let methods = [Method::Dop853, Method::DormandPrince, Method::Rk4 { step: 0.01 }];
    for (method, charts) in methods.into_iter().flat_map(|method| [(method, Charts::Change), (method, Charts::General)])
    {
        let run = model.simulate(AppellHamelState::default()).velocities(speeds).charts(charts);
        let interrupted = run.method(method).until(1.0).unwrap_err();
        let (t, _) = interrupted.trajectory.last();
        match &interrupted.error {
            Error::Dependent { rows, .. } => assert_eq!(*rows, ["cone"]),
            other => panic!("{method:?}, {charts:?}: {other:?}"),
        }
        assert!(t < rest + 1e-9, "{method:?}: {t} {rest}");
    }
}
