//! Values in double precision at many points at once, for what modular evaluation leaves to a coin toss.

use super::modular::mix;
use super::{Algebra, Expr, Function, Graph, Rational, Symbol};

impl Graph {
    /// Whether values in double precision show that the two differ; asked only where roots occur.
    pub(super) fn contradicted(&self, a: Expr, b: Expr) -> bool {
        if !(self.branches.contains(a) || self.branches.contains(b)) {
            return false;
        }
        let mut samples = self.samples.borrow_mut();
        let found = self.evaluate_further(&[a, b], &mut Sampled::of(self), &mut samples.0);
        let mut finite = 0;
        let contradiction = (0..SAMPLES).any(|k| {
            let ((x, sx), (y, sy)) = (found[0][k], found[1][k]);
            let comparable = x.is_finite() && y.is_finite() && sx.is_finite() && sy.is_finite();
            finite += usize::from(comparable);
            comparable && (x - y).abs() > 1e-7 * (sx + sy + 1e-30)
        });
        // What was never seen is refused.
        contradiction || finite == 0
    }

    /// Whether values in double precision show that the two differ, at most of the points that can be compared: what is only
    /// refused, for want of a relation, agrees at nearly all.
    pub(super) fn refuted(&self, a: Expr, b: Expr) -> bool {
        let mut samples = self.samples.borrow_mut();
        let found = self.evaluate_further(&[a, b], &mut Sampled::of(self), &mut samples.0);
        let pairs = (0..SAMPLES).map(|k| (found[0][k], found[1][k]));
        let finite = pairs.filter(|((x, sx), (y, sy))| [x, sx, y, sy].iter().all(|value| value.is_finite()));
        let differ: Vec<bool> = finite.map(|((x, sx), (y, sy))| (x - y).abs() > 1e-7 * (sx + sy + 1e-30)).collect();
        differ.len() >= LEAST_COMPARED && 2 * differ.iter().filter(|differ| **differ).count() > differ.len()
    }

    /// Values in double precision at points near zero; none where they are not finite.
    pub(super) fn near_zero(&self, e: Expr, found: &mut Samples) -> [Option<f64>; SAMPLES] {
        let mut near = Sampled { pi: self.pi_symbol(), reach: [1.5; 3], spheres: self.spheres.clone() };
        let values = self.evaluate_further(&[e], &mut near, &mut found.0).swap_remove(0);
        std::array::from_fn(|k| Some(values[k].0).filter(|x| x.is_finite() && *x != 0.0))
    }

    /// Values in double precision, each with the size of the terms that made it: a value far below its size is zero
    /// to rounding.
    pub fn evaluate_scaled(&self, expressions: &[Expr], values: &dyn Fn(Symbol) -> f64) -> Vec<(f64, f64)> {
        self.evaluate_in(expressions, &mut Scaled { pi: self.pi_symbol(), values })
    }
}

/// Points in double precision at which what contains roots is compared.
pub(super) const SAMPLES: usize = 48;

/// Fewer points show nothing.
const LEAST_COMPARED: usize = 3;

/// Values in double precision at all points, with the sizes of their terms, one entry for each expression of the arena.
#[derive(Clone, Debug, Default)]
pub struct Samples(Vec<Option<Values>>);

/// At each point a value and the size of the terms that made it.
type Values = Box<[(f64, f64)]>;

/// [`Scaled`] at all points at once: what was compared before is not evaluated again.
struct Sampled {
    pi: Symbol,
    /// How far from zero the values of symbols are, point by point.
    reach: [f64; 3],
    /// Symbols whose squares add up to one.
    spheres: Vec<[Symbol; 4]>,
}

impl Sampled {
    /// Points near and far: a root may be real only beyond some value.
    fn of(graph: &Graph) -> Self {
        Sampled { pi: graph.pi_symbol(), reach: [2.0, 30.0, 500.0], spheres: graph.spheres.clone() }
    }

    /// One operation at every point.
    fn each(&self, mut operation: impl FnMut(&mut Scaled<'_>, usize) -> (f64, f64)) -> Values {
        let mut values = vec![(0.0, 0.0); SAMPLES];
        let (out, mut k) = (values.as_mut_slice(), 0);
        while k < SAMPLES {
            let reach = self.reach[k % 3];
            let unit = |s: Symbol| (mix(mix(k as u64) ^ mix(s.index() as u64)) >> 11) as f64 / (1u64 << 53) as f64;
            out[k] = operation(&mut Scaled { pi: self.pi, values: &|s| reach * (2.0 * unit(s) - 1.0) }, k);
            k += 1;
        }
        values.into_boxed_slice()
    }
}

impl Algebra for Sampled {
    type Value = Values;
    fn number(&mut self, value: &Rational) -> Self::Value {
        let x = value.to_f64();
        vec![(x, x.abs()); SAMPLES].into_boxed_slice()
    }
    fn symbol(&mut self, symbol: Symbol) -> Self::Value {
        let own = self.each(|scaled, _| scaled.symbol(symbol));
        let Some(four) = self.spheres.iter().find(|four| four.contains(&symbol)).copied() else { return own };
        let four = four.map(|symbol| self.each(|scaled, _| scaled.symbol(symbol)));
        let length = |k: usize| four.iter().map(|values| values[k].0 * values[k].0).sum::<f64>().sqrt();
        (0..SAMPLES).map(|k| (own[k].0 / length(k), own[k].1 / length(k))).collect()
    }
    fn add(&mut self, a: &Self::Value, b: &Self::Value) -> Self::Value {
        self.each(|scaled, k| scaled.add(&a[k], &b[k]))
    }
    fn mul(&mut self, a: &Self::Value, b: &Self::Value) -> Self::Value {
        self.each(|scaled, k| scaled.mul(&a[k], &b[k]))
    }
    fn recip(&mut self, a: &Self::Value) -> Self::Value {
        self.each(|scaled, k| scaled.recip(&a[k]))
    }
    fn function(&mut self, function: Function, arguments: &[Self::Value]) -> Self::Value {
        self.each(|scaled, k| {
            let values: Vec<(f64, f64)> = arguments.iter().map(|a| a[k]).collect();
            scaled.function(function, &values)
        })
    }
}

/// Double precision with a bound of the terms' magnitudes.
struct Scaled<'a> {
    pi: Symbol,
    values: &'a dyn Fn(Symbol) -> f64,
}

impl Algebra for Scaled<'_> {
    type Value = (f64, f64);
    fn number(&mut self, value: &Rational) -> Self::Value {
        let x = value.to_f64();
        (x, x.abs())
    }
    fn symbol(&mut self, symbol: Symbol) -> Self::Value {
        let x = if symbol == self.pi { std::f64::consts::PI } else { (self.values)(symbol) };
        (x, x.abs())
    }
    fn add(&mut self, a: &Self::Value, b: &Self::Value) -> Self::Value {
        (a.0 + b.0, a.1 + b.1)
    }
    fn mul(&mut self, a: &Self::Value, b: &Self::Value) -> Self::Value {
        (a.0 * b.0, a.1 * b.1)
    }
    fn recip(&mut self, a: &Self::Value) -> Self::Value {
        // A reciprocal loses as many digits as its argument lost by cancellation.
        (1.0 / a.0, a.1 / (a.0 * a.0))
    }
    fn function(&mut self, function: Function, arguments: &[Self::Value]) -> Self::Value {
        let values: Vec<f64> = arguments.iter().map(|a| a.0).collect();
        let x = match function {
            // What holds for every function holds for this one.
            Function::Given(at) => (0.7 * values[0] + f64::from(at)).sin() + 0.3 * values[0],
            _ => super::evaluate::double(function, &values),
        };
        if function == Function::Whole {
            return arguments[0];
        }
        (x, x.abs() + arguments.iter().map(|a| a.1).sum::<f64>())
    }
}
