//! The general form against the full system (2.8), and its losses.

use super::*;
use nalgebra::{DMatrix, DVector};

/// Figures between −1 and 1 that look random.
fn figures(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// v̇ of `[M, −Cᵀ; C, 0] [v̇; λ] = [h; −c]`, of least norm in λ.
fn full(c: &DMatrix<f64>, mass: &DMatrix<f64>, bias: &[f64], force: &[f64]) -> DVector<f64> {
    let (m, n) = c.shape();
    let mut matrix = DMatrix::zeros(n + m, n + m);
    matrix.view_mut((0, 0), (n, n)).copy_from(mass);
    matrix.view_mut((0, n), (n, m)).copy_from(&-c.transpose());
    matrix.view_mut((n, 0), (m, n)).copy_from(c);
    let right = DVector::from_iterator(n + m, force.iter().copied().chain(bias.iter().map(|b| -b)));
    matrix.svd(true, true).solve(&right, 1e-11).unwrap().rows(0, n).into_owned()
}

fn filled(c: &DMatrix<f64>, mass: &DMatrix<f64>) -> Tangent {
    let (m, n) = c.shape();
    let mut tangent = Tangent::new(n, m);
    tangent.rows.copy_from_slice(c.transpose().as_slice());
    tangent.mass.copy_from_slice(mass.as_slice());
    tangent
}

/// Random rows in n velocities; the inertia misses `massless` directions; `repeated` rows are combinations of the others.
fn agrees(n: usize, rows: usize, repeated: usize, massless: usize, seed: u64) {
    let mut figure = figures(seed);
    let root = DMatrix::from_fn(n - massless, n, |i, j| 0.4 * figure() + if i == j { 1.0 } else { 0.0 });
    let mass = root.transpose() * root;
    let independent = DMatrix::from_fn(rows, n, |_, _| figure());
    let mix = DMatrix::from_fn(repeated, rows, |_, _| figure());
    let mut c = DMatrix::zeros(rows + repeated, n);
    c.rows_mut(0, rows).copy_from(&independent);
    c.rows_mut(rows, repeated).copy_from(&(&mix * &independent));
    let bias = DVector::from_fn(rows, |_, _| figure());
    let bias: Vec<f64> = bias.iter().copied().chain((mix * &bias).iter().copied()).collect();
    let force: Vec<f64> = (0..n).map(|_| figure()).collect();
    let mut tangent = filled(&c, &mass);
    tangent.decompose(Some(rows), 1e-10).unwrap();
    let mut found = vec![0.0; n];
    tangent.solve(&bias, &force, &mut found);
    let expected = full(&c, &mass, &bias, &force);
    let size = expected.amax().max(1.0);
    for (found, expected) in found.iter().zip(expected.iter()) {
        assert!((found - expected).abs() < 1e-9 * size, "{n} {rows} {repeated} {massless} {seed}: {found} {expected}");
    }
}

#[test]
fn the_general_form_agrees_with_the_full_system() {
    for seed in 1..40 {
        agrees(5, 2, 0, 0, seed);
        agrees(5, 2, 1, 0, seed);
        agrees(6, 3, 2, 2, seed);
        agrees(4, 4, 1, 0, seed);
        agrees(3, 0, 0, 0, seed);
    }
}

#[test]
fn units_do_not_matter() {
    // The same system in millimetres and tonnes.
    let mut figure = figures(7);
    let root = DMatrix::from_fn(4, 4, |_, _| figure());
    let (mass, c) = (root.transpose() * root, DMatrix::from_fn(2, 4, |_, _| figure()));
    let units = [1e-6, 1.0, 1e4, 1e9];
    let scaled_mass = DMatrix::from_fn(4, 4, |i, j| mass[(i, j)] / units[i] / units[j]);
    let scaled_c = DMatrix::from_fn(2, 4, |i, j| c[(i, j)] / units[j] * [1e8, 1e-7][i]);
    let (mut a, mut b) = (filled(&c, &mass), filled(&scaled_c, &scaled_mass));
    a.decompose(Some(2), 1e-10).unwrap();
    b.decompose(Some(2), 1e-10).unwrap();
    let (mut plain, mut scaled) = ([0.0; 4], [0.0; 4]);
    a.solve(&[0.3, -0.2], &[1.0, 2.0, 3.0, 4.0], &mut plain);
    b.solve(&[0.3e8, -0.2e-7], &[1.0 / 1e-6, 2.0, 3.0 / 1e4, 4.0 / 1e9], &mut scaled);
    for i in 0..4 {
        assert!((scaled[i] / units[i] - plain[i]).abs() < 1e-11 * plain[i].abs().max(1.0), "{i}");
    }
}

#[test]
fn losses_name_their_rows_and_their_figure() {
    let mass = DMatrix::identity(3, 3);
    let c = DMatrix::from_row_slice(3, 3, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 2.0, 0.0, 1e-13]);
    let loss = filled(&c, &mass).decompose(Some(3), 1e-10).unwrap_err();
    assert!(matches!(loss, Loss::Rank { ref rows, pivot } if *rows == [0, 2] && pivot < 1e-12), "{loss:?}");
    // A row that vanishes depends on nothing else.
    let c = DMatrix::from_row_slice(2, 3, &[1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    let loss = filled(&c, &mass).decompose(Some(2), 1e-10).unwrap_err();
    assert_eq!(loss, Loss::Rank { rows: vec![1], pivot: 0.0 });
    // Without inertia along the second velocity, which no row binds.
    let mass = DMatrix::from_diagonal(&DVector::from_row_slice(&[1.0, 0.0, 1.0]));
    let c = DMatrix::from_row_slice(1, 3, &[1.0, 0.0, 0.0]);
    assert!(matches!(filled(&c, &mass).decompose(Some(1), 1e-10), Err(Loss::Inertia { .. })));
    let c = DMatrix::from_row_slice(1, 3, &[0.0, 1.0, 0.0]);
    assert_eq!(filled(&c, &mass).decompose(Some(1), 1e-10), Ok(()));
}

#[test]
fn without_forces_the_change_is_the_least_one_in_the_kinetic_metric() {
    let mass = DMatrix::from_diagonal(&DVector::from_row_slice(&[1.0, 4.0]));
    let c = DMatrix::from_row_slice(1, 2, &[1.0, 1.0]);
    let mut tangent = filled(&c, &mass);
    tangent.decompose(None, 1e-7).unwrap();
    let mut change = [0.0; 2];
    tangent.solve(&[5.0], &[0.0, 0.0], &mut change);
    // M⁻¹ Cᵀ ∝ (1, 1/4)
    assert!((change[0] + 4.0).abs() < 1e-14 && (change[1] + 1.0).abs() < 1e-14, "{change:?}");
}

#[test]
fn rows_that_turn_over_are_told() {
    let mass = DMatrix::identity(3, 3);
    let decomposed = |c: &[f64]| {
        let mut tangent = filled(&DMatrix::from_row_slice(2, 3, c), &mass);
        tangent.decompose(Some(2), 1e-10).unwrap();
        tangent
    };
    let first = decomposed(&[1.0, 0.2, 0.0, 0.3, 2.0, 0.5]);
    let span = first.span();
    assert!(first.compare(&span).0 > 0.0 && (first.compare(&span).1 - 1.0).abs() < 1e-14);
    // The rows move, and exchange their rôles as pivots: nothing turns over.
    let moved = decomposed(&[8.0, 0.1, 0.3, 0.2, 1.0, 0.6]);
    let (sign, cosine) = moved.compare(&span);
    assert!(sign > 0.0 && (0.5..1.0).contains(&cosine), "{sign} {cosine}");
    // The second row passes zero, and comes out on the other side.
    let turned = decomposed(&[8.0, 0.1, 0.3, -0.02, -0.1, -0.06]);
    assert!(turned.compare(&span).0 < 0.0 && turned.turned(&span) == [1]);
}
