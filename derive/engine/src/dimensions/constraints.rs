//! Rows of constraints, and what their multipliers measure: λ times the rate that a row binds is a power.

use super::Checker;
use super::dimension::Dimension;
use super::functions::is_rate;
use super::report::Side;
use crate::syntax::{AXES, Expression, Term};
use std::collections::BTreeMap;

/// How often what is bound was differentiated.
type Order = u8;

const ACCELERATIONS: [&str; 3] = ["ddot", "acceleration", "angular_acceleration"];
const VELOCITIES: [&str; 4] = ["velocity", "angular_velocity", "momentum", "angular_momentum"];

impl Checker<'_> {
    pub fn constraints(&mut self) {
        let orders = self.orders();
        for constraint in &self.declarations.constraints {
            let name = constraint.name.to_string();
            self.origin = format!("the constraint `{name}`");
            let Some(right) = &constraint.right else {
                self.joint(&name, &constraint.left);
                continue;
            };
            let (of_left, of_right) = (self.dimension(&constraint.left), self.dimension(right));
            let row = match (of_left, of_right) {
                (Some(a), Some(b)) => {
                    let (left, other) = (Side::whole(a.clone(), &constraint.left), Side::whole(b, right));
                    self.equal(constraint.sign, &left, "set equal to", &other).then_some(a)
                }
                (one, None) | (None, one) => one,
            };
            let order = order(&constraint.left, &orders).max(order(right, &orders));
            if let Some(row) = row {
                // C v is the rate of a position row, a velocity row itself, and what an acceleration row is the rate of.
                let bound = row.times(&self.time.powi(i64::from(order) - 1));
                self.tell(&name, self.power().over(&bound));
            }
        }
        for release in self.declarations.geometry.releases() {
            let name = release.name.to_string();
            self.origin = format!("the release `{name}`");
            let way = match release.get("along") {
                Some(along) => self.dimension(along).map(|along| self.length.over(&along)),
                None => Some(Dimension::pure()),
            };
            if let Some(way) = way {
                self.reactions.insert(name, self.energy.over(&way));
            }
        }
    }

    /// A multiplier and those of a vector's components.
    fn tell(&mut self, name: &str, multiplier: Dimension) {
        for axis in AXES {
            self.reactions.entry(format!("{name}_{axis}")).or_insert_with(|| multiplier.clone());
        }
        self.reactions.insert(name.to_owned(), multiplier);
    }

    /// Points come together, or roll; axes are at right angles.
    fn joint(&mut self, name: &str, written: &Expression) {
        let Some((Term::Call(function, arguments), _)) = written.terms().last() else { return };
        let length = self.length.clone();
        let points = if function == "rolling" { 1 } else { 2 };
        for at in arguments.iter().take(points) {
            self.expected_part(written, *at, "a point", &length);
        }
        let mut axes = Dimension::pure();
        if matches!(function.as_str(), "revolute" | "universal") {
            for at in arguments.iter().skip(points) {
                let axis = self.dimension(&written.part(*at)).unwrap_or_default();
                axes = axes.times(&axis);
            }
        }
        self.tell(name, self.energy.over(&length));
        self.reactions.insert(format!("{name}_axes"), self.energy.over(&axes));
    }

    /// What `reaction(name)` is; one of which nothing is known where the constraint was not understood.
    pub fn reaction(&mut self, name: &str) -> Dimension {
        self.multiplier(name).unwrap_or_else(|| self.solver.fresh())
    }

    /// The multiplier of a row; the rows of a joint about its axes are called `name_axes..`.
    pub fn multiplier(&self, name: &str) -> Option<Dimension> {
        let about = || name.rfind("_axes").and_then(|at| self.reactions.get(&name[..at + "_axes".len()]));
        self.reactions.get(name).or_else(about).cloned()
    }

    /// What defines mention.
    fn orders(&self) -> BTreeMap<String, Order> {
        let mut orders: BTreeMap<String, Order> = BTreeMap::new();
        let declarations = self.declarations;
        let speeds = declarations.speeds.iter().flat_map(|speeds| &speeds.names);
        let speeds = speeds.map(|name| name.ident.to_string());
        let quaternions = declarations.quaternions();
        let all = declarations.all_speeds(&quaternions).into_iter();
        let all = all.map(|speed| declarations.speed_name(speed, &quaternions));
        orders.extend(speeds.chain(all).map(|name| (name, 1)));
        loop {
            let mut changed = false;
            for define in &declarations.defines {
                let (name, found) = (define.name.to_string(), order(&define.value, &orders));
                if orders.get(&name).copied().unwrap_or(0) < found {
                    orders.insert(name, found);
                    changed = true;
                }
            }
            if !changed {
                return orders;
            }
        }
    }
}

fn order(expression: &Expression, orders: &BTreeMap<String, Order>) -> Order {
    let of_name = |name: &str| orders.get(name).copied().unwrap_or(0);
    let of_term = |term: &Term| match term {
        Term::Name(name) => of_name(name),
        Term::Call(function, arguments) if is_rate(function, arguments.len()) => {
            let inside = match &expression.terms()[arguments[0]].0 {
                Term::Name(name) => of_name(name),
                _ => 0,
            };
            if function == "ddot" { 2 } else { inside + 1 }
        }
        Term::Call(function, _) if ACCELERATIONS.contains(&function.as_str()) => 2,
        Term::Call(function, _) if VELOCITIES.contains(&function.as_str()) => 1,
        _ => 0,
    };
    expression.terms().iter().map(|(term, _)| of_term(term)).max().unwrap_or(0).min(2)
}
