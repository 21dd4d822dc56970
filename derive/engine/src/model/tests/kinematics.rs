use super::super::inverse::inverse;
use super::{InitialSystem, assert_matrix, assert_unit, parse, system};
use crate::symbolic::Matrix;

/// A model with these kinematics, in the coordinates x, y, z, a, b and the speeds u, v, w, p, q.
fn kinematics(n: usize, entries: &str) -> InitialSystem {
    let names = |names: [&str; 5]| names[..n].join(", ");
    let zeros = vec!["0"; n].join(", ");
    system(&format!(
        "#[coordinates({})] #[speeds({})] #[kinematics({entries})]
         #[inertia(diag({}))] #[forces({zeros})] struct Model {{ l: f64, k: f64 }}",
        names(["x", "y", "z", "a", "b"]),
        names(["u", "v", "w", "p", "q"]),
        zeros.replace('0', "1"),
    ))
}

/// A B = 1, B a0 + b0 = 0; the pivots as text.
fn checked(mut s: InitialSystem) -> (InitialSystem, Vec<String>) {
    let k = s.kinematics.clone();
    let product = k.b.mul(&mut s.graph, &k.a);
    assert_unit(&mut s, &product);
    for (moved, bias) in k.b.mul_vec(&mut s.graph, &k.a0).into_iter().zip(k.b0) {
        let rest = s.graph.add(moved, bias);
        assert!(s.graph.vanishes(rest));
    }
    let pivots = k.pivots.iter().map(|pivot| s.graph.display(*pivot)).collect();
    (s, pivots)
}

#[test]
fn either_direction_in_any_order() {
    let (mut s, pivots) = checked(kinematics(2, "v = dot(y)*2, u = cos(x)*dot(x) - dot(y) + t"));
    assert_eq!(pivots, ["cos(x)"]);
    let a = s.kinematics.a.clone();
    assert_matrix(&mut s, &a, &[&["1/cos(x)", "1/2/cos(x)"], &["0", "1/2"]]);
    let (s, pivots) = checked(kinematics(2, "dot(y) = v/l, dot(x) = u/cos(x) + k*t"));
    assert_eq!(pivots, ["cos(x)", "l"]);
    assert_eq!(s.graph.display(s.kinematics.b.get(0, 0)), "cos(x)");
}

#[test]
fn both_directions_are_compared() {
    let both = "u = cos(x)*dot(x) + 1, v = dot(y), dot(x) = (u - 1)/cos(x), dot(y) = v";
    let (_, pivots) = checked(kinematics(2, both));
    assert_eq!(pivots, ["cos(x)"]);
}

/// Linear is what is linear, however it is written.
#[test]
fn linearity_is_decided() {
    let disguised = "u = dot(x)*dot(x)/dot(x) + (powi(sin(dot(x)), 2) + powi(cos(dot(x)), 2))*y, v = dot(y)";
    let (mut s, _) = checked(kinematics(2, disguised));
    let (b, b0) = (s.kinematics.b.clone(), s.kinematics.b0.clone());
    assert_matrix(&mut s, &b, &[&["1", "0"], &["0", "1"]]);
    super::assert_all(&mut s, &b0, &["y", "0"]);
}

/// Blocks with orthogonal rows or columns are divided by their norms only, others by their determinant.
#[test]
fn divisors_are_few() {
    let polar = "dot(x) = u*cos(a) - v*l*sin(a), dot(y) = u*sin(a) + v*l*cos(a), dot(z) = w, dot(a) = p + u";
    let (_, pivots) = checked(kinematics(4, polar));
    assert_eq!(pivots, ["l"]);
    let skew = "u = cos(x)*dot(x) + sin(y)*dot(y), v = sin(x)*dot(x) - cos(y)*dot(y)";
    let (_, pivots) = checked(kinematics(2, skew));
    assert_eq!(pivots.len(), 1, "{pivots:?}");
    let three = "u = dot(x) + k*dot(y), v = dot(y) + l*dot(z), w = dot(z) + k*dot(x)";
    let (_, pivots) = checked(kinematics(3, three));
    assert_eq!(pivots.len(), 1, "{pivots:?}");
}

/// Beyond three rows in a block: constant pivots first, the rest as a whole.
#[test]
fn large_blocks_are_eliminated() {
    let ring = "u = dot(x) + k*dot(y), v = dot(y) + k*dot(z), w = dot(z) + k*dot(a), p = dot(a) + k*dot(b), \
                q = dot(b) + cos(x)*dot(x)";
    let (_, pivots) = checked(kinematics(5, ring));
    assert_eq!(pivots.len(), 1, "{pivots:?}");
    let s = &mut kinematics(1, "u = dot(x)");
    let entries = ["2", "x", "1", "l", "1", "k", "x", "3", "sin(x)", "1", "l", "1", "1", "2", "x", "t"];
    let entries: Vec<_> = entries.iter().map(|text| parse_in(s, text)).collect();
    let matrix = Matrix::from_rows(entries.chunks(4).map(<[_]>::to_vec).collect(), 4);
    let found = inverse(&mut s.graph, &matrix).ok().unwrap();
    let product = matrix.mul(&mut s.graph, &found.matrix);
    assert_unit(s, &product);
}

fn parse_in(s: &mut InitialSystem, text: &str) -> crate::symbolic::Expr {
    parse(s, text)
}
