//! Joints in short: what they let move, and what their reactions are.

#[path = "models/geometry/joints.rs"]
mod joints;

use holonomy::prelude::*;
use holonomy::{Error, Method, State};
use joints::{Cardan, Hinged, OnARail, Seamed, SpatialFourBar, Turntable};

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * (1.0 + expected.abs()), "{found} instead of {expected}");
}

/// A physical pendulum: α = m g (l/2) cos θ/J about its end; the hinge's force and the moment that holds the axis.
#[test]
fn a_hinge_holds_two_of_three_turns() -> Result<(), Error> {
    let (m, l, w, g, f) = (2.0, 0.8, 0.1, 9.81, 3.0);
    let bar = Hinged { m, l, w, g, f }.prepare()?;
    // Below the level by θ, about y.
    let (theta, omega) = (0.4_f64, 1.5);
    let (sin, cos) = theta.sin_cos();
    let (e0, e2) = ((theta / 2.0).cos(), (theta / 2.0).sin());
    let guess = State::<Hinged> { x: l / 2.0 * cos, z: -l / 2.0 * sin, e0, e2, omega_B_y: omega, ..Default::default() };
    assert_eq!(Hinged::MODEL.state_speeds.len(), 1);
    let start = bar.assemble(guess).solve()?;
    let j = m * (l * l + w * w) / 12.0 + m * l * l / 4.0;
    let alpha = m * g * l / 2.0 * cos / j;
    let rates = bar.velocity_rates(0.0, &start, &[]);
    close(rates.get("omega_B_y").expect("a speed"), alpha, 1e-12);
    // The centre is accelerated towards the hinge and across; the rest of the force is the hinge's.
    let (inward, across) = (l / 2.0 * omega * omega, l / 2.0 * alpha);
    let (ax, az) = (-inward * cos - across * sin, inward * sin - across * cos);
    let held = bar.multipliers(0.0, &start, &[]);
    close(held.hinge_x, m * ax, 1e-12);
    close(held.hinge_y, -f, 1e-12);
    close(held.hinge_z, m * az + m * g, 1e-12);
    // Of the moment about the hinge only that of the force across is left, (l/2) B.x × f N.y = (l f/2) B.z: the hinge's is opposite.
    // λ of the row of B.i is a moment about B.i × N.y, and N.y is B.y here: B.x × B.y = B.z.
    close(held.hinge_axes_x, -l * f / 2.0, 1e-12);
    close(held.hinge_axes_z, 0.0, 1e-12);
    Ok(())
}

/// Along the rail it goes as it is pushed, and nothing turns.
#[test]
fn a_rail_holds_all_turns() -> Result<(), Error> {
    let (m, l, w, g, f, slope) = (2.0, 0.8, 0.1, 9.81, 3.0, 0.3_f64);
    let bar = OnARail { m, l, w, g, f, slope }.prepare()?;
    // About -y, as the rail's axes.
    let (e0, e2) = ((slope / 2.0).cos(), -(slope / 2.0).sin());
    let (x, z) = (0.5 * slope.cos(), 0.5 * slope.sin());
    let start = bar.assemble(State::<OnARail> { x, z, e0, e2, ..Default::default() }).solve()?;
    assert_eq!(OnARail::MODEL.state_speeds.len(), 1);
    let rates = bar.velocity_rates(0.0, &start, &[]);
    let along = f / m - g * slope.sin();
    close(rates.get("dot_x").expect("a speed"), along * slope.cos(), 1e-12);
    close(rates.get("dot_z").expect("a speed"), along * slope.sin(), 1e-12);
    // λ acts on the ground's point: what the rail carries.
    let held = bar.multipliers(0.0, &start, &[]);
    close(held.rail_y, 0.0, 1e-12);
    close(held.rail_z, -m * g * slope.cos(), 1e-12);
    // The push at (l/2) B.y turns about -z: the rail's moment on the bar is about z, that on the rail, R.x × B.y, about -z.
    close(held.rail_axes_xy, -l * f / 2.0, 1e-12);
    // Its force acts at the bar's centre and turns nothing.
    close(held.rail_axes_yz, 0.0, 1e-12);
    close(held.rail_axes_zx, 0.0, 1e-12);
    Ok(())
}

/// A seam carries force and moment, and the two turn as one.
#[test]
fn a_seam_holds_everything() -> Result<(), Error> {
    let (m, l, w, g) = (2.0, 0.8, 0.1, 9.81);
    let both = Seamed { m, l, w, g }.prepare()?;
    let guess = State::<Seamed> { x: l, e0: 1.0, dot_a: 2.0, ..Default::default() };
    let start = both.assemble(guess).solve()?;
    assert_eq!(Seamed::MODEL.state_speeds, ["dot_a"]);
    let held = both.multipliers(0.0, &start, &[]);
    // On the bar: towards the axis, and up.
    close(held.seam_x, -m * l * 4.0, 1e-12);
    close(held.seam_y, 0.0, 1e-12);
    close(held.seam_z, m * g, 1e-12);
    // On the bar, about z, x and y: the force up acts at its end, (-l/2) x × m g z = (l/2) m g y, which the moment undoes.
    close(held.seam_axes_xy, 0.0, 1e-12);
    close(held.seam_axes_yz, 0.0, 1e-12);
    close(held.seam_axes_zx, -m * g * l / 2.0, 1e-12);
    Ok(())
}

/// tan b = tan a/cos β of a cross between shafts that are bent by β.
#[test]
fn a_cross_between_shafts() -> Result<(), Error> {
    let bend = 0.5_f64;
    let shafts = Cardan { r: 0.1, bend }.prepare()?;
    let run =
        shafts.simulate(State::<Cardan> { dot_a: 2.0, ..Default::default() }).tolerance(1e-11, 1e-12).until(3.0)?;
    let energy = shafts.energy(0.0, &run.states()[0]);
    for (t, s) in run.iter() {
        close(s.b.sin() * s.a.cos() * bend.cos(), s.a.sin() * s.b.cos(), 1e-12);
        let v = shafts.velocities(t, s);
        let ratio = bend.cos() / (1.0 - (bend.sin() * s.a.cos()).powi(2));
        close(v.dot_b, s.dot_a * ratio, 1e-10);
        close(shafts.energy(t, s), energy, 1e-9);
    }
    Ok(())
}

/// On a turntable a solid ball goes round a circle with 2/7 of the table's rate (Ehrlich and Tuszynski, Am. J. Phys. 63, 1995).
#[test]
fn a_ball_on_a_turntable() -> Result<(), Error> {
    let (m, r, omega) = (1.0, 0.1, 2.0);
    let ball = Turntable { m, r, omega }.prepare()?;
    let start = State::<Turntable> { x: 0.3, e0: 1.0, dot_x: 0.2, dot_y: -0.1, omega_B_z: 0.7, ..Default::default() };
    let rate = 2.0 / 7.0 * omega;
    // v = rate z × (x - c)
    let (cx, cy) = (start.x - start.dot_y / rate, start.dot_x / rate);
    let run = ball.simulate(start).method(Method::Dop853).tolerance(1e-11, 1e-12).until(12.0)?;
    for (t, s) in run.iter() {
        let (sin, cos) = (rate * t).sin_cos();
        let (x, y) = (start.x - cx, -cy);
        close(s.x, cx + cos * x - sin * y, 1e-8);
        close(s.y, cy + sin * x + cos * y, 1e-8);
    }
    Ok(())
}

/// A four-bar in space keeps its energy and stays closed while its crank falls through.
#[test]
fn a_four_bar_in_space() -> Result<(), Error> {
    let (a, b, c, d) = (0.2, 0.9, 0.6, 0.7);
    let linkage = SpatialFourBar { a, b, c, d, w: 0.05, m: 1.0, g: 9.81 }.prepare()?;
    let guess = State::<SpatialFourBar> {
        crank: 0.4,
        rocker: 0.1,
        e0: 0.7,
        e2: -0.3,
        e3: 0.5,
        dot_crank: 12.0,
        omega_B_x: 1.0,
        ..Default::default()
    };
    let start = linkage.assemble(guess).hold("crank").solve()?;
    let energy = linkage.energy(0.0, &start);
    let run = linkage.simulate(start).method(Method::Dop853).tolerance(1e-10, 1e-12).until(2.0)?;
    assert!(run.largest_residuals().position < 1e-12);
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for (t, s) in run.iter() {
        close(linkage.energy(t, s), energy, 1e-7);
        // Both balls are b apart, whatever the rod's attitude is.
        let p = [a * s.crank.cos(), a * s.crank.sin(), 0.0];
        let q = [0.0, d - c * s.rocker.sin(), c * s.rocker.cos()];
        let square: f64 = p.iter().zip(&q).map(|(p, q)| (p - q) * (p - q)).sum();
        close(square, b * b, 1e-11);
        (least, most) = (least.min(s.crank), most.max(s.crank));
    }
    // The crank goes round.
    assert!(most - least > std::f64::consts::TAU, "from {least} to {most}");
    Ok(())
}
