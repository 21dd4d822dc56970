//! The tangent basis D and the bias a_u, so that v = Dᵀ u + v_p and v̇ = Dᵀ u̇ + a_u.
//!
//! Two stages. The configuration x = g(q, t), if there is one, gives partial velocities (4.9): its rates are the
//! carriers w, and v = D1ᵀ w + v_1. Without one the carriers are v itself. The rows that the configuration does not
//! satisfy by itself are then eliminated among the carriers, w = D2ᵀ u + w_p with a unit block in D2, or the user's
//! complement is taken. With a unit block the bias is [-C_d⁻¹ c0*; 0], without any derivative of D.

use super::Simplifier;
use super::constraints::{DifferentiatedRow, motion};
use super::dependence::independent;
use super::elimination::{Choice, Elimination, Stuck, eliminate};
use super::factorisation::factorise;
use super::messages;
use crate::model::{IndependentSpeed, InitialSystem};
use crate::symbolic::{Expr, Graph, Kind, Matrix, Symbol};
use crate::syntax::Diagnostics;

/// The first stage: from the initial system to the carriers w.
#[derive(Clone, Debug)]
pub struct Carriers {
    /// Coordinates of the state.
    pub coordinates: Vec<Symbol>,
    /// w: the rates of q, or v.
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
    /// Whether further rows bind the carriers, but repeat these there.
    pub overlapping: bool,
    /// How they were eliminated; `None` where the user gave D.
    pub elimination: Option<Elimination>,
    /// Pivots of this stage, in terms of the state.
    pub pivots: Vec<Expr>,
    /// The choice, told to a person.
    pub note: Option<String>,
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
    let rates = graph.vars(&configuration.rates);
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
    let partial = graph.jacobian(&velocities, &configuration.rates);
    let bias = graph.along(&velocities, &motion);
    let mut map = positions;
    map.extend(system.speeds.iter().copied().zip(velocities));
    Carriers {
        coordinates: configuration.coordinates,
        speeds: configuration.rates,
        motion,
        map,
        partial_velocities: Some(partial),
        bias,
    }
}

/// A row of C in terms of the carriers.
#[derive(Clone, Debug)]
struct CarriedRow {
    /// Its position in C.
    row: usize,
    gradient: Vec<Expr>,
    /// η: the row's value at w = 0.
    offset: Expr,
    /// c0*.
    bias: Expr,
}

/// The rows that still bind the carriers, and whether some of them repeated others. Rows that the configuration
/// satisfies are gone; one that it makes impossible is an error.
fn carried(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    rows: &[DifferentiatedRow],
    kept: &[usize],
    carriers: &Carriers,
    errors: &mut Diagnostics,
) -> (Vec<CarriedRow>, bool) {
    let graph = &mut system.graph;
    let zero = graph.zero();
    let at_rest: Vec<(Symbol, Expr)> = carriers.speeds.iter().map(|w| (*w, zero)).collect();
    let velocities: Vec<Expr> = kept.iter().map(|i| rows[*i].velocity).collect();
    let velocities = graph.substitute(&velocities, &carriers.map);
    let mut carried = Vec::new();
    for (position, velocity) in velocities.into_iter().enumerate() {
        let row = &rows[kept[position]];
        let velocity = if carriers.map.is_empty() { velocity } else { simplifier.one(graph, velocity) };
        let gradient: Vec<Expr> = graph
            .jacobian(&[velocity], &carriers.speeds)
            .row(0)
            .iter()
            .map(|e| if graph.vanishes(*e) { zero } else { *e })
            .collect();
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
        let mut position = 0..all;
        carried.retain(|_| position.next().is_some_and(|i| keep.contains(&i)));
    }
    let overlapping = carried.len() < all;
    (carried, overlapping)
}

/// The tangent basis among the carriers: the user's complement, or by elimination.
pub fn tangent(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    rows: &[DifferentiatedRow],
    kept: &[usize],
    carriers: &Carriers,
    errors: &mut Diagnostics,
) -> Option<Tangent> {
    let (carried, overlapping) = carried(system, simplifier, rows, kept, carriers, errors);
    if !errors.is_empty() {
        return None;
    }
    if system.complement.is_some() {
        let given = given(system, simplifier, rows, kept, &carried, carriers, errors);
        return given.map(|tangent| Tangent { overlapping, ..tangent });
    }
    let independent = chosen(system, carriers, carried.len(), errors)?;
    let by_user = independent.is_some();
    let width = carriers.speeds.len();
    let columns = match &independent {
        Some(list) => (0..width).map(|j| !list.contains(&j)).collect(),
        None => vec![true; width],
    };
    let graph = &mut system.graph;
    let c = Matrix::from_rows(carried.iter().map(|row| row.gradient.clone()).collect(), width);
    let elimination = match eliminate(graph, simplifier, &c, &Choice { columns, new_guards: true }) {
        Ok(elimination) => elimination,
        Err(stuck) => {
            let row = match stuck {
                Stuck::Dependent { row, .. } | Stuck::Forbidden { row } => carried[row].row,
                Stuck::NeedsGuard => 0,
            };
            let names: Vec<&str> = carriers.speeds.iter().map(|s| graph.name(*s)).collect();
            let span = if by_user { system.places.independent } else { rows[kept[row]].span };
            errors.report(span, messages::not_independent(&rows[kept[row]].name, &names));
            return None;
        }
    };
    let order = independent.unwrap_or_else(|| (0..width).filter(|j| !elimination.pivots.contains(j)).collect());
    let offsets: Vec<Expr> = carried.iter().map(|row| row.offset).collect();
    let biases: Vec<Expr> = carried.iter().map(|row| row.bias).collect();
    let offset = elimination.inverse.mul_vec(graph, &offsets);
    let bias = elimination.inverse.mul_vec(graph, &biases);
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
    let u = graph.vars(&speeds);
    let w = complement.transpose().mul_vec(graph, &u);
    let map: Vec<(Symbol, Expr)> = elimination
        .pivots
        .iter()
        .zip(&offset)
        .map(|(pivot, eta)| {
            let value = graph.sub(w[*pivot], *eta);
            (carriers.speeds[*pivot], simplifier.one(graph, value))
        })
        .collect();
    let mut dependent = vec![graph.zero(); width];
    for (pivot, c0) in elimination.pivots.iter().zip(bias) {
        let value = graph.substitute(&[c0], &map)[0];
        let value = graph.neg(value);
        dependent[*pivot] = simplifier.one(graph, value);
    }
    let note = note(graph, carriers, &elimination, &speeds, by_user);
    let pivots = elimination.values.clone();
    let rows = carried.iter().map(|row| row.row).collect();
    let elimination = Some(elimination);
    Some(Tangent {
        speeds,
        complement,
        map,
        bias: dependent,
        rows,
        gradients: c,
        overlapping,
        elimination,
        pivots,
        note,
    })
}

/// The positions of the independent speeds that the user names, checked; `None` where the choice is ours.
#[allow(clippy::option_option)]
fn chosen(
    system: &InitialSystem,
    carriers: &Carriers,
    rows: usize,
    errors: &mut Diagnostics,
) -> Option<Option<Vec<usize>>> {
    let width = carriers.speeds.len();
    let Some(list) = &system.independent else {
        return Some(None);
    };
    let graph = &system.graph;
    let mut columns = Vec::with_capacity(list.len());
    for IndependentSpeed { expr, place, .. } in list {
        match graph.as_symbol(*expr).and_then(|s| carriers.speeds.iter().position(|w| *w == s)) {
            Some(j) if columns.contains(&j) => {
                errors.report(*place, messages::independent_twice(graph.name(carriers.speeds[j])));
            }
            Some(j) => columns.push(j),
            None => {
                let names: Vec<&str> = carriers.speeds.iter().map(|s| graph.name(*s)).collect();
                errors.report(*place, messages::not_a_speed(&names));
            }
        }
    }
    if errors.is_empty() && columns.len() + rows != width {
        let span = system.places.independent;
        errors.report(span, messages::wrong_number_independent(columns.len(), width, rows));
    }
    errors.is_empty().then_some(Some(columns))
}

fn note(graph: &Graph, carriers: &Carriers, e: &Elimination, speeds: &[Symbol], by_user: bool) -> Option<String> {
    if e.pivots.is_empty() {
        return None;
    }
    let names = |symbols: Vec<Symbol>| symbols.iter().map(|s| graph.name(*s)).collect::<Vec<_>>().join(", ");
    let who = if by_user { "named by the model" } else { "chosen by the cheapest pivots" };
    let pivots: Vec<String> = e
        .pivots
        .iter()
        .zip(&e.values)
        .map(|(j, value)| format!("{} ({})", graph.name(carriers.speeds[*j]), graph.display(*value)))
        .collect();
    Some(format!(
        "independent speeds {}, {who}; dependent speeds with their pivots: {}",
        names(speeds.to_vec()),
        pivots.join(", ")
    ))
}

/// D as the user gives it: D Cᵀ ≡ 0 decided, its rank checked, a_u by differentiation along the motion.
fn given(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    rows: &[DifferentiatedRow],
    kept: &[usize],
    carried: &[CarriedRow],
    carriers: &Carriers,
    errors: &mut Diagnostics,
) -> Option<Tangent> {
    let declared = system.complement.clone()?;
    let graph = &mut system.graph;
    let width = carriers.speeds.len();
    let span = system.places.complement;
    for d in &declared {
        for row in carried {
            let terms: Vec<Expr> = d.entries.iter().zip(&row.gradient).map(|(a, b)| graph.mul(*a, *b)).collect();
            let product = graph.sum(&terms);
            if !graph.vanishes(product) {
                let product = simplifier.one(graph, product);
                let text = graph.display(product);
                errors.report(d.span, messages::not_a_complement(&d.name, &rows[kept[row.row]].name, &text));
            }
        }
    }
    if declared.len() + carried.len() != width {
        errors.report(span, messages::wrong_number_complement(declared.len(), width, carried.len()));
    }
    let entries: Vec<Vec<Expr>> = declared.iter().map(|row| row.entries.clone()).collect();
    let order: Vec<usize> = (0..declared.len()).collect();
    let independent = independent(graph, &entries, &order);
    for i in order.iter().filter(|i| !independent.contains(i)) {
        errors.report(declared[*i].span, messages::complement_dependent(&declared[*i].name));
    }
    if !errors.is_empty() {
        return None;
    }
    let speeds: Vec<Symbol> = declared.iter().map(|row| graph.symbol(&row.name, Kind::Speed)).collect();
    let complement = Matrix::from_rows(entries, width);
    let u = graph.vars(&speeds);
    let mut w = complement.transpose().mul_vec(graph, &u);
    let mut pivots = Vec::new();
    if !carried.iter().all(|row| graph.vanishes(row.offset)) {
        let (particular, divisors) = particular(graph, simplifier, carried, width);
        pivots = divisors;
        w.iter_mut().zip(particular).for_each(|(w, p)| *w = graph.add(*w, p));
    }
    let map: Vec<(Symbol, Expr)> = carriers.speeds.iter().copied().zip(w.iter().copied()).collect();
    let rates: Vec<Expr> = carriers.motion.iter().map(|(_, rate)| *rate).collect();
    let rates = graph.substitute(&rates, &map);
    let motion: Vec<(Symbol, Expr)> = carriers.motion.iter().map(|(s, _)| *s).zip(rates).collect();
    let bias = graph.along(&w, &motion);
    let bias = bias.into_iter().map(|e| simplifier.one(graph, e)).collect();
    let gradients = Matrix::from_rows(carried.iter().map(|row| row.gradient.clone()).collect(), width);
    let rows = carried.iter().map(|row| row.row).collect();
    Some(Tangent {
        speeds,
        complement,
        map,
        bias,
        rows,
        gradients,
        overlapping: false,
        elimination: None,
        pivots,
        note: None,
    })
}

/// A particular solution of C v_p = -η, and what it divides by: with the pivots of C where they need no new guard, else
/// the one of least norm, -Cᵀ (C Cᵀ)⁻¹ η, which is regular wherever the rows are independent.
fn particular(
    graph: &mut Graph,
    simplifier: &mut dyn Simplifier,
    carried: &[CarriedRow],
    width: usize,
) -> (Vec<Expr>, Vec<Expr>) {
    let c = Matrix::from_rows(carried.iter().map(|row| row.gradient.clone()).collect(), width);
    let offsets: Vec<Expr> = carried.iter().map(|row| graph.neg(row.offset)).collect();
    let mut solution = vec![graph.zero(); width];
    let choice = Choice { columns: vec![true; width], new_guards: false };
    if let Ok(elimination) = eliminate(graph, simplifier, &c, &choice) {
        let at_pivots = elimination.inverse.mul_vec(graph, &offsets);
        elimination.pivots.iter().zip(at_pivots).for_each(|(j, value)| solution[*j] = value);
        return (solution, Vec::new());
    }
    let transposed = c.transpose();
    let normal = c.mul(graph, &transposed).map(|e| e.iter().map(|e| simplifier.one(graph, *e)).collect());
    match factorise(graph, simplifier, &normal) {
        Ok(factors) => {
            let weights = factors.solve(graph, simplifier, &offsets);
            (transposed.mul_vec(graph, &weights), factors.pivots)
        }
        // Independent rows have a regular C Cᵀ; as a value, the zero pivot stops every run.
        Err(_) => (solution, vec![graph.zero()]),
    }
}
