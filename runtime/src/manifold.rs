//! The constraint manifold f(x, t) = 0: how large the terms of a residual are, and the way back onto it.

use alloc::vec;
use alloc::vec::Vec;

use crate::math::double::sqrt;
use crate::vector::convert;
use crate::{ConstrainedSystem, Dual, Error, Prepared, Scalar, Vector};

/// A residual below this many units of rounding of its terms counts as zero.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// A residual that Newton's method no longer reduces is accepted below this fraction of its terms.
const STALLED: f64 = 1e-12;
/// Rows whose directions differ by less than the root of this count as dependent.
const DEPENDENT: f64 = 1e-13;
const ITERATIONS: usize = 10;

/// The same model over dual numbers, all derivatives zero.
pub(crate) fn lift<M: ConstrainedSystem>(model: &Prepared<M>) -> Result<Prepared<M, Dual>, Error> {
    let parameters = convert(model.parameters(), |_, value| Dual::constant(value));
    Prepared::with_parameters(model.system().clone(), parameters)
}

/// Which position or velocity rows a caller measures, over dual numbers.
pub(crate) type Rows<'a, M, R> = &'a dyn Fn(
    &Prepared<M, Dual>,
    Dual,
    &<M as ConstrainedSystem>::Coordinates<Dual>,
    &<M as ConstrainedSystem>::Velocities<Dual>,
) -> R;

/// The size of each row's terms: Σ |∂row/∂y| |y| over time, coordinates, velocities and parameters.
///
/// It does not depend on units, and rounding errors of the row are a few ε of it.
pub(crate) fn term_sizes<M: ConstrainedSystem, R: Vector<Dual>>(
    model: &Prepared<M>,
    t: f64,
    x: &M::Coordinates<f64>,
    v: &M::Velocities<f64>,
    rows: Rows<'_, M, R>,
) -> Result<Vec<f64>, Error> {
    let dual = lift(model)?;
    let seeded =
        |at: Option<usize>| move |i: usize, value: f64| Dual::new(value, if at == Some(i) { value } else { 0.0 });
    let plain_x: M::Coordinates<Dual> = convert(x, seeded(None));
    let plain_v: M::Velocities<Dual> = convert(v, seeded(None));
    let mut sizes = Vec::new();
    let mut collect = |row: R| {
        let array: R::Array = row.into();
        sizes.resize(array.as_ref().len(), 0.0);
        for (size, entry) in sizes.iter_mut().zip(array.as_ref()) {
            if entry.derivative.is_finite() {
                *size += entry.derivative.abs();
            }
        }
    };
    collect(rows(&dual, Dual::new(t, t), &plain_x, &plain_v));
    for j in 0..length(x) {
        collect(rows(&dual, Dual::constant(t), &convert(x, seeded(Some(j))), &plain_v));
    }
    for j in 0..length(v) {
        collect(rows(&dual, Dual::constant(t), &plain_x, &convert(v, seeded(Some(j)))));
    }
    for j in 0..length(model.parameters()) {
        let parameters = convert(model.parameters(), seeded(Some(j)));
        let dual = Prepared::with_parameters(model.system().clone(), parameters)?;
        collect(rows(&dual, Dual::constant(t), &plain_x, &plain_v));
    }
    Ok(sizes)
}

/// The number of entries of a vector.
pub(crate) fn length<T: Scalar, V: Vector<T>>(v: &V) -> usize {
    let array: V::Array = (*v).into();
    array.as_ref().len()
}

/// f over the state's coordinates, with its derivatives and the sizes of its terms.
pub(crate) struct Manifold<M: ConstrainedSystem> {
    dual: Prepared<M, Dual>,
    /// The size of the terms of each row, the largest seen.
    pub(crate) sizes: Vec<f64>,
    /// ∂f/∂q by rows, q the coordinates of the state.
    pub(crate) jacobian: Vec<f64>,
    /// The number of coordinates of the state.
    pub(crate) columns: usize,
    gram: Vec<f64>,
    weights: Vec<f64>,
}

impl<M: ConstrainedSystem> Manifold<M> {
    pub(crate) fn new(model: &Prepared<M>, t: f64, s: &M::State<f64>) -> Result<Self, Error> {
        let (x, v) = (model.coordinates(t, s), model.velocities(t, s));
        let sizes = term_sizes(model, t, &x, &v, &|model, t, x, _| model.position_residual(t, x))?;
        let (rows, columns) = (sizes.len(), M::MODEL.state_coordinates.len());
        Ok(Manifold {
            dual: lift(model)?,
            sizes,
            jacobian: vec![0.0; rows * columns],
            columns,
            gram: vec![0.0; rows * rows],
            weights: vec![0.0; rows],
        })
    }

    /// Fills the Jacobian at a state, one dual evaluation a column, and lets the sizes of the terms grow.
    pub(crate) fn differentiate(&mut self, t: f64, s: &M::State<f64>) {
        for j in 0..self.columns {
            let seeded = convert(s, |i, value| Dual::new(value, if i == j { 1.0 } else { 0.0 }));
            let f = self.dual.position_residual_at(Dual::constant(t), &seeded).into();
            for (i, entry) in f.as_ref().iter().enumerate() {
                self.jacobian[i * self.columns + j] = entry.derivative;
            }
        }
        let array: <M::State<f64> as Vector<f64>>::Array = (*s).into();
        let q = array.as_ref();
        for (size, row) in self.sizes.iter_mut().zip(self.jacobian.chunks(self.columns.max(1))) {
            let sum: f64 = row.iter().zip(q).map(|(slope, q)| (slope * q).abs()).sum();
            if sum > *size && sum.is_finite() {
                *size = sum;
            }
        }
    }

    /// The largest residual relative to the size of its terms, and its row. NaN counts as infinite.
    pub(crate) fn worst(&self, f: &[f64]) -> (usize, f64) {
        let mut worst = (0, 0.0);
        for (i, (residual, size)) in f.iter().zip(&self.sizes).enumerate() {
            let ratio = match residual.abs() {
                0.0 => 0.0,
                residual if residual.is_finite() && *size > 0.0 => residual / size,
                _ => f64::INFINITY,
            };
            if ratio > worst.1 {
                worst = (i, ratio);
            }
        }
        worst
    }

    /// Brings the coordinates of the state back onto f = 0 by Newton steps of least norm, and tells whether it moved them.
    pub(crate) fn restore(&mut self, model: &Prepared<M>, t: f64, s: &mut M::State<f64>) -> Result<bool, Error> {
        let mut last = f64::INFINITY;
        let mut moved = false;
        for _ in 0..ITERATIONS {
            let f = model.position_residual_at(t, s).into();
            if self.worst(f.as_ref()).1 <= ROUNDING {
                return Ok(moved);
            }
            self.differentiate(t, s);
            let (_, ratio) = self.worst(f.as_ref());
            if ratio <= ROUNDING || (ratio <= STALLED && ratio > 0.5 * last) {
                return Ok(moved);
            }
            last = ratio;
            self.step(f.as_ref(), s);
            moved = true;
        }
        let f = model.position_residual_at(t, s).into();
        let (row, ratio) = self.worst(f.as_ref());
        if ratio <= STALLED {
            return Ok(moved);
        }
        Err(Error::Projection {
            constraint: M::MODEL.position_rows.get(row).copied().unwrap_or("position"),
            residual: f.as_ref().get(row).copied().unwrap_or(f64::NAN),
            time: t,
        })
    }

    /// One step of least norm: δ = −Jᵀ (J Jᵀ)⁻¹ f. Dependent rows are left out; where they agree they are met all the same.
    fn step(&mut self, f: &[f64], s: &mut M::State<f64>) {
        let (m, n) = (f.len(), self.columns);
        for (i, residual) in f.iter().enumerate() {
            let row = &mut self.jacobian[i * n..(i + 1) * n];
            let norm = sqrt(row.iter().map(|slope| slope * slope).sum());
            let scale = if norm > 0.0 && norm.is_finite() { 1.0 / norm } else { 0.0 };
            row.iter_mut().for_each(|slope| *slope *= scale);
            self.weights[i] = -residual * scale;
        }
        for i in 0..m {
            for j in 0..=i {
                let (a, b) = (&self.jacobian[i * n..(i + 1) * n], &self.jacobian[j * n..(j + 1) * n]);
                self.gram[i * m + j] = a.iter().zip(b).map(|(a, b)| a * b).sum();
            }
        }
        solve_gram(&mut self.gram, &mut self.weights, m);
        let mut array: <M::State<f64> as Vector<f64>>::Array = (*s).into();
        for (j, q) in array.as_mut().iter_mut().take(n).enumerate() {
            let delta: f64 = (0..m).map(|i| self.jacobian[i * n + j] * self.weights[i]).sum();
            *q += delta;
        }
        *s = array.into();
    }
}

/// Solves G w = b in place for a positive semidefinite G with unit diagonal, by Cholesky on its lower half.
///
/// Where a pivot vanishes the row depends on earlier ones, and its weight is zero.
fn solve_gram(g: &mut [f64], b: &mut [f64], m: usize) {
    for j in 0..m {
        let mut pivot = g[j * m + j];
        for k in 0..j {
            pivot -= g[j * m + k] * g[j * m + k];
        }
        let inverse = if pivot > DEPENDENT { 1.0 / sqrt(pivot) } else { 0.0 };
        for i in j + 1..m {
            let mut entry = g[i * m + j];
            for k in 0..j {
                entry -= g[i * m + k] * g[j * m + k];
            }
            g[i * m + j] = entry * inverse;
        }
        g[j * m + j] = inverse;
    }
    for i in 0..m {
        let sum: f64 = (0..i).map(|k| g[i * m + k] * b[k]).sum();
        b[i] = (b[i] - sum) * g[i * m + i];
    }
    for i in (0..m).rev() {
        let sum: f64 = (i + 1..m).map(|k| g[k * m + i] * b[k]).sum();
        b[i] = (b[i] - sum) * g[i * m + i];
    }
}

#[cfg(test)]
mod tests;
