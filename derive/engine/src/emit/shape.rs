//! The names and sizes of the emitted types.

use super::target::{Target, ident};
use crate::program::entry::chart_guards;
use crate::program::names::Namer;
use crate::program::{Names, Shape};
use crate::projection::Equations;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

/// The suffix of the struct of outputs, whose names are a namespace of their own.
pub const OUTPUTS: &str = "Outputs";

/// What is known of a model: all of it, or as much as a model with errors tells.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Known {
    /// Coordinates of the state, then independent speeds.
    pub state: Vec<String>,
    /// How many of them are coordinates.
    pub state_coordinates: usize,
    /// Initial coordinates.
    pub coordinates: Vec<String>,
    /// Initial velocities.
    pub velocities: Vec<String>,
    /// Multipliers.
    pub multipliers: Vec<String>,
    /// Inputs.
    pub inputs: Vec<String>,
    /// Outputs.
    pub outputs: Vec<String>,
    /// Parameters.
    pub parameters: Vec<String>,
    /// How many guards.
    pub guards: usize,
    /// How many independent accelerations there are.
    pub reduced: usize,
    /// How many rows C has.
    pub rows: usize,
    /// How many of them bind velocities.
    pub velocity_rows: usize,
    /// How many position constraints there are.
    pub position_rows: usize,
    /// The carriers.
    pub carriers: Vec<String>,
    /// How many charts there are.
    pub charts: usize,
    /// The length of the longest list of guards among them.
    pub chart_guards: usize,
}

impl Known {
    /// Everything.
    pub fn of(equations: &Equations) -> Self {
        let names = |symbols: &[crate::symbolic::Symbol]| -> Vec<String> {
            symbols.iter().map(|s| equations.graph.name(*s).to_owned()).collect()
        };
        Known {
            state: [names(&equations.state_coordinates), names(&equations.state_speeds)].concat(),
            state_coordinates: equations.state_coordinates.len(),
            coordinates: names(&equations.coordinates),
            velocities: names(&equations.speeds),
            multipliers: equations.multiplier_names.clone(),
            inputs: names(&equations.inputs),
            outputs: equations.outputs.names.clone(),
            parameters: names(&equations.parameters),
            guards: equations.guards.len(),
            reduced: equations.reduced_speeds.len(),
            rows: equations.rows.len(),
            velocity_rows: equations.velocity_residual.len(),
            position_rows: equations.position_names.len(),
            carriers: names(&equations.carriers),
            charts: equations.charts.len() + 1,
            chart_guards: chart_guards(equations),
        }
    }
}

/// One emitted struct: its suffix, its fields, and the model's names of the fields.
#[derive(Clone, Debug)]
pub struct Record {
    /// `State` of `RollingDiskState`.
    pub suffix: &'static str,
    /// The fields.
    pub fields: Vec<String>,
    /// The model's names.
    pub names: Vec<String>,
}

/// All emitted types.
#[derive(Clone, Debug)]
pub struct Types {
    /// What is known of the model.
    pub known: Known,
    /// The state.
    pub state: Record,
    /// The parameters.
    pub parameters: Record,
    /// The velocities.
    pub velocities: Record,
    /// The multipliers.
    pub multipliers: Record,
    /// The inputs.
    pub inputs: Record,
    /// The outputs.
    pub outputs: Record,
    /// The prepared values.
    pub values: Record,
    /// The scalar's name.
    pub scalar: Ident,
}

impl Types {
    /// The types of a model; `names` gives the prepared values where they are known.
    pub fn new(target: &Target, known: Known, names: Option<&Names>) -> Self {
        let record = |suffix: &'static str, names: &[String]| {
            let mut namer = Namer::default();
            Record { suffix, fields: names.iter().map(|n| namer.unique(n)).collect(), names: names.to_vec() }
        };
        let parameters = record("Parameters", &known.parameters);
        let values = match names {
            Some(names) => Record { suffix: "Values", fields: names.values.clone(), names: names.values.clone() },
            None => Record { suffix: "Values", ..parameters.clone() },
        };
        Types {
            state: record("State", &known.state),
            velocities: record("Velocities", &known.velocities),
            multipliers: record("Multipliers", &known.multipliers),
            inputs: record("Inputs", &known.inputs),
            outputs: record(OUTPUTS, &known.outputs),
            parameters,
            values,
            known,
            scalar: target.scalar(),
        }
    }

    /// The type of a record over a scalar; an empty array where it has no fields.
    pub fn of(&self, target: &Target, record: &Record, scalar: &TokenStream) -> TokenStream {
        if record.fields.is_empty() {
            return quote!([#scalar; 0]);
        }
        let name = target.type_name(record.suffix);
        quote!(#name<#scalar>)
    }

    /// The type of a group of results.
    pub fn output(&self, target: &Target, shape: Shape) -> TokenStream {
        let scalar = &self.scalar;
        let krate = &target.krate;
        let t = quote!(#scalar);
        match shape {
            Shape::State => self.of(target, &self.state, &t),
            Shape::Velocities => self.of(target, &self.velocities, &t),
            Shape::Multipliers => self.of(target, &self.multipliers, &t),
            Shape::Outputs => self.of(target, &self.outputs, &t),
            Shape::Array(n) => {
                let n = Literal::usize_unsuffixed(n);
                quote!([#t; #n])
            }
            Shape::Matrix(rows, columns) => {
                let (rows, columns) = (Literal::usize_unsuffixed(rows), Literal::usize_unsuffixed(columns));
                quote!(#krate::__private::SMatrix<#t, #rows, #columns>)
            }
            Shape::Scalar => t,
            Shape::Optional(_) => quote!(::core::option::Option<#t>),
        }
    }
}

impl Record {
    /// The fields as identifiers, with the user's spans where the names are the user's.
    pub fn idents(&self, target: &Target) -> Vec<Ident> {
        let declared = |name: &str| match self.suffix {
            OUTPUTS => target.output(name),
            _ => target.declared(name),
        };
        let span = |name: &String| declared(name).map_or_else(Span::call_site, |d| d.span);
        self.fields.iter().zip(&self.names).map(|(field, name)| ident(field, span(name))).collect()
    }
}
