//! Two ways onto f = 0 from the start that the model names, both with bounded work.

use super::start::{Start, dot};
use crate::symbolic::{Expr, Graph, Matrix, Symbol};

/// Below this fraction of its terms f counts as closed.
const CLOSED: f64 = 1e-10;

/// A row of ∂f/∂q that keeps less than this of its length beside the others leads nowhere.
const SPENT: f64 = 1e-10;

/// Steps of one method, and how often a step is made shorter.
const STEPS: usize = 100;
const HALVINGS: usize = 30;

/// How much harder a step is damped that leads nowhere, the part of |f|² that is left where the next may be damped less, and the
/// least factor of the damping.
const HARDER: f64 = 4.0;
const WELL: f64 = 0.25;
const LEAST_FACTOR: f64 = 1e-8;

/// f = 0 in the coordinates that have a value.
pub(super) struct Loops<'a> {
    graph: &'a Graph,
    residuals: &'a [Expr],
    slopes: &'a Matrix,
    moved: &'a [Symbol],
    /// Their columns in the slopes.
    columns: &'a [usize],
    /// The size of the terms of each row where it is closed from; where they are zero there, that of its slopes.
    pub(super) scales: Vec<f64>,
}

impl<'a> Loops<'a> {
    pub(super) fn of(
        from: &Start,
        graph: &'a Graph,
        residuals: &'a [Expr],
        slopes: &'a Matrix,
        (moved, columns): (&'a [Symbol], &'a [usize]),
    ) -> Self {
        let mut loops = Loops { graph, residuals, slopes, moved, columns, scales: Vec::new() };
        let entries = from.all(graph, slopes.entries());
        let slope = |i: usize| columns.iter().map(|j| entries[i * slopes.columns() + j].1).fold(0.0, f64::max);
        let sizes = loops.residuals(from).into_iter().map(|(_, size)| size).enumerate();
        let positive = |size: f64| (size > 0.0).then_some(size);
        loops.scales = sizes.map(|(i, size)| positive(size).or(positive(slope(i))).unwrap_or(1.0)).collect();
        loops
    }

    fn residuals(&self, at: &Start) -> Vec<(f64, f64)> {
        at.all(self.graph, self.residuals)
    }

    /// ∂f/∂q, row by row.
    fn jacobian(&self, at: &Start) -> Vec<Vec<f64>> {
        let entries = at.all(self.graph, self.slopes.entries());
        let row = |i: usize| self.columns.iter().map(|j| entries[i * self.slopes.columns() + j].0).collect();
        (0..self.residuals.len()).map(row).collect()
    }

    /// The rows of which something is left among their terms, here or where they were closed from: a product has no others.
    pub(super) fn open(&self, f: &[(f64, f64)]) -> impl Iterator<Item = usize> {
        let closed = |((value, size), scale): (&(f64, f64), &f64)| value.abs() <= CLOSED * size.max(*scale);
        let closed: Vec<bool> = f.iter().zip(&self.scales).map(closed).collect();
        (0..closed.len()).filter(move |i| !closed[*i])
    }

    /// Changes of least norm, each whole or as far as it makes f smaller. Gives what is left of f.
    pub(super) fn by_newton(&self, at: &mut Start) -> Vec<(f64, f64)> {
        let mut f = self.residuals(at);
        for _ in 0..STEPS {
            if merit(&f, &self.scales) == 0.0 {
                break;
            }
            let right: Vec<f64> = f.iter().map(|(value, _)| *value).collect();
            let step = least_change(&self.jacobian(at), &right);
            let parts = std::iter::successors(Some(1.0), |part| Some(part / 2.0)).take(HALVINGS);
            let mut shorter = parts.map(|part| step.iter().map(|change| part * change).collect::<Vec<f64>>());
            let Some(next) = shorter.find_map(|step| self.descend(at, &step, &f)) else { break };
            f = next;
        }
        f
    }

    /// The method of Levenberg and Marquardt, with changes measured on the scale of each coordinate (Moré 1978, section 6).
    ///
    /// Beside configurations in which rows come to depend on each other, changes of least norm go far astray. Here a change minimises
    /// |J dq + f|² + μ |dq|², where μ is the length of f times a factor that grows while f becomes no smaller: so the method ends
    /// quadratically also where J has not full rank, as long as |f| tells the distance (Fan and Yuan 2005).
    pub(super) fn by_damped_steps(&self, at: &mut Start) -> Vec<(f64, f64)> {
        let mut f = self.residuals(at);
        let mut lengths = vec![0.0_f64; self.moved.len()];
        let mut factor = 1.0;
        for _ in 0..STEPS {
            let before = merit(&f, &self.scales);
            if before == 0.0 {
                break;
            }
            let mut jacobian = self.jacobian(at);
            jacobian.iter_mut().zip(&self.scales).for_each(|(row, scale)| row.iter_mut().for_each(|e| *e /= scale));
            for (j, length) in lengths.iter_mut().enumerate() {
                *length = length.max(jacobian.iter().map(|row| row[j] * row[j]).sum::<f64>().sqrt());
            }
            let right: Vec<f64> = f.iter().zip(&self.scales).map(|((value, _), scale)| value / scale).collect();
            let shorter = std::iter::successors(Some(factor), |factor| Some(HARDER * factor)).take(HALVINGS);
            let mut shorter = shorter.map(|factor| {
                let step = damped_change(&jacobian, &right, &lengths, factor * before.sqrt());
                (factor, step)
            });
            let found = shorter.find_map(|(factor, step)| Some((factor, self.descend(at, &step, &f)?)));
            let Some((enough, next)) = found else { break };
            let well = merit(&next, &self.scales) < WELL * before;
            factor = if well { (enough / HARDER).max(LEAST_FACTOR) } else { enough };
            f = next;
        }
        f
    }

    /// Moves along a step if that makes f smaller; `None`, and nothing moved, where it does not.
    fn descend(&self, at: &mut Start, step: &[f64], before: &[(f64, f64)]) -> Option<Vec<(f64, f64)>> {
        let kept = at.values.clone();
        for (symbol, change) in self.moved.iter().zip(step) {
            at.values.insert(*symbol, kept[symbol] + change);
        }
        let f = self.residuals(at);
        if merit(&f, &self.scales) < merit(before, &self.scales) {
            return Some(f);
        }
        at.values = kept;
        None
    }
}

/// The square sum of f, each on its scale.
pub(super) fn merit(f: &[(f64, f64)], scales: &[f64]) -> f64 {
    f.iter().zip(scales).map(|((value, _), scale)| (value / scale).powi(2)).sum()
}

/// The step of least norm with J dq = -f, over the rows of J that are independent.
fn least_change(jacobian: &[Vec<f64>], f: &[f64]) -> Vec<f64> {
    let mut step = vec![0.0; jacobian.first().map_or(0, Vec::len)];
    let mut basis: Vec<(Vec<f64>, f64)> = Vec::new();
    for (row, value) in jacobian.iter().zip(f) {
        let (mut rest, mut right) = (row.clone(), -value);
        // Twice is enough.
        for _ in 0..2 {
            for (direction, part) in &basis {
                let along = dot(&rest, direction);
                rest.iter_mut().zip(direction).for_each(|(r, d)| *r -= along * d);
                right -= along * part;
            }
        }
        let (length, whole) = (dot(&rest, &rest).sqrt(), dot(row, row).sqrt());
        if length > SPENT * whole && length.is_finite() {
            basis.push((rest.iter().map(|r| r / length).collect(), right / length));
        }
    }
    for (direction, part) in &basis {
        step.iter_mut().zip(direction).for_each(|(s, d)| *s += part * d);
    }
    step
}

/// The step that minimises |J dq + f|² + μ |dq|², each change on the scale of its column's length.
///
/// It is the step of least norm with J dq + √μ s = -f, where every row has a slack s of its own.
fn damped_change(jacobian: &[Vec<f64>], f: &[f64], lengths: &[f64], damping: f64) -> Vec<f64> {
    let length = |j: usize| if lengths[j] > 0.0 { lengths[j] } else { 1.0 };
    let slack = |i: usize| (0..f.len()).map(move |other| if other == i { damping.sqrt() } else { 0.0 });
    let scaled = |row: &[f64]| row.iter().enumerate().map(|(j, e)| e / length(j)).collect::<Vec<f64>>();
    let rows: Vec<Vec<f64>> =
        jacobian.iter().enumerate().map(|(i, row)| scaled(row).into_iter().chain(slack(i)).collect()).collect();
    let step = least_change(&rows, f);
    (0..lengths.len()).map(|j| step[j] / length(j)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_change_meets_independent_rows() {
        let rows = [vec![1.0, 2.0, 2.0], vec![0.0, 1.0, -1.0], vec![1.0, 3.0, 1.0]];
        let step = least_change(&rows, &[-9.0, 2.0, -7.0]);
        assert!((dot(&rows[0], &step) - 9.0).abs() < 1e-14 && (dot(&rows[1], &step) + 2.0).abs() < 1e-14);
        // It lies in the space of the rows: nothing of it is across them.
        assert!(dot(&[-4.0, 1.0, 1.0], &step).abs() < 1e-14);
    }

    /// (JᵀJ + μ E) dq = -Jᵀf, in units in which the columns have length one; two rows here are one.
    #[test]
    fn the_damped_change_solves_its_normal_equations() {
        let rows = [vec![1.0, 2.0, 0.0], vec![1.0, 2.0, 0.0], vec![0.0, 1.0, 0.0]];
        let (f, lengths, damping) = ([0.3, 0.1, -0.2], [2.0_f64.sqrt(), 3.0, 0.0], 0.01);
        let step = damped_change(&rows, &f, &lengths, damping);
        let left: Vec<f64> = rows.iter().zip(f).map(|(row, f)| dot(row, &step) + f).collect();
        for j in 0..2 {
            let column: Vec<f64> = rows.iter().map(|row| row[j]).collect();
            assert!((dot(&column, &left) + damping * lengths[j].powi(2) * step[j]).abs() < 1e-14, "{step:?}");
        }
        assert_eq!(step[2], 0.0);
    }
}
