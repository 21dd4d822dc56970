//! Programs against the graph they come from, and against counts by hand.

pub(crate) mod disks;
mod laws;
pub(crate) mod models;

use super::*;
use crate::projection::Equations;
use crate::symbolic::{Expr, Graph, Rational, Symbol};
use disks::{disk, disk_stage};
use models::{outputs, pendulum};

/// A value for each symbol: fixed, away from zero, different from run to run.
fn value(run: usize) -> impl Fn(Symbol) -> f64 {
    move |symbol| 0.35 + ((symbol.index() * 7919 + run * 104_729) % 1009) as f64 / 1009.0
}

/// Every function of the model at a few points against the graph.
pub(crate) fn check(equations: &Equations) -> Programs {
    let programs = programs(equations).expect("the functions read what they may");
    for run in 0..3 {
        let values = value(run);
        for program in programs.functions.iter().chain(&programs.charts) {
            let exact = equations.graph.evaluate(&program.entry.roots(), &values);
            let found = programs.evaluate(equations, &program.entry.name, &values).expect("a known function");
            for (k, (a, b)) in exact.iter().zip(&found).enumerate() {
                assert!(
                    (a - b).abs() <= 1e-11 * (1.0 + a.abs()),
                    "{} {}: {a} and {b}",
                    program.entry.name,
                    program.entry.labels()[k].0
                );
            }
        }
    }
    programs
}

/// The cost of a few expressions in m, l, g, x, y and dot_x.
fn cost(make: impl FnOnce(&mut Graph, &[Expr]) -> Vec<Expr>) -> Count {
    check(&outputs(make)).function("multipliers").expect("it exists").count
}

fn arithmetic(additions: usize, multiplications: usize, divisions: usize) -> Count {
    Count { additions, multiplications, divisions, ..Count::default() }
}

#[test]
fn programs_equal_their_expressions() {
    for equations in [pendulum(), disk(), disk_stage()] {
        check(&equations);
    }
}

/// A random graph over m, l, g, x, y and dot_x, nested, with everything that the language has.
fn random(seed: u64, g: &mut Graph, vars: &[Expr]) -> Vec<Expr> {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
    let mut draw = |n: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 33) as usize % n
    };
    let mut pool = vars.to_vec();
    for _ in 0..40 {
        let (a, b, c) = (pool[draw(pool.len())], pool[draw(pool.len())], pool[draw(pool.len())]);
        let one = g.one();
        let square = g.powi(a, 2);
        let positive = g.add(square, one);
        let factor = Rational::fraction(draw(9) as i64 - 4, draw(4) as i64 + 1).expect("a denominator");
        let new = match draw(12) {
            0 | 1 => g.add(a, b),
            2 => g.sub(a, b),
            3 | 4 => g.product(&[a, b]),
            5 => {
                let part = g.linear(Rational::ONE, &[(factor, b)]);
                g.product(&[a, part])
            }
            6 => g.linear(Rational::ZERO, &[(factor, a), (Rational::integer(2), b), (Rational::MINUS_ONE, c)]),
            7 => g.div(b, positive),
            8 => {
                let angle = g.linear(Rational::ZERO, &[(Rational::ONE, vars[3 + draw(2)]), (factor, vars[4])]);
                if draw(2) == 0 { g.sin(angle) } else { g.cos(angle) }
            }
            9 => g.sqrt(positive),
            10 => g.atan2(a, positive),
            _ => {
                // Kept small: nothing may overflow.
                let sine = g.sin(a);
                if draw(2) == 0 { g.exp(sine) } else { g.ln(positive) }
            }
        };
        // Values beyond a few thousand would lose digits in differences.
        let size = g.evaluate(&[new], &value(0))[0].abs();
        if size < 1e3 {
            pool.push(new);
        }
    }
    pool.split_off(pool.len() - 5)
}

#[test]
fn random_programs_equal_their_expressions() {
    for seed in 1..80 {
        check(&outputs(|g, vars| random(seed, g, vars)));
    }
}

#[test]
fn the_disk_is_cheap() {
    let programs = check(&disk());
    let derivative = programs.function("derivative").expect("it exists").count;
    // x, y: 3 + 2 for both; phi 1 (division); psi, and what v5 and v4 share: see the expansion.
    assert_eq!((derivative.operations(), derivative.divisions, derivative.sincos), (19, 1, 2));
    let stage = check(&disk_stage());
    let both = stage.function("mass_matrix_and_forcing").expect("it exists").count;
    assert_eq!((both.operations(), both.divisions, both.sincos), (19, 0, 1));
    let derivative = stage.function("derivative").expect("it exists").count;
    assert!(derivative.operations() <= 40 && derivative.sincos == 1, "{derivative:?}");
}

/// One state of the disk in both formulations, from a computation in 50-digit arithmetic that knows nothing of this
/// engine.
#[test]
fn the_disk_has_its_reference_values() {
    let close = |found: Vec<f64>, exact: &[f64]| {
        assert_eq!(found.len(), exact.len());
        for (a, b) in found.iter().zip(exact) {
            assert!((a - b).abs() <= 1e-13 * (1.0 + b.abs()), "{a} and {b}");
        }
    };
    let given = |equations: &Equations, values: &[(&str, f64)]| {
        let values: Vec<(String, f64)> = values.iter().map(|(n, x)| ((*n).to_owned(), *x)).collect();
        let graph = equations.graph.clone();
        move |s: Symbol| values.iter().find(|(n, _)| n == graph.name(s)).map_or(f64::NAN, |(_, x)| *x)
    };
    let parameters = [("m", 1.8125), ("r", 0.625), ("j", 0.7265625), ("g", 2.0625)];
    let angles = [("phi", 2.5), ("theta", 0.609375), ("psi", -0.65625)];

    let equations = disk();
    let speeds = [("v6", 1.8696988364731948), ("v5", -2.7162695434095876), ("v4", -1.90625)];
    let at = given(&equations, &[&parameters[..], &angles, &speeds].concat());
    let programs = programs(&equations).expect("the functions read what they may");
    let run = |name: &str| programs.evaluate(&equations, name, &at).expect("it exists");
    let rates = [1.8855040170587014, -1.4085135422759132, 0.0, -3.3125, 1.90625, 3.765625];
    let accelerations = [1.6963259794013925, -10.742336063277028, 9.326808291316457];
    close(run("derivative")[..6].to_vec(), &rates);
    close(run("accelerations"), &accelerations);
    close(run("multipliers"), &[3.9439579021082376, 2.9646171533294847, 6.952040872549438]);

    let equations = disk_stage();
    let speeds = [("omega1", -3.3125), ("omega2", 1.90625), ("omega3", 3.765625)];
    let at = given(&equations, &[&parameters[..], &angles, &speeds].concat());
    let programs = super::programs(&equations).expect("the functions read what they may");
    let run = |name: &str| programs.evaluate(&equations, name, &at).expect("it exists");
    let (m11, m13, m22, m33) = (1.1965138536644977, 1.23693531836227, 1.4345703125, 2.1611328125);
    let forcing = [-0.050403406977842936, -13.37996228510144, 14.856091156945174];
    close(run("mass_matrix_and_forcing")[..9].to_vec(), &[m11, 0.0, m13, 0.0, m22, 0.0, m13, 0.0, m33]);
    close(run("forcing"), &forcing);
    close(run("accelerations"), &[-17.507734169106833, -9.326808291316457, 16.894855181516675]);
}

#[test]
fn parameter_work_is_free() {
    // 2 m l x + m g: one product and one sum.
    let count = cost(|g, v| {
        let a = g.product(&[v[0], v[1], v[3]]);
        let a = g.scale(Rational::integer(2), a);
        let b = g.mul(v[0], v[2]);
        vec![g.add(a, b)]
    });
    assert_eq!(count, arithmetic(1, 1, 0));
    // (m x + l x) / g: one product.
    let count = cost(|g, v| {
        let a = g.mul(v[0], v[3]);
        let b = g.mul(v[1], v[3]);
        let sum = g.add(a, b);
        vec![g.div(sum, v[2])]
    });
    assert_eq!(count, arithmetic(0, 1, 0));
    // (m x + l y) / g: the divisor goes into both coefficients.
    let count = cost(|g, v| {
        let a = g.mul(v[0], v[3]);
        let b = g.mul(v[1], v[4]);
        let sum = g.add(a, b);
        vec![g.div(sum, v[2])]
    });
    assert_eq!(count, arithmetic(1, 2, 0));
}

#[test]
fn what_cancels_is_checked() {
    // (m x + l y) / m: the program has x + (l / m) y, and must still refuse m = 0.
    let equations = outputs(|g, v| {
        let a = g.mul(v[0], v[3]);
        let b = g.mul(v[1], v[4]);
        let sum = g.add(a, b);
        vec![g.div(sum, v[0])]
    });
    let programs = check(&equations);
    assert!(programs.values.guards.iter().any(|g| g.name == "m"));
    assert_eq!(programs.function("multipliers").expect("it exists").count, arithmetic(1, 1, 0));
}

#[test]
fn common_work_is_done_once() {
    // x y u and x y: two products.
    let count = cost(|g, v| vec![g.product(&[v[3], v[4], v[5]]), g.mul(v[3], v[4])]);
    assert_eq!(count, arithmetic(0, 2, 0));
    // x⁴ and x⁶: square, fourth power, and one more.
    let count = cost(|g, v| vec![g.powi(v[3], 4), g.powi(v[3], 6)]);
    assert_eq!(count, arithmetic(0, 3, 0));
    // x¹⁰⁰ by repeated squaring: 6 squares, 2 products.
    let count = cost(|g, v| vec![g.powi(v[3], 100)]);
    assert_eq!(count, arithmetic(0, 8, 0));
    // (x - y) u and (y - x)²: the difference once, its sign nowhere.
    let count = cost(|g, v| {
        let a = g.sub(v[3], v[4]);
        let b = g.neg(a);
        vec![g.mul(a, v[5]), g.powi(b, 2)]
    });
    assert_eq!(count, arithmetic(1, 2, 0));
    // m x + m y + m u and l x + l y: x + y once.
    let count = cost(|g, v| {
        let three: Vec<Expr> = [v[3], v[4], v[5]].iter().map(|e| g.mul(v[0], *e)).collect();
        let two: Vec<Expr> = [v[3], v[4]].iter().map(|e| g.mul(v[1], *e)).collect();
        vec![g.sum(&three), g.sum(&two)]
    });
    assert_eq!(count, arithmetic(2, 2, 0));
}

#[test]
fn divisors_are_inverted_once() {
    // x / y alone is a division; x / y and u / y share the reciprocal.
    assert_eq!(cost(|g, v| vec![g.div(v[3], v[4])]), arithmetic(0, 0, 1));
    assert_eq!(cost(|g, v| vec![g.div(v[3], v[4]), g.div(v[5], v[4])]), arithmetic(0, 2, 1));
    // 1 / y² is the square of the reciprocal that u / y needs.
    assert_eq!(cost(|g, v| vec![g.powi(v[4], -2), g.div(v[5], v[4])]), arithmetic(0, 2, 1));
    // u / (x y): one division.
    let count = cost(|g, v| {
        let below = g.mul(v[3], v[4]);
        vec![g.div(v[5], below)]
    });
    assert_eq!(count, arithmetic(0, 1, 1));
}

#[test]
fn angles_are_turned_once() {
    // sin, cos and tan of one angle.
    let count = cost(|g, v| vec![g.sin(v[3]), g.cos(v[3]), g.tan(v[3])]);
    assert_eq!(count, Count { divisions: 1, sincos: 1, ..Count::default() });
    // sin and cos of x, y, x + y and 2x: two calls; 4 + 2 for the sum, 4 + 1 for the double angle.
    let count = cost(|g, v| {
        let sum = g.add(v[3], v[4]);
        let double = g.scale(Rational::integer(2), v[3]);
        [v[3], v[4], sum, double].iter().flat_map(|a| [g.sin(*a), g.cos(*a)]).collect()
    });
    assert_eq!(count, Count { additions: 3, multiplications: 8, sincos: 2, ..Count::default() });
    // sin(x - y) alone stays a call of its own.
    let count = cost(|g, v| {
        let difference = g.sub(v[3], v[4]);
        vec![g.sin(difference)]
    });
    assert_eq!(count, Count { additions: 1, sincos: 1, ..Count::default() });
}

#[test]
fn roots_and_other_functions() {
    let count = cost(|g, v| {
        let squares: Vec<Expr> = [v[3], v[4]].iter().map(|e| g.powi(*e, 2)).collect();
        let sum = g.sum(&squares);
        let root = g.sqrt(sum);
        let ln = g.ln(root);
        vec![root, g.div(v[5], root), g.atan2(v[4], v[3]), g.exp(v[3]), ln]
    });
    assert_eq!(
        count,
        Count { additions: 1, multiplications: 2, divisions: 1, roots: 1, sincos: 0, selections: 0, others: 3 }
    );
}

#[test]
fn a_function_reads_only_what_it_may() {
    let mut equations = pendulum();
    equations.forcing = vec![equations.graph.var(equations.speeds[1])];
    let error = programs(&equations).unwrap_err();
    assert_eq!((error.function.as_str(), error.symbol.as_str()), ("forcing", "dot_y"));
}
