//! The motion by the full system (2.8): no complement, no elimination, only dense algebra.

use super::declaration::Level;
use super::number::{Number, Scaled};
use super::rows::Rows;
use super::system::{Dynamics, System};
use nalgebra::{DMatrix, DVector};

/// What a relative error of one unit in the data can do to a result is multiplied by this: 450 roundings of f64.
pub const UNIT: f64 = 1e-13;

/// A direction whose singular value is this small beside the largest one is no direction: rows that depend on each other.
pub const RANK: f64 = 1e-9;

/// v̇ and the reactions, with the errors that rounding may make in them.
pub struct Motion {
    /// v̇.
    pub acceleration: DVector<f64>,
    /// q̈, with a configuration.
    pub second_rates: DVector<f64>,
    /// M v̇ − h*: all reactions together, Cᵀ λ.
    pub reaction: DVector<f64>,
    /// λ, one per declared row; of minimum norm (rows taken with unit norm) where they depend on each other. Empty with a configuration.
    pub multipliers: DVector<f64>,
    /// k: how many accelerations are free.
    pub freedom: usize,
    /// How many speeds the state holds: only rows that are linear in v are taken out of it.
    pub speeds: usize,
    /// Condition of the equilibrated matrix of (2.8).
    pub condition: f64,
    /// Error bound of each q̈.
    pub second_rate_errors: DVector<f64>,
    /// Error bound of each v̇.
    pub acceleration_error: DVector<f64>,
    /// Error bound of each entry of the reaction.
    pub reaction_error: DVector<f64>,
}

/// x = g(q, t) beside the rows: v̇ = Dᵀ q̈ + a_u, with Dᵀ (n × p) and a_u.
type Partial = Option<(DMatrix<Scaled>, DVector<Scaled>)>;

impl System<'_> {
    /// The motion at x, v.
    pub fn motion(&self, t: f64, x: &[f64], v: &[f64]) -> Motion {
        solve(&self.dynamics(t, x, v), &self.rows(t, x, v), &None, self.model.gives_velocities)
    }

    /// The motion at the state's coordinates and their rates, where x = g(q, t) holds beside the rows.
    ///
    /// Nothing is eliminated here either: v̇ and q̈ are unknowns side by side, and v̇ = Dᵀ q̈ + a_u stands among the rows.
    pub fn configured_motion(&self, t: f64, q: &[f64], qdot: &[f64]) -> Motion {
        let x = self.coordinates(t, q);
        let v = self.velocities_of(t, q, qdot);
        let partial = Some(self.partial_velocities(t, q, qdot));
        solve(&self.dynamics(t, &x, &v), &self.rows(t, &x, &v), &partial, self.model.gives_velocities)
    }
}

/// `given`: the state's speeds satisfy every velocity row, nonlinear ones as well.
fn solve(dynamics: &Dynamics, rows: &Rows, partial: &Partial, given: bool) -> Motion {
    let (n, m) = (dynamics.h.len(), rows.c0.len());
    let p = partial.as_ref().map_or(0, |(d, _)| d.ncols());
    let bodies = dynamics.bodies.as_ref();
    let w = bodies.map_or(0, |bodies| bodies.force.len());
    let links = w + if partial.is_some() { n } else { 0 };
    let zero = Scaled { value: 0.0, size: 0.0 };

    // unknowns: ẇ of the bodies (w), v̇ (n), q̈ (p); rows: the declared ones (m), then ẇ − J v̇ = γ, then v̇ − Dᵀ q̈ = a_u
    let own = (&dynamics.m, &dynamics.h);
    let of_speeds = bodies.map_or(own, |bodies| (&bodies.inertia_of_speeds, &bodies.force_of_speeds));
    let inertia = |i: usize, j: usize| match (bodies, i.checked_sub(w), j.checked_sub(w)) {
        (Some(bodies), None, None) => bodies.mass[(i, j)],
        (_, Some(i), Some(j)) if i < n && j < n => of_speeds.0[(i, j)],
        _ => zero,
    };
    let force = |i: usize| match (bodies, i.checked_sub(w)) {
        (Some(bodies), None) => bodies.force[i],
        (_, Some(i)) if i < n => of_speeds.1[i],
        _ => zero,
    };
    let unit = |holds: bool| Scaled::constant(f64::from(u8::from(holds)));
    let row = |i: usize, j: usize| match (bodies, partial) {
        _ if i < m => j.checked_sub(w).filter(|j| *j < n).map_or(zero, |j| rows.c[(i, j)]),
        (Some(bodies), _) if i < m + w => match j.checked_sub(w) {
            Some(j) if j < n => -bodies.jacobian[(i - m, j)],
            _ => unit(i - m == j),
        },
        (_, Some((d, _))) if j >= w + n => -d[(i - m - w, j - w - n)],
        _ => unit(i - m == j),
    };
    let bias = |i: usize| match (bodies, partial) {
        _ if i < m => rows.c0[i],
        (Some(bodies), _) if i < m + w => -bodies.bias[i - m],
        (_, Some((_, a_u))) => -a_u[i - m - w],
        _ => zero,
    };

    // equilibrated: unit diagonal of M, partial velocities of unit size, rows of unit norm
    let unknowns = w + n + p;
    let mut scale = DVector::from_element(unknowns, 1.0);
    bodies.iter().flat_map(|bodies| bodies.scale.iter()).enumerate().for_each(|(i, unit)| scale[i] = *unit);
    roots(&dynamics.m.map(|e| e.value)).iter().enumerate().for_each(|(i, root)| scale[w + i] = 1.0 / root);
    for j in 0..p {
        let column: f64 = (0..n).map(|i| (row(m + w + i, w + n + j).value / scale[w + i]).powi(2)).sum();
        scale[w + n + j] = 1.0 / column.sqrt().max(f64::MIN_POSITIVE);
    }
    let size = unknowns + m + links;
    let row_scale = DVector::from_fn(m + links, |i, _| {
        let norm: f64 = (0..unknowns).map(|j| (row(i, j).value * scale[j]).powi(2)).sum();
        if norm > 0.0 { 1.0 / norm.sqrt() } else { 1.0 }
    });
    let entry = |i: usize, j: usize| match (i < unknowns, j < unknowns) {
        (true, true) => (inertia(i, j), scale[i] * scale[j]),
        (true, false) => (-row(j - unknowns, i), scale[i] * row_scale[j - unknowns]),
        (false, true) => (row(i - unknowns, j), row_scale[i - unknowns] * scale[j]),
        (false, false) => (zero, 0.0),
    };
    let right = |i: usize| match i < unknowns {
        true => (force(i), scale[i]),
        false => (-bias(i - unknowns), row_scale[i - unknowns]),
    };
    let matrix = DMatrix::from_fn(size, size, |i, j| entry(i, j).0.value * entry(i, j).1);
    let matrix_size = DMatrix::from_fn(size, size, |i, j| entry(i, j).0.size * entry(i, j).1);
    let vector = DVector::from_fn(size, |i, _| right(i).0.value * right(i).1);
    let vector_size = DVector::from_fn(size, |i, _| right(i).0.size * right(i).1);

    // bodies follow the speeds whatever the rows are: their own links are independent of each other and of all rows
    let of_bodies = |i: &usize| (m..m + w).contains(i);
    let of_rows: Vec<usize> = (0..m + links).filter(|i| !of_bodies(i)).collect();
    let constraint = matrix.view((unknowns, w), (m + links, unknowns - w)).into_owned();
    let (rank, _) = conditioned_rank(&constraint.select_rows(&of_rows));
    let by_the_state = |i: usize| rows.linear[i] || (given && rows.levels[i] == Level::Velocity);
    let binding: Vec<usize> = of_rows.iter().copied().filter(|&i| i >= m || by_the_state(i)).collect();
    let (velocity_rank, _) = conditioned_rank(&constraint.select_rows(&binding));
    let (solution, condition) = match rank == of_rows.len() {
        true if w > 0 => solve_regular(&matrix, &vector),
        regular => solve_dense(&matrix, &vector, regular),
    };
    let error = UNIT * condition * (matrix_size.norm() * solution.norm() + vector_size.norm()) / matrix.norm();

    let acceleration = DVector::from_fn(n, |i, _| solution[w + i] * scale[w + i]);
    let value = dynamics.m.map(|e| e.value);
    let force_value = dynamics.h.map(|e| e.value);
    Motion {
        reaction: value * &acceleration - force_value,
        multipliers: DVector::from_fn(if partial.is_none() { m } else { 0 }, |i, _| {
            solution[unknowns + i] * row_scale[i]
        }),
        second_rates: DVector::from_fn(p, |j, _| solution[w + n + j] * scale[w + n + j]),
        freedom: n + p - rank,
        speeds: n + p - velocity_rank,
        condition,
        second_rate_errors: DVector::from_fn(p, |i, _| error * scale[w + n + i]),
        acceleration_error: DVector::from_fn(n, |i, _| error * scale[w + i]),
        reaction_error: DVector::from_fn(n, |i, _| error / scale[w + i]),
        acceleration,
    }
}

/// LU with one step of refinement, or the solution of minimum norm, refined as well, where the rows depend on each other.
fn solve_dense(matrix: &DMatrix<f64>, vector: &DVector<f64>, regular: bool) -> (DVector<f64>, f64) {
    if matrix.is_empty() {
        return (vector.clone(), 1.0);
    }
    let svd = matrix.clone().svd(true, true);
    let largest = svd.singular_values.max();
    let kept = svd.singular_values.iter().filter(|s| **s > RANK * largest);
    let condition = largest / kept.fold(largest, |least, s| least.min(*s));
    let once = |right: &DVector<f64>| -> DVector<f64> {
        if regular {
            matrix.clone().lu().solve(right).expect("rows of full rank")
        } else {
            svd.solve(right, RANK * largest).expect("both sets of singular vectors")
        }
    };
    // the singular vectors of rows that repeat each other are known to some five digits only
    let mut solution = once(vector);
    for _ in 0..if regular { 1 } else { 5 } {
        let correction = once(&(vector - matrix * &solution));
        solution += correction;
    }
    (solution, condition)
}

/// LU with one step of refinement; the condition by the power method on AᵀA and on its inverse.
fn solve_regular(matrix: &DMatrix<f64>, vector: &DVector<f64>) -> (DVector<f64>, f64) {
    let transposed = matrix.transpose();
    let (lu, lu_transposed) = (matrix.clone().lu(), transposed.clone().lu());
    let once = |right: &DVector<f64>| lu.solve(right).expect("rows of full rank");
    let back = |right: &DVector<f64>| lu_transposed.solve(right).expect("rows of full rank");
    let first = once(vector);
    let solution = &first + once(&(vector - matrix * &first));
    let start = DVector::from_fn(vector.len(), |i, _| 1.0 + 0.3 * (7 * i + 1) as f64 % 1.7);
    let (mut large, mut small) = (start.normalize(), start.normalize());
    let (mut largest, mut inverse) = (1.0_f64, 1.0_f64);
    for _ in 0..15 {
        let (grown, shrunk) = (&transposed * (matrix * &large), once(&back(&small)));
        (largest, inverse) = (grown.norm(), shrunk.norm());
        (large, small) = (grown / largest, shrunk / inverse);
    }
    (solution, (largest * inverse).sqrt())
}

/// √M_ii; what has no inertia counts as the heaviest that has.
pub fn roots(inertia: &DMatrix<f64>) -> DVector<f64> {
    let diagonal = inertia.diagonal();
    let heaviest = diagonal.iter().copied().fold(0.0, f64::max);
    // what is left of a rod about its own axis is rounding
    diagonal.map(|own| (if own > RANK * RANK * heaviest { own } else { heaviest }).sqrt())
}

/// The rank of a matrix and the condition of what it keeps.
pub fn conditioned_rank(matrix: &DMatrix<f64>) -> (usize, f64) {
    if matrix.is_empty() {
        return (0, 1.0);
    }
    let values = matrix.singular_values();
    let largest = values.max();
    let kept: Vec<f64> = values.iter().copied().filter(|s| *s > RANK * largest).collect();
    let least = kept.iter().copied().fold(largest, f64::min);
    if largest == 0.0 { (0, 1.0) } else { (kept.len(), largest / least) }
}
