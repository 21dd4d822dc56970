//! The general form (3.5) in numbers, at one point: the null space of C, and the solution within it.
//!
//! `[C; D M] v̇ = [−c; D h]` for any D with `D Cᵀ = 0`: here the orthonormal one that a QR decomposition of Cᵀ with column pivots
//! leaves over, so that no choice of independent speeds can fail. M need only be definite on ker C. With h = 0 the same solution is
//! the change of least kinetic energy that lets the rows change by −c: the way back onto the constraints.

use alloc::vec;
use alloc::vec::Vec;

use crate::math::double::sqrt;

/// Pivots of D M Dᵀ below this fraction of the largest entry count as zero.
const INDEFINITE: f64 = 1e-13;

/// Rows with weights below this do not take part in a combination.
const NOT_TAKING_PART: f64 = 1e-6;

/// Rows below this fraction of the longest are nothing but rounding.
const NO_LENGTH: f64 = 1e-12;

/// Why there is no unique solution.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Loss {
    /// Rows of C depend on each other: those that take part, and the sine of the angle that is left between them.
    Rank { rows: Vec<usize>, pivot: f64 },
    /// M is not definite on ker C: the smallest pivot of D M Dᵀ relative to the largest entry.
    Inertia { pivot: f64 },
}

/// C and M of one point with their decomposition; the room for it is made once.
///
/// Velocities are measured in √M_jj and rows by their lengths, so that units do not matter.
pub(crate) struct Tangent {
    n: usize,
    m: usize,
    /// C, m × n by rows; the caller fills it.
    pub(crate) rows: Vec<f64>,
    /// M, n × n by rows; the caller fills it.
    pub(crate) mass: Vec<f64>,
    /// 1/√M_jj, and the inverse lengths of the rows.
    units: Vec<f64>,
    lengths: Vec<f64>,
    /// R of Cᵀ P = Q R, by rows of Rᵀ: the entries of a row of C along the columns of Q.
    along: Vec<f64>,
    order: Vec<usize>,
    /// Q, n × n by rows: the first `rank` columns span the rows of C, the others are Dᵀ.
    basis: Vec<f64>,
    rank: usize,
    /// The last pivot of the decomposition: the smallest sine of an angle between a row and those before it; one without rows.
    pub(crate) least: f64,
    /// The lower half of the Cholesky factor of D M Dᵀ, k × k by rows.
    factor: Vec<f64>,
    work: Vec<f64>,
    change: Vec<f64>,
    zeros: Vec<f64>,
}

/// Independent rows of C at one point and an orthonormal basis of what they span.
#[derive(Clone, Debug)]
pub(crate) struct Span {
    pub(crate) rows: Vec<usize>,
    /// By rows, as many columns as there are rows of C.
    basis: Vec<f64>,
    /// The signs of the rows along the directions of the basis, to each of which a row is the first to have an entry.
    signs: Vec<f64>,
}

impl Tangent {
    /// What the rows span.
    pub(crate) fn span(&self) -> Span {
        let (n, r) = (self.n, self.rank);
        let signs = self.order[..r].iter().enumerate().map(|(j, row)| self.along[row * n + j].signum());
        Span {
            rows: self.order[..r].to_vec(),
            basis: (0..n).flat_map(|i| self.basis[i * n..i * n + r].iter().copied()).collect(),
            signs: signs.collect(),
        }
    }

    /// The sign of the determinant of the rows of a span along its directions relative to that which it had there, and the
    /// product of the cosines between then and now.
    pub(crate) fn compare(&self, span: &Span) -> (f64, f64) {
        let r = span.rows.len();
        if r != self.rank {
            return (1.0, 0.0);
        }
        let now = self.rows_along(&span.rows);
        let then = self.projected(span, &now);
        let (along, across) = (determinant(now, r), determinant(then, r));
        (across.signum() * span.signs.iter().product::<f64>(), if along == 0.0 { 0.0 } else { (across / along).abs() })
    }

    /// Those rows of a span that point the other way now.
    pub(crate) fn turned(&self, span: &Span) -> Vec<usize> {
        let r = span.rows.len();
        if r != self.rank {
            return Vec::new();
        }
        let then = self.projected(span, &self.rows_along(&span.rows));
        (0..r).filter(|i| then[i * r + i] * span.signs[*i] < 0.0).map(|i| span.rows[i]).collect()
    }

    /// Rows along the first columns of the basis, r × r.
    fn rows_along(&self, rows: &[usize]) -> Vec<f64> {
        rows.iter().flat_map(|row| self.along[row * self.n..row * self.n + self.rank].iter().copied()).collect()
    }

    /// The same along the directions of a span.
    fn projected(&self, span: &Span, along: &[f64]) -> Vec<f64> {
        let (n, r) = (self.n, self.rank);
        let mut out = vec![0.0; r * r];
        for a in 0..r {
            for b in 0..r {
                let product = |j: usize| -> f64 { (0..n).map(|i| self.basis[i * n + j] * span.basis[i * r + b]).sum() };
                out[a * r + b] = (0..r).map(|j| along[a * r + j] * product(j)).sum();
            }
        }
        out
    }

    /// Room for n velocities and m rows.
    pub(crate) fn new(n: usize, m: usize) -> Self {
        Tangent {
            n,
            m,
            rows: vec![0.0; m * n],
            mass: vec![0.0; n * n],
            units: vec![1.0; n],
            lengths: vec![0.0; m],
            along: vec![0.0; m * n],
            order: (0..m).collect(),
            basis: vec![0.0; n * n],
            rank: 0,
            least: 1.0,
            factor: vec![0.0; n * n],
            work: vec![0.0; n * 3],
            change: vec![0.0; n],
            zeros: vec![0.0; n],
        }
    }

    /// Decomposes C and D M Dᵀ.
    ///
    /// With `rank` C has that many independent rows, or it is a loss where a pivot falls below `dependent`; without, rows below
    /// it are left out.
    pub(crate) fn decompose(&mut self, rank: Option<usize>, dependent: f64) -> Result<(), Loss> {
        self.scale();
        self.orthogonalise(rank, dependent)?;
        self.reduce()
    }

    /// The least change in the kinetic metric by which the rows change by −c; rows that depend on others are left out.
    ///
    /// Where M is not definite on the motions that the rows leave, every velocity counts by its own inertia.
    pub(crate) fn nearest(&mut self, c: &[f64], dependent: f64) -> &[f64] {
        if self.decompose(None, dependent).is_err() {
            self.forget_inertia();
            // The identity in the units of `scale`: its Cholesky factor cannot fail.
            let _ = self.decompose(None, dependent);
        }
        let mut change = core::mem::take(&mut self.change);
        let forces = core::mem::take(&mut self.zeros);
        self.solve(c, &forces, &mut change);
        (self.change, self.zeros) = (change, forces);
        &self.change
    }

    /// The rows that the last decomposition left out, with the sines of the angles between them and what the others span. Rows of no
    /// length beside the longest have no direction.
    pub(crate) fn left_out(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        let known = self.lengths.iter().filter(|inverse| **inverse > 0.0);
        let shortest = known.fold(f64::INFINITY, |least: f64, inverse| least.min(*inverse));
        let sine = move |row: usize| {
            let square: f64 = self.along[row * self.n + self.rank..(row + 1) * self.n].iter().map(|c| c * c).sum();
            if self.lengths[row] * NO_LENGTH > shortest { 0.0 } else { sqrt(square) }
        };
        self.order[self.rank..].iter().map(move |row| (*row, sine(*row)))
    }

    /// Takes the identity for M, in the units of the velocities.
    fn forget_inertia(&mut self) {
        let n = self.n;
        for i in 0..n {
            for j in 0..n {
                self.mass[i * n + j] = if i == j { 1.0 / (self.units[i] * self.units[i]) } else { 0.0 };
            }
        }
    }

    fn scale(&mut self) {
        let n = self.n;
        for j in 0..n {
            let inertia = self.mass[j * n + j];
            self.units[j] = if inertia > 0.0 && inertia.is_finite() { 1.0 / sqrt(inertia) } else { 1.0 };
        }
        for i in 0..self.m {
            for j in 0..n {
                self.along[i * n + j] = self.rows[i * n + j] * self.units[j];
            }
            let row = &mut self.along[i * n..(i + 1) * n];
            let length = sqrt(row.iter().map(|c| c * c).sum());
            self.lengths[i] = if length > 0.0 && length.is_finite() { 1.0 / length } else { 0.0 };
            let inverse = self.lengths[i];
            row.iter_mut().for_each(|c| *c *= inverse);
        }
    }

    /// Householder's decomposition of Cᵀ with column pivots.
    fn orthogonalise(&mut self, rank: Option<usize>, dependent: f64) -> Result<(), Loss> {
        let (n, m) = (self.n, self.m);
        self.basis.fill(0.0);
        for j in 0..n {
            self.basis[j * n + j] = 1.0;
        }
        self.order.iter_mut().enumerate().for_each(|(i, row)| *row = i);
        (self.rank, self.least) = (0, 1.0);
        let most = rank.unwrap_or(n.min(m)).min(n);
        while self.rank < most {
            let j = self.rank;
            let left = |along: &[f64], row: usize| sqrt(along[row * n + j..(row + 1) * n].iter().map(|c| c * c).sum());
            let (mut at, mut largest) = (j, 0.0);
            for (place, row) in self.order.iter().enumerate().skip(j) {
                let length = left(&self.along, *row);
                if length > largest {
                    (at, largest) = (place, length);
                }
            }
            if largest <= dependent || largest.is_nan() {
                return match rank {
                    Some(_) => Err(Loss::Rank { rows: self.partners(j, NOT_TAKING_PART), pivot: largest }),
                    None => Ok(()),
                };
            }
            self.order.swap(j, at);
            self.reflect(self.order[j], j, largest);
            self.least = largest;
            self.rank += 1;
        }
        Ok(())
    }

    /// Turns the rest of a row into its entry j.
    fn reflect(&mut self, row: usize, j: usize, length: f64) {
        let n = self.n;
        let axis = &mut self.work[..n];
        axis.fill(0.0);
        axis[j..].copy_from_slice(&self.along[row * n + j..(row + 1) * n]);
        axis[j] += if axis[j] < 0.0 { -length } else { length };
        let square: f64 = axis[j..].iter().map(|a| a * a).sum();
        let turn = |of: &mut [f64]| {
            let product: f64 = of.iter().zip(&axis[j..]).map(|(a, b)| a * b).sum();
            let factor = 2.0 * product / square;
            for (entry, a) in of.iter_mut().zip(&axis[j..]) {
                *entry -= factor * a;
            }
        };
        for i in &self.order[j..] {
            turn(&mut self.along[i * n + j..(i + 1) * n]);
        }
        for i in 0..n {
            turn(&mut self.basis[i * n + j..(i + 1) * n]);
        }
    }

    /// The row that is nearest to a combination of others, and those.
    pub(crate) fn weakest(&self) -> Vec<usize> {
        self.partners(self.rank.saturating_sub(1), NOT_TAKING_PART.max(self.least))
    }

    /// The row at a place of the order, and the rows before it of which it is a combination, but for what is left of it there.
    fn partners(&self, r: usize, negligible: f64) -> Vec<usize> {
        let n = self.n;
        let Some(&last) = self.order.get(r) else {
            return Vec::new();
        };
        let mut weights = self.along[last * n..last * n + r].to_vec();
        for j in (0..r).rev() {
            weights[j] /= self.along[self.order[j] * n + j];
            for i in 0..j {
                weights[i] -= weights[j] * self.along[self.order[j] * n + i];
            }
        }
        let mut rows = vec![last];
        rows.extend(
            self.order.iter().zip(&weights).filter(|(_, weight)| weight.abs() > negligible).map(|(row, _)| *row),
        );
        rows.sort_unstable();
        rows
    }

    /// D M Dᵀ and its Cholesky factor.
    fn reduce(&mut self) -> Result<(), Loss> {
        let (n, r) = (self.n, self.rank);
        let k = n - r;
        let mut largest: f64 = 0.0;
        for a in 0..k {
            self.momentum(r + a);
            for b in 0..=a {
                let entry: f64 = (0..n).map(|i| self.basis[i * n + r + b] * self.units[i] * self.work[i]).sum();
                self.factor[a * k + b] = entry;
                largest = largest.max(entry.abs());
            }
        }
        for a in 0..k {
            for b in 0..=a {
                let mut entry = self.factor[a * k + b];
                for c in 0..b {
                    entry -= self.factor[a * k + c] * self.factor[b * k + c];
                }
                if a == b {
                    if entry <= INDEFINITE * largest || entry.is_nan() {
                        return Err(Loss::Inertia { pivot: entry / largest });
                    }
                    self.factor[a * k + a] = sqrt(entry);
                } else {
                    self.factor[a * k + b] = entry / self.factor[b * k + b];
                }
            }
        }
        Ok(())
    }

    /// M times column c of the basis, into the first n places of `work`.
    fn momentum(&mut self, c: usize) {
        let n = self.n;
        for i in 0..n {
            let row = &self.mass[i * n..(i + 1) * n];
            self.work[i] = (0..n).map(|j| row[j] * self.units[j] * self.basis[j * n + c]).sum();
        }
    }

    /// v with C v = −c and D M v = D h (3.5).
    pub(crate) fn solve(&mut self, c: &[f64], h: &[f64], v: &mut [f64]) {
        let (n, r) = (self.n, self.rank);
        let k = n - r;
        let (within, rest) = self.work.split_at_mut(n);
        // Along the rows: Rᵀ z = −c.
        for j in 0..r {
            let row = self.order[j];
            let known: f64 = (0..j).map(|i| self.along[row * n + i] * within[i]).sum();
            within[j] = (-c[row] * self.lengths[row] - known) / self.along[row * n + j];
        }
        let (particular, rest) = rest.split_at_mut(n);
        for (i, entry) in particular.iter_mut().enumerate() {
            *entry = self.units[i] * (0..r).map(|j| self.basis[i * n + j] * within[j]).sum::<f64>();
        }
        let force = &mut rest[..n];
        for (i, force) in force.iter_mut().enumerate() {
            let row = &self.mass[i * n..(i + 1) * n];
            *force = h[i] - row.iter().zip(&*particular).map(|(m, v)| m * v).sum::<f64>();
        }
        // Within the null space: D M Dᵀ ν = D (h − M v_p).
        for a in 0..k {
            let sum: f64 = (0..n).map(|i| self.basis[i * n + r + a] * self.units[i] * force[i]).sum();
            let known: f64 = (0..a).map(|b| self.factor[a * k + b] * within[r + b]).sum();
            within[r + a] = (sum - known) / self.factor[a * k + a];
        }
        for a in (0..k).rev() {
            let known: f64 = (a + 1..k).map(|b| self.factor[b * k + a] * within[r + b]).sum();
            within[r + a] = (within[r + a] - known) / self.factor[a * k + a];
        }
        for (i, v) in v.iter_mut().enumerate() {
            let free: f64 = (0..k).map(|a| self.basis[i * n + r + a] * within[r + a]).sum();
            *v = particular[i] + self.units[i] * free;
        }
    }
}

/// By elimination with row pivots.
fn determinant(mut matrix: Vec<f64>, r: usize) -> f64 {
    let mut product = 1.0;
    for j in 0..r {
        let at = (j..r).fold(j, |at, i| if matrix[i * r + j].abs() > matrix[at * r + j].abs() { i } else { at });
        if at != j {
            (0..r).for_each(|l| matrix.swap(at * r + l, j * r + l));
            product = -product;
        }
        let pivot = matrix[j * r + j];
        product *= pivot;
        if pivot == 0.0 {
            return 0.0;
        }
        for i in j + 1..r {
            let factor = matrix[i * r + j] / pivot;
            (j..r).for_each(|l| matrix[i * r + l] -= factor * matrix[j * r + l]);
        }
    }
    product
}

#[cfg(test)]
mod tests;
