//! A loop on top of a tree moves as by M_d: through changes of the chart, linearised, with the same reactions.

mod support;

use holonomy::{ConstrainedSystem, Vector};
use support::running::entries;

/// A four-bar by the speed of its rocker or of its coupler, with a load on their pin, eliminated in one way.
macro_rules! by_rocker {
    ($name:ident, $way:ident) => {
        #[derive(ConstrainedSystem, Clone, Debug)]
        #[holonomy(elimination = $way)]
        #[coordinates(crank, coupler, rocker)]
        #[inputs(tau)]
        #[frame(A = rotate(N, z, crank), B = rotate(N, z, coupler), C = rotate(N, z, rocker))]
        #[point(P = O + a*A.x, Q = P + b*B.x, S = O + d*N.x + c*C.x)]
        #[body(
                            crank_bar = { frame: A, center: O + a/2*A.x, mass: m1, inertia: rod(m1, a, x) },
                            coupler_bar = { frame: B, center: P + b/2*B.x, mass: m2, inertia: rod(m2, b, x) },
                            rocker_bar = { frame: C, center: O + d*N.x + c/2*C.x, mass: m3, inertia: rod(m3, c, x) },
                        )]
        #[torque(drive = { on: A, value: tau*N.z })]
        #[particle(weight = { at: Q, mass: load })]
        #[gravity(-g*N.y)]
        #[constraint(closure: Q == S)]
        #[independent(dot(rocker))]
        #[independent(dot(coupler))]
        #[start(crank = 0.1, coupler = 0.6, rocker = 1.9)]
        struct $name {
            #[nominal(0.5)]
            a: f64,
            #[nominal(1.8)]
            b: f64,
            #[nominal(1.2)]
            c: f64,
            #[nominal(2)]
            d: f64,
            #[nominal(0.5)]
            m1: f64,
            #[nominal(1.8)]
            m2: f64,
            #[nominal(1.2)]
            m3: f64,
            #[nominal(2)]
            load: f64,
            #[nominal(9.81)]
            g: f64,
        }

        impl $name {
            const OWN: $name = $name { a: 0.5, b: 1.8, c: 1.2, d: 2.0, m1: 0.5, m2: 1.8, m3: 1.2, load: 2.0, g: 9.81 };
        }
    };
}

by_rocker!(ByJoints, recursive);
by_rocker!(ByMatrix, matrix);

/// Closed, with a crank that goes over the top.
fn start() -> ByMatrixState {
    let guess = ByMatrixState { crank: 0.3, coupler: 0.6, rocker: 1.9, dot_rocker: 0.0 };
    let matrix = ByMatrix::OWN.prepare().expect("good parameters");
    matrix.assemble(guess).hold("crank").set("dot_crank", 12.0).solve().expect("it closes")
}

#[test]
fn a_loop_on_a_tree_runs_through_its_charts() {
    let (joints, matrix) = (ByJoints::OWN.prepare().expect("good"), ByMatrix::OWN.prepare().expect("good"));
    assert!(ByJoints::MODEL.notes.iter().any(|note| note.contains("joint by joint")), "{:?}", ByJoints::MODEL.notes);
    assert!(ByMatrix::MODEL.notes.iter().all(|note| !note.contains("joint by joint")));
    let found = start();
    let same = ByJointsState::from_fn(|i| entries(&found)[i]);
    let torque = |t: f64| 0.5 * (2.0 * t).sin();
    let (one, other) = (
        joints.simulate(same).tolerance(1e-11, 1e-13).inputs(|t, _: &ByJointsState| ByJointsInputs { tau: torque(t) }),
        matrix.simulate(found).tolerance(1e-11, 1e-13).inputs(|t, _: &ByMatrixState| ByMatrixInputs { tau: torque(t) }),
    );
    let (one, other) = (one.until(4.0).expect("it runs"), other.until(4.0).expect("it runs"));
    assert!(one.statistics().chart_changes >= 4 && (one.last().1.crank - 0.3).abs() > 6.0, "{:?}", one.statistics());
    for i in 0..=40 {
        let t = 0.1 * f64::from(i);
        let (a, b) = (one.at(t).expect("within"), other.at(t).expect("within"));
        for (a, b) in entries(&a)[..3].iter().zip(&entries(&b)[..3]) {
            assert!((a - b).abs() < 1e-7, "{a} {b} at {t}");
        }
        let (a, b) = (
            one.multipliers_at(t, &ByJointsInputs { tau: torque(t) }).expect("within"),
            other.multipliers_at(t, &ByMatrixInputs { tau: torque(t) }).expect("within"),
        );
        let (a, b) = (entries(&a), entries(&b));
        assert!(a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-5 * b.abs().max(1.0)), "{a:?} {b:?} at {t}");
    }
}

#[test]
fn a_loop_on_a_tree_is_linearised() {
    let (joints, matrix) = (ByJoints::OWN.prepare().expect("good"), ByMatrix::OWN.prepare().expect("good"));
    let found = start();
    let same = ByJointsState::from_fn(|i| entries(&found)[i]);
    let one = joints.linearize(0.0, &same, &ByJointsInputs { tau: 0.4 }).expect("regular");
    let other = matrix.linearize(0.0, &found, &ByMatrixInputs { tau: 0.4 }).expect("regular");
    assert!(one.a.nrows() == 2 && other.a.norm() > 1.0);
    assert!((&one.a - &other.a).norm() < 1e-10 * other.a.norm(), "{} {}", one.a, other.a);
    assert!((&one.b - &other.b).norm() < 1e-10 * other.b.norm(), "{} {}", one.b, other.b);
}
