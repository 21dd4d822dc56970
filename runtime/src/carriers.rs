//! The carriers w of a motion: v = B w + v_p with w the speeds of a chart, or those from which all others follow.
//!
//! B and the part of v̇ that does not depend on ẇ come from the emitted velocities over dual numbers, so that one derivation serves
//! every chart, with and without a configuration.

use alloc::vec;
use alloc::vec::Vec;

use crate::manifold::lift;
use crate::vector::convert;
use crate::{ConstrainedSystem, Dual, Error, Matrix, Prepared, Scalar, Vector};

/// The array behind a model's state.
pub(crate) type StateArray<M> = <<M as ConstrainedSystem>::State<f64> as Vector<f64>>::Array;

/// Which speeds carry the motion.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) enum Carriers {
    /// The speeds of an emitted chart: they satisfy the linear velocity constraints by construction.
    Chart(usize),
    /// v, or the rates of a configuration: no constraint on velocities is satisfied by construction.
    General,
}

impl Carriers {
    /// The number of carriers.
    pub(crate) fn count<M: ConstrainedSystem>(self) -> usize {
        match self {
            Carriers::Chart(_) => M::MODEL.state_speeds.len(),
            Carriers::General => M::MODEL.carriers.len(),
        }
    }

    /// v of the carriers; of `s` the coordinates are read.
    pub(crate) fn velocities<M: ConstrainedSystem, T: Scalar>(
        self,
        model: &Prepared<M, T>,
        t: T,
        s: &M::State<T>,
        w: impl Fn(usize) -> T,
    ) -> M::Velocities<T> {
        match self {
            Carriers::General => M::carried_velocities(model.values(), t, s, &M::Carriers::from_fn(w)),
            Carriers::Chart(chart) => {
                let s = with_speeds::<M, T>(s, w);
                match chart {
                    0 => M::velocities(model.values(), t, &s),
                    _ => M::chart_velocities(chart, model.values(), t, &s),
                }
            }
        }
    }
}

/// A state with other entries for its speeds.
pub(crate) fn with_speeds<M: ConstrainedSystem, T: Scalar>(s: &M::State<T>, u: impl Fn(usize) -> T) -> M::State<T> {
    let first = M::MODEL.state_coordinates.len();
    convert(s, |i, entry| if i < first { entry } else { u(i - first) })
}

/// v = B w + v_p at a point, with the derivatives that the general form needs.
pub(crate) struct Frame<M: ConstrainedSystem> {
    pub(crate) carriers: Carriers,
    dual: Prepared<M, Dual>,
    /// The number of velocities and that of carriers.
    pub(crate) size: (usize, usize),
    /// B, n × c by rows.
    pub(crate) basis: Vec<f64>,
    /// a: v̇ where ẇ = 0.
    pub(crate) bias: Vec<f64>,
    /// K of q̇ = K w + …, by rows.
    pub(crate) rates: Vec<f64>,
    /// Whether v = w.
    identity: bool,
}

impl<M: ConstrainedSystem> Frame<M> {
    pub(crate) fn new(model: &Prepared<M>, carriers: Carriers) -> Result<Self, Error> {
        let (n, c) = (M::MODEL.velocities.len(), carriers.count::<M>());
        let identity = carriers == Carriers::General && M::MODEL.carriers == M::MODEL.velocities;
        let mut frame = Frame {
            carriers,
            dual: lift(model)?,
            size: (n, c),
            basis: vec![0.0; n * c],
            bias: vec![0.0; n],
            rates: vec![0.0; M::MODEL.state_coordinates.len() * c],
            identity,
        };
        if identity {
            (0..n).for_each(|i| frame.basis[i * c + i] = 1.0);
        }
        Ok(frame)
    }

    /// Fills B at a point.
    pub(crate) fn turn(&mut self, t: f64, s: &M::State<f64>, w: impl Fn(usize) -> f64) {
        if self.identity {
            return;
        }
        let (n, c) = self.size;
        let s = convert(s, |_, value| Dual::constant(value));
        for j in 0..c {
            let seeded = |i: usize| Dual::new(w(i), if i == j { 1.0 } else { 0.0 });
            let v = self.carriers.velocities(&self.dual, Dual::constant(t), &s, seeded).into();
            (0..n).for_each(|i| self.basis[i * c + j] = v.as_ref()[i].derivative);
        }
    }

    /// Fills a: the derivative of v along the motion with ẇ = 0, where the coordinates of the state have the rate given.
    pub(crate) fn drift(&mut self, t: f64, s: &M::State<f64>, rate: impl Fn(usize) -> f64, w: impl Fn(usize) -> f64) {
        if self.identity {
            return;
        }
        let first = M::MODEL.state_coordinates.len();
        let s = convert(s, |i, value| Dual::new(value, if i < first { rate(i) } else { 0.0 }));
        let v = self.carriers.velocities(&self.dual, Dual::variable(t), &s, |i| Dual::constant(w(i))).into();
        for (bias, entry) in self.bias.iter_mut().zip(v.as_ref()) {
            *bias = entry.derivative;
        }
    }

    /// Fills K of the carriers of the general chart at a point; its entries do not depend on w.
    pub(crate) fn kinematics(&mut self, t: f64, s: &M::State<f64>) {
        let c = self.size.1;
        let s = convert(s, |_, value| Dual::constant(value));
        for j in 0..c {
            let seeded = M::Carriers::from_fn(|i| Dual::new(0.0, if i == j { 1.0 } else { 0.0 }));
            let rates = M::carried_rates(self.dual.values(), Dual::constant(t), &s, &seeded).into();
            for (i, entry) in rates.as_ref().iter().enumerate() {
                self.rates[i * c + j] = entry.derivative;
            }
        }
    }

    /// Rows in v, taken over to the carriers: C B. Rows that vanish but for rounding are zero: a configuration satisfies them.
    pub(crate) fn pull_rows(&self, rows: &[f64], out: &mut [f64]) {
        let (n, c) = self.size;
        if self.identity {
            out.copy_from_slice(rows);
            return;
        }
        for (row, out) in rows.chunks(n.max(1)).zip(out.chunks_mut(c.max(1))) {
            let (mut length, mut terms) = (0.0, 0.0);
            for (j, out) in out.iter_mut().enumerate() {
                let products = row.iter().enumerate().map(|(i, entry)| entry * self.basis[i * c + j]);
                let (sum, size) = products.fold((0.0, 0.0), |(sum, size), p: f64| (sum + p, size + p.abs()));
                *out = sum;
                (length, terms) = (length + sum * sum, terms + size * size);
            }
            if length <= IDENTITY * IDENTITY * terms {
                out.fill(0.0);
            }
        }
    }

    /// Bᵀ M B.
    pub(crate) fn pull_inertia(&self, inertia: &M::SystemMatrix<f64>, out: &mut [f64]) {
        let (n, c) = self.size;
        for a in 0..c {
            for b in 0..=a {
                let entry = if self.identity {
                    inertia.entry(a, b)
                } else {
                    let momentum =
                        |i: usize| -> f64 { (0..n).map(|j| inertia.entry(i, j) * self.basis[j * c + b]).sum() };
                    (0..n).filter(|i| self.basis[i * c + a] != 0.0).map(|i| self.basis[i * c + a] * momentum(i)).sum()
                };
                (out[a * c + b], out[b * c + a]) = (entry, entry);
            }
        }
    }

    /// Bᵀ h.
    pub(crate) fn pull_force(&self, force: impl Fn(usize) -> f64, out: &mut [f64]) {
        let (n, c) = self.size;
        for (a, out) in out.iter_mut().enumerate() {
            *out = match self.identity {
                true => force(a),
                false => (0..n).map(|i| self.basis[i * c + a] * force(i)).sum(),
            };
        }
    }
}

/// A row of C B below this fraction of its terms vanishes identically.
const IDENTITY: f64 = 1e-12;
