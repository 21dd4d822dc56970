//! A planar loop where single pivots come near zero and the loop itself does not: accelerations and reactions against the
//! full system (2.8), solved densely.

use holonomy::{ConstrainedSystem, Vector};
use nalgebra::{DMatrix, DVector};

/// A four-bar linkage by the absolute angles of its bars, uniform and under gravity.
#[derive(ConstrainedSystem, Clone)]
#[coordinates(q1, q2, q3)]
#[inertia(matrix(
    [(m1/3 + m2)*powi(l1, 2), m2*l1*l2/2*cos(q1 - q2), 0],
    [_, m2*powi(l2, 2)/3, 0],
    [_, _, m3*powi(l3, 2)/3],
))]
#[forces(
    tau - m2*l1*l2/2*sin(q1 - q2)*powi(dot(q2), 2) - (m1/2 + m2)*g*l1*cos(q1),
    m2*l1*l2/2*sin(q1 - q2)*powi(dot(q1), 2) - m2/2*g*l2*cos(q2),
    -m3/2*g*l3*cos(q3),
)]
#[constraint(closure_x: l1*cos(q1) + l2*cos(q2) == d + l3*cos(q3))]
#[constraint(closure_y: l1*sin(q1) + l2*sin(q2) == l3*sin(q3))]
#[independent(dot(q1))]
struct FourBar {
    l1: f64,
    l2: f64,
    l3: f64,
    d: f64,
    m1: f64,
    m2: f64,
    m3: f64,
    g: f64,
    tau: f64,
}

#[test]
fn a_loop_is_as_accurate_as_its_determinant_allows() {
    let parameters = FourBar { l1: 1.5, l2: 1.2, l3: 1.6, d: 0.5, m1: 1.5, m2: 1.2, m3: 1.6, g: 9.81, tau: 2.0 };
    let model = parameters.prepare().expect("good parameters");
    let names: Vec<&str> = FourBar::MODEL.guards.iter().map(|guard| guard.name).collect();
    // The first pivot: sin(q2 - q3), in whatever form; never sin(q2) alone.
    assert!(names.iter().all(|name| *name != "sin(q2)" && *name != "sin(q3)"), "{names:?}");
    for q2 in [0.4, 1e-3, 1e-5, 1e-8, 0.0] {
        // C v̇ + c0* = 0 and M v̇ = h* + Cᵀ λ hold for any angles, whether or not the loop closes.
        let s = FourBarState { q1: 1.6, q2, q3: 1.9, dot_q1: 1.3 };
        let (x, v) = (model.coordinates(0.0, &s), model.velocities(0.0, &s));
        let (m, c) = (model.inertia(0.0, &x), model.constraint_matrix(0.0, &x, &v));
        let h: [f64; 3] = model.forces(0.0, &x, &v, &[]).into();
        let c0 = model.constraint_bias(0.0, &x, &v);
        let full = DMatrix::from_fn(5, 5, |i, j| match (i < 3, j < 3) {
            (true, true) => m[(i, j)],
            (true, false) => -c[(j - 3, i)],
            (false, true) => c[(i - 3, j)],
            (false, false) => 0.0,
        });
        let right = DVector::from_fn(5, |i, _| if i < 3 { h[i] } else { -c0[i - 3] });
        let condition = {
            let values = full.singular_values();
            values.max() / values.min()
        };
        let exact = full.lu().solve(&right).expect("the loop is regular here");
        let rates: [f64; 3] = model.velocity_rates(0.0, &s, &[]).into();
        let lambda = model.multipliers(0.0, &s, &[]);
        let found = [rates[0], rates[1], rates[2], lambda.closure_x, lambda.closure_y];
        for (a, b) in found.iter().zip(exact.iter()) {
            let bound = 1e-15 * condition * exact.amax();
            assert!((a - b).abs() <= bound.max(1e-12 * exact.amax()), "q2 = {q2}: {a} and {b}");
        }
        assert!(<[f64; 3]>::from(v).iter().all(|v| v.is_finite()));
        assert_eq!(FourBarState::<f64>::NAMES[3], "dot_q1");
    }
}
