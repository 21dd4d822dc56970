//! From declarations to the initial system: names resolved, kinds checked, expressions in one graph.
//!
//! | file | idea |
//! |---|---|
//! | `names` | one namespace, and what an expression mentions |
//! | `functions` | the functions of the language |
//! | `context` | what may occur where |
//! | `vocabulary` | the symbols of a model, and what is lowered so far |
//! | `value` | scalars and vectors |
//! | `lower` | expressions as written become expressions of the graph |
//! | `named` | rates and reactions, which take a name and not its value |
//! | `geometry` | frames, points and bodies |
//! | `mechanism` | what bodies come to: a tree of twists |
//! | `kinematics` | ẋ = A v + a0 (2.1), v = B ẋ + b0 (2.2): one given, the other derived |
//! | `joint_kinematics` | that of joints, quaternions among them |
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
mod dynamics;
mod functions;
mod geometry;
mod inverse;
mod joint_kinematics;
mod kinematics;
mod linear;
mod lower;
pub mod mechanism;
mod named;
mod names;
mod numbers;
mod outputs;
mod rows;
mod system;
#[cfg(test)]
mod tests;
mod value;
mod velocities;
mod vocabulary;

pub use mechanism::Mechanism;
pub use system::{
    Chosen, ComplementRow, Configuration, Independent, IndependentSpeed, InitialSystem, Kinematics, Output, Outputs,
    Places, Reaction, Row, RowKind, Swept, Velocities,
};

use crate::symbolic::{Expr, Matrix, Symbol};
use crate::syntax::{Declarations, Diagnostics, Elimination, Expression, Place, messages};
use context::Context;
use names::Names;
use vocabulary::Vocabulary;

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
    let bodies = declarations.geometry.bodies().next();
    let by_energy = declarations.kinetic_energy.is_some() || bodies.is_some();
    for (missing, statement) in [
        (declarations.coordinates.is_empty(), "coordinates"),
        (declarations.inertia.is_none() && !by_energy, "inertia"),
        (declarations.forces.is_none() && !by_energy, "forces"),
    ] {
        if missing {
            diagnostics.report(&declarations.ident, messages::statement_missing(statement));
        }
    }
    if declarations.coordinates.is_empty() {
        return None;
    }
    let vocabulary = &mut Vocabulary::new(declarations, names);
    beside_quaternions(vocabulary, diagnostics);
    geometry::order::lower(vocabulary, diagnostics);
    if bodies.is_some() {
        let inertia = declarations.inertia.as_ref().map(|given| (given.span.into(), messages::inertia_and_bodies()));
        let energy = declarations.kinetic_energy.as_ref().map(|given| (given.place(), messages::kinetic_and_bodies()));
        for (place, message) in [inertia, energy].into_iter().flatten() {
            let place: Place = place;
            diagnostics.report(place, message);
        }
    } else {
        let geometry = &declarations.geometry;
        let element = geometry.elements.first().map(|element| (Place::from(&element.name), element.kind.statement()));
        let gravity = geometry.gravity.as_ref().map(|given| (given.place(), "gravity"));
        let force = geometry.generalized.first().map(|given| (Place::from(&given.name), "generalized_force"));
        for (place, statement) in [element, gravity, force].into_iter().flatten() {
            diagnostics.report(place, messages::acts_on_nothing(statement));
        }
    }

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
    let mechanism = geometry::mechanism(vocabulary, diagnostics);
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
    let mechanism = mechanism.map(|mechanism| moving(mechanism, &kinematics, &rates, vocabulary));
    let forces = match &declarations.forces {
        None if by_energy => Some(vec![vocabulary.graph.zero(); vocabulary.speeds.len()]),
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
        None if bodies.is_some() => {
            let n = vocabulary.speeds.len();
            // What could not be read is reported.
            mechanism.as_ref().map(|_| Matrix::zeros(&vocabulary.graph, n, n))
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
        joint_speeds: declarations.speeds.is_none(),
        inertia: inertia?,
        forces: forces?,
        kinetic,
        potential,
        mechanism,
        elimination: Elimination::Matrix,
        swept: None,
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
                (None, Some(statement)) => statement.span,
                (None, None) => bodies.map_or(model, |body| body.name.span()),
            },
            complement: declarations.complement.as_ref().map_or(model, |statement| statement.span),
            start: declarations.start.first().map_or(model, |first| first.name.span()),
        },
        start,
        nominal,
        graph: std::mem::take(&mut vocabulary.graph),
    })
}

/// The mechanism over v: rates are replaced, and forces on rates become forces on speeds by Aᵀ.
fn moving(
    mut mechanism: Mechanism,
    kinematics: &Kinematics,
    rates: &[(Symbol, Expr)],
    vocabulary: &mut Vocabulary<'_>,
) -> Mechanism {
    let on_rates = std::mem::take(&mut vocabulary.forces_on_rates);
    let graph = &mut vocabulary.graph;
    for (i, force) in on_rates {
        for (j, total) in mechanism.generalized.iter_mut().enumerate() {
            let part = graph.mul(kinematics.a.get(i, j), force);
            *total = graph.add(*total, part);
        }
    }
    let mut moving = mechanism.expressions();
    let written: Vec<Expr> = moving.iter().map(|e| **e).collect();
    let replaced = graph.substitute(&written, rates);
    moving.iter_mut().zip(replaced).for_each(|(e, new)| **e = new);
    mechanism
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
    // Norms do not change.
    let held: Vec<(Symbol, Expr)> =
        vocabulary.turnings.iter().map(|turning| (turning.norm_rate, graph.zero())).collect();
    let values = if held.is_empty() { values } else { graph.substitute(&values, &held) };
    let mut rates: Vec<(Symbol, Expr)> = vocabulary.rates.iter().copied().zip(values).collect();
    rates.extend(vocabulary.turned.iter().copied());
    rates
}

/// Statements that do not know the speeds of quaternions' frames.
fn beside_quaternions(vocabulary: &Vocabulary<'_>, diagnostics: &mut Diagnostics) {
    if vocabulary.quaternions.is_empty() {
        return;
    }
    let declarations = vocabulary.declarations;
    let given: [(Option<Place>, &str); 6] = [
        (declarations.configuration.as_ref().map(|given| given.span.into()), "configuration"),
        (declarations.velocities.as_ref().map(|given| given.span.into()), "velocities"),
        (declarations.complement.as_ref().map(|given| given.span.into()), "complement"),
        (declarations.inertia.as_ref().map(|given| given.span.into()), "inertia"),
        (declarations.kinetic_energy.as_ref().map(Expression::place), "kinetic_energy"),
        (declarations.forces.as_ref().map(|given| given.span.into()), "forces"),
    ];
    for (place, statement) in given {
        if let Some(place) = place {
            diagnostics.report(place, messages::quaternions_beside(statement));
        }
    }
}
