//! Several projections one after the other against one: the same motion, and all reactions right at the end.

mod systems;

use holonomy::Error;
use holonomy::forms::{InitialEquations, NullSpaceMethod, Stages};
use nalgebra::{DMatrix, DVector};
use systems::{Random, distance};

const METHODS: [NullSpaceMethod; 3] = [NullSpaceMethod::Lu, NullSpaceMethod::Qr, NullSpaceMethod::Svd];

/// The rows dealt out to stages at random, each at least once; some stages may be empty.
fn split(random: &mut Random, full: &InitialEquations, stages: usize) -> Vec<Vec<&'static str>> {
    let mut dealt = vec![Vec::new(); stages];
    full.rows.iter().for_each(|row| dealt[random.between(0, stages - 1)].push(*row));
    dealt
}

fn in_stages(random: &mut Random, full: &InitialEquations, stages: usize) -> Stages {
    let dealt = split(random, full, stages);
    dealt.iter().fold(full.stages(), |done, rows| {
        let method = METHODS[random.between(0, 2)];
        done.project_by(rows, method).unwrap()
    })
}

#[test]
fn many_stages_equal_one() {
    let mut random = Random::new(11);
    for case in 0..600 {
        let n = random.between(1, 12);
        let m = random.between(0, n);
        let full = random.system(n, m);
        let (rates, multipliers) = full.solve().unwrap();
        let stages = random.between(1, 4);
        let chain = in_stages(&mut random, &full, stages);
        assert!(distance(&chain.rates().unwrap(), &rates) < 1e-12, "case {case}");
        assert!(distance(&chain.multipliers().unwrap(), &multipliers) < 1e-12, "case {case}");
        // The product of the complements is a complement, and the system at the end is the one of that single projection.
        let (d, a) = (chain.complement(), chain.bias());
        assert!(m == 0 || m == n || (&d * full.constraint_matrix.transpose()).amax() < 1e-12);
        let once = full.with_rows(&[]).unwrap().reduced(&d, &a).unwrap();
        let last = chain.system();
        assert!((&once.inertia - &last.inertia).amax_or_zero() < 1e-12);
        assert!(distance(&last.forces, &once.forces) < 1e-12);
        assert!(distance(&last.velocities, &once.velocities) < 1e-11);
        // (5.7) gives the rates of the coordinates: nothing of v is lost on the way.
        assert!(distance(&last.coordinate_rates(), &full.coordinate_rates()) < 1e-11);
    }
}

trait AmaxOrZero {
    fn amax_or_zero(&self) -> f64;
}

impl AmaxOrZero for DMatrix<f64> {
    fn amax_or_zero(&self) -> f64 {
        if self.is_empty() { 0.0 } else { self.amax() }
    }
}

#[test]
fn the_speeds_are_those_of_the_paper() {
    let mut random = Random::new(17);
    for _ in 0..100 {
        let n = random.between(2, 10);
        let m = random.between(1, n - 1);
        let full = random.system(n, m);
        // (5.2), (5.3): with C v + η = 0, v = Dᵀ u + v_u and v_u = −M⁻¹ Cᵀ M_c⁻¹ η; (5.7): ẋ = A Dᵀ u + A v_u + a0.
        let eta = -(&full.constraint_matrix * &full.velocities);
        let compliance = full.inertia.clone().cholesky().unwrap().solve(&full.constraint_matrix.transpose());
        let rest = -(&compliance * full.constraint_metric().unwrap().cholesky().unwrap().solve(&eta));
        let null = full.null_space(NullSpaceMethod::Lu).unwrap();
        let a = null.particular(&full.constraint_bias);
        let reduced = full.with_rows(&[]).unwrap().reduced(&null.complement, &a).unwrap();
        assert!(distance(&(null.complement.tr_mul(&reduced.velocities) + &rest), &full.velocities) < 1e-12);
        let bias = &full.kinematic_matrix * &rest + &full.kinematic_bias;
        assert!(distance(&reduced.kinematic_bias, &bias) < 1e-12);
        // Velocities in the independent columns: with the particular ones of the unit block instead of v_u, u = v there.
        let v_p = null.particular(&eta);
        let u = DVector::from_fn(n - m, |i, _| full.velocities[null.independent[i]]);
        assert!(distance(&(null.complement.tr_mul(&u) + v_p), &full.velocities) < 1e-12);
    }
}

#[test]
fn rows_that_are_still_open_act_as_well() {
    let mut random = Random::new(12);
    for _ in 0..100 {
        let n = random.between(3, 10);
        let m = random.between(2, n);
        let full = random.system(n, m);
        let chain = full.stages().project_by(&full.rows[..1], NullSpaceMethod::Lu).unwrap();
        assert_eq!(chain.system().rows, full.rows[1..]);
        let (rates, multipliers) = full.solve().unwrap();
        assert!(distance(&chain.rates().unwrap(), &rates) < 1e-12);
        assert!(distance(&chain.multipliers().unwrap(), &multipliers) < 1e-12);
        // A later stage's multipliers come out of the reduced system as well: there (3.6) holds as it stands.
        let later = chain.system().multipliers().unwrap();
        assert!(distance(&later, &multipliers.rows(1, m - 1).into_owned()) < 1e-11);
    }
}

#[test]
fn natural_multipliers_are_those_without_the_later_stages() {
    let mut random = Random::new(13);
    let mut different = 0;
    for _ in 0..100 {
        let n = random.between(3, 10);
        let m = random.between(2, n - 1);
        let first = random.between(1, m - 1);
        let full = random.system(n, m);
        let (early, late) = full.rows.split_at(first);
        let chain = full.stages().project_by(early, NullSpaceMethod::Qr).unwrap();
        let chain = chain.project_by(late, NullSpaceMethod::Lu).unwrap();
        let natural = chain.natural_multipliers(0).unwrap();
        let alone = full.with_rows(early).unwrap().solve().unwrap().1;
        assert!(distance(&natural, &alone) < 1e-11);
        // λ₁ = −(C₁ M⁻¹ C₁ᵀ)⁻¹ (c₁ + C₁ M⁻¹ (h* + C₂ᵀ λ₂)): the later reactions count among the forces.
        let all = chain.multipliers().unwrap();
        let later = full.with_rows(late).unwrap();
        let mut pulled = full.with_rows(early).unwrap();
        pulled.forces += later.constraint_matrix.tr_mul(&all.rows(first, m - first).into_owned());
        assert!(distance(&pulled.multipliers().unwrap(), &all.rows(0, first).into_owned()) < 1e-11);
        // Of the last stage there is none later.
        let last = chain.natural_multipliers(1).unwrap();
        assert!(distance(&last, &all.rows(first, m - first).into_owned()) < 1e-11);
        different += usize::from(distance(&natural, &all.rows(0, first).into_owned()) > 1e-3);
        assert!(matches!(chain.natural_multipliers(2), Err(Error::Shape { .. })));
    }
    assert!(different > 90, "{different}");
}

#[test]
fn any_a_that_satisfies_the_rows_will_do() {
    let mut random = Random::new(14);
    for _ in 0..100 {
        let n = random.between(3, 9);
        let m = random.between(2, n - 1);
        let full = random.system(n, m);
        let rows = &full.rows[..1];
        let before = full.with_rows(rows).unwrap();
        let null = before.null_space(NullSpaceMethod::Qr).unwrap();
        // Another base of the same tangent space, and another a.
        let turn = random.rows(n - 1, n - 1);
        let d = turn * &null.complement;
        let a = null.particular(&before.constraint_bias) + d.tr_mul(&random.vector(n - 1));
        let chain = full.stages().project(rows, &d, &a).unwrap();
        let (rates, multipliers) = full.solve().unwrap();
        assert!(distance(&chain.rates().unwrap(), &rates) < 1e-11);
        assert!(distance(&chain.multipliers().unwrap(), &multipliers) < 1e-11);
    }
}

#[test]
fn inertia_may_be_singular_and_rows_may_repeat() {
    let mut random = Random::new(15);
    for _ in 0..50 {
        let n = random.between(3, 9);
        let mut full = random.system(n, 3.min(n - 1));
        // A velocity without inertia, which the first row binds.
        full.inertia.row_mut(0).fill(0.0);
        full.inertia.column_mut(0).fill(0.0);
        full.constraint_matrix[(0, 0)] = 2.0;
        // The last row once more.
        let last = full.rows.len() - 1;
        full.rows.push("again");
        full.constraint_matrix = full.constraint_matrix.clone().insert_row(last + 1, 0.0);
        let again = full.constraint_matrix.row(last) * 3.0;
        full.constraint_matrix.set_row(last + 1, &again);
        full.constraint_bias = full.constraint_bias.push(3.0 * full.constraint_bias[last]);
        let (rates, multipliers) = full.solve_by(NullSpaceMethod::Svd).unwrap();
        let rest: Vec<&str> = full.rows[1..].to_vec();
        let chain = full.stages().project_by(&full.rows[..1], NullSpaceMethod::Lu).unwrap();
        let chain = chain.project_by(&rest, NullSpaceMethod::Qr).unwrap();
        assert!(distance(&chain.rates().unwrap(), &rates) < 1e-11);
        assert!(distance(&chain.multipliers().unwrap(), &multipliers) < 1e-10);
        assert!((multipliers[last + 1] - 3.0 * multipliers[last]).abs() < 1e-10);
    }
}

#[test]
fn what_does_not_fit_is_refused() {
    let mut random = Random::new(16);
    let full = random.system(5, 2);
    let unknown = full.stages().project_by(&["a", "q"], NullSpaceMethod::Lu).unwrap_err();
    assert_eq!(unknown, Error::UnknownName { name: "q".into(), known: vec!["a", "b"] });
    let null = full.with_rows(&["a"]).unwrap().null_space(NullSpaceMethod::Lu).unwrap();
    let a = null.particular(&full.constraint_bias.rows(0, 1).into_owned());
    let d = &null.complement;
    let refused = |rows: &[&str], d: &DMatrix<f64>, a: &DVector<f64>| full.stages().project(rows, d, a).unwrap_err();
    assert!(matches!(refused(&["a", "b"], d, &a), Error::Shape { matrix: "D", needed: (3, 5), .. }));
    assert!(matches!(refused(&["a"], d, &DVector::zeros(4)), Error::Shape { matrix: "a", .. }));
    // The complement of another row, and an a that leaves the row.
    assert!(matches!(refused(&["b"], d, &a), Error::NotTangent { constraint: "b", .. }));
    match refused(&["a"], d, &DVector::zeros(5)) {
        Error::NotTangent { constraint: "a", value } => assert_eq!(value, full.constraint_bias[0]),
        other => panic!("{other:?}"),
    }
    let nan = DMatrix::from_element(4, 5, f64::NAN);
    assert!(matches!(refused(&["a"], &nan, &a), Error::NotTangent { constraint: "a", .. }));
}
