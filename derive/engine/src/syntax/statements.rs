//! The names of the statements, and the attribute names that are nobody's mistake.

use super::diagnostics::{distance, nearest};

/// The statements that stand on the struct.
pub const STATEMENTS: &[&str] = &[
    "coordinates",
    "speeds",
    "kinematics",
    "inertia",
    "forces",
    "kinetic_energy",
    "potential_energy",
    "constraint",
    "configuration",
    "velocities",
    "independent",
    "complement",
    "inputs",
    "define",
    "output",
    "start",
    "size",
    "function",
    "frame",
    "point",
    "particle",
    "body",
    "gravity",
    "force",
    "torque",
    "generalized_force",
    "spring",
    "damper",
    "armature",
    "release",
    "holonomy",
];

/// The statements that stand on a field.
pub const FIELD_STATEMENTS: &[&str] = &["unit", "nominal"];

/// Every attribute name that `#[proc_macro_derive(.., attributes(..))]` registers: the two lists
/// above, in this order.
pub fn helper_attributes() -> impl Iterator<Item = &'static str> {
    [STATEMENTS, FIELD_STATEMENTS].into_iter().flatten().copied()
}

/// rustc's own attributes that may stand on a struct or a field, and the common ones of other
/// derives: never taken for a misspelt statement.
const FOREIGN: &[&str] = &[
    "allow",
    "arbitrary",
    "automatically_derived",
    "builder",
    "cfg",
    "cfg_attr",
    "clap",
    "cold",
    "command",
    "debug",
    "default",
    "deny",
    "deprecated",
    "derive",
    "diagnostic",
    "doc",
    "error",
    "expect",
    "forbid",
    "from",
    "global_allocator",
    "inline",
    "instrument",
    "into",
    "must_use",
    "non_exhaustive",
    "path",
    "proptest",
    "repr",
    "serde",
    "source",
    "test",
    "validate",
    "warn",
];

/// The statement that an attribute of this name was probably meant to be. Attributes of other macros must pass, so
/// the measure is stricter than for names of the model's own.
pub(crate) fn misspelt(attribute: &str) -> Option<&'static str> {
    if FOREIGN.contains(&attribute) {
        return None;
    }
    let allowed = (attribute.chars().count() / 3).max(1);
    nearest(attribute, helper_attributes()).filter(|meant| distance(attribute, meant) <= allowed)
}
