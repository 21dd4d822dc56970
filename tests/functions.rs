//! Every function of the language and `if`, in places where their derivatives count, against the oracle.
#![allow(clippy::duplicated_attributes, reason = "clippy takes the masses of `diag(m, m)` for attributes")]

mod claims;
mod support;

use claims::compiled::{claim, other_claim};
use claims::states::random_state;
use holonomy::ConstrainedSystem;
use oracle::{System, check, read_models};
use support::splitmix::SplitMix;

/// Two particles on a curve in space that all functions shape, with springs that slacken and friction that changes sides.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z)]
#[inertia(diag(m + m*powi(tanh(x), 2), m*(1 + max(x, y)/8), m*cosh(z/2)))]
#[forces(
    if x < y { -k*(x - y) } else if z >= 1/2 { k*z } else { 0 } - k*sign(dot(x))*abs(dot(x)),
    -k*sinh(y/2) - m*min(dot(y), powf(abs(dot(z)) + 1, 1.3)),
    k*asin(x/4)*acos(y/4) - powf(k, x/3) - atan(z),
)]
#[potential_energy(k*abs(x - y) + if z > 1 { z } else { powi(z, 2) })]
#[constraint(curve: z + asin(x/5) - tanh(y/3) - powf(x + 3, 1.7)/20 - atan(x*y)/8 + acos(y/6)/9 == 0)]
#[constraint(gear: dot(y) == (if x < 0.7 { powi(x, 2) } else { 1.4*x - 0.49 } + sinh(x)/9)*dot(x)/3)]
#[independent(dot(x))]
#[define(pace = sqrt(powi(dot(x), 2) + powi(dot(y), 2)))]
#[output(
    pace,
    bend = atan2(dot(y), 2 + abs(x)) - asin(tanh(z)/2),
    grip = if ddot(x) < 0 { tanh(reaction(gear)) } else { -k*reaction(gear) },
    share = exp(-abs(reaction(curve))/9)*max(pace, bend) + powf(1 + powi(ddot(z), 2), 0.3),
)]
pub struct AllFunctions {
    /// The mass.
    #[nominal(1.5)]
    pub m: f64,
    /// The stiffness.
    #[nominal(0.8)]
    pub k: f64,
}

#[test]
fn every_function_agrees_with_the_oracle() {
    let random = &mut SplitMix::new(12);
    let declared = read_models(include_str!("functions.rs"));
    for _ in 0..40 {
        let (m, k) = (random.between(1.0, 2.0), random.between(0.5, 1.2));
        let system = System { model: &declared[0], parameters: vec![m, k], inputs: Vec::new() };
        let model = AllFunctions { m, k }.prepare().expect("the parameters are good");
        let (t, q, u) = random_state(&model, &system, random, [0.2, 1.2]).expect("the curve is reached");
        for claim in [claim(&model, t, &q, &u, &[]), other_claim(&model, t, &q, &u, &[])] {
            let report = check(&system, &claim);
            report.assert(&format!("q = {q:?}, u = {u:?}, m = {m}, k = {k}"));
            // and an output that is off by little is seen
            for wrong in 0..claim.outputs.len() {
                let mut other = claim.clone();
                other.outputs[wrong].1 += 1e-6 * other.outputs[wrong].1.abs().max(1.0);
                let seen = check(&system, &other).failures;
                assert!(seen.len() == 1 && seen[0].contains(&claim.outputs[wrong].0), "{seen:?}");
            }
        }
    }
}
