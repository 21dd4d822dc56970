//! Random constraints whose derivatives can be written down beside them.

use super::expression::Writer;

/// f and ḟ as text.
pub struct Closure {
    /// f(x, t).
    pub f: String,
    /// ḟ in dot(x).
    pub rate: String,
}

impl Writer {
    /// A position row with a dominant pivot: c x_p plus smaller terms in the other names, and in t if asked for.
    ///
    /// A varying row has no constant among its derivatives.
    pub fn closure(&mut self, pivot: &str, others: &[String], rheonomic: bool, varying: bool) -> Closure {
        let c = self.decimal(1.2, 2.0);
        let (mut f, mut rate) = (format!("{c}*{pivot}"), format!("{c}*dot({pivot})"));
        let add = |text: &mut String, term: String| *text += &format!(" + {term}");
        if varying || self.random.once_in(2) {
            // the pivot depends on the coordinate
            let b = self.decimal(0.1, 0.3);
            add(&mut f, format!("{b}*sin({pivot})"));
            add(&mut rate, format!("{b}*cos({pivot})*dot({pivot})"));
        }
        for x in others.iter().take(3) {
            let b = self.decimal(0.1, 0.4);
            let y = self.random.one_of(others).clone();
            let (term, its_rate) = match self.random.below(5).max(usize::from(varying)) {
                0 => (format!("{b}*{x}"), format!("{b}*dot({x})")),
                1 => (format!("{b}*sin({x})"), format!("{b}*cos({x})*dot({x})")),
                2 => (format!("{b}*powi({x}, 2)/2"), format!("{b}*{x}*dot({x})")),
                3 => (format!("{b}*{x}*{y}"), format!("{b}*(dot({x})*{y} + {x}*dot({y}))")),
                _ => (format!("exp({b}*{x})/2"), format!("{b}*exp({b}*{x})*dot({x})/2")),
            };
            add(&mut f, term);
            add(&mut rate, its_rate);
        }
        if rheonomic {
            let w = self.decimal(0.4, 1.5);
            add(&mut f, format!("0.30*sin({w}*t)"));
            add(&mut rate, format!("0.30*{w}*cos({w}*t)"));
        }
        f += &self.signed(0.1, 0.8);
        Closure { f, rate }
    }

    /// A velocity row: dominant in the speed of the pivot, small in the others, and with a part without speeds if asked for.
    ///
    /// A varying row has no constant factor.
    pub fn rolling(&mut self, pivot: &str, others: &[String], names: &[String], driven: bool, varying: bool) -> String {
        let mut text = match self.random.below(3).max(2 * usize::from(varying)) {
            0 => pivot.to_string(),
            1 => format!("{}*{pivot}", self.decimal(1.0, 2.0)),
            _ => format!("(1.50{}*{})*{pivot}", self.signed(0.1, 0.3), self.bounded(names)),
        };
        for v in others.iter().take(3) {
            text += &format!("{}*{}*{v}", self.signed(0.1, 0.35), self.bounded(names));
        }
        if driven {
            text += &format!("{}*{}", self.signed(0.2, 0.6), self.bounded(names));
        }
        text
    }
}
