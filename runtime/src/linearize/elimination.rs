//! Which entries of a state are independent on the constraints, and how the others follow them.

use alloc::vec;
use alloc::vec::Vec;

use nalgebra::DMatrix;

use crate::manifold::{DEPENDENT, Manifold, STALLED, floor, term_sizes};
use crate::math::double::sqrt;
use crate::vector::convert;
use crate::{ConstrainedSystem, Dual, Error, Prepared, Vector};

/// An entry that had better be eliminated is, unless its pivot is below this fraction of the largest.
const PREFERRED: f64 = 0.1;

/// The tangent of the constraints at a state: δs = S δy with y the independent entries of s.
pub(super) struct Elimination {
    pub(super) independents: Vec<usize>,
    pub(super) dependents: Vec<usize>,
    /// S, all entries by the independent ones.
    pub(super) tangent: DMatrix<f64>,
}

/// A row of ∂(f, φ)/∂s.
struct Row {
    name: &'static str,
    /// Whether it binds speeds, not coordinates.
    binds_speeds: bool,
    slopes: Vec<f64>,
}

impl Elimination {
    /// Rows f of position constraints eliminate coordinates, rows φ that are not linear in the velocities eliminate speeds. All
    /// other rows are satisfied by any speeds of the state.
    pub(super) fn at<M: ConstrainedSystem>(
        model: &Prepared<M>,
        dual: &Prepared<M, Dual>,
        manifold: Option<Manifold<M>>,
        t: f64,
        s: &M::State<f64>,
    ) -> Result<Self, Error> {
        let names = <M::State<f64> as Vector<f64>>::NAMES;
        let coordinates = M::MODEL.state_coordinates.len();
        let mut rows = manifold.map_or_else(Vec::new, |manifold| position_rows(&manifold, s, names.len()));
        rows.extend(velocity_rows(model, dual, t, s)?);
        for row in &rows {
            if let Some(at) = row.slopes.iter().position(|slope| !slope.is_finite()) {
                return Err(Error::NotDifferentiable { name: row.name, along: names[at], time: t });
            }
        }
        // Where the rate of a coordinate is a speed of the state, both had better stay.
        let stays = |at: usize| match at.checked_sub(coordinates) {
            Some(speed) => M::MODEL.reduced_speeds.contains(&M::MODEL.state_speeds[speed]),
            None => {
                let is_rate = |speed: &&str| speed.strip_prefix("dot_") == Some(names[at]);
                M::MODEL.state_speeds.iter().any(is_rate)
            }
        };
        eliminate(rows, names.len(), coordinates, stays).map_err(|(name, value)| Error::Dependent {
            rows: vec![name],
            value,
            guard: None,
            time: Some(t),
        })
    }
}

fn position_rows<M: ConstrainedSystem>(manifold: &Manifold<M>, s: &M::State<f64>, n: usize) -> Vec<Row> {
    let live = (0..manifold.sizes.len()).filter(|row| manifold.moves(*row, s));
    live.map(|row| {
        let columns = manifold.columns;
        let mut slopes = manifold.jacobian[row * columns..(row + 1) * columns].to_vec();
        slopes.resize(n, 0.0);
        Row { name: M::MODEL.position_rows.get(row).copied().unwrap_or("position"), binds_speeds: false, slopes }
    })
    .collect()
}

/// Where v = g(u, x, t) is given, φ vanishes for all u: such rows bind nothing.
fn velocity_rows<M: ConstrainedSystem>(
    model: &Prepared<M>,
    dual: &Prepared<M, Dual>,
    t: f64,
    s: &M::State<f64>,
) -> Result<Vec<Row>, Error> {
    let state = (*s).into();
    let (least, n) = (floor(s), state.as_ref().len());
    let nonlinear = M::MODEL.velocity_rows().enumerate().filter(|(_, row)| !row.linear);
    let mut rows: Vec<(usize, Row)> = nonlinear
        .map(|(place, row)| (place, Row { name: row.name, binds_speeds: true, slopes: vec![0.0; n] }))
        .collect();
    if rows.is_empty() {
        return Ok(Vec::new());
    }
    for j in 0..n {
        let seeded = convert(s, |i, value| Dual::new(value, if i == j { 1.0 } else { 0.0 }));
        let phi = dual.velocity_residual_at(Dual::constant(t), &seeded).into();
        for (place, row) in &mut rows {
            row.slopes[j] = phi.as_ref()[*place].derivative;
        }
    }
    let (x, v) = (model.coordinates(t, s), model.velocities(t, s));
    let sizes = term_sizes(model, t, &x, &v, &|model, t, x, v| model.velocity_residual(t, x, v))?;
    rows.retain(|(place, row)| {
        let slopes = row.slopes.iter().zip(state.as_ref());
        let terms: f64 = slopes.map(|(slope, entry)| (slope * entry.abs().max(least)).abs()).sum();
        // What is not a number stays, and is an error.
        terms > STALLED * sizes[*place] || terms.is_nan()
    });
    Ok(rows.into_iter().map(|(_, row)| row).collect())
}

/// Gauss-Jordan elimination; the name of a row that binds no speed though it depends on the state, and its largest pivot.
fn eliminate(
    mut rows: Vec<Row>,
    n: usize,
    coordinates: usize,
    stays: impl Fn(usize) -> bool,
) -> Result<Elimination, (&'static str, f64)> {
    for row in &mut rows {
        let length = sqrt(row.slopes.iter().map(|slope| slope * slope).sum());
        if length > 0.0 {
            row.slopes.iter_mut().for_each(|slope| *slope /= length);
        }
    }
    let mut pivots: Vec<Option<usize>> = vec![None; rows.len()];
    let mut taken = vec![false; n];
    for binds_speeds in [false, true] {
        let columns = if binds_speeds { coordinates..n } else { 0..coordinates };
        loop {
            // The largest entry of all, and the largest of those that are not to stay.
            let (mut largest, mut preferred) = ((0, 0, 0.0), (0, 0, 0.0));
            for (i, row) in
                rows.iter().enumerate().filter(|(i, row)| pivots[*i].is_none() && row.binds_speeds == binds_speeds)
            {
                for j in columns.clone().filter(|j| !taken[*j]) {
                    let size = row.slopes[j].abs();
                    if size > largest.2 {
                        largest = (i, j, size);
                    }
                    if size > preferred.2 && !stays(j) {
                        preferred = (i, j, size);
                    }
                }
            }
            if largest.2 <= DEPENDENT {
                break;
            }
            let (i, j, _) = if preferred.2 >= PREFERRED * largest.2 { preferred } else { largest };
            clear(&mut rows, i, j);
            pivots[i] = Some(j);
            taken[j] = true;
        }
    }
    // What is left of a row that repeats others is nothing.
    for row in rows.iter().enumerate().filter(|(i, _)| pivots[*i].is_none()).map(|(_, row)| row) {
        let left = row.slopes.iter().fold(0.0, |left: f64, slope| left.max(slope.abs()));
        if left > DEPENDENT {
            return Err((row.name, left));
        }
    }
    let (independents, dependents): (Vec<usize>, Vec<usize>) = (0..n).partition(|j| !taken[*j]);
    let mut tangent = DMatrix::zeros(n, independents.len());
    for (column, at) in independents.iter().enumerate() {
        tangent[(*at, column)] = 1.0;
        for (row, pivot) in rows.iter().zip(&pivots) {
            if let Some(j) = pivot {
                tangent[(*j, column)] = -row.slopes[*at];
            }
        }
    }
    Ok(Elimination { independents, dependents, tangent })
}

/// Makes row i one in column j, and all others zero there.
fn clear(rows: &mut [Row], i: usize, j: usize) {
    let pivot = rows[i].slopes[j];
    rows[i].slopes.iter_mut().for_each(|slope| *slope /= pivot);
    rows[i].slopes[j] = 1.0;
    let cleared = rows[i].slopes.clone();
    for (_, row) in rows.iter_mut().enumerate().filter(|(at, _)| *at != i) {
        let multiple = row.slopes[j];
        row.slopes.iter_mut().zip(&cleared).for_each(|(slope, entry)| *slope -= multiple * entry);
        row.slopes[j] = 0.0;
    }
}
