//! All programs of a model.

use super::angles::Rests;
use super::entry::{Arguments, Entry, chart_entries, entries};
use super::layout::Layout;
use super::lower::{Lowering, Manner};
use super::names::{Namer, Names, quantity};
use super::operation::{Code, Count, Leaf};
use super::schedule::{Numbers, Registry, schedule};
use super::share::share;
use crate::projection::{Equations, Guard, GuardKind};
use crate::symbolic::{Expr, Graph, Symbol};
use std::collections::BTreeMap;

/// Above this many nodes only the factored form is tried.
const BOTH_FORMS: usize = 40_000;
/// Functions of at most this many operations are marked for inlining; larger ones would be compiled many times over.
const INLINED: usize = 120;

/// One function of the model as a program.
#[derive(Clone, Debug)]
pub struct Program {
    /// What it reads and returns.
    pub entry: Entry,
    /// What it does.
    pub code: Code,
    /// How it is written down.
    pub layout: Layout,
    /// What it costs.
    pub count: Count,
    /// Whether it is small enough to be inlined.
    pub inline: bool,
}

/// The work of `prepare`: quantities of parameters alone, shared by all functions.
#[derive(Clone, Debug)]
pub struct Values {
    /// The prepared values as expressions of [`Programs::graph`]: the parameters, then the other quantities.
    pub quantities: Vec<Expr>,
    /// How many of them are parameters.
    pub parameters: usize,
    /// What must hold of the parameters: the guards of the equations, then what cancelled on the way to the programs.
    pub guards: Vec<Guard>,
    /// Gives the quantities behind the parameters, then the figures of the guards.
    pub code: Code,
    /// How it is written down.
    pub layout: Layout,
    /// What it costs.
    pub count: Count,
}

/// All programs of a model.
#[derive(Clone, Debug)]
pub struct Programs {
    /// The arena of the quantities.
    pub graph: Graph,
    /// The work of `prepare`.
    pub values: Values,
    /// The functions, in the order of the trait.
    pub functions: Vec<Program>,
    /// The functions of the charts, private to the implementation.
    pub charts: Vec<Program>,
    /// Names of everything that is read.
    pub names: Names,
}

impl Programs {
    /// The function of that name.
    pub fn function(&self, name: &str) -> Option<&Program> {
        self.functions.iter().chain(&self.charts).find(|p| p.entry.name == name)
    }
}

/// A function that depends on a symbol which it cannot read: the equations are inconsistent.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Unbound {
    /// The function.
    pub function: String,
    /// The symbol's name.
    pub symbol: String,
}

impl std::fmt::Display for Unbound {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(out, "`{}` depends on `{}`, which it cannot read", self.function, self.symbol)
    }
}

/// The programs of all functions of the model.
pub fn programs(equations: &Equations) -> Result<Programs, Unbound> {
    let mut graph = equations.graph.clone();
    let mut names = Names::new(equations);
    let mut registry = Registry::new(&graph.vars(&equations.parameters));
    let mut rests = Rests::default();
    let mut coded: Vec<(Entry, Code)> = Vec::new();
    let own = entries(equations);
    let count = own.len();
    for entry in own.into_iter().chain(chart_entries(equations)) {
        let code = function(&mut graph, &mut rests, equations, &entry, &mut registry)?;
        coded.push((entry, code));
    }
    let values = prepare(&mut graph, equations, registry, &mut names)?;
    let mut functions: Vec<Program> = coded
        .into_iter()
        .map(|(entry, code)| {
            let layout = Layout::new(&code, &names, &entry.labels());
            let count = code.count();
            Program { entry, code, layout, count, inline: count.operations() <= INLINED }
        })
        .collect();
    let charts = functions.split_off(count);
    Ok(Programs { graph, values, functions, charts, names })
}

/// What the cheapest program for the expressions weighs, whatever function they stand in.
pub fn weight(graph: &mut Graph, roots: &[Expr]) -> usize {
    graph.without_new_assumptions(|graph| {
        let place = |symbol: Symbol| Some(Leaf::StateSpeed(symbol.index()));
        let found = cheapest(graph, &mut Rests::default(), roots, &place, &Registry::new(&[]));
        found.map_or(usize::MAX, |(code, _)| code.count().weight())
    })
}

/// What the cheapest program for the expressions does.
pub fn count(graph: &mut Graph, roots: &[Expr]) -> Count {
    graph.without_new_assumptions(|graph| {
        let place = |symbol: Symbol| Some(Leaf::StateSpeed(symbol.index()));
        let found = cheapest(graph, &mut Rests::default(), roots, &place, &Registry::new(&[]));
        found.map_or_else(|_| Count::default(), |(code, _)| code.count())
    })
}

/// How long the cheapest program for the expressions takes, in estimate.
pub fn cycles(graph: &mut Graph, roots: &[Expr]) -> usize {
    graph.without_new_assumptions(|graph| {
        let place = |symbol: Symbol| Some(Leaf::StateSpeed(symbol.index()));
        let found = cheapest(graph, &mut Rests::default(), roots, &place, &Registry::new(&[]));
        found.map_or(usize::MAX, |(code, _)| code.cycles())
    })
}

/// The program for one function.
fn function(
    graph: &mut Graph,
    rests: &mut Rests,
    equations: &Equations,
    entry: &Entry,
    registry: &mut Registry,
) -> Result<Code, Unbound> {
    let places = places(equations, entry.arguments);
    let place = |symbol: Symbol| places.get(&symbol).copied();
    let found = cheapest(graph, rests, &entry.roots(), &place, registry);
    let (code, used) = found.map_err(|symbol| unbound(&entry.name, equations, symbol))?;
    *registry = used;
    Ok(code)
}

/// The cheaper of two programs: sums as they stand, and with common factors taken out. Or the symbol that has no place.
fn cheapest(
    graph: &mut Graph,
    rests: &mut Rests,
    roots: &[Expr],
    place: &dyn Fn(Symbol) -> Option<Leaf>,
    registry: &Registry,
) -> Result<(Code, Registry), Symbol> {
    let forms: &[bool] = if graph.reachable(roots).len() > BOTH_FORMS { &[true] } else { &[true, false] };
    let mut best: Option<(Code, Registry)> = None;
    for factor in forms {
        let mut lowering = Lowering::new(graph, rests, Manner { numeric: false, factor: *factor });
        let lowered = lowering.lower(roots, place);
        let units = std::mem::take(&mut lowering.units);
        let (code, used) = program(graph, units, &lowered?, registry.clone());
        if best.as_ref().is_none_or(|(other, _)| code.count().weight() < other.count().weight()) {
            best = Some((code, used));
        }
    }
    Ok(best.expect("one form at least"))
}

fn program(graph: &Graph, mut units: super::unit::Units, roots: &[u32], mut registry: Registry) -> (Code, Registry) {
    share(&mut units);
    let code = schedule(&units, roots, graph, &mut registry);
    (code, registry)
}

fn prepare(graph: &mut Graph, equations: &Equations, registry: Registry, names: &mut Names) -> Result<Values, Unbound> {
    let quantities = registry.quantities;
    let parameters = equations.parameters.len();
    let places = places(equations, Arguments::Parameters);
    let guards = parameter_guards(graph, equations);
    let mut roots = quantities[parameters..].to_vec();
    roots.extend(guards.iter().map(|g| g.expr));
    let mut rests = Rests::default();
    let mut lowering = Lowering::new(graph, &mut rests, Manner { numeric: true, factor: true });
    let lowered = lowering.lower(&roots, &|symbol| places.get(&symbol).copied());
    let mut units = std::mem::take(&mut lowering.units);
    let lowered = lowered.map_err(|symbol| unbound("values", equations, symbol))?;
    share(&mut units);
    let code = schedule(&units, &lowered, graph, &mut Numbers);
    let mut namer = Namer::avoiding(names.values.iter().map(String::as_str));
    for e in &quantities[parameters..] {
        let name = match quantity(graph, *e) {
            Some(text) => namer.unique(&text),
            None => namer.numbered('k'),
        };
        names.values.push(name);
    }
    let figures: Vec<String> = (1..=guards.len()).map(|i| format!("guard_{i}")).collect();
    let fields = names.values[parameters..].iter().map(|n| (n.as_str(), false));
    let labels: Vec<(&str, bool)> = fields.chain(figures.iter().map(|n| (n.as_str(), true))).collect();
    let layout = Layout::new(&code, names, &labels);
    let count = code.count();
    Ok(Values { quantities, parameters, guards, code, layout, count })
}

/// A parameter-only base that cancelled against its reciprocal must not be zero, as if it had not.
fn parameter_guards(graph: &Graph, equations: &Equations) -> Vec<Guard> {
    let mut guards = equations.parameter_guards.clone();
    let before: Vec<Expr> = equations.graph.cancelled().chain(guards.iter().map(|g| g.expr)).collect();
    let new: Vec<Expr> = graph.cancelled().filter(|e| !before.contains(e)).collect();
    guards.extend(new.iter().zip(graph.display_all(&new)).map(|(expr, name)| Guard {
        expr: *expr,
        name,
        kind: GuardKind::Pivot,
        origin: "the equations divide by it".to_owned(),
        rows: Vec::new(),
        start: None,
    }));
    guards
}

fn unbound(function: &str, equations: &Equations, symbol: Symbol) -> Unbound {
    Unbound { function: function.to_owned(), symbol: equations.graph.name(symbol).to_owned() }
}

/// What a function with these arguments can read.
fn places(equations: &Equations, arguments: Arguments) -> BTreeMap<Symbol, Leaf> {
    let e = equations;
    let mut places = BTreeMap::new();
    let mut add = |symbols: &[Symbol], leaf: fn(usize) -> Leaf| {
        for (index, symbol) in symbols.iter().enumerate() {
            places.insert(*symbol, leaf(index));
        }
    };
    let pi = e.graph.pi_symbol();
    let inputs = matches!(
        arguments,
        Arguments::StateInputs
            | Arguments::CoordinatesVelocitiesInputs
            | Arguments::CoordinatesVelocitiesRatesInputs
            | Arguments::ChartInputs(_)
            | Arguments::StateCarriersRates
    );
    match arguments {
        Arguments::Parameters => {
            add(&e.parameters, Leaf::Parameter);
            add(&[pi], |_| Leaf::Pi);
            return places;
        }
        Arguments::State | Arguments::StateInputs => {
            add(&e.state_coordinates, Leaf::StateCoordinate);
            add(&e.state_speeds, Leaf::StateSpeed);
        }
        Arguments::Chart(chart) | Arguments::ChartInputs(chart) => {
            add(&e.state_coordinates, Leaf::StateCoordinate);
            add(&e.charts[chart - 1].speeds, Leaf::StateSpeed);
        }
        Arguments::StateVelocities => {
            // Where v is a nonlinear function of them, the state's own speeds are the guess. A speed that is one of v is v's.
            add(&e.state_speeds, Leaf::StateSpeed);
            add(&e.state_coordinates, Leaf::StateCoordinate);
            add(&e.speeds, Leaf::Speed);
        }
        Arguments::StateCarriers => {
            add(&e.state_coordinates, Leaf::StateCoordinate);
            add(&e.carriers, Leaf::Carrier);
        }
        Arguments::StateCarriersRates => {
            // Where v = g(u, x, t) is given, u may stand in an output; a speed that is a carrier is the carriers'.
            add(&e.state_speeds, Leaf::StateSpeed);
            add(&e.state_coordinates, Leaf::StateCoordinate);
            add(&e.carriers, Leaf::Carrier);
            add(&e.outputs.carrier_rates, Leaf::CarrierRate);
        }
        Arguments::Coordinates => add(&e.coordinates, Leaf::Coordinate),
        Arguments::CoordinatesVelocities | Arguments::CoordinatesVelocitiesInputs => {
            add(&e.coordinates, Leaf::Coordinate);
            add(&e.speeds, Leaf::Speed);
        }
        Arguments::CoordinatesVelocitiesRatesInputs => {
            add(&e.coordinates, Leaf::Coordinate);
            add(&e.speeds, Leaf::Speed);
            add(&e.velocity_rate_symbols, Leaf::SpeedRate);
        }
    }
    if inputs {
        add(&e.inputs, Leaf::Input);
    }
    add(&[e.time], |_| Leaf::Time);
    if arguments == Arguments::StateCarriersRates {
        places.extend(e.outputs.reactions.iter().map(|(symbol, at)| (*symbol, Leaf::Multiplier(*at))));
    }
    places
}
