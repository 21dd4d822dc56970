//! What an elimination did to the rows of C, of which C_d⁻¹ is the product, done to a vector.

use super::Simplifier;
use crate::symbolic::{Expr, Graph, Matrix};

/// One thing that was done to rows.
#[derive(Clone, Debug)]
pub enum Step {
    /// The rows of a block were multiplied by the adjugate of the block, and divided by its determinant.
    Solve {
        /// The rows.
        rows: Vec<usize>,
        /// The adjugate.
        adjugate: Matrix,
        /// The determinant.
        determinant: Expr,
    },
    /// The multiple of one row was taken from another.
    Subtract {
        /// The row that became less.
        row: usize,
        /// The row that was taken from it.
        other: usize,
        /// How much of it.
        factor: Expr,
    },
}

impl Step {
    /// How many products it takes.
    pub fn terms(&self, graph: &Graph) -> usize {
        match self {
            Step::Solve { adjugate, .. } => adjugate.entries().iter().filter(|e| !graph.is_zero(**e)).count(),
            Step::Subtract { .. } => 1,
        }
    }

    /// Does the same to the entries of a vector.
    pub fn apply(&self, graph: &mut Graph, simplifier: &mut dyn Simplifier, vector: &mut [Expr]) {
        match self {
            Step::Solve { rows, adjugate, determinant } => {
                solved(graph, simplifier, vector, rows, (adjugate, *determinant));
            }
            Step::Subtract { row, other, factor } => subtract(graph, vector, *row, *other, *factor),
        }
    }

    /// Does the transposed of it.
    pub fn apply_transposed(&self, graph: &mut Graph, simplifier: &mut dyn Simplifier, vector: &mut [Expr]) {
        match self {
            Step::Solve { rows, adjugate, determinant } => {
                solved(graph, simplifier, vector, rows, (&adjugate.transpose(), *determinant));
            }
            Step::Subtract { row, other, factor } => subtract(graph, vector, *other, *row, *factor),
        }
    }
}

fn solved(
    graph: &mut Graph,
    simplifier: &mut dyn Simplifier,
    vector: &mut [Expr],
    rows: &[usize],
    (adjugate, determinant): (&Matrix, Expr),
) {
    let given: Vec<Expr> = rows.iter().map(|row| vector[*row]).collect();
    for (row, value) in rows.iter().zip(adjugate.mul_vec(graph, &given)) {
        let value = graph.div(value, determinant);
        vector[*row] = simplifier.one(graph, value);
    }
}

fn subtract(graph: &mut Graph, vector: &mut [Expr], row: usize, other: usize, factor: Expr) {
    let product = graph.mul(factor, vector[other]);
    vector[row] = graph.sub(vector[row], product);
}
