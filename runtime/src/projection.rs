//! The way back onto the constraints for coordinates and velocities that have drifted, or that were measured.

use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector};

use crate::forms::{dynamic_matrix, least_change};
use crate::manifold::{lift, term_sizes};
use crate::vector::convert;
use crate::{ConstrainedSystem, Dual, Error, Level, Matrix, Prepared, Vector};

/// A residual below this many units of rounding of its terms counts as zero.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// A residual that Newton's method no longer reduces is accepted below this fraction of its terms.
const STALLED: f64 = 1e-12;
const ITERATIONS: usize = 30;

/// What a projection onto the constraints gives, and what it did.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct Projected<V, R> {
    /// The coordinates or velocities on the constraints.
    pub value: V,
    /// The residuals of what was given.
    pub before: R,
    /// The residuals that remain.
    pub after: R,
}

/// What [`Prepared::project_positions`] gives.
pub type ProjectedPositions<M> =
    Projected<<M as ConstrainedSystem>::Coordinates<f64>, <M as ConstrainedSystem>::PositionRows<f64>>;

/// What [`Prepared::project_velocities`] gives.
pub type ProjectedVelocities<M> =
    Projected<<M as ConstrainedSystem>::Velocities<f64>, <M as ConstrainedSystem>::VelocityRows<f64>>;

impl<M: ConstrainedSystem> Prepared<M> {
    /// Coordinates x brought onto f(x, t) = 0 by Newton's method. Each step is the change that a motion of the least kinetic
    /// energy makes: δx = A δw with f_x A δw = −f and δwᵀ M δw least.
    ///
    /// Where some coordinates have no inertia of their own, the change keeps to the velocity constraints as well.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::Pendulum;
    /// use holonomy::prelude::*;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let back = pendulum.project_positions(0.0, &[0.33, -0.44])?;
    /// assert!((back.value[0] - 0.3).abs() < 1e-15 && (back.value[1] + 0.4).abs() < 1e-15);
    /// assert!((back.before[0] - 0.02625).abs() < 1e-15 && back.after[0].abs() < 1e-16);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn project_positions(&self, t: f64, x: &M::Coordinates<f64>) -> Result<ProjectedPositions<M>, Error> {
        check(t, x, M::MODEL.coordinates)?;
        let dual = lift(self)?;
        let still = M::Velocities::from_fn(|_| 0.0);
        let before = self.position_residual(t, x);
        let mut approach = Approach { last: f64::INFINITY, time: t, names: M::MODEL.position_rows.to_vec() };
        let mut x = *x;
        for _ in 0..ITERATIONS {
            let f = self.position_residual(t, &x);
            let sizes = term_sizes(self, t, &x, &still, &|model, t, x, _| model.position_residual(t, x))?;
            if approach.arrived(&entries(&f), &sizes)? {
                return Ok(Projected { value: x, before, after: f });
            }
            let a = dynamic_matrix(&self.kinematic_matrix(t, &x));
            let along = |j: usize| {
                let moving: M::Coordinates<Dual> = convert(&x, |i, value| Dual::new(value, a[(i, j)]));
                entries(&dual.position_residual(Dual::constant(t), &moving))
            };
            let columns: Vec<Vec<Dual>> = (0..a.ncols()).map(along).collect();
            let f = DVector::from_vec(entries(&f));
            let rows = DMatrix::from_fn(f.len(), a.ncols(), |i, j| columns[j][i].derivative);
            let inertia = dynamic_matrix(&self.inertia(t, &x));
            let change = match least_change(&inertia, &rows, &f) {
                Err(Error::Indefinite { .. }) => {
                    let (more, count) = (self.velocity_rows(t, &x, &still), rows.nrows());
                    let mut all = rows.resize_vertically(count + more.nrows(), 0.0);
                    all.rows_mut(count, more.nrows()).copy_from(&more);
                    least_change(&inertia, &all, &f.resize_vertically(count + more.nrows(), 0.0))?
                }
                other => other?,
            };
            let change = a * change;
            x = M::Coordinates::from_fn(|i| entries(&x)[i] + change[i]);
        }
        Err(approach.lost(&entries(&self.position_residual(t, &x))))
    }

    /// Velocities v brought onto the velocity constraints at x, φ(v, x, t) = 0 and ḟ = 0, by the change of the least kinetic
    /// energy: C δv = −φ and δvᵀ M δv least. It is what an impact on all constraints at once would do.
    ///
    /// One step is exact where the constraints are linear in v; otherwise Newton's method repeats it. Rows that bind
    /// accelerations alone take no part.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumVelocities};
    /// use holonomy::prelude::*;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// // Along the rod by (0.03, −0.04): that part goes, the rest stays.
    /// let back = pendulum.project_velocities(0.0, &[0.3, -0.4], &PendulumVelocities { dot_x: 0.83, dot_y: 0.56 })?;
    /// assert!((back.value.dot_x - 0.8).abs() < 1e-15 && (back.value.dot_y - 0.6).abs() < 1e-15);
    /// assert!((back.before[0] - 0.025).abs() < 1e-15 && back.after[0].abs() < 1e-15);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn project_velocities(
        &self,
        t: f64,
        x: &M::Coordinates<f64>,
        v: &M::Velocities<f64>,
    ) -> Result<ProjectedVelocities<M>, Error> {
        check(t, x, M::MODEL.coordinates)?;
        check(t, v, M::MODEL.velocities)?;
        let names = M::MODEL.velocity_rows().map(|row| row.name).collect();
        let inertia = dynamic_matrix(&self.inertia(t, x));
        let before = self.velocity_residual(t, x, v);
        let mut approach = Approach { last: f64::INFINITY, time: t, names };
        let mut v = *v;
        for _ in 0..ITERATIONS {
            let phi = self.velocity_residual(t, x, &v);
            let sizes = term_sizes(self, t, x, &v, &|model, t, x, v| model.velocity_residual(t, x, v))?;
            if approach.arrived(&entries(&phi), &sizes)? {
                return Ok(Projected { value: v, before, after: phi });
            }
            let change = least_change(&inertia, &self.velocity_rows(t, x, &v), &DVector::from_vec(entries(&phi)))?;
            v = M::Velocities::from_fn(|i| entries(&v)[i] + change[i]);
        }
        Err(approach.lost(&entries(&self.velocity_residual(t, x, &v))))
    }

    /// The rows of C that bind velocities.
    fn velocity_rows(&self, t: f64, x: &M::Coordinates<f64>, v: &M::Velocities<f64>) -> DMatrix<f64> {
        let c = self.constraint_matrix(t, x, v);
        let rows = M::MODEL.rows.iter().enumerate().filter(|(_, row)| row.level != Level::Acceleration);
        let rows: Vec<usize> = rows.map(|(at, _)| at).collect();
        DMatrix::from_fn(rows.len(), M::MODEL.velocities.len(), |i, j| c.entry(rows[i], j))
    }
}

/// Newton's method on its way.
struct Approach {
    last: f64,
    time: f64,
    names: Vec<&'static str>,
}

impl Approach {
    /// Whether the residuals are met as well as they can be.
    fn arrived(&mut self, residuals: &[f64], sizes: &[f64]) -> Result<bool, Error> {
        let ratios = residuals.iter().zip(sizes).map(|(residual, size)| match residual.abs() {
            0.0 => 0.0,
            residual if residual.is_finite() && *size > 0.0 => residual / size,
            _ => f64::INFINITY,
        });
        let worst = ratios.fold(0.0, f64::max);
        if residuals.iter().any(|residual| !residual.is_finite()) {
            return Err(self.lost(residuals));
        }
        let arrived = worst <= ROUNDING || (worst <= STALLED && worst > 0.5 * self.last);
        self.last = worst;
        Ok(arrived)
    }

    fn lost(&self, residuals: &[f64]) -> Error {
        let key = |i: &usize| if residuals[*i].is_finite() { residuals[*i].abs() } else { f64::INFINITY };
        let row = (0..residuals.len()).max_by(|i, j| key(i).total_cmp(&key(j))).unwrap_or_default();
        Error::Projection {
            constraint: self.names.get(row).copied().unwrap_or("position"),
            residual: residuals.get(row).copied().unwrap_or(f64::NAN),
            time: self.time,
        }
    }
}

/// A time and numbers that a caller gave must be finite.
fn check<V: Vector<f64>>(t: f64, numbers: &V, names: &'static [&'static str]) -> Result<(), Error> {
    let lost = entries(numbers).iter().position(|entry| !entry.is_finite());
    match lost {
        _ if !t.is_finite() => Err(Error::NonFinite { name: "t" }),
        Some(at) => Err(Error::NonFinite { name: names[at] }),
        None => Ok(()),
    }
}

fn entries<T: crate::Scalar, V: Vector<T>>(v: &V) -> Vec<T> {
    let array: V::Array = (*v).into();
    Vec::from(array.as_ref())
}
