//! Where the equations of a model have a value, their cheaper forms have one too: at special states above all, where sines,
//! cosines, differences and products vanish.

mod random;
mod support;

use holonomy_engine::analyse_by;
use holonomy_engine::program::{Arguments, Programs, programs};
use holonomy_engine::projection::Equations;
use holonomy_engine::simplify::Search;
use holonomy_engine::symbolic::Symbol;
use oracle::read_models;
use quote::ToTokens;
use random::first;
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use std::fs;
use std::path::Path;
use support::declared;
use support::splitmix::SplitMix;

/// Random models beside those of the tests, ...
const MODELS: usize = 60;
/// ... and states of each.
const STATES: usize = 60;

const SPECIAL: [f64; 10] = [0.0, -0.0, FRAC_PI_2, -FRAC_PI_2, PI, -PI, FRAC_PI_4, 1.0, -1.0, 0.5];

/// A guard below this part of what it usually is, or beyond so many times as much, is zero, or comes from rounding where it should
/// be zero, or was divided by one that does: cos(PI/2) is no zero in doubles. Nothing is claimed where something is divided by it:
/// what rounding leaves of a zero is chance, and differs between functions of one form, too.
const NOISE: f64 = 1e-9;

/// Values by name.
type Values = BTreeMap<String, f64>;

struct Form {
    equations: Equations,
    programs: Programs,
}

impl Form {
    fn new(model: &syn::ItemStruct, search: Search) -> Self {
        let equations = analyse_by(model.to_token_stream(), search).expect("the model is good").equations;
        let programs = programs(&equations).expect("every symbol is known");
        Form { equations, programs }
    }

    /// Everything that a function may read, by name.
    fn names(&self) -> Vec<String> {
        let e = &self.equations;
        let of_state = [&e.inputs, &e.state_coordinates, &e.state_speeds, &e.coordinates, &e.speeds, &e.carriers];
        let rates = e.velocity_rate_symbols.iter().chain(&e.outputs.carrier_rates);
        let symbols = of_state.into_iter().flatten().chain(rates).chain([&e.time]);
        let of_charts = e.charts.iter().flat_map(|chart| &chart.speeds);
        let reactions = e.outputs.reactions.iter().map(|(symbol, _)| symbol);
        symbols.chain(of_charts).chain(reactions).map(|s| e.graph.name(*s).to_owned()).collect()
    }

    fn functions(&self) -> impl Iterator<Item = &str> {
        self.programs.functions.iter().chain(&self.programs.charts).map(|program| program.entry.name.as_str())
    }

    /// Whether a function is one of the initial system, which divides by no guard.
    fn initial(&self, function: &str) -> bool {
        use Arguments::{Coordinates, CoordinatesVelocities, CoordinatesVelocitiesInputs};
        let arguments = self.programs.function(function).expect("it is there").entry.arguments;
        matches!(arguments, Coordinates | CoordinatesVelocities | CoordinatesVelocitiesInputs)
    }

    fn results(&self, function: &str, values: &Values) -> Vec<f64> {
        let value = |symbol: Symbol| values[self.equations.graph.name(symbol)];
        self.programs.evaluate(&self.equations, function, &value).expect("both forms have the same functions")
    }

    fn defined(&self, function: &str, values: &Values) -> bool {
        self.results(function, values).iter().all(|result| result.is_finite())
    }

    /// The figures that tell whether a state is a regular one, in every chart. Different functions may round them differently,
    /// one to zero and another not.
    fn guards(&self, values: &Values) -> Vec<f64> {
        let rates = self.functions().filter(|function| function.ends_with("derivative"));
        let states = self.equations.state_coordinates.len() + self.equations.state_speeds.len();
        let of_rates = rates.flat_map(|function| self.results(function, values).split_off(states));
        self.results("guards", values).into_iter().chain(of_rates).collect()
    }
}

/// Values with as many coincidences and zeros as there can be, the parameters apart.
fn state(names: &[String], parameters: &Values, random: &mut SplitMix) -> Values {
    let same = *random.one_of(&SPECIAL);
    let mut value = |name: &String| {
        let drawn = match random.below(4) {
            0 => 0.0,
            1 => *random.one_of(&SPECIAL),
            2 => same,
            _ => random.between(-2.0, 2.0),
        };
        (name.clone(), drawn)
    };
    let mut values: Values = names.iter().map(&mut value).collect();
    values.extend(parameters.iter().map(|(name, value)| (name.clone(), *value)));
    values
}

/// Whether each of the states is a regular one.
fn regular(states: &[Values], form: &Form) -> Vec<bool> {
    let all: Vec<Vec<f64>> = states.iter().map(|values| form.guards(values)).collect();
    let usual: Vec<f64> = (0..all[0].len())
        .map(|i| {
            let sizes = all.iter().map(|guards| guards[i].abs()).filter(|size| size.is_finite() && *size > 0.0);
            let mut sizes: Vec<f64> = sizes.collect();
            sizes.sort_by(f64::total_cmp);
            sizes.get(sizes.len() / 2).copied().unwrap_or(1.0)
        })
        .collect();
    let good = |guards: &Vec<f64>| {
        guards.iter().zip(&usual).all(|(guard, usual)| (NOISE..1.0 / NOISE).contains(&(guard.abs() / usual)))
    };
    all.iter().map(good).collect()
}

/// What the functions of a model have given.
#[derive(Default)]
struct Seen {
    regular: usize,
    defined: usize,
    undefined: usize,
    lost: Vec<String>,
}

fn examine(model: &syn::ItemStruct, parameters: &Values, random: &mut SplitMix, seen: &mut Seen) {
    let [found, plain] = [Search::Full, Search::Off].map(|search| Form::new(model, search));
    let names = plain.names();
    let states: Vec<Values> = (0..STATES).map(|_| state(&names, parameters, random)).collect();
    for (values, regular) in states.iter().zip(regular(&states, &plain)) {
        seen.regular += usize::from(regular);
        for function in plain.functions().filter(|function| regular || plain.initial(function)) {
            if !plain.defined(function, values) {
                seen.undefined += 1;
                continue;
            }
            seen.defined += 1;
            if !found.defined(function, values) {
                let text = model.to_token_stream();
                seen.lost.push(format!("{} {function} at {values:?}\n{text}", model.ident));
            }
        }
    }
}

/// A random model with functions that are known in place of the user's, which have no value here.
fn without_functions(source: &str) -> String {
    let lines = source.lines().filter(|line| !line.starts_with("#[function("));
    lines.collect::<Vec<_>>().join("\n").replace("wave(", "sin(").replace("bump(", "atan(")
}

#[test]
fn what_is_defined_stays_defined() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/models");
    let files = declared::rust_files(&folder).into_iter();
    let sources = files.map(|file| fs::read_to_string(file).expect("a text"));
    let generated = first(MODELS, 61).into_iter().map(|model| without_functions(&model.source));
    let (random, mut seen) = (&mut SplitMix::new(3), Seen::default());
    let mut models = 0;
    for source in sources.chain(generated) {
        for (model, declaration) in declared::models(&source).iter().zip(read_models(&source)) {
            assert_eq!(model.ident, declaration.name);
            let nominal = declaration.nominal();
            let names = declaration.parameters.into_iter().map(|(name, _)| name);
            examine(model, &names.zip(nominal).collect(), random, &mut seen);
            models += 1;
        }
    }
    let Seen { regular, defined, undefined, lost } = seen;
    println!(
        "{models} models at {regular} regular states: functions are defined {defined} times, {undefined} times not"
    );
    assert!(lost.is_empty(), "{} are lost:\n{}", lost.len(), lost.join("\n"));
    // Most states are regular, special as they are, and there are others, else nothing is tested.
    assert!(regular > models * STATES / 2 && undefined > 100, "{regular} {defined} {undefined}");
}
