//! Null spaces found at run time, and the general form that is built on them, against the full system and against algebra that
//! goes another way.

mod systems;

use holonomy::Error;
use holonomy::forms::{InitialEquations, NullSpace, NullSpaceMethod};
use nalgebra::{DMatrix, DVector};
use systems::{NAMES, Random, distance};

const METHODS: [NullSpaceMethod; 3] = [NullSpaceMethod::Lu, NullSpaceMethod::Qr, NullSpaceMethod::Svd];

#[test]
fn every_method_gives_a_complement_of_full_rank() {
    let mut random = Random::new(1);
    for _ in 0..200 {
        let n = random.between(1, 12);
        let m = random.between(0, n);
        let c = random.rows(m, n);
        let r = random.vector(m);
        for method in METHODS {
            let null = NullSpace::new(&c, method).unwrap();
            let d = &null.complement;
            assert_eq!((null.rank, d.shape()), (m, (n - m, n)));
            assert!(m == n || m == 0 || (d * c.transpose()).amax() < 1e-13, "{method:?}");
            assert_eq!(null.figures.len(), m);
            assert!(null.figures.iter().all(|figure| *figure > 1e-3 && *figure <= 1.0));
            let z = null.particular(&r);
            assert!(distance(&(&c * &z), &-&r) < 1e-12);
            if method == NullSpaceMethod::Lu {
                // u = v in the independent columns, and z is zero there.
                for (i, &column) in null.independent.iter().enumerate() {
                    assert!((0..n - m).all(|row| d[(row, column)] == if row == i { 1.0 } else { 0.0 }));
                    assert_eq!(z[column], 0.0);
                }
                assert_eq!(null.independent.len(), n - m);
            } else {
                assert!(n == m || (d * d.transpose() - DMatrix::identity(n - m, n - m)).amax() < 1e-13);
                // The shortest z has no part in the null space.
                assert!(n == m || (d * &z).amax() < 1e-13);
            }
        }
        // Orthonormal bases of one space have one projector.
        let [_, q, s] = METHODS.map(|method| NullSpace::new(&c, method).unwrap().complement);
        assert!(n == m || (q.tr_mul(&q) - s.tr_mul(&s)).amax() < 1e-13);
    }
}

#[test]
fn the_rank_is_found_whatever_the_units() {
    let mut random = Random::new(2);
    for _ in 0..200 {
        let n = random.between(2, 10);
        let rank = random.between(1, n);
        let m = random.between(rank, 12);
        let c = random.rows(m, rank) * random.rows(rank, n);
        // Rows in units from 1e-9 to 1e9.
        let scaled = DMatrix::from_fn(m, n, |i, j| c[(i, j)] * 10_f64.powi((i as i32 % 3 - 1) * 9));
        for method in METHODS {
            let null = NullSpace::new(&scaled, method).unwrap();
            assert_eq!((null.rank, null.complement.nrows()), (rank, n - rank), "{method:?} {:?}", null.figures);
            assert!(rank == n || (&null.complement * c.transpose()).amax() < 1e-12);
            // C G C = C
            let again = &scaled * &null.inverse * &scaled;
            assert!((0..m).all(|i| (again.row(i) - scaled.row(i)).amax() <= 1e-11 * scaled.row(i).amax()));
            assert!(null.figures[rank - 1] > 1e-4 && null.figures.get(rank).is_none_or(|figure| *figure < 1e-13));
        }
    }
}

#[test]
fn zero_rows_and_empty_matrices() {
    for method in METHODS {
        let null = NullSpace::new(&DMatrix::zeros(2, 3), method).unwrap();
        assert_eq!((null.rank, null.figures.as_slice()), (0, [0.0, 0.0].as_slice()));
        assert_eq!(null.complement.rank(1e-9), 3);
        let null = NullSpace::new(&DMatrix::zeros(0, 3), method).unwrap();
        assert_eq!((null.rank, null.complement), (0, DMatrix::identity(3, 3)));
        let nan = DMatrix::from_element(1, 2, f64::NAN);
        assert_eq!(NullSpace::new(&nan, method), Err(Error::NonFinite { name: "C" }));
    }
}

#[test]
fn singular_values_are_those_of_another_algorithm() {
    let mut random = Random::new(3);
    for _ in 0..50 {
        let (m, n) = (random.between(1, 8), random.between(1, 8));
        // Entries of one binade in each row's largest, so that rows are not scaled.
        let mut c = random.matrix(m, n) * 0.5;
        (0..m).for_each(|i| c[(i, i % n)] = 1.5);
        let null = NullSpace::new(&c, NullSpaceMethod::Svd).unwrap();
        let mut expected: Vec<f64> = c.clone().svd(false, false).singular_values.iter().copied().collect();
        expected.sort_by(|a, b| b.total_cmp(a));
        let largest = expected[0];
        for (found, expected) in null.figures.iter().zip(expected) {
            assert!((found - expected / largest).abs() < 1e-14, "{found} {expected}");
        }
    }
}

#[test]
fn all_forms_agree_on_random_systems() {
    let mut random = Random::new(4);
    for _ in 0..200 {
        let n = random.between(1, 12);
        let m = random.between(0, n);
        let full = random.system(n, m);
        let (rates, multipliers) = full.solve().unwrap();
        for method in METHODS {
            let (by, lambda) = full.solve_by(method).unwrap();
            assert!(distance(&by, &rates) < 1e-12 && distance(&lambda, &multipliers) < 1e-11, "{method:?}");
            let d = full.null_space(method).unwrap().complement;
            assert!(distance(&full.tangent_rates(&d).unwrap(), &rates) < 1e-12);
        }
        assert!(distance(&full.projected_rates().unwrap(), &rates) < 1e-12);
        assert!(distance(&full.multipliers().unwrap(), &multipliers) < 1e-11);
        assert!(distance(&full.multipliers_of(&rates).unwrap(), &multipliers) < 1e-11);
        // P is a projector onto ker C, symmetric in the metric.
        let p = full.projector().unwrap();
        assert!((&p * &p - &p).amax() < 1e-12 && (m == 0 || (&full.constraint_matrix * &p).amax() < 1e-12));
        let mp = &full.inertia * &p;
        assert!((mp.transpose() - mp).amax() < 1e-12);
    }
}

/// M with no inertia at all in some directions outside of ker C.
fn singular_inertia(random: &mut Random, n: usize, m: usize) -> InitialEquations {
    let mut full = random.system(n, m);
    // On ker C as before; what is taken away lies across it: M − M Z (Zᵀ M Z)⁻¹ Zᵀ M kills the columns of Z.
    let z = full.constraint_matrix.transpose() * random.rows(m, m);
    let mz = &full.inertia * &z;
    let middle = z.tr_mul(&mz).cholesky().unwrap().inverse();
    full.inertia -= &mz * middle * mz.transpose();
    full.inertia = 0.5 * (&full.inertia + full.inertia.transpose());
    full
}

#[test]
fn inertia_need_only_be_definite_on_the_tangent_space() {
    let mut random = Random::new(5);
    for _ in 0..100 {
        let n = random.between(2, 10);
        let m = random.between(1, n - 1);
        let full = singular_inertia(&mut random, n, m);
        assert_eq!(full.inertia.rank(1e-10), n - m);
        let (rates, multipliers) = full.solve().unwrap();
        for method in METHODS {
            let (by, lambda) = full.solve_by(method).unwrap();
            assert!(distance(&by, &rates) < 1e-11 && distance(&lambda, &multipliers) < 1e-10, "{method:?}");
        }
        assert!(distance(&full.multipliers_of(&rates).unwrap(), &multipliers) < 1e-10);
    }
    // (3.6) needs M⁻¹, and tells where there is none.
    let mut full = random.system(2, 1);
    full.inertia = DMatrix::from_row_slice(2, 2, &[3.0, 0.0, 0.0, 0.0]);
    full.constraint_matrix = DMatrix::from_row_slice(1, 2, &[0.5, 2.0]);
    assert_eq!(full.multipliers(), Err(Error::SingularMatrix { matrix: "M", pivot: 0.0 }));
    let (rates, multipliers) = full.solve_by(NullSpaceMethod::Lu).unwrap();
    // 3 v̇₁ = h₁ + λ/2, 0 = h₂ + 2 λ, v̇₁/2 + 2 v̇₂ + c = 0
    let lambda = -0.5 * full.forces[1];
    let first = (full.forces[0] + 0.5 * lambda) / 3.0;
    let second = -0.5 * (0.5 * first + full.constraint_bias[0]);
    assert!(distance(&rates, &DVector::from_vec(vec![first, second])) < 1e-15);
    assert!((multipliers[0] - lambda).abs() < 1e-15);
}

#[test]
fn inertia_that_is_not_definite_there_is_told() {
    let mut random = Random::new(6);
    for sign in [0.0, -1.0] {
        for _ in 0..30 {
            let n = random.between(3, 9);
            let mut full = random.system(n, 1);
            // No inertia, or a negative one, along one direction of ker C.
            let d = full.null_space(NullSpaceMethod::Qr).unwrap().complement;
            let z = d.tr_mul(&random.vector(n - 1));
            let mz = &full.inertia * &z;
            full.inertia -= (1.0 - sign) * &mz * mz.transpose() / z.dot(&mz);
            for method in METHODS {
                let error = full.solve_by(method).unwrap_err();
                assert!(matches!(error, Error::Indefinite { .. }), "{error:?}");
                assert!(error.to_string().contains("M on ker C"));
            }
        }
    }
}

/// The same system with further rows W C, consistent ones.
fn with_combinations(full: &InitialEquations, w: &DMatrix<f64>) -> InitialEquations {
    let (m, more) = (full.rows.len(), w.nrows());
    let mut longer = full.clone();
    longer.rows = NAMES[..m + more].to_vec();
    longer.constraint_matrix = full.constraint_matrix.clone().resize_vertically(m + more, 0.0);
    longer.constraint_matrix.rows_mut(m, more).copy_from(&(w * &full.constraint_matrix));
    longer.constraint_bias = full.constraint_bias.clone().resize_vertically(m + more, 0.0);
    longer.constraint_bias.rows_mut(m, more).copy_from(&(w * &full.constraint_bias));
    longer
}

#[test]
fn dependent_rows_share_the_load_with_the_least_norm() {
    let mut random = Random::new(7);
    for _ in 0..100 {
        let n = random.between(2, 10);
        let m = random.between(1, n.min(8));
        let full = random.system(n, m);
        let more = random.between(1, 4);
        let combinations = random.matrix(more, m);
        let longer = with_combinations(&full, &combinations);
        let (rates, multipliers) = full.solve().unwrap();
        let load = full.constraint_matrix.tr_mul(&multipliers);
        // All rows are W C with W = [1; R]: λ = W (Wᵀ W)⁻¹ μ.
        let mut w = DMatrix::identity(m + more, m);
        w.rows_mut(m, more).copy_from(&combinations);
        let expected = &w * w.tr_mul(&w).cholesky().unwrap().solve(&multipliers);
        for method in METHODS {
            let (by, lambda) = longer.solve_by(method).unwrap();
            assert!(distance(&by, &rates) < 1e-11, "{method:?}");
            assert!(distance(&lambda, &expected) < 1e-10, "{method:?}");
            assert!(distance(&longer.constraint_matrix.tr_mul(&lambda), &load) < 1e-11);
        }
        assert!(distance(&longer.multipliers_of(&rates).unwrap(), &expected) < 1e-10);
        let independent = longer.independent_rows().unwrap();
        assert_eq!(independent.rows.len(), m);
        let (again, forces) = independent.solve().unwrap();
        assert!(distance(&again, &rates) < 1e-10);
        assert!(distance(&independent.constraint_matrix.tr_mul(&forces), &load) < 1e-10);
        // What needs independent rows tells that they are not.
        for error in [longer.solve().unwrap_err(), longer.multipliers().unwrap_err(), longer.check_rank().unwrap_err()]
        {
            assert!(matches!(error, Error::Dependent { value, .. } if value < 1e-13), "{error:?}");
        }
    }
}

#[test]
fn the_rows_that_depend_are_named_and_no_others() {
    let mut random = Random::new(8);
    for _ in 0..50 {
        let full = random.system(7, 4);
        // e = 2 a − 3 c; b and d have no part in it.
        let w = DMatrix::from_row_slice(1, 4, &[2.0, 0.0, -3.0, 0.0]);
        let mut longer = with_combinations(&full, &w);
        match longer.solve().unwrap_err() {
            Error::Dependent { rows, guard: None, time: None, .. } => assert_eq!(rows, ["a", "c", "e"]),
            other => panic!("{other:?}"),
        }
        longer.constraint_bias[4] += 0.25;
        for method in METHODS {
            match longer.solve_by(method).unwrap_err() {
                Error::Inconsistent { rows, residual } => {
                    assert_eq!(rows, ["a", "c", "e"]);
                    assert!(residual.abs() > 1e-3 && residual.abs() < 0.3, "{residual}");
                }
                other => panic!("{other:?}"),
            }
        }
    }
}

/// The same with the rows' order and signs changed, and a column for a velocity in another unit.
#[test]
fn units_of_velocities_do_not_choose_the_independent_ones() {
    let mut random = Random::new(9);
    for _ in 0..50 {
        let n = random.between(2, 8);
        let m = random.between(1, n - 1);
        let full = random.system(n, m);
        let factor = DVector::from_fn(n, |j, _| 2_f64.powi(j as i32 % 5 * 12 - 24));
        let units = DMatrix::from_diagonal(&factor);
        // v = U v'
        let mut other = full.clone();
        other.inertia = &units * &full.inertia * &units;
        other.forces = &units * &full.forces;
        other.constraint_matrix = &full.constraint_matrix * &units;
        let (a, b) = (full.null_space(NullSpaceMethod::Lu).unwrap(), other.null_space(NullSpaceMethod::Lu).unwrap());
        assert_eq!(a.independent, b.independent);
        let (rates, _) = other.solve_by(NullSpaceMethod::Lu).unwrap();
        assert!(distance(&(&units * rates), &full.solve().unwrap().0) < 1e-11);
    }
}
