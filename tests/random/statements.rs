//! Random kinematics, inertia, forces: the statements that every model has.

use super::expression::Writer;

/// Which way the kinematics are declared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// v = dot(x) without names of their own.
    Rates,
    /// dot(x) = A v + a0 (2.1).
    FromSpeeds,
    /// v = B dot(x) + b0 (2.2).
    FromRates,
    /// Both, each the inverse of the other.
    Both,
}

impl Writer {
    /// The statement for the kinematics, in coordinates `x1..` and speeds `v1..`.
    pub fn kinematics(&mut self, direction: Direction, x: &[String], names: &[String], biased: bool) -> String {
        let n = x.len();
        let rate = |j: usize| format!("dot({})", x[j]);
        let speed = |j: usize| format!("v{}", j + 1);
        let mut lines = Vec::new();
        match direction {
            Direction::Rates => return String::new(),
            Direction::Both => {
                // lower triangular with unit diagonal: the inverse is written by substitution
                let mut solved: Vec<String> = Vec::new();
                for i in 0..n {
                    let below = (i > 0).then(|| (self.random.below(i.max(1)), self.bounded(names)));
                    let (to, from) = match &below {
                        Some((j, c)) => (format!(" + {c}*{}", rate(*j)), format!(" - {c}*({})", solved[*j])),
                        None => (String::new(), String::new()),
                    };
                    lines.push(format!("{} = {}{to}", speed(i), rate(i)));
                    solved.push(format!("{}{from}", speed(i)));
                }
                lines.extend(solved.iter().enumerate().map(|(i, e)| format!("{} = {e}", rate(i))));
            }
            Direction::FromSpeeds | Direction::FromRates => {
                let forward = direction == Direction::FromSpeeds;
                for i in 0..n {
                    let of = |j: usize| if forward { speed(j) } else { rate(j) };
                    let mut e = match self.random.below(3) {
                        0 => of(i),
                        _ => format!("{}*{}", self.positive(names), of(i)),
                    };
                    if n > 1 && !self.random.once_in(3) {
                        let j = (i + 1 + self.random.below(n - 1)) % n;
                        e += &format!("{}*{}*{}", self.signed(0.1, 0.4), self.bounded(names), of(j));
                    }
                    if biased {
                        e += &format!("{}*{}", self.signed(0.1, 0.6), self.bounded(names));
                    }
                    lines.push(format!("{} = {e}", if forward { rate(i) } else { speed(i) }));
                }
            }
        }
        format!("#[kinematics(\n    {},\n)]\n", lines.join(",\n    "))
    }

    /// The statement for M: diagonal, or L Lᵀ with its factors inline or under names of their own.
    ///
    /// With speeds, T = vᵀ M v / 2 + bᵀ v + T0 is stated instead, its first part as a sum of squares.
    pub fn inertia(
        &mut self,
        n: usize,
        names: &[String],
        dense: bool,
        named: bool,
        speeds: Option<&Vec<String>>,
    ) -> String {
        if !dense {
            let masses: Vec<String> = (0..n).map(|_| self.positive(names)).collect();
            if let Some(speeds) = speeds {
                let terms = masses.iter().zip(speeds).map(|(m, v)| format!("{m}*powi({v}, 2)/2"));
                let squares = terms.collect::<Vec<_>>().join(" + ");
                return format!("#[kinetic_energy({squares}{})]\n", self.lower_terms(names, speeds));
            }
            return format!("#[inertia(diag({}))]\n", masses.join(", "));
        }
        let mut definitions = Vec::new();
        // the columns of each row of L, empty where L has a zero
        let mut factor: Vec<Vec<String>> = Vec::new();
        for i in 0..n {
            let mut row = Vec::new();
            for j in 0..=i {
                let e = match (i == j, self.random.below(3)) {
                    (true, _) => self.positive(names),
                    (false, 0) => String::new(),
                    (false, _) => format!("{}*{}", self.decimal(0.1, 0.4), self.bounded(names)),
                };
                let name = format!("l{}{}", i + 1, j + 1);
                row.push(match (e.is_empty(), named) {
                    (true, _) => String::new(),
                    (false, true) => name.clone(),
                    (false, false) => format!("({e})"),
                });
                if !e.is_empty() {
                    definitions.push(format!("{name} = {e}"));
                }
            }
            factor.push(row);
        }
        let definitions = if named { format!("#[define({})]\n", definitions.join(", ")) } else { String::new() };
        if let Some(speeds) = speeds {
            let square = |k: usize| {
                let terms = (k..n).filter(|&i| !factor[i][k].is_empty());
                let terms: Vec<String> = terms.map(|i| format!("{}*{}", factor[i][k], speeds[i])).collect();
                format!("powi({}, 2)/2", terms.join(" + "))
            };
            let squares: Vec<String> = (0..n).map(square).collect();
            let rest = self.lower_terms(names, speeds);
            return format!("{definitions}#[kinetic_energy({}{rest})]\n", squares.join(" + "));
        }
        let entry = |i: usize, j: usize| {
            let terms = (0..=i.min(j)).filter(|&k| !factor[i][k].is_empty() && !factor[j][k].is_empty());
            let terms: Vec<String> = terms.map(|k| format!("{}*{}", factor[i][k], factor[j][k])).collect();
            if terms.is_empty() { "0".to_string() } else { terms.join(" + ") }
        };
        let row = |i: usize| {
            let entries: Vec<String> = (0..n).map(|j| if j < i { "_".to_string() } else { entry(i, j) }).collect();
            format!("    [{}],\n", entries.join(", "))
        };
        let rows: String = (0..n).map(row).collect();
        format!("{definitions}#[inertia(matrix(\n{rows}))]\n")
    }

    /// bᵀ v and T0, each or none.
    fn lower_terms(&mut self, names: &[String], speeds: &[String]) -> String {
        let mut terms = String::new();
        for speed in speeds {
            if self.random.once_in(3) {
                terms += &format!("{}*{}*{speed}", self.signed(0.2, 0.7), self.bounded(names));
            }
        }
        if self.random.once_in(2) {
            terms += &format!("{}*{}", self.signed(0.2, 0.7), self.bounded(names));
        }
        terms
    }

    /// The statement for h*.
    pub fn forces(&mut self, n: usize, names: &[String], speeds: &[String], inputs: &[String]) -> String {
        let forces: Vec<String> = (0..n)
            .map(|_| if self.random.once_in(8) { "0".to_string() } else { self.force(names, speeds, inputs) })
            .collect();
        format!("#[forces(\n    {},\n)]\n", forces.join(",\n    "))
    }
}
