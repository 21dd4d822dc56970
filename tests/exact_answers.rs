//! Mechanisms whose motion and reactions are known in closed form.
//!
//! Accelerations and reactions at a state to a relative 1e-12; motions, by an extrapolation integrator of order 16, to 1e-9.

mod models;
mod support;

use holonomy::ConstrainedSystem;
use models::{
    Atwood, BeadByDistance, BeadOnRod, ConicalPendulum, DoublePendulum, HangingPendulum, KnifeEdge, Pendulum,
    PendulumByAngle, Sleigh, SleighInPlane,
};
use support::extrapolation::integrate;
use support::golden::assert_close;
use support::running::{Running, by_rows};
use support::special::{gudermannian, jacobi, quarter_period};
use support::splitmix::SplitMix;

const AT_A_STATE: f64 = 1e-12;
const IN_MOTION: f64 = 1e-9;
const G: f64 = 9.81;

fn times(until: f64, count: usize) -> Vec<f64> {
    (0..=count).map(|i| until * i as f64 / count as f64).collect()
}

/// From rest at `amplitude`: alpha = 2 asin(k sn(w t + K)), lambda = -(m/l²)(l² alpha'² + g l cos alpha).
fn swings<M: ConstrainedSystem>(model: M, coordinates: impl Fn(f64) -> Vec<f64>, [m, l]: [f64; 2], amplitude: f64) {
    let pendulum = Running::new(model);
    let (k, w) = ((amplitude / 2.0).sin(), (G / l).sqrt());
    let period = 4.0 * quarter_period(k) / w;
    let start = pendulum.with_velocities(0.0, &coordinates(amplitude), &[0.0, 0.0]);
    let times = times(1.25 * period, 10);
    for (t, y) in times.iter().zip(pendulum.run(&start, &times, 0.02)) {
        let (sn, cn, _) = jacobi(w * t + quarter_period(k), k);
        let (alpha, rate) = (2.0 * (k * sn).asin(), 2.0 * k * w * cn);
        let (sin, cos) = alpha.sin_cos();
        let place = format!("{} at {t}", M::MODEL.name);
        assert_close(&place, &pendulum.coordinates(*t, &y), &[l * sin, -l * cos], IN_MOTION);
        // the velocity passes through zero: its scale is the largest speed of the motion
        let v = pendulum.velocities(*t, &y);
        let (expected, scale) = ([l * rate * cos, l * rate * sin], 2.0 * k * w * l);
        assert!(
            (v[0] - expected[0]).abs().max((v[1] - expected[1]).abs()) <= IN_MOTION * scale,
            "{place}: {v:?} {expected:?}"
        );
        let lambda = -(m / (l * l)) * (l * l * rate * rate + G * l * cos);
        let error = (pendulum.multiplier("rod", *t, &y) - lambda).abs();
        assert!(error <= IN_MOTION * 3.0 * m * G / l, "{place}: the rod's force is off by {error}");
    }
}

#[test]
fn p1_pendulum() {
    let (m, l) = (1.5, 0.8);
    let cartesian = |alpha: f64| vec![l * alpha.sin(), -l * alpha.cos()];
    swings(Pendulum { m, l, g: G }, cartesian, [m, l], 1.0);
    swings(Pendulum { m, l, g: G }, cartesian, [m, l], 2.8);
    swings(PendulumByAngle { m, l, g: G }, |alpha| vec![alpha], [m, l], 1.0);
    swings(PendulumByAngle { m, l, g: G }, |alpha| vec![alpha], [m, l], 2.8);
    // the chart of the horizontal velocity ends where the rod is level
    swings(HangingPendulum { m, l, g: G }, cartesian, [m, l], 1.2);
}

#[test]
fn p1_pendulum_reduced() {
    let pendulum = Running::new(Pendulum { m: 1.5, l: 0.8, g: G });
    let (sin, cos) = 0.7_f64.sin_cos();
    let y = [0.8 * sin, -0.8 * cos, 0.3];
    let s = pendulum.state(&y);
    assert_close("M_d", &by_rows(&pendulum.0.mass_matrix(0.0, &s)), &[1.5 * 0.64], AT_A_STATE);
    assert_close("u̇", &pendulum.accelerations(0.0, &y), &[-G / 0.8 * sin], AT_A_STATE);
    assert_close("λ", &pendulum.multipliers(0.0, &y), &[-(1.5 / 0.64) * (0.64 * 0.09 + G * 0.8 * cos)], AT_A_STATE);
}

/// rho = rho0 cosh wt + (rho0' - g/2w) sinh(wt)/w + g sin(wt)/2w², lambda = m (2 w rho' + g cos wt).
fn slides<M: ConstrainedSystem>(model: M, coordinates: impl Fn(f64) -> Vec<f64>, [m, w]: [f64; 2]) {
    let bead = Running::new(model);
    let (rho0, rate0) = (0.4, -0.3);
    let start = bead.with_velocities(0.0, &coordinates(rho0), &[rate0, w * rho0]);
    let times = times(2.5, 10);
    for (t, y) in times.iter().zip(bead.run(&start, &times, 0.02)) {
        let (sin, cos) = (w * t).sin_cos();
        let (sinh, cosh) = ((w * t).sinh(), (w * t).cosh());
        let free = rate0 - G / (2.0 * w);
        let rho = rho0 * cosh + free * sinh / w + G * sin / (2.0 * w * w);
        let rate = rho0 * w * sinh + free * cosh + G * cos / (2.0 * w);
        let place = format!("{} at {t}", M::MODEL.name);
        assert_close(&place, &bead.coordinates(*t, &y), &[rho * cos, rho * sin], IN_MOTION);
        let expected = [rate * cos - w * rho * sin, rate * sin + w * rho * cos];
        assert_close(&place, &bead.velocities(*t, &y), &expected, IN_MOTION);
        assert_close(&place, &[bead.multiplier("rod", *t, &y)], &[m * (2.0 * w * rate + G * cos)], IN_MOTION);
    }
}

#[test]
fn p2_bead_on_a_turning_rod() {
    let (m, w) = (0.7, 1.25);
    slides(BeadOnRod { m, w, g: G }, |rho| vec![rho, 0.0], [m, w]);
    slides(BeadByDistance { m, w, g: G }, |rho| vec![rho], [m, w]);
}

/// u = V tanh tau, o = (V/b) sech tau, heading (b/a) gd tau with tau = a V t/b² + c; lambda = m u o i/(i + m a²).
fn coasts<M: ConstrainedSystem>(model: M, [m, i, a]: [f64; 3], velocities: impl Fn(f64, f64, f64) -> [f64; 3]) {
    let sleigh = Running::new(model);
    let b = ((i + m * a * a) / m).sqrt();
    let (speed, tau0, until) = (1.3, -3.0, 6.0);
    let of = |t: f64| {
        let tau = a * speed * t / (b * b) + tau0;
        (speed * tau.tanh(), speed / b / tau.cosh(), b / a * gudermannian(tau))
    };
    let (u0, o0, heading0) = of(0.0);
    let start = sleigh.with_velocities(0.0, &[0.1, -0.2, heading0], &velocities(u0, o0, heading0));
    let times = times(until, 12);
    for (t, y) in times.iter().zip(sleigh.run(&start, &times, 0.02)) {
        let (u, o, heading) = of(*t);
        let place = format!("{} at {t}", M::MODEL.name);
        assert_close(&place, &sleigh.velocities(*t, &y), &velocities(u, o, heading), IN_MOTION);
        assert!((y[2] - heading).abs() <= IN_MOTION * heading0.abs(), "{place}: heading");
        let lambda = m * u * o * i / (i + m * a * a);
        let error = (sleigh.multiplier("blade", *t, &y) - lambda).abs();
        assert!(error <= IN_MOTION * m * speed * speed / b, "{place}: the blade's force is off by {error}");
        let energy = m / 2.0 * speed * speed;
        assert_close(&place, &[sleigh.energy(*t, &y)], &[energy], IN_MOTION);
    }
}

#[test]
fn p4_chaplygin_sleigh() {
    let (m, i, a) = (2.5, 0.3, 0.4);
    coasts(Sleigh { m, i, a }, [m, i, a], |u, o, _| [u, 0.0, o]);
    coasts(SleighInPlane { m, i, a }, [m, i, a], |u, o, heading| [u * heading.cos(), u * heading.sin(), o]);
}

/// From rest with phi = w t: x = s sin²(wt)/2w², y = s (wt - sin(2wt)/2)/2w², lambda = 2 m s sin wt, s = g sin(incline).
#[test]
fn p5_knife_edge_on_an_incline() {
    let (m, i, incline, w) = (2.0, 0.7, 0.5, 1.5);
    let blade = Running::new(KnifeEdge { m, i, g: G, incline });
    let s = G * f64::sin(incline);
    let start = blade.with_velocities(0.0, &[0.0, 0.0, 0.0], &[0.0, 0.0, w]);
    // phi runs through ±90°, where x' or y' as a speed would fail
    let times = times(5.0, 20);
    for (t, y) in times.iter().zip(blade.run(&start, &times, 0.02)) {
        let (sin, cos) = (w * t).sin_cos();
        let expected = [s * sin * sin / (2.0 * w * w), s * (w * t - sin * cos) / (2.0 * w * w), w * t];
        if *t == 0.0 {
            assert_eq!(y[..3], expected);
            continue;
        }
        assert_close("x, y, phi", &y[..3], &expected, IN_MOTION);
        let v = [s * sin * cos / w, s * sin * sin / w, w];
        assert_close("x', y', phi'", &blade.velocities(*t, &y), &v, IN_MOTION);
        let error = (blade.multiplier("blade", *t, &y) - 2.0 * m * s * sin).abs();
        assert!(error <= IN_MOTION * 2.0 * m * s, "the blade's force is off by {error} at {t}");
    }
}

/// Sphere: lambda = -m w²; plane: lambda = m (g - w² r cos(opening)); the rate stays.
#[test]
fn p12_conical_pendulum() {
    let (m, r, opening, w) = (1.2, 2.0, 0.6, 1.75);
    let pendulum = Running::new(ConicalPendulum { m, r, opening, g: G });
    let radius = r * f64::sin(opening);
    let at = |t: f64| {
        let (sin, cos) = (w * t + 0.3).sin_cos();
        ([radius * cos, radius * sin, -r * opening.cos()], [-radius * w * sin, radius * w * cos, 0.0])
    };
    let start = pendulum.with_velocities(0.0, &at(0.0).0, &at(0.0).1);
    let times = times(4.0, 10);
    for (t, y) in times.iter().zip(pendulum.run(&start, &times, 0.02)) {
        assert_close("x", &pendulum.coordinates(*t, &y), &at(*t).0, IN_MOTION);
        assert_close("v", &pendulum.velocities(*t, &y), &at(*t).1, IN_MOTION);
        let lambda = [-m * w * w, m * (G - w * w * r * opening.cos())];
        assert_close("λ", &["sphere", "plane"].map(|name| pendulum.multiplier(name, *t, &y)), &lambda, IN_MOTION);
    }
    assert_close(
        "λ",
        &pendulum.multipliers(0.0, &start),
        &[-m * w * w, m * (G - w * w * r * opening.cos())],
        AT_A_STATE,
    );
}

/// y1'' = (m2 - m1) g/(m1 + m2), lambda = 2 m1 m2 g/(m1 + m2).
#[test]
fn p15_atwood() {
    let (m1, m2, c) = (2.0, 3.5, -4.0);
    let machine = Running::new(Atwood { m1, m2, c, g: G });
    let (height, rate) = (-1.5, 0.25);
    let start = machine.with_velocities(0.0, &[height, c - height], &[rate, -rate]);
    let a = (m2 - m1) * G / (m1 + m2);
    assert_close("v̇", &machine.velocity_rates(0.0, &start), &[a, -a], AT_A_STATE);
    assert_close("λ", &machine.multipliers(0.0, &start), &[2.0 * m1 * m2 * G / (m1 + m2)], AT_A_STATE);
    let end = machine.run(&start, &[0.0, 2.0], 0.1).pop().expect("an end");
    let y1 = height + 2.0 * rate + 2.0 * a;
    assert_close("y", &machine.coordinates(2.0, &end), &[y1, c - y1], IN_MOTION);
}

/// M_d = [[(m1+m2) l1², m2 l1 l2 cos d], [., m2 l2²]], h_u* = [-m2 l1 l2 w2² sin d - (m1+m2) g l1 sin a1,
/// m2 l1 l2 w1² sin d - m2 g l2 sin a2], d = a1 - a2; and the energy over a long, chaotic run.
#[test]
fn p16_double_pendulum() {
    let (m1, m2, l1, l2) = (2.0, 1.25, 0.9, 0.6);
    let pendulum = Running::new(DoublePendulum { m1, m2, l1, l2, g: G });
    let mut random = SplitMix::new(16);
    for _ in 0..20 {
        let y = [random.vector(2, -3.0, 3.0), random.vector(2, -2.0, 2.0)].concat();
        let [a1, a2, w1, w2] = [y[0], y[1], y[2], y[3]];
        let (sin, cos) = (a1 - a2).sin_cos();
        let coupling = m2 * l1 * l2;
        let m = [(m1 + m2) * l1 * l1, coupling * cos, coupling * cos, m2 * l2 * l2];
        let h = [
            -coupling * w2 * w2 * sin - (m1 + m2) * G * l1 * a1.sin(),
            coupling * w1 * w1 * sin - m2 * G * l2 * a2.sin(),
        ];
        let s = pendulum.state(&y);
        assert_close("M_d", &by_rows(&pendulum.0.mass_matrix(0.0, &s)), &m, AT_A_STATE);
        assert_close("h_u*", &pendulum.forcing(0.0, &y), &h, AT_A_STATE);
    }
    let start = [2.0, -1.5, 0.0, 0.5];
    let run = pendulum.run(&start, &times(20.0, 20), 0.01);
    let energy = pendulum.energy(0.0, &start);
    for y in run {
        assert!((pendulum.energy(0.0, &y) - energy).abs() <= 1e-11 * (m1 + m2) * G * (l1 + l2), "energy");
    }
}

/// From a state off the constraint, (3.5) keeps f̈ = 0 and nothing else: f(t) = f0 + ḟ0 t. Both D = [-y, x] and a numerical one.
#[test]
fn p18_drift_from_inconsistent_data() {
    let (m, l) = (1.5, 0.8);
    let pendulum = Pendulum { m, l, g: G }.prepare().expect("good parameters");
    let (f0, rate0) = (0.02, -0.013);
    // x² + y² = l² + 2 f0 and x x' + y y' = f0'
    let radius = (l * l + 2.0 * f0).sqrt();
    let (sin, cos) = 0.7_f64.sin_cos();
    let (along, across) = (rate0 / radius, 1.1);
    let start = [radius * sin, -radius * cos, along * sin + across * cos, -along * cos + across * sin];
    let rate = |t: f64, y: &[f64], given: bool| {
        let full = pendulum.initial_equations(t, &[y[0], y[1]], &[y[2], y[3]].into(), &[]);
        let rates = if given {
            full.tangent_rates(&nalgebra::DMatrix::from_row_slice(1, 2, &[-y[1], y[0]])).expect("regular")
        } else {
            full.solve_by(holonomy::forms::NullSpaceMethod::Qr).expect("regular").0
        };
        vec![y[2], y[3], rates[0], rates[1]]
    };
    for given in [true, false] {
        let times = times(3.0, 6);
        for (t, y) in times.iter().zip(integrate(|t, y| rate(t, y, given), &start, &times, 0.02)) {
            let f = (y[0] * y[0] + y[1] * y[1] - l * l) / 2.0;
            let expected = f0 + rate0 * t;
            assert!((f - expected).abs() <= IN_MOTION * l * l, "{f} instead of {expected} at {t}");
        }
    }
}
