//! Small dense algebra over any number.

use super::number::Number;

/// Solves a x = b with row interchanges chosen by value, so that it can be differentiated through.
///
/// # Panics
/// If the matrix is singular at this very point.
pub fn solve<N: Number>(mut a: Vec<Vec<N>>, mut b: Vec<N>) -> Vec<N> {
    let n = b.len();
    for k in 0..n {
        let largest = |i: &usize, j: &usize| a[*i][k].value().abs().total_cmp(&a[*j][k].value().abs());
        let pivot = (k..n).max_by(largest).expect("a row");
        assert!(a[pivot][k].value() != 0.0, "kinematics are singular here");
        a.swap(k, pivot);
        b.swap(k, pivot);
        let (above, below) = a.split_at_mut(k + 1);
        for (i, row) in below.iter_mut().enumerate() {
            let factor = row[k] / above[k][k];
            row.iter_mut().zip(&above[k]).skip(k + 1).for_each(|(entry, pivot)| *entry = *entry - factor * *pivot);
            b[k + 1 + i] = b[k + 1 + i] - factor * b[k];
        }
    }
    for k in (0..n).rev() {
        let known = (k + 1..n).fold(b[k], |sum, j| sum - a[k][j] * b[j]);
        b[k] = known / a[k][k];
    }
    b
}

/// The j-th unit direction laid on a point: entry j moves, the others stand still.
pub fn seeded<N: Number>(point: &[N], j: usize) -> Vec<super::number::Dual<N>> {
    let rate = |i: usize| if i == j { N::one() } else { N::zero() };
    point.iter().enumerate().map(|(i, &x)| super::number::Dual::moving(x, rate(i))).collect()
}

/// A point that moves with the given rates.
pub fn along<N: Number>(point: &[N], rates: &[N]) -> Vec<super::number::Dual<N>> {
    point.iter().zip(rates).map(|(&x, &rate)| super::number::Dual::moving(x, rate)).collect()
}

/// A point that stands still.
pub fn fixed<N: Number>(point: &[N]) -> Vec<super::number::Dual<N>> {
    point.iter().map(|&x| super::number::Dual::fixed(x)).collect()
}

/// The j-th unit direction at the origin.
pub fn unit<N: Number>(n: usize, j: usize) -> Vec<super::number::Dual<N>> {
    seeded(&vec![N::zero(); n], j)
}
