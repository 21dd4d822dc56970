//! A derived model that runs.

use super::extrapolation::integrate;
use holonomy::{ConstrainedSystem, Dual, Matrix, Prepared, Scalar, Vector};
use nalgebra::{DMatrix, DVector};

/// The entries of a vector of the runtime.
pub fn entries<T: Scalar, V: Vector<T>>(vector: &V) -> Vec<T> {
    let array: V::Array = (*vector).into();
    array.as_ref().to_vec()
}

/// A matrix of the runtime as one of any size.
pub fn dense<X: Matrix<f64>>(matrix: &X) -> DMatrix<f64> {
    DMatrix::from_fn(X::ROWS, X::COLUMNS, |i, j| matrix.entry(i, j))
}

/// The entries of a matrix, row after row, as golden data has them.
pub fn by_rows<X: Matrix<f64>>(matrix: &X) -> Vec<f64> {
    dense(matrix).transpose().as_slice().to_vec()
}

/// A prepared model without inputs, its states as lists: coordinates, then speeds.
pub struct Running<M: ConstrainedSystem>(pub Prepared<M>);

impl<M: ConstrainedSystem> Running<M> {
    /// Prepares the model.
    ///
    /// # Panics
    /// If its parameters are refused.
    pub fn new(model: M) -> Self {
        Self(model.prepare().expect("the parameters are good"))
    }

    /// The named state of a list.
    pub fn state(&self, y: &[f64]) -> M::State<f64> {
        M::State::<f64>::from_fn(|i| y[i])
    }

    fn no_inputs<T: Scalar>(&self) -> M::Inputs<T> {
        M::Inputs::<T>::from_fn(|_| T::from_f64(0.0))
    }

    /// The rate of the state.
    pub fn rate(&self, t: f64, y: &[f64]) -> Vec<f64> {
        entries(&self.0.derivative(t, &self.state(y), &self.no_inputs()).0)
    }

    /// x.
    pub fn coordinates(&self, t: f64, y: &[f64]) -> Vec<f64> {
        entries(&self.0.coordinates(t, &self.state(y)))
    }

    /// v.
    pub fn velocities(&self, t: f64, y: &[f64]) -> Vec<f64> {
        entries(&self.0.velocities(t, &self.state(y)))
    }

    /// v̇ = Dᵀ u̇ + a_u.
    pub fn velocity_rates(&self, t: f64, y: &[f64]) -> Vec<f64> {
        entries(&self.0.velocity_rates(t, &self.state(y), &self.no_inputs()))
    }

    /// u̇.
    pub fn accelerations(&self, t: f64, y: &[f64]) -> Vec<f64> {
        entries(&self.0.accelerations(t, &self.state(y), &self.no_inputs()))
    }

    /// h_u*.
    pub fn forcing(&self, t: f64, y: &[f64]) -> Vec<f64> {
        entries(&self.0.forcing(t, &self.state(y), &self.no_inputs()))
    }

    /// All λ.
    pub fn multipliers(&self, t: f64, y: &[f64]) -> Vec<f64> {
        entries(&self.0.multipliers(t, &self.state(y), &self.no_inputs()))
    }

    /// λ of one constraint.
    ///
    /// # Panics
    /// If there is none of that name.
    pub fn multiplier(&self, name: &str, t: f64, y: &[f64]) -> f64 {
        let multipliers = self.0.multipliers(t, &self.state(y), &self.no_inputs());
        multipliers.get(name).unwrap_or_else(|| panic!("no multiplier {name}"))
    }

    /// Cᵀ λ, every row of C once.
    pub fn reaction(&self, t: f64, y: &[f64]) -> DVector<f64> {
        let s = self.state(y);
        let (x, v) = (self.0.coordinates(t, &s), self.0.velocities(t, &s));
        let c = dense(&self.0.constraint_matrix(t, &x, &v));
        let lambda = self.multipliers(t, y);
        let mut of_row = DVector::zeros(c.nrows());
        for (info, lambda) in M::MODEL.multipliers.iter().zip(lambda) {
            if let Some(row) = info.row {
                of_row[row] = lambda;
            }
        }
        c.transpose() * of_row
    }

    /// The state with the given coordinates whose velocities are the given ones: v is affine in u.
    ///
    /// # Panics
    /// If no speeds give these velocities.
    pub fn with_velocities(&self, t: f64, coordinates: &[f64], v: &[f64]) -> Vec<f64> {
        let k = M::MODEL.state_speeds.len();
        let state = |u: &[f64]| -> Vec<f64> { coordinates.iter().chain(u).copied().collect() };
        let rest = DVector::from_vec(self.velocities(t, &state(&vec![0.0; k])));
        let columns: Vec<DVector<f64>> = (0..k)
            .map(|j| {
                let unit: Vec<f64> = (0..k).map(|i| f64::from(u8::from(i == j))).collect();
                DVector::from_vec(self.velocities(t, &state(&unit))) - &rest
            })
            .collect();
        let wanted = DVector::from_column_slice(v) - rest;
        let d = DMatrix::from_columns(&columns);
        let u = d.clone().svd(true, true).solve(&wanted, 1e-12).expect("both sets of singular vectors");
        let missed = (d * &u - &wanted).amax();
        assert!(missed <= 1e-12 * wanted.amax().max(1.0), "no speeds give these velocities: {missed:e} off");
        state(u.as_slice())
    }

    /// The energy.
    pub fn energy(&self, t: f64, y: &[f64]) -> f64 {
        self.0.energy(t, &self.state(y))
    }

    /// ∂(rate)/∂(state) by dual numbers through the emitted code.
    ///
    /// # Panics
    /// If the parameters are refused.
    pub fn jacobian(&self, t: f64, y: &[f64]) -> DMatrix<f64> {
        let prepared = self.0.system().clone().prepare_as::<Dual<f64>>().expect("the parameters are good");
        let columns: Vec<Vec<f64>> = (0..y.len())
            .map(|j| {
                let state = M::State::<Dual<f64>>::from_fn(|i| Dual::new(y[i], f64::from(u8::from(i == j))));
                let (rate, _) = prepared.derivative(Dual::constant(t), &state, &self.no_inputs());
                entries(&rate).iter().map(|e| e.derivative).collect()
            })
            .collect();
        DMatrix::from_fn(y.len(), y.len(), |i, j| columns[j][i])
    }

    /// The states at the given times from the state at the first of them, by an integrator that is not the runtime's.
    pub fn run(&self, start: &[f64], times: &[f64], step: f64) -> Vec<Vec<f64>> {
        integrate(|t, y| self.rate(t, y), start, times, step)
    }
}
