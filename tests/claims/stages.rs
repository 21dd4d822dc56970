//! The same motion as two derivations claim it.

use nalgebra::DMatrix;
use oracle::{Claim, conditioned_rank};

/// What two derivations of one motion may differ by, before rounding is amplified.
const TOLERANCE: f64 = 1e-12;

/// How much elimination amplifies rounding: by the steepness and the condition of D, and by the condition of C, once for v and once
/// more for v̇ and λ.
fn amplification(claim: &Claim) -> f64 {
    let of_rows = |m: &DMatrix<f64>| {
        let norms: Vec<f64> = m.row_iter().map(|row| row.norm().max(f64::MIN_POSITIVE)).collect();
        conditioned_rank(&DMatrix::from_fn(m.nrows(), m.ncols(), |i, j| m[(i, j)] / norms[i])).1
    };
    let steepness = claim.complement.amax().max(1.0);
    (steepness * of_rows(&claim.complement) * of_rows(&claim.constraint_matrix)).powi(2)
}

/// The largest relative difference of v̇ and of every λ by its name.
///
/// # Errors
/// Which quantity differs by more than rounding.
pub fn difference(one: &Claim, other: &Claim) -> Result<f64, String> {
    let tolerance = TOLERANCE * amplification(one).max(amplification(other));
    let mut worst = 0.0_f64;
    let mut close = |what: &str, a: f64, b: f64, scale: f64| {
        let error = (a - b).abs() / scale;
        worst = worst.max(error);
        if error <= tolerance { Ok(()) } else { Err(format!("{what}: {a:e} and {b:e}, {error:e} of {scale:e}")) }
    };
    let (rates, others) = (one.acceleration(), other.acceleration());
    let scale = rates.amax().max(1.0);
    for (i, (a, b)) in rates.iter().zip(others.iter()).enumerate() {
        close(&format!("v̇[{i}]"), *a, *b, scale)?;
    }
    let scale = one.multipliers.iter().fold(scale, |scale, m| scale.max(m.value.abs()));
    for multiplier in &one.multipliers {
        let name = &multiplier.name;
        let same =
            other.multipliers.iter().find(|m| m.name == *name).ok_or_else(|| format!("λ of {name} is missing"))?;
        close(&format!("λ of {name}"), multiplier.value, same.value, scale)?;
    }
    Ok(worst)
}
