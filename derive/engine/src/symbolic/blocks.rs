//! The block-triangular form of a square pattern, and the inverse of a small block as a whole.

use super::{Expr, Graph, Matrix};

/// Blocks up to this size are inverted by cofactors.
pub const COFACTORS: usize = 3;

/// Rows and columns that can only be solved together.
#[derive(Debug, PartialEq)]
pub struct Block {
    /// The rows.
    pub rows: Vec<usize>,
    /// As many columns.
    pub columns: Vec<usize>,
}

/// The smallest blocks, in an order in which a block's rows have entries only in its own columns and in those of
/// earlier blocks. `None` if the pattern alone makes the matrix singular.
pub fn triangular(n: usize, filled: impl Fn(usize, usize) -> bool) -> Option<Vec<Block>> {
    let column_of = matching(n, &filled)?;
    // Row i needs row k if it has an entry in the column of k; then who needs whom, however indirectly.
    let mut needs: Vec<Vec<bool>> =
        (0..n).map(|i| (0..n).map(|k| i == k || filled(i, column_of[k])).collect()).collect();
    for via in 0..n {
        let through = needs[via].clone();
        for row in needs.iter_mut().filter(|row| row[via]) {
            row.iter_mut().zip(&through).for_each(|(needs, also)| *needs |= *also);
        }
    }
    // A block needs all that its rows need, so blocks with fewer needs come first.
    let mut order: Vec<usize> = (0..n).collect();
    let count: Vec<usize> = needs.iter().map(|row| row.iter().filter(|needs| **needs).count()).collect();
    order.sort_by_key(|&i| (count[i], i));
    let mut blocks: Vec<Block> = Vec::new();
    let mut placed = vec![false; n];
    for &first in &order {
        if placed[first] {
            continue;
        }
        let rows: Vec<usize> = (0..n).filter(|&i| needs[first][i] && needs[i][first]).collect();
        rows.iter().for_each(|&i| placed[i] = true);
        let columns = rows.iter().map(|&i| column_of[i]).collect();
        blocks.push(Block { rows, columns });
    }
    Some(blocks)
}

/// A column for each row, all different, with an entry there: augmenting paths, searched breadth first.
fn matching(n: usize, filled: &impl Fn(usize, usize) -> bool) -> Option<Vec<usize>> {
    let mut row_of: Vec<Option<usize>> = vec![None; n];
    for start in 0..n {
        // The row from which each column was reached.
        let mut from: Vec<Option<usize>> = vec![None; n];
        let mut queue = std::collections::VecDeque::from([start]);
        let mut free = None;
        while let (Some(row), None) = (queue.pop_front(), free) {
            for column in (0..n).filter(|&column| filled(row, column)) {
                if from[column].is_some() {
                    continue;
                }
                from[column] = Some(row);
                match row_of[column] {
                    Some(next) => queue.push_back(next),
                    None => {
                        free = Some(column);
                        break;
                    }
                }
            }
        }
        let mut column = free?;
        // Hand every column on the path over to the row that reached it.
        while let Some(row) = from[column] {
            let before = row_of.iter().position(|owner| *owner == Some(row));
            row_of[column] = Some(row);
            match before {
                Some(released) if row != start => column = released,
                _ => break,
            }
        }
    }
    let mut column_of = vec![0; n];
    for (column, row) in row_of.iter().enumerate() {
        column_of[(*row)?] = column;
    }
    Some(column_of)
}

/// Adjugate and determinant of a block of up to three rows.
pub fn cofactors(graph: &mut Graph, block: &Matrix) -> (Matrix, Expr) {
    let n = block.rows();
    let adjugate = match n {
        1 => Matrix::identity(graph, 1),
        2 => Matrix::from_fn(2, 2, |i, j| {
            let entry = block.get(1 - j, 1 - i);
            if i == j { entry } else { graph.neg(entry) }
        }),
        _ => Matrix::from_fn(n, n, |i, j| {
            // The cyclic minor carries its sign.
            let at = |a: usize, b: usize| block.get((j + a) % 3, (i + b) % 3);
            let main = graph.mul(at(1, 1), at(2, 2));
            let other = graph.mul(at(1, 2), at(2, 1));
            graph.sub(main, other)
        }),
    };
    let terms: Vec<Expr> = (0..n).map(|k| graph.mul(block.get(0, k), adjugate.get(k, 0))).collect();
    let determinant = graph.sum(&terms);
    (adjugate, determinant)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(pattern: &[&str]) -> Option<Vec<Block>> {
        triangular(pattern.len(), |i, j| pattern[i].as_bytes()[j] == b'x')
    }

    #[test]
    fn finds_the_blocks_in_order() {
        let blocks = of(&["xx..", ".xx.", "..xx", "..xx"]).unwrap();
        let rows: Vec<Vec<usize>> = blocks.iter().map(|block| block.rows.clone()).collect();
        assert_eq!(rows, [vec![2, 3], vec![1], vec![0]]);
        assert_eq!(blocks[2].columns, [0]);
    }

    #[test]
    fn augments_along_paths() {
        let blocks = of(&["xx.", "x..", ".xx"]).unwrap();
        assert_eq!(blocks.iter().map(|block| block.rows.len()).collect::<Vec<_>>(), [1, 1, 1]);
        assert_eq!(of(&["x.", "x."]), None);
        assert_eq!(of(&["xx.", "xx.", "xx."]), None);
    }
}
