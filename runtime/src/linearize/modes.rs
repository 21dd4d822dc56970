//! Eigenvalues and eigenvectors.
//!
//! A matrix of a mechanism often falls apart: nothing depends on coordinates like the place on a plane or the angle of a wheel.
//! Its eigenvalues are those of the blocks whose entries all depend on each other (the matrix permuted to block triangular
//! form; Horn, Johnson, Matrix Analysis, section 6.2), and then the zeros that belong to such coordinates are exact: taken
//! together with the rates of the coordinates they belong to a Jordan block, of which rounding makes √ε.

use alloc::vec;
use alloc::vec::Vec;

use nalgebra::linalg::{Schur, balancing};
use nalgebra::{Complex, DMatrix, DVector};

use crate::Error;
use crate::math::double::sqrt;

const ITERATIONS: usize = 60;

/// All eigenvalues, the largest real part first; of equal ones the larger imaginary part first.
pub(super) fn eigenvalues(a: &DMatrix<f64>) -> Result<Vec<Complex<f64>>, Error> {
    let mut all = Vec::new();
    for block in blocks(a) {
        let part = DMatrix::from_fn(block.len(), block.len(), |i, j| a[(block[i], block[j])]);
        all.extend(of_block(part).ok_or(Error::NoConvergence { of: "the eigenvalues" })?);
    }
    // No zero is negative.
    all.iter_mut().for_each(|value| *value += Complex::new(0.0, 0.0));
    all.sort_by(|x, y| y.re.total_cmp(&x.re).then(y.im.total_cmp(&x.im)));
    Ok(all)
}

/// The classes of entries that depend on each other both ways, directly or by others.
fn blocks(a: &DMatrix<f64>) -> Vec<Vec<usize>> {
    let n = a.nrows();
    let mut reaches = DMatrix::from_fn(n, n, |i, j| i == j || a[(i, j)] != 0.0);
    for k in 0..n {
        for i in 0..n {
            if reaches[(i, k)] {
                (0..n)
                    .filter(|j| reaches[(k, *j)])
                    .collect::<Vec<_>>()
                    .into_iter()
                    .for_each(|j| reaches[(i, j)] = true);
            }
        }
    }
    let mut blocks: Vec<Vec<usize>> = Vec::new();
    for i in 0..n {
        match blocks.iter_mut().find(|block| reaches[(i, block[0])] && reaches[(block[0], i)]) {
            Some(block) => block.push(i),
            None => blocks.push(vec![i]),
        }
    }
    blocks
}

fn of_block(mut a: DMatrix<f64>) -> Option<Vec<Complex<f64>>> {
    let n = a.nrows();
    if n < 3 {
        return Some(of_triangle(&a));
    }
    balancing::balance_parlett_reinsch(&mut a);
    // Francis' shifts go in circles where they see an orthogonal matrix (a cyclic permutation, say); another base has others.
    let tries = [None, Some(0.61), Some(0.37)];
    tries.into_iter().find_map(|base| {
        let turned = match base {
            None => a.clone(),
            Some(seed) => turned(&a, seed),
        };
        let (_, t) = Schur::try_new(turned, f64::EPSILON, ITERATIONS * n)?.unpack();
        Some(of_triangle(&t))
    })
}

/// H A H with a reflection H.
fn turned(a: &DMatrix<f64>, seed: f64) -> DMatrix<f64> {
    let n = a.nrows();
    let axis = DVector::from_fn(n, |i, _| 1.0 + seed * (i * i % 7) as f64).normalize();
    let reflection = DMatrix::identity(n, n) - &axis * axis.transpose() * 2.0;
    &reflection * a * &reflection
}

/// Those of an upper triangle with blocks of two on its diagonal.
fn of_triangle(t: &DMatrix<f64>) -> Vec<Complex<f64>> {
    let (n, mut at, mut all) = (t.nrows(), 0, Vec::new());
    while at < n {
        if at + 1 < n && t[(at + 1, at)] != 0.0 {
            all.extend(of_pair(t[(at, at)], t[(at, at + 1)], t[(at + 1, at)], t[(at + 1, at + 1)]));
            at += 2;
        } else {
            all.push(Complex::new(t[(at, at)], 0.0));
            at += 1;
        }
    }
    all
}

/// Those of [a b; c d]: of real ones the smaller follows from the product, without cancellation.
fn of_pair(a: f64, b: f64, c: f64, d: f64) -> [Complex<f64>; 2] {
    let (half, product) = (0.5 * (a - d), b * c);
    let square = half * half + product;
    if square < 0.0 {
        let (mean, imaginary) = (0.5 * (a + d), sqrt(-square));
        return [Complex::new(mean, imaginary), Complex::new(mean, -imaginary)];
    }
    let far = half + if half < 0.0 { -sqrt(square) } else { sqrt(square) };
    let near = if far == 0.0 { 0.0 } else { product / far };
    [Complex::new(d + far, 0.0), Complex::new(d - near, 0.0)]
}

/// The direction that A multiplies by an eigenvalue, its largest entry one: inverse iteration, which needs two steps from any
/// start that has a part along it (Golub, Van Loan, Matrix Computations, section 7.6.1).
pub(super) fn direction(a: &DMatrix<f64>, eigenvalue: Complex<f64>) -> Result<Vec<Complex<f64>>, Error> {
    let n = a.nrows();
    // Next to the eigenvalue, not at it, the matrix can be inverted.
    let aside = 4.0 * f64::EPSILON * a.amax().max(f64::MIN_POSITIVE);
    let shift = eigenvalue + Complex::new(aside, aside);
    let shifted = DMatrix::from_fn(n, n, |i, j| {
        Complex::new(a[(i, j)], 0.0) - if i == j { shift } else { Complex::new(0.0, 0.0) }
    });
    let lu = shifted.lu();
    let mut x = DVector::from_fn(n, |i, _| Complex::new(1.0 + 0.37 * (i % 5) as f64, 0.11 * (i % 3) as f64));
    for _ in 0..3 {
        x = lu.solve(&x).ok_or(Error::NoConvergence { of: "an eigenvector" })?;
        let largest =
            x.iter().fold(
                Complex::new(0.0, 0.0),
                |largest, entry| {
                    if entry.norm_sqr() > largest.norm_sqr() { *entry } else { largest }
                },
            );
        if !(largest.norm_sqr() > 0.0 && largest.norm_sqr().is_finite()) {
            return Err(Error::NoConvergence { of: "an eigenvector" });
        }
        x /= largest;
    }
    Ok(x.iter().copied().collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(n: usize, entries: &[f64]) -> Vec<Complex<f64>> {
        eigenvalues(&DMatrix::from_row_slice(n, n, entries)).expect("they are found")
    }

    fn close(found: &[Complex<f64>], expected: &[(f64, f64)]) {
        assert_eq!(found.len(), expected.len());
        for (found, expected) in found.iter().zip(expected) {
            assert!((found.re - expected.0).abs() + (found.im - expected.1).abs() < 1e-13, "{found} {expected:?}");
        }
    }

    #[test]
    fn jordan_blocks_of_what_nothing_depends_on_are_exact() {
        // A wheel's angle, its rate, and a pendulum that does not know of them.
        let found = values(4, &[0., 1., 0., 0., 0., 0., 0., 0., 0., 0., 0., 1., 3., 0., -4., 0.]);
        assert_eq!(found, [(0.0, 2.0), (0.0, 0.0), (0.0, 0.0), (0.0, -2.0)].map(|(re, im)| Complex::new(re, im)));
    }

    #[test]
    fn a_cyclic_permutation_has_the_roots_of_one() {
        let h = 0.75_f64.sqrt();
        close(&values(3, &[0., 0., 1., 1., 0., 0., 0., 1., 0.]), &[(1.0, 0.0), (-0.5, h), (-0.5, -h)]);
        close(
            &values(4, &[0., 0., 0., 1., 1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1., 0.]),
            &[(1.0, 0.0), (0.0, 1.0), (0.0, -1.0), (-1.0, 0.0)],
        );
    }

    #[test]
    fn a_full_matrix_and_its_directions() {
        // (λ − 1)(λ − 2)(λ + 3)(λ² + 4) by its companion.
        let mut a = DMatrix::zeros(5, 5);
        for (j, coefficient) in [-24.0, 28.0, -6.0, 3.0, 0.0].into_iter().enumerate() {
            a[(4, j)] = coefficient;
        }
        (0..4).for_each(|i| a[(i, i + 1)] = 1.0);
        let found = eigenvalues(&a).expect("they are found");
        close(&found, &[(2.0, 0.0), (1.0, 0.0), (0.0, 2.0), (0.0, -2.0), (-3.0, 0.0)]);
        for value in found {
            let x = direction(&a, value).expect("it is found");
            for i in 0..5 {
                let product: Complex<f64> = (0..5).map(|j| x[j] * a[(i, j)]).sum();
                assert!((product - value * x[i]).norm_sqr() < 1e-24, "{value}");
            }
        }
    }
}
