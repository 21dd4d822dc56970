//! Independent speeds that are combinations of the carriers, u = L w + l0.
//!
//! The rows C w + η = 0 and these readings are inverted together: with E = [C; L], w = E⁻¹ [-η; u - l0], so that D2ᵀ is made
//! of the columns of E⁻¹ that belong to u, and ẇ = E⁻¹ [-c0*; u̇ - (L̇ w + l̇0)] gives the bias. With unit rows in L these are
//! the formulas of elimination: [-C_d⁻¹ C_i; 1] and [-C_d⁻¹ c0*; 0]. Where C alone has no good pivots E may have them.

use super::Simplifier;
use super::carriers::{CarriedRow, Carriers};
use super::constraints::DifferentiatedRow;
use super::elimination::{Choice, Elimination, Stuck, eliminate};
use super::guards::readable;
use super::messages;
use super::tangent::Tangent;
use crate::model::{Independent, InitialSystem};
use crate::symbolic::{Expr, Graph, Matrix, Symbol};
use crate::syntax::Diagnostics;

/// The tangent basis for the speeds of a chart, of which some are no carriers.
#[allow(clippy::too_many_arguments)]
pub fn combined(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    rows: &[DifferentiatedRow],
    kept: &[usize],
    carried: &[CarriedRow],
    carriers: &Carriers,
    choice: &Independent,
    errors: &mut Diagnostics,
) -> Option<Tangent> {
    let graph = &mut system.graph;
    let (m, width) = (carried.len(), carriers.speeds.len());
    let gradients = Matrix::from_rows(carried.iter().map(|row| row.gradient.clone()).collect(), width);
    let readings = choice.speeds.iter().map(|speed| speed.gradient.clone());
    let bordered = carried.iter().map(|row| row.gradient.clone()).chain(readings).collect();
    let bordered = Matrix::from_rows(bordered, width);
    let elimination =
        match eliminate(graph, simplifier, &bordered, &Choice { columns: vec![true; width], new_guards: true }) {
            Ok(elimination) => elimination,
            Err(stuck) => {
                let names = carried.iter().map(|row| rows[kept[row.row]].name.clone()).collect();
                dependent(graph, simplifier, &stuck, names, choice, errors);
                return None;
            }
        };
    let speeds: Vec<Symbol> = choice.speeds.iter().map(|speed| speed.symbol).collect();
    let readings: Vec<Expr> = choice.speeds.iter().map(|speed| speed.expr).collect();
    let offsets: Vec<Expr> =
        carried.iter().map(|row| row.offset).chain(choice.speeds.iter().map(|speed| speed.offset)).collect();
    // c0*, and the rate of L w + l0 with ẇ = 0.
    let mut biases: Vec<Expr> = carried.iter().map(|row| row.bias).collect();
    biases.extend(graph.along(&readings, &carriers.motion));
    let offset = elimination.solve(graph, simplifier, &offsets);
    let bias = elimination.solve(graph, simplifier, &biases);
    let mut complement = Matrix::zeros(graph, speeds.len(), width);
    for i in 0..speeds.len() {
        for (row, column) in elimination.pivots.iter().enumerate() {
            let entry = simplifier.one(graph, elimination.inverse.get(row, m + i));
            complement.set(i, *column, entry);
        }
    }
    let u = graph.vars(&speeds);
    let w = complement.transpose().mul_vec(graph, &u);
    let mut map = Vec::new();
    for (column, eta) in elimination.pivots.iter().zip(offset) {
        let value = graph.sub(w[*column], eta);
        let carrier = carriers.speeds[*column];
        if value != graph.var(carrier) {
            map.push((carrier, simplifier.one(graph, value)));
        }
    }
    let mut rates = vec![graph.zero(); width];
    for (column, value) in elimination.pivots.iter().zip(bias) {
        let value = graph.substitute(&[value], &map)[0];
        let value = graph.neg(value);
        rates[*column] = simplifier.one(graph, value);
    }
    simplifier.settle(graph, &rates);
    let mut names: Vec<String> = carried.iter().map(|row| rows[kept[row.row]].name.clone()).collect();
    names.extend(speeds.iter().map(|speed| graph.name(*speed).to_owned()));
    let note = note(graph, carriers, &elimination, &names, choice);
    Some(Tangent {
        speeds,
        complement,
        map,
        bias: rates,
        rows: carried.iter().map(|row| row.row).collect(),
        gradients,
        pivots: elimination.values.clone(),
        elimination: Some(elimination),
        readings: Some(readings),
        note: Some(note),
    })
}

/// Says which speed follows from the rows and the other speeds.
fn dependent(
    graph: &mut Graph,
    simplifier: &mut dyn Simplifier,
    stuck: &Stuck,
    mut names: Vec<String>,
    choice: &Independent,
    errors: &mut Diagnostics,
) {
    let m = names.len();
    names.extend(choice.speeds.iter().map(|speed| graph.name(speed.symbol).to_owned()));
    let combination = match stuck {
        Stuck::Dependent { combination, .. } => combination.as_slice(),
        Stuck::Forbidden { .. } | Stuck::NeedsGuard => &[],
    };
    // The rows of constraints are independent, so that some speed takes part.
    let taking_part = |at: &usize| combination.get(*at).is_some_and(|weight| !graph.vanishes(*weight));
    let last = (m..names.len()).rev().find(taking_part);
    let Some(last) = last else {
        errors.report(choice.span, messages::combinations_not_independent("", ""));
        return;
    };
    let mut parts = Vec::new();
    for (at, weight) in combination.iter().enumerate().filter(|(at, _)| *at != last) {
        let quotient = graph.div(*weight, combination[last]);
        let factor = graph.neg(quotient);
        if !graph.vanishes(factor) {
            parts.push((names[at].as_str(), simplifier.one(graph, factor)));
        }
    }
    let text = messages::combination(graph, &parts);
    errors.report(choice.speeds[last - m].place, messages::combinations_not_independent(&names[last], &text));
}

/// The choice, told to a person.
fn note(
    graph: &Graph,
    carriers: &Carriers,
    elimination: &Elimination,
    rows: &[String],
    choice: &Independent,
) -> String {
    let speeds = choice.speeds.iter().map(|speed| match carriers.speeds.contains(&speed.symbol) {
        true => graph.name(speed.symbol).to_owned(),
        false => format!("{} = {}", graph.name(speed.symbol), graph.display(speed.expr)),
    });
    let pivots = elimination.pivots.iter().zip(&elimination.values).zip(elimination.pivot_names(rows));
    let pivots = pivots.filter(|((column, _), _)| !choice.speeds.iter().any(|s| s.symbol == carriers.speeds[**column]));
    let pivots = pivots.map(|((column, value), called)| {
        format!("{} ({})", graph.name(carriers.speeds[*column]), readable(graph, *value, &called))
    });
    format!(
        "independent speeds {}, named by the model; the speeds that follow from them and the constraints, with their \
         pivots: {}",
        speeds.collect::<Vec<_>>().join(", "),
        pivots.collect::<Vec<_>>().join(", ")
    )
}
