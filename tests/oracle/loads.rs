//! What acts on bodies, points and frames: forces, torques, springs, dampers.

use super::bodies::Place;
use super::evaluate::Scope;
use super::geometry::Record;
use super::number::Number;
use super::statements::plain;
use super::system::Entry;
use super::vectors::{Vector, difference, inner, outer, scaled};

/// Tension or compression of a spring, as a length.
pub(super) fn stretch(spring: &Record, scope: &Scope<'_, Entry>) -> Entry {
    let rest = spring.entries.get("length").map_or(Entry::zero(), |length| scope.value(length));
    let now = match spring.entries.get("of") {
        Some(e) => scope.value(e),
        None => {
            let between = between(spring, scope);
            inner(&between, &between).sqrt()
        }
    };
    now - rest
}

/// From the one end to the other.
fn between(record: &Record, scope: &Scope<'_, Entry>) -> Vector<Entry> {
    difference(&scope.vector(record.entry("to")), &scope.vector(record.entry("from")))
}

/// Where a force, torque, spring or damper acts, and by how much.
pub(super) fn acting<'a>(record: &'a Record, scope: &Scope<'a, Entry>) -> Vec<(Place<'a>, Vec<Entry>)> {
    let minus = |force: &Vector<Entry>| force.map(|x| -x).to_vec();
    match record.kind.as_str() {
        "force" => {
            let (at, value) = (record.entry("at"), scope.vector(record.entry("value")));
            let mut all = vec![match record.entries.get("on") {
                None => (Place::Point(at), value.to_vec()),
                Some(body) => {
                    let body = scope.model.geometry.carrier(&plain(body).expect("the name of a body"));
                    let arm = difference(&scope.vector(at), &scope.vector(body.center()));
                    (Place::Body(body), [value, outer(&arm, &value)].concat())
                }
            }];
            all.extend(record.entries.get("from").map(|from| (Place::Point(from), minus(&value))));
            all
        }
        "torque" => {
            let value = scope.vector(record.entry("value"));
            let mut all = vec![(Place::Frame(record.entry("on")), value.to_vec())];
            all.extend(record.entries.get("from").map(|from| (Place::Frame(from), minus(&value))));
            all
        }
        "spring" | "damper" => {
            let pull = match record.kind.as_str() {
                "spring" => scope.value(record.entry("stiffness")) * stretch(record, scope),
                _ => {
                    let coefficient = scope.value(record.entry("coefficient"));
                    let rate = match record.entries.get("of") {
                        Some(e) => scope.along(0).rate(e).scalar(),
                        None => {
                            let of = |key: &str| scope.along(0).rate(record.entry(key)).vector();
                            let between = between(record, scope);
                            inner(&between, &difference(&of("to"), &of("from"))) / inner(&between, &between).sqrt()
                        }
                    };
                    coefficient * rate
                }
            };
            match record.entries.get("of") {
                Some(e) => vec![(Place::Scalar(e), vec![-pull])],
                None => {
                    let between = between(record, scope);
                    let on_from = scaled(pull / inner(&between, &between).sqrt(), &between);
                    let [from, to] = ["from", "to"].map(|key| Place::Point(record.entry(key)));
                    vec![(from, on_from.to_vec()), (to, minus(&on_from))]
                }
            }
        }
        _ => Vec::new(),
    }
}
