//! `MODEL.equations` as formulas: each text is read, written again as it was, and is what the emitted functions compute.

#[path = "models/linkages.rs"]
mod linkages;
mod models;
mod support;

use holonomy::equations::Formula;
use holonomy::{ConstrainedSystem, Vector};
use linkages::{CarAxis, FourBar, SliderCrank};
use models::*;
use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use std::collections::HashMap;
use std::path::Path;
use support::declared;
use support::golden::assert_close;
use support::kept;
use support::running::{Running, by_rows, entries};
use support::splitmix::SplitMix;

const CLOSE: f64 = 1e-12;
/// Models that take as long to derive as most others together.
const LARGE: [&str; 1] = ["TwentyPendulums"];

/// The value of a formula without vectors.
///
/// # Panics
/// If a name or a function has no meaning.
fn value(formula: &Formula, names: &HashMap<String, f64>) -> f64 {
    let of = |formula: &Formula| value(formula, names);
    match formula {
        Formula::Number(digits) => digits.parse().expect("digits"),
        Formula::Symbol(name) => *names.get(name).unwrap_or_else(|| panic!("`{name}` has no value")),
        Formula::Negative(a) => -of(a),
        Formula::Sum(terms) => terms.iter().map(of).sum(),
        Formula::Product(factors) => factors.iter().map(of).product(),
        Formula::Quotient { numerator, denominator } => of(numerator) / of(denominator),
        Formula::Power { base, exponent } => of(base).powi(*exponent),
        Formula::Select { condition, negative, otherwise } => {
            of(if of(condition) < 0.0 { negative } else { otherwise })
        }
        Formula::Call { function, arguments } => match (function.as_str(), arguments.as_slice()) {
            ("sin", [a]) => of(a).sin(),
            ("cos", [a]) => of(a).cos(),
            ("sqrt", [a]) => of(a).sqrt(),
            ("abs", [a]) => of(a).abs(),
            _ => panic!("no model here calls {function} of {}", arguments.len()),
        },
        other => panic!("not a number: {other}"),
    }
}

/// The entries of a formula, row after row.
fn values(formula: &Formula, names: &HashMap<String, f64>) -> Vec<f64> {
    match formula {
        Formula::Vector(entries) => entries.iter().map(|entry| value(entry, names)).collect(),
        Formula::Matrix(rows) => rows.iter().flatten().map(|entry| value(entry, names)).collect(),
        scalar => vec![value(scalar, names)],
    }
}

/// The emitted functions that equations name, with their values at a state, each from the parameters, the state and the
/// equations before it.
fn evaluated<M: ConstrainedSystem>(model: &M, t: f64, y: &[f64]) -> HashMap<&'static str, Vec<f64>> {
    let m = M::MODEL;
    let parameters = m.parameters.iter().zip(entries(&model.parameters()));
    let state = m.state_coordinates.iter().chain(m.state_speeds).zip(y.iter().copied());
    let mut names: HashMap<String, f64> =
        parameters.chain(state).map(|(name, value)| (name.to_string(), value)).collect();
    names.extend([("t".to_owned(), t), ("PI".to_owned(), std::f64::consts::PI)]);
    let mut functions: HashMap<_, Vec<f64>> = HashMap::new();
    for equation in m.equations {
        let formula = equation.formula().unwrap_or_else(|error| panic!("{}: {}: {error}", m.name, equation.text));
        let computed = values(&formula, &names);
        // An output may have the name of a coordinate, whose equation stands before it.
        if let [value] = computed[..] {
            names.entry(equation.symbol.to_owned()).or_insert(value);
        }
        functions.entry(equation.function).or_default().extend(computed);
    }
    functions
}

/// Compares what equations say with the emitted functions, at random states beside a given one.
fn holds<M: ConstrainedSystem>(model: M, near: &[f64]) {
    let m = M::MODEL;
    let running = Running::new(model.clone());
    let mut random = SplitMix::new(4);
    for _ in 0..3 {
        let t = random.between(0.1, 0.9);
        let y: Vec<f64> = near.iter().map(|y| y + random.between(-0.1, 0.1)).collect();
        let s = running.state(&y);
        let (x, v) = (running.0.coordinates(t, &s), running.0.velocities(t, &s));
        let (p, inputs) = (running.0.values(), M::Inputs::from_fn(|_| 0.0));
        let mut told = evaluated(&model, t, &y);
        told.remove("");
        let mut close = |function: &str, emitted: Vec<f64>| {
            let told = told.remove(function).unwrap_or_default();
            assert_close(&format!("{function} of {} at {t}, {y:?}", m.name), &told, &emitted, CLOSE);
        };
        close("derivative", running.rate(t, &y)[..m.state_coordinates.len()].to_vec());
        close("accelerations", running.accelerations(t, &y));
        close("mass_matrix", by_rows(&running.0.mass_matrix(t, &s)));
        close("forcing", running.forcing(t, &y));
        if m.state_coordinates != m.coordinates {
            close("coordinates", entries(&x));
        }
        close("velocities", entries(&v));
        close("complement", by_rows(&running.0.complement(t, &s)));
        close("complement_bias", entries(&running.0.complement_bias(t, &s)));
        close("velocity_rates", running.velocity_rates(t, &y));
        close("multipliers", running.multipliers(t, &y));
        close("kinematic_matrix", by_rows(&M::kinematic_matrix(p, t, &x)));
        close("kinematic_bias", entries(&M::kinematic_bias(p, t, &x)));
        close("inertia", by_rows(&M::inertia(p, t, &x)));
        close("forces", entries(&M::forces(p, t, &x, &v, &inputs)));
        close("constraint_matrix", by_rows(&M::constraint_matrix(p, t, &x, &v)));
        close("constraint_bias", entries(&M::constraint_bias(p, t, &x, &v)));
        close("kinetic_energy", vec![M::kinetic_energy(p, t, &x, &v)]);
        close("potential_energy", M::potential_energy(p, t, &x).into_iter().collect());
        close("outputs", entries(&running.0.outputs(t, &s, &inputs)));
        // Rows that hold are zero but for rounding.
        let mut rows = |function: &str, emitted: Vec<f64>| {
            let told = told.remove(function).unwrap_or_default();
            let place = format!("{function} of {} at {t}, {y:?}", m.name);
            assert_close(&place, &[told, vec![1.0]].concat(), &[emitted, vec![1.0]].concat(), CLOSE);
        };
        rows("position_residual", entries(&M::position_residual(p, t, &x)));
        rows("velocity_residual", entries(&M::velocity_residual(p, t, &x, &v)));
        assert!(told.is_empty(), "{}: {:?} compared with nothing", m.name, told.keys());
    }
}

#[test]
fn texts_are_what_the_functions_compute() {
    const G: f64 = 9.81;
    holds(Pendulum { m: 1.5, l: 0.8, g: G }, &[0.5, -0.6, 0.7]);
    holds(HangingPendulum { m: 1.5, l: 0.8, g: G }, &[0.5, -0.6, 0.7]);
    holds(PendulumByAngle { m: 1.5, l: 0.8, g: G }, &[0.6, -1.1]);
    holds(BeadOnRod { m: 0.7, w: 1.25, g: G }, &[0.5, 0.4, 0.7]);
    holds(Atwood { m1: 2.0, m2: 3.5, c: -4.0, g: G }, &[-1.0, -3.0, 0.4]);
    holds(DoublePendulum { m1: 2.0, m2: 1.25, l1: 0.9, l2: 0.6, g: G }, &[0.4, -0.7, 0.9, 1.2]);
    holds(RollingDisk { m: 2.0, r: 0.5, j: 0.125, g: G }, &[0.3, 0.4, 0.5, 0.6, 0.7, 0.8, -5.0, 0.4, 0.6]);
    holds(AppellHamel { m1: 1.2, m2: 0.7, g: G, c: 0.6 }, &[0.3, 0.4, 0.5, 0.6, 0.7, 0.8]);
    holds(CurvedPath { m: 1.5, g: G, kappa: 0.4 }, &[0.3, 0.4, 0.5, 0.6]);
    holds(Pushed { m: 1.5, g: G, k: 0.4 }, &[0.3, 0.4, 0.5, 0.6]);
    holds(TripleRod { m: 1.5, g: G, l: 0.8 }, &[0.5, -0.6, 0.7]);
    holds(Prescribed { m: 1.5, g: G, w: 0.7 }, &[0.3, 0.4, 0.5, 0.6]);
    holds(PendulumByMomentum { m: 1.5, g: G, l: 0.8 }, &[0.7, 0.4, 0.5, 0.6]);
}

/// Long equations, over parts.
#[test]
fn parts_stand_before_what_they_are_parts_of() {
    let four_bar = FourBar { l1: 0.5, l2: 1.8, l3: 1.2, d: 2.0, m1: 0.5, m2: 1.8, m3: 1.2, g: 9.81, tau: 2.0 };
    assert!(FourBar::MODEL.equations.iter().any(|equation| equation.function.is_empty()));
    holds(four_bar, &[0.3, 0.6, 1.9, 0.7]);
    let crank = SliderCrank { l: 1.0, m1: 1.0, m2: 1.0, m3: 2.0, g: 9.81 };
    holds(crank, &[0.5, 0.6, 1.7, 0.7]);
    let axis = CarAxis { eps: 0.01, m: 10.0, l: 1.0, l0: 0.5, r: 0.1, w: 10.0, g: 1.0 };
    holds(axis, &[0.1, 0.5, 1.0, 0.6, 0.3, 0.2]);
}

/// The fields of every `Equation { .. }` in emitted code that are texts, by their names.
fn equations(code: TokenStream, found: &mut Vec<HashMap<String, String>>) {
    let trees: Vec<TokenTree> = code.into_iter().collect();
    for (at, tree) in trees.iter().enumerate() {
        let TokenTree::Group(group) = tree else { continue };
        if at == 0 || trees[at - 1].to_string() != "Equation" {
            equations(group.stream(), found);
            continue;
        }
        let fields: Vec<TokenTree> = group.stream().into_iter().collect();
        let text = |tree: &TokenTree| syn::parse2::<syn::LitStr>(tree.to_token_stream()).ok().map(|text| text.value());
        let pairs = fields.windows(3).filter(|w| w[1].to_string() == ":");
        found.push(pairs.filter_map(|w| Some((w[0].to_string(), text(&w[2])?))).collect());
    }
}

/// Whether braces, environments and delimiters of LaTeX open and close in turn, all of `align*` but its markers included.
fn balanced(latex: &str) -> bool {
    let mut open = Vec::new();
    let mut rest = latex;
    while let Some(at) = rest.find(['{', '}', '\\']) {
        let (token, after) = rest[at..].split_at(1);
        let word: String = after.chars().take_while(char::is_ascii_alphabetic).collect();
        rest = match (token, word.as_str()) {
            ("{", _) => {
                open.push("{".to_owned());
                after
            }
            ("}", _) => {
                if open.pop().as_deref() != Some("{") {
                    return false;
                }
                after
            }
            // `\\`, `\_`, `\{` and the like are one character.
            (_, "") => after.get(1..).unwrap_or_default(),
            (_, "left") => {
                open.push("left".to_owned());
                &after[5..]
            }
            (_, "right") => {
                if open.pop().as_deref() != Some("left") {
                    return false;
                }
                &after[6..]
            }
            (_, "begin") => {
                let (name, after) = after["begin{".len()..].split_once('}').expect("the name of an environment");
                open.push(name.to_owned());
                after
            }
            (_, "end") => {
                let (name, after) = after["end{".len()..].split_once('}').expect("the name of an environment");
                if open.pop().as_deref() != Some(name) {
                    return false;
                }
                after
            }
            (_, word) => &after[word.len()..],
        };
    }
    open.is_empty()
}

#[test]
fn what_does_not_balance_is_seen() {
    assert!(balanced(r"\begin{cases} \left(a_{\}}\right) \\ b \end{cases}"));
    for wrong in [r"{a", r"a}", r"\left(a", r"\left({a\right)}", r"\begin{a}\end{b}", r"{\begin{a}}\end{a}"] {
        assert!(!balanced(wrong), "{wrong}");
    }
}

/// The derive's texts for all models of `models`, those included that are too large to be compiled here.
#[test]
fn every_text_is_read_and_written_as_it_was() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/models");
    for file in declared::rust_files(&folder) {
        let source = std::fs::read_to_string(&file).expect("the file can be read");
        for model in declared::models(&source).into_iter().filter(|model| !LARGE.contains(&&*model.ident.to_string())) {
            let mut found = Vec::new();
            equations(holonomy_engine::expand(model.to_token_stream()), &mut found);
            assert!(found.len() > 10, "{}: no equations", model.ident);
            for equation in &found {
                let text = &equation["text"];
                let formula: Formula = text.parse().unwrap_or_else(|e| panic!("{}: {text}: {e}", model.ident));
                assert_eq!(formula.to_string(), *text, "{}", model.ident);
                assert!(balanced(&formula.latex()), "{}: {text}: {}", model.ident, formula.latex());
            }
        }
    }
}

/// The disk's equations as a page that can be read; `HOLONOMY_BLESS=1` writes it anew.
#[test]
fn the_disk_in_latex() {
    let latex = RollingDisk::MODEL.latex();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/rolling_disk.tex");
    assert_eq!(kept::changed(&path, &latex), None);
    assert!(balanced(&latex));
    assert_eq!(latex.matches(" &= ").count(), RollingDisk::MODEL.equations.len());
    assert_eq!(
        latex.matches("\\tag{").count(),
        RollingDisk::MODEL.equations.iter().filter(|e| !e.source.is_empty()).count()
    );
}
