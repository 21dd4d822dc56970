//! What binds the carriers: all that is known before independent speeds are chosen among them.

use super::carriers::{CarriedRow, Carriers, carried, carriers};
use super::constraints::{DifferentiatedRow, differentiate};
use super::dependence::{Sorted, sort};
use super::{Simplifier, bodies, lagrange, messages, overconstrained};
use crate::model::InitialSystem;
use crate::syntax::Diagnostics;

/// The carriers of the motion and the rows that bind them.
#[derive(Clone, Debug)]
pub struct Binding {
    /// All rows, differentiated.
    pub rows: Vec<DifferentiatedRow>,
    /// What becomes of each.
    pub sorted: Sorted,
    /// w.
    pub carriers: Carriers,
    /// The rows that bind w.
    pub carried: Vec<CarriedRow>,
    /// Whether some of these repeated others and were left out.
    pub overlapping: bool,
    /// Rows that the configuration leaves to them, told to a person.
    pub second_stage: Option<String>,
}

/// Differentiates the rows, sorts them, and carries them over to the carriers.
pub fn binding(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    errors: &mut Diagnostics,
) -> Option<Binding> {
    let tree = match system.mechanism {
        Some(_) => bodies::complete(system, simplifier),
        None => {
            lagrange::complete(system, simplifier);
            None
        }
    };
    let rows = differentiate(system, tree.is_some());
    let n = system.speeds.len();
    let mut sorted = sort(&mut system.graph, simplifier, &rows, n, errors);
    let carriers = carriers(system, simplifier);
    // A tree has no configuration, and its rows bind its speeds.
    let second_stage = match tree.is_some() && sorted.kept.len() == rows.len() {
        true => None,
        false => check_configuration(system, simplifier, &rows, &carriers, errors),
    };
    if !errors.is_empty() {
        return None;
    }
    overconstrained::take_out(system, &rows, &carriers, &mut sorted);
    if let Some(tree) = tree {
        let kept: Vec<&DifferentiatedRow> = sorted.kept.iter().map(|i| &rows[*i]).collect();
        if !bodies::close(system, tree, &kept) {
            errors.report(system.places.model, messages::not_joint_by_joint());
            return None;
        }
    }
    let (carried, overlapping) = carried(system, simplifier, &rows, &sorted.kept, &carriers, errors);
    errors.is_empty().then_some(Binding { rows, sorted, carriers, carried, overlapping, second_stage })
}

/// f(g(q, t)) ≡ 0 for the position rows that the configuration is to satisfy. Those that it leaves to a second stage are
/// named in a note, lest a slip in g go unseen.
fn check_configuration(
    system: &mut InitialSystem,
    simplifier: &mut dyn Simplifier,
    rows: &[DifferentiatedRow],
    carriers: &Carriers,
    errors: &mut Diagnostics,
) -> Option<String> {
    let mut left = Vec::new();
    for row in rows {
        let Some(f) = row.position else { continue };
        let value = system.graph.substitute(&[f], &carriers.map)[0];
        // A function of q is a constraint of the second stage; of t and parameters alone it can only be wrong.
        let slopes = system.graph.jacobian(&[value], &carriers.coordinates);
        if slopes.entries().iter().any(|e| !system.graph.vanishes(*e)) {
            left.push(format!("`{}`", row.name));
        } else if !system.graph.vanishes(value) {
            let value = simplifier.one(&mut system.graph, value);
            let text = system.graph.display(value);
            errors.report(row.span, messages::configuration_misses(&row.name, &text));
        }
    }
    (carriers.partial_velocities.is_some() && !left.is_empty()).then(|| {
        let (they, bind) = if left.len() == 1 { ("it", "binds") } else { ("they", "bind") };
        format!(
            "the configuration does not satisfy {}: {they} {bind} its coordinates in a second stage",
            left.join(", ")
        )
    })
}
