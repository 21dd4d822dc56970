//! Successive projections: bodies → coordinates → constraints.
//!
//! A projection v = Dᵀ u + v_p, v̇ = Dᵀ u̇ + a of M v̇ = h* gives M_d u̇ = h_u*, which is a system (2.3) again: the rows that
//! are still open are rewritten, C Dᵀ u̇ + (C a + c0*) = 0, and the next projection goes on from there.
//!
//! Reactions do not chain like that. A row that a later stage eliminates pulls on the rows of the earlier ones, through the
//! direction that it has in the *initial* space: its row written in the stage's own velocities has lost that. So all rows stand
//! in the initial system, and all multipliers are computed once, from M v̇ − h* = Cᵀ λ there. (3.6) with a stage's h* alone
//! gives the reaction of the system *without* the later stages, as (6.19) does; it is here as
//! [`natural_multipliers`](Stages::natural_multipliers).

use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector};

use super::{InitialEquations, NullSpace, NullSpaceMethod, shape};
use crate::Error;

/// D Cᵀ = 0 and C a + c0* = 0 hold if they are met to this fraction of the norms of their factors.
const TANGENT: f64 = 1e-9;

/// A system under successive projections; from [`InitialEquations::stages`].
///
/// ```
/// # mod models { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/pendulum.rs")); }
/// # use models::{Pendulum, PendulumState};
/// use holonomy::forms::NullSpaceMethod;
/// use holonomy::prelude::*;
/// use nalgebra::{DMatrix, DVector};
///
/// let pendulum = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare()?;
/// let mut full = pendulum.initial_equations_at(0.0, &PendulumState { x: 0.3, y: -0.4, dot_x: 0.0 }, &[]);
/// // A second constraint stops the pendulum: ẍ = 0.
/// full.rows.push("stop");
/// full.constraint_matrix = DMatrix::from_row_slice(2, 2, &[0.3, -0.4, 1.0, 0.0]);
/// full.constraint_bias = DVector::from_vec(vec![0.0, 0.0]);
///
/// let stages = full.stages().project_by(&["rod"], NullSpaceMethod::Lu)?.project_by(&["stop"], NullSpaceMethod::Lu)?;
/// assert!(stages.rates()?.amax() < 1e-15);
/// // Held fast, the rod carries −0.4 λ = m g: the weight. Alone it would swing, and carry less.
/// let weight = 2.0 * 9.81;
/// assert!((stages.multipliers()?[0] * -0.4 - weight).abs() < 1e-12);
/// assert!((stages.natural_multipliers(0)?[0] * -0.4 - weight * 0.64).abs() < 1e-12);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Stages {
    initial: InitialEquations,
    done: Vec<Done>,
    system: InitialEquations,
}

/// A projection that was made.
#[derive(Clone, Debug)]
struct Done {
    /// The system before, with the rows that were eliminated and no others.
    before: InitialEquations,
    complement: DMatrix<f64>,
    bias: DVector<f64>,
}

impl InitialEquations {
    /// The start of successive projections: no stage yet, all rows open.
    pub fn stages(&self) -> Stages {
        Stages { initial: self.clone(), done: Vec::new(), system: self.clone() }
    }

    /// The same system with these rows only, in this order.
    pub fn with_rows(&self, rows: &[&str]) -> Result<Self, Error> {
        let unknown = |name: &&str| Error::UnknownName { name: (*name).into(), known: self.rows.clone() };
        let find = |name: &&str| self.rows.iter().position(|row| row == name).ok_or_else(|| unknown(name));
        let picked: Vec<usize> = rows.iter().map(find).collect::<Result<_, _>>()?;
        Ok(self.with_picked_rows(&picked))
    }

    pub(super) fn with_picked_rows(&self, picked: &[usize]) -> Self {
        InitialEquations {
            rows: picked.iter().map(|row| self.rows[*row]).collect(),
            constraint_matrix: self.constraint_matrix.select_rows(picked),
            constraint_bias: self.constraint_bias.select_rows(picked),
            ..self.clone()
        }
    }

    /// The system in u that v = Dᵀ u + v_p, v̇ = Dᵀ u̇ + a makes of this one (4.10), (5.6), (5.7), its rows rewritten.
    ///
    /// u is that of (5.2), M_d u = D M v, and v_p the rest of v, orthogonal to the tangent space in the metric M.
    pub fn reduced(&self, complement: &DMatrix<f64>, bias: &DVector<f64>) -> Result<Self, Error> {
        let n = self.forces.len();
        shape("D", (complement.nrows(), n), complement.shape())?;
        shape("a", (n, 1), (bias.len(), 1))?;
        let speeds = self.tangent_solve(complement, complement * &self.inertia * &self.velocities)?;
        let rest = &self.velocities - complement.tr_mul(&speeds);
        Ok(InitialEquations {
            rows: self.rows.clone(),
            velocities: speeds,
            kinematic_matrix: &self.kinematic_matrix * complement.transpose(),
            kinematic_bias: &self.kinematic_bias + &self.kinematic_matrix * rest,
            inertia: complement * &self.inertia * complement.transpose(),
            forces: complement * (&self.forces - &self.inertia * bias),
            constraint_matrix: &self.constraint_matrix * complement.transpose(),
            constraint_bias: &self.constraint_matrix * bias + &self.constraint_bias,
        })
    }

    /// D and a must satisfy the rows: D Cᵀ = 0 (3.1), C a + c0* = 0.
    fn check_tangent(&self, complement: &DMatrix<f64>, bias: &DVector<f64>) -> Result<(), Error> {
        let null = NullSpace::new(&self.constraint_matrix, NullSpaceMethod::Qr)?;
        shape("D", (null.complement.nrows(), self.forces.len()), complement.shape())?;
        shape("a", (self.forces.len(), 1), (bias.len(), 1))?;
        let (c, size) = (&self.constraint_matrix, bias.norm());
        let (products, remains) = (c * complement.transpose(), c * bias + &self.constraint_bias);
        for (row, constraint) in self.rows.iter().enumerate() {
            let norm = c.row(row).norm();
            let products = (0..complement.nrows()).map(|j| (products[(row, j)], norm * complement.row(j).norm()));
            for (value, size) in products.chain([(remains[row], norm * size + self.constraint_bias[row].abs())]) {
                if value.is_nan() || value.abs() > TANGENT * size {
                    return Err(Error::NotTangent { constraint, value });
                }
            }
        }
        Ok(())
    }
}

impl Stages {
    /// The next stage: eliminates rows by a D with D Cᵀ = 0 and an a with C a + c0* = 0, both in the velocities of the system
    /// as it is now.
    ///
    /// For a model with `configuration`, D and a are `complement` and `complement_bias`.
    pub fn project(mut self, rows: &[&str], complement: &DMatrix<f64>, bias: &DVector<f64>) -> Result<Self, Error> {
        let before = self.system.with_rows(rows)?;
        before.check_tangent(complement, bias)?;
        let open: Vec<&str> = self.system.rows.iter().copied().filter(|row| !rows.contains(row)).collect();
        self.system = self.system.with_rows(&open)?.reduced(complement, bias)?;
        self.done.push(Done { before, complement: complement.clone(), bias: bias.clone() });
        Ok(self)
    }

    /// The next stage with D and a from the null space of the rows.
    pub fn project_by(self, rows: &[&str], method: NullSpaceMethod) -> Result<Self, Error> {
        let before = self.system.with_rows(rows)?;
        let (null, bias, _) = before.tangent(method)?;
        self.project(rows, &null.complement, &bias)
    }

    /// The system after the stages so far: a system (2.3) in the speeds of the last one, with the rows that are still open.
    pub fn system(&self) -> &InitialEquations {
        &self.system
    }

    /// D of all stages together, the product of theirs: v̇ = Dᵀ u̇ + a in the initial space.
    pub fn complement(&self) -> DMatrix<f64> {
        let n = self.initial.forces.len();
        self.done.iter().fold(DMatrix::identity(n, n), |product, stage| &stage.complement * product)
    }

    /// a of all stages together.
    pub fn bias(&self) -> DVector<f64> {
        self.lifted(DVector::zeros(self.system.forces.len()))
    }

    /// v̇ in the initial space. Rows that are still open bind it too.
    pub fn rates(&self) -> Result<DVector<f64>, Error> {
        Ok(self.lifted(self.system.solve_by(NullSpaceMethod::Qr)?.0))
    }

    /// λ of all rows of the initial system, in its order; every stage acts.
    pub fn multipliers(&self) -> Result<DVector<f64>, Error> {
        self.initial.multipliers_of(&self.rates()?)
    }

    /// λ of the rows that a stage eliminated, as they would be if no later stage were there: (3.6) with the h* of that stage,
    /// which is what (6.19) is. The true reaction is in [`multipliers`](Self::multipliers); the two agree only where the later
    /// reactions do not pull on these rows (C M⁻¹ of one row times the other vanishes).
    ///
    /// Stages count from zero; [`Error::Shape`] beyond the last.
    pub fn natural_multipliers(&self, stage: usize) -> Result<DVector<f64>, Error> {
        let beyond = Error::Shape { matrix: "the list of stages", needed: (stage + 1, 1), given: (self.done.len(), 1) };
        Ok(self.done.get(stage).ok_or(beyond)?.before.solve_by(NullSpaceMethod::Qr)?.1)
    }

    /// u̇ of the last stage → v̇ of the initial system.
    fn lifted(&self, accelerations: DVector<f64>) -> DVector<f64> {
        let up = |rates: DVector<f64>, stage: &Done| stage.complement.tr_mul(&rates) + &stage.bias;
        self.done.iter().rev().fold(accelerations, up)
    }
}
