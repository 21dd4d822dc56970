//! The struct's fields with their units and nominal values.

use std::collections::BTreeMap;

use proc_macro2::{Ident, Literal};
use quote::quote;
use syn::{Attribute, Data, DeriveInput, Expr, ExprLit, Fields, GenericParam, Lit, Meta, Type};

use super::declarations::{Field, Unit};
use super::diagnostics::{Diagnostics, messages};
use super::entries;
use super::expression::{Expression, Operator, Term};
use super::families::element_name;
use super::read::{Statement, statement};
use super::statements::FIELD_STATEMENTS;

/// The fields of a struct.
#[derive(Default)]
pub(crate) struct Read {
    /// The fields in order, arrays entry by entry.
    pub fields: Vec<Field>,
    /// The arrays; `None` where the length is no literal.
    pub arrays: BTreeMap<String, Option<i64>>,
}

/// The fields in order; none where the input is not a struct with named fields.
pub(crate) fn read(input: &DeriveInput, diagnostics: &mut Diagnostics) -> Read {
    let fields = match &input.data {
        Data::Struct(data) => match &data.fields {
            Fields::Named(fields) => &fields.named,
            Fields::Unit => return Read::default(),
            Fields::Unnamed(fields) => {
                diagnostics.report(fields.paren_token.span.open(), messages::tuple_struct());
                return Read::default();
            }
        },
        Data::Enum(data) => {
            diagnostics.report(data.enum_token.span, messages::not_a_struct("an enum"));
            return Read::default();
        }
        Data::Union(data) => {
            diagnostics.report(data.union_token.span, messages::not_a_struct("a union"));
            return Read::default();
        }
    };
    let parameters: Vec<String> = input
        .generics
        .params
        .iter()
        .filter_map(|parameter| match parameter {
            GenericParam::Type(parameter) => Some(parameter.ident.to_string()),
            _ => None,
        })
        .collect();
    let mut read = Read::default();
    for field in fields {
        let Some(ident) = field.ident.clone() else {
            continue;
        };
        let mut unit = None;
        let mut nominal: Option<(Ident, Vec<Expression>)> = None;
        for attribute in &field.attrs {
            let Some(statement) = statement(attribute, FIELD_STATEMENTS, diagnostics) else {
                continue;
            };
            let slot = if statement.name == "unit" { unit.is_some() } else { nominal.is_some() };
            if slot {
                diagnostics.report_local(&statement.name, messages::statement_twice(&statement.name));
                continue;
            }
            if statement.name == "unit" {
                unit = unit_of(&statement, diagnostics);
            } else {
                nominal = values(&statement, diagnostics).map(|values| (statement.name, values));
            }
        }
        let one = Field {
            scalar: is_scalar(&field.ty, &parameters),
            docs: docs(&field.attrs),
            member: quote!(#ident),
            ident: ident.clone(),
            ty: field.ty.clone(),
            unit,
            nominal: None,
        };
        match array(&field.ty).filter(|(element, _)| is_scalar(element, &parameters)) {
            Some((element, Some(length))) => {
                read.arrays.insert(ident.to_string(), Some(length));
                let nominal = each(nominal, length, &ident, diagnostics);
                let entries = (0..length).zip(nominal).map(|(index, nominal)| {
                    let place = Literal::i64_unsuffixed(index);
                    Field {
                        scalar: true,
                        member: quote!(#ident[#place]),
                        ident: Ident::new(&element_name(&ident, index), ident.span()),
                        ty: element.clone(),
                        nominal,
                        ..one.clone()
                    }
                });
                read.fields.extend(entries);
            }
            Some((_, None)) => {
                read.arrays.insert(ident.to_string(), None);
                read.fields.push(Field { nominal: alone(nominal, diagnostics), ..one });
            }
            None => read.fields.push(Field { nominal: alone(nominal, diagnostics), ..one }),
        }
    }
    read
}

/// Element and length of an array type; no length where it is no literal, or where it is beyond all use.
fn array(ty: &Type) -> Option<(&Type, Option<i64>)> {
    let mut ty = ty;
    loop {
        match ty {
            Type::Group(group) => ty = &group.elem,
            Type::Paren(paren) => ty = &paren.elem,
            Type::Array(array) => {
                let length = match &array.len {
                    Expr::Lit(ExprLit { lit: Lit::Int(length), .. }) => length.base10_parse::<i64>().ok(),
                    _ => None,
                };
                return Some((&array.elem, length.filter(|length| *length <= entries::LONGEST)));
            }
            _ => return None,
        }
    }
}

/// The expressions in a statement's parentheses, one at least.
fn values(statement: &Statement, diagnostics: &mut Diagnostics) -> Option<Vec<Expression>> {
    let entries = entries::split(statement.tokens.clone(), statement.end);
    if entries.is_empty() {
        diagnostics.report(&statement.name, messages::statement_empty(&statement.name));
        return None;
    }
    Some(entries.iter().map(|entry| entry.expression(diagnostics)).collect())
}

/// The value of a field that is no array.
fn alone(nominal: Option<(Ident, Vec<Expression>)>, diagnostics: &mut Diagnostics) -> Option<Expression> {
    let (_, values) = nominal?;
    if let Some(second) = values.get(1) {
        diagnostics.report(second.place(), messages::one_expression());
    }
    values.into_iter().next()
}

/// The values of an array's entries: one for all, or a list.
fn each(
    nominal: Option<(Ident, Vec<Expression>)>,
    length: i64,
    array: &Ident,
    diagnostics: &mut Diagnostics,
) -> Vec<Option<Expression>> {
    let length = usize::try_from(length).unwrap_or(0);
    let Some((statement, values)) = nominal else { return vec![None; length] };
    if values.len() != 1 && values.len() != length {
        let (found, entries) =
            (messages::counted(values.len(), "value", "values"), messages::counted(length, "entry", "entries"));
        diagnostics.report(&statement, messages::nominal_of_array(found, array, entries));
    }
    let last = values.last().cloned();
    let all = if values.len() == 1 { vec![last; length] } else { values.into_iter().map(Some).collect() };
    all.into_iter().chain(std::iter::repeat(None)).take(length).collect()
}

/// The one expression in a statement's parentheses.
fn single(statement: &Statement, diagnostics: &mut Diagnostics) -> Option<Expression> {
    let entries = entries::split(statement.tokens.clone(), statement.end);
    match entries.as_slice() {
        [entry] => Some(entry.expression(diagnostics)),
        [] => {
            let name = &statement.name;
            diagnostics.report(name, messages::statement_empty(name));
            None
        }
        [_, second, ..] => {
            diagnostics.report(second.place(), messages::one_expression());
            None
        }
    }
}

/// Whether a type is written `f64` (with or without its path) or is a type parameter. Fragments
/// that a `macro_rules` passes on are wrapped in invisible groups.
fn is_scalar(ty: &Type, parameters: &[String]) -> bool {
    let mut ty = ty;
    loop {
        match ty {
            Type::Group(group) => ty = &group.elem,
            Type::Paren(paren) => ty = &paren.elem,
            Type::Path(path) if path.qself.is_none() => {
                let single = path.path.get_ident();
                let last = path.path.segments.last();
                return last.is_some_and(|last| last.ident == "f64")
                    || single.is_some_and(|ident| parameters.contains(&ident.to_string()));
            }
            _ => return false,
        }
    }
}

fn docs(attributes: &[Attribute]) -> Vec<String> {
    attributes
        .iter()
        .filter(|attribute| attribute.path().is_ident("doc"))
        .filter_map(|attribute| match &attribute.meta {
            Meta::NameValue(pair) => match &pair.value {
                Expr::Lit(literal) => match &literal.lit {
                    Lit::Str(text) => Some(text.value()),
                    _ => None,
                },
                _ => None,
            },
            _ => None,
        })
        .collect()
}

/// The unit in a statement's parentheses.
pub(super) fn unit_of(statement: &Statement, diagnostics: &mut Diagnostics) -> Option<Unit> {
    single(statement, diagnostics).and_then(|value| unit(&value, diagnostics))
}

/// Reads `kg*m/s`: names, `1`, `*`, `/` and `powi`.
fn unit(expression: &Expression, diagnostics: &mut Diagnostics) -> Option<Unit> {
    let refused = |diagnostics: &mut Diagnostics, span| {
        diagnostics.report_local(span, messages::unit_form());
        None
    };
    // The value of each term: factors of a unit, or the whole number that is an exponent.
    type Factors = Vec<(String, i32)>;
    let mut values: Vec<(Factors, Option<i32>)> = Vec::new();
    for (term, span) in expression.terms() {
        let value = match term {
            Term::Name(name) => (vec![(name.clone(), 1)], None),
            Term::Number(number) => {
                let whole = number.as_integer().and_then(|whole| i32::try_from(whole).ok());
                let Some(whole) = whole else { return refused(diagnostics, *span) };
                (Vec::new(), Some(whole))
            }
            Term::Hole => return None,
            Term::If(..) | Term::Axis(..) => return refused(diagnostics, *span),
            Term::Negative(of) => match values[*of].1 {
                Some(number) => (Vec::new(), number.checked_neg()),
                None => return refused(diagnostics, *span),
            },
            Term::Binary(operator, left, right) => {
                let sign = match operator {
                    Operator::Multiply => 1,
                    Operator::Divide => -1,
                    _ => return refused(diagnostics, *span),
                };
                let mut factors = values[*left].0.clone();
                for (name, exponent) in &values[*right].0 {
                    factors.push((name.clone(), exponent.saturating_mul(sign)));
                }
                // Only 1 is a unit among the numbers.
                let number = |of: usize| values[of].1.is_some_and(|number| number != 1);
                if number(*left) || number(*right) {
                    return refused(diagnostics, *span);
                }
                (factors, None)
            }
            Term::Call(function, arguments) => match arguments.as_slice() {
                [base, exponent] if function == "powi" => match values[*exponent].1 {
                    Some(exponent) => {
                        let factors = values[*base].0.iter();
                        let raised = factors.map(|(name, e)| (name.clone(), e.saturating_mul(exponent))).collect();
                        (raised, None)
                    }
                    None => return refused(diagnostics, *span),
                },
                _ => return refused(diagnostics, *span),
            },
        };
        values.push(value);
    }
    let (factors, number) = values.pop()?;
    if number.is_some_and(|number| number != 1) {
        diagnostics.report_local(expression.place(), messages::unit_form());
        return None;
    }
    let mut sums = BTreeMap::new();
    for (name, exponent) in factors {
        let sum: &mut i32 = sums.entry(name).or_default();
        *sum = sum.saturating_add(exponent);
    }
    sums.retain(|_, exponent| *exponent != 0);
    let names = expression.terms().iter().filter_map(|(term, span)| match term {
        Term::Name(name) => Some((name.clone(), *span)),
        _ => None,
    });
    Some(Unit { factors: sums.into_iter().collect(), names: names.collect() })
}
