//! What moves: the same scope once more over dual numbers in time, in which every point and frame is differentiated.

use super::evaluate::Scope;
use super::number::{Dual, Number};
use super::vectors::{Axes, Value, Vector, outer, scaled, sum};
use syn::Expr;

/// A scope along the motion.
pub trait Rates<N> {
    /// The derivative of an expression in positions: a velocity, or an acceleration.
    fn rate(&self, e: &Expr) -> Value<N>;
    /// The angular velocity of a frame, or its derivative.
    fn turning(&self, frame: &Expr) -> Vector<N>;
}

/// First derivatives.
struct Once<'a, N>(Scope<'a, Dual<N>>);

/// Second derivatives.
struct Twice<'a, N>(Scope<'a, Dual<Dual<N>>>);

impl<N: Number> Rates<N> for Once<'_, N> {
    fn rate(&self, e: &Expr) -> Value<N> {
        self.0.evaluate(e).map(|x| x.rate)
    }
    fn turning(&self, frame: &Expr) -> Vector<N> {
        angular_velocity(&self.0.axes(frame))
    }
}

impl<N: Number> Rates<N> for Twice<'_, N> {
    fn rate(&self, e: &Expr) -> Value<N> {
        self.0.evaluate(e).map(|x| x.rate.rate)
    }
    fn turning(&self, frame: &Expr) -> Vector<N> {
        angular_velocity(&self.0.axes(frame)).map(|x| x.rate)
    }
}

/// Axes e of a frame turn as ė = ω × e, so that e × ė adds up to 2 ω over the three of them.
fn angular_velocity<N: Number>(axes: &Axes<Dual<N>>) -> Vector<N> {
    let of = |axis: &Vector<Dual<N>>| outer(&axis.map(|x| x.value), &axis.map(|x| x.rate));
    let twice = axes.iter().map(of).reduce(|a, b| sum(&a, &b)).expect("three axes");
    scaled(N::constant(0.5), &twice)
}

impl<'a, N: Number> Scope<'a, N> {
    /// The scope with what the rates in it say of velocities.
    pub fn with_velocities(mut self) -> Self {
        self.along[0] = Some(once);
        self
    }

    /// The scope with what the second rates in it say of accelerations.
    pub fn with_accelerations(mut self) -> Self {
        self.along[1] = Some(twice);
        self.with_velocities()
    }

    /// The scope along the motion, for first or for second derivatives.
    ///
    /// # Panics
    /// Where the scope knows no motion.
    pub(super) fn along(&self, order: usize) -> &dyn Rates<N> {
        let lift = self.along[order].unwrap_or_else(|| panic!("derivatives of order {} are not in scope", order + 1));
        &**self.moving[order].get_or_init(|| lift(self))
    }

    /// The same scope over other numbers.
    fn over<M: Number>(&self, lifted: impl Fn(&str, N) -> M) -> Scope<'a, M> {
        let mut scope = Scope::new(self.model);
        scope.names = self.names.iter().map(|(name, value)| (*name, lifted(name, *value))).collect();
        scope
    }

    /// The derivatives of a name; what has none stands still.
    fn derivatives(&self, name: &str) -> [N; 2] {
        match name {
            "t" => [N::one(), N::zero()],
            name => [&self.rates, &self.second_rates].map(|known| known.get(name).copied().unwrap_or(N::zero())),
        }
    }
}

fn once<'a, N: Number>(scope: &Scope<'a, N>) -> Box<dyn Rates<N> + 'a> {
    Box::new(Once(scope.over(|name, value| Dual::moving(value, scope.derivatives(name)[0]))))
}

fn twice<'a, N: Number>(scope: &Scope<'a, N>) -> Box<dyn Rates<N> + 'a> {
    Box::new(Twice(scope.over(|name, value| {
        let [rate, second] = scope.derivatives(name);
        Dual::moving(Dual::moving(value, rate), Dual::moving(rate, second))
    })))
}
