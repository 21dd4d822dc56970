//! The `independent` statement that an error offers: one that will be accepted.
//!
//! Speeds that determine the others well are found among the numbers at the start, by full pivoting. That is not enough: the equations
//! are eliminated with pivots of their own, in the order of what these cost, and one of them may vanish where the whole is regular. So
//! what is offered has been eliminated and judged as it will be when it is written down. Where the first choice fails, those are
//! tried that differ from it by one exchange, the best determined first.

use super::Simplifier;
use super::judge::{Judged, VANISHES, vanishing};
use super::start::Start;
use super::tangent::tangent;
use crate::model::{Chosen, InitialSystem};
use crate::symbolic::{Assumptions, Graph, Symbol};
use crate::syntax::Diagnostics;

/// Choices that are tried.
const TRIED: usize = 8;

/// The statement to write instead; `None` where the start does not tell, or none that was tried is accepted.
///
/// The arena grows, the choice of the model is lost: what is made with them must be in error.
pub fn offer(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    judged: Judged<'_>,
    start: &Start,
    gradients: Option<Vec<Vec<f64>>>,
    before: &Assumptions,
) -> Option<String> {
    let Judged { rows, kept, carried, carriers } = judged;
    let choices = choices(gradients?, carriers.speeds.len())?;
    system.independent.clear();
    for dependent in choices.into_iter().take(TRIED) {
        let free = carriers.speeds.iter().enumerate().filter(|(j, _)| !dependent.contains(j));
        let speeds: Vec<Symbol> = free.map(|(_, speed)| *speed).collect();
        system.chosen = Some(Chosen { speeds: speeds.clone(), reason: None });
        system.graph.assume_only(before.clone());
        let found = tangent(system, simplifier, rows, kept, carried, carriers, 0, &mut Diagnostics::new());
        if found.is_some_and(|tangent| vanishing(system, judged, start, &tangent).is_none()) {
            return Some(statement(&system.graph, &speeds));
        }
    }
    None
}

fn statement(graph: &Graph, speeds: &[Symbol]) -> String {
    let written = speeds.iter().map(|speed| {
        let name = graph.name(*speed);
        name.strip_prefix("dot_").map_or_else(|| name.to_owned(), |q| format!("dot({q})"))
    });
    format!("#[independent({})]", written.collect::<Vec<_>>().join(", "))
}

/// The dependent columns by full pivoting, then with one of them exchanged for another, the best determined first; `None` where
/// the rows are dependent.
fn choices(mut c: Vec<Vec<f64>>, width: usize) -> Option<Vec<Vec<usize>>> {
    let largest = c.iter().flatten().fold(0.0_f64, |a, b| a.max(b.abs()));
    let (mut open, mut dependent): (Vec<usize>, Vec<(usize, usize)>) = ((0..c.len()).collect(), Vec::new());
    while !open.is_empty() {
        let places = open.iter().flat_map(|i| (0..width).map(move |j| (*i, j)));
        let free = places.filter(|(_, j)| dependent.iter().all(|(_, column)| column != j));
        let (row, column) = free.max_by(|a, b| c[a.0][a.1].abs().total_cmp(&c[b.0][b.1].abs()))?;
        let pivot = c[row][column];
        if pivot.abs() <= VANISHES * largest {
            return None;
        }
        open.retain(|i| *i != row);
        dependent.push((row, column));
        c[row].iter_mut().for_each(|e| *e /= pivot);
        let pivot_row = c[row].clone();
        for i in (0..c.len()).filter(|i| *i != row) {
            let factor = c[i][column];
            c[i].iter_mut().zip(&pivot_row).for_each(|(a, b)| *a -= factor * b);
        }
    }
    let columns: Vec<usize> = dependent.iter().map(|(_, column)| *column).collect();
    // A dependent speed may change places with an independent one by its entry, the factor between the determinants.
    let mut exchanges: Vec<(f64, usize, usize)> = Vec::new();
    for (at, (row, _)) in dependent.iter().enumerate() {
        let others = (0..width).filter(|j| !columns.contains(j) && c[*row][*j].abs() > VANISHES);
        exchanges.extend(others.map(|j| (c[*row][j].abs(), at, j)));
    }
    exchanges.sort_by(|a, b| b.0.total_cmp(&a.0));
    let exchanged = exchanges.into_iter().map(|(_, at, j)| {
        let mut columns = columns.clone();
        columns[at] = j;
        columns
    });
    Some(std::iter::once(columns.clone()).chain(exchanged).collect())
}

#[cfg(test)]
mod tests {
    use super::choices;

    /// Every choice determines the dependent speeds; the first by the largest pivots, the others as well as they can.
    #[test]
    fn choices_are_regular_and_the_best_come_first() {
        let rows = vec![vec![4.0, 1.0, 1.0, 0.5], vec![4.0, 3.0, 1.0, 0.0]];
        let found = choices(rows.clone(), 4).expect("independent rows");
        let determinant = |columns: &[usize]| {
            let [a, b] = [columns[0], columns[1]];
            (rows[0][a] * rows[1][b] - rows[0][b] * rows[1][a]).abs()
        };
        assert_eq!(found[0], [0, 1]);
        assert!(found.iter().all(|columns| determinant(columns) > 0.0), "{found:?}");
        let sizes: Vec<f64> = found[1..].iter().map(|columns| determinant(columns)).collect();
        assert!(sizes.len() == 3 && sizes.is_sorted_by(|a, b| a >= b), "{sizes:?}");
        assert_eq!(choices(vec![vec![1.0, 2.0, 0.0], vec![2.0, 4.0, 0.0]], 3), None);
    }
}
