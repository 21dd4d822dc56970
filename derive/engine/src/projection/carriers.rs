//! The first stage: the carriers w of the motion, and the rows that still bind them.
//!
//! The configuration x = g(q, t), if there is one, gives partial velocities (4.9): its rates are the carriers, and
//! v = D1ᵀ w + v_1; where it names quasi-velocities with q̇ = Ã w + ã0 (4.3), these are. Without one the carriers are v itself.

use super::Simplifier;
use super::constraints::{DifferentiatedRow, motion};
use super::dependence::{combination, independent};
use super::elimination::{Choice, eliminate};
use super::messages;
use crate::model::InitialSystem;
use crate::symbolic::{Expr, Graph, Matrix, Symbol};
use crate::syntax::Diagnostics;

/// The first stage: from the initial system to the carriers w.
#[derive(Clone, Debug)]
pub struct Carriers {
    /// Coordinates of the state.
    pub coordinates: Vec<Symbol>,
    /// w: the rates of q, the configuration's quasi-velocities, or v.
    pub speeds: Vec<Symbol>,
    /// Rates of the coordinates in (w, coordinates, t), and ṫ.
    pub motion: Vec<(Symbol, Expr)>,
    /// x and v in terms of the carriers; empty without a configuration.
    pub map: Vec<(Symbol, Expr)>,
    /// D1ᵀ = ∂v/∂w, n x dim w; `None` without a configuration, where it is the unit matrix.
    pub partial_velocities: Option<Matrix>,
    /// a_1, n: v̇ = D1ᵀ ẇ + a_1.
    pub bias: Vec<Expr>,
}

/// The carriers of the system.
pub fn carriers(system: &mut InitialSystem, simplifier: &mut dyn Simplifier) -> Carriers {
    let Some(configuration) = system.configuration.clone() else {
        let zero = system.graph.zero();
        return Carriers {
            coordinates: system.coordinates.clone(),
            speeds: system.speeds.clone(),
            motion: motion(system),
            map: Vec::new(),
            partial_velocities: None,
            bias: vec![zero; system.speeds.len()],
        };
    };
    let graph = &mut system.graph;
    // q̇ = Ã w + ã0 (4.3); w is q̇ itself where the configuration names no speeds.
    let speeds = graph.vars(&configuration.speeds);
    let moved = configuration.kinematics.a.mul_vec(graph, &speeds);
    let biased = moved.into_iter().zip(&configuration.kinematics.a0);
    let rates: Vec<Expr> = biased.map(|(rate, bias)| graph.add(rate, *bias)).collect();
    let one = graph.one();
    let mut motion: Vec<(Symbol, Expr)> = configuration.coordinates.iter().copied().zip(rates).collect();
    motion.push((system.time, one));
    // ẋ = J q̇ + g_t, then v = B ẋ + b0 (2.2) at x = g: (4.4).
    let x_rates = graph.along(&configuration.map, &motion);
    let positions: Vec<(Symbol, Expr)> =
        system.coordinates.iter().copied().zip(configuration.map.iter().copied()).collect();
    let b = system.kinematics.b.map(|entries| graph.substitute(entries, &positions));
    let b0 = graph.substitute(&system.kinematics.b0, &positions);
    let linear = b.mul_vec(graph, &x_rates);
    let velocities: Vec<Expr> = linear
        .into_iter()
        .zip(b0)
        .map(|(a, b)| {
            let v = graph.add(a, b);
            simplifier.one(graph, v)
        })
        .collect();
    let partial = graph.jacobian(&velocities, &configuration.speeds);
    let bias = graph.along(&velocities, &motion);
    let mut map = positions;
    map.extend(system.speeds.iter().copied().zip(velocities));
    Carriers {
        coordinates: configuration.coordinates,
        speeds: configuration.speeds,
        motion,
        map,
        partial_velocities: Some(partial),
        bias,
    }
}

/// A row of C in terms of the carriers.
#[derive(Clone, Debug)]
pub struct CarriedRow {
    /// Its position in C.
    pub row: usize,
    /// Its entries, one a carrier.
    pub gradient: Vec<Expr>,
    /// η: the row's value at w = 0.
    pub offset: Expr,
    /// c0*.
    pub bias: Expr,
}

/// The rows that still bind the carriers, and whether some of them repeated others. Rows that the configuration
/// satisfies are gone, as are those that bind accelerations alone; one that it makes impossible is an error.
pub fn carried(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    rows: &[DifferentiatedRow],
    kept: &[usize],
    carriers: &Carriers,
    errors: &mut Diagnostics,
) -> (Vec<CarriedRow>, bool) {
    let known = system.swept.is_some();
    let graph = &mut system.graph;
    let zero = graph.zero();
    let at_rest: Vec<(Symbol, Expr)> = carriers.speeds.iter().map(|w| (*w, zero)).collect();
    let binding: Vec<usize> = (0..kept.len()).filter(|position| rows[kept[*position]].binds_speeds()).collect();
    let velocities: Vec<Expr> = binding.iter().filter_map(|position| rows[kept[*position]].velocity).collect();
    let velocities = graph.substitute(&velocities, &carriers.map);
    let mut carried = Vec::new();
    for (position, velocity) in binding.into_iter().zip(velocities) {
        let row = &rows[kept[position]];
        let velocity = if carriers.map.is_empty() { velocity } else { simplifier.one(graph, velocity) };
        // Of a tree the carriers are v, and C is known.
        let gradient =
            if known { row.gradient.clone() } else { graph.jacobian(&[velocity], &carriers.speeds).row(0).to_vec() };
        let gradient: Vec<Expr> = gradient.into_iter().map(|e| if graph.vanishes(e) { zero } else { e }).collect();
        if gradient.iter().all(|e| graph.is_zero(*e)) {
            if !graph.vanishes(velocity) {
                errors.report(row.span, messages::excluded_by_configuration(&row.name));
            }
            continue;
        }
        let offset = graph.substitute(&[velocity], &at_rest)[0];
        let bias = graph.along(&[velocity], &carriers.motion)[0];
        carried.push(CarriedRow { row: position, gradient, offset, bias });
    }
    let all = carried.len();
    if carriers.partial_velocities.is_some() {
        // Rows that were independent in v may repeat each other once the configuration has taken its share.
        let gradients: Vec<Vec<Expr>> = carried.iter().map(|row| row.gradient.clone()).collect();
        let order: Vec<usize> = (0..all).collect();
        let keep = independent(&system.graph, &gradients, &order);
        let basis: Vec<&CarriedRow> = keep.iter().map(|i| &carried[*i]).collect();
        let repeated = order.iter().filter(|i| !keep.contains(i)).map(|i| &carried[*i]);
        check_repeated(&mut system.graph, simplifier, &basis, repeated, |row| &rows[kept[row]], errors);
        let mut position = 0..all;
        carried.retain(|_| position.next().is_some_and(|i| keep.contains(&i)));
    }
    let overlapping = carried.len() < all;
    (carried, overlapping)
}

/// Rows that repeat others among the carriers must say the same there.
fn check_repeated<'a>(
    graph: &mut Graph,
    simplifier: &mut dyn Simplifier,
    basis: &[&CarriedRow],
    repeated: impl Iterator<Item = &'a CarriedRow>,
    declared: impl Fn(usize) -> &'a DifferentiatedRow,
    errors: &mut Diagnostics,
) {
    let mut repeated = repeated.peekable();
    if repeated.peek().is_none() {
        return;
    }
    let width = basis.first().map_or(0, |row| row.gradient.len());
    let c = Matrix::from_rows(basis.iter().map(|row| row.gradient.clone()).collect(), width);
    // Pivots that serve only this question must not become guards of the model.
    graph.without_new_assumptions(|graph| {
        let choice = Choice { columns: vec![true; width], new_guards: true };
        let Ok(elimination) = eliminate(graph, simplifier, &c, &choice) else { return };
        for row in repeated {
            let coefficients = combination(graph, simplifier, &elimination, &row.gradient);
            let terms: Vec<Expr> = coefficients.iter().zip(basis).map(|(c, k)| graph.mul(*c, k.offset)).collect();
            let total = graph.sum(&terms);
            if !graph.identical(row.offset, total) {
                let DifferentiatedRow { name, span, .. } = declared(row.row);
                errors.report(*span, messages::excluded_by_configuration(name));
            }
        }
    });
}
