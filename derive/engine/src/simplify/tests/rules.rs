//! Each rule, alone and with its value in doubles.

use super::random::{Draw, assert_same_values};
use super::support::Names;
use crate::simplify::{Search, cost, simplify};
use crate::symbolic::{Expr, Kind};

fn names() -> Names {
    Names::new(&[("m J r", Kind::Parameter), ("a b x y z", Kind::Coordinate), ("u v w", Kind::Speed)])
}

/// Simplifies the roots, checks them, and returns them with the weight before and after.
fn checked(names: &mut Names, texts: &[&str]) -> (Vec<Expr>, usize, usize) {
    let roots: Vec<Expr> = texts.iter().map(|t| names.parse(t)).collect();
    let g = &mut names.graph;
    let out = simplify(g, &roots, Search::Full);
    assert_eq!(out.len(), roots.len());
    for (new, old) in out.iter().zip(&roots) {
        assert!(g.identical(*new, *old), "{} became {}", g.display(*old), g.display(*new));
    }
    assert_same_values(g, &roots, &out, &mut Draw(7));
    let (before, after) = (cost(g, &roots).weight(), cost(g, &out).weight());
    assert!(after <= before, "{before} {after}");
    (out, before, after)
}

/// The roots become exactly these.
fn becomes(texts: &[&str], expected: &[&str]) {
    let mut names = names();
    let (out, ..) = checked(&mut names, texts);
    for (e, text) in out.iter().zip(expected) {
        let expected = names.parse(text);
        assert_eq!(*e, expected, "{} instead of {text}", names.graph.display(*e));
    }
}

#[test]
fn squares_of_sine_and_cosine() {
    becomes(&["u*sin(a)^2 + u*cos(a)^2"], &["u"]);
    becomes(&["u - u*sin(a)^2"], &["u*cos(a)^2"]);
    becomes(&["m*u*cos(a)^2 - m*u"], &["0 - m*u*sin(a)^2"]);
    becomes(&["sin(a)^4 + 2*sin(a)^2*cos(a)^2 + cos(a)^4"], &["1"]);
    becomes(&["(sin(a)*cos(b))^2 + (sin(a)*sin(b))^2 + cos(a)^2"], &["1"]);
}

#[test]
fn common_factors() {
    becomes(&["x*y + x*z"], &["x*(y + z)"]);
    becomes(&["x*u + x*v + y*u + y*v"], &["(x + y)*(u + v)"]);
    becomes(&["m*r^2*u + J*u + 2*J*u"], &["(m*r^2 + 3*J)*u"]);
    becomes(&["x^3 + x^2 + x"], &["x*(1 + x*(1 + x))"]);
    becomes(&["u/x + v/x"], &["(u + v)/x"]);
}

#[test]
fn double_angles_go_where_the_angle_is() {
    let mut names = names();
    let (_, before, after) = checked(&mut names, &["u*sin(2*a) + v*cos(2*a)", "u*sin(a)", "v*cos(a)"]);
    assert!(after < before, "{before} {after}");
    let (out, ..) = checked(&mut names, &["u*cos(b)^2 - u*sin(b)^2", "sin(2*b)*v"]);
    assert!(!out.is_empty());
}

#[test]
fn sums_and_differences_of_angles() {
    becomes(&["u*cos(a)*cos(b) + u*sin(a)*sin(b)"], &["u*cos(a - b)"]);
    becomes(&["u*sin(a)*cos(b) - u*cos(a)*sin(b)"], &["u*sin(a - b)"]);
    becomes(&["sin(a)*cos(b) + cos(a)*sin(b)"], &["sin(a + b)"]);
    becomes(&["m*cos(a)*cos(b) - m*sin(a)*sin(b)"], &["m*cos(a + b)"]);
    becomes(&["J - J*(cos(a)*cos(b) + sin(a)*sin(b))^2"], &["J*sin(a - b)^2"]);
    // The double pendulum's mass matrix beside its gravity: the difference is shared and follows by products.
    let mut names = names();
    let texts = [
        "m*r^2*(cos(a)*cos(b) + sin(a)*sin(b))",
        "m*r^2*(sin(a)*cos(b) - cos(a)*sin(b))*u^2 - m*r*sin(b)",
        "m*r*sin(a)*v - m*r^2*u*(sin(a)*cos(b) - cos(a)*sin(b))",
    ];
    let (_, before, after) = checked(&mut names, &texts);
    assert!(after <= before, "{before} {after}");
}

#[test]
fn opposite_sums_are_shared() {
    let mut names = names();
    let (_, before, after) = checked(&mut names, &["x*y*u - z*w", "z*w - x*y*u"]);
    assert!(after <= before);
}

#[test]
fn nothing_cancels_without_a_reason() {
    let mut names = names();
    let texts = ["x*y/x", "sqrt(x^2)", "(x^2 + x*y)/(x + y)", "u/u - 1", "(x^2 - y^2)/(x - y)"];
    let (out, ..) = checked(&mut names, &texts);
    let g = &names.graph;
    for (e, at) in [(out[0], "x"), (out[2], "y"), (out[3], "u")] {
        let x = names_value(g, e, at);
        assert!(x.is_nan(), "{} is defined where the input was not", g.display(e));
    }
    assert!(names_value(g, out[4], "y").is_nan());
    assert_eq!(g.evaluate(&[out[1]], &|_| -2.0)[0], 2.0);
    assert_eq!(g.cancelled().count(), 0);
}

/// The value where the named symbol makes the texts of the test above undefined, other symbols being one.
fn names_value(g: &crate::symbolic::Graph, e: Expr, at: &str) -> f64 {
    let special = |name: &str| match (at, name) {
        ("y", "y") if g.display(e).contains("- y") || g.display(e).contains("y -") => 1.0,
        ("y", "y") => -1.0,
        (a, n) if a == n => 0.0,
        _ => 1.0,
    };
    g.evaluate(&[e], &|s| special(g.name(s)))[0]
}

#[test]
fn parameters_cancel_and_are_recorded() {
    let mut names = names();
    let (out, ..) = checked(&mut names, &["((m*r^2 + J)^2*x - (m*r^2 + J)*J*x)/(m*r^2 + J)"]);
    let expected = names.parse("m*r^2*x");
    assert_eq!(out, [expected]);
    let sum = names.parse("m*r^2 + J");
    assert!(names.graph.cancelled().any(|e| e == sum));
}

#[test]
fn assumed_bases_cancel() {
    let mut names = names();
    let base = names.parse("J + m*r^2*sin(a)^2");
    names.graph.assume_nonzero(base);
    let (out, ..) = checked(&mut names, &["(u*J + u*m*r^2 - u*m*r^2*cos(a)^2)/(J + m*r^2*sin(a)^2)"]);
    let u = names.parse("u");
    assert_eq!(out, [u]);
}
