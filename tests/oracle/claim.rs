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

/// What a derivation says about the same state in the speeds of one chart.
#[derive(Clone, Debug, Default)]
pub struct ChartClaim {
    /// u of v.
    pub speeds: Vec<f64>,
    /// v of u.
    pub velocities: Vec<f64>,
    /// The rates of the state's coordinates.
    pub coordinate_rates: Vec<f64>,
    /// u̇.
    pub accelerations: Vec<f64>,
    /// What the chart divides by.
    pub guards: Vec<f64>,
}

/// Everything a derivation says about one state.
#[derive(Clone, Debug)]
pub struct Claim {
    /// Time.
    pub t: f64,
    /// q with a configuration, else x.
    pub state_coordinates: Vec<f64>,
    /// The names of the speeds that the state holds.
    pub speed_names: Vec<String>,
    /// Their values.
    pub speeds: Vec<f64>,
    /// x (4.2).
    pub coordinates: Vec<f64>,
    /// v (5.3).
    pub velocities: Vec<f64>,
    /// d/dt of the state's coordinates (4.3), (5.7).
    pub coordinate_rates: Vec<f64>,
    /// The rates of the state's speeds.
    pub accelerations: Vec<f64>,
    /// v̇ as the derivative of `velocities` along the claimed motion.
    pub velocity_rates: Vec<f64>,
    /// v̇ as it is given.
    pub given_rates: Vec<f64>,
    /// M_d (4.10).
    pub mass_matrix: DMatrix<f64>,
    /// h_u* (4.10), (5.6).
    pub forcing: Vec<f64>,
    /// D (k × n).
    pub complement: DMatrix<f64>,
    /// a_u.
    pub complement_bias: Vec<f64>,
    /// What the derivation divides by at this state.
    pub guards: Vec<f64>,
    /// λ.
    pub multipliers: Vec<Multiplier>,
    /// The names of the rows of C.
    pub row_names: Vec<String>,
    /// C (m × n).
    pub constraint_matrix: DMatrix<f64>,
    /// c0*.
    pub constraint_bias: Vec<f64>,
    /// ḟ or φ by name.
    pub velocity_residual: Vec<(String, f64)>,
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
    /// M v, where it is claimed.
    pub momenta: Option<Vec<f64>>,
    /// M v̇ - h* for v̇ as it is given, where it is claimed.
    pub inverse_dynamics: Option<Vec<f64>>,
    /// ½ vᵀ M v.
    pub kinetic_energy: f64,
    /// V.
    pub potential_energy: Option<f64>,
    /// The same state in every chart, the state's own first.
    pub charts: Vec<ChartClaim>,
    /// Outputs by name.
    pub outputs: Vec<(String, f64)>,
    /// The same from the carriers, their rates and λ, where the claim tells these.
    pub carried_outputs: Option<Vec<f64>>,
}

impl Claim {
    /// The k independent accelerations: u̇, or the solution of M_d ν = h_u* where the state holds more speeds than k.
    ///
    /// # Panics
    /// If M_d is singular at this state.
    pub fn independent_accelerations(&self) -> DVector<f64> {
        if self.accelerations.len() == self.complement.nrows() {
            return DVector::from_column_slice(&self.accelerations);
        }
        let forcing = DVector::from_column_slice(&self.forcing);
        if forcing.is_empty() {
            return forcing;
        }
        self.mass_matrix.clone().lu().solve(&forcing).expect("M_d is regular")
    }

    /// v̇ = Dᵀ u̇ + a_u.
    pub fn acceleration(&self) -> DVector<f64> {
        self.complement.transpose() * self.independent_accelerations()
            + DVector::from_column_slice(&self.complement_bias)
    }

    /// The indices of the rows of C that carry a multiplier, each once, with their multipliers.
    pub fn carried_rows(&self) -> Vec<(usize, f64)> {
        let mut taken = vec![false; self.row_names.len()];
        let mut carried = Vec::new();
        for multiplier in &self.multipliers {
            if let Some(row) = multiplier.row.filter(|&row| !std::mem::replace(&mut taken[row], true)) {
                carried.push((row, multiplier.value));
            }
        }
        carried
    }

    /// The rows of C that carry a multiplier, and their multipliers.
    pub fn carried(&self) -> (DMatrix<f64>, DVector<f64>) {
        let carried = self.carried_rows();
        let rows: Vec<usize> = carried.iter().map(|(row, _)| *row).collect();
        let values = carried.iter().map(|(_, value)| *value);
        (self.constraint_matrix.select_rows(&rows), DVector::from_iterator(rows.len(), values))
    }

    /// Cᵀ λ over the rows that carry a multiplier.
    pub fn reaction(&self) -> DVector<f64> {
        let (rows, multipliers) = self.carried();
        rows.transpose() * multipliers
    }
}
