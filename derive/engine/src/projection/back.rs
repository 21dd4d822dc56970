//! The way back: the carriers and the independent speeds from v, for any v that a run arrives with.
//!
//! Where v = g(u, x, t) (5.8) is given and not linear in u, there is no closed form: what is emitted is a Gauss-Newton step
//! from the speeds of the state at hand, u + (D Dᵀ)⁻¹ D (v − g(u, x, t)), which is exact wherever g is linear.

use super::Simplifier;
use super::carriers::Carriers;
use super::factorisation::factorise;
use super::tangent::Tangent;
use crate::model::InitialSystem;
use crate::symbolic::{Expr, Graph, Matrix, Symbol};

/// The carriers w as functions of v, the state's coordinates and t: v itself, or the rates q̇ of a configuration, of
/// which those that are initial coordinates are read off A v + a0 and the others follow by least squares; or its
/// quasi-velocities, which follow from q̇ (4.3).
pub fn carriers_of_velocities(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    carriers: &Carriers,
) -> Vec<Expr> {
    let graph = &mut system.graph;
    let Some(configuration) = &system.configuration else { return graph.vars(&carriers.speeds) };
    let positions: Vec<(Symbol, Expr)> =
        system.coordinates.iter().copied().zip(configuration.map.iter().copied()).collect();
    let v = graph.vars(&system.speeds);
    let linear = system.kinematics.a.mul_vec(graph, &v);
    let rates: Vec<Expr> = linear.into_iter().zip(&system.kinematics.a0).map(|(a, b)| graph.add(a, *b)).collect();
    let rates = graph.substitute(&rates, &positions);
    let zero = graph.zero();
    let mut known: Vec<Option<Expr>> = Vec::new();
    for q in &configuration.coordinates {
        known.push(system.coordinates.iter().position(|x| x == q).map(|at| rates[at]));
    }
    // ẋ − g_t − J q̇ of the known ones = J q̇ of the others.
    let jacobian = graph.jacobian(&configuration.map, &configuration.coordinates);
    let one = graph.one();
    let in_time = graph.along(&configuration.map, &[(system.time, one)]);
    let others: Vec<usize> = (0..known.len()).filter(|j| known[*j].is_none()).collect();
    let rows = Matrix::from_fn(rates.len(), others.len(), |i, j| jacobian.get(i, others[j]));
    let at_known: Vec<Expr> = known.iter().map(|rate| rate.unwrap_or(zero)).collect();
    let moved = jacobian.mul_vec(graph, &at_known);
    let rest: Vec<Expr> = (0..rates.len())
        .map(|i| {
            let given = graph.add(in_time[i], moved[i]);
            graph.sub(rates[i], given)
        })
        .collect();
    let found = least_squares(graph, simplifier, &rows, &rest);
    let mut found = found.into_iter();
    let rates: Vec<Expr> = known.into_iter().map(|rate| rate.or_else(|| found.next()).unwrap_or(zero)).collect();
    let kinematics = system.configuration.as_ref().map(|configuration| configuration.kinematics.clone());
    let Some(kinematics) = kinematics else { return rates };
    let moved = kinematics.b.mul_vec(graph, &rates);
    moved.into_iter().zip(&kinematics.b0).map(|(rate, bias)| graph.add(rate, *bias)).collect()
}

/// The independent speeds of a chart from the carriers: those of the same name, the combinations that they are, or the
/// least-squares solution of w = D2ᵀ u + w_p where the user gave D, or g.
pub fn speeds_of_carriers(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    carriers: &Carriers,
    tangent: &Tangent,
    w: &[Expr],
) -> Vec<Expr> {
    let graph = &mut system.graph;
    if let Some(readings) = &tangent.readings {
        let at: Vec<(Symbol, Expr)> = carriers.speeds.iter().copied().zip(w.iter().copied()).collect();
        let found = graph.substitute(readings, &at);
        return found.into_iter().map(|e| simplifier.one(graph, e)).collect();
    }
    let own = |speed: &Symbol| carriers.speeds.iter().position(|carrier| carrier == speed);
    if let Some(columns) = tangent.speeds.iter().map(own).collect::<Option<Vec<usize>>>() {
        return columns.into_iter().map(|j| w[j]).collect();
    }
    let all = graph.vars(&carriers.speeds);
    let all = graph.substitute(&all, &tangent.map);
    let linear = !tangent.complement.entries().iter().any(|e| graph.contains(*e, &tangent.speeds));
    let zero = graph.zero();
    let guess: Vec<Expr> = match linear {
        true => vec![zero; tangent.speeds.len()],
        false => graph.vars(&tangent.speeds),
    };
    let at: Vec<(Symbol, Expr)> = tangent.speeds.iter().copied().zip(guess.iter().copied()).collect();
    let at_guess = graph.substitute(&all, &at);
    let rest: Vec<Expr> = w.iter().zip(at_guess).map(|(w, p)| graph.sub(*w, p)).collect();
    let step = least_squares(graph, simplifier, &tangent.complement.transpose(), &rest);
    guess.into_iter().zip(step).map(|(u, step)| graph.add(u, step)).collect()
}

/// The solution of (Rᵀ R) y = Rᵀ r: exact where R y = r has one, regular wherever R has full rank.
fn least_squares(graph: &mut Graph, simplifier: &mut dyn Simplifier, rows: &Matrix, right: &[Expr]) -> Vec<Expr> {
    let across = rows.transpose();
    let normal = across.mul(graph, rows).map(|e| e.iter().map(|e| simplifier.one(graph, *e)).collect());
    let moments: Vec<Expr> = across.mul_vec(graph, right).into_iter().map(|e| simplifier.one(graph, e)).collect();
    // Its pivots are positive by themselves wherever the state's coordinates are regular ones.
    let before = graph.assumptions();
    let solution = match factorise(graph, simplifier, &normal) {
        Ok(factors) => factors.solve(graph, simplifier, &moments),
        // Columns that are dependent everywhere were refused before.
        Err(_) => moments,
    };
    graph.assume_only(before);
    solution.into_iter().map(|e| simplifier.one(graph, e)).collect()
}
