//! Every sentence that the projection can say to a user, in one place.

use crate::symbolic::{Expr, Graph};
use crate::syntax::messages::counted;

/// Two kinds of rows say different things about the same velocities.
pub(crate) fn contradictory(name: &str, combination: &str) -> String {
    format!(
        "constraint `{name}` contradicts the others: its velocities are bound as {combination}, but to other values; \
         no motion satisfies both"
    )
}

/// A row binds accelerations that others bind, and nothing tells that it says the same.
pub(crate) fn conflicting(name: &str, combination: &str, difference: &str) -> String {
    format!(
        "constraint `{name}` binds the same accelerations as {combination}, and to other values unless {difference} is 0; \
         remove one of them"
    )
}

/// On the motions that the other rows leave, a row binds nothing or what others bind.
pub(crate) fn dependent_on_motions(name: &str) -> String {
    format!(
        "constraint `{name}` depends on the other rows: on the motions that they leave it binds no further acceleration; \
         remove it, its reaction cannot be told apart"
    )
}

/// On the motions that the other rows leave, a row cannot hold.
pub(crate) fn excluded_on_motions(name: &str, excess: &str) -> String {
    format!(
        "constraint `{name}` cannot hold: on the motions that the other rows leave, it binds no further acceleration, but \
         demands that {excess} be 0"
    )
}

/// A redundant position row has the rates of others, but other values.
pub(crate) fn contradictory_positions(name: &str, combination: &str) -> String {
    format!(
        "constraint `{name}` contradicts the others: its rates are those of {combination}, but its values never are"
    )
}

/// A redundant row does not say what its combination says.
pub(crate) fn redundant_but_different(name: &str, combination: &str, difference: &str) -> String {
    format!(
        "constraint `{name}` is not redundant: it binds what {combination} binds, and to other values unless {difference} \
         is 0; no motion satisfies both otherwise"
    )
}

/// A row repeats others.
pub(crate) fn dependent(name: &str, position: bool, combination: &str) -> String {
    let what = if position { "the derivative of constraint" } else { "constraint" };
    format!(
        "{what} `{name}` depends on the other rows: it is {combination}; remove it, its reaction cannot be told apart"
    )
}

/// The configuration leaves a row without a variable, and unsatisfied.
pub(crate) fn excluded_by_configuration(name: &str) -> String {
    format!("constraint `{name}` cannot hold: the configuration fixes its velocities to other values")
}

/// f(g(q, t)) is not zero although the configuration was to satisfy it.
pub(crate) fn configuration_misses(name: &str, value: &str) -> String {
    format!("the configuration does not satisfy constraint `{name}`: there its left minus right side is {value}, not 0")
}

/// The named speeds cannot be independent.
pub(crate) fn not_independent(row: &str, speeds: &[&str]) -> String {
    format!("these speeds are not independent: constraint `{row}` binds them; choose others among {}", list(speeds))
}

/// A pivot vanishes at the start that the model names.
pub(crate) fn singular_at_start(pivot: &str, dependent: &str, by_user: bool, better: Option<&str>) -> String {
    let who = if by_user { "these independent speeds do" } else { "the chosen independent speeds do" };
    let mend = match better {
        Some(line) => format!("write `{line}`"),
        None => "no other choice that was tried is accepted there: start elsewhere".to_owned(),
    };
    format!("{who} not determine `{dependent}` at the start, where the pivot {pivot} vanishes; {mend}")
}

/// f = 0 is not reached from the start.
pub(crate) fn start_not_closed(open: &[(&str, f64)]) -> String {
    let rows: Vec<String> = open.iter().map(|(name, rest)| format!("`{name}` by {rest:.2e}")).collect();
    format!(
        "the start does not close: Newton's method, damped as well, ends where the two sides of constraints differ, {}; give values nearer to \
         a configuration of the mechanism, or other nominal parameters",
        rows.join(", ")
    )
}

/// Rows that are independent elsewhere depend on each other at the start.
pub(crate) fn dependent_at_start(name: &str, parts: &[(&str, f64)]) -> String {
    format!(
        "constraint `{name}` depends on the others at the start: its rates are those of {} there, so that no \
         choice of speeds determines the motion; start elsewhere",
        weighted(parts)
    )
}

/// Rows that are independent elsewhere depend on each other wherever they hold.
pub(crate) fn overconstrained(name: &str, parts: &[(&str, f64)]) -> String {
    format!(
        "constraint `{name}` depends on the others wherever these hold: at the start its rates are those of {}, and so beside it; \
         write `redundant` behind it, for reactions of the least sum of squares, or leave it out",
        weighted(parts)
    )
}

/// `2*a + 0.5*b` over names of rows.
fn weighted(parts: &[(&str, f64)]) -> String {
    let terms = parts.iter().map(|(name, weight)| match format!("{weight:.3}").as_str() {
        "1.000" => format!("`{name}`"),
        "-1.000" => format!("-`{name}`"),
        text => format!("{}*`{name}`", text.trim_end_matches('0').trim_end_matches('.')),
    });
    if parts.is_empty() { "0".to_owned() } else { terms.collect::<Vec<_>>().join(" + ") }
}

/// What the start says of a chart.
pub(crate) fn judged(chart: usize, relative_pivot: f64) -> String {
    let which = if chart == 0 { "the independent speeds".to_owned() } else { format!("chart {chart}") };
    format!(
        "at the start that the model names, closed, the relative pivot of {which} is {relative_pivot}: |det [C; L]| over the \
         volumes of the rows of C and of L, between 0, where they do not determine the other speeds, and 1"
    )
}

/// Coordinates that position rows bind are states.
pub(crate) fn carried(rows: usize, operations: usize, functions: usize) -> String {
    let bound = counted(rows, "coordinate", "coordinates");
    let pairs = if functions == 0 {
        String::new()
    } else {
        format!(" and {}", counted(functions, "pair of sine and cosine", "pairs of sine and cosine"))
    };
    format!(
        "the position rows bind {bound}, carried by the state and brought back onto f = 0 after every step: their rates are velocities \
         that the motion needs anyway, and Newton's method in every evaluation would add {}{pairs} in each iteration for f \
         alone",
        counted(operations, "operation", "operations")
    )
}

/// A chart repeats another one.
pub(crate) fn chart_twice(of_the_state: bool) -> String {
    let which = if of_the_state { "the first `independent` statement" } else { "an earlier `independent` statement" };
    format!("{which} names the same speeds; a further chart must choose others")
}

/// [C; L] is singular.
pub(crate) fn combinations_not_independent(name: &str, combination: &str) -> String {
    if name.is_empty() {
        return "these speeds are not independent of each other and of the constraints; choose others".to_owned();
    }
    format!(
        "these speeds are not independent of each other and of the constraints: the speeds enter `{name}` as they enter \
         {combination}; choose others"
    )
}

/// `2*a - cos(theta)*b` over names.
pub(crate) fn combination(graph: &Graph, parts: &[(&str, Expr)]) -> String {
    if parts.is_empty() {
        return "0".to_owned();
    }
    let terms = parts.iter().map(|(name, c)| {
        let name = format!("`{name}`");
        match graph.display(*c).as_str() {
            "1" => name,
            "-1" => format!("-{name}"),
            text if text.contains(' ') => format!("({text})*{name}"),
            text => format!("{text}*{name}"),
        }
    });
    terms.collect::<Vec<_>>().join(" + ")
}

/// k is not n - m.
pub(crate) fn wrong_number_independent(given: usize, n: usize, m: usize) -> String {
    format!(
        "{given} independent speed{} named, but the system has {}: {n} speeds less {m} independent row{}",
        if given == 1 { " is" } else { "s are" },
        n - m,
        if m == 1 { "" } else { "s" }
    )
}

/// φ(g(u, x, t), x, t) is not zero.
pub(crate) fn velocities_miss(name: &str, value: &str) -> String {
    format!("the velocities do not satisfy constraint `{name}`: with them its left minus right side is {value}, not 0")
}

/// ∂g/∂u has not full rank.
pub(crate) fn velocities_dependent(name: &str) -> String {
    format!(
        "the velocities do not depend on `{name}` in a way of its own: its partial velocities are a combination of the others'"
    )
}

/// D Cᵀ is not zero.
pub(crate) fn not_a_complement(row: &str, constraint: &str, product: &str) -> String {
    format!("row `{row}` of the complement violates constraint `{constraint}`: their product is {product}, not 0")
}

/// D has the wrong number of rows.
pub(crate) fn wrong_number_complement(given: usize, n: usize, m: usize) -> String {
    format!(
        "the complement has {given} row{}, but needs {}: {n} speeds less {m} independent row{}",
        if given == 1 { "" } else { "s" },
        n.saturating_sub(m),
        if m == 1 { "" } else { "s" }
    )
}

/// The rows of D are dependent.
pub(crate) fn complement_dependent(row: &str) -> String {
    format!("row `{row}` of the complement is a combination of the rows above it")
}

/// 1/0 after substitution.
pub(crate) fn division_by_zero_arises() -> String {
    "the equations of this model divide by zero everywhere: a divisor vanishes once the configuration and the \
     constraints are put in, or a tangent stands at a quarter turn"
        .to_owned()
}

/// 1/0 in an output, once the state is put in.
pub(crate) fn output_divides_by_zero(name: &str) -> String {
    format!("the output `{name}` divides by zero in every state: a divisor vanishes where the constraints hold")
}

/// A merged row has no multiplier of its own.
pub(crate) fn reaction_shared(name: &str, carriers: &[String]) -> String {
    let names: Vec<&str> = carriers.iter().map(String::as_str).collect();
    format!(
        "constraint `{name}` has no reaction of its own: its derivative is a combination of {}, which carry it; mention theirs",
        list(&names)
    )
}

/// M_d is singular, whatever the parameters.
pub(crate) fn not_joint_by_joint() -> String {
    "this mechanism cannot be eliminated joint by joint: that takes bodies whose speeds are those of their joints, each of one joint \
     that it moves against an inertia, constraints of positions or linear in velocities, and no `configuration` or `complement`; \
     leave `elimination = recursive` out"
        .to_owned()
}

pub(crate) fn joint_by_joint(cycles: usize, whole: usize) -> String {
    format!(
        "the motion is found joint by joint from the leaves: in estimate {cycles} cycles, by M_d as a whole at least {whole}"
    )
}

pub(crate) fn immovable(speeds: usize) -> String {
    format!(
        "with this row the constraints leave the mechanism no degree of freedom: {} and as many independent rows, none of which time \
         moves; take a constraint out, or add a coordinate",
        counted(speeds, "speed", "speeds")
    )
}

pub(crate) fn singular_inertia(speed: &str) -> String {
    format!(
        "no inertia acts on the independent speed `{speed}`: its pivot of D M D\u{1d40} vanishes identically; \
         the inertia must be definite on the motions that the constraints leave"
    )
}

/// M_d has a negative number on its diagonal.
pub(crate) fn negative_inertia(speed: &str, value: &str) -> String {
    format!("the inertia is not positive: the pivot of D M D\u{1d40} for speed `{speed}` is {value}")
}

/// The configuration removes freedoms that no row states.
pub(crate) fn reaction_undetermined(name: &str, missing: usize) -> String {
    format!(
        "the reaction of `{name}` cannot be told from that of the configuration, which removes {missing} more \
         freedom{} than the constraints state; declare them all or leave `{name}` out",
        if missing == 1 { "" } else { "s" }
    )
}

fn list(names: &[&str]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// A rule of the simplification is wrong.
pub(crate) fn changed(old: &str, new: &str) -> String {
    format!(
        "internal error: simplification made {new} of {old}, which is something else; nothing is emitted. Please report the \
         model, and use `#[holonomy(simplify = off)]` until then"
    )
}
