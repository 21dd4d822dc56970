//! Four rows that can only be solved together: accelerations and reactions against the full system (2.8), solved densely,
//! where every entry that an elimination row by row would divide by vanishes in turn.

#[path = "models/coupled.rs"]
mod coupled;

use coupled::{SixBar, SixBarState};
use holonomy::{ConstrainedSystem, Error, Prepared};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::FRAC_PI_2;

fn six_bar() -> Prepared<SixBar> {
    let bars = SixBar {
        l1: 0.5,
        l2: 1.2,
        l3: 1.1,
        l4: 1.3,
        l5: 1.4,
        a: 0.5,
        b: 0.6,
        d: 2.0,
        j1: 0.3,
        j2: 0.4,
        j3: 0.5,
        j4: 0.6,
        j5: 0.7,
        w1: 5.0,
        w2: 6.0,
        w3: 7.0,
        w4: 8.0,
        w5: 9.0,
        tau: 2.0,
    };
    bars.prepare().expect("good parameters")
}

/// Angles at which the loops are regular; they need not close for C v̇ + c0* = 0 and M v̇ = h* + Cᵀ λ to hold.
const REGULAR: [f64; 5] = [1.2, 0.5, -0.6, -1.3, -2.1];

fn at(q: [f64; 5]) -> SixBarState {
    SixBarState { q1: q[0], q2: q[1], q3: q[2], q4: q[3], q5: q[4], dot_q1: 1.3 }
}

#[test]
fn four_rows_are_as_accurate_as_their_determinant_allows() {
    let model = six_bar();
    // The determinant of the block is its only guard; the other one is that of M_d, if it needs one.
    let pivots = SixBar::MODEL.guards.iter().filter(|guard| guard.name.contains("sin") && !guard.name.contains("j1"));
    assert_eq!(pivots.count(), 1, "{:?}", SixBar::MODEL.guards.iter().map(|guard| guard.name).collect::<Vec<_>>());
    for angle in 1..5 {
        for value in [0.0, 1e-9, FRAC_PI_2, 1.1] {
            let mut q = REGULAR;
            q[angle] = value;
            let s = at(q);
            let (x, v) = (model.coordinates(0.0, &s), model.velocities(0.0, &s));
            let (m, c) = (model.inertia(0.0, &x), model.constraint_matrix(0.0, &x, &v));
            let h: [f64; 5] = model.forces(0.0, &x, &v, &[]).into();
            let c0 = model.constraint_bias(0.0, &x, &v);
            let full = DMatrix::from_fn(9, 9, |i, j| match (i < 5, j < 5) {
                (true, true) => m[(i, j)],
                (true, false) => -c[(j - 5, i)],
                (false, true) => c[(i - 5, j)],
                (false, false) => 0.0,
            });
            let right = DVector::from_fn(9, |i, _| if i < 5 { h[i] } else { -c0[i - 5] });
            let condition = {
                let values = full.singular_values();
                values.max() / values.min()
            };
            assert!(condition < 1e6, "the block is regular at angle {angle} = {value}: {condition:e}");
            let exact = full.lu().solve(&right).expect("regular");
            let rates: [f64; 5] = model.velocity_rates(0.0, &s, &[]).into();
            let lambda: [f64; 4] = model.multipliers(0.0, &s, &[]).into();
            for (found, expected) in rates.iter().chain(&lambda).zip(exact.iter()) {
                let bound = (4e-16 * condition).max(1e-12) * exact.amax();
                assert!((found - expected).abs() <= bound, "angle {angle} = {value}: {found} and {expected}");
            }
            // The velocities satisfy the rows.
            let v: [f64; 5] = v.into();
            for i in 0..4 {
                let terms: Vec<f64> = (0..5).map(|j| c[(i, j)] * v[j]).collect();
                let size: f64 = terms.iter().map(|term| term.abs()).sum();
                assert!(terms.iter().sum::<f64>().abs() <= 4e-16 * condition * size.max(1e-3), "row {i}");
            }
        }
    }
}

#[test]
fn a_loop_that_is_stretched_out_loses_its_rank() {
    let model = six_bar();
    assert!(model.check_rank(0.0, &at(REGULAR)).expect("full rank") > 1e-3);
    // All bars of the outer loop along one line: its two rows bind one direction twice.
    let stretched = at([0.7, 0.7, 0.7, 0.7, -2.1]);
    match model.check_rank(0.5, &stretched).unwrap_err() {
        Error::Dependent { rows, guard: Some(guard), time: Some(0.5), value } => {
            assert!(rows.iter().any(|row| row.starts_with("outer")), "{rows:?}");
            assert!(SixBar::MODEL.guards.iter().any(|entry| entry.name == guard));
            assert!(value < 1e-12, "{value}");
        }
        other => panic!("{other:?}"),
    }
    // The crank at an angle keeps the rank, but the other bars no longer follow from it.
    let dead = at([1.2, 0.7, 0.7, 0.7, -2.1]);
    assert!(model.check_rank(0.0, &dead).expect("full rank") > 1e-3);
    let guards = model.guards(0.0, &dead);
    assert!(guards.as_ref().iter().any(|guard| guard.abs() < 1e-14), "{guards:?}");
}
