//! Every quantity by which the result divides, signed and named.

use super::equations::{Equations, Guard, GuardKind};
use crate::symbolic::{Expr, Graph, Node, Rational, Stage};

/// Guards as they are found: those of the state and those of parameters.
#[derive(Clone, Debug, Default)]
pub struct Guards {
    /// Functions of the state.
    pub state: Vec<Guard>,
    /// Functions of parameters.
    pub parameters: Vec<Guard>,
}

impl Guards {
    /// A quantity that must not vanish: each of its factors must not, so that a change of sign is seen in every one.
    pub fn pivot(&mut self, graph: &Graph, e: Expr, called: &str, origin: &str, rows: &[String]) {
        let (_, factors) = graph.as_term(e);
        for (base, _) in factors {
            self.push(graph, base, GuardKind::Pivot, called, origin, rows);
        }
    }

    /// A pivot of M_d. Even powers are watched by their signed base: J cos²θ stays positive while cos θ runs through
    /// zero. `Err` with the text of a pivot that is a negative number.
    pub fn positive(
        &mut self,
        graph: &mut Graph,
        e: Expr,
        called: &str,
        origin: &str,
        rows: &[String],
    ) -> Result<(), String> {
        let (coefficient, factors) = graph.as_term(e);
        let mut rest = Vec::new();
        for (base, exponent) in factors {
            if exponent % 2 == 0 {
                self.push(graph, base, GuardKind::Pivot, called, origin, rows);
            } else {
                rest.push((base, exponent));
            }
        }
        let sign = if coefficient.is_negative() { Rational::MINUS_ONE } else { Rational::ONE };
        let rest = graph.power_product(sign, &rest);
        match graph.as_number(rest) {
            Some(number) if number.is_negative() => Err(graph.display(e)),
            Some(_) => Ok(()),
            None => {
                self.push(graph, rest, GuardKind::Positive, called, origin, rows);
                Ok(())
            }
        }
    }

    /// What some expression divides by, and what depends on more than parameters.
    pub fn divisors(&mut self, graph: &Graph, roots: &[Expr], called: &str, origin: &str, rows: &[String]) {
        for e in graph.reachable(roots) {
            if let Node::Product(factors) = graph.node(e) {
                let below = factors.iter().filter(|(base, k)| *k < 0 && graph.stage(*base) > Stage::Parameter);
                below.for_each(|(base, _)| self.push(graph, *base, GuardKind::Pivot, called, origin, rows));
            }
        }
    }

    /// Adds what another chart needs of the parameters.
    pub fn of_parameters(&mut self, graph: &Graph, guards: Vec<Guard>) {
        for Guard { expr, name, kind, origin, rows, .. } in guards {
            self.push(graph, expr, kind, &name, &origin, &rows);
        }
    }

    fn push(&mut self, graph: &Graph, expr: Expr, kind: GuardKind, called: &str, origin: &str, rows: &[String]) {
        if kind == GuardKind::Pivot && graph.bounds(expr).exclude_zero() {
            return;
        }
        let list = match graph.stage(expr) {
            Stage::Constant => return,
            Stage::Parameter => &mut self.parameters,
            _ => &mut self.state,
        };
        let known = |g: &Guard| g.expr == expr && (g.kind == kind || g.kind == GuardKind::Positive);
        if list.iter().any(known) {
            return;
        }
        list.retain(|g| g.expr != expr);
        let name = match readable(graph, expr, called) {
            text if text != called => text,
            // The factors of one pivot.
            _ => match list.iter().filter(|g| g.name.starts_with(called)).count() {
                0 => called.to_owned(),
                others => format!("{called}, factor {}", others + 1),
            },
        };
        list.push(Guard { expr, name, kind, origin: origin.to_owned(), rows: rows.to_vec(), start: None });
    }
}

/// A name longer than this is none.
const LONGEST: usize = 160;

/// The text of an expression as its name, or what it is `called` where the text is too long for one.
pub fn readable(graph: &Graph, e: Expr, called: &str) -> String {
    let text = graph.display(e);
    if text.contains('…') || text.chars().count() > LONGEST { called.to_owned() } else { text }
}

/// Drops the pivots of the tangent basis that cancelled: where no function of the state divides by anything that is not
/// another guard, the basis is regular at their zeros, and a run need not stop there.
pub fn drop_cancelled_pivots(equations: &mut Equations, origin: &str) {
    let roots = equations.state_roots();
    drop_cancelled(&equations.graph, &roots, &mut equations.guards, origin);
    for chart in &mut equations.charts {
        let roots = chart.state_roots();
        drop_cancelled(&equations.graph, &roots, &mut chart.guards, origin);
    }
}

fn drop_cancelled(graph: &Graph, roots: &[Expr], guards: &mut Vec<Guard>, origin: &str) {
    let mut divisors: Vec<Expr> = Vec::new();
    for e in graph.reachable(roots) {
        if let Node::Product(factors) = graph.node(e) {
            let below = factors.iter().filter(|(base, k)| *k < 0 && graph.stage(*base) > Stage::Parameter);
            divisors.extend(below.map(|(base, _)| *base).filter(|base| !graph.bounds(*base).exclude_zero()));
        }
    }
    let others: Vec<Expr> = guards.iter().filter(|g| g.origin != origin).map(|g| g.expr).collect();
    if divisors.iter().all(|d| others.contains(d)) {
        guards.retain(|g| g.origin != origin);
    }
}

/// Whether some expression divides by the number zero.
pub fn divides_by_zero(equations: &Equations) -> bool {
    let graph = &equations.graph;
    let zero = |e: Expr| matches!(graph.node(e), Node::Product(factors) if factors.iter().any(|(b, k)| *k < 0 && graph.is_zero(*b)));
    graph.reachable(&equations.roots()).into_iter().any(zero)
}

/// Adds the parameter-only quantities by which some expression divides, and those that were cancelled on the way.
pub fn add_parameter_divisors(equations: &mut Equations) {
    let roots = equations.roots();
    let graph = &equations.graph;
    let mut divisors: Vec<Expr> = graph.cancelled().collect();
    for e in graph.reachable(&roots) {
        if let Node::Product(factors) = graph.node(e) {
            let below = factors.iter().filter(|(base, k)| *k < 0 && graph.stage(*base) == Stage::Parameter);
            divisors.extend(below.map(|(base, _)| *base));
        }
    }
    let mut guards = Guards { state: Vec::new(), parameters: std::mem::take(&mut equations.parameter_guards) };
    for e in divisors {
        guards.push(graph, e, GuardKind::Pivot, "a divisor of parameters", "a divisor", &[]);
    }
    equations.parameter_guards = guards.parameters;
}
