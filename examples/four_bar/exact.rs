//! What is known of the four-bar without differential equations: Freudenstein's closed form of its angles, and with it the energy as
//! J(crank) ω²/2 + V(crank), which gives the period of a full turn as an integral.

use crate::models::FourBar;
use std::f64::consts::TAU;

/// The period's integral by the trapezoidal rule, which for a smooth periodic function converges faster than any power.
const POINTS: u32 = 4096;

/// Angles of coupler and rocker with the rocker above the coupler's line: b² = |d + c e^{iφ} - a e^{iθ}|², a linear equation in the
/// cosine and sine of the rocker's angle φ (Freudenstein 1954).
pub fn angles(bar: &FourBar, crank: f64) -> (f64, f64) {
    let FourBar { a, b, c, d, .. } = bar;
    let (sin, cos) = crank.sin_cos();
    let (along, across) = (2.0 * c * (d - a * cos), -2.0 * c * a * sin);
    let rest = b * b - a * a - c * c - d * d + 2.0 * a * d * cos;
    let rocker = across.atan2(along) + (rest / along.hypot(across)).acos();
    let coupler = (c * rocker.sin() - a * sin).atan2(d + c * rocker.cos() - a * cos);
    (coupler, rocker)
}

/// Rates of coupler and rocker in units of the crank's: a e^{iθ} + b β' e^{iβ} = c φ' e^{iφ} along the normals of the two.
pub fn ratios(bar: &FourBar, crank: f64) -> (f64, f64) {
    let (coupler, rocker) = angles(bar, crank);
    let transmission = (rocker - coupler).sin();
    (bar.a * (crank - rocker).sin() / (bar.b * transmission), bar.a * (crank - coupler).sin() / (bar.c * transmission))
}

/// The inertia J that the crank feels, and the height energy V, with a load on the pin of coupler and rocker.
fn reduced(bar: &FourBar, load: f64, crank: f64) -> (f64, f64) {
    let FourBar { a, b, c, m1, m2, m3, g, .. } = bar;
    let ((coupler, rocker), (beta, phi)) = (angles(bar, crank), ratios(bar, crank));
    let middle = a * a + b * b / 4.0 * beta * beta + a * b * beta * (crank - coupler).cos();
    let inertia = m1 * a * a / 3.0 + m2 * (middle + b * b / 12.0 * beta * beta) + (m3 / 3.0 + load) * c * c * phi * phi;
    let height = m1 * a / 2.0 * crank.sin() + m2 * (a * crank.sin() + b / 2.0 * coupler.sin());
    (inertia, g * (height + (m3 / 2.0 + load) * c * rocker.sin()))
}

/// The time of a full turn that starts at crank = 0 with this speed: ∮ √(J/(2 (E - V))) dθ.
pub fn period(bar: &FourBar, load: f64, speed: f64) -> f64 {
    let (inertia, height) = reduced(bar, load, 0.0);
    let energy = 0.5 * inertia * speed * speed + height;
    let angles = (0..POINTS).map(|i| TAU * f64::from(i) / f64::from(POINTS));
    let slowness = angles.map(|angle| {
        let (inertia, height) = reduced(bar, load, angle);
        (inertia / (2.0 * (energy - height))).sqrt()
    });
    slowness.sum::<f64>() * TAU / f64::from(POINTS)
}
