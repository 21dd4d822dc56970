//! Matrices of expressions.

use super::{Expr, Graph};

/// A dense matrix, row by row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Matrix {
    rows: usize,
    columns: usize,
    entries: Vec<Expr>,
}

impl Matrix {
    /// The matrix with the given entries.
    pub fn from_fn(rows: usize, columns: usize, mut entry: impl FnMut(usize, usize) -> Expr) -> Self {
        let entries = (0..rows * columns).map(|k| entry(k / columns, k % columns)).collect();
        Matrix { rows, columns, entries }
    }

    /// From rows of equal length; `columns` matters where there is no row.
    pub fn from_rows(rows: Vec<Vec<Expr>>, columns: usize) -> Self {
        debug_assert!(rows.iter().all(|row| row.len() == columns));
        Matrix { rows: rows.len(), columns, entries: rows.into_iter().flatten().collect() }
    }

    /// The zero matrix.
    pub fn zeros(graph: &Graph, rows: usize, columns: usize) -> Self {
        Matrix::from_fn(rows, columns, |_, _| graph.zero())
    }

    /// The unit matrix.
    pub fn identity(graph: &Graph, n: usize) -> Self {
        Matrix::from_fn(n, n, |i, j| if i == j { graph.one() } else { graph.zero() })
    }

    /// How many rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// How many columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// The entry in row i and column j.
    pub fn get(&self, i: usize, j: usize) -> Expr {
        self.entries[i * self.columns + j]
    }

    /// Replaces an entry.
    pub fn set(&mut self, i: usize, j: usize, value: Expr) {
        self.entries[i * self.columns + j] = value;
    }

    /// Row i.
    pub fn row(&self, i: usize) -> &[Expr] {
        &self.entries[i * self.columns..(i + 1) * self.columns]
    }

    /// All entries, row by row.
    pub fn entries(&self) -> &[Expr] {
        &self.entries
    }

    /// All entries, row by row, to be changed in place.
    pub fn entries_mut(&mut self) -> &mut [Expr] {
        &mut self.entries
    }

    /// The transpose.
    pub fn transpose(&self) -> Self {
        Matrix::from_fn(self.columns, self.rows, |i, j| self.get(j, i))
    }

    /// The rows with the given indices.
    pub fn select_rows(&self, rows: &[usize]) -> Self {
        Matrix::from_fn(rows.len(), self.columns, |i, j| self.get(rows[i], j))
    }

    /// The product with another matrix.
    pub fn mul(&self, graph: &mut Graph, other: &Matrix) -> Matrix {
        Matrix::from_fn(self.rows, other.columns, |i, j| {
            let terms: Vec<Expr> = (0..self.columns).map(|k| graph.mul(self.get(i, k), other.get(k, j))).collect();
            graph.sum(&terms)
        })
    }

    /// The product with a column.
    pub fn mul_vec(&self, graph: &mut Graph, vector: &[Expr]) -> Vec<Expr> {
        (0..self.rows)
            .map(|i| {
                let terms: Vec<Expr> = self.row(i).iter().zip(vector).map(|(a, b)| graph.mul(*a, *b)).collect();
                graph.sum(&terms)
            })
            .collect()
    }

    /// The matrix with every entry mapped, all at once.
    pub fn map(&self, f: impl FnOnce(&[Expr]) -> Vec<Expr>) -> Matrix {
        let entries = f(&self.entries);
        debug_assert_eq!(entries.len(), self.entries.len());
        Matrix { rows: self.rows, columns: self.columns, entries }
    }
}
