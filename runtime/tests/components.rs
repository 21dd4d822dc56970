//! Vectors in bases and dual bases (A.1)-(A.6), and the principles that every motion obeys.

mod models;
mod systems;

use holonomy::Error;
use holonomy::forms::{Metric, NullSpaceMethod};
use holonomy::prelude::*;
use models::*;
use nalgebra::DMatrix;
use systems::{Random, distance};

#[test]
fn components_describe_one_arrow_whatever_the_base() {
    let mut random = Random::new(21);
    for _ in 0..100 {
        let n = random.between(1, 8);
        // Base vectors in an orthonormal space of the same or a higher dimension.
        let more = random.between(0, 2);
        let e = random.rows(n, n + more);
        let metric = Metric::of_base(&e).unwrap();
        let (a, b) = (random.vector(n), random.vector(n));
        let arrow = |components: &nalgebra::DVector<f64>, base: &DMatrix<f64>| base.tr_mul(components);
        let dual = metric.dual_base(&e);
        // (A.1), (A.3)
        assert!(distance(&arrow(&metric.covariant(&a), &dual), &arrow(&a, &e)) < 1e-12);
        assert!(distance(&metric.contravariant(&metric.covariant(&a)), &a) < 1e-12);
        assert!((&e * dual.transpose() - DMatrix::identity(n, n)).amax() < 1e-12);
        assert!((&dual * dual.transpose() - metric.inverse()).amax() < 1e-10);
        // (A.4), all four, against the arrows
        let expected = arrow(&a, &e).dot(&arrow(&b, &e));
        let (ca, cb) = (metric.covariant(&a), metric.covariant(&b));
        for product in [metric.dot(&a, &b), a.dot(&cb), metric.dot_covariant(&ca, &cb), ca.dot(&b)] {
            assert!((product - expected).abs() < 1e-12);
        }
        // (A.5), (A.6), as corrected: the arrow stays, the base moves.
        let turn = random.rows(n, n);
        let change = metric.change(&turn).unwrap();
        let moved = change.base(&e);
        assert!((&moved * moved.transpose() - change.metric().matrix()).amax() < 1e-12);
        assert!(distance(&arrow(&change.contravariant(&a), &moved), &arrow(&a, &e)) < 1e-12);
        assert!(distance(&change.covariant(&ca), &change.metric().covariant(&change.contravariant(&a))) < 1e-12);
        let (ha, hb) = (change.contravariant(&a), change.contravariant(&b));
        assert!((change.metric().dot(&ha, &hb) - expected).abs() < 1e-12);
    }
}

#[test]
fn the_tangent_base_is_a_change_of_base() {
    let mut random = Random::new(22);
    for _ in 0..50 {
        let n = random.between(2, 9);
        let m = random.between(1, n - 1);
        let full = random.system(n, m);
        let d = full.null_space(NullSpaceMethod::Lu).unwrap().complement;
        let t = full.transformation(&d).unwrap();
        let metric = Metric::new(full.inertia.clone()).unwrap();
        let change = metric.change(&t).unwrap();
        // (3.3): M_t has the blocks M_c and M_d.
        let blocks = full.metric(&d).unwrap();
        assert!((change.metric().matrix() - &blocks).amax() < 1e-12);
        assert!((blocks.view((0, 0), (m, m)) - full.constraint_metric().unwrap()).amax() < 1e-12);
        assert!((blocks.view((m, m), (n - m, n - m)) - full.tangent_metric(&d).unwrap()).amax() < 1e-12);
        assert!(blocks.view((0, m), (m, n - m)).amax() < 1e-12);
        // (3.4): the dynamic equations along the constraint vectors and along the tangent vectors.
        let (rates, multipliers) = full.solve().unwrap();
        let inertia_forces = change.covariant(&metric.covariant(&rates));
        let forces = change.covariant(&full.forces);
        let across = forces.rows(0, m) + full.constraint_metric().unwrap() * &multipliers;
        assert!(distance(&inertia_forces.rows(0, m).into_owned(), &across) < 1e-11);
        assert!(distance(&inertia_forces.rows(m, n - m).into_owned(), &forces.rows(m, n - m).into_owned()) < 1e-11);
        // The reactions have no tangent part, and their contravariant components across are λ.
        let reactions = change.covariant(&full.constraint_matrix.tr_mul(&multipliers));
        assert!(reactions.rows(m, n - m).amax() < 1e-12);
        let along = change.metric().contravariant(&reactions);
        assert!(distance(&along.rows(0, m).into_owned(), &multipliers) < 1e-10);
    }
}

#[test]
fn the_motion_makes_gauss_constraint_least() {
    let mut random = Random::new(23);
    for _ in 0..100 {
        let n = random.between(2, 9);
        let m = random.between(1, n - 1);
        let full = random.system(n, m);
        let (rates, multipliers) = full.solve().unwrap();
        let least = full.gauss_constraint(&rates).unwrap();
        let held = multipliers.dot(&(full.constraint_metric().unwrap() * &multipliers));
        assert!((least - held).abs() < 1e-12 * (1.0 + held));
        let d = full.null_space(NullSpaceMethod::Qr).unwrap().complement;
        for _ in 0..10 {
            // Any other v̇ that the constraints allow; the value grows by the square of the distance.
            let apart = d.tr_mul(&random.vector(n - m));
            let more = full.gauss_constraint(&(&rates + &apart)).unwrap();
            assert!((more - least - apart.dot(&(&full.inertia * &apart))).abs() < 1e-11);
        }
    }
}

#[test]
fn reactions_of_constraints_at_rest_do_no_work() {
    let model = Pendulum { m: 2.0, l: 0.5, g: 9.81 }.prepare().unwrap();
    let full = model.initial_equations_at(0.0, &PendulumState { x: 0.3, y: -0.4, dot_x: 0.7 }, &[]);
    let (rates, multipliers) = full.solve().unwrap();
    assert!(full.reaction_power(&multipliers).unwrap().abs() < 1e-14);
    assert!((full.velocities.dot(&(&full.inertia * rates)) - full.power()).abs() < 1e-13);
}

#[test]
fn reactions_of_moving_constraints_do_the_work_that_the_energy_gains() {
    let model = Bead { m: 1.5, w: 0.8, g: 9.81 }.prepare().unwrap();
    let t = 0.6;
    let y = (0.8_f64 * t).tan() * 1.3;
    let s = BeadState { x: 1.3, y, dot_x: -0.4 };
    let full = model.initial_equations_at(t, &s, &[]);
    let (rates, multipliers) = full.solve().unwrap();
    let power = full.reaction_power(&multipliers).unwrap();
    // −λᵀ η with η = φ at v = 0
    let [eta] = model.velocity_residual(t, &[s.x, s.y], &BeadVelocities::default());
    assert!(power.abs() > 1.0 && (power + multipliers[0] * eta).abs() < 1e-12);
    assert!((full.velocities.dot(&(&full.inertia * rates)) - full.power() - power).abs() < 1e-12);
    // d/dt of the kinetic energy along the motion, by differences, is all power.
    let run = model.simulate(s).starting_at(t).tolerance(1e-13, 1e-13).until(t + 0.2).unwrap();
    let kinetic = |t: f64| model.energy(t, &run.at(t).unwrap());
    let (middle, h) = (t + 0.1, 1e-3);
    let slope = (8.0 * (kinetic(middle + h) - kinetic(middle - h)) - kinetic(middle + 2.0 * h)
        + kinetic(middle - 2.0 * h))
        / (12.0 * h);
    let full = model.initial_equations_at(middle, &run.at(middle).unwrap(), &[]);
    let (_, multipliers) = full.solve().unwrap();
    let expected = full.power() + full.reaction_power(&multipliers).unwrap();
    assert!((slope - expected).abs() < 1e-7, "{slope} {expected}");
}

#[test]
fn wrong_shapes_are_told() {
    assert!(matches!(Metric::new(DMatrix::zeros(2, 3)), Err(Error::Shape { matrix: "M", .. })));
    assert!(matches!(Metric::new(DMatrix::zeros(2, 2)), Err(Error::SingularMatrix { matrix: "M", .. })));
    let metric = Metric::new(DMatrix::identity(2, 2)).unwrap();
    assert!(matches!(metric.change(&DMatrix::identity(3, 3)), Err(Error::Shape { matrix: "B", .. })));
    assert!(matches!(metric.change(&DMatrix::zeros(2, 2)), Err(Error::SingularMatrix { .. })));
    let full = Random::new(24).system(3, 1);
    assert!(matches!(full.gauss_constraint(&nalgebra::DVector::zeros(2)), Err(Error::Shape { .. })));
    assert!(matches!(full.reaction_power(&nalgebra::DVector::zeros(2)), Err(Error::Shape { .. })));
    assert!(matches!(full.multipliers_of(&nalgebra::DVector::zeros(2)), Err(Error::Shape { .. })));
}
