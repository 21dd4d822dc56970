//! The tangent basis D and the bias a_u, so that v = Dᵀ u + v_p and v̇ = Dᵀ u̇ + a_u.
//!
//! The rows that bind the carriers are eliminated among them, w = D2ᵀ u + w_p with a unit block in D2, or together with
//! the combinations that the user wants as u, or the user's complement is taken. With a unit block the bias is [-C_d⁻¹ c0*; 0], without any derivative of D.

use super::carriers::{CarriedRow, Carriers};
use super::combined::combined;
use super::complement;
use super::constraints::DifferentiatedRow;
use super::elimination::{Choice, Elimination, Stuck, eliminate};
use super::guards::readable;
use super::messages;
use super::{Simplifier, given};
use crate::model::{Chosen, Independent, InitialSystem};
use crate::symbolic::{Expr, Graph, Matrix, Symbol};
use crate::syntax::Diagnostics;

/// The second stage: the independent speeds among the carriers.
#[derive(Clone, Debug)]
pub struct Tangent {
    /// u.
    pub speeds: Vec<Symbol>,
    /// D2, k x dim w.
    pub complement: Matrix,
    /// w(u) where it differs from a carrier of the same name.
    pub map: Vec<(Symbol, Expr)>,
    /// a_2, dim w: ẇ = D2ᵀ u̇ + a_2, in terms of the state.
    pub bias: Vec<Expr>,
    /// The rows (positions in C) that bind the carriers.
    pub rows: Vec<usize>,
    /// These rows of C in terms of the carriers, one column a carrier.
    pub gradients: Matrix,
    /// How they were eliminated; `None` where the user gave D. Where u are combinations of carriers, their readings stand
    /// below the rows.
    pub elimination: Option<Elimination>,
    /// u as functions of the carriers, where they are combinations of these.
    pub readings: Option<Vec<Expr>>,
    /// Pivots of this stage, in terms of the state.
    pub pivots: Vec<Expr>,
    /// The choice, told to a person.
    pub note: Option<String>,
}

impl Tangent {
    /// What each of the pivots is, over the names of the rows that bind the carriers.
    pub fn pivot_names(&self, graph: &Graph, rows: &[String]) -> Vec<String> {
        let mut names = rows.to_vec();
        match &self.elimination {
            Some(elimination) => {
                let speeds = self.speeds.iter().filter(|_| self.readings.is_some());
                names.extend(speeds.map(|speed| graph.name(*speed).to_owned()));
                elimination.pivot_names(&names)
            }
            None => (0..self.pivots.len()).map(|_| format!("pivot of C C\u{1d40} of {}", names.join(", "))).collect(),
        }
    }
}

/// The tangent basis among the carriers: the user's complement, or by elimination to the speeds of a chart.
#[allow(clippy::too_many_arguments)]
pub fn tangent(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    rows: &[DifferentiatedRow],
    kept: &[usize],
    carried: &[CarriedRow],
    carriers: &Carriers,
    chart: usize,
    errors: &mut Diagnostics,
) -> Option<Tangent> {
    if system.velocities.is_some() {
        return given::velocities(system, simplifier, rows, kept, carriers, errors);
    }
    if system.complement.is_some() {
        return complement::given(system, simplifier, rows, kept, carried, carriers, errors);
    }
    let choice = system.independent.get(chart).cloned();
    if let Some(choice) = &choice {
        let (width, m) = (carriers.speeds.len(), carried.len());
        if choice.speeds.len() + m != width {
            let norms = system.norm_rates().len();
            let message = messages::wrong_number_independent(choice.speeds.len(), width - norms, m - norms);
            errors.report(choice.span, message);
            return None;
        }
    }
    let independent = match &choice {
        Some(choice) => match columns(choice, carriers) {
            Some(columns) => Some(columns),
            None => return combined(system, simplifier, rows, kept, carried, carriers, choice, errors),
        },
        None => system.chosen.as_ref().and_then(|chosen| places(&chosen.speeds, carriers)),
    };
    let why = match (&choice, &system.chosen) {
        (Some(_), _) => "named by the model".to_owned(),
        (None, Some(Chosen { reason: Some(reason), .. })) => reason.clone(),
        (None, _) => "chosen by the cheapest pivots".to_owned(),
    };
    let width = carriers.speeds.len();
    let columns = match &independent {
        Some(list) => (0..width).map(|j| !list.contains(&j)).collect(),
        None => vec![true; width],
    };
    let norm_rates = system.norm_rates();
    let swept = system.swept.is_some();
    let graph = &mut system.graph;
    let c = Matrix::from_rows(carried.iter().map(|row| row.gradient.clone()).collect(), width);
    let elimination = match eliminate(graph, simplifier, &c, &Choice { columns, new_guards: true }) {
        Ok(elimination) => elimination,
        Err(stuck) => {
            let row = match stuck {
                Stuck::Dependent { row, .. } | Stuck::Forbidden { row } => carried[row].row,
                Stuck::NeedsGuard => 0,
            };
            let free = carriers.speeds.iter().filter(|s| !norm_rates.contains(s));
            let names: Vec<&str> = free.map(|s| graph.name(*s)).collect();
            let span = choice.map_or(rows[kept[row]].span, |choice| choice.span);
            errors.report(span, messages::not_independent(&rows[kept[row]].name, &names));
            return None;
        }
    };
    let order = independent.unwrap_or_else(|| (0..width).filter(|j| !elimination.pivots.contains(j)).collect());
    let offsets: Vec<Expr> = carried.iter().map(|row| row.offset).collect();
    let biases: Vec<Expr> = carried.iter().map(|row| row.bias).collect();
    let offset = elimination.solve(graph, simplifier, &offsets);
    let bias = elimination.solve(graph, simplifier, &biases);
    // w_d = -C_d⁻¹ C_i u - C_d⁻¹ η
    let mut complement = Matrix::zeros(graph, order.len(), width);
    for (i, j) in order.iter().enumerate() {
        complement.set(i, *j, graph.one());
        for (row, pivot) in elimination.pivots.iter().enumerate() {
            let entry = graph.neg(elimination.reduced.get(row, *j));
            complement.set(i, *pivot, entry);
        }
    }
    let speeds: Vec<Symbol> = order.iter().map(|j| carriers.speeds[*j]).collect();
    // Of a tree the rows are short, and D is not: w_d = -C_d⁻¹ φ where these are at rest.
    let at_rest = swept.then(|| {
        let zero = graph.zero();
        let still: Vec<(Symbol, Expr)> = elimination.pivots.iter().map(|j| (carriers.speeds[*j], zero)).collect();
        let velocities: Vec<Expr> = carried.iter().filter_map(|row| rows[kept[row.row]].velocity).collect();
        let velocities = graph.substitute(&velocities, &still);
        elimination.solve(graph, simplifier, &velocities)
    });
    let u = graph.vars(&speeds);
    let w = if swept { Vec::new() } else { complement.transpose().mul_vec(graph, &u) };
    let mut map: Vec<(Symbol, Expr)> = Vec::with_capacity(elimination.pivots.len());
    for (row, pivot) in elimination.pivots.iter().enumerate() {
        let value = match &at_rest {
            Some(values) => graph.neg(values[row]),
            None => graph.sub(w[*pivot], offset[row]),
        };
        map.push((carriers.speeds[*pivot], simplifier.one(graph, value)));
    }
    let mut dependent = vec![graph.zero(); width];
    for (pivot, c0) in elimination.pivots.iter().zip(bias) {
        let value = graph.substitute(&[c0], &map)[0];
        let value = graph.neg(value);
        dependent[*pivot] = simplifier.one(graph, value);
    }
    simplifier.settle(graph, &dependent);
    let names: Vec<String> = carried.iter().map(|row| rows[kept[row.row]].name.clone()).collect();
    let norms = rows.iter().filter(|row| !row.reaction).map(|row| row.name.as_str()).collect::<Vec<_>>();
    let note = note(graph, carriers, &elimination, (&names, &norms), &speeds, &why);
    let pivots = elimination.values.clone();
    let rows = carried.iter().map(|row| row.row).collect();
    let elimination = Some(elimination);
    let bias = dependent;
    Some(Tangent { speeds, complement, map, bias, rows, gradients: c, elimination, readings: None, pivots, note })
}

/// The positions of the speeds among the carriers; `None` where some are combinations of these.
fn columns(choice: &Independent, carriers: &Carriers) -> Option<Vec<usize>> {
    let speeds: Vec<Symbol> = choice.speeds.iter().map(|speed| speed.symbol).collect();
    places(&speeds, carriers)
}

fn places(speeds: &[Symbol], carriers: &Carriers) -> Option<Vec<usize>> {
    speeds.iter().map(|speed| carriers.speeds.iter().position(|w| w == speed)).collect()
}

fn note(
    graph: &Graph,
    carriers: &Carriers,
    e: &Elimination,
    (rows, norms): (&[String], &[&str]),
    speeds: &[Symbol],
    why: &str,
) -> Option<String> {
    if rows.iter().all(|row| norms.contains(&row.as_str())) {
        return None;
    }
    let names = |symbols: Vec<Symbol>| symbols.iter().map(|s| graph.name(*s)).collect::<Vec<_>>().join(", ");
    let pivots: Vec<String> = e
        .pivots
        .iter()
        .zip(&e.values)
        .zip(e.pivot_names(rows))
        .zip(rows)
        .filter(|(_, row)| !norms.contains(&row.as_str()))
        .map(|(((j, value), called), _)| {
            format!("{} ({})", graph.name(carriers.speeds[*j]), readable(graph, *value, &called))
        })
        .collect();
    Some(format!(
        "independent speeds {}, {why}; dependent speeds with their pivots: {}",
        names(speeds.to_vec()),
        pivots.join(", ")
    ))
}
