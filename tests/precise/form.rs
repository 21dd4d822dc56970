//! A model's programs in one form, run over any number.

use super::number::Number;
use holonomy_engine::analyse_by;
use holonomy_engine::program::{Arguments, Code, Leaf, Operation, Programs, programs};
use holonomy_engine::projection::Equations;
use holonomy_engine::simplify::Search;
use quote::ToTokens;

/// The equations of a model and the programs that they are emitted as.
pub struct Form {
    equations: Equations,
    programs: Programs,
}

/// A state, coordinates before speeds: doubles, which every number type takes as they are.
pub type Point = Vec<f64>;

/// The results of a program, step by step as it is emitted.
fn run<N: Number>(code: &Code, read: &dyn Fn(Leaf) -> N) -> Vec<N> {
    let mut values: Vec<N> = Vec::with_capacity(code.operations.len());
    // Sine and cosine of one angle are one call.
    let mut turns: Vec<Option<(N, N)>> = vec![None; code.operations.len()];
    for operation in &code.operations {
        let at = |r: &u32| values[*r as usize].clone();
        let mut turn = |r: &u32| turns[*r as usize].get_or_insert_with(|| values[*r as usize].turn()).clone();
        let value = match operation {
            Operation::Read(leaf) => read(*leaf),
            Operation::Number(number) => N::from_rational(number),
            Operation::Negate(a) => -at(a),
            Operation::Add(a, b) => at(a) + at(b),
            Operation::Subtract(a, b) => at(a) - at(b),
            Operation::Multiply(a, b) => at(a) * at(b),
            Operation::Divide(a, b) => at(a) / at(b),
            Operation::Sine(a) => turn(a).0,
            Operation::Cosine(a) => turn(a).1,
            Operation::Root(a) => at(a).root(),
            Operation::Call(function, _) => panic!("no reference model calls {function:?}"),
        };
        values.push(value);
    }
    code.outputs.iter().map(|r| values[*r as usize].clone()).collect()
}

impl Form {
    /// The programs of a model, by this much of a search.
    ///
    /// # Panics
    /// If the model is refused.
    pub fn new(model: &syn::ItemStruct, search: Search) -> Self {
        let analysis = analyse_by(model.to_token_stream(), search).expect("the model is good");
        let programs = programs(&analysis.equations).expect("every symbol is known");
        Self { equations: analysis.equations, programs }
    }

    /// The prepared values for parameters by name: the parameters, then the quantities of them.
    ///
    /// # Panics
    /// If the work of `prepare` reads anything else.
    pub fn prepared<N: Number>(&self, parameter: &dyn Fn(&str) -> f64) -> Vec<N> {
        let named = self.equations.parameters.iter().map(|p| parameter(self.equations.graph.name(*p)));
        let mut values: Vec<N> = named.map(N::from_double).collect();
        let quantities = run(&self.programs.values.code, &|leaf| match leaf {
            Leaf::Parameter(i) => values[i].clone(),
            other => panic!("{other:?} is no parameter"),
        });
        let count = self.programs.values.quantities.len() - values.len();
        values.extend(quantities.into_iter().take(count));
        values
    }

    /// The results of a function of the state.
    ///
    /// # Panics
    /// If there is no such function, or if it depends on time or inputs: no reference model does.
    pub fn run<N: Number>(&self, function: &str, prepared: &[N], point: &Point) -> Vec<N> {
        let program = self.programs.function(function).expect("every model has it");
        assert!(matches!(program.entry.arguments, Arguments::State | Arguments::StateInputs), "{function}");
        let (q, u) = point.split_at(self.equations.state_coordinates.len());
        run(&program.code, &|leaf| match leaf {
            Leaf::Value(i) => prepared[i].clone(),
            Leaf::StateCoordinate(i) => N::from_double(q[i]),
            Leaf::StateSpeed(i) => N::from_double(u[i]),
            other => panic!("{other:?} is not in the state"),
        })
    }
}
