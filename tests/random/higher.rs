//! Rows that bind more than positions and speeds: nonlinear velocity rows, acceleration rows, rows that depend on each other,
//! rows without a constant in C.

use super::constraints::row;
use super::generate::Builder;

/// The level of one row.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Position,
    Velocity,
    Nonlinear,
    Acceleration,
}
use Kind::{Acceleration, Nonlinear, Position, Velocity};

impl Builder {
    /// The statements about constraints of the kinds from 12 on.
    pub fn higher_kinds(&mut self) -> String {
        let n = self.n;
        match self.kind {
            12 => {
                let m = 1 + self.writer.random.below(n);
                let linear = self.writer.random.below(m);
                self.rows(&[vec![Velocity; linear], vec![Nonlinear; m - linear]].concat())
            }
            13 => {
                let m = 1 + self.writer.random.below(n);
                self.rows(&vec![Acceleration; m])
            }
            14 => {
                let m = 2 + self.writer.random.below(n - 1);
                let positions = 1 + self.writer.random.below(m - 1);
                self.rows(&[vec![Position; positions], vec![Nonlinear; m - positions]].concat())
            }
            15 => {
                let m = 2 + self.writer.random.below(n - 1);
                let linear = 1 + self.writer.random.below(m - 1);
                let kind = if self.writer.random.once_in(2) { Position } else { Velocity };
                self.rows(&[vec![kind; linear], vec![Acceleration; m - linear]].concat())
            }
            16 => {
                // one of each as far as there is room, the last one in any place
                let mut kinds = vec![Velocity, Nonlinear, Acceleration];
                if n > 3 {
                    kinds.insert(0, Position);
                }
                self.rows(&kinds)
            }
            17 => self.redundant(),
            18 => {
                self.varying = true;
                let m = 1 + self.writer.random.below(n);
                let positions = self.writer.random.below(m + 1);
                self.rows(&[vec![Position; positions], vec![Velocity; m - positions]].concat())
            }
            19 => self.configured(),
            _ => self.charts(),
        }
    }

    /// Rows of the given kinds, each on a pivot of its own, under names in their order.
    fn rows(&mut self, kinds: &[Kind]) -> String {
        let equations = self.equations(kinds);
        let linear = kinds.iter().filter(|kind| matches!(kind, Position | Velocity)).count();
        let rows = equations.iter().enumerate().map(|(i, equation)| row(&format!("row{}", i + 1), equation));
        rows.collect::<String>() + &self.independent(linear)
    }

    fn equations(&mut self, kinds: &[Kind]) -> Vec<String> {
        let m = kinds.len();
        let equation = |(i, kind): (usize, &Kind)| match kind {
            Position => self.position(i, m).f,
            Velocity => self.velocity(i, m),
            Nonlinear => self.nonlinear(i, m),
            Acceleration => self.acceleration(i, m),
        };
        kinds.iter().enumerate().map(equation).collect()
    }

    /// A velocity row that is not linear in the speeds and can be solved for the one of its pivot.
    fn nonlinear(&mut self, i: usize, m: usize) -> String {
        let pivot = self.v[self.order[i]].clone();
        let others = self.beside(i, m, &self.v.clone());
        let names = self.names.clone();
        let other = |builder: &mut Self| match others.is_empty() {
            true => pivot.clone(),
            false => builder.writer.random.one_of(&others).clone(),
        };
        let (v, w) = (other(self), other(self));
        let (c, b) = (self.writer.decimal(1.0, 2.0), self.writer.signed(0.1, 0.3));
        let bounded = self.writer.bounded(&names);
        let shift = format!("{}*{}", self.writer.signed(0.2, 0.6), self.writer.bounded(&names));
        match self.writer.random.below(5) {
            0 => format!("{c}*{pivot}{b}*{bounded}*{v}*{w}{shift}"),
            1 => format!("{c}*{pivot}{b}*sin({pivot} + {bounded}*{v}){shift}"),
            2 => format!("{c}*{pivot}{b}*{pivot}*{v}*{bounded}{shift}"),
            3 => format!("powi({pivot}, 2){b}*powi({v}, 2) - (2{b}*{bounded})"),
            _ => format!("{c}*{pivot}{b}*sqrt(1.50 + powi({v}, 2) + powi({w}, 2)){shift}"),
        }
    }

    /// A row that is linear in v̇, of one speed mostly, with anything in positions and speeds beside it.
    fn acceleration(&mut self, i: usize, m: usize) -> String {
        let own = self.v[0].starts_with('v');
        let pivot = self.order[i];
        let rate = |builder: &Self, j: usize| match own {
            true => format!("dot({})", builder.v[j]),
            false => format!("ddot({})", builder.x[j]),
        };
        let names = self.names.clone();
        let mut text = match self.writer.random.below(4) {
            0 => format!("ddot({})", self.x[pivot]),
            1 => rate(self, pivot),
            2 => format!("{}*{}", self.writer.decimal(1.0, 2.0), rate(self, pivot)),
            _ => {
                format!("(1.50{}*{})*{}", self.writer.signed(0.1, 0.3), self.writer.bounded(&names), rate(self, pivot))
            }
        };
        let mut allowed: Vec<usize> = self.order[m..].iter().chain(&self.order[..i]).copied().collect();
        allowed.truncate(2);
        for j in allowed {
            let (c, of) = (self.writer.signed(0.1, 0.3), rate(self, j));
            text += &format!("{c}*{}*{of}", self.writer.bounded(&names));
        }
        let speed = |builder: &mut Self| builder.writer.random.one_of(&builder.v).clone();
        let (v, w) = (speed(self), speed(self));
        let c = self.writer.signed(0.2, 0.8);
        text += &match self.writer.random.below(4) {
            0 => format!("{c}*{}", self.writer.bounded(&names)),
            1 => format!("{c}*{v}*{w}*{}", self.writer.bounded(&names)),
            2 => format!("{c}*{v}/sqrt(1.20 + powi({w}, 2))"),
            _ => format!("{c}*{v}{c}*{}", self.writer.bounded(&names)),
        };
        text
    }

    /// Independent rows of one kind or two, and combinations of them that are marked as such.
    fn redundant(&mut self) -> String {
        let (n, names) = (self.n, self.names.clone());
        let m = 1 + self.writer.random.below((n - 1).min(3));
        let kind = *self.writer.random.one_of(&[Position, Velocity, Velocity, Nonlinear, Acceleration]);
        let equations = self.equations(&vec![kind; m]);
        let mut text: String = (0..m).map(|i| row(&format!("row{}", i + 1), &equations[i])).collect();
        for copy in 0..1 + self.writer.random.below(2) {
            let (a, b) = (self.writer.random.below(m), self.writer.random.below(m));
            // f alone must keep its gradient a combination off the manifold too
            let factor = match kind {
                Position => self.writer.decimal(0.5, 1.5),
                _ => self.writer.positive(&names),
            };
            let mut combination = format!("{factor}*({})", equations[a]);
            if a != b {
                combination += &format!("{}*({})", self.writer.signed(0.3, 1.2), equations[b]);
            }
            text += &format!("#[constraint(again{}: {combination} == 0, redundant)]\n", copy + 1);
        }
        text + &if matches!(kind, Position | Velocity) { self.independent(m) } else { String::new() }
    }

    /// Some coordinates as functions of the others, and a row of a higher kind on the speeds of what is left.
    fn configured(&mut self) -> String {
        let configuration = self.configuration_by_names(false);
        let given = configuration.lines().next().map_or(0, |line| line.matches(" = ").count());
        // the pivots that the configuration has taken
        let m = given + 1;
        let equation = match self.writer.random.once_in(2) {
            true => self.nonlinear(given, m),
            false => self.acceleration(given, m),
        };
        configuration + &row("bound", &equation)
    }
}
