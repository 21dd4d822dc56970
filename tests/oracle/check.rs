//! A claim against the oracle.
//!
//! Every comparison has a bound that is computed at that very state, never chosen for a model:
//!
//! * what is only evaluated (A, a0, M, h*, C, c0*, f, φ, energies): `UNIT` times the size of the terms that were added up
//!   (`Scaled`, a first-order running error analysis);
//! * what is solved for (v̇, λ): `UNIT` times the condition of the equilibrated matrix of (2.8) times the size of the data and of
//!   the solution, times κ² where D enters: the reduced mass matrix is D M Dᵀ, and a chart near its singularity costs digits
//!   that the full system does not lose. κ is the condition of D, or of the columns of C that the chart eliminates if larger.

use super::claim::Claim;
use super::condition::{chart_condition, least_norm, null_space};
use super::kkt::{Motion, UNIT, conditioned_rank, roots};
use super::number::{Number, Scaled};
use super::report::Report;
use super::rows::Rows;
use super::system::{Dynamics, System};
use nalgebra::{DMatrix, DVector};

/// Holds a claim against the declared model at the claim's own state.
pub fn check(system: &System<'_>, claim: &Claim) -> Report {
    let (t, x, v) = (claim.t, &claim.coordinates, &claim.velocities);
    let configured = system.model.configuration.is_some();
    let motion = match configured {
        true => system.configured_motion(t, &claim.state_coordinates, &claim.coordinate_rates),
        false => system.motion(t, x, v),
    };
    let dynamics = system.dynamics(t, x, v);
    let rows = system.rows(t, x, v);
    let chart = chart_condition(system, claim, &dynamics, &rows);
    let mut state = Compared { system, claim, motion, dynamics, rows, chart };
    if let Some(list) = system.model.charts.first() {
        // with combinations for speeds there is no unit block to judge by
        state.chart = state.chart.max(state.condition_of(list, &claim.guards));
    }
    let mut report = Report::default();
    state.evaluated(&mut report);
    state.declared_rows(&mut report);
    state.state(&mut report);
    state.reduced(&mut report);
    state.accelerations(&mut report);
    state.reactions(&mut report);
    state.any_complement(&mut report);
    state.gauss(&mut report);
    state.charts(&mut report);
    state.outputs(&mut report);
    report
}

/// A claim beside what the oracle says.
pub(super) struct Compared<'a> {
    pub(super) system: &'a System<'a>,
    pub(super) claim: &'a Claim,
    pub(super) motion: Motion,
    pub(super) dynamics: Dynamics,
    pub(super) rows: Rows,
    pub(super) chart: f64,
}

impl Compared<'_> {
    /// What is declared and only evaluated.
    fn evaluated(&self, report: &mut Report) {
        let (claim, dynamics) = (self.claim, &self.dynamics);
        report.matrix("A", &claim.kinematic_matrix, &dynamics.a);
        report.vector("a0", &claim.kinematic_bias, &dynamics.a0);
        report.matrix("M", &claim.inertia, &dynamics.m);
        report.vector("h*", &claim.forces, &dynamics.h);
        let along = |values: &[f64]| -> DVector<Scaled> {
            DVector::from_fn(values.len(), |i, _| {
                let products = values.iter().enumerate().map(|(j, v)| (dynamics.m[(i, j)], *v));
                products.fold(Scaled { value: 0.0, size: 0.0 }, |sum, (m, v)| Scaled {
                    value: sum.value + m.value * v,
                    size: sum.size + m.size * v.abs(),
                })
            })
        };
        if let Some(momenta) = &claim.momenta {
            report.vector("M v", momenta, &along(&claim.velocities));
        }
        if let Some(needed) = &claim.inverse_dynamics {
            let less = |m: Scaled, h: Scaled| Scaled { value: m.value - h.value, size: m.size + h.size };
            report.vector("M v̇ - h*", needed, &along(&claim.given_rates).zip_map(&dynamics.h, less));
        }
        let kinetic = dynamics.kinetic;
        report.number("kinetic energy", claim.kinetic_energy, kinetic.value, UNIT * kinetic.size);
        // bodies without gravity and springs may as well have V = 0
        let needless = dynamics.bodies.is_some() && dynamics.potential.is_none() && claim.potential_energy == Some(0.0);
        let both = claim.potential_energy.is_some() == dynamics.potential.is_some();
        report.fact("potential energy present", both || needless);
        if let (Some(claimed), Some(expected)) = (claim.potential_energy, dynamics.potential) {
            report.number("potential energy", claimed, expected.value, UNIT * expected.size);
        }
    }

    /// C, c0* and the residuals, row by row by name.
    fn declared_rows(&self, report: &mut Report) {
        let (claim, rows) = (self.claim, &self.rows);
        report.fact("C has a row for each name", claim.constraint_matrix.nrows() == claim.row_names.len());
        for (i, name) in claim.row_names.iter().enumerate() {
            let Some(j) = rows.names.iter().position(|n| n == name) else {
                report.fact(&format!("row {name} was declared"), false);
                continue;
            };
            let row = claim.constraint_matrix.rows(i, 1).into_owned();
            report.matrix(&format!("C {name}"), &row, &rows.c.rows(j, 1).into_owned());
            let bias = rows.c0[j];
            report.number(&format!("c0* {name}"), claim.constraint_bias[i], bias.value, UNIT * bias.size);
        }
        let named = |list: &[(String, f64)], name: &str| list.iter().find(|(n, _)| n == name).map(|(_, value)| *value);
        for (name, f) in &rows.position {
            let claimed = named(&claim.position_residual, name);
            report.fact(&format!("residual of {name} is given"), claimed.is_some());
            report.number(&format!("f {name}"), claimed.unwrap_or(f64::NAN), f.value, UNIT * f.size);
        }
        for (name, residual) in rows.velocity.iter().filter(|(name, _)| claim.row_names.contains(name)) {
            let claimed = named(&claim.velocity_residual, name);
            report.fact(&format!("velocity residual of {name} is given"), claimed.is_some());
            let what = format!("velocity residual {name}");
            report.number(&what, claimed.unwrap_or(f64::NAN), residual.value, UNIT * residual.size);
        }
        let count = claim.velocity_residual.len();
        report.fact("velocity residuals of other rows", count <= rows.velocity.len());
    }

    /// x and v of the state satisfy what was declared, and u is what its name says.
    fn state(&self, report: &mut Report) {
        let (claim, system) = (self.claim, self.system);
        let lift = |values: &[f64]| values.iter().map(|&x| Scaled::constant(x)).collect::<Vec<_>>();
        let t = Scaled::constant(claim.t);
        let (q, qdot) = (lift(&claim.state_coordinates), lift(&claim.coordinate_rates));
        report.vector("x", &claim.coordinates, &DVector::from_vec(system.coordinates(t, &q)));
        // the rates come from v by A, or v from the rates by A⁻¹: whichever is declared loses nothing
        let velocities = DVector::from_vec(system.velocities_of(t, &q, &qdot));
        let size = velocities.iter().fold(0.0_f64, |size, e| size.max(e.size));
        let bound = DVector::from_element(velocities.len(), UNIT * self.chart * size);
        report.bounded("v", &claim.velocities, &velocities.map(|e| e.value), &bound);
        let speeds = self.motion.speeds;
        report.fact(&format!("{} speeds instead of {speeds}", claim.speeds.len()), claim.speeds.len() == speeds);
        for (name, residual) in &self.rows.velocity {
            report.number(&format!("{name} at velocity level"), 0.0, residual.value, UNIT * self.chart * residual.size);
        }
        let quasi = system.model.configuration.as_ref().map_or(&[][..], |given| &given.speeds);
        // where the state holds all of them
        let held = quasi.iter().all(|name| claim.speed_names.contains(name));
        let said = held.then(|| system.quasi(t, &q, &qdot, &claim.speed_names, &lift(&claim.speeds)));
        for (said, left, right) in said.into_iter().flatten() {
            let size = UNIT * self.chart * left.size.max(right.size).max(size);
            report.number(&format!("(4.3) {said}"), left.value, right.value, size);
        }
        for (name, u) in claim.speed_names.iter().zip(&claim.speeds) {
            let named = |names: &[String]| names.iter().position(|n| n == name || format!("dot_{n}") == *name);
            let value = match (named(&system.model.speeds), named(system.model.state_coordinates())) {
                (Some(i), _) => claim.velocities[i],
                (_, Some(i)) => claim.coordinate_rates[i],
                _ => continue,
            };
            report.number(&format!("u {name}"), value, *u, UNIT * self.chart * size.max(u.abs()));
        }
    }

    /// D Cᵀ = 0 (3.1), C a_u = −c0*, M_d and h_u* (4.10), M_d u̇ = h_u*.
    fn reduced(&self, report: &mut Report) {
        let (claim, dynamics, rows, motion) = (self.claim, &self.dynamics, &self.rows, &self.motion);
        let d = &claim.complement;
        let k = d.nrows();
        report.fact(&format!("k = {k} instead of {}", motion.freedom), k == motion.freedom);
        report.fact("D has rank k", conditioned_rank(d).0 == k);
        let unit = UNIT * self.chart;
        // D is known to rounding of the largest entry of each row
        let d_size = row_sizes(&d.abs());
        let (c, c_size) = (rows.c.map(|e| e.value), rows.c.map(|e| e.size));
        let (product, sizes) = (d * c.transpose(), &d_size * c_size.transpose());
        for (i, (entry, size)) in product.iter().zip(sizes.iter()).enumerate() {
            report.number(&format!("D Cᵀ [{i}]"), *entry, 0.0, unit * size);
        }
        let a_u = DVector::from_column_slice(&claim.complement_bias);
        // a_u solves C a_u = −c0*, and is known to rounding of all that it solves
        let solved = (0..c.nrows()).map(|i| rows.c0[i].size / c.row(i).norm().max(f64::MIN_POSITIVE));
        let a_u_size = DVector::from_element(a_u.len(), solved.fold(a_u.amax(), f64::max));
        let bias_size = &c_size * &a_u_size + rows.c0.map(|e| e.size);
        report.bounded(
            "C a_u",
            (&c * &a_u).as_slice(),
            &-rows.c0.map(|e| e.value),
            &(&bias_size * (unit * self.chart)),
        );
        let (m, m_size) = (dynamics.m.map(|e| e.value), dynamics.m.map(|e| e.size));
        let (h, h_size) = (dynamics.h.map(|e| e.value), dynamics.h.map(|e| e.size));
        let (reduced, reduced_size) = (d * &m * d.transpose(), &d_size * &m_size * d_size.transpose());
        for (i, (claimed, expected)) in claim.mass_matrix.iter().zip(reduced.iter()).enumerate() {
            report.number(&format!("M_d [{i}]"), *claimed, *expected, unit * reduced_size[i]);
        }
        let forcing_size = &d_size * (h_size + m_size * &a_u_size) * (unit * self.chart);
        report.bounded("h_u*", &claim.forcing, &(d * (h - m * &a_u)), &forcing_size);
        let u_dot = claim.independent_accelerations();
        let balance = &claim.mass_matrix * &u_dot;
        let balance_size = (claim.mass_matrix.abs() * u_dot.abs()) * (unit * self.chart) + forcing_size;
        report.bounded("M_d u̇", balance.as_slice(), &DVector::from_column_slice(&claim.forcing), &balance_size);
    }

    /// What rounding may do to v̇: in solving for it, and in adding Dᵀ u̇ and a_u.
    pub(super) fn acceleration_error(&self) -> DVector<f64> {
        let claim = self.claim;
        let terms = claim.complement.abs().transpose() * claim.independent_accelerations().abs();
        let terms = terms + DVector::from_column_slice(&claim.complement_bias).abs();
        &self.motion.acceleration_error * self.chart.powi(2) + terms * (UNIT * self.chart)
    }

    /// v̇ = Dᵀ u̇ + a_u is the solution of (2.8), v̇ along the motion of the state is the same, and C v̇ + c0* = 0.
    fn accelerations(&self, report: &mut Report) {
        let (claim, motion, rows) = (self.claim, &self.motion, &self.rows);
        let error = self.acceleration_error();
        let claimed = claim.acceleration();
        report.bounded("v̇", claimed.as_slice(), &motion.acceleration, &error);
        // differentiated through the elimination: a pivot stands in the denominator once more
        report.bounded("v̇ along the motion", &claim.velocity_rates, &motion.acceleration, &(&error * self.chart));
        report.bounded("v̇ as given", &claim.given_rates, &motion.acceleration, &error);
        let kept = rows.c.map(|e| e.value) * &claimed + rows.c0.map(|e| e.value);
        let size = rows.c.map(|e| e.size);
        let bound = (&size * claimed.abs() + rows.c0.map(|e| e.size)) * UNIT + &size * &error;
        report.bounded("C v̇ + c0*", kept.as_slice(), &DVector::zeros(kept.len()), &bound);
    }

    /// Cᵀ λ = M v̇ − h*; its power along v; Gauss' principle: M v̇ − h* does no work on any admissible variation.
    fn reactions(&self, report: &mut Report) {
        let (claim, motion) = (self.claim, &self.motion);
        let error = self.reaction_error();
        let total = self.dynamics.m.map(|e| e.value) * claim.acceleration() - self.dynamics.h.map(|e| e.value);
        report.bounded("M v̇ − h*", total.as_slice(), &motion.reaction, &error);
        // λ follows from the eliminated columns alone, and the others amplify what is wrong there once more
        let error = error * self.chart;
        let reaction = claim.reaction();
        let partial = self.system.partial_velocities(claim.t, &claim.state_coordinates, &claim.coordinate_rates).0;
        let partial = partial.map(|e| e.value);
        if self.reactions_are_known() {
            report.bounded("Cᵀ λ", reaction.as_slice(), &motion.reaction, &error);
            self.power(report, &error);
            let (expected, bound) = self.multipliers();
            report.bounded("λ", claim.carried().1.as_slice(), &expected, &bound);
        } else {
            // the configuration binds more than the declared rows do: λ is known only as far as it acts on q
            let acting = partial.transpose() * &reaction;
            let bound = partial.abs().transpose() * &error;
            report.bounded("Dᵀ-part of Cᵀ λ", acting.as_slice(), &(partial.transpose() * &motion.reaction), &bound);
        }
        let bound_rows = self.rows.c.map(|e| e.value) * &partial;
        for variation in null_space(&bound_rows) {
            let variation = &partial * variation;
            let bound = variation.abs().dot(&error);
            report.number("work on an admissible variation", variation.dot(&total), 0.0, bound);
        }
    }
}

impl Compared<'_> {
    /// What rounding may do to M v̇ − h*.
    fn reaction_error(&self) -> DVector<f64> {
        let of_rates = self.dynamics.m.map(|e| e.size) * self.acceleration_error();
        &self.motion.reaction_error * self.chart.powi(2) + of_rates
    }

    /// Whether the declared rows bind all that is bound; otherwise a configuration binds more.
    pub(super) fn reactions_are_known(&self) -> bool {
        let rows = conditioned_rank(&self.claim.constraint_matrix).0;
        rows + self.motion.freedom == self.system.model.n()
    }

    /// λ is what the reactions leave of it: the one of minimum norm where rows depend on each other.
    ///
    /// One entry for each carried row, with the bound of its error.
    pub(super) fn multipliers(&self) -> (DVector<f64>, DVector<f64>) {
        let error = self.reaction_error() * self.chart;
        let (rows, _) = self.claim.carried();
        if rows.is_empty() {
            return (DVector::zeros(0), DVector::zeros(0));
        }
        // the rank is judged for rows and speeds at their own scales, the norm is that of λ as declared
        let root = roots(&self.dynamics.m.map(|e| e.value));
        let scaled = DMatrix::from_fn(rows.nrows(), rows.ncols(), |i, j| rows[(i, j)] / root[j]);
        let inverse = least_norm(&scaled);
        // refinement stays in the space of the least norm
        let reaction = self.motion.reaction.component_div(&root);
        let first = &inverse * &reaction;
        let expected = &first + &inverse * (&reaction - scaled.transpose() * &first);
        let bound = inverse.abs() * error.component_div(&root);
        // C is known to rounding of its terms, and so is the inverse
        let size = DMatrix::from_fn(self.rows.c.nrows(), root.len(), |i, j| self.rows.c[(i, j)].size / root[j]);
        let gain = UNIT * self.chart * size.norm() * inverse.norm();
        let bound = bound.map(|e| e + gain * expected.norm());
        (expected, bound)
    }
}

/// Every entry replaced by the largest of its row.
fn row_sizes(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, _| matrix.row(i).amax())
}
