//! Assemblies from many starts, the same ones counted once.

use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector};

use super::entry_name;
use super::space::Space;
use crate::assemble::AssemblyReport;
use crate::assemble::newton::{Equations, wander, worst};
use crate::assemble::problem::{Level, Unknown};
use crate::forms::null_directions;
use crate::{ConstrainedSystem, Error};

/// Solutions nearer than this are one, in rad and in parts of the reach, turns apart.
const NEAR: f64 = 1e-5;
/// Directions along which the equations change by less than this fraction of the most are tried: the mechanism may move there. A
/// double root has such a direction too.
const LOOSE: f64 = 1e-4;
/// How far it is tried to move, in rad and in parts of the reach.
const TRIED: f64 = 1e-2;
/// It moves if it stays away by this fraction of that.
const MOVED: f64 = 0.1;
/// A coordinate takes part in a motion if its part is above this.
const PART: f64 = 1e-6;

/// What was found.
pub(super) struct Found {
    pub(super) modes: Vec<Mode>,
    pub(super) unclosed: usize,
    pub(super) nearest_miss: Option<Error>,
    pub(super) movable: usize,
}

/// A solution at which the mechanism is held.
pub(super) struct Mode {
    y: Vec<f64>,
    pub(super) state: Vec<f64>,
    pub(super) parameters: Vec<f64>,
    pub(super) report: AssemblyReport,
    pub(super) distance: f64,
    pub(super) starts: usize,
}

/// Goes from the guess and from so many further starts.
pub(super) fn search<M: ConstrainedSystem>(level: &Level<'_, '_, M>, starts: usize) -> Result<Found, Error> {
    let space = Space::new(level)?;
    let mut found = Found { modes: Vec::new(), unclosed: 0, nearest_miss: None, movable: 0 };
    let mut least_miss = f64::INFINITY;
    let mut least_motion: Option<(usize, Vec<&'static str>)> = None;
    for n in 0..=starts {
        let (y, report) = match close(level, &space, space.start(n)) {
            Ok(closed) => closed,
            Err(Error::Assembly { constraint, residual, report }) => {
                let miss = miss(&report);
                if found.nearest_miss.is_none() || miss < least_miss {
                    least_miss = miss;
                    found.nearest_miss = Some(Error::Assembly { constraint, residual, report });
                }
                found.unclosed += 1;
                continue;
            }
            Err(error) => return Err(error),
        };
        let same = |mode: &&mut Mode| space.differences(&mode.y, &y).iter().all(|difference| difference.abs() <= NEAR);
        if let Some(mode) = found.modes.iter_mut().find(same) {
            mode.starts += 1;
            // Where a turn changes some equations, another solution may be turns away.
            let distance = space.distance(&y);
            if distance + NEAR < mode.distance {
                (mode.state, mode.parameters) = level.point(&y);
                (mode.y, mode.report, mode.distance) = (y, report, distance);
            }
            continue;
        }
        match motion(level, &space, &y)? {
            (0, _) => {
                let (state, parameters) = level.point(&y);
                let distance = space.distance(&y);
                found.modes.push(Mode { y, state, parameters, report, distance, starts: 1 });
            }
            motion => {
                found.movable += 1;
                if least_motion.as_ref().is_none_or(|least| motion.0 < least.0) {
                    least_motion = Some(motion);
                }
            }
        }
    }
    if found.modes.is_empty() {
        if let Some((freedom, among)) = least_motion {
            return Err(Error::Movable { freedom, among });
        }
        if let Some(error) = found.nearest_miss {
            return Err(error);
        }
    }
    found.modes.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    Ok(found)
}

/// A solution with its angles near the guess.
fn close<M: ConstrainedSystem>(
    level: &Level<'_, '_, M>,
    space: &Space,
    mut y: Vec<f64>,
) -> Result<(Vec<f64>, AssemblyReport), Error> {
    let start = y.clone();
    let report = match level.close(&mut y) {
        Ok(report) => report,
        Err(Error::Assembly { constraint, residual, report }) => {
            // A residual that is least nearby, without being zero, is no end for full steps.
            let mut other = start;
            wander(level, &mut other, &level.sizes(&y)?);
            other = space.turned_back(&other);
            match level.close(&mut other) {
                Ok(closed) => {
                    y = other;
                    closed
                }
                // They may also lead to parameters that the model refuses.
                Err(_) => return Err(Error::Assembly { constraint, residual, report }),
            }
        }
        Err(error) => return Err(error),
    };
    let turned = space.turned_back(&y);
    if turned == y {
        return Ok((y, report));
    }
    // A turn is no exact number: what its rounding leaves is closed again.
    y = turned;
    let report = level.close(&mut y)?;
    Ok((y, report))
}

/// In how many ways the mechanism can move from a solution, and which entries of the state move then.
///
/// The rank of the Jacobian does not tell alone: where two modes meet it falls as well. So a small step is made in each direction
/// that it leaves, and closed again.
fn motion<M: ConstrainedSystem>(
    level: &Level<'_, '_, M>,
    space: &Space,
    y: &[f64],
) -> Result<(usize, Vec<&'static str>), Error> {
    let (mut jacobian, sizes): (DMatrix<f64>, _) = (level.jacobian(y), level.sizes(y)?);
    for (i, size) in sizes.iter().enumerate() {
        if *size > 0.0 {
            jacobian.row_mut(i).scale_mut(1.0 / size);
        }
    }
    for j in 0..y.len() {
        jacobian.column_mut(j).scale_mut(space.reach(j));
    }
    let (mut moves, mut among) = (false, Vec::new());
    let directions = null_directions(jacobian, LOOSE);
    for direction in directions.row_iter() {
        let direction: DVector<f64> = direction.transpose();
        let step = |(j, y): (usize, &f64)| y + TRIED * direction[j] * space.reach(j);
        let mut near: Vec<f64> = y.iter().enumerate().map(step).collect();
        let closed = level.close(&mut near).is_ok();
        let away = space.differences(&near, y).iter().fold(0.0, |away: f64, difference| away.max(difference.abs()));
        moves |= closed && away > MOVED * TRIED;
    }
    if !moves {
        return Ok((0, among));
    }
    for (j, unknown) in level.unknowns.iter().enumerate() {
        if let Unknown::State(at) = unknown
            && directions.column(j).amax() > PART
        {
            among.push(entry_name::<M>(*at));
        }
    }
    Ok((directions.nrows(), among))
}

/// The largest residual relative to its terms.
fn miss(report: &AssemblyReport) -> f64 {
    let (residuals, sizes): (Vec<f64>, Vec<f64>) =
        report.entries.iter().map(|entry| (entry.residual, entry.size)).unzip();
    worst(&residuals, &sizes).1
}
