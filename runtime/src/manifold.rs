//! The constraint manifold f(x, t) = 0: how large the terms of a residual are, and the way back onto it.

use alloc::vec;
use alloc::vec::Vec;

use crate::carriers::{Carriers, Frame};
use crate::scalar::Measured;
use crate::tangent::Tangent;
use crate::vector::convert;
use crate::{ConstrainedSystem, Dual, Error, Prepared, Vector};

/// A residual below this many units of rounding of its terms counts as zero.
pub(crate) const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// A residual that Newton's method no longer reduces is accepted below this fraction of its terms.
pub(crate) const STALLED: f64 = 1e-12;
/// Rows whose directions differ by less than this count as dependent.
pub(crate) const DEPENDENT: f64 = 3e-7;
/// In the size of a row's terms no entry counts with less than this fraction of the largest one …
const SMALLEST: f64 = 1e-4;
/// … and no less than this: where all are zero but for rounding, nothing tells how large they are meant to be.
const NOISE: f64 = 1e-6;
const ITERATIONS: usize = 10;

/// The same model over dual numbers, all derivatives zero.
pub(crate) fn lift<M: ConstrainedSystem>(model: &Prepared<M>) -> Result<Prepared<M, Dual>, Error> {
    let parameters = convert(model.parameters(), |_, value| Dual::constant(value));
    Prepared::with_parameters(model.system().clone(), parameters)
}

/// Which position or velocity rows a caller measures.
pub(crate) type Rows<'a, M, R> = &'a dyn Fn(
    &Prepared<M, Measured>,
    Measured,
    &<M as ConstrainedSystem>::Coordinates<Measured>,
    &<M as ConstrainedSystem>::Velocities<Measured>,
) -> R;

/// The smallest magnitude with which an entry of a vector counts in the size of terms.
///
/// Of a row like z = 0 the terms are the noise itself: what the noise is small against is how far the other entries reach.
pub(crate) fn floor<V: Vector<f64>>(v: &V) -> f64 {
    let array: V::Array = (*v).into();
    let reach = array.as_ref().iter().fold(0.0, |reach: f64, entry| reach.max(entry.abs()));
    if reach.is_finite() { NOISE.max(SMALLEST * reach) } else { NOISE }
}

/// The size of each row's terms, of which rounding errors of the row are a few ε.
///
/// It depends on units only where nearly everything is zero.
pub(crate) fn term_sizes<M: ConstrainedSystem, R: Vector<Measured>>(
    model: &Prepared<M>,
    t: f64,
    x: &M::Coordinates<f64>,
    v: &M::Velocities<f64>,
    rows: Rows<'_, M, R>,
) -> Result<Vec<f64>, Error> {
    let parameters = convert(model.parameters(), |_, value| Measured::given(value, 0.0));
    let measured = Prepared::with_parameters(model.system().clone(), parameters)?;
    let (least_x, least_v) = (floor(x), floor(v));
    let x = convert(x, |_, value| Measured::given(value, least_x));
    let v = convert(v, |_, value| Measured::given(value, least_v));
    let array: R::Array = rows(&measured, Measured::given(t, 0.0), &x, &v).into();
    let known = |size: f64| if size.is_finite() { size } else { 0.0 };
    Ok(array.as_ref().iter().map(|row| known(row.size)).collect())
}

/// A residual relative to the size of its terms. NaN counts as infinite.
pub(crate) fn ratio(residual: f64, size: f64) -> f64 {
    match residual.abs() {
        0.0 => 0.0,
        residual if residual.is_finite() && size > 0.0 => residual / size,
        _ => f64::INFINITY,
    }
}

/// f over the state's coordinates, with its derivatives and the sizes of its terms.
pub(crate) struct Manifold<M: ConstrainedSystem> {
    frame: Frame<M>,
    dual: Prepared<M, Dual>,
    /// The size of the terms of each row, the largest seen.
    pub(crate) sizes: Vec<f64>,
    /// ∂f/∂q by rows, q the coordinates of the state.
    pub(crate) jacobian: Vec<f64>,
    /// The number of coordinates of the state.
    pub(crate) columns: usize,
    /// The largest residual at the last point that was restored, relative to its terms.
    pub(crate) last: f64,
    /// Whether also residuals that count as zero are reduced: near a loss of rank they are a distance.
    pub(crate) thorough: bool,
    tangent: Tangent,
}

impl<M: ConstrainedSystem> Manifold<M> {
    pub(crate) fn new(model: &Prepared<M>, t: f64, s: &M::State<f64>) -> Result<Self, Error> {
        let (x, v) = (model.coordinates(t, s), M::Velocities::from_fn(|_| 0.0));
        let sizes = term_sizes(model, t, &x, &v, &|model, t, x, _| model.position_residual(t, x))?;
        let (rows, columns) = (sizes.len(), M::MODEL.state_coordinates.len());
        let frame = Frame::new(model, Carriers::General)?;
        Ok(Manifold {
            dual: lift(model)?,
            sizes,
            jacobian: vec![0.0; rows * columns],
            columns,
            last: 0.0,
            thorough: false,
            tangent: Tangent::new(frame.size.1, rows),
            frame,
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

    /// The largest residual relative to the size of its terms, and its row.
    pub(crate) fn worst(&self, f: &[f64]) -> (usize, f64) {
        let ratios = f.iter().zip(&self.sizes).map(|(residual, size)| ratio(*residual, *size)).enumerate();
        ratios.fold((0, 0.0), |worst, (i, ratio)| if ratio > worst.1 { (i, ratio) } else { worst })
    }

    /// Brings the coordinates of the state back onto f = 0 by Newton steps that are the least ones in the kinetic metric, and
    /// tells whether it moved them.
    pub(crate) fn restore(&mut self, model: &Prepared<M>, t: f64, s: &mut M::State<f64>) -> Result<bool, Error> {
        let mut before = f64::INFINITY;
        let mut moved = false;
        for _ in 0..ITERATIONS {
            let f = model.position_residual_at(t, s).into();
            self.last = self.worst(f.as_ref()).1;
            let enough = moved || !self.thorough;
            if self.last <= ROUNDING && enough {
                return Ok(moved);
            }
            self.differentiate(t, s);
            self.last = self.worst(f.as_ref()).1;
            if self.last <= ROUNDING && enough || (self.last <= STALLED && self.last > 0.5 * before) {
                return Ok(moved);
            }
            before = self.last;
            self.step(model, t, f.as_ref(), s);
            moved = true;
        }
        let f = model.position_residual_at(t, s).into();
        let row;
        (row, self.last) = self.worst(f.as_ref());
        if self.last <= STALLED {
            return Ok(moved);
        }
        Err(Error::Projection {
            constraint: M::MODEL.position_rows.get(row).copied().unwrap_or("position"),
            residual: f.as_ref().get(row).copied().unwrap_or(f64::NAN),
            time: t,
        })
    }

    /// Whether a row depends on the coordinates of the state at all, by the Jacobian: a configuration satisfies its rows.
    pub(crate) fn moves(&self, row: usize, s: &M::State<f64>) -> bool {
        self.slopes(row, s) > STALLED * self.sizes[row]
    }

    /// The first row whose slopes, times the coordinates of the state, are below a part of its terms: it does not tell where to go.
    pub(crate) fn level(&mut self, t: f64, s: &M::State<f64>, below: f64) -> Option<usize> {
        self.differentiate(t, s);
        (0..self.sizes.len()).find(|row| self.slopes(*row, s) < below * self.sizes[*row])
    }

    /// The size of a row's slopes times the coordinates of the state.
    fn slopes(&self, row: usize, s: &M::State<f64>) -> f64 {
        let array: <M::State<f64> as Vector<f64>>::Array = (*s).into();
        let least = floor(s);
        let slopes = self.jacobian[row * self.columns..(row + 1) * self.columns].iter().zip(array.as_ref());
        slopes.map(|(slope, q)| (slope * q.abs().max(least)).abs()).sum()
    }

    /// Whether the coordinates of the state satisfy f = 0 by construction.
    pub(crate) fn is_satisfied(&mut self, t: f64, s: &M::State<f64>) -> bool {
        self.differentiate(t, s);
        (0..self.sizes.len()).all(|row| !self.moves(row, s))
    }

    /// ∂f/∂q K of one row: its derivative along the carriers.
    pub(crate) fn gradient(&mut self, t: f64, s: &M::State<f64>, row: usize) -> Vec<f64> {
        self.differentiate(t, s);
        self.frame.kinematics(t, s);
        let (c, n) = (self.frame.size.1, self.columns);
        let slopes = &self.jacobian[row * n..(row + 1) * n];
        (0..c).map(|j| slopes.iter().enumerate().map(|(l, slope)| slope * self.frame.rates[l * c + j]).sum()).collect()
    }

    /// The step δq = K δw with ∂f/∂q K δw = −f and δwᵀ Bᵀ M B δw least, for q̇ = K w + … and v = B w + ….
    fn step(&mut self, model: &Prepared<M>, t: f64, f: &[f64], s: &mut M::State<f64>) {
        let (c, n) = (self.frame.size.1, self.columns);
        self.frame.turn(t, s, |_| 0.0);
        self.frame.kinematics(t, s);
        self.frame.pull_inertia(&model.inertia(t, &model.coordinates(t, s)), &mut self.tangent.mass);
        for i in 0..f.len() {
            let live = self.moves(i, s);
            let row = &self.jacobian[i * n..(i + 1) * n];
            for j in 0..c {
                let slopes = row.iter().enumerate().map(|(l, slope)| slope * self.frame.rates[l * c + j]);
                self.tangent.rows[i * c + j] = if live { slopes.sum() } else { 0.0 };
            }
        }
        let change = self.tangent.nearest(f, DEPENDENT);
        let mut array: <M::State<f64> as Vector<f64>>::Array = (*s).into();
        for (l, q) in array.as_mut().iter_mut().take(n).enumerate() {
            *q += (0..c).map(|j| self.frame.rates[l * c + j] * change[j]).sum::<f64>();
        }
        *s = array.into();
    }
}

#[cfg(test)]
mod tests;
