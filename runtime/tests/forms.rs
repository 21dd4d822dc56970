//! The unreduced forms against each other and against the reduced equations.

mod models;

use holonomy::Error;
use holonomy::prelude::*;
use models::*;
use nalgebra::DMatrix;

/// A complement from the constraint's row itself, for x and v off the manifold.
fn complement(c: &DMatrix<f64>) -> DMatrix<f64> {
    DMatrix::from_row_slice(1, 2, &[-c[(0, 1)], c[(0, 0)]])
}

#[test]
fn all_forms_agree_off_the_manifold() {
    let model = Bead { m: 1.5, w: 0.8, g: 9.81 }.prepare().unwrap();
    for (t, x, v) in [(0.0, [1.0, 2.0], [0.1, -0.3]), (2.0, [-0.4, 0.3], [5.0, 0.0])] {
        let v: BeadVelocities = v.into();
        let full = model.initial_equations(t, &x, &v, &[]);
        let d = complement(&full.constraint_matrix);
        let (rates, lambda) = full.solve().unwrap();
        assert!((&rates - full.tangent_rates(&d).unwrap()).amax() < 1e-12);
        assert!((&rates - full.tangent_rates(&(&d * -7.0)).unwrap()).amax() < 1e-12);
        assert!((&lambda - full.multipliers().unwrap()).amax() < 1e-12);
        // M v̇ = h* + Σ r_i*, C v̇ + c0* = 0
        let reactions = full.reactions(&lambda).unwrap();
        let balance = &full.inertia * &rates - &full.forces - reactions.column_sum();
        assert!(balance.amax() < 1e-12);
        assert!((&full.constraint_matrix * &rates + &full.constraint_bias).amax() < 1e-12);
        assert_eq!(full.coordinate_rates().as_slice(), <[f64; 2]>::from(v));
    }
}

#[test]
fn the_metric_is_block_diagonal() {
    let model = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap();
    let s = PendulumState { x: 0.3, y: -0.4, dot_x: 0.7 };
    let full = model.initial_equations_at(0.0, &s, &[]);
    let d = model.complement_at(0.0, &s);
    let metric = full.metric(&d).unwrap();
    assert!((metric[(0, 0)] - full.constraint_metric().unwrap()[(0, 0)]).abs() < 1e-14);
    assert!((metric[(1, 1)] - full.tangent_metric(&d).unwrap()[(0, 0)]).abs() < 1e-14);
    assert!((metric[(1, 1)] - model.mass_matrix(0.0, &s).entry(0, 0)).abs() < 1e-14);
    assert!(metric[(0, 1)].abs() < 1e-15 && metric[(1, 0)].abs() < 1e-15);
}

#[test]
fn the_reduced_equations_solve_the_full_ones() {
    let model = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap();
    for angle in [0.1f64, 1.2, 2.5, -2.0] {
        let (x, y) = (0.5 * angle.sin(), -0.5 * angle.cos());
        let s = PendulumState { x, y, dot_x: 0.7 };
        let full = model.initial_equations_at(0.0, &s, &[]);
        let (rates, lambda) = full.solve().unwrap();
        let reduced = model.velocity_rates(0.0, &s, &[]);
        assert!((rates[0] - reduced.dot_x).abs() < 1e-11 && (rates[1] - reduced.dot_y).abs() < 1e-11);
        assert!((lambda[0] - model.multipliers(0.0, &s, &[]).rod).abs() < 1e-11);
        // P1: λ = −(m/L²)(v·v − g y)
        let square = full.velocities.norm_squared();
        assert!((lambda[0] + 2.0 / 0.25 * (square - 9.81 * y)).abs() < 1e-11);
    }
}

#[test]
fn a_system_without_constraints_has_forms_too() {
    let model = Oscillator { m: 2.0, a: 0.0, k: 3.0, c: 0.0, b: 0.0 }.prepare().unwrap();
    let s = OscillatorState { x: 0.5, dot_x: 0.1 };
    let full = model.initial_equations_at(0.0, &s, &OscillatorInputs { tau: 0.25 });
    let (rates, lambda) = full.solve().unwrap();
    assert_eq!((rates[0], lambda.len()), ((0.25 - 1.5) / 2.0, 0));
    let d = model.complement_at(0.0, &s);
    assert_eq!(full.tangent_rates(&d).unwrap()[0], rates[0]);
    assert_eq!(full.multipliers().unwrap().len(), 0);
}

#[test]
fn units_do_not_make_a_matrix_singular_but_dependence_does() {
    let model = Pendulum { m: 1e-12, l: 1e6, g: 9.81 }.prepare().unwrap();
    let s = PendulumState { x: 0.0, y: -1e6, dot_x: 0.0 };
    let full = model.initial_equations_at(0.0, &s, &[]);
    assert!((full.solve().unwrap().1[0] + 9.81e-18).abs() < 1e-30);

    // The row of the constraint vanishes at the pivot point.
    let lost = model.initial_equations(0.0, &[0.0, 0.0], &PendulumVelocities::default(), &[]);
    let dependent = Error::Dependent { rows: vec!["rod"], value: 0.0, guard: None, time: None };
    assert_eq!(lost.solve(), Err(dependent.clone()));
    assert_eq!(lost.multipliers(), Err(dependent.clone()));
    assert_eq!(lost.projector(), Err(dependent.clone()));
    assert_eq!(lost.tangent_rates(&complement(&lost.constraint_matrix)), Err(dependent));

    // The same row twice, up to rounding.
    let mut twice = full.clone();
    let c = &full.constraint_matrix;
    twice.constraint_matrix = DMatrix::from_fn(2, 2, |i, j| c[(0, j)] * if i == 0 { 0.1 } else { 0.3 });
    twice.constraint_bias = nalgebra::DVector::zeros(2);
    twice.rows = vec!["rod", "same"];
    match twice.solve().unwrap_err() {
        Error::Dependent { rows, value, .. } => assert!(rows == ["rod", "same"] && value < 1e-15),
        other => panic!("{other:?}"),
    }
}

#[test]
fn wrong_shapes_and_figures_are_told() {
    let model = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap();
    let s = PendulumState { x: 0.3, y: -0.4, dot_x: 0.7 };
    let full = model.initial_equations_at(0.0, &s, &[]);
    let shape = Error::Shape { matrix: "D", needed: (1, 2), given: (2, 2) };
    assert_eq!(full.tangent_rates(&DMatrix::identity(2, 2)), Err(shape.clone()));
    assert_eq!(full.transformation(&DMatrix::identity(2, 2)), Err(shape.clone()));
    assert_eq!(full.tangent_metric(&DMatrix::identity(2, 2)), Err(shape));
    assert!(matches!(full.reactions(&nalgebra::DVector::zeros(3)), Err(Error::Shape { matrix: "λ", .. })));
    let nan = model.initial_equations_at(0.0, &PendulumState { x: f64::NAN, ..s }, &[]);
    assert!(matches!(nan.solve(), Err(Error::NonFinite { .. })));
}

#[test]
fn the_tangent_form_keeps_the_second_derivative_of_a_position_row_and_nothing_else() {
    // From data that violate the row, f(t) = f(0) + ḟ(0) t: (3.5) knows f̈ = 0 alone. That is the drift that projections undo.
    let model = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap();
    let rate = |y: [f64; 4]| {
        let full = model.initial_equations(0.0, &[y[0], y[1]], &[y[2], y[3]].into(), &[]);
        let rates = full.solve_by(holonomy::forms::NullSpaceMethod::Qr).unwrap().0;
        [y[2], y[3], rates[0], rates[1]]
    };
    let ahead = |y: [f64; 4], k: [f64; 4], h: f64| std::array::from_fn(|i| y[i] + h * k[i]);
    let mut y = [0.3, -0.42, 0.5, 0.2];
    let residuals = |y: [f64; 4]| {
        let [f] = model.position_residual(0.0, &[y[0], y[1]]);
        let [rate] = model.velocity_residual(0.0, &[y[0], y[1]], &[y[2], y[3]].into());
        (f, rate)
    };
    let (f, slope) = residuals(y);
    let h = 1e-3;
    for _ in 0..500 {
        let a = rate(y);
        let b = rate(ahead(y, a, h / 2.0));
        let c = rate(ahead(y, b, h / 2.0));
        let d = rate(ahead(y, c, h));
        y = std::array::from_fn(|i| y[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
    }
    let (end, end_slope) = residuals(y);
    assert!(f.abs() > 5e-3 && slope.abs() > 0.05);
    assert!((end - f - 0.5 * slope).abs() < 1e-11 && (end_slope - slope).abs() < 1e-11);
}
