//! The general form (3.5) of a model at one point, in its carriers.

use alloc::vec;
use alloc::vec::Vec;

use nalgebra::{DMatrix, DVector};

use super::guards::SINGULAR;
use super::orientation::Orientation;
use crate::carriers::{Carriers, Frame};
use crate::manifold::Manifold;
use crate::tangent::{Loss, Span, Tangent};
use crate::{ConstrainedSystem, Error, Level, Matrix, Prepared, Vector};

/// Rows of C below this fraction of the longest do not take part in reactions.
const NEGLIGIBLE: f64 = 1e-12;

/// Rows whose directions a step apart have this cosine, in magnitude, are the same or opposite.
const OPPOSITE: f64 = 0.9;

/// Rows depend on each other, as far as can be told, where their smallest pivot has fallen to this fraction of its largest value.
///
/// Near a point where two branches of a mechanism meet f is about the product of the distances from them. At the distance ρ along
/// one, rounding of f by ε is a distance ε/ρ from it, and a turn of the row by ε/ρ²: here by a millionth. A run that went on would
/// choose its branch, and lose energy, by rounding.
const LOST: f64 = 1e-5;

/// α and β of Baumgarte's stabilisation.
pub(super) type Baumgarte = Option<(f64, f64)>;

/// How well the rows of C told directions apart, at best: with it is compared how well they do.
#[derive(Clone, Debug)]
pub(super) struct Strength {
    /// The largest lengths of the rows.
    rows: Vec<f64>,
    /// The largest value of the smallest pivot of their decomposition, scaled to one length.
    pivot: f64,
}

/// Room for the general form: C B ẇ + c0* + C a = 0 and D Bᵀ (M (B ẇ + a) − h*) = 0 with v = B w + v_p, v̇ = B ẇ + a.
pub(super) struct Equations<M: ConstrainedSystem> {
    frame: Frame<M>,
    tangent: Tangent,
    /// C by rows.
    rows: Vec<f64>,
    bias: Vec<f64>,
    forces: Vec<f64>,
    orientation: Orientation,
    /// The lengths of the rows at the last point.
    lengths: Vec<f64>,
    pub(super) strength: Strength,
    /// The rows of C at the last point at which a crossing was looked for.
    before: Option<Span>,
    /// ẇ of the last point.
    pub(super) rates: Vec<f64>,
    /// How often it was solved.
    pub(super) solved: usize,
}

impl<M: ConstrainedSystem> Equations<M> {
    pub(super) fn new(model: &Prepared<M>) -> Result<Self, Error> {
        let frame = Frame::new(model, Carriers::General)?;
        let ((n, c), m) = (frame.size, M::MODEL.rows.len());
        Ok(Equations {
            frame,
            tangent: Tangent::new(c, m),
            rows: vec![0.0; m * n],
            lengths: vec![0.0; m],
            bias: vec![0.0; m],
            forces: vec![0.0; c],
            orientation: Orientation::default(),
            strength: Strength { rows: vec![0.0; m], pivot: 0.0 },
            before: None,
            rates: vec![0.0; c],
            solved: 0,
        })
    }

    /// The carriers of velocities v, by least squares in the kinetic metric where there are fewer of them.
    pub(super) fn carriers(
        &mut self,
        model: &Prepared<M>,
        t: f64,
        s: &M::State<f64>,
        v: &M::Velocities<f64>,
    ) -> M::Carriers<f64> {
        let v = (*v).into();
        let at_rest = Carriers::General.velocities(model, t, s, |_| 0.0).into();
        let inertia = model.inertia(t, &model.coordinates(t, s));
        self.frame.turn(t, s, |_| 0.0);
        let n = self.frame.size.0;
        let momentum =
            |i: usize| -> f64 { (0..n).map(|j| inertia.entry(i, j) * (v.as_ref()[j] - at_rest.as_ref()[j])).sum() };
        if M::MODEL.carriers == M::MODEL.velocities {
            return M::Carriers::from_fn(|i| v.as_ref()[i]);
        }
        let mut free = Tangent::new(self.frame.size.1, 0);
        self.frame.pull_inertia(&inertia, &mut free.mass);
        self.frame.pull_force(momentum, &mut self.forces);
        let mut w = vec![f64::NAN; self.frame.size.1];
        if free.decompose(Some(0), SINGULAR).is_ok() {
            free.solve(&[], &self.forces, &mut w);
        }
        M::Carriers::from_fn(|i| w[i])
    }

    /// ẇ at a point, into `rates`; with the rates of the state's coordinates, which are returned.
    pub(super) fn solve(
        &mut self,
        model: &Prepared<M>,
        t: f64,
        s: &M::State<f64>,
        w: &M::Carriers<f64>,
        inputs: &M::Inputs<f64>,
        baumgarte: Baumgarte,
    ) -> Result<M::StateCoordinates<f64>, Error> {
        self.solved += 1;
        let carriers = (*w).into();
        let carriers: &[f64] = carriers.as_ref();
        let v = model.carried_velocities(t, s, w);
        let x = model.coordinates(t, s);
        let rates = model.carried_rates(t, s, w);
        let moving = rates.into();
        self.frame.turn(t, s, |i| carriers[i]);
        self.frame.drift(t, s, |i| moving.as_ref()[i], |i| carriers[i]);
        let (n, m) = (self.frame.size.0, self.bias.len());
        let (matrix, bias) = (model.constraint_matrix(t, &x, &v), model.constraint_bias(t, &x, &v).into());
        for i in 0..m {
            let mut sum = bias.as_ref()[i];
            for j in 0..n {
                self.rows[i * n + j] = matrix.entry(i, j);
                sum += matrix.entry(i, j) * self.frame.bias[j];
            }
            self.bias[i] = sum;
        }
        if let Some(gains) = baumgarte {
            self.stabilise(model, t, &x, &v, gains);
        }
        let inertia = model.inertia(t, &x);
        let forces = model.forces(t, &x, &v, inputs).into();
        let force = |i: usize| -> f64 {
            let known: f64 = (0..n).map(|j| inertia.entry(i, j) * self.frame.bias[j]).sum();
            forces.as_ref()[i] - known
        };
        self.frame.pull_rows(&self.rows, &mut self.tangent.rows);
        self.frame.pull_inertia(&inertia, &mut self.tangent.mass);
        self.frame.pull_force(force, &mut self.forces);
        if self.tangent.rows.iter().chain(&self.tangent.mass).any(|entry| !entry.is_finite()) {
            return Err(Error::NonFinite { name: "C or M" });
        }
        self.measure(t)?;
        let rank = self.frame.size.1.saturating_sub(M::MODEL.reduced_speeds.len());
        self.tangent.decompose(Some(rank), SINGULAR).map_err(|loss| self.loss(loss, t))?;
        self.tangent.solve(&self.bias, &self.forces, &mut self.rates);
        self.orientation.note(t, &self.tangent);
        Ok(rates)
    }

    /// Judges the point at this time, which is to be accepted: whether a loss of rank lies between it and the one before.
    pub(super) fn accept(&mut self, t: f64) -> Result<(), Error> {
        match self.orientation.accept(t, &self.tangent) {
            Some(rows) => Err(self.loss(Loss::Rank { rows, pivot: 0.0 }, t)),
            None => {
                self.strengthen();
                self.weakest(t, LOST).map_or(Ok(()), Err)
            }
        }
    }

    /// What is left of the rank at the last point: of the smallest pivot, or of the length of a row of positions, relative to the
    /// largest value that it had.
    pub(super) fn rank_left(&self) -> f64 {
        let length = self.shortest().map_or(f64::INFINITY, |(_, length)| length);
        length.min(self.pivot_left())
    }

    /// The rows that the last solution left out, with the sines of the angles between them and the others.
    pub(super) fn left_out(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.tangent.left_out()
    }

    /// What the last solution leaves of a row's C B ẇ + C a + c0*, relative to its terms.
    pub(super) fn missed(&self, row: usize) -> f64 {
        let c = self.frame.size.1;
        let products =
            self.tangent.rows[row * c..(row + 1) * c].iter().zip(&self.rates).map(|(entry, rate)| entry * rate);
        let bias = self.bias[row];
        let (sum, size) = products.fold((bias, bias.abs()), |(sum, size), p| (sum + p, size + p.abs()));
        if size > 0.0 { sum.abs() / size } else { 0.0 }
    }

    /// Remembers how well the rows of the last point tell directions apart, if no point before did better.
    pub(super) fn strengthen(&mut self) {
        self.strength.pivot = self.strength.pivot.max(self.tangent.least);
    }

    /// The smallest pivot at the last point, as a sine.
    pub(super) fn smallest_pivot(&self) -> f64 {
        self.tangent.least
    }

    /// The rows at the last point, to be compared with those of others.
    pub(super) fn span(&self) -> Span {
        self.tangent.span()
    }

    /// Whether the rows have turned over since they were these.
    pub(super) fn is_turned(&self, before: &Span) -> bool {
        self.tangent.compare(before).0 < 0.0
    }

    fn pivot_left(&self) -> f64 {
        self.tangent.least / self.strength.pivot.max(self.tangent.least)
    }

    /// The row of positions of whose length least is left, and how much.
    ///
    /// Rows of velocities and accelerations are not gradients of what they bind: no branches meet where they are short.
    fn shortest(&self) -> Option<(usize, f64)> {
        let positions = (0..self.lengths.len()).filter(|row| M::MODEL.rows[*row].level == Level::Position);
        let lengths = positions.map(|row| (row, self.lengths[row] / self.strength.rows[row]));
        lengths.min_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// The row that has become shortest, or the rows that are nearest to depending on each other, at the last point, if what is
    /// left of them is below this fraction of what there was.
    pub(super) fn weakest(&self, t: f64, below: f64) -> Option<Error> {
        let pivot = self.pivot_left();
        let (rows, pivot) = match self.shortest() {
            Some((row, length)) if length < pivot => (vec![row], length),
            _ => (self.tangent.weakest(), pivot),
        };
        (pivot < below).then(|| self.loss(Loss::Rank { rows, pivot }, t))
    }

    /// Whether a loss of rank lies between this point and the last one that was looked at. Unlike in the general chart nothing is
    /// known of the points between: rows count as turned over only where they are nearly opposite, which no accurate step turns
    /// them by itself.
    pub(super) fn crossed(
        &mut self,
        model: &Prepared<M>,
        t: f64,
        (s, v): (&M::State<f64>, &M::Velocities<f64>),
        inputs: &M::Inputs<f64>,
    ) -> Result<(), Error> {
        let w = self.carriers(model, t, s, v);
        self.solve(model, t, s, &w, inputs, None)?;
        if let Some(before) = &self.before {
            let (sign, cosine) = self.tangent.compare(before);
            if sign < 0.0 && cosine > OPPOSITE {
                let rows = self.tangent.turned(before);
                let rows = if rows.is_empty() { before.rows.clone() } else { rows };
                return Err(self.loss(Loss::Rank { rows, pivot: 0.0 }, t));
            }
        }
        self.before = Some(self.tangent.span());
        Ok(())
    }

    /// Adds 2 α φ + β² f to c0*, row by row: Baumgarte's terms.
    fn stabilise(
        &mut self,
        model: &Prepared<M>,
        t: f64,
        x: &M::Coordinates<f64>,
        v: &M::Velocities<f64>,
        (alpha, beta): (f64, f64),
    ) {
        let (phi, f) = (model.velocity_residual(t, x, v).into(), model.position_residual(t, x).into());
        let binding = M::MODEL.rows.iter().enumerate().filter(|(_, row)| row.level != Level::Acceleration);
        for (residual, (i, row)) in binding.enumerate() {
            self.bias[i] += 2.0 * alpha * phi.as_ref()[residual];
            if let Some(position) = M::MODEL.position_rows.iter().position(|name| *name == row.name) {
                self.bias[i] += beta * beta * f.as_ref()[position];
            }
        }
    }

    /// A row that has become short has lost its direction: the gradient of its constraint vanishes.
    fn measure(&mut self, t: f64) -> Result<(), Error> {
        let c = self.frame.size.1;
        for i in 0..self.lengths.len() {
            let row = &self.tangent.rows[i * c..(i + 1) * c];
            let length = row.iter().fold(0.0, |longest: f64, entry| longest.max(entry.abs()));
            self.lengths[i] = length;
            let longest = &mut self.strength.rows[i];
            *longest = longest.max(length);
            if length <= SINGULAR * *longest && *longest > 0.0 {
                let pivot = length / *longest;
                return Err(self.loss(Loss::Rank { rows: vec![i], pivot }, t));
            }
        }
        Ok(())
    }

    fn loss(&self, loss: Loss, time: f64) -> Error {
        match loss {
            Loss::Rank { rows, pivot } => {
                let names = rows.iter().filter_map(|row| M::MODEL.rows.get(*row)).map(|row| row.name).collect();
                Error::Dependent { rows: names, value: pivot, guard: None, time: Some(time) }
            }
            Loss::Inertia { pivot } => Error::Indefinite { pivot: "D M Dᵀ", value: pivot, time: Some(time) },
        }
    }

    /// λ (3.6) at coordinates and velocities that need no chart: Cᵀ λ = M v̇ − h*, of least norm where rows depend on each other.
    pub(super) fn multipliers(
        &mut self,
        model: &Prepared<M>,
        t: f64,
        s: &M::State<f64>,
        v: &M::Velocities<f64>,
        inputs: &M::Inputs<f64>,
    ) -> Result<M::Multipliers<f64>, Error> {
        let w = self.carriers(model, t, s, v);
        self.solve(model, t, s, &w, inputs, None)?;
        let ((n, c), m, x) = (self.frame.size, self.bias.len(), model.coordinates(t, s));
        let rates = DVector::from_fn(n, |i, _| {
            self.frame.bias[i] + (0..c).map(|j| self.frame.basis[i * c + j] * self.rates[j]).sum::<f64>()
        });
        let (inertia, forces) = (model.inertia(t, &x), model.forces(t, &x, v, inputs).into());
        let inertia = DMatrix::from_fn(n, n, |i, j| inertia.entry(i, j));
        let reaction = inertia * rates - DVector::from_column_slice(forces.as_ref());
        let columns = DMatrix::from_fn(n, m, |j, i| self.rows[i * n + j]);
        let lambda = match columns.try_svd(true, true, f64::EPSILON, 1000) {
            Some(svd) if m > 0 => {
                let least = NEGLIGIBLE * svd.singular_values.max();
                svd.solve(&reaction, least).map_err(|_| Error::NonFinite { name: "C" })?
            }
            _ => DVector::zeros(m),
        };
        let shared = |name: &str| self.shared(model, t, s, name);
        let entries: Vec<f64> = M::MODEL
            .multipliers
            .iter()
            .map(|entry| match entry.row {
                Some(row) => lambda[row],
                None => shared(entry.name).map_or(0.0, |(row, scale)| lambda[row] / scale),
            })
            .collect();
        Ok(M::Multipliers::from_fn(|i| entries[i]))
    }

    /// The outputs at coordinates and velocities that need no chart; of `s` the speeds are read where v = g(u, x, t) is given.
    pub(super) fn outputs(
        &mut self,
        model: &Prepared<M>,
        t: f64,
        s: &M::State<f64>,
        v: &M::Velocities<f64>,
        inputs: &M::Inputs<f64>,
    ) -> Result<M::Outputs<f64>, Error> {
        let w = self.carriers(model, t, s, v);
        // Where no output needs them, accelerations and reactions need not exist.
        let moving = M::MODEL.outputs.iter().any(|output| output.level == Level::Acceleration);
        let multipliers = match moving {
            true => self.multipliers(model, t, s, v, inputs)?,
            false => M::Multipliers::from_fn(|_| f64::NAN),
        };
        let rates = M::Carriers::from_fn(|i| if moving { self.rates[i] } else { f64::NAN });
        let outputs = M::carried_outputs(model.values(), t, s, &w, &rates, &multipliers, inputs);
        let values = outputs.into();
        match M::MODEL.outputs.iter().zip(values.as_ref()).find(|(_, value)| !value.is_finite()) {
            Some((output, _)) => Err(Error::Undefined { output: output.name, divisors: output.divisors, time: t }),
            None => Ok(outputs),
        }
    }

    /// The row of C that carries a merged position row, and the factor between them: its gradient is that many times the row.
    fn shared(&self, model: &Prepared<M>, t: f64, s: &M::State<f64>, name: &str) -> Option<(usize, f64)> {
        let position = M::MODEL.position_rows.iter().position(|entry| *entry == name)?;
        let c = self.frame.size.1;
        let mut manifold = Manifold::new(model, t, s).ok()?;
        let gradient = manifold.gradient(t, s, position);
        let parallel = |row: &[f64]| {
            let product: f64 = row.iter().zip(&gradient).map(|(a, b)| a * b).sum();
            let (a, b): (f64, f64) = (row.iter().map(|a| a * a).sum(), gradient.iter().map(|b| b * b).sum());
            (product / a, product * product / (a * b))
        };
        let rows = self.tangent.rows.chunks(c.max(1)).map(parallel).enumerate();
        rows.filter(|(_, (_, cosine))| *cosine > 0.99).map(|(i, (scale, _))| (i, scale)).next()
    }
}
