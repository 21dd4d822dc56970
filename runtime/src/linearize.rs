//! Linearisation about any state: small deviations from a motion, the constraints eliminated.

mod elimination;
mod modes;

use alloc::vec::Vec;

use nalgebra::{Complex, DMatrix, DVector};

use crate::assemble::check_finite;
use crate::manifold::lift;
use crate::scalar::Orders;
use crate::simulate::{Watch, check_inputs, check_position, check_velocity};
use crate::vector::convert;
use crate::{ConstrainedSystem, Dual, Error, OutputInfo, Prepared, Scalar, Vector};

use elimination::Elimination;

/// δẏ = A δy + B δi and δo = C_y δy + D_y δi: how small deviations from a motion go on, and what they do to the outputs; from
/// [`Prepared::linearize`].
///
/// y are the independent entries of the state s = (q, u), and i are the inputs, which have e entries; there are k entries y
/// and p outputs o. Entries of A have the unit of the row's entry of y over that of the column's and a second, and so on.
///
/// # How the constraints are eliminated
///
/// The emitted derivative is ṡ = F(t, s, i). The speeds u satisfy all constraints that are linear in the velocities, whatever
/// they are; position constraints f(q, t) = 0 bind the coordinates, and constraints φ(q, u, t) = 0 that are not linear bind the
/// speeds. With G = ∂(f, φ)/∂s neighbouring states satisfy G δs = 0. Where G has full rank, Gauss-Jordan elimination takes as many
/// entries as there are rows to follow from the others, y = E s, so that δs = S δy with G S = 0 and E S = 1. By the theorem on
/// implicit functions s is a function of y and t there, with ∂s/∂y = S. F keeps to the constraints; so y has an equation
/// of its own, ẏ = E F(t, s(y, t), i), and its derivatives at fixed time are
///
/// A = E ∂F/∂s S,  B = E ∂F/∂i,  and of the outputs o = h(t, s, i) likewise  C_y = ∂h/∂s S,  D_y = ∂h/∂i.
///
/// That holds at every state that satisfies the constraints, at rest, steady or not; how F goes on outside of them does not
/// matter. Columns of ∂F/∂s S are derivatives in the directions of S: one evaluation of the emitted code over dual numbers each,
/// no differences. About a motion that is not steady, A and B change with it.
///
/// ```
/// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
/// # use models::{Pendulum, PendulumState};
/// use holonomy::prelude::*;
///
/// // A pendulum in x and y, one constraint: of its two coordinates one is independent.
/// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
/// let hanging = PendulumState { x: 0.0, y: -0.5, dot_x: 0.0 };
/// let linear = pendulum.linearize(0.0, &hanging, &[])?;
/// assert_eq!((linear.states, linear.dependents), (vec!["x", "dot_x"], vec!["y"]));
/// assert_eq!(linear.a.transpose().as_slice(), [0.0, 1.0, -9.81 / 0.5, 0.0]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Linearization {
    /// The names of y, the independent entries of the state: the rows and columns of A.
    pub states: Vec<&'static str>,
    /// The names of the entries that follow from y.
    pub dependents: Vec<&'static str>,
    /// The names of the inputs: the columns of B and D_y.
    pub inputs: Vec<&'static str>,
    /// The names of the outputs: the rows of C_y and D_y.
    pub outputs: Vec<&'static str>,
    /// ẏ itself, which vanishes at an equilibrium; k entries.
    pub rate: DVector<f64>,
    /// A, k × k.
    pub a: DMatrix<f64>,
    /// B, k × e.
    pub b: DMatrix<f64>,
    /// C_y, p × k.
    pub c_y: DMatrix<f64>,
    /// D_y, p × e.
    pub d_y: DMatrix<f64>,
    /// S: all entries of the state by the independent ones, δs = S δy.
    pub tangent: DMatrix<f64>,
    /// Why outputs have no linear form at this state: an error for each whose value or derivative is not finite there. Its row in
    /// C_y and D_y is not a number; all else holds.
    pub undefined: Vec<Error>,
}

/// A motion e^{λ t} of the linearised equations; from [`Linearization::modes`].
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// λ, in 1/s.
    pub eigenvalue: Complex<f64>,
    /// The deviations δy, scaled so that the largest is one.
    pub shape: Vec<Complex<f64>>,
}

impl Linearization {
    /// The eigenvalues of A in 1/s, the largest real part first: the motion grows where it is positive.
    ///
    /// Coordinates of which nothing depends give zeros, exactly.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState};
    /// use holonomy::prelude::*;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let (standing, hanging) = (0.5, -0.5);
    /// let about = |y| pendulum.linearize(0.0, &PendulumState { x: 0.0, y, dot_x: 0.0 }, &[])?.eigenvalues();
    /// let w = (9.81_f64 / 0.5).sqrt();
    /// assert_eq!(about(standing)?.iter().map(|value| value.re).collect::<Vec<_>>(), [w, -w]);
    /// assert_eq!(about(hanging)?.iter().map(|value| value.im).collect::<Vec<_>>(), [w, -w]);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn eigenvalues(&self) -> Result<Vec<Complex<f64>>, Error> {
        modes::eigenvalues(&self.a)
    }

    /// The eigenvalues with their directions, in the order of [`eigenvalues`](Self::eigenvalues).
    ///
    /// Of an eigenvalue that occurs several times each mode has a direction that it multiplies; where A has fewer such
    /// directions, or by chance otherwise, some are the same.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState};
    /// use holonomy::prelude::*;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let standing = PendulumState { x: 0.0, y: 0.5, dot_x: 0.0 };
    /// let modes = pendulum.linearize(0.0, &standing, &[])?.modes()?;
    /// // It falls with ẋ = λ x.
    /// let (falls, w) = (&modes[0], (9.81_f64 / 0.5).sqrt());
    /// assert!((falls.shape[0].re * w - 1.0).abs() < 1e-14 && falls.shape[1].re == 1.0);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn modes(&self) -> Result<Vec<Mode>, Error> {
        let mode = |eigenvalue| Ok(Mode { eigenvalue, shape: modes::direction(&self.a, eigenvalue)? });
        self.eigenvalues()?.into_iter().map(mode).collect()
    }
}

impl<M: ConstrainedSystem> Prepared<M> {
    /// A, B and the output matrices about a state, which need not be an equilibrium; see [`Linearization`].
    ///
    /// The state must satisfy the constraints and its guards must not vanish, as at the start of a run. Functions of the
    /// model's own need one derivative more than the equations, or [`Error::MissingOrder`] tells which rate or output lacks it.
    ///
    /// ```
    /// # #[cfg(feature = "derive")] fn main() -> Result<(), holonomy::Error> {
    /// use holonomy::{ConstrainedSystem, State};
    ///
    /// /// A cart with a pendulum; the force on the cart is an input.
    /// #[derive(ConstrainedSystem, Clone)]
    /// #[coordinates(x, a)]
    /// #[kinetic_energy(m*powi(dot(x), 2)/2 + m*(powi(dot(x) + l*cos(a)*dot(a), 2) + powi(l*sin(a)*dot(a), 2))/2)]
    /// #[potential_energy(-m*g*l*cos(a))]
    /// #[forces(push, 0)]
    /// #[inputs(push)]
    /// #[output(bob = x + l*sin(a), felt = ddot(x))]
    /// struct Cart {
    ///     m: f64,
    ///     l: f64,
    ///     g: f64,
    /// }
    ///
    /// let cart = Cart { m: 2.0, l: 0.5, g: 10.0 }.prepare()?;
    /// let linear = cart.linearize(0.0, &State::<Cart>::default(), &[0.0].into())?;
    /// assert_eq!(linear.states, ["x", "a", "dot_x", "dot_a"]);
    /// // m ẍ = push + m g a, and l ä = −ẍ − g a.
    /// let close = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-12);
    /// [0.0, 10.0, 0.0, 0.0].into_iter().enumerate().for_each(|(j, entry)| close(linear.a[(2, j)], entry));
    /// [0.0, -40.0, 0.0, 0.0].into_iter().enumerate().for_each(|(j, entry)| close(linear.a[(3, j)], entry));
    /// [0.0, 0.0, 0.5, -1.0].into_iter().enumerate().for_each(|(i, entry)| close(linear.b[(i, 0)], entry));
    /// assert_eq!(linear.outputs, ["bob", "felt"]);
    /// close(linear.c_y[(0, 1)], 0.5);
    /// close(linear.d_y[(1, 0)], 0.5);
    /// # Ok(())
    /// # }
    /// # #[cfg(not(feature = "derive"))] fn main() {}
    /// ```
    pub fn linearize(&self, t: f64, s: &M::State<f64>, i: &M::Inputs<f64>) -> Result<Linearization, Error> {
        check_finite::<M>(t, s)?;
        check_inputs::<M>(i)?;
        let manifold = check_position(self, t, s)?;
        Watch::new(self, 0, t, s)?;
        check_velocity(self, t, s, &self.velocities(t, s))?;
        let dual = lift(self)?;
        let Elimination { independents, dependents, tangent } = Elimination::at(self, &dual, manifold, t, s)?;

        let state = <M::State<f64> as Vector<f64>>::NAMES;
        let names = |places: &[usize]| places.iter().map(|at| state[*at]).collect::<Vec<_>>();
        let (states, inputs) = (names(&independents), M::MODEL.inputs.to_vec());
        let outputs: Vec<&'static str> = M::MODEL.outputs.iter().map(|output| output.name).collect();
        let (k, e, p) = (states.len(), inputs.len(), outputs.len());
        let values = self.derivative(t, s, i).0.into();
        let rate = DVector::from_fn(k, |row, _| values.as_ref()[independents[row]]);
        if let Some(row) = rate.iter().position(|entry| !entry.is_finite()) {
            return Err(Error::NotDifferentiable { name: states[row], along: "t", time: t });
        }
        let mut undefined: Vec<Option<Error>> = self.undefined_outputs(t, s, i);

        let (mut of_rates, mut of_outputs) = (DMatrix::zeros(k, k + e), DMatrix::zeros(p, k + e));
        for j in 0..k + e {
            let along = if j < k { states[j] } else { inputs[j - k] };
            let moving = convert(s, |l, value| Dual::new(value, if j < k { tangent[(l, j)] } else { 0.0 }));
            let driven = convert(i, |l, value| Dual::new(value, if l + k == j { 1.0 } else { 0.0 }));
            let rate = dual.derivative(Dual::constant(t), &moving, &driven).0.into();
            for (row, at) in independents.iter().enumerate() {
                of_rates[(row, j)] = rate.as_ref()[*at].derivative;
                if !of_rates[(row, j)].is_finite() {
                    return Err(self.not_differentiable(t, s, i, (states[row], along)));
                }
            }
            let values = dual.outputs(Dual::constant(t), &moving, &driven).into();
            for (row, entry) in values.as_ref().iter().take(p).enumerate() {
                of_outputs[(row, j)] = entry.derivative;
                if !entry.derivative.is_finite() && undefined[row].is_none() {
                    undefined[row] = Some(self.not_differentiable(t, s, i, (outputs[row], along)));
                }
            }
        }
        for row in (0..p).filter(|row| undefined[*row].is_some()) {
            of_outputs.row_mut(row).fill(f64::NAN);
        }
        Ok(Linearization {
            a: of_rates.columns(0, k).into_owned(),
            b: of_rates.columns(k, e).into_owned(),
            c_y: of_outputs.columns(0, k).into_owned(),
            d_y: of_outputs.columns(k, e).into_owned(),
            dependents: names(&dependents),
            undefined: undefined.into_iter().flatten().collect(),
            rate,
            tangent,
            states,
            inputs,
            outputs,
        })
    }

    /// For each output why it has no finite value, if it has none.
    fn undefined_outputs(&self, t: f64, s: &M::State<f64>, i: &M::Inputs<f64>) -> Vec<Option<Error>> {
        let values = self.outputs(t, s, i).into();
        let judged = M::MODEL.outputs.iter().zip(values.as_ref());
        let error = |info: &OutputInfo| Error::Undefined { output: info.name, divisors: info.divisors, time: t };
        judged.map(|(info, value)| (!value.is_finite()).then(|| error(info))).collect()
    }

    /// Why a rate or an output has no derivative.
    fn not_differentiable(
        &self,
        t: f64,
        s: &M::State<f64>,
        i: &M::Inputs<f64>,
        (name, along): (&'static str, &'static str),
    ) -> Error {
        let parameters = convert(self.parameters(), |_, value| Orders::still(value));
        let model: Prepared<M, Orders> = match Prepared::with_parameters(self.system().clone(), parameters) {
            Ok(model) => model,
            Err(error) => return error,
        };
        let (t, s, i) = (Orders::still(t), convert(s, |_, v| Orders::moving(v)), convert(i, |_, v| Orders::moving(v)));
        let (rate, outputs) = (model.derivative(t, &s, &i).0.into(), model.outputs(t, &s, &i).into());
        let states = <M::State<f64> as Vector<f64>>::NAMES.iter().copied().zip(rate.as_ref());
        let outputs = M::MODEL.outputs.iter().map(|output| output.name).zip(outputs.as_ref());
        match states.chain(outputs).any(|(entry, value)| entry == name && value.lacking) {
            true => Error::MissingOrder { name },
            false => Error::NotDifferentiable { name, along, time: t.to_f64() },
        }
    }
}
