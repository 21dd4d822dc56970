//! The basis D from v = g(u, x, t) (5.8), (5.9).
//!
//! With v = g(u, x, t) every row, linear or not, has minimal form: Dᵀ = ∂g/∂u, a_u = ∂g/∂x ẋ + ∂g/∂t, and
//! M_d u̇ = D (h* − M a_u) is the equation of motion (method of (4.10)). D depends on u then. With a configuration g gives
//! its rates, and the stages chain.

use super::Simplifier;
use super::carriers::Carriers;
use super::constraints::DifferentiatedRow;
use super::dependence::independent;
use super::messages;
use super::tangent::Tangent;
use crate::model::InitialSystem;
use crate::symbolic::{Expr, Matrix, Symbol};
use crate::syntax::Diagnostics;

/// φ(g(u, x, t), x, t) ≡ 0 decided for every row that binds speeds, the rank of ∂g/∂u checked.
pub fn velocities(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    rows: &[DifferentiatedRow],
    kept: &[usize],
    carriers: &Carriers,
    errors: &mut Diagnostics,
) -> Option<Tangent> {
    let given = system.velocities.clone()?;
    let graph = &mut system.graph;
    for i in kept {
        let Some(velocity) = rows[*i].velocity else { continue };
        let carried = graph.substitute(&[velocity], &carriers.map);
        let value = graph.substitute(&carried, &given.map)[0];
        if !graph.vanishes(value) {
            let value = simplifier.one(graph, value);
            errors.report(rows[*i].span, messages::velocities_miss(&rows[*i].name, &graph.display(value)));
        }
    }
    let w = graph.vars(&carriers.speeds);
    let w = graph.substitute(&w, &given.map);
    let slopes = graph.jacobian(&w, &given.speeds);
    let complement = slopes.transpose().map(|entries| entries.iter().map(|e| simplifier.one(graph, *e)).collect());
    let entries: Vec<Vec<Expr>> = (0..given.speeds.len()).map(|i| complement.row(i).to_vec()).collect();
    let order: Vec<usize> = (0..given.speeds.len()).collect();
    let free = independent(graph, &entries, &order);
    for i in order.iter().filter(|i| !free.contains(i)) {
        errors.report(given.span, messages::velocities_dependent(graph.name(given.speeds[*i])));
    }
    if !errors.is_empty() {
        return None;
    }
    let rates: Vec<Expr> = carriers.motion.iter().map(|(_, rate)| *rate).collect();
    let rates = graph.substitute(&rates, &given.map);
    let motion: Vec<(Symbol, Expr)> = carriers.motion.iter().map(|(s, _)| *s).zip(rates).collect();
    let bias = graph.along(&w, &motion).into_iter().map(|e| simplifier.one(graph, e)).collect();
    let names: Vec<&str> = given.speeds.iter().map(|s| graph.name(*s)).collect();
    let note = format!("independent speeds {}, by the velocities that the model gives (5.8)", names.join(", "));
    Some(Tangent {
        complement,
        map: given.map,
        bias,
        rows: Vec::new(),
        gradients: Matrix::zeros(graph, 0, carriers.speeds.len()),
        elimination: None,
        readings: None,
        pivots: Vec::new(),
        note: Some(note),
        speeds: given.speeds,
    })
}
