use super::*;

fn three() -> (Graph, Symbol, Symbol, Symbol) {
    let mut g = Graph::new();
    let x = g.symbol("x", Kind::Coordinate);
    let y = g.symbol("y", Kind::Coordinate);
    let m = g.symbol("m", Kind::Parameter);
    (g, x, y, m)
}

#[test]
fn like_terms_and_powers_are_collected() {
    let (mut g, x, y, _) = three();
    let (x, y) = (g.var(x), g.var(y));
    let two_x = g.add(x, x);
    let back = g.sub(two_x, x);
    assert_eq!(back, x);
    let (xy, yx) = (g.mul(x, y), g.mul(y, x));
    assert_eq!(xy, yx);
    let (sum, minus) = (g.sub(x, y), g.sub(y, x));
    let (a, b) = (g.mul(sum, x), g.mul(minus, x));
    let total = g.add(a, b);
    assert!(g.is_zero(total), "(x-y)x + (y-x)x = {}", g.display(total));
}

#[test]
fn a_quotient_cancels_only_with_a_reason() {
    let (mut g, x, _, m) = three();
    let (x, m) = (g.var(x), g.var(m));
    let q = g.div(x, x);
    assert!(!g.is_one(q));
    let q = g.div(m, m);
    assert!(g.is_one(q) && g.cancelled().eq([m]));
    let c = g.cos(x);
    g.assume_nonzero(c);
    let t = g.tan(x);
    let s = g.mul(t, c);
    let sin = g.sin(x);
    assert_eq!(s, sin);
}

#[test]
fn sines_are_canonical() {
    let (mut g, x, y, _) = three();
    let (x, y) = (g.var(x), g.var(y));
    let quarter = g.scale(Rational::fraction(1, 2).unwrap(), g.pi());
    let minus = g.sub(y, x);
    let plus = g.sub(x, y);
    let (a, b) = (g.sin(minus), g.sin(plus));
    let sum = g.add(a, b);
    assert!(g.is_zero(sum));
    for turns in -5i64..6 {
        for (start, sign) in [(x, 1.0), (plus, 1.0)] {
            let shift = g.scale(Rational::integer(turns), quarter);
            let angle = g.add(start, shift);
            let negative = g.neg(angle);
            for (e, expected) in [
                (g.sin(angle), (0.3 + turns as f64 * std::f64::consts::FRAC_PI_2).sin()),
                (g.cos(negative), (0.3 + turns as f64 * std::f64::consts::FRAC_PI_2).cos()),
            ] {
                let values = |s: Symbol| if g.name(s) == "x" { if start == x { 0.3 } else { 0.5 } } else { 0.2 };
                let value = g.evaluate(&[e], &values)[0];
                assert!((value - sign * expected).abs() < 1e-12, "{turns} {}", g.display(e));
            }
        }
    }
}

#[test]
fn identities_are_decided() {
    let (mut g, x, y, m) = three();
    let (x, y, m) = (g.var(x), g.var(y), g.var(m));
    let (s, c) = (g.sin(x), g.cos(x));
    let (s2, c2) = (g.powi(s, 2), g.powi(c, 2));
    let one = g.add(s2, c2);
    assert!(!g.is_one(one) && g.identical(one, g.one()));
    let almost = g.linear(Rational::ZERO, &[(Rational::ONE, s2), (Rational::parse("1.0000000001").unwrap(), c2)]);
    assert!(!g.identical(almost, g.one()));
    // sin(2x - y/3) against the expanded form
    let third = g.scale(Rational::fraction(1, 3).unwrap(), y);
    let angle = g.linear(Rational::ZERO, &[(Rational::integer(2), x), (Rational::MINUS_ONE, third)]);
    let left = g.sin(angle);
    let (sd, cd) = (g.product(&[s, c]), g.sub(c2, s2));
    let (st, ct) = (g.sin(third), g.cos(third));
    let a = g.power_product(Rational::integer(2), &[(sd, 1), (ct, 1)]);
    let b = g.mul(cd, st);
    let right = g.sub(a, b);
    assert!(g.identical(left, right));
    // a quotient, expanded
    let sum = g.add(x, m);
    let square = g.powi(sum, 2);
    let quotient = g.div(square, sum);
    assert!(g.identical(quotient, sum));
    // exponentials multiply
    let (ex, ey, exy) = (g.function(Function::Exp, &[x]), g.function(Function::Exp, &[y]), g.add(x, y));
    let (product, of_sum) = (g.mul(ex, ey), g.function(Function::Exp, &[exy]));
    assert!(g.identical(product, of_sum));
}

#[test]
fn roots_keep_their_branch() {
    let (mut g, x, y, _) = three();
    let (x, y) = (g.var(x), g.var(y));
    let x2 = g.powi(x, 2);
    let y2 = g.powi(y, 2);
    let root = g.sqrt(x2);
    assert!(!g.identical(root, x));
    let minus = g.neg(x);
    assert!(!g.identical(root, minus));
    let norm2 = g.add(x2, y2);
    let norm = g.sqrt(norm2);
    let inverse = g.powi(norm, -1);
    let a = g.mul(inverse, norm2);
    assert!(g.identical(a, norm));
}

#[test]
fn derivatives_agree_with_differences() {
    let (mut g, x, y, m) = three();
    let (xe, ye, me) = (g.var(x), g.var(y), g.var(m));
    let t1 = g.tan(xe);
    let p = g.mul(xe, ye);
    let t2 = g.function(Function::Exp, &[p]);
    let q = g.powi(xe, 2);
    let q = g.add(q, me);
    let t3 = g.function(Function::Ln, &[q]);
    let t4 = g.sqrt(q);
    let t5 = g.atan2(ye, xe);
    let t6 = g.powi(q, -3);
    let e = g.product(&[t1, t3, t5]);
    let e = g.sum(&[e, t2, t4, t6]);
    let d = g.derivative(e, x);
    let at = |v: f64| {
        move |s: Symbol| {
            if s == x {
                v
            } else if s == y {
                0.7
            } else {
                1.3
            }
        }
    };
    let h = 1e-5;
    let numeric = (g.evaluate(&[e], &at(0.4 + h))[0] - g.evaluate(&[e], &at(0.4 - h))[0]) / (2.0 * h);
    let exact = g.evaluate(&[d], &at(0.4))[0];
    assert!((numeric - exact).abs() < 1e-8, "{numeric} {exact}");
}

#[test]
fn deep_expressions_need_no_stack() {
    let (mut g, x, _, _) = three();
    let xs = x;
    let x = g.var(x);
    let mut e = x;
    for _ in 0..100_000 {
        let s = g.sin(e);
        e = g.add(s, x);
    }
    let d = g.derivative(e, xs);
    assert!(!g.identical(d, e));
    assert!(g.evaluate(&[d], &|_| 0.3)[0].is_finite());
    assert!(g.display(e).len() < 2000);
}

#[test]
fn text_reads_as_written() {
    let (mut g, x, y, m) = three();
    let (x, y, m) = (g.var(x), g.var(y), g.var(m));
    let d = g.sub(x, y);
    let e = g.mul(m, d);
    let two = g.powi(x, 2);
    let e = g.sub(two, e);
    let h = g.scale(Rational::fraction(-1, 2).unwrap(), e);
    assert_eq!(g.display(h), "m*(x - y)/2 - powi(x, 2)/2");
    let q = g.div(m, d);
    assert_eq!(g.display(q), "m/(x - y)");
}

#[test]
fn the_content_of_a_long_sum_is_taken_out() {
    let mut g = Graph::new();
    let symbols: Vec<Symbol> = (0..40).map(|i| g.symbol(&format!("x{i}"), Kind::Coordinate)).collect();
    let x = g.vars(&symbols);
    let terms: Vec<_> = x.iter().map(|e| (Rational::integer(2), *e)).collect();
    let (long, half) = (g.linear(Rational::ZERO, &terms), g.sum(&x));
    let (a, b) = (g.mul(long, x[0]), g.mul(half, x[0]));
    let twice = g.scale(Rational::integer(2), b);
    assert_eq!(a, twice);
}
