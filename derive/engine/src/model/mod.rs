//! From declarations to the initial system: names resolved, kinds checked, expressions in one graph.
//!
//! | file | idea |
//! |---|---|
//! | `names` | one namespace, and what an expression mentions |
//! | `functions` | the functions of the language |
//! | `context` | what may occur where |
//! | `lower` | expressions as written become expressions of the graph |
//! | `named` | rates and reactions, which take a name and not its value |
//! | `defines` | intermediate names in the order of their dependence |
//! | `kinematics` | ẋ = A v + a0 (2.1), v = B ẋ + b0 (2.2): one given, the other derived |
//! | `linear` | splitting what is linear, decided |
//! | `inverse` | inverses with few divisors |
//! | `dynamics` | M, h* (2.3), T, V |
//! | `rows` | constraints, sorted by what they bind |
//! | `configuration` | x = g(q, t) (4.2) |
//! | `velocities` | v = g(u, x, t) (5.8) |
//! | `outputs` | what a model tells of a state besides its motion |
//! | `choice` | independent speeds, or D by rows (3.1) |
//! | `numbers` | values for judging |
//! | `system` | the result |

mod choice;
mod configuration;
mod context;
mod defines;
mod dynamics;
mod functions;
mod inverse;
mod kinematics;
mod linear;
mod lower;
mod named;
mod names;
mod numbers;
mod outputs;
mod rows;
mod system;
#[cfg(test)]
mod tests;
mod velocities;

pub use system::{
    Chosen, ComplementRow, Configuration, Independent, IndependentSpeed, InitialSystem, Kinematics, Output, Outputs,
    Places, Reaction, Row, RowKind, Velocities,
};

use crate::symbolic::{Expr, Symbol};
use crate::syntax::{Declarations, Diagnostics, messages};
use context::Context;
use lower::Vocabulary;
use names::Names;

/// Builds the initial system of a model.
///
/// # Errors
///
/// Everything in the model that makes no sense. What was reported when it was read is not reported again: with holes in
/// the declarations the list may be empty. Declarations that are not [`complete`](Declarations::complete) give errors
/// that are not the user's.
pub fn build(declarations: &Declarations) -> Result<InitialSystem, Diagnostics> {
    let mut diagnostics = Diagnostics::new();
    let system = attempt(declarations, &mut diagnostics);
    match system {
        Some(system) => diagnostics.result(system),
        None => Err(diagnostics),
    }
}

/// `None` only if something was reported.
fn attempt(declarations: &Declarations, diagnostics: &mut Diagnostics) -> Option<InitialSystem> {
    let names = Names::of(declarations, diagnostics);
    for (missing, statement) in [
        (declarations.coordinates.is_empty(), "coordinates"),
        (declarations.inertia.is_none() && declarations.kinetic_energy.is_none(), "inertia"),
        (declarations.forces.is_none() && declarations.kinetic_energy.is_none(), "forces"),
    ] {
        if missing {
            diagnostics.report(&declarations.ident, messages::statement_missing(statement));
        }
    }
    if declarations.coordinates.is_empty() {
        return None;
    }
    let vocabulary = &mut Vocabulary::new(declarations, names);
    defines::lower(vocabulary, diagnostics);

    // All that is written, before anything depends on the kinematics, so that no error hides another.
    let kinematics = kinematics::build(vocabulary, diagnostics);
    let inertia = declarations.inertia.as_ref().and_then(|given| dynamics::inertia(given, vocabulary, diagnostics));
    let forces = declarations.forces.as_ref().and_then(|given| dynamics::forces(given, vocabulary, diagnostics));
    let kinetic = declarations
        .kinetic_energy
        .as_ref()
        .and_then(|given| vocabulary.lower(given, Context::KINETIC, diagnostics).map(|lowered| lowered.expr));
    let potential = declarations
        .potential_energy
        .as_ref()
        .and_then(|given| vocabulary.lower(given, Context::POTENTIAL, diagnostics).map(|lowered| lowered.expr));
    let written = rows::lower(vocabulary, diagnostics);
    let configuration = configuration::build(vocabulary, diagnostics);
    outputs::lower(vocabulary, diagnostics);
    let failed = declarations.configuration.is_some() && configuration.is_none();
    let complement = if failed { None } else { choice::complement(configuration.as_ref(), vocabulary, diagnostics) };
    let start = numbers::start(vocabulary, diagnostics);
    let nominal = numbers::nominal(vocabulary, diagnostics);

    // Rates become A v + a0.
    let kinematics = kinematics?;
    let rates = rates(&kinematics, vocabulary);
    let rows = rows::finish(&written, &rates, vocabulary, diagnostics);
    let outputs = outputs::finish(&rates, vocabulary);
    let forces = match (&declarations.forces, &declarations.kinetic_energy) {
        (None, Some(_)) => Some(vec![vocabulary.graph.zero(); vocabulary.speeds.len()]),
        _ => forces.map(|forces| vocabulary.graph.substitute(&forces, &rates)),
    };
    let kinetic = kinetic.map(|kinetic| vocabulary.graph.substitute(&[kinetic], &rates)[0]);
    let inertia = match &declarations.kinetic_energy {
        Some(written) => {
            let found =
                kinetic.and_then(|kinetic| dynamics::second_derivative(kinetic, written, vocabulary, diagnostics));
            if let (Some(found), Some(given)) = (&found, &inertia) {
                dynamics::compare(given, found, vocabulary, diagnostics);
            }
            found
        }
        None => inertia,
    };
    let independent = match failed {
        true => Vec::new(),
        false => choice::independent(&kinematics, configuration.as_ref(), vocabulary, diagnostics),
    };

    let velocities =
        if failed { None } else { velocities::build(&rates, configuration.as_ref(), vocabulary, diagnostics) };

    let used = vocabulary.fields.iter().zip(&vocabulary.used).filter(|(_, used)| **used);
    let parameters = used.map(|(field, _)| *field).collect();
    let model = declarations.ident.span();
    Some(InitialSystem {
        time: vocabulary.time,
        parameters,
        inputs: vocabulary.inputs.clone(),
        coordinates: vocabulary.coordinates.clone(),
        speeds: vocabulary.speeds.clone(),
        kinematics,
        inertia: inertia?,
        forces: forces?,
        kinetic,
        potential,
        rows,
        configuration,
        velocities,
        independent,
        chosen: None,
        complement,
        outputs,
        places: Places {
            model,
            kinematics: declarations.kinematics.as_ref().map_or(model, |statement| statement.span),
            inertia: match (&declarations.kinetic_energy, &declarations.inertia) {
                (Some(energy), _) => energy.place().start,
                (None, statement) => statement.as_ref().map_or(model, |statement| statement.span),
            },
            complement: declarations.complement.as_ref().map_or(model, |statement| statement.span),
            start: declarations.start.first().map_or(model, |first| first.name.span()),
        },
        start,
        nominal,
        graph: std::mem::take(&mut vocabulary.graph),
    })
}

/// What replaces each `dot(x)`: nothing where the rates are the speeds themselves.
fn rates(kinematics: &Kinematics, vocabulary: &mut Vocabulary<'_>) -> Vec<(Symbol, Expr)> {
    if vocabulary.rates == vocabulary.speeds {
        return Vec::new();
    }
    let graph = &mut vocabulary.graph;
    let speeds = graph.vars(&vocabulary.speeds);
    let moved = kinematics.a.mul_vec(graph, &speeds);
    let values: Vec<Expr> = moved.into_iter().zip(&kinematics.a0).map(|(rate, bias)| graph.add(rate, *bias)).collect();
    vocabulary.rates.iter().copied().zip(values).collect()
}
