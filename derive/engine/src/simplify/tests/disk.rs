//! The rolling disk's pieces (Blajer 1992, section 6, as corrected).

use super::random::{Draw, assert_same_values};
use super::support::Names;
use crate::simplify::{Search, cost, normalise, simplify};
use crate::symbolic::{Expr, Kind, Matrix};

fn disk() -> Names {
    let mut names = Names::new(&[
        ("m r J g", Kind::Parameter),
        ("phi theta psi", Kind::Coordinate),
        ("w1 w2 w3 v1 v2 v3 v4 v5 v6", Kind::Speed),
    ]);
    let c = names.parse("cos(theta)");
    names.graph.assume_nonzero(c);
    names
}

fn matrix(names: &mut Names, rows: &[&[&str]]) -> Matrix {
    let rows: Vec<Vec<Expr>> = rows.iter().map(|row| row.iter().map(|e| names.parse(e)).collect()).collect();
    let columns = rows[0].len();
    Matrix::from_rows(rows, columns)
}

/// B of (6.3): v in terms of the rates of (x, y, z, phi, theta, psi) of the contact point.
fn kinematic_matrix(names: &mut Names) -> Matrix {
    matrix(
        names,
        &[
            &["cos(phi)", "sin(phi)", "0", "0-r*sin(theta)", "0", "0"],
            &["0-sin(phi)*sin(theta)", "cos(phi)*sin(theta)", "cos(theta)", "0", "0", "0"],
            &["sin(phi)*cos(theta)", "0-cos(phi)*cos(theta)", "sin(theta)", "0", "0-r", "0"],
            &["0", "0", "0", "0", "0-1", "0"],
            &["0", "0", "0", "cos(theta)", "0", "0"],
            &["0", "0", "0", "sin(theta)", "0", "1"],
        ],
    )
}

/// Each entry normalised, with the cost of all before and after.
fn normalised(names: &mut Names, entries: &[Expr]) -> (Vec<Expr>, usize, usize) {
    let g = &mut names.graph;
    let out: Vec<Expr> = entries.iter().map(|e| normalise(g, *e)).collect();
    (out.clone(), cost(g, entries).weight(), cost(g, &out).weight())
}

fn assert_entries(names: &mut Names, entries: &[Expr], expected: &[&str]) {
    for (e, text) in entries.iter().zip(expected) {
        let expected = names.parse(text);
        assert_eq!(*e, expected, "{} instead of {text}", names.graph.display(*e));
    }
    assert_eq!(entries.len(), expected.len());
}

/// M_d of the five coordinates (6.17), normalised, and B without the third column.
fn five_coordinates(names: &mut Names) -> (Matrix, Matrix) {
    let b = kinematic_matrix(names);
    let b = Matrix::from_fn(6, 5, |i, j| b.get(i, if j < 2 { j } else { j + 1 }));
    let diagonal: Vec<Expr> = ["m", "m", "m", "J", "J", "2*J"].iter().map(|e| names.parse(e)).collect();
    let zero = names.graph.zero();
    let inertia = Matrix::from_fn(6, 6, |i, j| if i == j { diagonal[i] } else { zero });
    let mb = inertia.mul(&mut names.graph, &b);
    let md = b.transpose().mul(&mut names.graph, &mb);
    (md, b)
}

#[test]
fn the_mass_matrix_of_five_coordinates() {
    let mut names = disk();
    let (md, _) = five_coordinates(&mut names);
    let (md, before, after) = normalised(&mut names, md.entries());
    assert_entries(
        &mut names,
        &[md[0], md[1], md[2], md[3], md[12], md[14], md[18], md[24]],
        &[
            "m",
            "0",
            "0-m*r*sin(theta)*cos(phi)",
            "0-m*r*cos(theta)*sin(phi)",
            "(m*r^2+J)*sin(theta)^2+J",
            "2*J*sin(theta)",
            "m*r^2+J",
            "2*J",
        ],
    );
    assert!(before == 72 && after <= 42, "{before} {after}");
}

#[test]
fn the_mass_matrix_of_three_speeds() {
    let mut names = disk();
    let (md, _) = five_coordinates(&mut names);
    // u = D^T w (6.24): no slip, x' = -r psi' cos phi and y' = -r psi' sin phi.
    let d = matrix(
        &mut names,
        &[&["0", "0", "1", "0", "0"], &["0", "0", "0", "1", "0"], &["0-r*cos(phi)", "0-r*sin(phi)", "0", "0", "1"]],
    );
    let dm = d.mul(&mut names.graph, &md);
    let mw = dm.mul(&mut names.graph, &d.transpose());
    let (mw, before, after) = normalised(&mut names, mw.entries());
    // (6.27) corrected
    let expected = [
        "(m*r^2+J)*sin(theta)^2+J",
        "0",
        "(m*r^2+2*J)*sin(theta)",
        "0",
        "m*r^2+J",
        "0",
        "(m*r^2+2*J)*sin(theta)",
        "0",
        "m*r^2+2*J",
    ];
    assert_entries(&mut names, &mw, &expected);
    assert!(before >= 80 && after <= 19, "{before} {after}");
    // The Schur complement after the elimination of psi.
    let g = &mut names.graph;
    let l = g.div(mw[2], mw[8]);
    let t = g.mul(l, mw[2]);
    let schur = g.sub(mw[0], t);
    let (schur, ..) = normalised(&mut names, &[schur]);
    assert_entries(&mut names, &schur, &["J*cos(theta)^2"]);
    let pivot = names.parse("m*r^2+2*J");
    assert!(names.graph.cancelled().any(|e| e == pivot), "prepare must check the pivot");
}

#[test]
fn the_elimination_in_the_other_order() {
    let mut names = disk();
    let d = names.parse("(m*r^2+J)*sin(theta)^2+J");
    names.graph.assume_nonzero(d);
    let e = names.parse("m*r^2+2*J - ((m*r^2+2*J)*sin(theta))^2/((m*r^2+J)*sin(theta)^2+J)");
    let (e, before, after) = normalised(&mut names, &[e]);
    assert_entries(&mut names, &e, &["J*(m*r^2+2*J)*cos(theta)^2/((m*r^2+J)*sin(theta)^2+J)"]);
    assert!(after <= before, "{before} {after}");
}

#[test]
fn velocities_of_the_contact_point() {
    // x' = A v of (6.2) where the disk rolls: v1 = -r v6, v2 = 0, v3 = r v4.
    let mut names = disk();
    let e = names
        .parse("cos(phi)*(0-r*v6) + sin(phi)*cos(theta)*r*v4 + r*tan(theta)*cos(phi)*v5 - r*cos(theta)*sin(phi)*v4");
    let (e, ..) = normalised(&mut names, &[e]);
    assert_entries(&mut names, &e, &["r*cos(phi)*(v5*tan(theta) - v6)"]);
    let e = names.parse("sin(theta)*cos(theta)*v3 + cos(theta)^2*v2*tan(theta) - sin(theta)*cos(theta)*r*v4 + sin(theta)^2*v5/cos(theta) + cos(theta)*v5");
    let (e, before, after) = normalised(&mut names, &[e]);
    assert_entries(&mut names, &e, &["sin(theta)*cos(theta)*(v2+v3-r*v4) + v5/cos(theta)"]);
    assert!(after < before);
}

/// The accelerations of the three speeds by elimination of psi, theta, phi in turn, with (6.27) and (6.28).
fn accelerations(names: &mut Names) -> Vec<Expr> {
    let h = [
        "0-2*(m*r^2+J)*w1*w2*sin(theta)*cos(theta) - 2*J*w2*w3*cos(theta)",
        "(m*r^2+J)*w1^2*sin(theta)*cos(theta) + (m*r^2+2*J)*w1*w3*cos(theta) + m*g*r*sin(theta)",
        "0-2*(m*r^2+J)*w1*w2*cos(theta)",
    ]
    .map(|text| names.parse(text));
    let [a, b, d, e] =
        ["(m*r^2+J)*sin(theta)^2+J*(sin(theta)^2+cos(theta)^2)", "(m*r^2+2*J)*sin(theta)", "m*r^2+2*J", "m*r^2+J"]
            .map(|t| names.parse(t));
    let g = &mut names.graph;
    let l = g.div(b, d);
    let (lb, lh) = (g.mul(l, b), g.mul(l, h[2]));
    let (pivot, right) = (g.sub(a, lb), g.sub(h[0], lh));
    let pivot = normalise(g, pivot);
    g.assume_nonzero(pivot);
    let x = g.div(right, pivot);
    let bx = g.mul(b, x);
    let rest = g.sub(h[2], bx);
    vec![x, g.div(h[1], e), g.div(rest, d)]
}

#[test]
fn the_accelerations_of_the_disk() {
    let mut names = disk();
    let roots = accelerations(&mut names);
    let g = &mut names.graph;
    let before = cost(g, &roots);
    let out = simplify(g, &roots, Search::Full);
    let after = cost(g, &out);
    assert!(out.iter().zip(&roots).all(|(a, b)| g.identical(*a, *b)));
    assert_same_values(g, &roots, &out, &mut Draw(3));
    assert_eq!(g.display(out[0]), "-2*w2*w3/cos(theta)");
    assert!(after.operations() <= 19 && after.sincos == 1, "{before:?} -> {after:?}");
}

#[test]
fn the_same_input_gives_the_same_forms() {
    // Every hash map of the standard library has an order of its own, so one process is enough to see it.
    let texts: Vec<Vec<String>> = (0..3)
        .map(|_| {
            let mut names = disk();
            let roots = accelerations(&mut names);
            let (md, _) = five_coordinates(&mut names);
            let roots: Vec<Expr> = roots.into_iter().chain(md.entries().to_vec()).collect();
            let out = simplify(&mut names.graph, &roots, Search::Full);
            out.iter().map(|e| format!("{} {}", e.index(), names.graph.display(*e))).collect()
        })
        .collect();
    assert_eq!(texts[0], texts[1]);
    assert_eq!(texts[0], texts[2]);
}

#[test]
fn large_and_deep_expressions_stay_within_the_bounds() {
    let mut names = disk();
    let (mut e, x) = (names.parse("w1"), names.parse("theta"));
    let g = &mut names.graph;
    for _ in 0..5_000 {
        let sine = g.sin(e);
        e = g.add(sine, x);
    }
    let mut fraction = names.parse("w2");
    let y = names.parse("w3 + psi");
    let g = &mut names.graph;
    for _ in 0..5_000 {
        let below = g.div(y, fraction);
        fraction = g.add(below, x);
    }
    let sum = names.parse("w1 + w2 + w3 + v1 + v2 + v3 + v4 + v5 + v6 + sin(phi)");
    let g = &mut names.graph;
    let (power, product) = (g.powi(sum, 30), g.product(&[sum, fraction]));
    let roots = [e, fraction, power, product];
    let out = simplify(g, &roots, Search::Full);
    assert!(cost(g, &out).weight() <= cost(g, &roots).weight());
    assert_eq!(normalise(g, power), power);
}
