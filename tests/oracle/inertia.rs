//! Moments and products of inertia as they are declared.

use super::evaluate::Scope;
use super::geometry::Record;
use super::number::Number;
use super::statements::plain;
use super::vectors::{Axes, Vector, difference, index, inner};
use syn::Expr;

/// R I Rᵀ, the axes being the columns of R.
pub(super) fn in_the_world<N: Number>(inertia: &[Vector<N>; 3], axes: &Axes<N>) -> [Vector<N>; 3] {
    let entry = |i: usize, j: usize| {
        let pairs = (0..9).map(|k| axes[k / 3][i] * inertia[k / 3][k % 3] * axes[k % 3][j]);
        pairs.fold(N::zero(), |sum, part| sum + part)
    };
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}

/// The inertia about the mass centre in axes of the body's frame.
pub(super) fn central<N: Number>(record: &Record, scope: &Scope<'_, N>, mass: N, axes: &Axes<N>) -> [Vector<N>; 3] {
    let mut inertia = declared(record.entry("inertia"), scope);
    if let Some(point) = record.entries.get("about") {
        // Steiner: I about P = I about C + m (d² − d dᵀ), d from C to P
        let away = difference(&scope.vector(point), &scope.vector(record.center()));
        let d: Vector<N> = std::array::from_fn(|i| inner(&axes[i], &away));
        for i in 0..3 {
            for j in 0..3 {
                let square = if i == j { inner(&d, &d) } else { N::zero() };
                inertia[i][j] = inertia[i][j] - mass * (square - d[i] * d[j]);
            }
        }
    }
    inertia
}

/// What stands under `inertia`.
fn declared<N: Number>(e: &Expr, scope: &Scope<'_, N>) -> [Vector<N>; 3] {
    let Expr::Call(call) = e else { panic!("not an inertia") };
    let form = plain(&call.func).expect("a form of inertia");
    let arguments: Vec<&Expr> = call.args.iter().collect();
    let number = |i: usize| scope.value(arguments[i]);
    let constant = N::constant;
    let square = |e: N| e * e;
    let diagonal =
        |of: [N; 3]| std::array::from_fn(|i| std::array::from_fn(|j| if i == j { of[i] } else { N::zero() }));
    let about = |axis: usize, axial: N, across: N| {
        let axis = plain(arguments[axis]).and_then(|axis| index(&axis)).expect("x, y or z");
        diagonal(std::array::from_fn(|i| if i == axis { axial } else { across }))
    };
    match form.as_str() {
        "rod" => about(2, N::zero(), number(0) * square(number(1)) / constant(12.0)),
        "disk" => {
            let polar = number(0) * square(number(1)) / constant(2.0);
            about(2, polar, polar / constant(2.0))
        }
        "cylinder" => {
            let across = constant(3.0) * square(number(1)) + square(number(2));
            about(3, number(0) * square(number(1)) / constant(2.0), number(0) * across / constant(12.0))
        }
        "sphere" => diagonal([constant(0.4) * number(0) * square(number(1)); 3]),
        "cuboid" => {
            let edges = [square(number(1)), square(number(2)), square(number(3))];
            let of = |i: usize| number(0) * (edges[(i + 1) % 3] + edges[(i + 2) % 3]) / constant(12.0);
            diagonal(std::array::from_fn(of))
        }
        "planar" => diagonal([N::zero(), N::zero(), number(0)]),
        "diag" => diagonal([number(0), number(1), number(2)]),
        "matrix" => {
            let entry = |i: usize, j: usize| {
                let Expr::Array(row) = arguments[i] else { panic!("not a row") };
                match &row.elems[j] {
                    Expr::Infer(_) => None,
                    e => Some(scope.value(e)),
                }
            };
            let either =
                |i: usize, j: usize| entry(i, j).or_else(|| entry(j, i)).expect("an entry or its mirror image");
            std::array::from_fn(|i| std::array::from_fn(|j| either(i, j)))
        }
        other => panic!("{other} is no inertia"),
    }
}
