//! Where assemblies start from, and how far apart they are: which coordinates are angles, and how far the others reach.

mod reach;

use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::{PI, TAU};

use crate::assemble::newton::Equations;
use crate::assemble::problem::{Level, Unknown};
use crate::math::double::sqrt;
use crate::{ConstrainedSystem, Error};

/// An equation is the same after a turn if it changes by less than this fraction of its terms.
const SAME: f64 = 1e-11;
/// Points at which equations are compared before and after a turn, the guess among them.
const LOOKS: usize = 3;

/// The unknowns of an assembly.
pub(super) struct Space {
    guess: Vec<f64>,
    /// The fractional parts of the roots of the primes, one for each unknown.
    steps: Vec<f64>,
    ranges: Vec<Range>,
    /// The unknowns of a quaternion each: with all signs changed it is the same attitude.
    quaternions: Vec<Vec<usize>>,
}

/// What is known about an unknown.
#[derive(Copy, Clone)]
struct Range {
    /// All equations are the same after a turn.
    angle: bool,
    /// Some are, as of a wheel that also drives a rack: what another turn changes is seen at the rack.
    turning: bool,
    /// Starts are drawn from as much on both sides of the guess.
    drawn: f64,
    /// What differences are compared with: one, for all that turns.
    reach: f64,
}

impl Space {
    pub(super) fn new<M: ConstrainedSystem>(level: &Level<'_, '_, M>) -> Result<Self, Error> {
        let guess = level.guess();
        let range = |(unknown, value): (&Unknown, &f64)| match unknown {
            Unknown::State(_) => Range { angle: false, turning: false, drawn: PI, reach: 1.0 },
            Unknown::Parameter(_) => {
                let reach = if *value == 0.0 { 1.0 } else { value.abs() };
                Range { angle: false, turning: false, drawn: 0.0, reach }
            }
        };
        let ranges = level.unknowns.iter().zip(&guess).map(range).collect();
        let mut space = Space { steps: roots_of_primes(guess.len()), guess, ranges, quaternions: Vec::new() };
        space.find_angles(level)?;
        space.find_quaternions(level)?;
        space.find_reaches(level)?;
        Ok(space)
    }

    /// The n-th point; the guess is the point 0.
    pub(super) fn start(&self, n: usize) -> Vec<f64> {
        let entry = |((guess, range), step): ((&f64, &Range), &f64)| {
            let place = if n == 0 { 0.5 } else { fraction(n as f64 * step) };
            guess + (2.0 * place - 1.0) * range.drawn
        };
        self.guess.iter().zip(&self.ranges).zip(&self.steps).map(entry).collect()
    }

    /// The same point with all angles within half a turn of the guess, and all quaternions on its side.
    pub(super) fn turned_back(&self, y: &[f64]) -> Vec<f64> {
        let entry =
            |((y, guess), range): ((&f64, &f64), &Range)| if range.angle { y - turns(y - guess) * TAU } else { *y };
        let mut turned: Vec<f64> = y.iter().zip(&self.guess).zip(&self.ranges).map(entry).collect();
        self.take_sides(&mut turned, &self.guess);
        turned
    }

    /// Changes the signs of quaternions that point away from those of another point.
    fn take_sides(&self, y: &mut [f64], other: &[f64]) {
        for quaternion in &self.quaternions {
            if quaternion.iter().map(|j| y[*j] * other[*j]).sum::<f64>() < 0.0 {
                quaternion.iter().for_each(|j| y[*j] = -y[*j]);
            }
        }
    }

    /// The differences between two solutions, each relative to its reach, turns and signs of quaternions apart.
    pub(super) fn differences(&self, a: &[f64], b: &[f64]) -> Vec<f64> {
        let mut b = b.to_vec();
        self.take_sides(&mut b, a);
        let entry = |((a, b), range): ((&f64, &f64), &Range)| {
            let difference = a - b;
            (if range.turning { difference - turns(difference) * TAU } else { difference }) / range.reach
        };
        a.iter().zip(&b).zip(&self.ranges).map(entry).collect()
    }

    /// The root of the sum of squares of the differences from the guess, turns counted.
    pub(super) fn distance(&self, y: &[f64]) -> f64 {
        let entry = |((y, guess), range): ((&f64, &f64), &Range)| (y - guess) / range.reach;
        sqrt(y.iter().zip(&self.guess).zip(&self.ranges).map(entry).map(|difference| difference * difference).sum())
    }

    /// What one is in the unit of an unknown.
    pub(super) fn reach(&self, at: usize) -> f64 {
        self.ranges[at].reach
    }

    /// Finds what turns.
    fn find_angles<M: ConstrainedSystem>(&mut self, level: &Level<'_, '_, M>) -> Result<(), Error> {
        let n = self.guess.len();
        let (mut moved, mut same) = (Vec::new(), Vec::new());
        for look in 0..LOOKS {
            let point = self.start(look);
            let (before, slopes, sizes) = (level.residual(&point), level.jacobian(&point), level.sizes(&point)?);
            moved.resize(before.len(), vec![false; n]);
            same.resize(before.len(), vec![false; n]);
            for j in self.coordinates(level) {
                let mut turned = point.clone();
                turned[j] += TAU;
                let (after, turned_sizes) = (level.residual(&turned), level.sizes(&turned)?);
                for i in 0..before.len() {
                    let change = (after[i] - before[i]).abs();
                    if change > SAME * sizes[i].max(turned_sizes[i]) {
                        moved[i][j] = true;
                    } else if change.is_finite() && slopes[(i, j)] != 0.0 {
                        same[i][j] = true;
                    }
                }
            }
        }
        for j in 0..n {
            let moves = moved.iter().any(|row: &Vec<bool>| row[j]);
            let turning = same.iter().zip(&moved).any(|(same, moved): (&Vec<bool>, _)| same[j] && !moved[j]);
            (self.ranges[j].turning, self.ranges[j].angle) = (turning, turning && !moves);
        }
        Ok(())
    }

    /// Finds quaternions: what a row binds that holds a norm, without a multiplier, if no equation tells their signs. Where a
    /// part is held, it often does.
    fn find_quaternions<M: ConstrainedSystem>(&mut self, level: &Level<'_, '_, M>) -> Result<(), Error> {
        let carried = |name: &&str| M::MODEL.multipliers.iter().any(|multiplier| multiplier.name == *name);
        let norms = M::MODEL.position_rows.iter().enumerate().filter(|(_, name)| !carried(name));
        let slopes = level.jacobian(&self.start(1));
        let bound = |row: usize| (0..self.guess.len()).filter(|j| slopes[(row, *j)] != 0.0).collect();
        let mut found: Vec<Vec<usize>> = norms.map(|(row, _)| bound(row)).collect();
        for look in 0..LOOKS {
            let point = self.start(look);
            let (before, sizes) = (level.residual(&point), level.sizes(&point)?);
            found.retain(|quaternion| {
                let mut other = point.clone();
                quaternion.iter().for_each(|j| other[*j] = -other[*j]);
                let after = level.residual(&other);
                let same = |i: usize| (after[i] - before[i]).abs() <= SAME * sizes[i];
                !quaternion.is_empty() && (0..before.len()).all(same)
            });
        }
        self.quaternions = found;
        Ok(())
    }

    /// The places of the unknowns that are entries of the state.
    fn coordinates<M: ConstrainedSystem>(&self, level: &Level<'_, '_, M>) -> impl Iterator<Item = usize> + use<M> {
        let is_state = |unknown: &Unknown| matches!(unknown, Unknown::State(_));
        let places: Vec<usize> = (0..self.guess.len()).filter(|j| is_state(&level.unknowns[*j])).collect();
        places.into_iter()
    }
}

/// The whole number of turns next to an angle; `core` has no rounding.
fn turns(angle: f64) -> f64 {
    (angle / TAU + if angle < 0.0 { -0.5 } else { 0.5 }) as i64 as f64
}

/// The part behind the point of a number that is not negative.
fn fraction(x: f64) -> f64 {
    x - x as u64 as f64
}

/// The fractional parts of the roots of the first primes: linearly independent over the whole numbers, with one among them, so that
/// their multiples are equidistributed (Richtmyer 1951; Niederreiter, Random Number Generation and Quasi-Monte Carlo Methods, 1992).
fn roots_of_primes(count: usize) -> Vec<f64> {
    let mut primes: Vec<u32> = Vec::new();
    let mut next = 2;
    while primes.len() < count {
        if primes.iter().all(|prime| next % prime != 0) {
            primes.push(next);
        }
        next += 1;
    }
    primes.into_iter().map(|prime| fraction(sqrt(f64::from(prime)))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_are_taken_off_to_the_nearest() {
        let found = [0.0, 3.1, 3.2, -3.1, -3.2, 12.5, -12.6].map(turns);
        assert_eq!(found, [0.0, 0.0, 1.0, 0.0, -1.0, 2.0, -2.0]);
    }

    #[test]
    fn the_points_fill_every_plane_evenly() {
        let steps = roots_of_primes(12);
        assert!(
            (steps[0] - 0.414_213_562_373_095_1).abs() < 1e-15 && (steps[4] - 0.316_624_790_355_399_8).abs() < 1e-15
        );
        let n = 1600;
        for a in 0..12 {
            for b in 0..a {
                let mut counts = [0_usize; 16];
                for i in 1..=n {
                    let cell = |at: usize| (4.0 * fraction(i as f64 * steps[at])) as usize;
                    counts[4 * cell(a) + cell(b)] += 1;
                }
                assert!(counts.iter().all(|count| (60..=140).contains(count)), "{a} {b}: {counts:?}");
            }
        }
    }
}
