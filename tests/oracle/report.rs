//! Comparisons with their bounds, collected.

use super::kkt::UNIT;
use super::number::Scaled;
use nalgebra::{DMatrix, DVector};

/// Which comparisons failed, and how near the others came to their bounds.
#[derive(Debug, Default)]
pub struct Report {
    /// One line per failed comparison.
    pub failures: Vec<String>,
    /// How many numbers were compared.
    pub compared: usize,
    /// The largest quotient of error and bound.
    pub worst: f64,
    /// What that was found in.
    pub worst_in: String,
}

impl Report {
    /// A number against what it should be.
    pub fn number(&mut self, what: &str, claimed: f64, expected: f64, bound: f64) {
        let error = (claimed - expected).abs();
        self.compared += 1;
        if error <= bound {
            let part = if bound > 0.0 { error / bound } else { 0.0 };
            if part > self.worst {
                (self.worst, self.worst_in) = (part, what.to_string());
            }
        } else {
            let line = format!("{what}: claimed {claimed:e}, expected {expected:e}, off by {error:e}, bound {bound:e}");
            self.failures.push(line);
        }
    }

    /// What another comparison has found, added to this.
    pub fn add(&mut self, other: Self) {
        self.failures.extend(other.failures);
        self.compared += other.compared;
        if other.worst > self.worst {
            (self.worst, self.worst_in) = (other.worst, other.worst_in);
        }
    }

    /// Something that is so or not.
    pub fn fact(&mut self, what: &str, holds: bool) {
        if !holds {
            self.failures.push(what.to_string());
        }
    }

    /// A vector with one bound per entry.
    pub fn bounded(&mut self, what: &str, claimed: &[f64], expected: &DVector<f64>, bound: &DVector<f64>) {
        self.fact(
            &format!("{what}: {} entries instead of {}", claimed.len(), expected.len()),
            claimed.len() == expected.len(),
        );
        for (i, (claimed, expected)) in claimed.iter().zip(expected.iter()).enumerate() {
            self.number(&format!("{what}[{i}]"), *claimed, *expected, bound[i]);
        }
    }

    /// An evaluated vector: the bound follows the largest size in it.
    pub fn vector(&mut self, what: &str, claimed: &[f64], expected: &DVector<Scaled>) {
        let size = expected.iter().fold(0.0_f64, |size, e| size.max(e.size));
        let bound = DVector::from_element(expected.len(), UNIT * size);
        self.bounded(what, claimed, &expected.map(|e| e.value), &bound);
    }

    /// An evaluated matrix, row by row.
    pub fn matrix(&mut self, what: &str, claimed: &DMatrix<f64>, expected: &DMatrix<Scaled>) {
        let shapes = format!("{what}: {:?} instead of {:?}", claimed.shape(), expected.shape());
        self.fact(&shapes, claimed.shape() == expected.shape());
        if claimed.shape() != expected.shape() {
            return;
        }
        for i in 0..claimed.nrows() {
            let row: Vec<f64> = claimed.row(i).iter().copied().collect();
            self.vector(&format!("{what} row {i}"), &row, &expected.row(i).transpose());
        }
    }

    /// Panics with every failure of the comparison.
    ///
    /// # Panics
    /// If there is one.
    pub fn assert(&self, place: &str) {
        assert!(self.failures.is_empty(), "{place}\n  {}", self.failures.join("\n  "));
    }
}
