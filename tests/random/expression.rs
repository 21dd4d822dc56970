//! Random expressions as text.

use crate::support::splitmix::SplitMix;

/// Writes expressions in the names that it is given.
pub struct Writer {
    /// Where the choices come from.
    pub random: SplitMix,
    /// Parameters; their values lie between 0.5 and 1.5.
    pub parameters: Vec<String>,
}

impl Writer {
    /// A decimal between the two bounds, as Rust spells it.
    pub fn decimal(&mut self, low: f64, high: f64) -> String {
        format!("{:.2}", self.random.between(low, high))
    }

    /// " + c" or " - c" with c between the bounds, to be put behind something.
    pub fn signed(&mut self, low: f64, high: f64) -> String {
        let sign = if self.random.once_in(2) { "+" } else { "-" };
        format!(" {sign} {}", self.decimal(low, high))
    }

    /// A sum of one or two names with coefficients, and sometimes a constant.
    fn linear(&mut self, names: &[String]) -> String {
        let mut text = format!("{}*{}", self.decimal(0.4, 1.2), self.name(names));
        if self.random.once_in(2) {
            text += &format!("{}*{}", self.signed(0.2, 0.9), self.name(names));
        }
        if self.random.once_in(3) {
            text += &self.signed(0.1, 1.5);
        }
        text
    }

    fn name(&mut self, names: &[String]) -> String {
        self.random.one_of(names).clone()
    }

    /// An expression that stays between -1 and 1, smooth beside where it changes its case.
    pub fn bounded(&mut self, names: &[String]) -> String {
        if names.is_empty() || !self.random.once_in(8) {
            return self.smooth(names);
        }
        let (a, c) = (self.name(names), self.decimal(-0.6, 0.6));
        let sign = ["<", "<=", ">", ">="][self.random.below(4)];
        format!("(if {a} {sign} {c} {{ {} }} else {{ {} }})", self.smooth(names), self.smooth(names))
    }

    /// A smooth expression that stays between -1 and 1; 0.5 where there is nothing to depend on.
    pub fn smooth(&mut self, names: &[String]) -> String {
        if names.is_empty() {
            return "0.5".to_string();
        }
        let (a, b) = (self.name(names), self.name(names));
        let c = self.decimal(0.3, 1.0);
        match self.random.below(16) {
            0 | 1 => format!("sin({})", self.linear(names)),
            2 | 3 => format!("cos({})", self.linear(names)),
            4 => format!("sin({})*cos({})", self.linear(names), self.linear(names)),
            5 => format!("{a}/(1 + powi({a}, 2))"),
            6 => format!("exp(-powi({a}, 2)/2)"),
            7 => format!("1/sqrt(1.50 + powi({a}, 2))"),
            8 => format!("atan2({a}, 2 + cos({b}))/2"),
            9 => format!("tan({c}*sin({a}))/2"),
            10 => format!("ln(1.60 + {c}*cos({a}))"),
            11 => format!("{c}*sin({a})/(1.50 + cos({b}))"),
            12 => format!("powi(cos({}), 3)", self.linear(names)),
            13 => format!("wave({})", self.linear(names)),
            14 => format!("bump({})", self.linear(names)),
            _ => {
                let p = self.random.one_of(&self.parameters).clone();
                format!("sin({p}*{a}{})", self.signed(0.1, 1.0))
            }
        }
    }

    /// An expression between 0.6 and 1.8.
    pub fn positive(&mut self, names: &[String]) -> String {
        let base = self.decimal(1.0, 1.4);
        if self.random.once_in(3) {
            return base;
        }
        format!("({base}{}*{})", self.signed(0.1, 0.35), self.bounded(names))
    }

    /// A force: some terms in positions, speeds and parameters, in all the functions that there are.
    pub fn force(&mut self, names: &[String], speeds: &[String], inputs: &[String]) -> String {
        let mut terms = Vec::new();
        for _ in 0..1 + self.random.below(4) {
            let c = self.decimal(0.3, 2.0);
            let (v, w, x) = (self.name(speeds), self.name(speeds), self.name(names));
            let p = self.random.one_of(&self.parameters).clone();
            terms.push(match self.random.below(10) {
                0 => format!("{c}*{v}"),
                1 => format!("{p}*{v}*{w}*{}", self.bounded(names)),
                2 => format!("{c}*powi({v}, 2)"),
                3 => format!("{c}*{}", self.bounded(names)),
                4 => format!("{p}*exp(0.20*{x})"),
                5 => format!("{v}*sqrt(2 + powi({w}, 2))"),
                6 => format!("{c}*{v}/(1 + powi({x}, 2))"),
                7 => format!("{p}*{x}"),
                8 => format!("{v}*{w}/{}", self.positive(names)),
                _ => format!("{}*{c}", inputs.first().unwrap_or(&p)),
            });
        }
        terms.join(if self.random.once_in(2) { " - " } else { " + " })
    }
}
