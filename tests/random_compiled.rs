//! 200 random models as real Rust: derived by the macro, compiled, held against the oracle; those in two stages also against
//! themselves in one.

mod claims;
mod support;

use claims::compiled::{claim, other_claim};
use claims::stages::difference;
use claims::states::random_state;
use holonomy::ConstrainedSystem;
use oracle::{Declaration, System, check, read_models};
use support::fields::Field;
use support::parallel;
use support::splitmix::SplitMix;

/// The models themselves, one struct each.
#[allow(dead_code, reason = "not every parameter occurs in an equation")]
mod models {
    include!("data/random_models.rs");
}

const SOURCE: &str = include_str!("data/random_models.rs");
/// Checked against the generator in tests/random_models.rs.
const MODELS: usize = 200;
const STATES: usize = 3;

thread_local! {
    /// What the file declares; every thread reads it once.
    static DECLARED: &'static [Declaration] = read_models(SOURCE).leak();
}

/// The declaration of a model.
fn declared<M: ConstrainedSystem>() -> &'static Declaration {
    DECLARED.with(|all| all.iter().find(|d| d.name == M::MODEL.name).expect("the model is declared"))
}

/// Holds the emitted code of a model against its declaration.
fn agrees<M: ConstrainedSystem>(build: impl Fn(&[f64]) -> M) -> Result<f64, String> {
    let declared = declared::<M>();
    let mut random = SplitMix::new(M::MODEL.name.bytes().map(u64::from).sum());
    let mut system = System::nominal(declared);
    let model = build(&system.parameters).prepare().map_err(|e| format!("{}: {e}", declared.name))?;
    let mut worst = 0.0_f64;
    for _ in 0..STATES {
        system.inputs = random.vector(declared.inputs.len(), -1.0, 1.0);
        let state = (0..20).find_map(|_| random_state(&model, &system, &mut random, [-1.0, 1.0]));
        let (t, q, u) = state.expect("the manifold is reached");
        for claim in [claim(&model, t, &q, &u, &system.inputs), other_claim(&model, t, &q, &u, &system.inputs)] {
            let report = check(&system, &claim);
            if !report.failures.is_empty() {
                let failures = report.failures.join("\n  ");
                return Err(format!("{} at t = {t}, q = {q:?}, u = {u:?}\n  {failures}", declared.name));
            }
            worst = worst.max(report.worst);
        }
    }
    Ok(worst)
}

macro_rules! check_all {
    ($($model:ident($($field:ident),*))*) => {{
        let checks: &[fn() -> Result<f64, String>] = &[$(|| agrees(|p| {
            let mut p = p.iter().copied();
            models::$model { $($field: Field::take(&mut p)),* }
        })),*];
        parallel::each(checks.len(), |number| checks[number]())
    }};
}

#[test]
fn compiled_random_models_agree_with_the_oracle() {
    let results = models::every_random_model!(check_all);
    assert!(results.len() >= MODELS);
    let failures: Vec<String> = results.iter().filter_map(|result| result.clone().err()).collect();
    let worst = results.iter().flatten().fold(0.0_f64, |worst, w| worst.max(*w));
    println!("largest error {worst:.1e} of its bound");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// The same motion in two stages and in one: v̇ and every λ, to 1e-12 times what both eliminations amplify.
fn same<A: ConstrainedSystem, B: ConstrainedSystem>(two: impl Fn(&[f64]) -> A, one: impl Fn(&[f64]) -> B) -> f64 {
    let (staged, whole) = (declared::<A>(), declared::<B>());
    let mut random = SplitMix::new(A::MODEL.name.bytes().map(u64::from).sum());
    let system = System { inputs: random.vector(staged.inputs.len(), -1.0, 1.0), ..System::nominal(staged) };
    let two = two(&system.parameters).prepare().expect("good parameters");
    let one = one(&system.parameters).prepare().expect("good parameters");
    let mut worst = 0.0_f64;
    for _ in 0..STATES {
        let state = (0..20).find_map(|_| random_state(&two, &system, &mut random, [-1.0, 1.0]));
        let (t, q, u) = state.expect("the manifold is reached");
        let staged = claim(&two, t, &q, &u, &system.inputs);
        let speed = |name: &&str| whole.speeds.iter().position(|v| v == name).map(|i| staged.velocities[i]);
        let u: Vec<f64> = B::MODEL.state_speeds.iter().map(|name| speed(name).expect("a speed of the model")).collect();
        let whole = claim(&one, t, &staged.coordinates, &u, &system.inputs);
        worst = worst.max(difference(&staged, &whole).unwrap_or_else(|text| panic!("{}: {text}", A::MODEL.name)));
    }
    worst
}

macro_rules! compare_all {
    ($($two:ident $one:ident($($field:ident),*))*) => {
        vec![$({
            let two = |p: &[f64]| {
                let mut p = p.iter().copied();
                models::$two { $($field: Field::take(&mut p)),* }
            };
            let one = |p: &[f64]| {
                let mut p = p.iter().copied();
                models::$one { $($field: Field::take(&mut p)),* }
            };
            same(two, one)
        }),*]
    };
}

#[test]
fn compiled_models_in_two_stages_move_as_in_one() {
    let differences = models::every_random_pair!(compare_all);
    let worst = differences.iter().fold(0.0_f64, |worst, d| worst.max(*d));
    println!("{} models in two stages and in one, largest difference {worst:.1e}", differences.len());
    assert!(differences.len() >= 10, "{}", differences.len());
}
