//! Principles that every motion obeys: what tests may ask of any form.

use nalgebra::DVector;

use super::InitialEquations;
use super::dense::{column, solve};
use crate::Error;

impl InitialEquations {
    /// Gauss' constraint (Zwang) (v̇ − M⁻¹ h*)ᵀ M (v̇ − M⁻¹ h*): the motion makes it least among all v̇ with C v̇ + c0* = 0.
    ///
    /// ```
    /// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
    /// # use models::{Pendulum, PendulumState};
    /// use holonomy::prelude::*;
    ///
    /// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
    /// let s = PendulumState { x: 0.3, y: -0.4, dot_x: 0.2 };
    /// let full = pendulum.initial_equations_at(0.0, &s, &[]);
    /// let (rates, multipliers) = full.solve()?;
    /// // λᵀ M_c λ, as the constraints alone hold v̇ back.
    /// let value = multipliers.dot(&(full.constraint_metric()? * &multipliers));
    /// assert!((full.gauss_constraint(&rates)? - value).abs() < 1e-12);
    /// let along = pendulum.complement_at(0.0, &s).transpose().column(0) * 1e-3;
    /// assert!(full.gauss_constraint(&(&rates + &along))? > full.gauss_constraint(&rates)?);
    /// assert!(full.gauss_constraint(&(&rates - &along))? > full.gauss_constraint(&rates)?);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn gauss_constraint(&self, rates: &DVector<f64>) -> Result<f64, Error> {
        super::shape("v̇", (self.forces.len(), 1), (rates.len(), 1))?;
        let free = solve("M", self.inertia.clone(), column(&self.forces))?;
        let held_back = rates - free.column(0);
        Ok(held_back.dot(&(&self.inertia * &held_back)))
    }

    /// vᵀ Cᵀ λ, the power of the reactions. Where the velocities meet the constraints C v + η = 0 it is −λᵀ η: constraints that
    /// do not move do no work.
    ///
    /// With [`power`](Self::power) it balances: vᵀ M v̇ = vᵀ h* + vᵀ Cᵀ λ.
    pub fn reaction_power(&self, multipliers: &DVector<f64>) -> Result<f64, Error> {
        super::shape("λ", (self.rows.len(), 1), (multipliers.len(), 1))?;
        Ok((&self.constraint_matrix * &self.velocities).dot(multipliers))
    }

    /// vᵀ h*, the power of the forces; gyroscopic terms included.
    pub fn power(&self) -> f64 {
        self.velocities.dot(&self.forces)
    }
}
