//! The constraint system of a random model, by kind.

use super::generate::Builder;

/// A statement of one constraint.
pub(super) fn row(name: &str, equation: &str) -> String {
    format!("#[constraint({name}: {equation} == 0)]\n")
}

impl Builder {
    /// All statements about constraints.
    pub fn constraints(&mut self) -> String {
        let n = self.n;
        let some = |builder: &mut Self| 1 + builder.writer.random.below(n.saturating_sub(1).max(1));
        match self.kind {
            0 => String::new(),
            1 => {
                let m = some(self);
                self.mixture(m, 0)
            }
            2 => {
                let m = some(self);
                self.mixture(m, m)
            }
            3 => {
                let m = some(self).max(2.min(n));
                self.mixture(m, m / 2)
            }
            4 => self.merged(),
            5 => self.merged_jointly(),
            6 => self.configuration_by_names(false),
            7 => self.configuration_of(),
            8 => self.configuration_by_names(true),
            9 => self.complement(),
            10 => {
                let positions = self.writer.random.below(n);
                self.mixture(n - 1, positions.min(n - 1))
            }
            11 => {
                let positions = self.writer.random.below(n + 1);
                self.mixture(n, positions)
            }
            _ => self.higher_kinds(),
        }
    }

    /// m rows, the first ones position rows; pivots in the order of the builder.
    fn mixture(&mut self, m: usize, positions: usize) -> String {
        let mut text = String::new();
        for i in 0..m {
            let name = format!("row{}", i + 1);
            text += &if i < positions { row(&name, &self.position(i, m).f) } else { row(&name, &self.velocity(i, m)) };
        }
        text + &self.independent(m)
    }

    /// A position row on the i-th pivot; the other names come from the coordinates that are no pivots, if there are any.
    pub(super) fn position(&mut self, i: usize, m: usize) -> super::rows::Closure {
        let (pivot, others) = (self.x[self.order[i]].clone(), self.beside(i, m, &self.x.clone()));
        self.writer.closure(&pivot, &others, self.rheonomic, self.varying)
    }

    pub(super) fn velocity(&mut self, i: usize, m: usize) -> String {
        let (pivot, others) = (self.v[self.order[i]].clone(), self.beside(i, m, &self.v.clone()));
        let driven = self.writer.random.once_in(3);
        let names = self.names.clone();
        self.writer.rolling(&pivot, &others, &names, driven, self.varying)
    }

    /// Names that may stand beside the i-th pivot: all that are no pivots, and the pivots before it.
    pub(super) fn beside(&mut self, i: usize, m: usize, names: &[String]) -> Vec<String> {
        let mut allowed: Vec<usize> = self.order[m..].iter().chain(&self.order[..i]).copied().collect();
        allowed.truncate(1 + self.writer.random.below(4));
        allowed.iter().map(|&j| names[j].clone()).collect()
    }

    /// The independent speeds in some order, plain or combined, perhaps in two charts, or nothing: then the engine chooses.
    pub(super) fn independent(&mut self, m: usize) -> String {
        if m == self.n || self.writer.random.once_in(2) {
            return String::new();
        }
        self.classes.push("independent speeds named".to_string());
        let speeds: Vec<String> = self.order[m..].iter().rev().map(|&j| self.v[j].clone()).collect();
        let (bound, names) =
            (self.order[..m].iter().map(|&j| self.v[j].clone()).collect::<Vec<_>>(), self.names.clone());
        let plain = speeds.join(", ");
        let combined = self.writer.random.once_in(2).then(|| self.combined(&speeds, &bound, &names));
        // a combination of one speed alone would be no other choice
        let alone = |list: &String| (1..=speeds.len()).fold(list.clone(), |l, i| l.replace(&format!("s{i} = "), ""));
        let several = self.writer.random.once_in(3) && combined.as_ref().is_none_or(|list| alone(list) != plain);
        let lists = match (combined, several) {
            (None, _) => vec![plain],
            (Some(combined), false) => vec![combined],
            (Some(combined), true) if self.writer.random.once_in(2) => vec![combined, plain],
            (Some(combined), true) => vec![plain, combined],
        };
        lists.iter().map(|list| format!("#[independent({list})]\n")).collect()
    }

    /// Combinations, each dominant in one of the speeds, with some of the bound ones and of those before it.
    pub(super) fn combined(&mut self, speeds: &[String], bound: &[String], names: &[String]) -> String {
        let mut list = Vec::new();
        for (i, speed) in speeds.iter().enumerate() {
            if i > 0 && self.writer.random.once_in(3) {
                list.push(speed.clone());
                continue;
            }
            let mut others = [&speeds[..i], bound].concat();
            others.truncate(1 + self.writer.random.below(2));
            // never the speed alone, which would be no other chart
            let driven = others.is_empty() || self.writer.random.once_in(3);
            list.push(format!("s{} = {}", i + 1, self.writer.rolling(speed, &others, names, driven, false)));
        }
        list.join(", ")
    }

    /// A position row and its own derivative as a velocity row, plain or scaled, and perhaps another row.
    fn merged(&mut self) -> String {
        let m = if self.n > 2 { 2 } else { 1 };
        let closure = self.position(0, m);
        let rate = match self.writer.random.once_in(2) {
            true => closure.rate,
            false => {
                let names = self.names.clone();
                format!("{}*({})", self.writer.positive(&names), closure.rate)
            }
        };
        let mut text = row("height", &closure.f) + &row("height_rate", &rate);
        if m == 2 {
            text += &row("further", &self.velocity(1, m));
        }
        text + &self.independent(m)
    }

    /// A position row whose derivative is a combination of two velocity rows, neither of which is it.
    fn merged_jointly(&mut self) -> String {
        let closure = self.position(0, 2);
        let first = self.velocity(1, 2);
        let names = self.names.clone();
        let weight = format!("0.50*{}", self.writer.bounded(&names));
        let second = format!("{} - {weight}*({first})", closure.rate);
        row("height", &closure.f) + &row("first", &first) + &row("second", &second) + &self.independent(2)
    }

    /// Some coordinates as functions of the others and of time; each may also be declared as a row, for its reaction.
    pub(super) fn configuration_by_names(&mut self, then_rows: bool) -> String {
        let given = 1 + self.writer.random.below((self.n - 1).min(2));
        let free: Vec<String> = self.order[given..].iter().map(|&j| self.x[j].clone()).collect();
        let mut names = free.clone();
        if self.rheonomic {
            names.push("t".to_string());
        }
        let (mut map, mut rows) = (Vec::new(), String::new());
        // all reactions of the configuration or none: some of them alone could not be told from the rest
        let reactions = self.writer.random.once_in(2);
        for i in 0..given {
            let x = self.x[self.order[i]].clone();
            let g = format!("{}*{}", self.writer.decimal(0.5, 1.5), self.writer.bounded(&names));
            if reactions {
                rows += &row(&format!("held_{x}"), &format!("{x} - ({g})"));
            }
            map.push(format!("{x} = {g}"));
        }
        self.classes.push(format!("reactions of the configuration: {}", if reactions { "all" } else { "none" }));
        if then_rows && free.len() > 1 {
            // a row on the rates of the free coordinates
            self.classes.push("rows on top of a configuration".to_string());
            let rates: Vec<String> = free.iter().map(|x| format!("dot({x})")).collect();
            let driven = self.writer.random.once_in(3);
            let equation = self.writer.rolling(&rates[0], &rates[1..], &free, driven, false);
            rows += &row("rolling", &equation);
            if self.writer.random.once_in(2) {
                let list = match self.writer.random.once_in(2) {
                    true => self.combined(&rates[1..], &rates[..1], &free),
                    false => rates[1..].join(", "),
                };
                rows += &format!("#[independent({list})]\n");
            }
        }
        format!("#[configuration({})]\n{rows}", map.join(", "))
    }

    /// All coordinates as functions of fewer (or as many) further ones.
    fn configuration_of(&mut self) -> String {
        let p = 1 + self.writer.random.below(self.n);
        let q: Vec<String> = (1..=p).map(|i| format!("q{i}")).collect();
        let mut names = q.clone();
        if self.rheonomic {
            names.push("t".to_string());
        }
        let (mut map, mut rows) = (Vec::new(), String::new());
        for (i, &j) in self.order.clone().iter().enumerate() {
            let x = self.x[j].clone();
            if i < p {
                map.push(format!("{x} = 1.25*{}", q[i]));
                continue;
            }
            let g = self.writer.bounded(&names);
            // in x instead of q: q_i = x_i/1.25 vanishes identically on the configuration
            let in_x =
                (0..p).rev().fold(g.clone(), |g, i| g.replace(&q[i], &format!("({}/1.25)", self.x[self.order[i]])));
            rows += &row(&format!("held_{x}"), &format!("{x} - ({in_x})"));
            map.push(format!("{x} = {g}"));
        }
        format!("#[configuration(of({}), {})]\n{rows}", q.join(", "), map.join(", "))
    }

    /// Velocity rows solved for their pivots, and D written down from them, each of its rows scaled.
    fn complement(&mut self) -> String {
        let (n, names) = (self.n, self.names.clone());
        let m = 1 + self.writer.random.below((n - 1).max(1));
        let m = m.min(n - 1);
        let free: Vec<usize> = self.order[m..].to_vec();
        let mut coefficient = vec![vec![String::new(); free.len()]; m];
        let mut rows = String::new();
        for (i, coefficient) in coefficient.iter_mut().enumerate() {
            let mut equation = self.v[self.order[i]].clone();
            for (c, &j) in coefficient.iter_mut().zip(&free) {
                *c = if self.writer.random.once_in(3) {
                    "0".to_string()
                } else {
                    format!("{}*{}", self.writer.decimal(0.2, 0.8), self.writer.bounded(&names))
                };
                equation += &format!(" + {c}*{}", self.v[j]);
            }
            if self.writer.random.once_in(3) {
                equation += &format!(" + 0.40*{}", self.writer.bounded(&names));
            }
            rows += &row(&format!("row{}", i + 1), &equation);
        }
        let mut lines = Vec::new();
        for (a, &j) in free.iter().enumerate() {
            let scale = self.writer.positive(&names);
            let mut entries = vec!["0".to_string(); n];
            entries[j] = scale.clone();
            for (i, coefficient) in coefficient.iter().enumerate() {
                entries[self.order[i]] = format!("-{scale}*({})", coefficient[a]);
            }
            lines.push(format!("    w{} = [{}],\n", a + 1, entries.join(", ")));
        }
        format!("{rows}#[complement(\n{})]\n", lines.concat())
    }
}
