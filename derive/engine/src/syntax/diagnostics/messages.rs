//! Every message about a model, in one table.
//!
//! In rustc's style: lower case at the start, the culprit in backticks, then what to do.

use std::fmt::Display;

/// Turns the table into one function per message, whose arguments are what the text names.
macro_rules! messages {
    ($($(#[$doc:meta])* $name:ident($($argument:ident),*) = $text:literal;)*) => {
        $(
            $(#[$doc])*
            pub(crate) fn $name($($argument: impl Display),*) -> String {
                format!($text)
            }
        )*
    };
}

// The input as a whole.
messages! {
    not_a_struct(what) =
        "a mechanism is declared on a struct with named fields, not on {what}";
    tuple_struct() =
        "the parameters of a mechanism need names: use a struct with named fields";
    too_deep(depth) =
        "nested more than {depth} deep; name a part of it with `define`";
}

// Statements.
messages! {
    statement_unknown(name, meant) =
        "there is no statement `{name}`; did you mean `{meant}`?";
    statement_planned(name) =
        "the statement `{name}` is not supported yet; state the equations with `inertia`, `forces` and `constraint`";
    statement_on_field(name) =
        "the statement `{name}` belongs on the struct, not on a field";
    statement_on_struct(name) =
        "the statement `{name}` belongs on a field, not on the struct";
    statement_twice(name) =
        "`{name}` is given twice; make it one statement";
    statement_empty(name) =
        "`{name}` is empty";
    statement_without_list(name) =
        "expected a list in parentheses: `#[{name}(..)]`";
    option_unknown(name, did_you_mean) =
        "there is no option `{name}`{did_you_mean} (the options are `crate` and `simplify`)";
    option_twice(name) =
        "the option `{name}` is given twice";
    option_crate() =
        "expected a path, such as `crate = ::holonomy`";
    option_simplify() =
        "expected `on` or `off`";
}

// The form of a statement's entries.
messages! {
    name_expected() =
        "expected a name";
    comma_expected(name) =
        "expected `,` after `{name}`";
    attribute_on_name() =
        "only doc comments can stand before a name here";
    family() =
        "families of names are not supported yet; write the names out";
    keyword(name) =
        "`{name}` is a keyword of Rust and cannot be a name here";
    raw_identifier(name) =
        "the raw identifier `{name}` cannot be a name in equations; choose another name";
    assignment_expected(form) =
        "expected `{form}`";
    quantity_expected() =
        "expected a name or the rate of a coordinate, such as `v1` or `dot(x)`";
    one_expression() =
        "expected one expression, found another after the comma";
    inertia_form() =
        "expected `diag(a, b, ..)` or `matrix([a, b, ..], [_, c, ..], ..)`";
    matrix_row_expected() =
        "expected a row in brackets: `[a, b, ..]`, with `_` for an entry that follows by symmetry";
    constraint_form() =
        "expected `name: left == right`; the name is that of the constraint's reaction";
    equation_expected() =
        "a constraint is an equation: expected `left == right`";
    single_equals() =
        "a constraint is written with `==`";
    second_equation() =
        "a constraint is one equation, this is a second `==`";
    unit_form() =
        "expected a unit such as `kg*m/s`: names with `*`, `/` and `powi(s, 2)`, or `1`";
}

// Expressions that are not part of an equation's language.
messages! {
    expression_expected() =
        "expected an expression";
    not_an_expression(error) =
        "cannot read this expression: {error}";
    operator_expected() =
        "expected an operator";
    attribute_in_expression() =
        "attributes cannot stand inside an expression";
    foreign_syntax() =
        "not part of an equation: use numbers, names, `+ - * /`, parentheses and functions";
    operator(operator) =
        "the operator `{operator}` is not part of an equation: use `+`, `-`, `*` and `/`";
    caret() =
        "`^` is not a power in Rust; write `powi(x, 2)`";
    equation_in_expression() =
        "an equation cannot stand inside an expression; equations are stated by `constraint`";
    call_of_no_name() =
        "only functions with a plain name can be called, such as `sin(theta)`";
    method_call(method) =
        "functions are not called as methods; write `{method}(x)` instead of `x.{method}()`";
    field_of_self(name) =
        "fields are visible by name; write `{name}` instead of `self.{name}`";
    component(name) =
        "components such as `.{name}` are not supported yet; a name stands for a number";
    path() =
        "paths are not part of an equation: use plain names";
    path_to_pi() =
        "write `PI`, without a path";
    index() =
        "indices are not supported yet; a name stands for a number";
    array() =
        "arrays are not supported yet; write the components one by one";
    tuple() =
        "a tuple is not a number; separate entries by commas without parentheses";
    condition(keyword) =
        "`{keyword}` is not supported yet";
    cast() =
        "casts are not needed: every expression is a number";
    underscore() =
        "`_` stands for an entry by symmetry in `inertia(matrix(..))` only";
    not_a_number() =
        "only integers and decimal fractions are numbers here";
    literal_suffix(digits, suffix) =
        "write `{digits}` without the suffix `{suffix}`: numbers are exact and have no type";
    literal_out_of_range(digits) =
        "the number {digits} is out of range: numerators and denominators have up to 256 bits";
}
