//! Whether an expression is a number times powers of others.
//!
//! The exponents are found in double precision, by the logarithms at sampled points, and then decided modulo a prime: the quotient
//! of e and w₁^k₁ w₂^k₂ … is a number if its residue is the same at all points.

use super::identity::POINTS;
use super::modular::{Element, Field};
use super::samples::{SAMPLES, Samples};
use super::{Expr, Graph};

/// A logarithm that deviates by more than this from what the exponents give is another function.
const FITS: f64 = 1e-5;
/// A quantity is a product of those before it where this part of its logarithms is left beside theirs.
const DEPENDS: f64 = 1e-4;
/// No more quantities are combined than the points can tell apart.
const COMBINED: usize = SAMPLES / 2;

/// Quantities whose powers are looked for.
#[derive(Debug, Default)]
pub struct Powers {
    quantities: Vec<Expr>,
    samples: Samples,
}

impl Powers {
    /// Powers of these quantities.
    pub fn of(graph: &Graph, quantities: &[Expr]) -> Self {
        let mut powers = Powers::default();
        for e in quantities {
            if !powers.quantities.contains(e) && graph.as_number(*e).is_none() {
                powers.quantities.push(*e);
            }
        }
        powers
    }

    /// The quantities with their exponents, zeros left out, where the expression is a number times these powers.
    pub fn find(&mut self, graph: &Graph, e: Expr) -> Option<Vec<(Expr, i32)>> {
        if self.quantities.contains(&e) {
            return Some(vec![(e, 1)]);
        }
        let exponents = self.exponents(graph, e)?;
        let found: Vec<(Expr, i32)> = exponents.into_iter().map(|(at, k)| (self.quantities[at], k)).collect();
        is_number(graph, e, &found).then_some(found)
    }

    /// Whole numbers that fit the logarithms at the sampled points: of one quantity, or of the first ones together.
    fn exponents(&mut self, graph: &Graph, e: Expr) -> Option<Vec<(usize, i32)>> {
        let own = graph.near_zero(e, &mut self.samples);
        let points: Vec<usize> = (0..SAMPLES).filter(|k| own[*k].is_some()).collect();
        let all: Vec<_> = self.quantities.iter().map(|w| graph.near_zero(*w, &mut self.samples)).collect();
        // What has no value at many of the points does not take part.
        let there = |at: &usize| 2 * points.iter().filter(|k| all[*at][**k].is_some()).count() > points.len();
        let mut present: Vec<usize> = (0..all.len()).filter(there).collect();
        for at in &present {
            if let Some(found) = fitted(&own, &[(*at, &all[*at])]) {
                return Some(found);
            }
        }
        present.truncate(COMBINED);
        let columns: Vec<(usize, &Sampled)> = present.into_iter().map(|at| (at, &all[at])).collect();
        fitted(&own, &columns)
    }
}

/// Whether the expression over these powers is the same at all points.
fn is_number(graph: &Graph, e: Expr, powers: &[(Expr, i32)]) -> bool {
    let mut seen: Vec<(Field, Element)> = Vec::new();
    (0..POINTS).all(|point| {
        let quotient = || {
            let (field, mut value) = graph.residue(e, point)?;
            for (w, k) in powers {
                let power = field.pow(graph.residue(*w, point)?.1, u64::from(k.unsigned_abs()));
                value = field.mul(value, if *k > 0 { field.recip(power)? } else { power });
            }
            Some((field, value))
        };
        let Some((field, value)) = quotient() else { return false };
        match seen.iter().find(|(known, _)| *known == field) {
            Some((_, known)) => *known == value,
            None => {
                seen.push((field, value));
                true
            }
        }
    })
}

type Sampled = [Option<f64>; SAMPLES];

/// Exponents of the columns that make the right side, up to a number.
fn fitted(right: &Sampled, columns: &[(usize, &Sampled)]) -> Option<Vec<(usize, i32)>> {
    let known = |k: &usize| right[*k].is_some() && columns.iter().all(|(_, values)| values[*k].is_some());
    let points: Vec<usize> = (0..SAMPLES).filter(known).collect();
    // More points than unknowns, or anything fits.
    if points.len() < 4 + columns.len().min(8) {
        return None;
    }
    // The mean is taken off: it is the number's logarithm.
    let centred = |values: &Sampled| {
        let logarithms: Vec<f64> = points.iter().map(|k| values[*k].map_or(0.0, |x| x.abs().ln())).collect();
        let mean = logarithms.iter().sum::<f64>() / points.len() as f64;
        logarithms.iter().map(|x| x - mean).collect::<Vec<f64>>()
    };
    let right = centred(right);
    let centred: Vec<Vec<f64>> = columns.iter().map(|(_, values)| centred(values)).collect();
    let whole: Vec<i32> = least_squares(&centred, &right).iter().map(|k| k.round() as i32).collect();
    // Digits may be lost at some of the points, and with them the mean: two points at a time.
    let rest = |at: usize| {
        right[at] - centred.iter().zip(&whole).map(|(column, k)| column[at] * f64::from(*k)).sum::<f64>()
    };
    let mut rests: Vec<f64> = (0..right.len()).map(rest).collect();
    rests.sort_by(f64::total_cmp);
    let fits = rests[3 * rests.len() / 4] - rests[rests.len() / 4] < FITS;
    let found = columns.iter().zip(whole).map(|((at, _), k)| (*at, k)).filter(|(_, k)| *k != 0);
    let found: Vec<(usize, i32)> = found.collect();
    (fits && found.iter().all(|(_, k)| k.abs() < 9)).then_some(found)
}

/// Factors that approximate the right side best; zero for columns that depend on those before them.
fn least_squares(columns: &[Vec<f64>], right: &[f64]) -> Vec<f64> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    // Each kept column at right angles to the kept ones before it, and what was taken off it.
    let mut basis: Vec<(usize, Vec<f64>, Vec<f64>)> = Vec::new();
    for (at, column) in columns.iter().enumerate() {
        let mut rest = column.clone();
        let mut taken = vec![0.0; basis.len()];
        for _ in 0..2 {
            for ((_, direction, _), taken) in basis.iter().zip(&mut taken) {
                let part = dot(&rest, direction) / dot(direction, direction);
                *taken += part;
                rest.iter_mut().zip(direction).for_each(|(x, d)| *x -= part * d);
            }
        }
        if dot(&rest, &rest) > DEPENDS * DEPENDS * dot(column, column) && basis.len() + 2 < right.len() {
            basis.push((at, rest, taken));
        }
    }
    let mut factors = vec![0.0; columns.len()];
    let mut along: Vec<f64> = basis.iter().map(|(_, d, _)| dot(right, d) / dot(d, d)).collect();
    for i in (0..basis.len()).rev() {
        let (at, _, taken) = &basis[i];
        factors[*at] = along[i];
        for (j, part) in taken.iter().enumerate() {
            along[j] -= part * along[i];
        }
    }
    factors
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbolic::Kind;

    #[test]
    fn powers_are_found_and_nothing_else() {
        let mut g = Graph::new();
        let [m, l] = ["m", "l"].map(|name| g.symbol(name, Kind::Parameter));
        let q = g.symbol("q", Kind::Coordinate);
        let [m, l, q] = [m, l, q].map(|s| g.var(s));
        let (sin, cos) = (g.sin(q), g.cos(q));
        // a = m + m l² cos² q, b = cos q
        let (l2, cos2, sin2) = (g.powi(l, 2), g.powi(cos, 2), g.powi(sin, 2));
        let inner = g.mul(l2, cos2);
        let one = g.one();
        let inner = g.add(one, inner);
        let a = g.mul(m, inner);
        let mut powers = Powers::of(&g, &[a, cos, m]);
        // m (1 + l² - l² sin² q)² / cos q, written out otherwise
        let other = g.mul(l2, sin2);
        let other = g.sub(l2, other);
        let other = g.add(one, other);
        let square = g.powi(other, 2);
        let thrice = g.number(super::super::Rational::Small(3, 1));
        let e = [square, m, thrice].into_iter().reduce(|a, b| g.mul(a, b)).expect("three factors");
        let e = g.div(e, cos);
        assert_eq!(powers.find(&g, e), Some(vec![(a, 2), (cos, -1), (m, -1)]));
        assert_eq!(powers.find(&g, cos), Some(vec![(cos, 1)]));
        // A further parameter, another sum, another function: none of them is made of these.
        let scaled = g.mul(cos, l);
        let near = g.add(e, one);
        for e in [scaled, near, sin] {
            assert_eq!(powers.find(&g, e), None);
        }
    }

    #[test]
    fn a_quantity_that_is_made_of_others_does_not_disturb() {
        let mut g = Graph::new();
        let q = ["p", "q"].map(|name| g.symbol(name, Kind::Coordinate)).map(|s| g.var(s));
        let square = g.powi(q[0], 2);
        let mut powers = Powers::of(&g, &[q[0], square, q[1]]);
        let e = [square, q[0], q[1]].into_iter().reduce(|a, b| g.mul(a, b)).expect("three factors");
        assert_eq!(powers.find(&g, e), Some(vec![(q[0], 3), (q[1], 1)]));
    }
}
