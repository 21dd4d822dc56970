//! All declared rows at one point, in the form C v̇ + c0* = 0 (2.4) to (2.7).
//!
//! Every direction of a derivative is evaluated once for all rows: what they share, the rates above all, is computed once.

use super::declaration::{Constraint, Level};
use super::linear::{along, fixed, seeded, unit};
use super::number::{Dual, Number};
use super::system::{Entry, System, lift, lift_speeds};
use nalgebra::{DMatrix, DVector};

/// C v̇ + c0* = 0 (2.4), one row per declared constraint, and the levels below.
pub struct Rows {
    /// Names in the order of declaration.
    pub names: Vec<String>,
    /// Whether the row binds v linearly: every position row, and a velocity row whose ∂φ/∂v does not depend on v.
    pub linear: Vec<bool>,
    /// The level of each row.
    pub levels: Vec<Level>,
    /// C (2.5), (2.7).
    pub c: DMatrix<Entry>,
    /// c0* (2.6), (2.7).
    pub c0: DVector<Entry>,
    /// ḟ of a position row, φ of a velocity row; acceleration rows have none.
    pub velocity: Vec<(String, Entry)>,
    /// f of the position rows.
    pub position: Vec<(String, Entry)>,
}

impl System<'_> {
    /// ḟ of every position row, φ of every velocity row; zero for acceleration rows, which bind no velocity.
    fn residuals<N: Number>(&self, t: N, x: &[N], v: &[N]) -> Vec<N> {
        let rates = self.rates(t, x, v);
        let carried = self.scope(Dual::moving(t, N::one()), &along(x, &rates));
        let moving = self.scope_of_motion(t, x, v, &rates);
        let residual = |row: &Constraint| match row.level {
            Level::Position => (carried.value(&row.left) - carried.value(&row.right)).rate,
            Level::Velocity => moving.value(&row.left) - moving.value(&row.right),
            Level::Acceleration => N::zero(),
        };
        self.model.constraints.iter().map(residual).collect()
    }

    /// C v̇ + c0* of every acceleration row; zero for the others.
    fn accelerations<N: Number>(&self, t: N, x: &[N], v: &[N], vdot: &[N]) -> Vec<N> {
        if !self.has(Level::Acceleration) {
            return vec![N::zero(); self.model.constraints.len()];
        }
        let scope = self.accelerated(t, x, v, vdot);
        let residual = |row: &Constraint| match row.level {
            Level::Acceleration => scope.value(&row.left) - scope.value(&row.right),
            _ => N::zero(),
        };
        self.model.constraints.iter().map(residual).collect()
    }

    fn has(&self, level: Level) -> bool {
        self.model.constraints.iter().any(|row| row.level == level)
    }

    /// The columns of C, one for each speed: ∂φ/∂v, ∂ḟ/∂v, or the factors of v̇.
    fn columns(&self, t: Entry, x: &[Entry], v: &[Entry]) -> Vec<Vec<Entry>> {
        let n = v.len();
        let (t, x) = (Dual::fixed(t), fixed(x));
        let column = |j: usize| {
            let bound = self.residuals(t, &x, &seeded(v, j));
            let free = self.accelerations(t, &x, &fixed(v), &unit(n, j));
            let rates = bound.iter().zip(&free).zip(&self.model.constraints);
            rates.map(|((a, b), row)| if row.level == Level::Acceleration { b.rate } else { a.rate }).collect()
        };
        (0..n).map(column).collect()
    }

    /// All declared rows in acceleration form: position rows differentiated twice, velocity rows once, along ẋ = A v + a0.
    pub fn rows(&self, t: f64, x: &[f64], v: &[f64]) -> Rows {
        let (t, x, v) = (Entry::constant(t), lift(x), lift_speeds(v));
        let (n, m) = (v.len(), self.model.constraints.len());
        let (columns, elsewhere) = match m {
            0 => (vec![Vec::new(); n], Vec::new()),
            _ => (self.columns(t, &x, &v), self.columns_elsewhere(t, &x, &v)),
        };
        // a gradient that is the same at other velocities: φ is linear in v, as ḟ always is
        let same = |i: usize| {
            let pairs = columns.iter().zip(&elsewhere).map(|(here, there)| (here[i], there[i]));
            pairs.into_iter().all(|(a, b)| (a.value - b.value).abs() <= 1e-10 * a.size.max(b.size))
        };
        let carried = along(&x, &self.rates(t, &x, &v));
        let still = vec![Entry::zero(); n];
        let bound = self.residuals(Dual::moving(t, Entry::one()), &carried, &fixed(&v));
        let free = self.accelerations(t, &x, &v, &still);
        let residuals = self.residuals(t, &x, &v);
        let constraints = || self.model.constraints.iter().enumerate();
        let levels: Vec<Level> = constraints().map(|(_, c)| c.level).collect();
        Rows {
            names: self.model.constraints.iter().map(|c| c.name.clone()).collect(),
            linear: (0..m).map(|i| levels[i] == Level::Position || levels[i] == Level::Velocity && same(i)).collect(),
            c: DMatrix::from_fn(m, n, |i, j| columns[j][i]),
            c0: DVector::from_fn(m, |i, _| if levels[i] == Level::Acceleration { free[i] } else { bound[i].rate }),
            velocity: constraints()
                .filter(|(_, c)| c.level != Level::Acceleration)
                .map(|(i, c)| (c.name.clone(), residuals[i]))
                .collect(),
            position: constraints()
                .filter(|(_, c)| c.level == Level::Position)
                .map(|(i, c)| (c.name.clone(), self.position(i, t, &x)))
                .collect(),
            levels,
        }
    }

    /// The columns at other velocities, where there are rows that might not be linear in them.
    fn columns_elsewhere(&self, t: Entry, x: &[Entry], v: &[Entry]) -> Vec<Vec<Entry>> {
        if !self.has(Level::Velocity) {
            return Vec::new();
        }
        let other = |(i, v): (usize, &Entry)| Entry::constant(0.37 * (i as f64 + 1.0) - 0.8 * v.value);
        self.columns(t, x, &v.iter().enumerate().map(other).collect::<Vec<_>>())
    }
}
