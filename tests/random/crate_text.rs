//! Random models as a file of Rust.

use super::generate::RandomModel;
use super::in_one_stage;

/// The functions that models use, each with three derivatives.
const FUNCTIONS: &str = "\
pub fn wave(s: f64) -> f64 {
    s.sin() / 2.0
}
pub fn wave_1(s: f64) -> f64 {
    s.cos() / 2.0
}
pub fn wave_2(s: f64) -> f64 {
    -s.sin() / 2.0
}
pub fn wave_3(s: f64) -> f64 {
    -s.cos() / 2.0
}
pub fn bump(s: f64) -> f64 {
    1.0 / (1.0 + s * s)
}
pub fn bump_1(s: f64) -> f64 {
    -2.0 * s / (1.0 + s * s).powi(2)
}
pub fn bump_2(s: f64) -> f64 {
    (6.0 * s * s - 2.0) / (1.0 + s * s).powi(3)
}
pub fn bump_3(s: f64) -> f64 {
    24.0 * s * (1.0 - s * s) / (1.0 + s * s).powi(4)
}
";

/// The structs, a macro that calls another one with every model and its fields, and one with every pair of a model in two stages
/// and the same in one.
pub fn crate_text(models: &[RandomModel]) -> String {
    let wholes: Vec<(&RandomModel, RandomModel)> =
        models.iter().filter_map(|model| Some((model, in_one_stage(model)?))).collect();
    let all = || models.iter().chain(wholes.iter().map(|(_, whole)| whole));
    let structs: String = all().map(|model| format!("\n{}", model.source)).collect();
    let fields = |model: &RandomModel| model.parameters.join(", ");
    let calls: String = all().map(|model| format!("            {}({})\n", model.name, fields(model))).collect();
    let pair =
        |(two, one): &(&RandomModel, RandomModel)| format!("            {} {}({})\n", two.name, one.name, fields(two));
    let pairs: String = wholes.iter().map(pair).collect();
    format!(
        "// Generated from tests/random: random models, and macros that name them all.\n\n\
         use holonomy::ConstrainedSystem;\n\n{FUNCTIONS}{structs}\n\
         macro_rules! every_random_model {{\n    ($then:ident) => {{\n        $then! {{\n{calls}        }}\n    }};\n}}\n\
         pub(crate) use every_random_model;\n\n\
         macro_rules! every_random_pair {{\n    ($then:ident) => {{\n        $then! {{\n{pairs}        }}\n    }};\n}}\n\
         pub(crate) use every_random_pair;\n"
    )
}
