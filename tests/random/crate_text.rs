//! Random models as a file of Rust.

use super::generate::RandomModel;

/// The structs, and a macro that calls another one with every model and its fields.
pub fn crate_text(models: &[RandomModel]) -> String {
    let structs: String = models.iter().map(|model| format!("\n{}", model.source)).collect();
    let call = |model: &RandomModel| format!("            {}({})\n", model.name, model.parameters.join(", "));
    let calls: String = models.iter().map(call).collect();
    format!(
        "// Generated from tests/random: random models, and a macro that names them all.\n\n\
         use holonomy::ConstrainedSystem;\n{structs}\n\
         macro_rules! every_random_model {{\n    ($then:ident) => {{\n        $then! {{\n{calls}        }}\n    }};\n}}\n\
         pub(crate) use every_random_model;\n"
    )
}
