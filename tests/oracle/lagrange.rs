//! M and the forces of inertia from T and V, by Lagrange's equations in the coordinates, whatever the speeds are.
//!
//! With T̃(ẋ, x, t) = T(v(ẋ, x, t), x, t) the equations of x are d/dt ∂T̃/∂ẋ − ∂T̃/∂x + ∂V/∂x = Q. Their combination by Aᵀ,
//! A = ∂ẋ/∂v, is that of the speeds, because Q does the work Qᵀ A δv: so M = ∂²T/∂v² and h* collects what is left at v̇ = 0.

use super::evaluate::Scope;
use super::linear::{along, fixed, seeded};
use super::number::{Dual, Number};
use super::system::{Entry, System};
use nalgebra::{DMatrix, DVector};
use syn::Expr;

impl System<'_> {
    /// The declared forces on top of others; none are no forces.
    pub(super) fn forces(&self, scope: &Scope<'_, Entry>, others: Vec<Entry>) -> DVector<Entry> {
        let declared = |i: usize| self.model.forces.get(i).map_or(Entry::zero(), |e| scope.value(e));
        DVector::from_fn(others.len(), |i, _| others[i] + declared(i))
    }

    /// T.
    pub(super) fn kinetic<N: Number>(&self, t: N, x: &[N], v: &[N]) -> N {
        self.moving(t, x, v).value(self.model.kinetic_energy.as_ref().expect("T is given where M is not"))
    }

    /// The forces of a potential that is declared beside bodies, in the speeds.
    pub(super) fn conservative(&self, t: Entry, x: &[Entry], a: &DMatrix<Entry>) -> Vec<Entry> {
        let n = x.len();
        let slope = |e: &Expr, j: usize| self.scope(Dual::fixed(t), &seeded(x, j)).value(e).rate;
        let slopes: Vec<Entry> = match &self.model.potential_energy {
            Some(e) => (0..n).map(|j| slope(e, j)).collect(),
            None => vec![Entry::zero(); n],
        };
        (0..n).map(|i| -(0..n).fold(Entry::zero(), |sum, j| sum + a[(j, i)] * slopes[j])).collect()
    }

    /// ∂M/∂t, entry by entry.
    pub(super) fn inertia_rate(&self, t: f64, x: &[f64]) -> Vec<f64> {
        let (moving, x, n) = (Dual::moving(t, 1.0), fixed(x), self.model.n());
        if self.model.kinetic_energy.is_some() {
            let origin = vec![Dual::zero(); n];
            let second = |k: usize| {
                let v = seeded(&seeded(&origin, k / n), k % n);
                self.kinetic(Dual::fixed(Dual::fixed(moving)), &fixed(&fixed(&x)), &v).rate.rate.rate
            };
            return (0..n * n).map(second).collect();
        }
        let scope = self.scope(moving, &x);
        self.model.inertia.iter().flatten().flatten().map(|e| scope.value(e).rate).collect()
    }

    /// T as a function of ẋ.
    fn kinetic_of_rates<N: Number>(&self, t: N, x: &[N], xdot: &[N]) -> N {
        self.kinetic(t, x, &self.velocities(t, x, xdot))
    }

    /// M, and the part of h* that T and V make.
    pub(super) fn lagrange(
        &self,
        t: Entry,
        x: &[Entry],
        v: &[Entry],
        a: &DMatrix<Entry>,
    ) -> (DMatrix<Entry>, Vec<Entry>) {
        let n = v.len();
        let second = |i: usize, j: usize| {
            let v = seeded(&seeded(v, i), j);
            self.kinetic(Dual::fixed(Dual::fixed(t)), &fixed(&fixed(x)), &v).rate.rate
        };
        let lower: Vec<Vec<Entry>> = (0..n).map(|i| (0..=i).map(|j| second(i, j)).collect()).collect();
        let m = DMatrix::from_fn(n, n, |i, j| lower[i.max(j)][i.min(j)]);

        // the motion with v̇ = 0
        let xdot = self.rates(t, x, v);
        let moving_t = Dual::moving(t, Entry::one());
        let moving_x = along(x, &xdot);
        let moving_xdot = self.rates(moving_t, &moving_x, &fixed(v));
        let still_xdot = fixed(&xdot);
        let of_coordinate = |j: usize| {
            let momentum =
                self.kinetic_of_rates(Dual::fixed(moving_t), &fixed(&moving_x), &seeded(&moving_xdot, j)).rate;
            let x = seeded(x, j);
            let slope = self.kinetic_of_rates(Dual::fixed(t), &x, &still_xdot).rate;
            let potential = self.model.potential_energy.as_ref();
            let potential = potential.map_or(Entry::zero(), |e| self.scope(Dual::fixed(t), &x).value(e).rate);
            momentum.rate - slope + potential
        };
        let e: Vec<Entry> = (0..n).map(of_coordinate).collect();
        let of_speed = |i: usize| -(0..n).fold(Entry::zero(), |sum, j| sum + a[(j, i)] * e[j]);
        (m, (0..n).map(of_speed).collect())
    }
}
