//! Function bodies as text. Text is lexed by the compiler itself, which is far quicker than building tokens one by one
//! in an unoptimised macro, and it can be read in tests.

use crate::program::{Arguments, Block, Code, Layout, Leaf, Let, Names, Operation, Part, Reference, Shape};
use crate::symbolic::{Function, Rational};
use std::fmt::Write;

/// Larger unit matrices are called so instead of being written out.
const WRITTEN_OUT: usize = 9;

/// Writes the steps of one program.
pub struct Writer<'a> {
    /// The program.
    pub code: &'a Code,
    /// How it is written down.
    pub layout: &'a Layout,
    /// Names of what it reads.
    pub names: &'a Names,
    /// The scalar's name.
    pub scalar: &'a str,
}

/// How tightly an expression binds.
#[derive(Copy, Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Sign,
    Atom,
}

impl Writer<'_> {
    /// The text of a step where it is used.
    pub fn expression(&self, reference: Reference) -> String {
        let mut out = String::new();
        self.write(&mut out, reference, Binding::Sum, false);
        out
    }

    /// The text of a named step where it is defined.
    fn definition(&self, reference: Reference) -> String {
        let mut out = String::new();
        self.write(&mut out, reference, Binding::Sum, true);
        out
    }

    /// Only steps without a name nest, and those stay short.
    fn write(&self, out: &mut String, reference: Reference, least: Binding, define: bool) {
        if !define && let Some(name) = &self.layout.names[reference as usize] {
            out.push_str(name);
            return;
        }
        let operation = &self.code.operations[reference as usize];
        let binding = match operation {
            Operation::Add(..) | Operation::Subtract(..) => Binding::Sum,
            Operation::Multiply(..) | Operation::Divide(..) => Binding::Product,
            Operation::Negate(_) => Binding::Sign,
            _ => Binding::Atom,
        };
        let parentheses = binding < least || (binding == Binding::Sign && least > Binding::Sum);
        if parentheses {
            out.push('(');
        }
        let mut binary = |a: Reference, sign: &str, b: Reference, right: Binding| {
            self.write(out, a, binding, false);
            out.push_str(sign);
            self.write(out, b, right, false);
        };
        match operation {
            Operation::Add(a, b) => binary(*a, " + ", *b, Binding::Product),
            Operation::Subtract(a, b) => binary(*a, " - ", *b, Binding::Product),
            Operation::Multiply(a, b) => binary(*a, " * ", *b, Binding::Sign),
            Operation::Divide(a, b) => binary(*a, " / ", *b, Binding::Sign),
            Operation::Negate(a) => {
                out.push('-');
                self.write(out, *a, Binding::Atom, false);
            }
            Operation::Read(Leaf::Pi) => {
                let _ = write!(out, "{}::from_f64(::core::f64::consts::PI)", self.scalar);
            }
            Operation::Read(leaf) => {
                out.push_str(Names::place(*leaf));
                out.push_str(self.names.of(*leaf));
            }
            Operation::Number(number) => {
                let _ = write!(out, "{}::from_f64({})", self.scalar, literal(number));
            }
            Operation::Sine(a) => self.call(out, *a, "sin_cos().0"),
            Operation::Cosine(a) => self.call(out, *a, "sin_cos().1"),
            Operation::Root(a) => self.call(out, *a, "sqrt()"),
            Operation::Call(Function::Given(at), arguments) => {
                let given = &self.names.functions[*at as usize];
                let orders = user_function(given.function);
                self.call(out, arguments[0], "apply(");
                let _ = if given.order == 0 {
                    write!(out, "{orders})")
                } else {
                    write!(out, "&{orders}[{}..])", given.order)
                };
            }
            Operation::Call(function, arguments) => {
                self.call(out, arguments[0], function.name());
                out.push('(');
                for (k, argument) in arguments[1..].iter().enumerate() {
                    out.push_str(if k == 0 { "" } else { ", " });
                    self.write(out, *argument, Binding::Sum, false);
                }
                out.push(')');
            }
        }
        if parentheses {
            out.push(')');
        }
    }

    fn call(&self, out: &mut String, receiver: Reference, method: &str) {
        self.write(out, receiver, Binding::Atom, false);
        out.push('.');
        out.push_str(method);
    }

    fn name(&self, reference: Reference) -> &str {
        self.layout.names[reference as usize].as_deref().unwrap_or("_")
    }

    fn list(&self, references: &[Reference]) -> String {
        references.iter().map(|r| self.name(*r)).collect::<Vec<_>>().join(", ")
    }

    /// `let [x, _, phi] = *at;`, the coordinates, the carriers or their rates that the program reads.
    pub fn arrays(&self, arguments: Arguments) -> String {
        let coordinates = |leaf: &Leaf| if let Leaf::Coordinate(i) = leaf { Some(*i) } else { None };
        let carriers = |leaf: &Leaf| if let Leaf::Carrier(i) = leaf { Some(*i) } else { None };
        let rates = |leaf: &Leaf| if let Leaf::CarrierRate(i) = leaf { Some(*i) } else { None };
        match arguments {
            Arguments::Coordinates
            | Arguments::CoordinatesVelocities
            | Arguments::CoordinatesVelocitiesInputs
            | Arguments::CoordinatesVelocitiesRatesInputs => self.array("at", &self.names.coordinates, coordinates),
            Arguments::StateCarriers => self.array("w", &self.names.carriers, carriers),
            Arguments::StateCarriersRates => {
                self.array("w", &self.names.carriers, carriers) + &self.array("dw", &self.names.carrier_rates, rates)
            }
            _ => String::new(),
        }
    }

    /// One array, taken apart.
    fn array(&self, argument: &str, names: &[String], place: impl Fn(&Leaf) -> Option<usize>) -> String {
        let mut read = vec![false; names.len()];
        for operation in &self.code.operations {
            if let Operation::Read(leaf) = operation
                && let Some(i) = place(leaf)
            {
                read[i] = true;
            }
        }
        let Some(last) = read.iter().rposition(|r| *r) else { return String::new() };
        let mut pattern: Vec<&str> = (0..=last).map(|i| if read[i] { names[i].as_str() } else { "_" }).collect();
        if last + 1 < read.len() {
            pattern.push("..");
        }
        format!("let [{}] = *{argument};\n", pattern.join(", "))
    }

    /// The `let`s of a part.
    pub fn part(&self, part: &Part) -> String {
        let mut out = String::new();
        if !part.enter.is_empty() {
            let _ = writeln!(out, "let [{}] = part;", self.list(&part.enter));
        }
        out.push_str(&self.blocks(part));
        out
    }

    /// The `let`s of a part, without what enters it.
    pub fn blocks(&self, part: &Part) -> String {
        let mut out = String::new();
        for block in &part.blocks {
            self.block(&mut out, block);
        }
        out
    }

    fn block(&self, out: &mut String, block: &Block) {
        // The last block of a program needs no scope of its own: the results stand behind it.
        let nested = !block.leave.is_empty();
        let leave = match block.leave.as_slice() {
            [one] => self.name(*one).to_owned(),
            many => format!("({})", self.list(many)),
        };
        if nested {
            let _ = writeln!(out, "let {leave} = {{");
        }
        for statement in &block.lets {
            match statement {
                Let::One(reference) => {
                    let _ = writeln!(out, "let {} = {};", self.name(*reference), self.definition(*reference));
                }
                Let::SineCosine { angle, sine, cosine } => {
                    let name = |r: &Option<Reference>| r.map_or("_", |r| self.name(r)).to_owned();
                    let mut angle_text = String::new();
                    self.write(&mut angle_text, *angle, Binding::Atom, false);
                    let _ = writeln!(out, "let ({}, {}) = {angle_text}.sin_cos();", name(sine), name(cosine));
                }
            }
        }
        if nested {
            let _ = writeln!(out, "{leave}\n}};");
        }
    }

    /// Whether results are a unit matrix too large to be written out.
    pub fn is_unit(&self, shape: Shape, outputs: &[Reference]) -> bool {
        let Shape::Matrix(rows, columns) = shape else { return false };
        let unit = |at: usize, r: &Reference| match &self.code.operations[*r as usize] {
            Operation::Number(number) if at / columns == at % columns => number.is_one(),
            Operation::Number(number) => number.is_zero(),
            _ => false,
        };
        rows == columns && rows > WRITTEN_OUT && outputs.iter().enumerate().all(|(at, r)| unit(at, r))
    }

    /// The results `outputs[from..from + n]` packed in a shape; `record` names the struct and its fields.
    pub fn pack(&self, shape: Shape, outputs: &[Reference], record: Option<(&str, &[String])>) -> String {
        let text = |r: &Reference| self.expression(*r);
        match (shape, record) {
            (_, Some((name, fields))) if !fields.is_empty() => {
                let entries: Vec<String> = fields
                    .iter()
                    .zip(outputs)
                    .map(|(field, r)| {
                        let value = text(r);
                        if value == *field { value } else { format!("{field}: {value}") }
                    })
                    .collect();
                format!("{name} {{ {} }}", entries.join(", "))
            }
            (Shape::Matrix(rows, columns), _) => {
                // nalgebra stores columns.
                let column = |j: usize| -> String {
                    (0..rows).map(|i| text(&outputs[i * columns + j])).collect::<Vec<_>>().join(", ")
                };
                let columns: Vec<String> = (0..columns).map(|j| format!("[{}]", column(j))).collect();
                format!("::core::convert::From::from([{}])", columns.join(", "))
            }
            (Shape::Scalar, _) => outputs.iter().map(text).collect(),
            (Shape::Optional(true), _) => {
                format!("::core::option::Option::Some({})", outputs.iter().map(text).collect::<String>())
            }
            (Shape::Optional(false), _) => "::core::option::Option::None".to_owned(),
            _ => format!("[{}]", outputs.iter().map(text).collect::<Vec<_>>().join(", ")),
        }
    }
}

/// The constant that holds a function of the user's with its derivatives.
pub fn user_function(number: usize) -> String {
    format!("HOLONOMY_FUNCTION_{}", number + 1)
}

/// A number as an expression of type `f64` that the compiler folds.
fn literal(number: &Rational) -> String {
    let value = number.to_f64();
    if !value.is_finite() {
        return format!("{}::core::f64::INFINITY", if number.is_negative() { "-" } else { "" });
    }
    let (n, d) = number.parts();
    let short = format!("{value:?}");
    // A quotient of small integers says more than seventeen digits.
    if short.len() > 12 && n.len() < 10 && d.len() < 10 { format!("{n}.0 / {d}.0") } else { short }
}
