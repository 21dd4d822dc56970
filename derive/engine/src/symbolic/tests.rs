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

/// A rewrite is used where it is proven, left where it is only refused, and remembered where it is shown to be wrong.
#[test]
fn wrong_rewrites_are_remembered() {
    let (mut g, x, y, _) = three();
    let (x, y) = (g.var(x), g.var(y));
    let sine = g.sin(x);
    let square = g.powi(sine, 2);
    let cosine = g.cos(x);
    let other = g.powi(cosine, 2);
    let one = g.one();
    let rest = g.sub(one, other);
    assert!(g.proven(rest, square) && g.broken().is_none());
    // the angle's terms do not tell that it is y + x y
    let outer = g.add(one, x);
    let product = g.mul(y, outer);
    let whole = g.mul(x, y);
    let sum = g.add(y, whole);
    let (a, b) = (g.sin(product), g.sin(sum));
    assert!(!g.proven(a, b) && g.broken().is_none());
    assert!(!g.proven(other, square));
    assert_eq!(g.broken(), Some((square, other)));
    // the first one stays
    assert!(!g.proven(x, y));
    assert_eq!(g.broken(), Some((square, other)));
}

/// Decimals of four places are multiples of one angle.
#[test]
fn angles_with_decimals_are_related() {
    let (mut g, x, y, _) = three();
    let (x, y) = (g.var(x), g.var(y));
    let times = |g: &mut Graph, text: &str, e: Expr| {
        let number = Rational::parse(text).expect("a number");
        g.scale(number, e)
    };
    let (a, b) = (times(&mut g, "1.03", x), times(&mut g, "0.4704", y));
    let sum = g.add(a, b);
    let [(sin_a, cos_a), (sin_b, cos_b), (sin, _)] = [a, b, sum].map(|angle| (g.sin(angle), g.cos(angle)));
    let (first, second) = (g.mul(sin_a, cos_b), g.mul(cos_a, sin_b));
    let expanded = g.add(first, second);
    assert!(g.identical(sin, expanded));
    let (third, double) = (times(&mut g, "0.0331", x), times(&mut g, "0.0662", x));
    let (s, c, twice) = (g.sin(third), g.cos(third), g.sin(double));
    let product = g.mul(s, c);
    let product = times(&mut g, "2", product);
    assert!(g.identical(twice, product));
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

#[test]
fn the_functions_have_canonical_forms() {
    let (mut g, x, y, _) = three();
    let (x, y) = (g.var(x), g.var(y));
    let (difference, opposite) = (g.sub(x, y), g.sub(y, x));
    for function in [Function::Asin, Function::Atan, Function::Sinh, Function::Tanh, Function::Sign] {
        let (a, b) = (g.function(function, &[difference]), g.function(function, &[opposite]));
        let sum = g.add(a, b);
        assert!(g.is_zero(sum), "{}", function.name());
    }
    for function in [Function::Cosh, Function::Abs] {
        let (a, b) = (g.function(function, &[difference]), g.function(function, &[opposite]));
        assert_eq!(a, b, "{}", function.name());
    }
    let triple = g.scale(Rational::integer(-3), difference);
    let (a, b) = (g.abs(triple), g.abs(difference));
    assert_eq!(a, g.scale(Rational::integer(3), b));
    let one = g.one();
    let exact = [(Function::Asin, "PI/2"), (Function::Acos, "0"), (Function::Atan, "PI/4")];
    for (function, expected) in exact {
        let value = g.function(function, &[one]);
        assert_eq!(g.display(value), expected);
    }
    // Equal branches are one, a number decides, and min and max do not depend on the order.
    assert_eq!(g.select(x, y, y), y);
    let minus = g.integer(-2);
    assert_eq!(g.select(minus, x, y), x);
    assert_eq!(g.min(x, y), g.min(y, x));
    assert_eq!(g.max(x, y), g.max(y, x));
    let half = g.number(Rational::Small(3, 2));
    let (power, root) = (g.powf(x, half), g.sqrt(x));
    assert_eq!(power, g.mul(x, root));
    let choice = g.select(difference, x, y);
    assert_eq!(g.display(choice), "if x - y < 0 { x } else { y }");
}

#[test]
fn identities_of_the_functions_are_decided() {
    let (mut g, x, y, _) = three();
    let (x, y) = (g.var(x), g.var(y));
    let of = |g: &mut Graph, function: Function, e: Expr| g.function(function, &[e]);
    let (s, c) = (of(&mut g, Function::Sinh, x), of(&mut g, Function::Cosh, x));
    let (s2, c2) = (g.powi(s, 2), g.powi(c, 2));
    let difference = g.sub(c2, s2);
    assert!(g.identical(difference, g.one()) && !g.identical(c2, s2));
    let (tanh, quotient) = (of(&mut g, Function::Tanh, x), g.div(s, c));
    assert!(g.identical(tanh, quotient));
    let (asin, acos) = (of(&mut g, Function::Asin, x), of(&mut g, Function::Acos, x));
    let arcs = g.add(asin, acos);
    let quarter = g.scale(Rational::Small(1, 2), g.pi());
    assert!(g.identical(arcs, quarter) && !g.identical(asin, acos));
    let (atan, atan2) = (of(&mut g, Function::Atan, x), g.atan2(x, g.one()));
    assert!(g.identical(atan, atan2));
    // |x|² = x², and |x| is neither x nor -x, at whatever points.
    let (abs, x2) = (g.abs(x), g.powi(x, 2));
    let (abs2, root, minus) = (g.powi(abs, 2), g.sqrt(x2), g.neg(x));
    assert!(g.identical(abs2, x2) && g.identical(abs, root));
    assert!(!g.identical(abs, x) && !g.identical(abs, minus));
    let sign = g.sign(x);
    let product = g.mul(sign, abs);
    assert!(g.identical(product, x) && !g.identical(sign, g.one()));
    // x^y = e^(y ln x)
    let (power, ln) = (g.powf(x, y), g.ln(x));
    let exponent = g.mul(y, ln);
    let exponential = g.exp(exponent);
    assert!(g.identical(power, exponential) && !g.identical(power, x));
}

#[test]
fn selections_are_related_as_far_as_they_are_linear() {
    let (mut g, x, y, m) = three();
    let (x, y, m) = (g.var(x), g.var(y), g.var(m));
    let condition = g.sub(x, m);
    let choice = g.select(condition, x, y);
    let (scaled, mx, my) = (g.mul(m, choice), g.mul(m, x), g.mul(m, y));
    let inside = g.select(condition, mx, my);
    assert!(g.identical(scaled, inside) && !g.identical(choice, x) && !g.identical(choice, y));
    // min + max = a + b
    let (least, most) = (g.min(x, y), g.max(x, y));
    let (both, sum) = (g.add(least, most), g.add(x, y));
    assert!(g.identical(both, sum));
    // A condition that vanishes takes the second branch.
    let (s, c) = (g.sin(x), g.cos(x));
    let (s2, c2, one) = (g.powi(s, 2), g.powi(c, 2), g.one());
    let sum = g.sum(&[s2, c2]);
    let zero = g.sub(sum, one);
    let choice = g.select(zero, x, y);
    assert!(g.identical(choice, y));
}

#[test]
fn derivatives_of_the_functions_agree_with_differences() {
    let (mut g, xs, ys, _) = three();
    let (x, y) = (g.var(xs), g.var(ys));
    let half = g.scale(Rational::Small(1, 2), x);
    let mut parts: Vec<Expr> = [
        Function::Asin,
        Function::Acos,
        Function::Atan,
        Function::Sinh,
        Function::Cosh,
        Function::Tanh,
        Function::Abs,
        Function::Sign,
    ]
    .into_iter()
    .map(|function| g.function(function, &[half]))
    .collect();
    parts.push(g.powf(x, y));
    parts.push(g.powf(y, x));
    let (square, cube) = (g.powi(x, 2), g.powi(x, 3));
    let number = g.number(Rational::Small(1, 2));
    let condition = g.sub(x, number);
    parts.push(g.select(condition, square, cube));
    parts.push(g.min(square, y));
    parts.push(g.max(square, y));
    for at in [0.4, 1.1] {
        let values = |v: f64| move |s: Symbol| if s == xs { v } else { 0.7 };
        let h = 1e-5;
        for part in &parts {
            let slope = g.derivative(*part, xs);
            let exact = g.evaluate(&[slope], &values(at))[0];
            let numeric =
                (g.evaluate(&[*part], &values(at + h))[0] - g.evaluate(&[*part], &values(at - h))[0]) / (2.0 * h);
            assert!((numeric - exact).abs() < 1e-9, "{}: {numeric} {exact}", g.display(*part));
        }
    }
}

#[test]
fn functions_of_the_users_are_differentiated_order_by_order() {
    let (mut g, x, y, _) = three();
    let road = g.give(&["road".to_owned(), "slope".to_owned()]);
    let sum = g.linear(Rational::ZERO, &[(Rational::integer(2), g.var(x)), (Rational::ONE, g.var(y))]);
    let value = g.function(road, &[sum]);
    let first = g.derivative(value, x);
    assert_eq!(g.display(first), "2*slope(2*x + y)");
    assert!(g.given().iter().all(|given| !given.missing));
    let second = g.derivative(first, x);
    let given: Vec<_> = g.given_in(&[second]).into_iter().map(|at| g.given()[at].clone()).collect();
    assert!(matches!(given.as_slice(), [given] if given.missing && given.order == 2 && given.function == 0));
    // Decided by the argument's value, and no function is another.
    let (a, b) = (g.var(x), g.var(y));
    let (ab, ba) = (g.sub(a, b), g.sub(b, a));
    let (one, minus) = (g.function(road, &[ab]), g.neg(ba));
    let other = g.function(road, &[minus]);
    assert!(g.identical(one, other) && !g.identical(one, value) && !g.identical(first, value));
}

/// The rotation of a unit quaternion is orthogonal where the squares add up to one, and where they do not it is not.
#[test]
fn what_holds_on_the_sphere_is_identical() {
    let mut g = Graph::new();
    let symbols = ["a", "b", "c", "d"].map(|name| g.symbol(name, Kind::Coordinate));
    let product = |g: &mut Graph| {
        let [a, b, c, d] = symbols.map(|symbol| g.var(symbol));
        let squares = [a, b, c, d].map(|e| g.powi(e, 2));
        let sum = g.sum(&squares);
        // The first row of R by itself and by the second: (a² + b² - c² - d², 2 (b c - a d), 2 (b d + a c)).
        let (x, y) = (g.add(squares[0], squares[1]), g.add(squares[2], squares[3]));
        let along = g.sub(x, y);
        let (bc, ad, bd, ac) = (g.mul(b, c), g.mul(a, d), g.mul(b, d), g.mul(a, c));
        let (across, up) = (g.sub(bc, ad), g.add(bd, ac));
        let two = g.integer(2);
        let row = [along, g.mul(two, across), g.mul(two, up)];
        (sum, g.dot(&row, &row))
    };
    let (sum, length) = product(&mut g);
    let one = g.one();
    assert!(!g.identical(sum, one) && !g.identical(length, one));
    g.on_sphere(symbols);
    assert!(g.identical(sum, one) && g.identical(length, one));
    // Where roots occur, values in double precision have their say.
    let (more, two) = (g.add(sum, one), g.integer(2));
    let (root, expected, other) = (g.sqrt(more), g.sqrt(two), g.sqrt(sum));
    assert!(g.identical(root, expected) && !g.identical(root, other));
    let [a, b, ..] = symbols.map(|symbol| g.var(symbol));
    let part = g.mul(a, b);
    assert!(!g.identical(part, one) && !g.vanishes(part) && !g.identical(a, b));
}
