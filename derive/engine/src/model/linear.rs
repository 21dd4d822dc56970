//! Expressions that are linear in some symbols, decided.

use crate::symbolic::{Expr, Graph, Matrix, Symbol};

/// `coefficients · variables + constant`, both free of the variables.
pub(super) struct Linear {
    pub coefficients: Matrix,
    pub constant: Vec<Expr>,
}

/// The row that is not linear, and a variable on which its derivative depends.
pub(super) struct Nonlinear {
    pub row: usize,
    pub variable: Symbol,
    /// The derivative of the row by that variable.
    pub derivative: Expr,
}

/// Splits each expression into a part linear in the variables and a rest without them.
///
/// That an expression *is* linear is decided by identity with the split, so that `v*v/v` counts as `v`. The split is
/// read off at the variables' values 0, and at small numbers where 0 is no argument.
pub(super) fn split(graph: &mut Graph, rows: &[Expr], variables: &[Symbol]) -> Result<Linear, Vec<Nonlinear>> {
    let derivatives = graph.jacobian(rows, variables);
    let mut coefficients = Matrix::zeros(graph, rows.len(), variables.len());
    let mut constant = Vec::with_capacity(rows.len());
    let mut refused = Vec::new();
    for (i, row) in rows.iter().enumerate() {
        let found = (0..4).find_map(|at| at_value(graph, *row, derivatives.row(i), variables, at));
        match found {
            Some((entries, rest)) => {
                entries.into_iter().enumerate().for_each(|(j, entry)| coefficients.set(i, j, entry));
                constant.push(rest);
            }
            None => {
                let culprit = (0..variables.len()).find(|&j| graph.contains(derivatives.get(i, j), variables));
                let j = culprit.unwrap_or_default();
                refused.push(Nonlinear { row: i, variable: variables[j], derivative: derivatives.get(i, j) });
            }
        }
    }
    if refused.is_empty() { Ok(Linear { coefficients, constant }) } else { Err(refused) }
}

/// The split with everything but the row itself taken at `variables = value`; `None` if the row is another function.
fn at_value(
    graph: &mut Graph,
    row: Expr,
    derivatives: &[Expr],
    variables: &[Symbol],
    value: i64,
) -> Option<(Vec<Expr>, Expr)> {
    let number = graph.integer(value);
    let map: Vec<(Symbol, Expr)> = variables.iter().map(|variable| (*variable, number)).collect();
    let mut parts = derivatives.to_vec();
    parts.push(row);
    let mut entries = graph.substitute(&parts, &map);
    let at = entries.pop()?;
    let slope = graph.sum(&entries);
    let moved = graph.mul(number, slope);
    let rest = graph.sub(at, moved);
    let vars = graph.vars(variables);
    let products: Vec<Expr> = entries.iter().zip(vars).map(|(entry, var)| graph.mul(*entry, var)).collect();
    let sum = graph.sum(&products);
    let split = graph.add(sum, rest);
    graph.identical(row, split).then_some((entries, rest))
}
