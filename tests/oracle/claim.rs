//! What a derivation claims at one state, in plain numbers: filled from the engine's evaluation or from emitted code.

use nalgebra::{DMatrix, DVector};

/// One multiplier and the row of C that carries it.
#[derive(Clone, Debug)]
pub struct Multiplier {
    /// Its name.
    pub name: String,
    /// Its value.
    pub value: f64,
    /// The row of C, if the constraint stands there.
    pub row: Option<usize>,
}

/// Everything a derivation says about one state.
#[derive(Clone, Debug)]
pub struct Claim {
    /// Time.
    pub t: f64,
    /// q with a configuration, else x.
    pub state_coordinates: Vec<f64>,
    /// The names of the independent speeds.
    pub speed_names: Vec<String>,
    /// u.
    pub speeds: Vec<f64>,
    /// x (4.2).
    pub coordinates: Vec<f64>,
    /// v (5.3).
    pub velocities: Vec<f64>,
    /// d/dt of the state's coordinates (4.3), (5.7).
    pub coordinate_rates: Vec<f64>,
    /// u̇.
    pub accelerations: Vec<f64>,
    /// v̇ as the derivative of `velocities` along the claimed motion.
    pub velocity_rates: Vec<f64>,
    /// M_d (4.10).
    pub mass_matrix: DMatrix<f64>,
    /// h_u* (4.10), (5.6).
    pub forcing: Vec<f64>,
    /// D (k × n).
    pub complement: DMatrix<f64>,
    /// a_u.
    pub complement_bias: Vec<f64>,
    /// λ.
    pub multipliers: Vec<Multiplier>,
    /// The names of the rows of C.
    pub row_names: Vec<String>,
    /// C (m × n).
    pub constraint_matrix: DMatrix<f64>,
    /// c0*.
    pub constraint_bias: Vec<f64>,
    /// ḟ or φ, one per row of C.
    pub velocity_residual: Vec<f64>,
    /// f by name.
    pub position_residual: Vec<(String, f64)>,
    /// A.
    pub kinematic_matrix: DMatrix<f64>,
    /// a0.
    pub kinematic_bias: Vec<f64>,
    /// M.
    pub inertia: DMatrix<f64>,
    /// h*.
    pub forces: Vec<f64>,
    /// ½ vᵀ M v.
    pub kinetic_energy: f64,
    /// V.
    pub potential_energy: Option<f64>,
}

impl Claim {
    /// v̇ = Dᵀ u̇ + a_u.
    pub fn acceleration(&self) -> DVector<f64> {
        self.complement.transpose() * DVector::from_column_slice(&self.accelerations)
            + DVector::from_column_slice(&self.complement_bias)
    }

    /// Cᵀ λ over the rows that carry a multiplier, each row once.
    pub fn reaction(&self) -> DVector<f64> {
        let mut reaction = DVector::zeros(self.velocities.len());
        let mut taken = vec![false; self.row_names.len()];
        for multiplier in &self.multipliers {
            if let Some(row) = multiplier.row.filter(|&row| !std::mem::replace(&mut taken[row], true)) {
                reaction += self.constraint_matrix.row(row).transpose() * multiplier.value;
            }
        }
        reaction
    }
}
