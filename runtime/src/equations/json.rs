//! What `Serialize` adds to the fields of an equation.

use serde::Serializer;
use serde::ser::SerializeMap;

use super::Formula;

/// The text of an equation under its name, and the formula that it is.
pub(crate) fn text_and_formula<S: Serializer>(text: &str, serializer: S) -> Result<S::Ok, S::Error> {
    let formula: Option<Formula> = text.parse().ok();
    let mut entries = serializer.serialize_map(Some(2))?;
    entries.serialize_entry("text", text)?;
    entries.serialize_entry("formula", &formula)?;
    entries.end()
}
