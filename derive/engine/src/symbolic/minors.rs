//! The adjugate of a block of more than three rows, by minors that are made of each other.
//!
//! Every minor of the first rows is expanded along the last of them, every minor of the last rows along the first of them,
//! and a cofactor is the sum over products of the two that Laplace's expansion along the upper rows gives. Nothing is
//! divided, so that the inverse has the determinant as its only divisor: it is regular wherever the block is, whatever
//! entries vanish there. An elimination has to exchange rows while it runs to be as regular, and on lanes every exchange
//! selects between two values for every entry: as many selections as it has multiplications, for which no derivative, no
//! identity and no common factor would be known any more. Mechanisms have sparse blocks, and a minor that is zero by its
//! pattern costs nothing.

use super::{Expr, Graph, Matrix, Rational};

/// Products that the minors of one block may take: those of a full block with six rows.
const MOST_PRODUCTS: usize = 600;
/// Rows of a block beyond which its minors are not even counted.
const MOST_ROWS: usize = 10;

/// Adjugate and determinant; `None` where the pattern has too many minors. `tidy` gives each minor a cheap form.
pub fn by_minors(
    graph: &mut Graph,
    block: &Matrix,
    tidy: &mut dyn FnMut(&mut Graph, Expr) -> Expr,
) -> Option<(Matrix, Expr)> {
    let n = block.rows();
    let filled = |i: usize, j: usize| !graph.is_zero(block.get(i, j));
    if n > MOST_ROWS || products(n, &filled) > MOST_PRODUCTS {
        return None;
    }
    let (upper, lower) = (minors(graph, block, true, tidy), minors(graph, block, false, tidy));
    let all = (1usize << n) - 1;
    let mut adjugate = Matrix::zeros(graph, n, n);
    for i in 0..n {
        for j in 0..n {
            let mut terms = Vec::new();
            for (above, below) in splits(all ^ (1 << j), i) {
                let (a, b) = (upper[above], lower[below]);
                if !graph.is_zero(a) && !graph.is_zero(b) {
                    let odd = odd(above, all ^ (1 << j)) != ((i + j) % 2 == 1);
                    terms.push((sign(odd), graph.mul(a, b)));
                }
            }
            let cofactor = graph.linear(Rational::ZERO, &terms);
            let cofactor = tidy(graph, cofactor);
            adjugate.set(j, i, cofactor);
        }
    }
    Some((adjugate, upper[all]))
}

/// The minors of the first rows or of the last ones, by the set of their columns, one bit each.
fn minors(graph: &mut Graph, block: &Matrix, first: bool, tidy: &mut dyn FnMut(&mut Graph, Expr) -> Expr) -> Vec<Expr> {
    let n = block.rows();
    let mut found = vec![graph.one()];
    for set in 1..1usize << n {
        let rows = set.count_ones() as usize;
        let row = if first { rows - 1 } else { n - rows };
        let mut terms = Vec::new();
        for (position, column) in (0..n).filter(|j| set >> j & 1 == 1).enumerate() {
            let (entry, rest) = (block.get(row, column), found[set ^ (1 << column)]);
            if !graph.is_zero(entry) && !graph.is_zero(rest) {
                let odd = (if first { rows - 1 + position } else { position }) % 2 == 1;
                terms.push((sign(odd), graph.mul(entry, rest)));
            }
        }
        let minor = graph.linear(Rational::ZERO, &terms);
        found.push(tidy(graph, minor));
    }
    found
}

/// The products that [`by_minors`] forms for a pattern.
fn products(n: usize, filled: &dyn Fn(usize, usize) -> bool) -> usize {
    let mut count = 0;
    let mut pattern = |first: bool| {
        let mut found = vec![true];
        for set in 1..1usize << n {
            let rows = set.count_ones() as usize;
            let row = if first { rows - 1 } else { n - rows };
            let terms = (0..n).filter(|j| set >> j & 1 == 1 && filled(row, *j) && found[set ^ (1 << j)]).count();
            count += terms;
            found.push(terms > 0);
        }
        found
    };
    let (upper, lower) = (pattern(true), pattern(false));
    let all = (1usize << n) - 1;
    for j in 0..n {
        for i in 0..n {
            count += splits(all ^ (1 << j), i).filter(|(above, below)| upper[*above] && lower[*below]).count();
        }
    }
    count
}

/// The ways to take so many columns of a set for the upper rows, and the others for the lower ones.
fn splits(columns: usize, taken: usize) -> impl Iterator<Item = (usize, usize)> {
    let subsets = (0..=columns).filter(move |set| set & !columns == 0 && set.count_ones() as usize == taken);
    subsets.map(move |set| (set, columns ^ set))
}

/// Whether Laplace's expansion along the first rows takes these columns of a set with a minus.
fn odd(taken: usize, columns: usize) -> bool {
    let mut exchanges = 0;
    let mut left = taken;
    while left != 0 {
        let column = left.trailing_zeros();
        // Columns before it that are not taken are passed over.
        exchanges += (columns & !taken & ((1 << column) - 1)).count_ones();
        left &= left - 1;
    }
    exchanges % 2 == 1
}

fn sign(odd: bool) -> Rational {
    if odd { Rational::MINUS_ONE } else { Rational::ONE }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbolic::Kind;

    /// A matrix of symbols where the pattern has an x.
    fn of(graph: &mut Graph, pattern: &[&str]) -> Matrix {
        let n = pattern.len();
        Matrix::from_fn(n, n, |i, j| match pattern[i].as_bytes()[j] {
            b'x' => {
                let symbol = graph.symbol(&format!("a{i}{j}"), Kind::Coordinate);
                graph.var(symbol)
            }
            _ => graph.zero(),
        })
    }

    #[test]
    fn a_block_times_its_adjugate_is_its_determinant() {
        for pattern in [
            ["xxxx"; 4].as_slice(),
            &["xxxxx"; 5],
            &["xx..", ".xx.", "..xx", "x..x"],
            &["xx.x.", "x.xx.", ".xx.x", "x..xx", ".x.xx"],
        ] {
            let mut graph = Graph::new();
            let block = of(&mut graph, pattern);
            let (adjugate, determinant) = by_minors(&mut graph, &block, &mut |_, e| e).expect("few minors");
            assert!(!graph.vanishes(determinant));
            for product in [block.mul(&mut graph, &adjugate), adjugate.mul(&mut graph, &block)] {
                for i in 0..block.rows() {
                    for j in 0..block.rows() {
                        let expected = if i == j { determinant } else { graph.zero() };
                        assert!(graph.identical(product.get(i, j), expected), "{pattern:?} {i} {j}");
                    }
                }
            }
        }
    }

    #[test]
    fn the_bound_is_that_of_six_full_rows() {
        assert!((500..=MOST_PRODUCTS).contains(&products(6, &|_, _| true)));
        assert!(products(7, &|_, _| true) > MOST_PRODUCTS);
        // A chain of loops has few minors however long it is.
        assert!(products(10, &|i, j| j == i || j == (i + 1) % 10) <= MOST_PRODUCTS);
    }
}
