//! Random systems (2.3) with rows (2.4), the same on every machine.

#![allow(dead_code, missing_docs)]

use holonomy::forms::InitialEquations;
use nalgebra::{DMatrix, DVector};

/// splitmix64.
pub struct Random(u64);

pub const NAMES: [&str; 14] = ["a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m", "n"];

impl Random {
    pub fn new(seed: u64) -> Self {
        Random(seed)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number in [−1, 1).
    pub fn number(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// One of low..=high.
    pub fn between(&mut self, low: usize, high: usize) -> usize {
        low + (self.bits() % (high - low + 1) as u64) as usize
    }

    pub fn vector(&mut self, n: usize) -> DVector<f64> {
        DVector::from_fn(n, |_, _| self.number())
    }

    pub fn matrix(&mut self, rows: usize, columns: usize) -> DMatrix<f64> {
        DMatrix::from_fn(rows, columns, |_, _| self.number())
    }

    /// B Bᵀ + 1/2: positive definite and well conditioned.
    pub fn inertia(&mut self, n: usize) -> DMatrix<f64> {
        let b = self.matrix(n, n);
        &b * b.transpose() + DMatrix::identity(n, n) * 0.5
    }

    /// Rows with singular values that are all at least a tenth of the largest, so that errors are a few units of rounding.
    pub fn rows(&mut self, m: usize, n: usize) -> DMatrix<f64> {
        loop {
            let c = self.matrix(m, n);
            if c.is_empty() {
                return c;
            }
            let values = c.clone().svd(false, false).singular_values;
            if values.min() > 0.1 * values.max() {
                return c;
            }
        }
    }

    /// A system with n velocities and m independent rows.
    pub fn system(&mut self, n: usize, m: usize) -> InitialEquations {
        InitialEquations {
            rows: NAMES[..m].to_vec(),
            velocities: self.vector(n),
            kinematic_matrix: self.matrix(n, n),
            kinematic_bias: self.vector(n),
            inertia: self.inertia(n),
            forces: self.vector(n),
            constraint_matrix: self.rows(m, n),
            constraint_bias: self.vector(m),
        }
    }
}

/// The largest difference relative to the largest entry of what is expected, or to one.
pub fn distance(found: &DVector<f64>, expected: &DVector<f64>) -> f64 {
    assert_eq!(found.len(), expected.len());
    if found.is_empty() {
        return 0.0;
    }
    let difference = (found - expected).amax();
    assert!(difference.is_finite());
    difference / expected.amax().max(1.0)
}
