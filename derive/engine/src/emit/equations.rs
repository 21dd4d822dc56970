//! The derived equations as text: in the notation of models for `MODEL`, as in print for the documentation.

use super::layout::{laid_out, width};
use crate::projection::Equations;
use crate::symbolic::tables::Set;
use crate::symbolic::{Expr, Matrix, Notation, Parts, Symbol, unicode};
use std::collections::HashMap;

/// A line of the documentation that would be longer has its entries by name.
const LINE: usize = 110;
/// Entries that are no longer stay where they are.
const SHORT: usize = 16;
/// The equations of a function that are longer do not stand in its documentation.
const DOCUMENTED: usize = 5000;
/// What the equations of one model may be long together, in characters.
const TOLD: usize = 400_000;

/// An equation in the notation of models.
#[derive(Clone, Debug)]
pub struct Line {
    /// Its left side.
    pub symbol: String,
    /// The emitted function that computes it; empty for a part of others.
    pub function: &'static str,
    /// Its number in the paper.
    pub source: &'static str,
    /// Its right side.
    pub text: String,
}

/// What an equation defines.
enum Side {
    Scalar(Expr),
    Vector(Vec<Expr>),
    Matrix(Matrix),
}

struct Entry {
    function: &'static str,
    symbol: String,
    source: &'static str,
    side: Side,
}

/// The equations of a model.
pub struct Texts<'a> {
    equations: &'a Equations,
    entries: Vec<Entry>,
    /// Right sides in the notation of models, over the parts.
    texts: HashMap<Expr, String>,
    parts: Parts,
}

struct Collector<'a> {
    equations: &'a Equations,
    entries: Vec<Entry>,
}

impl Collector<'_> {
    fn each(&mut self, function: &'static str, source: &'static str, symbols: Vec<String>, roots: &[Expr]) {
        for (symbol, root) in symbols.into_iter().zip(roots) {
            self.entries.push(Entry { function, symbol, source, side: Side::Scalar(*root) });
        }
    }

    fn list(&mut self, function: &'static str, symbol: &str, source: &'static str, roots: &[Expr]) {
        self.entries.push(Entry { function, symbol: symbol.to_owned(), source, side: Side::Vector(roots.to_vec()) });
    }

    fn matrix(&mut self, function: &'static str, symbol: &str, source: &'static str, matrix: &Matrix) {
        self.entries.push(Entry { function, symbol: symbol.to_owned(), source, side: Side::Matrix(matrix.clone()) });
    }

    fn dots(&self, symbols: &[Symbol]) -> Vec<String> {
        symbols.iter().map(|s| format!("dot({})", self.equations.graph.name(*s))).collect()
    }
}

impl<'a> Texts<'a> {
    /// All equations of the model.
    pub fn new(e: &'a Equations) -> Self {
        let mut c = Collector { equations: e, entries: Vec::new() };
        let configured = e.state_coordinates != e.coordinates;
        let names =
            |symbols: &[Symbol]| -> Vec<String> { symbols.iter().map(|s| e.graph.name(*s).to_owned()).collect() };
        // Section 4 of the paper where x = g(q, t) is given, section 5 otherwise.
        let number = |holonomic, otherwise| if configured { holonomic } else { otherwise };
        c.each("derivative", number("(4.3)", "(5.7)"), c.dots(&e.state_coordinates), &e.coordinate_rates);
        c.each("accelerations", number("(4.10)", "(5.6)"), c.dots(&e.state_speeds), &e.accelerations);
        if !e.is_recursive() {
            c.matrix("mass_matrix", "M_d", "(4.10)", &e.mass_matrix);
        }
        if !e.is_recursive() || e.is_untied() {
            c.list("forcing", "h_u*", number("(4.10)", "(5.6)"), &e.forcing);
        }
        if configured {
            c.each("coordinates", "(4.2)", names(&e.coordinates), &e.initial_coordinates);
        }
        if e.combined {
            // What the names of combinations stand for.
            c.each("chart_0_speeds", "(5.2)", names(&e.state_speeds), &e.chart_speeds[0]);
        }
        c.each("velocities", number("(4.4)", "(5.3)"), names(&e.speeds), &e.velocities);
        // Where M is told by what it does, D is the unit matrix if nothing ties the speeds, and A if there are no quaternions.
        if !e.is_recursive() || !e.is_untied() {
            c.matrix("complement", "D", number("(4.9)", "(3.1)"), &e.complement);
        }
        c.list("complement_bias", "a_u", number("(4.5)", "(5.5)"), &e.complement_bias);
        c.each("velocity_rates", number("(4.5)", "(5.5)"), c.dots(&e.speeds), &e.velocity_rates);
        let lambdas = e.multiplier_names.iter().map(|n| format!("lambda({n})")).collect();
        c.each("multipliers", "(3.6)", lambdas, &e.multipliers);
        if !e.is_recursive() || e.norms > 0 {
            c.matrix("kinematic_matrix", "A", "(2.1)", &e.kinematic_matrix);
        }
        c.list("kinematic_bias", "a0", "(2.1)", &e.kinematic_bias);
        match e.is_recursive() {
            true => c.list("momenta", "M v", "(2.3)", &e.momenta),
            false => c.matrix("inertia", "M", "(2.3)", &e.inertia),
        }
        c.list("forces", "h*", "(2.3)", &e.forces);
        c.matrix("constraint_matrix", "C", "(2.4)", &e.constraint_matrix);
        c.list("constraint_bias", "c0*", "(2.6)", &e.constraint_bias);
        let residuals = e.position_names.iter().map(|n| format!("f({n})")).collect();
        c.each("position_residual", "(2.5)", residuals, &e.position_residual);
        let residuals = e.velocity_row_names().iter().map(|n| format!("phi({n})")).collect();
        c.each("velocity_residual", "(2.5)", residuals, &e.velocity_residual);
        c.each("kinetic_energy", "", vec!["T".to_owned()], &[e.kinetic_energy]);
        let potential: Vec<Expr> = e.potential_energy.into_iter().collect();
        c.each("potential_energy", "", vec!["V".to_owned()], &potential);
        c.each("outputs", "", e.outputs.names.clone(), &e.outputs.values);
        let entries = c.entries;
        let roots: Vec<Expr> = entries.iter().flat_map(Entry::roots).collect();
        let symbols = e.graph.symbols().map(|s| e.graph.name(s));
        let taken: Vec<&str> = symbols.chain(entries.iter().map(|entry| entry.symbol.as_str())).collect();
        let prefix = prefix(&taken);
        let (texts, parts) = e.graph.display_by_parts(&roots, |n| format!("{prefix}{n}"));
        Texts { equations: e, entries, texts, parts }
    }

    /// Every equation in the notation of models, each part before the first that needs it.
    pub fn model(&self) -> Vec<Line> {
        let graph = &self.equations.graph;
        let (mut lines, mut left) = (Vec::new(), TOLD);
        let mut known = Set::default();
        let mut push = |symbol: &str, function, source, text: String| {
            // What is beyond any reader is left out, and seen to be.
            let text = if text.len() > left { "…".to_owned() } else { text };
            left = left.saturating_sub(text.len());
            lines.push(Line { symbol: symbol.to_owned(), function, source, text });
        };
        for entry in &self.entries {
            for (e, name) in self.parts.of(graph, &entry.roots()) {
                if !known.contains(e) {
                    known.insert(e);
                    push(name, "", "", self.texts[&e].clone());
                }
            }
            push(&entry.symbol, entry.function, entry.source, entry.side.model(&|e| self.text(e)));
        }
        lines
    }

    /// A right side: by its name where it is a part.
    fn text(&self, e: Expr) -> String {
        self.parts.name(e).map_or_else(|| self.texts[&e].clone(), str::to_owned)
    }

    /// What a function computes, as in print; `None` where it is more than a page.
    pub fn of(&self, function: &str) -> Option<Vec<String>> {
        let shown: &[&str] = match function {
            "derivative" => &["derivative", "accelerations"],
            "mass_matrix_and_forcing" => &["mass_matrix", "forcing"],
            _ => &[function],
        };
        let entries: Vec<&Entry> = self.entries.iter().filter(|entry| shown.contains(&entry.function)).collect();
        let roots: Vec<Expr> = entries.iter().flat_map(|entry| entry.roots()).collect();
        let graph = &self.equations.graph;
        let needed = self.parts.of(graph, &roots);
        let all: Vec<Expr> = roots.iter().copied().chain(needed.iter().map(|(e, _)| *e)).collect();
        if all.iter().map(|e| self.texts[e].len()).sum::<usize>() > DOCUMENTED {
            return None;
        }
        // A right side is written out, unless others here call it by name.
        let called = |part: Expr| all.iter().any(|e| *e != part && graph.reachable(&[*e]).contains(&part));
        let texts = graph.display_over(&all, &self.parts, Notation::Unicode);
        let mut texts: HashMap<Expr, String> = all.iter().copied().zip(texts).collect();
        let mut lines = Vec::new();
        for (e, name) in needed.iter().filter(|(e, _)| called(*e)) {
            let name = unicode::name(name);
            lines.push(format!("{name} = {}", texts[e]));
            texts.insert(*e, name);
        }
        for entry in entries {
            let symbol = unicode::name(&entry.symbol);
            match &entry.side {
                Side::Scalar(e) => lines.push(format!("{symbol} = {}", texts[e])),
                Side::Vector(entries) => {
                    let rows: Vec<Vec<Expr>> = entries.iter().map(|e| vec![*e]).collect();
                    lines.extend(matrix(&symbol, &rows, &texts));
                }
                Side::Matrix(entries) => {
                    let rows: Vec<Vec<Expr>> = (0..entries.rows()).map(|i| entries.row(i).to_vec()).collect();
                    lines.extend(matrix(&symbol, &rows, &texts));
                }
            }
        }
        Some(lines)
    }
}

/// What the names of parts begin with, so that none of them is taken.
fn prefix(taken: &[&str]) -> String {
    let clear = |prefix: &String| taken.iter().all(|name| !is_part(name, prefix));
    (1..).map(|n| "e".repeat(n)).find(clear).unwrap_or_default()
}

/// Whether a name could be that of a part.
fn is_part(name: &str, prefix: &str) -> bool {
    name.strip_prefix(prefix).is_some_and(|rest| !rest.is_empty() && rest.chars().all(|c| c.is_ascii_digit()))
}

/// A matrix laid out, its entries by name where they are too long for a line.
fn matrix(symbol: &str, rows: &[Vec<Expr>], texts: &HashMap<Expr, String>) -> Vec<String> {
    let mut entries: Vec<Vec<String>> = rows.iter().map(|row| row.iter().map(|e| texts[e].clone()).collect()).collect();
    let mut lines = Vec::new();
    let column = rows.iter().all(|row| row.len() == 1);
    if !column && width(&entries) + symbol.chars().count() > LINE {
        let mut named: Vec<(Expr, String)> = Vec::new();
        for (i, row) in rows.iter().enumerate() {
            for (j, e) in row.iter().enumerate().filter(|(_, e)| texts[*e].chars().count() > SHORT) {
                let known = named.iter().find(|(known, _)| known == e).map(|(_, name)| name.clone());
                entries[i][j] = known.unwrap_or_else(|| {
                    let name = format!("{symbol}[{}, {}]", i + 1, j + 1);
                    named.push((*e, name.clone()));
                    name
                });
            }
        }
        lines.extend(named.iter().map(|(e, name)| format!("{name} = {}", texts[e])));
    }
    laid_out(&format!("{symbol} = "), &entries).into_iter().chain(lines).collect()
}

impl Entry {
    fn roots(&self) -> Vec<Expr> {
        match &self.side {
            Side::Scalar(e) => vec![*e],
            Side::Vector(entries) => entries.clone(),
            Side::Matrix(matrix) => matrix.entries().to_vec(),
        }
    }
}

impl Side {
    fn model(&self, text: &dyn Fn(Expr) -> String) -> String {
        let list = |entries: &[Expr]| entries.iter().map(|e| text(*e)).collect::<Vec<_>>().join(", ");
        match self {
            Side::Scalar(e) => text(*e),
            Side::Vector(entries) => format!("[{}]", list(entries)),
            Side::Matrix(matrix) => {
                let rows: Vec<String> = (0..matrix.rows()).map(|i| format!("[{}]", list(matrix.row(i)))).collect();
                format!("[{}]", rows.join(", "))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_have_names_of_their_own() {
        assert_eq!(prefix(&["e", "ea", "energy", "x1"]), "e");
        assert_eq!(prefix(&["x", "e1"]), "ee");
        assert_eq!(prefix(&["e12", "ee3", "eee"]), "eee");
    }
}
