//! Rows with several good choices of independent speeds.

use super::constraints::row;
use super::generate::Builder;

impl Builder {
    /// Rows that each bind a pair of speeds, of which either may be independent; a chart for each of some choices.
    pub fn charts(&mut self) -> String {
        let n = self.n;
        let m = 1 + self.writer.random.below(n / 2);
        let positions = self.writer.random.below(m + 1);
        let (x, v, names) = (self.x.clone(), self.v.clone(), self.names.clone());
        let mut text = String::new();
        for i in 0..m {
            let pair = [self.order[i], self.order[m + i]];
            let others: Vec<usize> = self.order[2 * m..].iter().copied().take(2).collect();
            let [c, d] = [self.writer.decimal(1.1, 1.6), self.writer.signed(0.8, 1.1)];
            let equation = if i < positions {
                let others: Vec<String> = others.iter().map(|&j| x[j].clone()).collect();
                let driven = if self.rheonomic { " + 0.30*sin(t)" } else { "" };
                let rest = format!("0.20*{}", self.writer.smooth(&others));
                let [a, b] = pair.map(|j| x[j].clone());
                format!("{c}*{a} + 0.10*sin({a}){d}*{b} + 0.10*cos({b}) + {rest}{driven}")
            } else {
                let [a, b] = pair.map(|j| v[j].clone());
                let weight = self.writer.bounded(&names);
                let mut equation = format!("({c} + 0.20*{weight})*{a}{d}*{b}");
                for &j in &others {
                    equation += &format!("{}*{}*{}", self.writer.signed(0.1, 0.3), self.writer.bounded(&names), v[j]);
                }
                equation + &format!("{}*{}", self.writer.signed(0.1, 0.5), self.writer.bounded(&names))
            };
            text += &row(&format!("row{}", i + 1), &equation);
        }
        let first: Vec<usize> = self.order[m..].to_vec();
        let mut choices = vec![first.clone()];
        let exchanged = |count: usize| -> Vec<usize> {
            first.iter().enumerate().map(|(i, &j)| if i < count { self.order[i] } else { j }).collect()
        };
        choices.push(exchanged(1));
        if m > 1 {
            choices.push(exchanged(m));
        }
        for choice in choices {
            let speeds: Vec<String> = choice.iter().map(|&j| v[j].clone()).collect();
            text += &format!("#[independent({})]\n", speeds.join(", "));
        }
        text
    }
}
