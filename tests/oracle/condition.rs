//! How much a chart amplifies rounding, and what a matrix sends to zero.

use super::claim::Claim;
use super::kkt::{RANK, conditioned_rank, roots};
use super::rows::Rows;
use super::system::{Dynamics, System};
use nalgebra::{DMatrix, DVector};

/// The matrix P with λ = P r the solution of Cᵀ λ = r of least norm, for any rank of C.
///
/// With the independent rows C_b and C = W C_b: μ = (C_b C_bᵀ)⁻¹ C_b r, and λ = W (Wᵀ W)⁻¹ μ. Rows are picked by what is left of
/// them beside those picked before, the longest first.
pub fn least_norm(c: &DMatrix<f64>) -> DMatrix<f64> {
    let mut left = c.clone();
    let longest = c.row_iter().map(|row| row.norm()).fold(0.0_f64, f64::max);
    let mut picked = Vec::new();
    while picked.len() < c.nrows().min(c.ncols()) {
        let norms: Vec<f64> = left.row_iter().map(|row| row.norm()).collect();
        let next = (0..norms.len()).max_by(|a, b| norms[*a].total_cmp(&norms[*b])).expect("a row");
        if norms[next] <= RANK * longest {
            break;
        }
        picked.push(next);
        let direction = left.row(next) / norms[next];
        for mut row in left.row_iter_mut() {
            let along = row.dot(&direction);
            row -= &direction * along;
        }
    }
    let base = c.select_rows(&picked);
    let gram = (&base * base.transpose()).cholesky().expect("the rows are independent");
    let of_base = gram.solve(&base);
    let w = c * of_base.transpose();
    let inner = (w.transpose() * &w).cholesky().expect("W holds the unit rows");
    &w * inner.solve(&of_base)
}

/// The condition of D, or of the columns of C that the chart eliminates if larger; speeds at the scale of their inertia.
///
/// Elimination row by row may meet a pivot that is small although the whole block is well conditioned: what it amplifies is the
/// entries of C over the smallest guard.
///
/// The eliminated columns are those outside the unit block of D for all rows, and those whose speeds the state does not hold for
/// the rows that bind v linearly.
pub fn chart_condition(system: &System<'_>, claim: &Claim, dynamics: &Dynamics, rows: &Rows) -> f64 {
    let n = system.model.n();
    let root = roots(&dynamics.m.map(|e| e.value));
    let entries = rows.c.iter().fold(1.0_f64, |size, e| size.max(e.value.abs()));
    let growth = claim.guards.iter().fold(1.0_f64, |growth, guard| growth.max(entries / guard.abs()));
    let d = DMatrix::from_fn(claim.complement.nrows(), n, |i, j| claim.complement[(i, j)] * root[j]);
    let of_d = conditioned_rank(&unit_rows(&d)).1;
    if system.model.configuration.is_some() {
        return of_d.max(growth);
    }
    let c = DMatrix::from_fn(rows.names.len(), n, |i, j| rows.c[(i, j)].value / root[j]);
    let of_columns = |rows: &DMatrix<f64>, free: &dyn Fn(usize) -> bool, count: usize| {
        let eliminated: Vec<usize> = (0..n).filter(|&j| !free(j)).collect();
        // without a unit block there is no elimination
        if eliminated.len() + count == n {
            conditioned_rank(&unit_rows(rows).select_columns(&eliminated)).1
        } else {
            1.0
        }
    };
    let block = unit_columns(&claim.complement);
    let linear: Vec<usize> = (0..rows.names.len()).filter(|&i| rows.linear[i]).collect();
    let held = |j: usize| claim.speed_names.contains(&system.model.speeds[j]);
    let of_all = of_columns(&c, &|j| block.contains(&j), claim.complement.nrows());
    let of_linear = of_columns(&c.select_rows(&linear), &held, claim.speeds.len());
    of_d.max(of_all).max(of_linear).max(growth)
}

/// The columns that are unit vectors, one for each row that has one.
fn unit_columns(d: &DMatrix<f64>) -> Vec<usize> {
    let is_unit = |i: usize, j: usize| (0..d.nrows()).all(|r| d[(r, j)] == f64::from(u8::from(r == i)));
    (0..d.nrows()).filter_map(|i| (0..d.ncols()).find(|&j| is_unit(i, j))).collect()
}

fn unit_rows(m: &DMatrix<f64>) -> DMatrix<f64> {
    let norms: Vec<f64> = m.row_iter().map(|row| row.norm()).collect();
    DMatrix::from_fn(m.nrows(), m.ncols(), |i, j| m[(i, j)] / norms[i].max(f64::MIN_POSITIVE))
}

/// A basis of the vectors that a matrix sends to zero.
pub fn null_space(matrix: &DMatrix<f64>) -> Vec<DVector<f64>> {
    let n = matrix.ncols();
    let square =
        DMatrix::from_fn(matrix.nrows().max(n), n, |i, j| if i < matrix.nrows() { matrix[(i, j)] } else { 0.0 });
    let rank = conditioned_rank(matrix).0;
    let svd = square.svd(false, true);
    let right = svd.v_t.expect("right singular vectors were asked for");
    (rank..n).map(|i| right.row(i).transpose()).collect()
}
