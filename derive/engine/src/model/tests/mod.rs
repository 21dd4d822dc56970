//! Whole models: built, or refused at the right token.

mod building;
mod errors;
mod expressions;
mod kinematics;
mod mutations;
mod statements;

use super::{InitialSystem, build};
use crate::symbolic::{Expr, Matrix};
use crate::syntax::tests::{declarations, rendered};

/// The system of a model without errors.
fn system(source: &str) -> InitialSystem {
    match build(&declarations(source)) {
        Ok(system) => system,
        Err(errors) => panic!("{:#?}", rendered(source, &errors)),
    }
}

/// The errors of a model that can be read.
fn errors(source: &str) -> Vec<String> {
    match build(&declarations(source)) {
        Ok(_) => Vec::new(),
        Err(errors) => rendered(source, &errors),
    }
}

/// An expression over the system's own symbols, from its text.
fn parse(system: &mut InitialSystem, text: &str) -> Expr {
    let all: Vec<(String, Expr)> =
        system.graph.symbols().map(|symbol| (system.graph.name(symbol).to_owned(), system.graph.var(symbol))).collect();
    let wrapped = declarations(&format!("#[forces({text})] struct Model;"));
    let entries = wrapped.forces.unwrap().entries;
    let graph = &mut system.graph;
    let mut values: Vec<Expr> = Vec::new();
    use crate::syntax::{Operator, Term};
    for (term, _) in entries[0].terms() {
        let value = match term {
            Term::Number(number) => graph.number(number.clone()),
            Term::Name(name) => all.iter().find(|(other, _)| other == name).unwrap().1,
            Term::Negative(of) => graph.neg(values[*of]),
            Term::Binary(operator, a, b) => {
                let (a, b) = (values[*a], values[*b]);
                match operator {
                    Operator::Add => graph.add(a, b),
                    Operator::Subtract => graph.sub(a, b),
                    Operator::Multiply => graph.mul(a, b),
                    Operator::Divide => graph.div(a, b),
                }
            }
            Term::Call(function, arguments) => match function.as_str() {
                "sin" => graph.sin(values[arguments[0]]),
                "cos" => graph.cos(values[arguments[0]]),
                "tan" => graph.tan(values[arguments[0]]),
                "sqrt" => graph.sqrt(values[arguments[0]]),
                _ => panic!("{function}"),
            },
            Term::If(..) | Term::Axis(..) | Term::Hole => panic!("not in these texts"),
        };
        values.push(value);
    }
    values.pop().unwrap()
}

/// Whether the expressions are those of the texts.
fn assert_all(system: &mut InitialSystem, found: &[Expr], expected: &[&str]) {
    assert_eq!(found.len(), expected.len());
    for (found, text) in found.iter().zip(expected) {
        let expected = parse(system, text);
        let shown = system.graph.display(*found);
        assert!(system.graph.identical(*found, expected), "{shown} is not {text}");
    }
}

fn assert_matrix(system: &mut InitialSystem, found: &Matrix, expected: &[&[&str]]) {
    for (i, row) in expected.iter().enumerate() {
        assert_all(system, found.row(i), row);
    }
}

fn assert_unit(system: &mut InitialSystem, product: &Matrix) {
    for i in 0..product.rows() {
        for j in 0..product.columns() {
            let unit = if i == j { system.graph.one() } else { system.graph.zero() };
            assert!(system.graph.identical(product.get(i, j), unit), "entry ({i}, {j})");
        }
    }
}

/// The disk of Blajer 1992, section 6: kinematics (6.3), inertia (6.9), forces (6.10).
const DISK: &str = "
#[coordinates(x, y, z, phi, theta, psi)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x)*cos(phi) + dot(y)*sin(phi) - r*sin(theta)*dot(phi),
    v2 = -dot(x)*sin(theta)*sin(phi) + dot(y)*sin(theta)*cos(phi) + dot(z)*cos(theta),
    v3 = dot(x)*cos(theta)*sin(phi) - dot(y)*cos(theta)*cos(phi) + dot(z)*sin(theta) - r*dot(theta),
    v4 = -dot(theta),
    v5 = dot(phi)*cos(theta),
    v6 = dot(psi) + dot(phi)*sin(theta),
)]
#[inertia(diag(m, m, m, j, j, 2*j))]
#[forces(
    m*v5*(v2*tan(theta) - v3),
    m*(v4*v3 - v5*v1*tan(theta) - g*cos(theta)),
    m*(v5*v1 - v4*v2 - g*sin(theta)),
    j*v5*(v5*tan(theta) - 2*v6),
    j*v4*(2*v6 - v5*tan(theta)),
    0,
)]
#[potential_energy(m*g*(z + r*cos(theta)))]
";

const FIELDS: &str = "struct Disk { m: f64, r: f64, j: f64, #[nominal(9.81)] g: f64, unused: f64 }";
