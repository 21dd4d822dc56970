//! Golden data: JSON that this project did not compute, and the comparison against it.

use serde_json::Value;

/// A file of golden data.
///
/// # Panics
/// If it is no JSON.
pub fn parse(text: &str) -> Value {
    serde_json::from_str(text).expect("golden data must be JSON")
}

/// A number, a list of numbers or a list of rows as one list.
///
/// # Panics
/// If there is anything else in it.
pub fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(list) => list.iter().flat_map(numbers).collect(),
        other => vec![other.as_f64().unwrap_or_else(|| panic!("not a number: {other}"))],
    }
}

/// The entries of a list.
///
/// # Panics
/// If it is no list.
pub fn list(value: &Value) -> &[Value] {
    value.as_array().expect("a list")
}

/// A text.
///
/// # Panics
/// If it is none.
pub fn text(value: &Value) -> &str {
    value.as_str().expect("a text")
}

/// The numbers of an object under the given names.
pub fn picked(value: &Value, names: &[&str]) -> Vec<f64> {
    names.iter().flat_map(|name| numbers(&value[*name])).collect()
}

/// Requires every entry to be within `relative` times the largest component of what is expected.
///
/// # Panics
/// If one is not.
pub fn assert_close(what: &str, computed: &[f64], expected: &[f64], relative: f64) {
    assert_close_at(what, computed, expected, relative, 0.0);
}

/// The same; where every expected component vanishes beside `natural`, that is the scale: the size of the terms that cancel.
///
/// # Panics
/// If an entry is not close.
pub fn assert_close_at(what: &str, computed: &[f64], expected: &[f64], relative: f64, natural: f64) {
    assert_eq!(computed.len(), expected.len(), "{what}: number of entries");
    let largest = expected.iter().fold(0.0_f64, |scale, e| scale.max(e.abs()));
    let scale = if largest <= f64::EPSILON * natural { natural } else { largest };
    for (i, (c, e)) in computed.iter().zip(expected).enumerate() {
        let error = (c - e).abs();
        assert!(error <= relative * scale, "{what}[{i}]: {c:e} instead of {e:e}, off by {error:e} at scale {scale:e}");
    }
}

/// The case of that name.
pub fn case<'a>(golden: &'a Value, name: &str) -> &'a Value {
    list(&golden["cases"]).iter().find(|case| text(&case["name"]) == name).expect("the case is there")
}

/// A struct of parameters from the object that names them.
macro_rules! from_json {
    ($values:expr, $model:ident { $($field:ident: $name:literal),* $(,)? }) => {
        $model { $($field: $values[$name].as_f64().expect("a number")),* }
    };
}
pub(crate) use from_json;
