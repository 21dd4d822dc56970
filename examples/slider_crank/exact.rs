//! What is known of the slider-crank without differential equations: its angles and its stroke in closed form, and with them the
//! energy as J(α) α̇²/2 + V(α), which gives the period of a full turn as an integral.

use crate::models::SliderCrank;
use std::f64::consts::TAU;

/// The period's integral by the trapezoidal rule, which for a smooth periodic function converges faster than any power.
const POINTS: u32 = 4096;

/// β by r sin α = l sin β, and its derivative by α.
pub fn rod(crank: &SliderCrank, alpha: f64) -> (f64, f64) {
    let beta = (crank.r / crank.l * alpha.sin()).asin();
    (beta, crank.r * alpha.cos() / (crank.l * beta.cos()))
}

/// x = r cos α + √(l² - r² sin² α), and its first two derivatives by α.
pub fn stroke(crank: &SliderCrank, alpha: f64) -> [f64; 3] {
    let SliderCrank { r, l, .. } = crank;
    let (sin, cos) = alpha.sin_cos();
    let along = (l * l - r * r * sin * sin).sqrt();
    let bend = (cos * cos - sin * sin) / along + (r * sin * cos).powi(2) / along.powi(3);
    [r * cos + along, -r * sin - r * r * sin * cos / along, -r * cos - r * r * bend]
}

/// The inertia J that the crank feels, and the height energy V.
fn reduced(crank: &SliderCrank, alpha: f64) -> (f64, f64) {
    let SliderCrank { r, l, m1, m2, m3, g } = crank;
    let ((beta, slope), [_, stroke, _]) = (rod(crank, alpha), stroke(crank, alpha));
    let middle = r * r + l * l / 4.0 * slope * slope - r * l * slope * (alpha + beta).cos();
    let inertia = m1 * r * r / 3.0 + m2 * (middle + l * l / 12.0 * slope * slope) + m3 * stroke * stroke;
    (inertia, g * (m1 + m2) * r / 2.0 * alpha.sin())
}

/// The time of a full turn that starts at α = 0 with this speed: ∮ √(J/(2 (E - V))) dα.
pub fn period(crank: &SliderCrank, speed: f64) -> f64 {
    let (inertia, height) = reduced(crank, 0.0);
    let energy = 0.5 * inertia * speed * speed + height;
    let angles = (0..POINTS).map(|i| TAU * f64::from(i) / f64::from(POINTS));
    let slowness = angles.map(|alpha| {
        let (inertia, height) = reduced(crank, alpha);
        (inertia / (2.0 * (energy - height))).sqrt()
    });
    slowness.sum::<f64>() * TAU / f64::from(POINTS)
}

/// The moment about the crank's bearing of a torque on the crank, of the weights and of the guide's force.
pub fn moment(crank: &SliderCrank, torque: f64, [alpha, beta, x]: [f64; 3], guide: f64) -> f64 {
    let SliderCrank { r, l, m1, m2, m3, g } = crank;
    let weights = m1 * r / 2.0 * alpha.cos() + m2 * (r * alpha.cos() + l / 2.0 * beta.cos()) + m3 * x;
    torque + guide * x - g * weights
}
