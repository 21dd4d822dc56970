//! What holds for every motion whatever the model is: Gauss' principle, the power of the reactions, any complement gives the motion.

use super::check::Compared;
use super::kkt::{RANK, UNIT, conditioned_rank, roots};
use super::number::{Number, Scaled};
use super::report::Report;
use super::system::lift;
use nalgebra::{DMatrix, DVector};

impl Compared<'_> {
    /// v̇ from the general form (3.5), [C; W D M] v̇ = [−c0*; W D h*], for a regular W of no meaning.
    pub(super) fn any_complement(&self, report: &mut Report) {
        let (claim, n) = (self.claim, self.claim.velocities.len());
        let (m, k) = (claim.constraint_matrix.nrows(), claim.complement.nrows());
        let w = DMatrix::from_fn(k, k, |i, j| f64::from(u8::from(i == j)) + 0.4 * ((3 * i + 5 * j + 1) as f64).sin());
        let d = w * &claim.complement;
        let (dm, dh) = (&d * &claim.inertia, &d * DVector::from_column_slice(&claim.forces));
        let root = roots(&claim.inertia);
        let entry =
            |i: usize, j: usize| (if i < m { claim.constraint_matrix[(i, j)] } else { dm[(i - m, j)] }) / root[j];
        let matrix = DMatrix::from_fn(m + k, n, entry);
        let norms: Vec<f64> = matrix.row_iter().map(|row| row.norm().max(f64::MIN_POSITIVE)).collect();
        let matrix = DMatrix::from_fn(m + k, n, |i, j| matrix[(i, j)] / norms[i]);
        let right =
            DVector::from_fn(m + k, |i, _| (if i < m { -claim.constraint_bias[i] } else { dh[i - m] }) / norms[i]);
        let (rank, condition) = conditioned_rank(&matrix);
        if conditioned_rank(&claim.constraint_matrix).0 + k < n {
            // what a configuration binds without a row of its own is not in C
            return;
        }
        report.fact("[C; W D M] has rank n", rank == n);
        let svd = matrix.clone().svd(true, true);
        let once = |right: &DVector<f64>| svd.solve(right, RANK).expect("both sets of singular vectors");
        let first = once(&right);
        let solution = &first + once(&(&right - &matrix * &first));
        let solution = &solution + once(&(&right - &matrix * &solution));
        let rates = solution.component_div(&root);
        let terms = self.acceleration_error() * condition;
        report.bounded("v̇ by W D", rates.as_slice(), &claim.acceleration(), &terms);
    }

    /// The compulsion (v̇ − M⁻¹ h*)ᵀ M (v̇ − M⁻¹ h*)/2 grows by δᵀ M_d δ/2 from v̇ to v̇ + Dᵀ δ: it is least at v̇.
    pub(super) fn gauss(&self, report: &mut Report) {
        let claim = self.claim;
        let h = DVector::from_column_slice(&claim.forces);
        // massless speeds have no metric of their own
        if (0..claim.inertia.nrows()).any(|i| claim.inertia[(i, i)] == 0.0) {
            return;
        }
        // nor have those that move nothing more than others do: M is only semidefinite
        let eigenvalues = claim.inertia.clone().symmetric_eigenvalues();
        let least = eigenvalues.min() / eigenvalues.max();
        report.fact("M is positive", least > -1e-12);
        let Some(m) = claim.inertia.clone().cholesky().filter(|_| least > 1e-12) else { return };
        let free = m.solve(&h);
        let compulsion = |rates: &DVector<f64>| {
            let away = rates - &free;
            0.5 * away.dot(&(&claim.inertia * &away))
        };
        let v_dot = claim.acceleration();
        let least = compulsion(&v_dot);
        let of_rates = self.acceleration_error();
        for i in 0..claim.complement.nrows() {
            // of the size of what the motion is away from the free one, so that nothing drowns
            let varied = claim.complement.row(i).transpose();
            let part = varied.dot(&(&claim.inertia * &varied));
            let size = ((2.0 * least + UNIT) / part).sqrt();
            let rates = &v_dot + &varied * size;
            let growth = 0.5 * size * size * part;
            let moved = (&claim.inertia * (&rates - &free)).abs().dot(&of_rates);
            let bound =
                2.0 * moved + UNIT * self.chart * (claim.inertia.abs() * (rates.abs() + free.abs())).dot(&rates.abs());
            report.number(&format!("compulsion along D[{i}]"), compulsion(&rates) - least, growth, bound);
        }
    }

    /// vᵀ Cᵀ λ = −ηᵀ λ for rows C v + η = 0: reactions work only where a constraint moves.
    pub(super) fn power(&self, report: &mut Report, error: &DVector<f64>) {
        let (claim, rows) = (self.claim, &self.rows);
        let v = DVector::from_column_slice(&claim.velocities);
        let still = vec![Scaled::zero(); v.len()];
        let (t, x) = (Scaled::constant(claim.t), lift(&claim.coordinates));
        let (mut power, mut bound) = (0.0, v.abs().dot(error));
        for (row, multiplier) in claim.carried_rows() {
            let Some(declared) = rows.names.iter().position(|name| *name == claim.row_names[row]) else { continue };
            let c = claim.constraint_matrix.row(row);
            if !rows.linear[declared] {
                power += multiplier * c.transpose().dot(&v);
                continue;
            }
            let eta = self.system.velocity(declared, t, &x, &still);
            power -= multiplier * eta.value;
            let size = rows.c.row(declared).map(|e| e.size).transpose().dot(&v.abs()) + eta.size;
            bound += UNIT * self.chart * multiplier.abs() * size.max(v.amax() * c.norm());
        }
        report.number("power of the reactions", claim.reaction().dot(&v), power, bound);
    }
}
