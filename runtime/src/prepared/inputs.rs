//! Inputs that give a motion.

use alloc::vec::Vec;

use nalgebra::DMatrix;

use super::Prepared;
use crate::assemble::newton::{Equations, STALLED, newton, worst};
use crate::assemble::{check_finite, entries};
use crate::forms::null_directions;
use crate::manifold::{floor, lift};
use crate::scalar::{Measured, Orders};
use crate::simulate::{Watch, check_inputs};
use crate::vector::{convert, entry};
use crate::{ConstrainedSystem, Dual, Error, Matrix, Vector};

const PASSES: usize = 2;
/// An input acts if D ∂h*/∂i is more than this fraction of the terms that it and D are made of; columns that differ by less depend on
/// each other.
const ACTS: f64 = 1e-10;
/// How far from the guess it is looked for an effect that a square, say, does not show at zero: so far …
const ASIDE: [f64; 2] = [0.7, -1.3];
/// … and for each further input by so much more.
const APART: f64 = 0.31;

impl<M: ConstrainedSystem> Prepared<M> {
    /// Inputs under which the independent speeds have the given rates ν: D (M (Dᵀ ν + a_u) − h*(i)) = 0, solved for i.
    ///
    /// It is [`inverse_dynamics`](Self::inverse_dynamics) for the forces that the model really has: a motor inside the mechanism, a
    /// thrust along a body's axis, a torque between two links; loops and rows that repeat others change nothing. As many
    /// independent inputs as degrees of freedom are unique. Of more inputs those nearest to the `guess` are taken, by the sum
    /// of squares of the changes: those of least norm, if the guess is zero. Fewer serve where the motion needs no more.
    ///
    /// h* may be any function of the inputs: dual numbers differentiate it, and Newton's method goes from the guess. Where h* is
    /// affine in them, as of forces and torques, its first step is the answer. Otherwise the guess decides which of several
    /// answers is found, and of a continuum a near one.
    ///
    /// In a run the rates are those of a motion that is wanted, q̈(t) where the independent speeds are rates of coordinates; a feedback
    /// may be added to them. Here the motion is given by its accelerations alone:
    ///
    /// ```
    /// # #[cfg(feature = "derive")] fn main() -> Result<(), holonomy::Error> {
    /// use holonomy::prelude::*;
    /// use holonomy::State;
    ///
    /// /// A load on a rod that hangs from a trolley, in x and y; a winch pulls the trolley.
    /// #[derive(ConstrainedSystem, Clone)]
    /// #[coordinates(cart, x, y)]
    /// #[inertia(diag(m1, m2, m2))]
    /// #[forces(pull, wind, -m2*g)]
    /// #[inputs(pull, wind)]
    /// #[constraint(rod: (powi(x - cart, 2) + powi(y, 2) - powi(l, 2))/2 == 0)]
    /// #[independent(dot(cart), dot(x))]
    /// struct Crane {
    ///     m1: f64,
    ///     m2: f64,
    ///     l: f64,
    ///     g: f64,
    /// }
    ///
    /// let crane = Crane { m1: 3.0, m2: 1.5, l: 0.8, g: 9.81 }.prepare()?;
    /// let start = State::<Crane> { y: -0.8, ..Default::default() };
    /// let guess = CraneInputs { pull: 0.0, wind: 0.0 };
    ///
    /// // Both are to move by 0.1 (1 − cos t).
    /// let run = crane.simulate(start).inputs(|t, s| {
    ///     let rates = [0.1 * t.cos(), 0.1 * t.cos()];
    ///     crane.inputs_for(t, s, &rates, &guess).unwrap_or(guess)
    /// });
    /// let run = run.until(2.0)?;
    /// let (t, end) = run.last();
    /// assert!((end.cart - 0.1 * (1.0 - t.cos())).abs() < 1e-9 && (end.x - end.cart).abs() < 1e-9);
    /// # Ok(())
    /// # }
    /// # #[cfg(not(feature = "derive"))] fn main() {}
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::NotHeld`] where no inputs give these rates, with the speed and what is missing along it; [`Error::NoEffect`] where
    /// inputs do not act on the motion in this state, with their names; [`Error::ChartSingularity`] where the independent speeds
    /// do not determine the others; [`Error::NotDifferentiable`] and [`Error::MissingOrder`] where h* has no derivative along
    /// an input.
    ///
    /// The state is not judged by the constraints, as the stages of a step in a run do not quite meet them.
    pub fn inputs_for(
        &self,
        t: f64,
        s: &M::State<f64>,
        rates: &M::Reduced<f64>,
        guess: &M::Inputs<f64>,
    ) -> Result<M::Inputs<f64>, Error> {
        check_finite::<M>(t, s)?;
        check_inputs::<M>(guess)?;
        if let Some(at) = entries(rates).iter().position(|rate| !rate.is_finite()) {
            return Err(Error::NonFinite { name: speed::<M>(at) });
        }
        Watch::new(self, 0, t, s)?;
        let reduced = Reduced::new(self, t, s, rates)?;
        let mut y = reduced.start(entries(guess))?;
        let (mut sizes, mut r) = (Vec::new(), Vec::new());
        for _ in 0..PASSES {
            // Far from the solution the terms are large, and so is their rounding: what counts is their size at the solution.
            sizes = reduced.sizes(&y);
            r = newton(&reduced, &mut y, &mut sizes);
        }
        let (row, ratio) = worst(&r, &sizes);
        match ratio > STALLED {
            true => Err(Error::NotHeld { speed: speed::<M>(row), residual: r[row], time: t }),
            false => Ok(inputs::<M>(&y)),
        }
    }
}

/// The reduced equations at one state, the rates given, as equations for the inputs.
struct Reduced<'a, M: ConstrainedSystem> {
    model: &'a Prepared<M>,
    dual: Prepared<M, Dual>,
    time: f64,
    state: M::State<f64>,
    rates: M::Reduced<f64>,
    x: M::Coordinates<Dual>,
    v: M::Velocities<Dual>,
    complement: DMatrix<f64>,
    /// The same over numbers that know their terms: at a dead point an entry of D may be nothing but rounding.
    measured: Prepared<M, Measured>,
    terms: DMatrix<f64>,
}

impl<'a, M: ConstrainedSystem> Reduced<'a, M> {
    fn new(model: &'a Prepared<M>, time: f64, state: &M::State<f64>, rates: &M::Reduced<f64>) -> Result<Self, Error> {
        let parameters = convert(model.parameters(), |_, value| Measured::given(value, 0.0));
        let measured: Prepared<M, Measured> = Prepared::with_parameters(model.system().clone(), parameters)?;
        let (k, n) = (M::Complement::<f64>::ROWS, M::Complement::<f64>::COLUMNS);
        let d = model.complement(time, state);
        let terms = measured.complement(Measured::given(time, 0.0), &measured_state::<M>(state));
        let constant = |_, value| Dual::constant(value);
        Ok(Reduced {
            model,
            dual: lift(model)?,
            time,
            state: *state,
            rates: *rates,
            x: convert(&model.coordinates(time, state), constant),
            v: convert(&model.velocities(time, state), constant),
            complement: DMatrix::from_fn(k, n, |i, j| d.entry(i, j)),
            measured,
            terms: DMatrix::from_fn(k, n, |i, j| terms.entry(i, j).size),
        })
    }

    /// ∂h*/∂i.
    fn slopes(&self, y: &[f64]) -> DMatrix<f64> {
        let column = |seed: usize| {
            let i = M::Inputs::from_fn(|at| Dual::new(y[at], if at == seed { 1.0 } else { 0.0 }));
            entries(&self.dual.forces(Dual::constant(self.time), &self.x, &self.v, &i))
        };
        let columns: Vec<Vec<Dual>> = (0..y.len()).map(column).collect();
        DMatrix::from_fn(self.complement.ncols(), y.len(), |i, j| columns[j][i].derivative)
    }

    /// Which inputs act on the motion.
    fn acting(&self, y: &[f64]) -> Vec<bool> {
        let slopes = self.slopes(y);
        let (acts, terms) = (&self.complement * &slopes, &self.terms * slopes.map(f64::abs));
        let acts = |j: usize| acts.column(j).iter().zip(&terms.column(j)).any(|(a, terms)| a.abs() > ACTS * terms);
        (0..y.len()).map(acts).collect()
    }

    /// The guess, or beside it, for inputs that act there only.
    fn start(&self, mut y: Vec<f64>) -> Result<Vec<f64>, Error> {
        self.judge(&y)?;
        let mut idle = self.acting(&y).iter().map(|acts| !acts).collect::<Vec<bool>>();
        for shift in ASIDE {
            if !idle.contains(&true) {
                break;
            }
            let aside: Vec<f64> = y.iter().enumerate().map(|(at, y)| y + shift + APART * at as f64).collect();
            for (at, acts) in self.acting(&aside).into_iter().enumerate() {
                if idle[at] && acts {
                    (idle[at], y[at]) = (false, aside[at]);
                }
            }
        }
        let names = M::MODEL.inputs.iter().zip(&idle).filter(|(_, idle)| **idle).map(|(name, _)| *name);
        match idle.contains(&true) {
            true => Err(Error::NoEffect { inputs: names.collect(), time: self.time }),
            false => Ok(y),
        }
    }

    /// All must be finite.
    fn judge(&self, y: &[f64]) -> Result<(), Error> {
        if let Some(at) = self.residual(y).iter().position(|entry| !entry.is_finite()) {
            return Err(Error::NonFinite { name: speed::<M>(at) });
        }
        let acts = &self.complement * self.slopes(y);
        for (j, column) in acts.column_iter().enumerate() {
            if let Some(row) = column.iter().position(|entry| !entry.is_finite()) {
                if self.lacks_order(y, row)? {
                    return Err(Error::MissingOrder { name: speed::<M>(row) });
                }
                let along = M::MODEL.inputs.get(j).copied().unwrap_or("input");
                return Err(Error::NotDifferentiable { name: speed::<M>(row), along, time: self.time });
            }
        }
        Ok(())
    }

    /// Whether a row lacks the derivative of a function of the model's own.
    fn lacks_order(&self, y: &[f64], row: usize) -> Result<bool, Error> {
        let parameters = convert(self.model.parameters(), |_, value| Orders::still(value));
        let orders: Prepared<M, Orders> = Prepared::with_parameters(self.model.system().clone(), parameters)?;
        let (s, rates) = (convert(&self.state, |_, v| Orders::still(v)), convert(&self.rates, |_, v| Orders::still(v)));
        let i = M::Inputs::from_fn(|at| Orders::moving(y[at]));
        Ok(entry(&orders.inverse_dynamics(Orders::still(self.time), &s, &rates, &i))(row).lacking)
    }

    /// The size of each row's terms.
    fn sizes(&self, y: &[f64]) -> Vec<f64> {
        let (t, s) = (Measured::given(self.time, 0.0), measured_state::<M>(&self.state));
        let rates = convert(&self.rates, |_, value| Measured::given(value, 0.0));
        let i = M::Inputs::from_fn(|at| Measured::given(y[at], 0.0));
        let known = |size: f64| if size.is_finite() { size } else { 0.0 };
        entries(&self.measured.inverse_dynamics(t, &s, &rates, &i)).iter().map(|row| known(row.size)).collect()
    }
}

impl<M: ConstrainedSystem> Equations for Reduced<'_, M> {
    fn residual(&self, y: &[f64]) -> Vec<f64> {
        entries(&self.model.inverse_dynamics(self.time, &self.state, &self.rates, &inputs::<M>(y)))
    }

    fn jacobian(&self, y: &[f64]) -> DMatrix<f64> {
        -(&self.complement * self.slopes(y))
    }

    /// Where only one answer is possible, inputs count by their effect, so that none is too weak to be seen beside others.
    fn measure(&self, y: &[f64]) -> DMatrix<f64> {
        let mut jacobian = self.jacobian(y);
        let scales: Vec<f64> = jacobian.column_iter().map(|column| 1.0 / column.amax()).collect();
        let identity = DMatrix::identity(y.len(), y.len());
        if scales.iter().any(|scale| !scale.is_finite()) {
            return identity;
        }
        for (j, scale) in scales.iter().enumerate() {
            jacobian.column_mut(j).scale_mut(*scale);
        }
        match null_directions(jacobian, ACTS).nrows() {
            0 => DMatrix::from_diagonal(&scales.into()),
            _ => identity,
        }
    }
}

/// A state of which the terms of what is computed from it are known; none of its entries counts as exactly zero.
fn measured_state<M: ConstrainedSystem>(s: &M::State<f64>) -> M::State<Measured> {
    let least = floor(s);
    convert(s, |_, value| Measured::given(value, least))
}

fn inputs<M: ConstrainedSystem>(y: &[f64]) -> M::Inputs<f64> {
    M::Inputs::from_fn(|at| y[at])
}

/// The name of a speed whose rate is an independent one.
fn speed<M: ConstrainedSystem>(at: usize) -> &'static str {
    M::MODEL.reduced_speeds.get(at).copied().unwrap_or("speed")
}
