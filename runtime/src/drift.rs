//! The way back onto the velocity constraints, by the least change in the kinetic metric.

use alloc::vec;
use alloc::vec::Vec;

use crate::carriers::{Carriers, Frame};
use crate::manifold::{DEPENDENT, ROUNDING, STALLED, ratio, term_sizes};
use crate::tangent::Tangent;
use crate::{ConstrainedSystem, Error, Level, Matrix, Prepared};

const ITERATIONS: usize = 8;

/// The velocity constraints that carriers do not satisfy by construction: nonlinear ones in an emitted chart, all in the general one.
pub(crate) struct Drift<M: ConstrainedSystem> {
    frame: Frame<M>,
    /// Which rows of C, and which entry of φ each has.
    places: Vec<(usize, usize)>,
    /// The size of the terms of each entry of φ, the largest seen.
    sizes: Vec<f64>,
    tangent: Tangent,
    rows: Vec<f64>,
    residuals: Vec<f64>,
    /// The largest residual at the last point, relative to its terms.
    pub(crate) last: f64,
    /// Whether also residuals that count as zero are reduced: near a loss of rank they turn the velocity.
    pub(crate) thorough: bool,
}

impl<M: ConstrainedSystem> Drift<M> {
    /// `None` where the carriers satisfy all velocity constraints by construction.
    pub(crate) fn new(
        model: &Prepared<M>,
        carriers: Carriers,
        t: f64,
        x: &M::Coordinates<f64>,
        v: &M::Velocities<f64>,
    ) -> Result<Option<Self>, Error> {
        let binding = M::MODEL.rows.iter().enumerate().filter(|(_, row)| row.level != Level::Acceleration);
        let places: Vec<(usize, usize)> = binding
            .enumerate()
            .filter(|(_, (_, row))| carriers == Carriers::General || !row.linear)
            .map(|(residual, (row, _))| (row, residual))
            .collect();
        if places.is_empty() {
            return Ok(None);
        }
        let sizes = term_sizes(model, t, x, v, &|model, t, x, v| model.velocity_residual(t, x, v))?;
        let frame = Frame::new(model, carriers)?;
        let ((n, c), m) = (frame.size, places.len());
        Ok(Some(Drift {
            frame,
            sizes: places.iter().map(|(_, residual)| sizes[*residual]).collect(),
            tangent: Tangent::new(c, m),
            rows: vec![0.0; m * n],
            residuals: vec![0.0; m],
            places,
            last: 0.0,
            thorough: false,
        }))
    }

    /// Brings the carriers w back onto φ = 0, and tells whether it moved them. Of `s` the coordinates are read.
    pub(crate) fn restore(
        &mut self,
        model: &Prepared<M>,
        t: f64,
        s: &M::State<f64>,
        w: &mut [f64],
    ) -> Result<bool, Error> {
        let x = model.coordinates(t, s);
        let (mut moved, mut before) = (false, f64::INFINITY);
        for _ in 0..ITERATIONS {
            let v = self.frame.carriers.velocities(model, t, s, |i| w[i]);
            self.measure(model, t, &x, &v);
            if self.last <= ROUNDING && (moved || !self.thorough) {
                return Ok(moved);
            }
            let stalled = self.last <= STALLED && self.last > 0.5 * before;
            if stalled {
                return Ok(moved);
            }
            before = self.last;
            self.step(model, t, s, &x, w);
            moved = true;
        }
        let v = self.frame.carriers.velocities(model, t, s, |i| w[i]);
        self.measure(model, t, &x, &v);
        if self.last <= STALLED {
            return Ok(moved);
        }
        let (worst, _) = self.worst();
        let constraint = M::MODEL.rows[self.places[worst].0].name;
        Err(Error::Projection { constraint, residual: self.residuals[worst], time: t })
    }

    /// φ, C, and the sizes of the terms, which grow.
    fn measure(&mut self, model: &Prepared<M>, t: f64, x: &M::Coordinates<f64>, v: &M::Velocities<f64>) {
        let n = self.frame.size.0;
        let (phi, matrix) = (model.velocity_residual(t, x, v).into(), model.constraint_matrix(t, x, v));
        let v = (*v).into();
        for (i, (row, residual)) in self.places.iter().enumerate() {
            self.residuals[i] = phi.as_ref()[*residual];
            let mut terms = 0.0;
            for j in 0..n {
                self.rows[i * n + j] = matrix.entry(*row, j);
                terms += (matrix.entry(*row, j) * v.as_ref()[j]).abs();
            }
            if terms.is_finite() {
                self.sizes[i] = self.sizes[i].max(terms);
            }
        }
        self.last = self.worst().1;
    }

    fn worst(&self) -> (usize, f64) {
        let ratios = self.residuals.iter().zip(&self.sizes).map(|(phi, size)| ratio(*phi, *size)).enumerate();
        ratios.fold((0, 0.0), |worst, (i, ratio)| if ratio > worst.1 { (i, ratio) } else { worst })
    }

    fn step(&mut self, model: &Prepared<M>, t: f64, s: &M::State<f64>, x: &M::Coordinates<f64>, w: &mut [f64]) {
        self.frame.turn(t, s, |i| w[i]);
        self.frame.pull_rows(&self.rows, &mut self.tangent.rows);
        self.frame.pull_inertia(&model.inertia(t, x), &mut self.tangent.mass);
        let change = self.tangent.nearest(&self.residuals, DEPENDENT);
        w.iter_mut().zip(change).for_each(|(w, change)| *w += change);
    }
}
