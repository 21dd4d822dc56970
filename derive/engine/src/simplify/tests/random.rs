//! Random expressions of mechanical flavour: cheaper or equal, and the same function, exactly and in doubles.

use super::support::Names;
use crate::simplify::{Search, cost, normalise, simplify};
use crate::symbolic::modular::mix;
use crate::symbolic::{Expr, Graph, Kind, Rational, Stage};

/// A generator with a state of one word.
pub struct Draw(pub u64);

impl Draw {
    pub fn below(&mut self, n: usize) -> usize {
        self.0 = mix(self.0);
        (self.0 % n as u64) as usize
    }

    pub fn real(&mut self) -> f64 {
        self.below(1 << 40) as f64 / (1u64 << 40) as f64
    }
}

/// Symbols, sines and cosines, and sums, products, quotients and roots of them.
pub fn expressions(names: &mut Names, draw: &mut Draw, count: usize) -> Vec<Expr> {
    let leaves = [
        "m", "J", "r", "x", "y", "u", "v", "sin(x)", "cos(x)", "sin(y)", "cos(y)", "cos(x-y)", "sin(2*x)", "2", "3/2",
        "m*r^2+J",
    ];
    let mut pool: Vec<Expr> = leaves.iter().map(|t| names.parse(t)).collect();
    let g = &mut names.graph;
    let pick = |draw: &mut Draw, pool: &[Expr]| pool[draw.below(pool.len())];
    while pool.len() < leaves.len() + count {
        let (a, b, c) = (pick(draw, &pool), pick(draw, &pool), pick(draw, &pool));
        let e = match draw.below(12) {
            0..=3 => {
                let (ab, n) = (g.mul(a, b), Rational::integer(draw.below(5) as i64 - 2));
                g.linear(Rational::ZERO, &[(Rational::ONE, ab), (n, c)])
            }
            4..=5 => g.mul(a, b),
            6 => g.product(&[a, b, c]),
            7 => {
                let (a2, b2) = (g.powi(a, 2), g.powi(b, 2));
                g.add(a2, b2)
            }
            8 => {
                // A positive divisor, known as such now and then.
                let square = g.powi(a, 2);
                let divisor = g.linear(Rational::ONE, &[(Rational::ONE, square)]);
                if draw.below(2) == 0 {
                    g.assume_nonzero(divisor);
                }
                let over = g.div(b, divisor);
                g.add(over, c)
            }
            9 => {
                let square = g.powi(a, 2);
                let below = g.linear(Rational::integer(2), &[(Rational::ONE, square)]);
                g.sqrt(below)
            }
            10 => {
                let (ab, bc) = (g.mul(a, b), g.mul(b, c));
                g.sub(ab, bc)
            }
            _ => g.sum(&[a, b, c]),
        };
        // Everything stays small enough to compare in doubles.
        if g.reachable(&[e]).len() < 40 && g.stage(e) != Stage::Constant {
            pool.push(e);
        }
    }
    pool.split_off(leaves.len())
}

pub fn names() -> Names {
    Names::new(&[("m J r", Kind::Parameter), ("x y", Kind::Coordinate), ("u v", Kind::Speed)])
}

/// Asserts that the values agree in doubles at random points.
pub fn assert_same_values(graph: &Graph, before: &[Expr], after: &[Expr], draw: &mut Draw) {
    for _ in 0..3 {
        let values: Vec<f64> = graph.symbols().map(|_| 0.3 + draw.real()).collect();
        let at = |s: crate::symbolic::Symbol| values[s.index()];
        let (x, y) = (graph.evaluate(before, &at), graph.evaluate(after, &at));
        for (k, (x, y)) in x.iter().zip(&y).enumerate() {
            let close = (x - y).abs() <= 1e-8 * (1.0 + x.abs()) || !x.is_finite() || x.abs() > 1e8;
            assert!(close, "{x} {y}: {} became {}", graph.display(before[k]), graph.display(after[k]));
        }
    }
}

#[test]
fn normal_forms_are_the_same_function_and_never_dearer() {
    let mut draw = Draw(1);
    let mut cheaper = 0;
    for _ in 0..20 {
        let mut names = names();
        for e in expressions(&mut names, &mut draw, 20) {
            let g = &mut names.graph;
            let normal = normalise(g, e);
            assert!(g.identical(e, normal));
            let (before, after) = (cost(g, &[e]).weight(), cost(g, &[normal]).weight());
            assert!(after <= before, "{} -> {}", g.display(e), g.display(normal));
            cheaper += usize::from(after < before);
            assert_same_values(g, &[e], &[normal], &mut draw);
        }
    }
    assert!(cheaper > 40, "{cheaper}");
}

#[test]
fn roots_together_are_the_same_functions_and_never_dearer() {
    let mut draw = Draw(2);
    let (mut all_before, mut all_after) = (0, 0);
    for _ in 0..40 {
        let mut names = names();
        let roots = expressions(&mut names, &mut draw, 10);
        let g = &mut names.graph;
        let out = simplify(g, &roots, Search::Full);
        for (new, old) in out.iter().zip(&roots) {
            assert!(g.identical(*new, *old), "{} -> {}", g.display(*old), g.display(*new));
        }
        let (before, after) = (cost(g, &roots).weight(), cost(g, &out).weight());
        assert!(after <= before, "{before} {after}");
        all_before += before;
        all_after += after;
        assert_same_values(g, &roots, &out, &mut draw);
        assert_eq!(simplify(&mut g.clone(), &roots, Search::Off), roots);
    }
    assert!(all_after < all_before, "{all_before} {all_after}");
    println!("{all_before} -> {all_after}");
}
