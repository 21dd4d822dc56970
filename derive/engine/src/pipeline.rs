//! The steps in order, from tokens to tokens.

use crate::carried;
use crate::choices::choose;
use crate::dimensions::{self, Units};
use crate::elimination::{Recursive, joint_by_joint};
use crate::forms::Forms;
use crate::model::InitialSystem;
use crate::plain::Plain;
use crate::projection::{
    AsIs, Equations, Simplifier, TANGENT_PIVOT, guards, inverse_dynamics, messages, outputs, project,
};
use crate::simplify::Search;
use crate::symbolic::{Expr, Graph};
use crate::syntax::{Declarations, Diagnostics};
use crate::target::{known, target};
use crate::{emit, model, orders, program, syntax};
use proc_macro2::{Ident, TokenStream};

/// A model that has been read, checked and projected.
#[derive(Clone, Debug)]
pub struct Analysis {
    /// What the model says.
    pub declarations: Declarations,
    /// What follows from it, in the cheapest forms found.
    pub equations: Equations,
    /// The units of its names, as far as they are known.
    pub units: Units,
}

/// A step of the derive, for those who watch it.
#[derive(Copy, Clone, PartialEq, Eq, Debug)]
pub enum Step {
    /// Tokens to declarations.
    Syntax,
    /// Declarations to the initial system.
    Model,
    /// The initial system to the equations of motion.
    Projection,
    /// The equations to cheaper ones.
    Simplification,
    /// The equations to straight-line programs.
    Program,
    /// The programs to tokens.
    Emission,
}

/// Called after each step with the number of expressions, operations or tokens that it left.
pub type Observer<'a> = &'a mut dyn FnMut(Step, usize);

/// The derive: an implementation of the model, or its errors beside an implementation that diverges.
pub fn expand(input: TokenStream) -> TokenStream {
    expand_observed(input, &mut |_, _| {})
}

/// [`expand`] without a search for cheaper forms, as with `simplify = off`: the same types, and the same errors, sooner.
pub fn expand_plainly(input: TokenStream) -> TokenStream {
    expansion(input, Search::Off, &mut |_, _| {})
}

/// [`expand`], watched.
pub fn expand_observed(input: TokenStream, after: Observer<'_>) -> TokenStream {
    expansion(input, Search::Full, after)
}

fn expansion(input: TokenStream, search: Search, after: Observer<'_>) -> TokenStream {
    let (declarations, diagnostics) = syntax::read(input);
    let Some(declarations) = declarations else { return diagnostics.into_tokens() };
    after(Step::Syntax, 0);
    emitted(&declarations, diagnostics, search, after).unwrap_or_else(|errors| {
        // The types are there all the same, so that only the model's own errors show.
        let mut tokens = errors.into_tokens();
        tokens.extend(emit::diverging(&target(&declarations, None, Units::default()), &known(&declarations)));
        tokens
    })
}

fn emitted(
    declarations: &Declarations,
    diagnostics: Diagnostics,
    search: Search,
    after: Observer<'_>,
) -> Result<TokenStream, Diagnostics> {
    let (equations, units) = equations(declarations, diagnostics, search, after)?;
    let programs = program::programs(&equations).map_err(|unbound| {
        let mut errors = Diagnostics::new();
        let message = format!(
            "internal error: `{}` of this model depends on `{}`, which it cannot know; please report the model",
            unbound.function, unbound.symbol
        );
        errors.report(&declarations.ident, message);
        errors
    })?;
    after(Step::Program, programs.functions.iter().map(|f| f.count.weight()).sum());
    let tokens = emit::implementation(&target(declarations, Some(&equations), units), &equations, &programs);
    after(Step::Emission, tokens.clone().into_iter().count());
    Ok(tokens)
}

/// Reads, checks and projects a model without emitting it.
///
/// # Errors
///
/// Everything that is wrong with the model, at its tokens.
pub fn analyse(input: TokenStream) -> Result<Analysis, Diagnostics> {
    analyse_by(input, Search::Full)
}

/// [`analyse`] with less of a search for cheaper forms, to see what it is worth.
///
/// # Errors
///
/// Those of [`analyse`].
pub fn analyse_by(input: TokenStream, search: Search) -> Result<Analysis, Diagnostics> {
    let (declarations, diagnostics) = syntax::read(input);
    match declarations {
        Some(declarations) => {
            let (equations, units) = equations(&declarations, diagnostics, search, &mut |_, _| {})?;
            Ok(Analysis { declarations, equations, units })
        }
        None => Err(diagnostics),
    }
}

/// From declarations to simplified equations. Declarations with errors of form are checked further where the rest can
/// be understood, so that all errors come at once.
fn equations(
    declarations: &Declarations,
    mut diagnostics: Diagnostics,
    search: Search,
    after: Observer<'_>,
) -> Result<(Equations, Units), Diagnostics> {
    if !declarations.complete {
        return Err(diagnostics);
    }
    dimensions::declared(declarations, &mut diagnostics);
    let system = match model::build(declarations) {
        Ok(system) => system,
        Err(more) => {
            diagnostics.extend(more);
            return Err(diagnostics);
        }
    };
    let units = dimensions::check(declarations, &mut diagnostics);
    let system = diagnostics.result(system)?;
    Ok((projected(system, declarations, search, after)?, units))
}

/// From the initial system to simplified equations.
fn projected(
    mut system: InitialSystem,
    declarations: &Declarations,
    search: Search,
    after: Observer<'_>,
) -> Result<Equations, Diagnostics> {
    after(Step::Model, system.graph.len());
    choose(&mut system);
    let search = if declarations.options.simplify { search } else { Search::Off };
    let mut recursive = joint_by_joint(&system, declarations.options.elimination, search)?;
    if let Some(recursive) = recursive.take_if(|recursive| recursive.is_surely_faster(&system)) {
        after(Step::Projection, recursive.size());
        let equations = recursive.taken();
        unchanged(&equations.graph, &declarations.ident)?;
        return finished(equations, declarations, after);
    }
    let mut equations = match search {
        Search::Off => {
            let equations = project(system, &mut AsIs)?;
            after(Step::Projection, equations.graph.len());
            equations
        }
        _ => {
            let mut forms = Forms::new(search);
            let initial = system.clone();
            let mut equations = project(system, &mut forms)?;
            after(Step::Projection, equations.graph.len());
            let plain = Plain::of(&mut equations, initial.clone());
            let lighter = cheapen(&mut equations, &mut forms, plain);
            cheapen_outputs(&mut equations, &mut forms);
            unchanged(&equations.graph, &declarations.ident)?;
            if lighter { equations } else { Plain::instead_of(equations, initial) }
        }
    };
    inverse_dynamics(&mut equations);
    let faster = recursive.take_if(|recursive| recursive.is_faster_than(&equations));
    let equations = faster.map_or(equations, Recursive::taken);
    unchanged(&equations.graph, &declarations.ident)?;
    finished(equations, declarations, after)
}

/// The last judgements of what will be emitted.
fn finished(
    mut equations: Equations,
    declarations: &Declarations,
    after: Observer<'_>,
) -> Result<Equations, Diagnostics> {
    let mut errors = Diagnostics::new();
    for (name, span) in outputs::dividing_by_zero(&equations) {
        errors.report(span, messages::output_divides_by_zero(name));
    }
    errors.result(())?;
    if guards::divides_by_zero(&equations) {
        let mut errors = Diagnostics::new();
        errors.report(&declarations.ident, messages::division_by_zero_arises());
        return Err(errors);
    }
    let mut errors = Diagnostics::new();
    orders::check(declarations, &mut equations, &mut errors);
    errors.result(())?;
    guards::drop_cancelled_pivots(&mut equations, TANGENT_PIVOT);
    guards::add_parameter_divisors(&mut equations);
    carried::tell(&mut equations);
    after(Step::Simplification, equations.graph.len());
    Ok(equations)
}

/// No expression was rewritten to something else: what is emitted is what was derived, or nothing is.
fn unchanged(graph: &Graph, model: &Ident) -> Result<(), Diagnostics> {
    let mut errors = Diagnostics::new();
    if let Some((old, new)) = graph.broken() {
        errors.report(model, messages::changed(&graph.display(old), &graph.display(new)));
    }
    errors.result(())
}

/// Replaces every group of expressions that is computed together by its cheapest form, or by how it comes without any forms. What
/// a run needs is the first of them: its forms are compared by the programs that they become. Whether it is lighter than as it came
/// beyond doubt.
fn cheapen(equations: &mut Equations, forms: &mut Forms, mut plain: Option<Plain>) -> bool {
    let mut graph = std::mem::take(&mut equations.graph);
    for (at, group) in equations.groups().into_iter().enumerate() {
        let roots: Vec<Expr> = group.iter().map(|e| **e).collect();
        let cheaper = match (at, &mut plain) {
            (0, _) => forms.lightest(&mut graph, &roots, program::weight),
            (_, Some(plain)) => plain.lighter(&mut graph, at, &roots).unwrap_or_else(|| forms.all(&mut graph, &roots)),
            _ => forms.all(&mut graph, &roots),
        };
        group.into_iter().zip(cheaper).for_each(|(e, new)| *e = new);
    }
    equations.graph = graph;
    plain.is_some_and(|mut plain| plain.lighten_motion(equations))
}

/// The same for the outputs, which are made of what has become cheaper.
fn cheapen_outputs(equations: &mut Equations, forms: &mut Forms) {
    outputs::bind(equations);
    let Equations { graph, outputs, .. } = equations;
    for group in [&mut outputs.values, &mut outputs.carried] {
        if !group.is_empty() {
            *group = forms.all(graph, group);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbolic::Kind;

    #[test]
    fn a_model_that_simplification_changed_is_not_emitted() {
        let mut graph = Graph::new();
        let model: Ident = syn::parse_quote!(Pendulum);
        let [x, y] = ["x", "y"].map(|name| graph.symbol(name, Kind::Coordinate));
        let [x, y] = [x, y].map(|symbol| graph.var(symbol));
        assert!(graph.proven(x, x) && unchanged(&graph, &model).is_ok());
        assert!(!graph.proven(y, x));
        let errors = unchanged(&graph, &model).expect_err("x is not y");
        let text: Vec<String> = errors.iter().map(|error| error.message.clone()).collect();
        assert_eq!(text.len(), 1);
        assert!(text[0].contains("simplification made y of x") && text[0].contains("report the model"), "{}", text[0]);
    }
}
