//! Outputs as functions of the state, and of what the general form knows of a motion.
//!
//! As functions of the state they are what their declaration says with x, v, v̇ and λ put in, so that each costs no more than
//! what it mentions. At a point where the state's speeds break down, the carriers w, their rates ẇ and λ are known all the
//! same, by the general form (3.5); for that the outputs stand in these terms as well.

use proc_macro2::Span;

use super::carriers::Carriers;
use super::equations::{Equations, Level};
use super::messages;
use crate::model::{self, InitialSystem};
use crate::symbolic::{Expr, Graph, Kind, Node, Stage, Symbol};
use crate::syntax::Diagnostics;

/// The outputs of a model.
#[derive(Clone, Debug, Default)]
pub struct Outputs {
    /// Their names.
    pub names: Vec<String>,
    /// The places of the names.
    pub spans: Vec<Span>,
    /// Each as a function of the state and the inputs.
    pub values: Vec<Expr>,
    /// Each over the state's coordinates, the carriers, `carrier_rates`, multipliers and inputs, and where the model gives
    /// v = g(u, x, t) over u.
    pub carried: Vec<Expr>,
    /// ẇ, as symbols.
    pub carrier_rates: Vec<Symbol>,
    /// The symbols of multipliers, each with its place among them.
    pub reactions: Vec<(Symbol, usize)>,
    /// As declared.
    written: Vec<Expr>,
    /// What the declared symbols stand for.
    meanings: Vec<(Symbol, Meaning)>,
}

/// What is known of an output.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct OutputFacts {
    /// The level of what it mentions: coordinates and time, velocities, or accelerations and reactions.
    pub level: Level,
    /// Whether it depends on inputs.
    pub inputs: bool,
    /// What it divides by at a state and no run watches.
    pub divisors: Vec<String>,
}

/// Where a symbol of a declared output has its value.
#[derive(Copy, Clone, Debug)]
enum Meaning {
    Coordinate(usize),
    Velocity(usize),
    VelocityRate(usize),
    /// The rate of a coordinate of the state.
    CoordinateRate(usize),
    Multiplier(usize),
    /// The rate of a coordinate's rate, or of a quasi-velocity.
    Rate(Expr),
    /// A quasi-velocity.
    Value(Expr),
}

/// Sorts the symbols that outputs mention. `carrier_values` are the carriers as functions of the state.
pub fn outputs(
    system: &mut InitialSystem,
    carriers: &Carriers,
    carrier_values: &[Expr],
    coordinate_rates: &[Expr],
    multiplier_names: &[String],
    carried_by: &dyn Fn(&str) -> Vec<String>,
    errors: &mut Diagnostics,
) -> Outputs {
    let model::Outputs { entries, accelerations, further_rates, further_accelerations, quasi_rates, reactions } =
        system.outputs.clone();
    if entries.is_empty() {
        return Outputs::default();
    }
    let mut outputs = Outputs {
        names: entries.iter().map(|output| output.name.clone()).collect(),
        spans: entries.iter().map(|output| output.span).collect(),
        written: entries.iter().map(|output| output.expr).collect(),
        ..Outputs::default()
    };
    let numbered = |symbols: &[Symbol], meaning: fn(usize) -> Meaning| -> Vec<(Symbol, Meaning)> {
        symbols.iter().enumerate().map(|(i, symbol)| (*symbol, meaning(i))).collect()
    };
    outputs.meanings.extend(numbered(&system.coordinates, Meaning::Coordinate));
    outputs.meanings.extend(numbered(&system.speeds, Meaning::Velocity));
    outputs.meanings.extend(numbered(&accelerations, Meaning::VelocityRate));
    // The further coordinates are the last ones of the state.
    let first = carriers.coordinates.len() - further_rates.len();
    for (i, symbol) in further_rates.iter().enumerate() {
        outputs.meanings.push((*symbol, Meaning::CoordinateRate(first + i)));
    }
    for (i, symbol) in further_accelerations.iter().enumerate() {
        outputs.meanings.push((*symbol, Meaning::Rate(coordinate_rates[first + i])));
    }
    for (i, symbol) in quasi_rates.iter().enumerate() {
        outputs.meanings.push((carriers.speeds[i], Meaning::Value(carrier_values[i])));
        outputs.meanings.push((*symbol, Meaning::Rate(carrier_values[i])));
    }
    for reaction in reactions {
        match multiplier_names.iter().position(|name| *name == reaction.name) {
            Some(at) => {
                outputs.meanings.push((reaction.symbol, Meaning::Multiplier(at)));
                outputs.reactions.push((reaction.symbol, at));
            }
            None => {
                errors.report(reaction.span, messages::reaction_shared(&reaction.name, &carried_by(&reaction.name)))
            }
        }
    }
    outputs.carried(system, carriers, &accelerations, (&further_rates, &further_accelerations), &quasi_rates);
    outputs
}

impl Outputs {
    /// In terms of the carriers.
    fn carried(
        &mut self,
        system: &mut InitialSystem,
        carriers: &Carriers,
        accelerations: &[Symbol],
        (further_rates, further_accelerations): (&[Symbol], &[Symbol]),
        quasi_rates: &[Symbol],
    ) {
        let graph = &mut system.graph;
        let Some(partial) = &carriers.partial_velocities else {
            self.carrier_rates = accelerations.to_vec();
            self.carried = self.written.clone();
            return;
        };
        self.carrier_rates = match quasi_rates {
            [] => {
                let names: Vec<String> = carriers.speeds.iter().map(|w| format!("dot({})", graph.name(*w))).collect();
                names.iter().map(|name| graph.symbol(name, Kind::Speed)).collect()
            }
            rates => rates.to_vec(),
        };
        let rates = graph.vars(&self.carrier_rates);
        // v̇ = D1ᵀ ẇ + a_1
        let moved = partial.mul_vec(graph, &rates);
        let velocity_rates: Vec<Expr> = moved.into_iter().zip(&carriers.bias).map(|(a, b)| graph.add(a, *b)).collect();
        let first = carriers.coordinates.len() - further_rates.len();
        let coordinate_rates: Vec<Expr> =
            carriers.motion[first..carriers.coordinates.len()].iter().map(|(_, rate)| *rate).collect();
        let mut motion = carriers.motion.clone();
        motion.extend(carriers.speeds.iter().copied().zip(rates));
        let second = graph.along(&coordinate_rates, &motion);
        let mut map = carriers.map.clone();
        map.extend(accelerations.iter().copied().zip(velocity_rates));
        map.extend(further_rates.iter().copied().zip(coordinate_rates));
        map.extend(further_accelerations.iter().copied().zip(second));
        self.carried = graph.substitute(&self.written, &map);
    }
}

/// Puts x, v, v̇ and λ as they stand in the equations into the outputs.
pub fn bind(equations: &mut Equations) {
    let e = equations;
    if e.outputs.names.is_empty() {
        return;
    }
    let mut motion: Vec<(Symbol, Expr)> =
        e.state_coordinates.iter().copied().zip(e.coordinate_rates.iter().copied()).collect();
    motion.extend(e.state_speeds.iter().copied().zip(e.accelerations.iter().copied()));
    motion.push((e.time, e.graph.one()));
    let mut map = Vec::with_capacity(e.outputs.meanings.len());
    let mentioned = e.graph.symbols_of(&e.outputs.written);
    for (symbol, meaning) in e.outputs.meanings.iter().filter(|(symbol, _)| mentioned.contains(symbol)) {
        let value = match *meaning {
            Meaning::Coordinate(i) => e.initial_coordinates[i],
            Meaning::Velocity(i) => e.velocities[i],
            Meaning::VelocityRate(i) => e.velocity_rates[i],
            Meaning::CoordinateRate(i) => e.coordinate_rates[i],
            Meaning::Multiplier(i) => e.multipliers[i],
            Meaning::Value(value) => value,
            Meaning::Rate(of) => e.graph.along(&[of], &motion)[0],
        };
        map.push((*symbol, value));
    }
    e.outputs.values = e.graph.substitute(&e.outputs.written, &map);
}

/// The names and places of outputs that divide by zero wherever the constraints hold.
pub fn dividing_by_zero(equations: &Equations) -> Vec<(&str, Span)> {
    let (graph, outputs) = (&equations.graph, &equations.outputs);
    let named = outputs.names.iter().map(String::as_str).zip(outputs.spans.iter().copied());
    let divides = |e: &Expr| divisors(graph, *e).into_iter().any(|divisor| graph.vanishes(divisor));
    named.zip(&outputs.values).filter(|(_, value)| divides(value)).map(|(output, _)| output).collect()
}

impl Equations {
    /// What is known of each output.
    pub fn output_facts(&self) -> Vec<OutputFacts> {
        let (graph, outputs) = (&self.graph, &self.outputs);
        let of_motion: Vec<Symbol> = outputs
            .meanings
            .iter()
            .filter(|(_, meaning)| {
                matches!(meaning, Meaning::VelocityRate(_) | Meaning::Multiplier(_) | Meaning::Rate(_))
            })
            .map(|(symbol, _)| *symbol)
            .collect();
        let watched = |divisor: &Expr| self.guards.iter().any(|guard| guard.expr == *divisor);
        let facts = |(written, value): (&Expr, &Expr)| OutputFacts {
            level: if graph.contains(*written, &of_motion) {
                Level::Acceleration
            } else if graph.contains(*value, &self.state_speeds) {
                Level::Velocity
            } else {
                Level::Position
            },
            inputs: graph.contains(*value, &self.inputs),
            divisors: divisors(graph, *value)
                .into_iter()
                .filter(|divisor| !watched(divisor) && !graph.bounds(*divisor).exclude_zero())
                .map(|divisor| graph.display(divisor))
                .collect(),
        };
        outputs.written.iter().zip(&outputs.values).map(facts).collect()
    }
}

/// What an expression divides by, and what depends on more than parameters.
fn divisors(graph: &Graph, e: Expr) -> Vec<Expr> {
    let mut found = Vec::new();
    for e in graph.reachable(&[e]) {
        if let Node::Product(factors) = graph.node(e) {
            let below = factors
                .iter()
                .filter(|(base, k)| *k < 0 && (graph.stage(*base) > Stage::Parameter || graph.is_zero(*base)));
            found.extend(below.map(|(base, _)| *base));
        }
    }
    found.sort_unstable();
    found.dedup();
    found
}
