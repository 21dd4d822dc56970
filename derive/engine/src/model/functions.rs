//! The functions of the language: names, numbers of arguments, and where they have no value.

use proc_macro2::Span;

use super::geometry::VECTOR_FUNCTIONS;
use super::names::Meaning;
use super::vocabulary::Vocabulary;
use crate::symbolic::{Expr, Function, Rational};
use crate::syntax::{Diagnostics, did_you_mean, messages, nearest};

/// The functions with their numbers of arguments.
pub(super) const FUNCTIONS: [(&str, usize); 21] = [
    ("sin", 1),
    ("cos", 1),
    ("tan", 1),
    ("asin", 1),
    ("acos", 1),
    ("atan", 1),
    ("atan2", 2),
    ("sinh", 1),
    ("cosh", 1),
    ("tanh", 1),
    ("sqrt", 1),
    ("exp", 1),
    ("ln", 1),
    ("abs", 1),
    ("sign", 1),
    ("min", 2),
    ("max", 2),
    ("powi", 2),
    ("powf", 2),
    ("dot", 1),
    ("reaction", 1),
];

/// Names under which people look for these functions.
const ALIASES: [(&str, &str); 13] = [
    ("log", "ln"),
    ("pow", "powf"),
    ("power", "powf"),
    ("arcsin", "asin"),
    ("arccos", "acos"),
    ("arctan", "atan"),
    ("arctan2", "atan2"),
    ("fabs", "abs"),
    ("signum", "sign"),
    ("sgn", "sign"),
    ("diff", "dot"),
    ("der", "dot"),
    ("root", "sqrt"),
];

/// Exponents of `powi` up to this magnitude.
const EXPONENT: i64 = 999;

/// A call of a function, its arguments lowered.
pub(super) struct Call<'a> {
    pub function: &'a str,
    pub span: Span,
    pub count: usize,
}

impl Call<'_> {
    /// The value; `None` where something was reported, here or in an argument.
    pub fn lower(
        &self,
        arguments: &[Option<Expr>],
        vocabulary: &mut Vocabulary<'_>,
        diagnostics: &mut Diagnostics,
    ) -> Option<Expr> {
        if let Some(Meaning::Function(i)) = vocabulary.names.get(self.function) {
            if self.count != 1 {
                let message = wrong_number_of_arguments(self.function, 1, self.count);
                diagnostics.report(self.span, message);
                return None;
            }
            let argument = arguments.first().copied()??;
            return Some(vocabulary.graph.function(vocabulary.functions[i], &[argument]));
        }
        let Some((_, count)) = FUNCTIONS.iter().find(|(name, _)| *name == self.function) else {
            diagnostics.report(self.span, self.unknown(vocabulary));
            return None;
        };
        if *count != self.count {
            let message = wrong_number_of_arguments(self.function, *count, self.count);
            diagnostics.report(self.span, message);
            return None;
        }
        let arguments: Vec<Expr> = arguments.iter().copied().collect::<Option<_>>()?;
        let graph = &mut vocabulary.graph;
        let number = |at: usize| graph.as_number(arguments[at]);
        let zero = |at: usize| number(at).is_some_and(|number| number.is_zero());
        let undefined = match self.function {
            "sqrt" => number(0).is_some_and(|number| number.is_negative()),
            "ln" => zero(0) || number(0).is_some_and(|number| number.is_negative()),
            "atan2" => zero(0) && zero(1),
            "asin" | "acos" => number(0).is_some_and(|number| number.abs() > Rational::ONE),
            "powf" => {
                let whole = number(1).and_then(Rational::as_integer);
                number(0).is_some_and(|base| base.is_negative()) && number(1).is_some() && whole.is_none()
            }
            _ => false,
        };
        if undefined {
            diagnostics.report(self.span, messages::undefined(self.function));
            return None;
        }
        let x = arguments[0];
        Some(match self.function {
            "sin" => graph.sin(x),
            "cos" => graph.cos(x),
            "tan" => graph.tan(x),
            "asin" => graph.function(Function::Asin, &[x]),
            "acos" => graph.function(Function::Acos, &[x]),
            "atan" => graph.function(Function::Atan, &[x]),
            "sinh" => graph.function(Function::Sinh, &[x]),
            "cosh" => graph.function(Function::Cosh, &[x]),
            "tanh" => graph.function(Function::Tanh, &[x]),
            "abs" => graph.abs(x),
            "sign" => graph.sign(x),
            "min" => graph.min(x, arguments[1]),
            "max" => graph.max(x, arguments[1]),
            "sqrt" => graph.sqrt(x),
            "exp" => graph.exp(x),
            "ln" => graph.ln(x),
            "atan2" => graph.atan2(x, arguments[1]),
            "powf" => {
                let negative = graph.as_number(arguments[1]).is_some_and(|exponent| exponent.is_negative());
                if negative && graph.vanishes(x) {
                    diagnostics.report(self.span, messages::division_by_zero());
                    return None;
                }
                graph.powf(x, arguments[1])
            }
            _ => {
                let exponent = graph
                    .as_number(arguments[1])
                    .and_then(|exponent| exponent.as_integer())
                    .filter(|exponent| exponent.abs() <= EXPONENT);
                let Some(exponent) = exponent else {
                    diagnostics.report(self.span, messages::exponent(EXPONENT));
                    return None;
                };
                if exponent < 0 && graph.vanishes(x) {
                    diagnostics.report(self.span, messages::division_by_zero());
                    return None;
                }
                graph.powi(x, exponent as i32)
            }
        })
    }

    fn unknown(&self, vocabulary: &Vocabulary<'_>) -> String {
        let name = self.function;
        if let Some(meaning) = vocabulary.names.get(name) {
            return messages::not_a_function(name, meaning.describe());
        }
        let alias = ALIASES.iter().find(|(alias, _)| *alias == name).map(|(_, function)| *function);
        let own: Vec<String> = vocabulary.declarations.functions.iter().map(|f| f.name.to_string()).collect();
        let known = FUNCTIONS.iter().chain(&VECTOR_FUNCTIONS).map(|(function, _)| *function);
        let known = known.chain(own.iter().map(String::as_str));
        let meant = alias.or_else(|| nearest(name, known));
        messages::unknown_function(name, did_you_mean(meant))
    }
}

pub(super) fn wrong_number_of_arguments(function: &str, expected: usize, found: usize) -> String {
    let expected = messages::counted(expected, "argument", "arguments");
    messages::wrong_number_of_arguments(function, expected, found)
}
