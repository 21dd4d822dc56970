//! Functions of the user's, with their derivatives as functions of their own.

use super::{Expr, Function, Graph, Node};

/// A function of one argument that the user's program has, or one of its derivatives.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Given {
    /// Its name.
    pub name: String,
    /// The number of the function that it is a derivative of.
    pub function: usize,
    /// Which derivative it is.
    pub order: usize,
    /// Whether nobody gave it: equations that need it cannot be emitted.
    pub missing: bool,
    derivative: Option<u32>,
}

impl Graph {
    /// Adds a function with its derivatives, by their names; `names` begins with the function itself.
    pub fn give(&mut self, names: &[String]) -> Function {
        let function = self.given.iter().map(|given| given.function + 1).max().unwrap_or(0);
        let first = self.given.len() as u32;
        for (order, name) in names.iter().enumerate() {
            let derivative = (order + 1 < names.len()).then_some(first + order as u32 + 1);
            self.given.push(Given { name: name.clone(), function, order, missing: false, derivative });
        }
        Function::Given(first)
    }

    /// All functions of the user's and their derivatives, those included that nobody gave.
    pub fn given(&self) -> &[Given] {
        &self.given
    }

    /// The function's name as it stands in models.
    pub fn function_name(&self, function: Function) -> &str {
        match function {
            Function::Given(at) => &self.given[at as usize].name,
            other => other.name(),
        }
    }

    /// The derivative of a function of the user's; one that nobody gave is made up, and told from the others.
    pub(super) fn derivative_of_given(&mut self, at: u32) -> Function {
        let Given { name, function, order, derivative, .. } = self.given[at as usize].clone();
        let next = derivative.unwrap_or_else(|| {
            let next = self.given.len() as u32;
            let name = format!("{name}\u{2032}");
            self.given.push(Given { name, function, order: order + 1, missing: true, derivative: None });
            self.given[at as usize].derivative = Some(next);
            next
        });
        Function::Given(next)
    }

    /// The functions of the user's in the expressions, as positions in [`Graph::given`].
    pub fn given_in(&self, roots: &[Expr]) -> Vec<usize> {
        let mut found: Vec<usize> = self
            .reachable(roots)
            .into_iter()
            .filter_map(|e| match self.node(e) {
                Node::Function(Function::Given(at), _) => Some(*at as usize),
                _ => None,
            })
            .collect();
        found.sort_unstable();
        found.dedup();
        found
    }
}
