//! The initial system of a declared model at one point: (2.1) to (2.6), by evaluation and dual numbers.

use super::bodies::Bodies;
use super::declaration::{Declaration, Level};
use super::evaluate::Scope;
use super::linear::{along, fixed, seeded, solve};
use super::number::{Dual, Number, Scaled};
use super::statements::{plain, rate_of};
use nalgebra::{DMatrix, DVector};
use syn::Expr;

/// A model with its numbers.
#[derive(Clone, Debug)]
pub struct System<'a> {
    /// What was declared.
    pub model: &'a Declaration,
    /// Parameters in the order of the fields.
    pub parameters: Vec<f64>,
    /// Inputs in the order of their declaration.
    pub inputs: Vec<f64>,
}

/// ẋ = A v + a0, M v̇ = h* and the energies at a point; every entry with the size of its terms.
pub struct Dynamics {
    /// A (2.1).
    pub a: DMatrix<Entry>,
    /// a0 (2.1).
    pub a0: DVector<Entry>,
    /// M (2.3).
    pub m: DMatrix<Entry>,
    /// h* (2.3).
    pub h: DVector<Entry>,
    /// ½ vᵀ M v.
    pub kinetic: Entry,
    /// V.
    pub potential: Option<Entry>,
    /// The bodies, where there are any.
    pub bodies: Option<Bodies>,
}

/// A number with the size of its terms.
pub type Entry = Scaled;

impl<'a> System<'a> {
    /// The model with its nominal parameters and no inputs.
    pub fn nominal(model: &'a Declaration) -> Self {
        Self { model, parameters: model.nominal(), inputs: vec![0.0; model.inputs.len()] }
    }

    pub(super) fn scope<N: Number>(&self, t: N, x: &[N]) -> Scope<'a, N> {
        let lifted = |values: &[f64]| values.iter().map(|&p| N::constant(p)).collect::<Vec<_>>();
        Scope::new(self.model)
            .with(["t"], &[t])
            .with(self.model.parameters.iter().map(|(name, _)| name.as_str()), &lifted(&self.parameters))
            .with(self.model.inputs.iter().map(String::as_str), &lifted(&self.inputs))
            .with(self.model.coordinates.iter().map(String::as_str), x)
    }

    pub(super) fn moving<N: Number>(&self, t: N, x: &[N], v: &[N]) -> Scope<'a, N> {
        self.scope_of_motion(t, x, v, &self.rates(t, x, v))
    }

    pub(super) fn scope_of_motion<N: Number>(&self, t: N, x: &[N], v: &[N], rates: &[N]) -> Scope<'a, N> {
        self.scope(t, x)
            .with(self.model.speeds.iter().map(String::as_str), v)
            .with_rates(self.model.coordinates.iter().map(String::as_str), rates)
            .with_velocities()
    }

    /// Everything that an acceleration row may mention; ẍ is the derivative of ẋ = A v + a0 along the motion.
    pub(super) fn accelerated<N: Number>(&self, t: N, x: &[N], v: &[N], vdot: &[N]) -> Scope<'a, N> {
        let rates = self.rates(t, x, v);
        let along = self.rates(Dual::moving(t, N::one()), &along(x, &rates), &along(v, vdot));
        let second: Vec<N> = along.iter().map(|rate| rate.rate).collect();
        self.moving(t, x, v)
            .with_rates(self.model.speeds.iter().map(String::as_str), vdot)
            .with_second_rates(self.model.coordinates.iter().map(String::as_str), &second)
            .with_accelerations()
    }

    /// ẋ from v (2.1).
    pub fn rates<N: Number>(&self, t: N, x: &[N], v: &[N]) -> Vec<N> {
        if let Some(rates) = &self.model.rates {
            let scope = self.scope(t, x).with(self.model.speeds.iter().map(String::as_str), v);
            return rates.iter().map(|e| scope.value(e)).collect();
        }
        if self.model.speeds_by_rates.is_none() {
            return v.to_vec();
        }
        let still = vec![N::zero(); x.len()];
        let b0 = self.velocities(t, x, &still);
        let column = |j| -> Vec<N> {
            let v = self.velocities(Dual::fixed(t), &fixed(x), &seeded(&still, j));
            v.iter().map(|v| v.rate).collect()
        };
        let columns: Vec<Vec<N>> = (0..x.len()).map(column).collect();
        let b = (0..x.len()).map(|i| columns.iter().map(|c| c[i]).collect()).collect();
        solve(b, v.iter().zip(&b0).map(|(&v, &b0)| v - b0).collect())
    }

    /// v from ẋ (2.2).
    pub fn velocities<N: Number>(&self, t: N, x: &[N], xdot: &[N]) -> Vec<N> {
        if let Some(speeds) = &self.model.speeds_by_rates {
            let rates = self.model.coordinates.iter().map(String::as_str);
            let scope = self.scope(t, x).with_rates(rates, xdot).with_velocities();
            return speeds.iter().map(|e| scope.value(e)).collect();
        }
        let Some(rates) = &self.model.rates else {
            return xdot.to_vec();
        };
        let names = || self.model.speeds.iter().map(String::as_str);
        let still = vec![N::zero(); x.len()];
        let bias = self.scope(t, x).with(names(), &still);
        let columns: Vec<Vec<N>> = (0..x.len())
            .map(|j| {
                let scope = self.scope(Dual::fixed(t), &fixed(x)).with(names(), &seeded(&still, j));
                rates.iter().map(|e| scope.value(e).rate).collect()
            })
            .collect();
        let a = (0..x.len()).map(|i| columns.iter().map(|c| c[i]).collect()).collect();
        solve(a, rates.iter().zip(xdot).map(|(e, &xdot)| xdot - bias.value(e)).collect())
    }

    /// x = g(q, t) (4.2); x itself without a configuration.
    pub fn coordinates<N: Number>(&self, t: N, q: &[N]) -> Vec<N> {
        let Some(configuration) = &self.model.configuration else {
            return q.to_vec();
        };
        let names: Vec<&str> = configuration.coordinates.iter().map(String::as_str).collect();
        // g may be written in q only; the other initial coordinates are not in scope
        let lifted: Vec<N> = self.parameters.iter().map(|&p| N::constant(p)).collect();
        let scope = Scope::new(self.model)
            .with(["t"], &[t])
            .with(self.model.parameters.iter().map(|(name, _)| name.as_str()), &lifted)
            .with(names.iter().copied(), q);
        let value = |x: &String| match configuration.map.get(x) {
            Some(g) => scope.value(g),
            None => q[names.iter().position(|name| name == x).expect("a coordinate of the state")],
        };
        self.model.coordinates.iter().map(value).collect()
    }

    /// Left and right side of what is said of the quasi-velocities u (4.3), each with the text of its left side.
    pub fn quasi<N: Number>(&'a self, t: N, q: &[N], qdot: &[N], names: &'a [String], u: &[N]) -> Vec<(String, N, N)> {
        let Some(configuration) = &self.model.configuration else { return Vec::new() };
        let lifted: Vec<N> = self.parameters.iter().map(|&p| N::constant(p)).collect();
        let coordinates = || configuration.coordinates.iter().map(String::as_str);
        let scope = Scope::new(self.model)
            .with(["t"], &[t])
            .with(self.model.parameters.iter().map(|(name, _)| name.as_str()), &lifted)
            .with(coordinates(), q)
            .with_rates(coordinates(), qdot)
            .with(names.iter().map(String::as_str), u);
        // a left side is `u` or `dot(q)`
        let text = |left: &Expr| rate_of(left).map_or_else(|| plain(left).unwrap_or_default(), |q| format!("dot({q})"));
        let sides = |(left, right): &(Expr, Expr)| (text(left), scope.value(left), scope.value(right));
        configuration.quasi.iter().map(sides).collect()
    }

    /// v of a motion of the state's coordinates (4.4).
    pub fn velocities_of<N: Number>(&self, t: N, q: &[N], qdot: &[N]) -> Vec<N> {
        let x = self.coordinates(Dual::moving(t, N::one()), &along(q, qdot));
        let (x, xdot): (Vec<N>, Vec<N>) = x.iter().map(|x| (x.value, x.rate)).unzip();
        self.velocities(t, &x, &xdot)
    }

    /// f of a position row.
    pub fn position<N: Number>(&self, row: usize, t: N, x: &[N]) -> N {
        let row = &self.model.constraints[row];
        let scope = self.scope(t, x);
        scope.value(&row.left) - scope.value(&row.right)
    }

    /// ḟ of a position row along the motion, φ of a velocity row.
    pub fn velocity<N: Number>(&self, row: usize, t: N, x: &[N], v: &[N]) -> N {
        let constraint = &self.model.constraints[row];
        if constraint.level == Level::Position {
            let rates = self.rates(t, x, v);
            return self.position(row, Dual::moving(t, N::one()), &along(x, &rates)).rate;
        }
        let scope = self.moving(t, x, v);
        scope.value(&constraint.left) - scope.value(&constraint.right)
    }

    /// Dᵀ = ∂v/∂q̇ (4.9) as a matrix n × p, and a_u = v̇ with q̈ = 0.
    pub fn partial_velocities(&self, t: f64, q: &[f64], qdot: &[f64]) -> (DMatrix<Entry>, DVector<Entry>) {
        let (t, q, qdot) = (Entry::constant(t), lift(q), lift_speeds(qdot));
        let column = |j| self.velocities_of(Dual::fixed(t), &fixed(&q), &seeded(&qdot, j));
        let columns: Vec<_> = (0..q.len()).map(column).collect();
        let d_transposed = DMatrix::from_fn(self.model.n(), q.len(), |i, j| columns[j][i].rate);
        let rates = self.velocities_of(Dual::moving(t, Entry::one()), &along(&q, &qdot), &fixed(&qdot));
        (d_transposed, DVector::from_iterator(self.model.n(), rates.iter().map(|v| v.rate)))
    }

    /// A, a0, M, h* and the energies.
    pub fn dynamics(&self, t: f64, x: &[f64], v: &[f64]) -> Dynamics {
        let n = self.model.n();
        let (t, x, v) = (Entry::constant(t), lift(x), lift_speeds(v));
        let still = vec![Entry::zero(); n];
        let column = |j| self.rates(Dual::fixed(t), &fixed(&x), &seeded(&still, j));
        let columns: Vec<_> = (0..n).map(column).collect();
        let scope = self.moving(t, &x, &v);
        let a = DMatrix::from_fn(n, n, |i, j| columns[j][i].rate);
        // with both T and M given, M is a check of T
        let (m, h, kinetic) = if self.model.geometry.has_bodies() {
            // M and T beside bodies are checks of them
            (
                DMatrix::from_element(n, n, Entry::zero()),
                self.forces(&scope, self.conservative(t, &x, &a)),
                Entry::zero(),
            )
        } else if self.model.kinetic_energy.is_some() {
            let (m, inertial) = self.lagrange(t, &x, &v, &a);
            (m, self.forces(&scope, inertial), self.kinetic(t, &x, &v))
        } else {
            let entry = |i: usize, j: usize| self.model.inertia[i][j].as_ref().or(self.model.inertia[j][i].as_ref());
            let m = DMatrix::from_fn(n, n, |i, j| entry(i, j).map_or(Entry::zero(), |e| scope.value(e)));
            let pairs = (0..n * n).map(|k| m[(k / n, k % n)] * v[k / n] * v[k % n]);
            let twice = pairs.fold(Entry::zero(), |sum, pair| sum + pair);
            (m, self.forces(&scope, vec![Entry::zero(); n]), Entry::constant(0.5) * twice)
        };
        let bodies = self.bodies(t, &x, &v, &scope).map(|bodies| bodies.beside(&m, &h));
        let potential = self.model.potential_energy.as_ref().map(|e| scope.value(e));
        Dynamics {
            a0: DVector::from_vec(self.rates(t, &x, &still)),
            potential: [potential, self.potential(&scope)].into_iter().flatten().reduce(|a, b| a + b),
            a,
            m: bodies.as_ref().map_or(m, Bodies::reduced_inertia),
            h: bodies.as_ref().map_or(h, Bodies::reduced_forces),
            kinetic: bodies.as_ref().map_or(kinetic, |bodies| kinetic + bodies.kinetic()),
            bodies,
        }
    }
}

pub(super) fn lift(values: &[f64]) -> Vec<Entry> {
    values.iter().map(|&x| Entry::constant(x)).collect()
}

/// Speeds are drawn of order one, and each is computed from the others: so each has the size of the largest, and at least one,
/// even where it happens to vanish.
pub(super) fn lift_speeds(values: &[f64]) -> Vec<Entry> {
    let size = values.iter().fold(1.0_f64, |size, v| size.max(v.abs()));
    values.iter().map(|&value| Entry { value, size }).collect()
}
