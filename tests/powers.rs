//! Inverse dynamics, momenta and power of models by geometry, against what can be written down.

use holonomy::{ConstrainedSystem, Error, State, Vector};

/// A crane: a trolley that is driven along a rail, and a load on a rod with a damped and driven hinge, all on a base that moves by
/// itself as a function of time.
#[derive(ConstrainedSystem, Clone)]
#[coordinates(x, angle)]
#[inputs(push, drive)]
#[frame(A = rotate(N, z, angle))]
#[point(C = O + (x + a*sin(2*t))*N.x, P = C - l*A.y)]
#[particle(trolley = { at: C, mass: m1 })]
#[body(load = { frame: A, center: P, mass: m2, inertia: sphere(m2, l/4) })]
#[gravity(-g*N.y)]
#[force(motor = { at: C, value: push*N.x })]
#[torque(hinge = { on: A, value: drive*N.z })]
#[damper(friction = { of: angle, coefficient: c })]
#[output(across = dot(momentum(trolley) + momentum(load), N.x), up = dot(momentum(load), N.y))]
#[output(about = dot(angular_momentum(load, C), N.z), of_trolley = norm(angular_momentum(trolley, C)))]
struct Crane {
    m1: f64,
    m2: f64,
    l: f64,
    a: f64,
    c: f64,
    g: f64,
}

fn crane(a: f64) -> Crane {
    Crane { m1: 3.0, m2: 1.5, l: 0.8, a, c: 0.3, g: 9.81 }
}

const AWAY: State<Crane> = CraneState { x: 0.4, angle: 0.7, dot_x: -0.6, dot_angle: 1.3 };
const INPUTS: CraneInputs = CraneInputs { push: 5.0, drive: -2.0 };

#[test]
fn power_is_that_of_what_has_no_potential() -> Result<(), Error> {
    // Where the base is at rest: the force times the trolley's speed, the torque times the hinge's, less what friction takes.
    let (own, u) = (INPUTS, AWAY);
    let expected = own.push * u.dot_x + own.drive * u.dot_angle - 0.3 * u.dot_angle * u.dot_angle;
    let power = crane(0.0).prepare()?.power(0.0, &u, &own)?;
    assert!((power - expected).abs() < 1e-13, "{power} {expected}");
    // Where it moves, what moves it gives the rest: the rate of the energy by differences along the motion.
    let moved = crane(0.2).prepare()?;
    let energy = |h: f64| -> f64 {
        let (rate, _) = moved.derivative(0.3, &u, &own);
        let (now, rate): ([f64; 4], [f64; 4]) = (u.into(), rate.into());
        moved.energy(0.3 + h, &State::<Crane>::from_fn(|i| now[i] + h * rate[i]))
    };
    let central = |h: f64| (energy(h) - energy(-h)) / (2.0 * h);
    let rate = (4.0 * central(5e-4) - central(1e-3)) / 3.0;
    let power = moved.power(0.3, &u, &own)?;
    assert!((power - rate).abs() < 1e-9 && (power - expected).abs() > 0.1, "{power} {rate}");
    Ok(())
}

#[test]
fn inverse_dynamics_undoes_the_motion() -> Result<(), Error> {
    let crane = crane(0.2).prepare()?;
    let wanted = [0.8, -2.5];
    let needed = crane.inverse_dynamics(0.3, &AWAY, &wanted, &CraneInputs { push: 0.0, drive: 0.0 });
    // The motors' inputs are the forces along the two speeds, but that the trolley's also moves what hangs on it.
    let found = crane.accelerations(0.3, &AWAY, &CraneInputs { push: needed[0], drive: needed[1] });
    for (found, wanted) in found.iter().zip(wanted) {
        assert!((found - wanted).abs() < 1e-13, "{found} {wanted}");
    }
    Ok(())
}

#[test]
fn momenta_are_those_of_the_bodies() -> Result<(), Error> {
    let crane = crane(0.2).prepare()?;
    let CraneState { angle, dot_x, dot_angle, .. } = AWAY;
    let v = crane.velocities(0.3, &AWAY);
    let p = crane.momenta(0.3, &crane.coordinates(0.3, &AWAY), &v);
    // The load moves with ẋ + l φ̇ (cos φ, sin φ).
    let (across, up) = (dot_x + 0.8 * dot_angle * angle.cos(), 0.8 * dot_angle * angle.sin());
    let along_x = 3.0 * dot_x + 1.5 * across;
    let own = 0.4 * 1.5 * 0.2 * 0.2 * dot_angle;
    let along_angle = 1.5 * 0.8 * (across * angle.cos() + up * angle.sin()) + own;
    assert!((p.dot_x - along_x).abs() < 1e-14 && (p.dot_angle - along_angle).abs() < 1e-14, "{p:?}");
    // Those by name are vectors; the base's own motion 2 a cos 2t counts in them.
    let told = crane.outputs(0.3, &AWAY, &INPUTS);
    let base = 2.0 * 0.2 * 0.6_f64.cos();
    assert!((told.across - along_x - 4.5 * base).abs() < 1e-14, "{told:?}");
    assert!((told.up - 1.5 * up).abs() < 1e-15, "{told:?}");
    assert!((told.about - along_angle - 1.5 * 0.8 * angle.cos() * base).abs() < 1e-14, "{told:?}");
    assert_eq!(told.of_trolley, 0.0);
    Ok(())
}
