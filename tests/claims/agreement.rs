//! A random model as a derivation has it, at a few states, against the oracle.

use super::evaluated::Evaluated;
use super::states::guess;
use crate::support::splitmix::SplitMix;
use holonomy_engine::projection::Equations;
use oracle::{Report, System, check, classes, closed, onto_nonlinear_rows, read_models};
use std::collections::BTreeSet;

/// Speeds beyond this tell of a state next to one in which the constraints or the chart break down.
const FASTEST: f64 = 1e6;

/// States are this far from where a model changes between its cases.
const BETWEEN_CASES: f64 = 1e-9;

/// No state was found at which the constraints hold and the chart is regular.
pub const NOT_REACHED: &str = "the manifold is not reached";

/// What the states of a model have shown.
#[derive(Default)]
pub struct Shown {
    /// The comparisons.
    pub report: Report,
    /// The classes that the model belongs to.
    pub classes: BTreeSet<&'static str>,
}

/// A model from its source text, in one form, at so many states.
///
/// # Errors
/// That the model was refused, cannot be closed, or disagrees with the oracle, and where.
pub fn agrees(
    source: &str,
    equations: Result<Equations, String>,
    states: usize,
    random: &mut SplitMix,
) -> Result<Shown, String> {
    let equations = equations.map_err(|refusal| format!("was refused: {refusal}"))?;
    let declared = read_models(source).remove(0);
    let mut system = System::nominal(&declared);
    let mut shown = Shown::default();
    for number in 0..states {
        system.inputs = random.vector(declared.inputs.len(), -1.0, 1.0);
        let evaluated = Evaluated { equations: &equations, system: &system };
        let state = |random: &mut SplitMix| {
            let t = random.between(0.0, 2.0);
            let q = closed(&system, t, &guess(&declared, random, [-1.0, 1.0]))?;
            let u = random.vector(equations.state_speeds.len(), -1.0, 1.0);
            let x = system.coordinates(t, &q);
            let u = onto_nonlinear_rows(&system, t, &x, &u, |u| evaluated.velocities(t, &q, u))?;
            let v = evaluated.velocities(t, &q, &u);
            let regular = v.iter().all(|v| v.abs() < FASTEST);
            (regular && system.to_next_case(t, &q, &x, &v) > BETWEEN_CASES).then_some((t, q, u))
        };
        let (t, q, u) = (0..20).find_map(|_| state(random)).ok_or(NOT_REACHED)?;
        let claim = evaluated.claim(t, &q, &u);
        let report = check(&system, &claim);
        if !report.failures.is_empty() {
            let state = format!("t = {t}, q = {q:?}, u = {u:?}, inputs = {:?}", system.inputs);
            return Err(format!("at {state}\n  {}", report.failures.join("\n  ")));
        }
        shown.report.add(report);
        let k = claim.complement.nrows();
        if number == 0 {
            shown.classes.extend(classes(&system, t, &claim.coordinates, &claim.velocities, k));
        }
    }
    Ok(shown)
}
