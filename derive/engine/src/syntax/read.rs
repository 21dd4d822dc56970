//! The statements on the struct, one after another.

use proc_macro2::{Ident, Span, TokenStream};
use syn::{Attribute, DeriveInput, MacroDelimiter, Meta};

use super::declarations::*;
use super::diagnostics::{Diagnostics, messages};
use super::entries::{self, Entry};
use super::families::Families;
use super::forms::*;
use super::geometry::{ElementKind, Geometry, element};
use super::statements::{FIELD_STATEMENTS, STATEMENTS, misspelt};
use super::{fields, options};

/// A statement: its name, what stands in its parentheses, and their closing one.
pub(crate) struct Statement {
    pub name: Ident,
    pub tokens: TokenStream,
    pub end: Span,
}

impl Statement {
    fn entries(&self) -> Vec<Entry> {
        entries::split(self.tokens.clone(), self.end)
    }
}

/// Reads the struct, its fields and its statements.
pub(crate) fn declarations(input: DeriveInput, diagnostics: &mut Diagnostics) -> Declarations {
    let mut statements = Vec::new();
    for attribute in &input.attrs {
        statements.extend(statement(attribute, STATEMENTS, diagnostics));
    }
    let read_fields = fields::read(&input, diagnostics);
    let mut families = Families::new(read_fields.arrays);
    write_out(&mut statements, &mut families, diagnostics);
    let krate = options::default_crate(input.ident.span());
    let mut declarations = Declarations {
        fields: read_fields.fields,
        arrays: families.lengths(),
        ident: input.ident,
        vis: input.vis,
        generics: input.generics,
        options: Options { krate, simplify: true, elimination: None },
        coordinates: Vec::new(),
        speeds: None,
        inputs: Vec::new(),
        defines: Vec::new(),
        outputs: Vec::new(),
        functions: Vec::new(),
        kinematics: None,
        inertia: None,
        forces: None,
        kinetic_energy: None,
        potential_energy: None,
        constraints: Vec::new(),
        configuration: None,
        velocities: None,
        independent: Vec::new(),
        complement: None,
        start: Vec::new(),
        geometry: Geometry::default(),
        complete: true,
    };
    let mut seen: Vec<String> = Vec::new();
    for statement in &statements {
        let name = statement.name.to_string();
        let repeatable = REPEATABLE.contains(&name.as_str()) || ElementKind::of(&name).is_some();
        if seen.contains(&name) && !repeatable {
            diagnostics.report(&statement.name, messages::statement_twice(&name));
        } else {
            read(statement, &mut declarations, diagnostics);
            seen.push(name);
        }
    }
    declarations.complete = diagnostics.only_local();
    declarations
}

/// Statements that may stand several times, besides those of elements.
const REPEATABLE: [&str; 10] = [
    "constraint",
    "define",
    "function",
    "start",
    "inputs",
    "independent",
    "output",
    "frame",
    "point",
    "generalized_force",
];

/// Sizes and lengths first, wherever they stand; then every statement without families.
fn write_out(statements: &mut Vec<Statement>, families: &mut Families, diagnostics: &mut Diagnostics) {
    let is = |statement: &Statement, names: &[&str]| names.iter().any(|name| statement.name == name);
    for size in statements.iter().filter(|statement| is(statement, &["size"])) {
        families.size(size.tokens.clone(), size.end, diagnostics);
    }
    for statement in statements.iter() {
        if is(statement, &["coordinates", "speeds", "inputs"]) {
            families.declare(statement.tokens.clone());
        } else if is(statement, &["configuration", "velocities"]) {
            families.declare_introduced(statement.tokens.clone());
        }
    }
    statements.retain(|statement| !is(statement, &["size"]));
    for statement in statements {
        let tokens = std::mem::take(&mut statement.tokens);
        statement.tokens = if is(statement, &["coordinates", "speeds", "inputs"]) {
            families.declaration(tokens)
        } else if is(statement, &["function", "holonomy"]) {
            tokens
        } else {
            families.statement(tokens, diagnostics)
        };
    }
}

/// The statement that an attribute is, if it is one of those `allowed` here. What belongs to other
/// macros is passed over, what looks like a misspelt statement is reported.
pub(crate) fn statement(attribute: &Attribute, allowed: &[&str], diagnostics: &mut Diagnostics) -> Option<Statement> {
    let name = attribute.path().get_ident()?;
    let text = name.to_string();
    if !allowed.contains(&text.as_str()) {
        if STATEMENTS.contains(&text.as_str()) {
            diagnostics.report(name, messages::statement_on_field(name));
        } else if FIELD_STATEMENTS.contains(&text.as_str()) {
            diagnostics.report(name, messages::statement_on_struct(name));
        } else if let Some(meant) = misspelt(&text) {
            diagnostics.report(name, messages::statement_unknown(name, meant));
        }
        return None;
    }
    match &attribute.meta {
        Meta::List(list) if matches!(list.delimiter, MacroDelimiter::Paren(_)) => {
            Some(Statement { name: name.clone(), tokens: list.tokens.clone(), end: list.delimiter.span().close() })
        }
        _ => {
            diagnostics.report(name, messages::statement_without_list(name));
            None
        }
    }
}

fn read(statement: &Statement, model: &mut Declarations, diagnostics: &mut Diagnostics) {
    let span = statement.name.span();
    let entries = statement.entries();
    if entries.is_empty() {
        diagnostics.report(span, messages::statement_empty(&statement.name));
        return;
    }
    match statement.name.to_string().as_str() {
        "coordinates" => model.coordinates = names(&entries, diagnostics),
        "inputs" => model.inputs.extend(names(&entries, diagnostics)),
        "speeds" => {
            let names = names(&entries, diagnostics);
            model.speeds = Some(Speeds { names, span });
        }
        "kinematics" => {
            let entries = entries.iter().filter_map(|entry| kinematic(entry, diagnostics)).collect();
            model.kinematics = Some(Kinematics { entries, span });
        }
        "inertia" => {
            model.inertia = inertia(&entries, span, diagnostics);
        }
        "forces" => {
            let entries = expressions(&entries, diagnostics);
            model.forces = Some(List { entries, span });
        }
        "kinetic_energy" => model.kinetic_energy = single(&entries, diagnostics),
        "potential_energy" => model.potential_energy = single(&entries, diagnostics),
        "constraint" => model.constraints.extend(constraints(&entries, diagnostics)),
        "define" => model.defines.extend(assignments(&entries, "mu = expression", diagnostics)),
        "output" => model.outputs.extend(entries.iter().filter_map(|entry| output(entry, diagnostics))),
        "function" => model.functions.extend(function(&entries, diagnostics)),
        "start" => model.start.extend(assignments(&entries, "theta = 0.3", diagnostics)),
        "configuration" => model.configuration = Some(configuration(&entries, span, diagnostics)),
        "velocities" => model.velocities = Some(velocities(&entries, span, diagnostics)),
        "independent" => {
            let entries = entries.iter().filter_map(|entry| entry.independent(diagnostics)).collect();
            model.independent.push(Independent { entries, span });
        }
        "complement" => {
            let rows = entries.iter().filter_map(|entry| complement_row(entry, diagnostics)).collect();
            model.complement = Some(Complement { rows, span });
        }
        "frame" => model.geometry.frames.extend(assignments(&entries, "A = rotate(N, z, theta)", diagnostics)),
        "point" => model.geometry.points.extend(assignments(&entries, "P = O + l*A.x", diagnostics)),
        "gravity" => model.geometry.gravity = single(&entries, diagnostics),
        "generalized_force" => {
            model.geometry.generalized.extend(assignments(&entries, "theta = expression", diagnostics));
        }
        "holonomy" => options::read(&entries, &mut model.options, diagnostics),
        name => {
            if let Some(kind) = ElementKind::of(name) {
                let elements = entries.iter().filter_map(|entry| element(kind, entry, diagnostics));
                model.geometry.elements.extend(elements);
            }
        }
    }
}
