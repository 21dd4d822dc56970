//! A model with more than 3,000 temporaries in its derivative builds with full debug information, in dev and in release.
//!
//! Thousands of flat `let`s with debug information are more than rustc takes; the emitted blocks are for this.

mod crates;
mod support;

use crates::Crate;
use oracle::{Motion, System, read_models};
use quote::ToTokens;
use std::fmt::Write as _;
use support::parallel;
use support::splitmix::SplitMix;
use syn::visit::Visit;

/// Particles in a plane that attract each other in pairs, ...
const PARTICLES: usize = 34;
/// ... the first of them in pairs on rods.
const RODS: usize = 3;
/// The `let`s that the derivative must have at least.
const LEAST: usize = 3_000;
/// The most `let`s in one block.
const IN_A_BLOCK: usize = 250;

/// x, y of every particle; the second end of a rod by the rod's angle.
fn source() -> String {
    let joined = |a: usize, b: usize| a / 2 == b / 2 && a.max(b) < 2 * RODS;
    let all =
        |text: &dyn Fn(usize) -> String, separator: &str| (0..PARTICLES).map(text).collect::<Vec<_>>().join(separator);
    let mut model = String::from("#[derive(ConstrainedSystem, Clone, Debug)]\n");
    let _ = writeln!(model, "#[coordinates({})]", all(&|i| format!("x{i}, y{i}"), ", "));
    let _ = writeln!(model, "#[inertia(diag({}))]", all(&|i| format!("m{i}, m{i}"), ", "));
    model += "#[define(\n";
    for a in 0..PARTICLES {
        for b in (a + 1..PARTICLES).filter(|&b| !joined(a, b)) {
            let square = format!("powi(x{a} - x{b}, 2) + powi(y{a} - y{b}, 2)");
            let _ = writeln!(model, "    f{a}_{b} = m{a}*m{b}/powi(sqrt({square}), 3),");
        }
    }
    model += ")]\n#[forces(\n";
    for a in 0..PARTICLES {
        for axis in ["x", "y"] {
            let others = (0..PARTICLES).filter(|&b| a != b && !joined(a, b));
            let pulls = others.map(|b| format!("f{}_{}*({axis}{b} - {axis}{a})", a.min(b), a.max(b)));
            let _ = writeln!(model, "    g*({}),", pulls.collect::<Vec<_>>().join(" + "));
        }
    }
    let angles: Vec<String> = (0..RODS).map(|rod| format!("a{rod}")).collect();
    let _ = write!(model, ")]\n#[configuration(of({})", angles.join(", "));
    for rod in 0..RODS {
        let (a, b) = (2 * rod, 2 * rod + 1);
        let _ = write!(model, ", x{b} = x{a} + l*cos(a{rod}), y{b} = y{a} + l*sin(a{rod})");
    }
    model += ")]\n";
    for rod in 0..RODS {
        let (a, b) = (2 * rod, 2 * rod + 1);
        let square = format!("powi(x{b} - x{a}, 2) + powi(y{b} - y{a}, 2)");
        let _ = writeln!(model, "#[constraint(rod{rod}: ({square} - l*l)/2 == 0)]");
    }
    let masses = all(&|i| format!("    #[nominal({})]\n    pub m{i}: f64,\n", 1.0 + 0.125 * i as f64), "");
    model
        + &format!(
            "pub struct Cluster {{\n{masses}    #[nominal(0.75)]\n    pub l: f64,\n    #[nominal(2.5)]\n    pub g: f64,\n}}\n"
        )
}

/// The `let`s of the derivative: all of them, and the most in one block; the functions that it is split into.
#[derive(Default)]
struct Lets {
    inside: bool,
    functions: usize,
    all: usize,
    in_a_block: usize,
}

impl<'a> Visit<'a> for Lets {
    fn visit_signature(&mut self, signature: &'a syn::Signature) {
        let name = signature.ident.to_string();
        self.inside = name.starts_with("derivative");
        self.functions += usize::from(self.inside);
    }

    fn visit_block(&mut self, block: &'a syn::Block) {
        if self.inside {
            let lets = block.stmts.iter().filter(|statement| matches!(statement, syn::Stmt::Local(_))).count();
            self.all += lets;
            self.in_a_block = self.in_a_block.max(lets);
        }
        syn::visit::visit_block(self, block);
    }
}

fn count(source: &str) -> Lets {
    let mut item: syn::ItemStruct = syn::parse_str(source).expect("a struct");
    item.attrs.retain(|a| !a.path().is_ident("derive"));
    let expansion = syn::parse2(holonomy_engine::expand(item.into_token_stream())).expect("the expansion is Rust");
    let mut lets = Lets::default();
    lets.visit_file(&expansion);
    lets
}

/// A program that reads a state and prints its rate.
const MAIN: &str = r#"
fn main() {
    let numbers = |text: String| -> Vec<f64> { text.split(' ').map(|x| x.parse().expect("a number")).collect() };
    let mut arguments = std::env::args().skip(1).map(numbers);
    let (parameters, state) = (arguments.next().expect("parameters"), arguments.next().expect("a state"));
    let cluster = cluster(&parameters).prepare().expect("the parameters are good");
    let s = State::<Cluster>::from_fn(|i| state[i]);
    let (rate, _) = cluster.derivative(0.0, &s, &[]);
    let rate: [f64; LENGTH] = rate.into();
    println!("{}", rate.map(|x| x.to_string()).join(" "));
}
"#;

fn program(source: &str, parameters: &[(String, Option<f64>)], length: usize) -> String {
    let fields: Vec<String> =
        parameters.iter().enumerate().map(|(i, (name, _))| format!("{name}: parameters[{i}]")).collect();
    format!(
        "use holonomy::{{ConstrainedSystem, State, Vector}};\n\n{source}\n\
         const LENGTH: usize = {length};\n\n\
         fn cluster(parameters: &[f64]) -> Cluster {{\n    Cluster {{ {} }}\n}}\n{MAIN}",
        fields.join(", ")
    )
}

fn list(numbers: &[f64]) -> String {
    numbers.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
}

/// Holds q̇ and q̈ against the full system (2.8) with v̇ = Dᵀ q̈ + a_u among its rows; gives the largest error as a part of the largest v̇.
fn agrees(system: &System<'_>, motion: &Motion, (q, qdot): (&[f64], &[f64]), printed: &str) -> f64 {
    let rate: Vec<f64> = printed.split_whitespace().map(|x| x.parse().expect("a number")).collect();
    let (rates, accelerations) = rate.split_at(q.len());
    assert_eq!(rates, qdot, "the rates are the speeds");
    let (partial, bias) = system.partial_velocities(0.0, q, qdot);
    let (mut worst, largest) = (0.0_f64, motion.acceleration.amax());
    for (i, expected) in motion.acceleration.iter().enumerate() {
        let along = accelerations.iter().enumerate().map(|(j, a)| partial[(i, j)].value * a).sum::<f64>();
        let error = (along + bias[i].value - expected).abs();
        assert!(error <= motion.acceleration_error[i], "v̇[{i}] is off by {error:e} from {expected:e}");
        worst = worst.max(error / largest);
    }
    worst
}

#[test]
fn builds_with_debug_information_and_is_right() {
    let source = source();
    let lets = count(&source);
    println!("{} lets in {} functions, at most {} in a block", lets.all, lets.functions, lets.in_a_block);
    assert!(lets.all > LEAST && lets.in_a_block <= IN_A_BLOCK && lets.functions > 1);

    let declared = read_models(&source).remove(0);
    let system = System::nominal(&declared);
    let mut random = SplitMix::new(3);
    // particles on a grid of unit spacing, each a little off its place, so that none are close
    let columns = (PARTICLES as f64).sqrt().ceil() as usize;
    let place = |name: &String, jitter: f64| match name[1..].parse::<usize>() {
        Ok(i) if name.starts_with('x') => (i % columns) as f64 * 1.5 + jitter,
        Ok(i) if name.starts_with('y') => (i / columns) as f64 * 1.5 + jitter,
        _ => jitter,
    };
    let q: Vec<f64> = declared.state_coordinates().iter().map(|name| place(name, random.between(-0.3, 0.3))).collect();
    let qdot = random.vector(q.len(), -1.0, 1.0);
    let motion = system.configured_motion(0.0, &q, &qdot);

    let program = program(&source, &declared.parameters, 2 * q.len());
    let made = Crate::new("large-model", "", "[profile.release]\ndebug = 2\n", &[("main.rs", &program)]);
    let arguments = [list(&system.parameters), list(&[q.clone(), qdot.clone()].concat())];
    // Both at the same time: most of either is one crate after the other.
    let profiles = ["dev", "release"];
    let runs = parallel::each(profiles.len(), |number| {
        let clock = std::time::Instant::now();
        let printed = made.cargo("run", &["--profile", profiles[number], "--", &arguments[0], &arguments[1]]);
        (printed, clock.elapsed().as_secs_f64())
    });
    for (profile, (printed, seconds)) in profiles.iter().zip(runs) {
        let worst = agrees(&system, &motion, (&q, &qdot), &printed);
        println!("{profile}: {seconds:.0} s, largest error {worst:.1e}");
        assert!(worst <= 1e-11);
    }
}
