use quote::ToTokens;

use super::super::*;
use super::declarations;
use crate::symbolic::Rational;

fn names(names: &[Name]) -> Vec<String> {
    names.iter().map(|name| name.ident.to_string()).collect()
}

#[test]
fn every_statement_is_read() {
    let model = declarations(
        r#"
        /// Not ours.
        #[serde(rename_all = "snake_case")]
        #[coordinates(
            /// along the plane
            /// and on
            x,
            y, phi,
        )]
        #[speeds(v1, v2, /** turning */ v3)]
        #[kinematics(v1 = dot(x)*cos(phi), dot(y) = -v2)]
        #[inertia(matrix([m, 0, 0], [_, m, a], [_, _, 1/2]))]
        #[forces(0, F, 9.81*m)]
        #[potential_energy(m*g*y)]
        #[constraint(roll: v1 + r*v3 == 0, touch: y == r)]
        #[constraint(more: x - (y) == -1e-3)]
        #[configuration(of(s), y = r, x = s)]
        #[independent(v3, dot(phi))]
        #[complement(w1 = [1, 0, -r], w2 = [0, 1, 0],)]
        #[inputs(F)]
        #[define(mu = r*r)]
        #[output(/** what drives */ power = F*v1, mu)]
        #[start(phi = PI/6)]
        #[holonomy(crate = my::holonomy, simplify = off)]
        pub(crate) struct Wheel<'a, S: Copy, const K: usize> where f64: From<S> {
            /// mass
            #[unit(kg)]
            pub m: f64,
            #[unit(m/s/s)] #[nominal(9.81)]
            g: S,
            r: core::primitive::f64,
            #[unit(1/powi(s, 2)*kg*m/kg)]
            a: f64,
            track: &'a [f64; K],
        }
        "#,
    );
    assert_eq!(model.ident, "Wheel");
    assert!(model.complete);
    assert_eq!(names(&model.coordinates), ["x", "y", "phi"]);
    assert_eq!(model.coordinates[0].docs, [" along the plane", " and on"]);
    let speeds = model.speeds.unwrap();
    assert_eq!(names(&speeds.names), ["v1", "v2", "v3"]);
    assert_eq!(speeds.names[2].docs, [" turning "]);
    let kinematics = model.kinematics.unwrap().entries;
    assert!(matches!(&kinematics[0].0, Quantity::Name(v1) if v1 == "v1"));
    assert!(matches!(&kinematics[1].0, Quantity::Rate(y, _) if y == "y"));
    let InertiaForm::Matrix(rows) = model.inertia.unwrap().form else {
        panic!("not a matrix");
    };
    assert!(matches!(rows[1].entries[0], InertiaEntry::Symmetric(_)));
    assert_eq!(model.forces.unwrap().entries.len(), 3);
    assert!(model.potential_energy.is_some());
    let constraints: Vec<String> = model.constraints.iter().map(|row| row.name.to_string()).collect();
    assert_eq!(constraints, ["roll", "touch", "more"]);
    let configuration = model.configuration.unwrap();
    assert_eq!(names(&configuration.further), ["s"]);
    assert_eq!(configuration.map.len(), 2);
    assert_eq!(model.independent[0].entries.len(), 2);
    let complement = model.complement.unwrap().rows;
    assert_eq!(complement[1].name, "w2");
    assert_eq!(complement[0].entries.len(), 3);
    assert_eq!(names(&model.inputs), ["F"]);
    assert_eq!(model.defines[0].name, "mu");
    let outputs: Vec<Name> = model.outputs.iter().map(|output| output.name.clone()).collect();
    assert_eq!(names(&outputs), ["power", "mu"]);
    assert_eq!(outputs[0].docs, [" what drives "]);
    assert_eq!(model.outputs[1].value.terms().len(), 1);
    assert_eq!(model.start[0].name, "phi");
    assert!(!model.options.simplify);
    assert_eq!(model.options.krate.to_token_stream().to_string(), "my :: holonomy");
    let scalars: Vec<bool> = model.fields.iter().map(|field| field.scalar).collect();
    assert_eq!(scalars, [true, true, true, true, false]);
    assert_eq!(model.fields[0].docs, [" mass"]);
    let unit = |name: &str, exponent| (name.to_owned(), exponent);
    assert_eq!(model.fields[1].unit.as_ref().unwrap().factors, [unit("m", 1), unit("s", -2)]);
    assert_eq!(model.fields[3].unit.as_ref().unwrap().factors, [unit("m", 1), unit("s", -2)]);
    assert_eq!(model.fields[1].nominal.as_ref().unwrap().terms().len(), 1);
}

#[test]
fn an_array_has_one_nominal_value_or_one_for_each_entry() {
    let model = declarations("struct Model { #[nominal(1, 2)] m: [f64; 2], #[nominal(3)] l: [f64; 2], g: [f64; 1] }");
    let values = model.fields.iter().map(|field| field.nominal.as_ref().map(|value| value.terms()[0].0.clone()));
    let number = |number: i64| Some(Term::Number(Rational::integer(number)));
    assert_eq!(values.collect::<Vec<_>>(), [number(1), number(2), number(3), number(3), None]);
}

#[test]
fn expressions_lie_in_postfix_order() {
    let model = declarations("#[forces(a - -b*atan2(c, 1/2))] struct Model;");
    let forces = model.forces.unwrap();
    let name = |name: &str| Term::Name(name.to_owned());
    let number = |number: i64| Term::Number(Rational::integer(number));
    let terms: Vec<Term> = forces.entries[0].terms().iter().map(|(term, _)| term.clone()).collect();
    let expected = [
        name("a"),
        name("b"),
        Term::Negative(1),
        name("c"),
        number(1),
        number(2),
        Term::Binary(Operator::Divide, 4, 5),
        Term::Call("atan2".to_owned(), vec![3, 6]),
        Term::Binary(Operator::Multiply, 2, 7),
        Term::Binary(Operator::Subtract, 0, 8),
    ];
    assert_eq!(terms, expected);
}

/// What `macro_rules` passes on as `$e:expr` arrives in invisible groups.
#[test]
fn invisible_groups_are_transparent() {
    use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
    let fragment: TokenStream = "a + b".parse().unwrap();
    let group = TokenTree::Group(Group::new(Delimiter::None, fragment));
    let model = parse(quote::quote!(
        #[forces(2 * #group)]
        struct Model;
    ))
    .unwrap();
    let terms = model.forces.unwrap().entries[0].terms().to_vec();
    let last = &terms[terms.len() - 1].0;
    assert!(matches!(last, Term::Binary(Operator::Multiply, 0, 3)));
}

#[test]
fn long_sums_need_no_stack() {
    let sum = vec!["a*-b"; 50_000].join(" - ");
    let model = declarations(&format!("#[forces({sum})] struct Model;"));
    assert_eq!(model.forces.unwrap().entries[0].terms().len(), 249_999);
}

#[test]
fn helper_attributes_are_distinct() {
    let names: std::collections::BTreeSet<&str> = helper_attributes().collect();
    assert_eq!(names.len(), helper_attributes().count());
}
