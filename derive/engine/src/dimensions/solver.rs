//! Equations between dimensions: linear ones over the rationals, each solved as it comes (Kennedy, Relational parametricity and
//! units of measure, 1997; over the rationals unification is elimination).

use super::dimension::Dimension;
use std::collections::BTreeSet;

/// What is known of one unknown.
#[derive(Debug)]
struct Unknown {
    /// What it is, over unknowns that are still free.
    value: Option<Dimension>,
    /// Whether it is no more than a power of ten: that of a unit of which the rest is known.
    scale: bool,
    /// The unknowns whose values it stands in.
    stands_in: BTreeSet<usize>,
    /// The statement from which its value follows.
    origin: String,
}

/// The unknowns and what they are.
#[derive(Debug, Default)]
pub struct Solver {
    unknowns: Vec<Unknown>,
}

impl Solver {
    /// A dimension of which nothing is known.
    pub fn fresh(&mut self) -> Dimension {
        self.enter(false)
    }

    /// A power of ten of which nothing is known.
    pub fn fresh_scale(&mut self) -> Dimension {
        self.enter(true)
    }

    fn enter(&mut self, scale: bool) -> Dimension {
        self.unknowns.push(Unknown { value: None, scale, stands_in: BTreeSet::new(), origin: String::new() });
        Dimension::unknown(self.unknowns.len() - 1)
    }

    /// A dimension over unknowns that are free.
    pub fn resolved(&self, dimension: &Dimension) -> Dimension {
        let mut resolved = dimension.without_unknowns();
        for (unknown, power) in dimension.unknowns() {
            resolved = match &self.unknowns[unknown].value {
                Some(value) => resolved.times(&value.power(power)),
                None => resolved.times(&Dimension::unknown(unknown).power(power)),
            };
        }
        resolved
    }

    /// Whether nothing but powers of ten is missing of a dimension.
    pub fn is_known(&self, dimension: &Dimension) -> bool {
        dimension.unknowns().all(|(unknown, _)| self.unknowns[unknown].scale)
    }

    /// The statement that told a single unknown.
    pub fn origin(&self, dimension: &Dimension) -> Option<&str> {
        let (unknown, _) = dimension.unknowns().next()?;
        let unknown = &self.unknowns[unknown];
        unknown.value.as_ref().map(|_| unknown.origin.as_str())
    }

    /// Makes two dimensions equal; whether they can be. If they cannot, nothing is added.
    pub fn equate(&mut self, left: &Dimension, right: &Dimension, origin: &str) -> bool {
        let difference = self.resolved(&left.over(right));
        if difference.is_pure() {
            return true;
        }
        let free = |scale: bool| {
            let mut unknowns = difference.unknowns().rev();
            unknowns.find(|(unknown, _)| self.unknowns[*unknown].scale == scale)
        };
        // The newest is told, so that what all share stays longest.
        let Some((unknown, power)) = free(false).or_else(|| free(true).filter(|_| difference.is_scale())) else {
            return false;
        };
        let Some(inverse) = power.neg().recip() else { return false };
        // u^p · rest = 1
        let rest = difference.over(&Dimension::unknown(unknown).power(power));
        let value = rest.power(&inverse);
        self.bind(unknown, value, origin);
        true
    }

    fn bind(&mut self, unknown: usize, value: Dimension, origin: &str) {
        let mut affected = std::mem::take(&mut self.unknowns[unknown].stands_in);
        affected.retain(|other| {
            let held = self.unknowns[*other].value.as_ref();
            held.is_some_and(|held| held.unknowns().any(|(inside, _)| inside == unknown))
        });
        self.unknowns[unknown].value = Some(value.clone());
        self.unknowns[unknown].origin = origin.to_owned();
        for other in &affected {
            let held = self.unknowns[*other].value.take().map(|held| self.resolved(&held));
            self.unknowns[*other].value = held;
        }
        affected.insert(unknown);
        for (inside, _) in value.unknowns() {
            self.unknowns[inside].stands_in.extend(affected.iter().copied());
        }
    }
}
