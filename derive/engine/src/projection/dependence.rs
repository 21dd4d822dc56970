//! Which rows are independent, which repeat others, and which contradict them.

use super::Simplifier;
use super::constraints::DifferentiatedRow;
use super::elimination::{Choice, Elimination, eliminate};
use super::messages;
use crate::symbolic::modular::{Element, Field};
use crate::symbolic::{Expr, Graph, Matrix, Stage};
use crate::syntax::Diagnostics;

/// A position row whose derivative is a combination of velocity rows: f serves assembly and projection, the rows stand
/// once in C.
#[derive(Clone, Debug)]
pub struct Merged {
    /// The position row.
    pub row: usize,
    /// ḟ = Σ coefficient·row, over rows that are kept.
    pub combination: Vec<(usize, Expr)>,
}

/// A row that depends on others and may: C_r = Σ coefficient·row, identically or where the constraints hold. It stands in C and
/// carries a share of the reaction.
#[derive(Clone, Debug)]
pub struct Redundant {
    /// The row.
    pub row: usize,
    /// Its combination, over rows that are kept; `None` until pivots tell it, where rows depend on others on the manifold alone.
    pub combination: Option<Vec<(usize, Expr)>>,
    /// Whether it depends on the others only where these hold, as the start shows.
    pub on_manifold: bool,
    /// What must vanish on the motions for it to say the same as its combination.
    pub excess: Expr,
}

/// The rows sorted by what becomes of them, as indices in the order of declaration.
#[derive(Clone, Debug, Default)]
pub struct Sorted {
    /// Independent rows: these determine the motion.
    pub kept: Vec<usize>,
    /// Position rows that velocity rows repeat.
    pub merged: Vec<Merged>,
    /// Rows that depend on others, as the model says.
    pub redundant: Vec<Redundant>,
}

impl Sorted {
    /// The rows of C, in the order of declaration.
    pub fn rows(&self) -> Vec<usize> {
        let mut all: Vec<usize> = self.kept.iter().copied().chain(self.redundant.iter().map(|row| row.row)).collect();
        all.sort_unstable();
        all
    }
}

/// The first rows, in the given order, that are independent of those before them: linear algebra modulo a prime.
pub fn independent(graph: &Graph, rows: &[Vec<Expr>], order: &[usize]) -> Vec<usize> {
    for point in 0..6 {
        if let Some(found) = independent_at(graph, rows, order, point) {
            return found;
        }
    }
    order.to_vec()
}

fn independent_at(graph: &Graph, rows: &[Vec<Expr>], order: &[usize], point: usize) -> Option<Vec<usize>> {
    let mut basis: Vec<(usize, Vec<Element>)> = Vec::new();
    let mut found = Vec::new();
    for i in order {
        let mut field = Field(3);
        let mut row = Vec::with_capacity(rows[*i].len());
        for e in &rows[*i] {
            let (f, value) = graph.residue(*e, point)?;
            field = f;
            row.push(value);
        }
        for (pivot, other) in &basis {
            let factor = field.neg(row[*pivot]);
            for (a, b) in row.iter_mut().zip(other) {
                *a = field.add(*a, field.mul(factor, *b));
            }
        }
        if let Some(pivot) = row.iter().position(|a| !a.is_zero()) {
            let scale = field.recip(row[pivot])?;
            row.iter_mut().for_each(|a| *a = field.mul(scale, *a));
            basis.push((pivot, row));
            found.push(*i);
        }
    }
    Some(found)
}

/// The coefficients of a dependent row over the rows that `elimination` has reduced.
pub fn combination(graph: &mut Graph, simplifier: &mut dyn Simplifier, e: &Elimination, row: &[Expr]) -> Vec<Expr> {
    let at_pivots: Vec<Expr> = e.pivots.iter().map(|j| row[*j]).collect();
    let coefficients = e.solve_transposed(graph, simplifier, &at_pivots);
    coefficients.into_iter().map(|c| if graph.vanishes(c) { graph.zero() } else { simplifier.one(graph, c) }).collect()
}

/// Sorts the rows; rows that depend on each other without a reason are errors that show the combination.
pub fn sort(
    graph: &mut Graph,
    simplifier: &mut dyn Simplifier,
    rows: &[DifferentiatedRow],
    columns: usize,
    errors: &mut Diagnostics,
) -> Sorted {
    // Velocity rows first: where a position row repeats them, they are the ones that stay. Rows that bind accelerations
    // alone come last: what they repeat binds more than they do. Before all of them come the rows that must not depend.
    let mut order: Vec<usize> = (0..rows.len()).collect();
    order.sort_by_key(|i| (rows[*i].redundant, !rows[*i].binds_speeds(), rows[*i].position.is_some()));
    let gradients: Vec<Vec<Expr>> = rows.iter().map(|row| row.gradient.clone()).collect();
    let mut kept = independent(graph, &gradients, &order);
    kept.sort_unstable();
    let dependent: Vec<usize> = (0..rows.len()).filter(|i| !kept.contains(i)).collect();
    if dependent.is_empty() {
        return Sorted { kept, ..Sorted::default() };
    }
    let c = Matrix::from_rows(kept.iter().map(|i| gradients[*i].clone()).collect(), columns);
    // Pivots that serve only this question must not become guards of the model.
    let (merged, redundant) =
        graph.without_new_assumptions(|graph| relate(graph, simplifier, rows, &kept, &dependent, &c, errors));
    Sorted { kept, merged, redundant }
}

/// Each dependent row as a combination of the kept ones: merged, redundant, or an error.
fn relate(
    graph: &mut Graph,
    simplifier: &mut dyn Simplifier,
    rows: &[DifferentiatedRow],
    kept: &[usize],
    dependent: &[usize],
    c: &Matrix,
    errors: &mut Diagnostics,
) -> (Vec<Merged>, Vec<Redundant>) {
    let (mut merged, mut redundant) = (Vec::new(), Vec::new());
    let choice = Choice { columns: vec![true; c.columns()], new_guards: true };
    let Ok(elimination) = eliminate(graph, simplifier, c, &choice) else { return (merged, redundant) };
    for i in dependent {
        let row = &rows[*i];
        let coefficients = combination(graph, simplifier, &elimination, &row.gradient);
        let parts: Vec<(usize, Expr)> =
            kept.iter().copied().zip(coefficients).filter(|(_, c)| !graph.is_zero(*c)).collect();
        let text = text_of(graph, rows, &parts);
        let (excess, of_velocities) = excess(graph, rows, row, &parts);
        if row.redundant && !contradicts_at_rest(graph, rows, row, &parts) {
            redundant.push(Redundant { row: *i, combination: Some(parts), on_manifold: false, excess });
        } else if row.redundant {
            errors.report(row.span, messages::contradictory_positions(&row.name, &text));
        } else if !graph.vanishes(excess) {
            let message = if of_velocities {
                messages::contradictory(&row.name, &text)
            } else {
                let excess = simplifier.one(graph, excess);
                messages::conflicting(&row.name, &text, &graph.display(excess))
            };
            errors.report(row.span, message);
        } else if row.position.is_some() && parts.iter().any(|(j, _)| rows[*j].position.is_none()) {
            merged.push(Merged { row: *i, combination: parts });
        } else {
            errors.report(row.span, messages::dependent(&row.name, row.position.is_some(), &text));
        }
    }
    (merged, redundant)
}

/// Whether f of a row and of its combination differ by a number: their rates agree, they cannot both be zero.
fn contradicts_at_rest(
    graph: &mut Graph,
    rows: &[DifferentiatedRow],
    row: &DifferentiatedRow,
    parts: &[(usize, Expr)],
) -> bool {
    let Some(f) = row.position else { return false };
    let mut terms = Vec::new();
    for (j, c) in parts {
        match rows[*j].position {
            Some(other) => terms.push(graph.mul(*c, other)),
            None => return false,
        }
    }
    let total = graph.sum(&terms);
    let difference = graph.sub(f, total);
    graph.as_number(difference).is_some_and(|number| !number.is_zero())
}

/// Redundant rows must say the same as the others on the motions that these leave; `on_motions` puts these in.
pub fn check_redundant(
    graph: &mut Graph,
    simplifier: &mut dyn Simplifier,
    rows: &[DifferentiatedRow],
    sorted: &Sorted,
    on_motions: impl Fn(&mut Graph, Expr) -> Expr,
    errors: &mut Diagnostics,
) {
    for Redundant { row, combination, excess, .. } in &sorted.redundant {
        let excess = on_motions(graph, *excess);
        if !graph.vanishes(excess) {
            let text = text_of(graph, rows, combination.as_deref().unwrap_or_default());
            let excess = simplifier.one(graph, excess);
            let message = messages::redundant_but_different(&rows[*row].name, &text, &graph.display(excess));
            errors.report(rows[*row].span, message);
        }
    }
}

/// What became of the rows that may depend on others, told to a person.
pub fn notes(graph: &Graph, rows: &[DifferentiatedRow], sorted: &Sorted) -> Vec<String> {
    let marked = rows.iter().enumerate().filter(|(_, row)| row.redundant);
    marked
        .map(|(i, row)| match sorted.redundant.iter().find(|redundant| redundant.row == i) {
            Some(Redundant { on_manifold: true, .. }) => format!(
                "`{}` depends on the other rows wherever these hold, as the start and configurations beside it show; they share \
                 the reaction with the least sum of squares",
                row.name
            ),
            Some(redundant) => format!(
                "`{}` depends on the other rows: it is {}; they share the reaction with the least sum of squares",
                row.name,
                text_of(graph, rows, redundant.combination.as_deref().unwrap_or_default())
            ),
            None => {
                format!("`{}` is marked as redundant, but independent of the other rows: it is a row as any", row.name)
            }
        })
        .collect()
}

/// By how much a row differs from the combination of others that has its gradient, and whether that is said of the
/// velocities: else, where it cannot be, of c0*.
fn excess(
    graph: &mut Graph,
    rows: &[DifferentiatedRow],
    row: &DifferentiatedRow,
    parts: &[(usize, Expr)],
) -> (Expr, bool) {
    let all = row.velocity.is_some() && parts.iter().all(|(j, _)| rows[*j].velocity.is_some());
    let of_velocities = all && parts.iter().all(|(_, c)| graph.stage(*c) <= Stage::Coordinate);
    let value = |row: &DifferentiatedRow| row.velocity.filter(|_| of_velocities).unwrap_or(row.bias);
    let terms: Vec<Expr> = parts.iter().map(|(j, c)| graph.mul(*c, value(&rows[*j]))).collect();
    let total = graph.sum(&terms);
    (graph.sub(value(row), total), of_velocities)
}

/// `2*a - cos(theta)*b` over the names of rows.
fn text_of(graph: &Graph, rows: &[DifferentiatedRow], parts: &[(usize, Expr)]) -> String {
    let named: Vec<(&str, Expr)> = parts.iter().map(|(j, c)| (rows[*j].name.as_str(), *c)).collect();
    messages::combination(graph, &named)
}
