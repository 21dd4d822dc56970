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

mod dimensions;
mod geometry;
pub(crate) use dimensions::*;
pub(crate) use geometry::*;

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
        "there is no option `{name}`{did_you_mean} (the options are `crate`, `simplify` and `elimination`)";
    option_twice(name) =
        "the option `{name}` is given twice";
    option_crate() =
        "expected a path, such as `crate = ::holonomy`";
    option_simplify() =
        "expected `on` or `off`";
    option_elimination() =
        "expected `matrix` or `recursive`";
}

// The form of a statement's entries.
messages! {
    name_expected() =
        "expected a name";
    comma_expected(name) =
        "expected `,` after `{name}`";
    attribute_on_name() =
        "only doc comments and `#[unit(..)]` can stand before a name here";
    family_form() =
        "a family is written `entry for i in 0..n`";
    range_expected() =
        "expected a range of integers such as `0..n`: literals, sizes and indices with `+ - * / %`, `min` and `max`";
    integer_expected() =
        "a size is an integer: `n = 20`, or one made of sizes above it by `+ - * / %`";
    size_twice(name) =
        "the size `{name}` is given twice";
    length_expected(most) =
        "the length of an array is an integer from 1 to {most}, or a size";
    length_unknown(name) =
        "the length of `{name}` is no literal, so the derive cannot see it; write `[f64; 5]`";
    index_out_of_range(index, name, entries) =
        "the index {index} is out of range: `{name}` has {entries}";
    index_negative(index) =
        "the index {index} is negative";
    sum_form(name) =
        "expected `{name}(0..n, |j| expression)`";
    families_too_large(most) =
        "families come to more than {most} tokens when they are written out";
    array_without_index(name, length) =
        "`{name}` is an array of {length}; name an entry, such as `{name}[0]`";
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
    redundant_alone() =
        "`redundant` stands behind the constraint of which it is said: `name: left == right, redundant`";
    equation_expected() =
        "a constraint is an equation or a joint: expected `left == right`, or for example `spherical(P, Q)`";
    single_equals() =
        "a constraint is written with `==`";
    second_equation() =
        "a constraint is one equation, this is a second `==`";
    function_form() =
        "expected `road(s), derivatives = [droad, ddroad, ..]`: functions from f64 to f64 in scope";
    function_of_one_argument() =
        "functions of the user's take one argument: expected one name, such as `road(s)`";
    function_path() =
        "expected the path of a function, such as `road` or `tracks::road`";
    function_lacks_derivative(name, order, equation) =
        "`{name}` needs its derivative of order {order}, for `{equation}`; name it in `derivatives = [..]`";
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
        "not part of an equation: use numbers, names, `+ - * /`, parentheses, functions and `if`";
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
        "there is no component `.{name}`: the axes of a frame are `A.x`, `A.y` and `A.z`";
    path() =
        "paths are not part of an equation: use plain names";
    path_to_pi() =
        "write `PI`, without a path";
    index() =
        "an index is an integer of literals, sizes and indices of families";
    array() =
        "an array is no number; name its entries one by one";
    tuple() =
        "a tuple is not a number; separate entries by commas without parentheses";
    choice_by_match() =
        "`match` is not part of an equation; write `if a < b {{ .. }} else {{ .. }}`";
    else_missing() =
        "an `if` without `else` has no value where its condition does not hold; add `else {{ .. }}`";
    condition_form() =
        "the condition of an `if` compares two expressions, by `<`, `<=`, `>` or `>=`";
    condition_joined() =
        "conditions cannot be joined; nest one `if` in another";
    condition_of_equality() =
        "numbers of a motion are equal at instants only; compare by `<`, `<=`, `>` or `>=`";
    branch_form() =
        "a branch holds one expression, its value; name parts of it with `define`";
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

// Names.
messages! {
    reserved_name(name, what) =
        "`{name}` is reserved for {what}; choose another name";
    duplicate_name(name, what, other) =
        "`{name}` cannot be {what}: it is {other} already";
    name_of_rate(name, of) =
        "`{name}` is the name of the rate of `{of}` in the generated code; choose another name";
    unknown_name(name, did_you_mean) =
        "cannot find `{name}` in this model{did_you_mean}";
    write_dot(of) =
        "; the rate of `{of}` is written `dot({of})`";
    field_not_scalar(name, ty) =
        "the field `{name}` has the type `{ty}`; equations need `f64` or a type parameter";
    out_of_place(name, what, rule) =
        "`{name}` is {what}, but {rule}";
    define_out_of_place(name, contains, rule) =
        "the define `{name}` contains {contains}, but {rule}";
    cycle(what, names) =
        "the {what} is needed for its own value: {names}";
    output_twice(name) =
        "there is an output `{name}` already";
    output_later(name) =
        "the output `{name}` is not known here: an output may mention those above it";
    output_out_of_place(name) =
        "`{name}` is an output, which only other outputs may mention; name it by `define` to use it elsewhere";
    constraint_as_name(name) =
        "`{name}` is a constraint; its multiplier is written `reaction({name})`, in outputs";
    reaction_of_no_constraint(name, constraints) =
        "there is no constraint `{name}`: {constraints}";
    reaction_of_expression() =
        "`reaction` takes the name of a constraint";
}

/// What may occur where, as the second half of a sentence.
pub(crate) const RULE_SPEEDS: &str =
    "the kinematics give a speed by parameters, coordinates, `t` and rates such as `dot(x)`";
pub(crate) const RULE_RATES: &str = "the kinematics give a rate by parameters, coordinates, `t` and speeds";
pub(crate) const RULE_INERTIA: &str = "the inertia may depend on parameters, coordinates and `t` only";
pub(crate) const RULE_KINETIC: &str =
    "the kinetic energy may depend on parameters, coordinates of `coordinates`, speeds, rates and `t` only";
pub(crate) const RULE_POTENTIAL: &str = "the potential energy may depend on parameters, coordinates and `t` only";
pub(crate) const RULE_FORCES: &str =
    "forces may depend on parameters, coordinates of `coordinates`, speeds, inputs and `t` only";
pub(crate) const RULE_CONSTRAINT: &str =
    "a constraint may depend on parameters, coordinates of `coordinates`, speeds, accelerations and `t` only";
pub(crate) const RULE_CONFIGURATION: &str =
    "a coordinate is given by parameters, other coordinates and `t` in `configuration`";
pub(crate) const RULE_QUASI_SPEEDS: &str =
    "a speed of `configuration` is given by parameters, coordinates, `t` and rates such as `dot(q)`";
pub(crate) const RULE_QUASI_RATES: &str =
    "a rate is given by parameters, coordinates, `t` and speeds of `configuration` here";
pub(crate) const RULE_VELOCITIES: &str =
    "`velocities` gives a speed by parameters, coordinates, `t`, the remaining speeds and those in `of(..)`";
pub(crate) const RULE_COMBINATION: &str =
    "an independent speed is given by parameters, coordinates, `t`, speeds and rates such as `dot(x)`";
pub(crate) const RULE_COMPLEMENT: &str = "the entries of D may depend on parameters, coordinates and `t` only";
pub(crate) const RULE_NUMBER: &str = "this is a value for judging, which is made of numbers and `PI` only";

// Functions and operations.
messages! {
    unknown_function(name, did_you_mean) =
        "there is no function `{name}`{did_you_mean}";
    not_a_function(name, what) =
        "`{name}` is {what}, not a function; write `*` to multiply";
    function_as_name(name) =
        "`{name}` is a function and needs an argument, such as `{name}(x)`";
    wrong_number_of_arguments(function, expected, found) =
        "`{function}` takes {expected}, not {found}";
    exponent(most) =
        "the exponent of `powi` is an integer between -{most} and {most}; use `powf` for other powers";
    division_by_zero() =
        "division by zero";
    undefined(function) =
        "`{function}` has no real value here";
    not_finite() =
        "this value is not finite";
    dot_of_no_coordinate(name, what) =
        "`{name}` is {what}; `dot` takes the name of a coordinate or of a speed";
    dot_of_expression() =
        "`dot` takes the name of a coordinate; apply the chain rule, or make the expression a coordinate";
    acceleration(function, name) =
        "`{function}({name})` is an acceleration, which only `constraint` can bind";
    rate_without_name(name, what) =
        "the rate of `{name}` has no name: it is {what}; take the rates of the speeds of the system instead";
    rate_of_rate() =
        "the rate of a rate is written `ddot(x)`, with the name of a coordinate";
    second_rate_of_speed(name) =
        "`{name}` is a speed; its rate is written `dot({name})`, and `ddot` takes the name of a coordinate";
}

// The system.
messages! {
    statement_missing(name) =
        "the model has no `{name}`; add `#[{name}(..)]`";
    wrong_length(what, found, expected) =
        "{what} has {found}, but the model has {expected}";
    number_of_speeds(found, expected) =
        "there must be as many speeds as coordinates: found {found}, expected {expected}; \
         fewer of them become independent by constraints";
    number_of_speeds_beside_norms(found, expected) =
        "there must be three speeds for each quaternion and one for every other coordinate: found {found}, expected {expected}";
    speeds_without_kinematics() =
        "named speeds need `kinematics` that tell what they are";
    kinematics_without_speeds() =
        "kinematics need named speeds: add `#[speeds(..)]`";
    kinematics_left_side(name, what) =
        "`{name}` is {what}; kinematics give a speed or the rate of a coordinate";
    kinematics_twice(name) =
        "`{name}` is given twice";
    kinematics_missing(names) =
        "the kinematics leave out {names}";
    kinematics_not_linear(variables, variable, derivative) =
        "the kinematics must be linear in the {variables}, but the coefficient of `{variable}` here is `{derivative}`";
    kinematics_mixed() =
        "the kinematics give some speeds and some rates; give all speeds, or all rates `dot(x)`";
    kinematics_not_invertible(combination, variables) =
        "the kinematics cannot be inverted: `{combination}` does not depend on the {variables}";
    kinematics_disagree(row, column, found) =
        "the two directions do not fit together: substituting the rates, \
         `{row}` gets the coefficient `{found}` of `{column}`";
    kinematics_biases_disagree(row, found) =
        "the two directions do not fit together: substituting the rates, `{row}` gets the additional term `{found}`";
    name_of_coordinate(name) =
        "`{name}` is a coordinate; its rate is `dot({name})`";
    not_symmetric(row, column, above, below) =
        "the inertia is not symmetric: entry ({row}, {column}) is `{above}`, but entry ({column}, {row}) is `{below}`";
    kinetic_not_quadratic(row, column, derivative) =
        "the kinetic energy must be quadratic in the speeds, but its second derivative by `{row}` and `{column}` \
         is `{derivative}`";
    kinetic_without_speed() =
        "the kinetic energy has no term that is quadratic in the speeds";
    inertia_differs(row, column, given, found) =
        "the inertia differs from the kinetic energy: entry ({row}, {column}) is `{given}`, but the second derivative \
         of the kinetic energy is `{found}`";
    underscore_on_diagonal() =
        "an entry on the diagonal does not follow by symmetry; write it out";
    underscore_twice() =
        "this entry and the one across the diagonal are both `_`; write one of them out";
    constraint_twice(name) =
        "there is a constraint `{name}` already";
    constraint_without_variable(name) =
        "the constraint `{name}` binds no coordinate and no speed";
    constraint_without_speed(name) =
        "the constraint `{name}` binds no speed: all its coefficients vanish";
    constraint_without_acceleration(name) =
        "the constraint `{name}` binds no acceleration: all its coefficients vanish; write it without them";
    constraint_not_linear(name, variable) =
        "the constraint `{name}` is not linear in `{variable}`: constraints may be nonlinear in velocities, \
         but not in accelerations";
    configuration_left_side(name, what) =
        "`{name}` is {what}; `configuration` gives coordinates of `coordinates`, further ones stand in `of(..)`";
    configuration_twice(name) =
        "`{name}` is given twice";
    configuration_of_given(name) =
        "`{name}` is itself given by `configuration`; give it by the remaining coordinates";
    configuration_without_coordinate() =
        "no coordinate remains free; leave one out or name further ones in `of(..)`";
    configuration_kinematics_without_speeds() =
        "the configuration gives rates but no speeds; name them in `speeds(..)`";
    configuration_number_of_speeds(found, expected) =
        "there must be as many speeds as generalised coordinates: found {found}, expected {expected}";
    configuration_rate_of_given(name) =
        "`{name}` is given by `configuration`; only rates of the remaining coordinates are given by speeds";
    configuration_speeds_without_kinematics(names) =
        "the configuration does not tell what its speeds are: give each of {names}, or the rate of each coordinate";
    velocities_left_side(name, carriers) =
        "`{name}` cannot be given here; `velocities` gives some of {carriers}";
    velocities_twice(name) =
        "`{name}` is given twice";
    velocities_of_given(name) =
        "`{name}` is itself given by `velocities`; give it by the remaining speeds";
    velocities_without_speed() =
        "no speed remains free; leave one out or name further ones in `of(..)`";
    velocities_without(name) =
        "no speed is given by `{name}`";
    velocities_and(other) =
        "`velocities` names the independent speeds already; leave out `{other}`";
    configuration_without(name) =
        "no coordinate is given by `{name}`";
    independent_form(name, what) =
        "`{name}` is {what}; expected a speed or the rate of a coordinate, such as `v1` or `dot(x)`";
    independent_twice(name) =
        "`{name}` stands in the list twice";
    combination_not_linear(name, variable, derivative) =
        "`{name}` must be linear in the speeds, but the coefficient of `{variable}` here is `{derivative}`";
    combination_without_speed(name) =
        "`{name}` depends on no speed: all its coefficients vanish";
    independent_and_complement() =
        "`complement` names the independent speeds already; leave out one of the two";
    complement_twice(name) =
        "there is a row `{name}` already";
    complement_is_not_speed(name) =
        "the row `{name}` takes the name of a speed, but D's column for that speed is not a unit vector; \
         choose another name";
    start_of(name, what) =
        "`{name}` is {what}; `start` gives values of coordinates and speeds";
    start_twice(name) =
        "`{name}` has a value already";
    nominal_of_array(found, array, entries) =
        "`nominal` gives {found}, but `{array}` has {entries}; give one value for all of them, or one for each";
    nominal_of_no_scalar(name) =
        "the field `{name}` is no parameter; `nominal` needs `f64` or a type parameter";
}

/// `1 entry`, `2 entries`
pub(crate) fn counted(number: usize, one: &str, many: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { many })
}
