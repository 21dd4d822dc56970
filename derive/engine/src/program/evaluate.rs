//! Programs run in double precision, step by step as they are emitted.

use super::entry::Arguments;
use super::operation::{Code, Leaf, Operation};
use super::plan::Programs;
use crate::projection::Equations;
use crate::symbolic::Symbol;
use crate::symbolic::evaluate::double;

impl Code {
    /// The results for given readings.
    pub fn evaluate(&self, read: &dyn Fn(Leaf) -> f64) -> Vec<f64> {
        let mut values: Vec<f64> = Vec::with_capacity(self.operations.len());
        for operation in &self.operations {
            let at = |r: u32| values[r as usize];
            let value = match operation {
                Operation::Read(Leaf::Pi) => std::f64::consts::PI,
                Operation::Read(leaf) => read(*leaf),
                Operation::Number(number) => number.to_f64(),
                Operation::Negate(a) => -at(*a),
                Operation::Add(a, b) => at(*a) + at(*b),
                Operation::Subtract(a, b) => at(*a) - at(*b),
                Operation::Multiply(a, b) => at(*a) * at(*b),
                Operation::Divide(a, b) => at(*a) / at(*b),
                Operation::Sine(a) => at(*a).sin(),
                Operation::Cosine(a) => at(*a).cos(),
                Operation::Root(a) => at(*a).sqrt(),
                Operation::Call(function, arguments) => {
                    double(*function, &arguments.iter().map(|a| at(*a)).collect::<Vec<_>>())
                }
            };
            values.push(value);
        }
        self.outputs.iter().map(|r| values[*r as usize]).collect()
    }
}

impl Programs {
    /// The results of a function at given values of the symbols, the prepared values computed on the way.
    /// `None` where the model has no such function.
    pub fn evaluate(&self, equations: &Equations, function: &str, values: &dyn Fn(Symbol) -> f64) -> Option<Vec<f64>> {
        let program = self.function(function)?;
        let parameters: Vec<f64> = equations.parameters.iter().map(|s| values(*s)).collect();
        let prepared = self.values.code.evaluate(&|leaf| match leaf {
            Leaf::Parameter(i) => parameters[i],
            _ => f64::NAN,
        });
        let speeds = match program.entry.arguments {
            Arguments::Chart(chart) | Arguments::ChartInputs(chart) => &equations.charts[chart - 1].speeds,
            _ => &equations.state_speeds,
        };
        Some(program.code.evaluate(&|leaf| match leaf {
            Leaf::Pi => std::f64::consts::PI,
            Leaf::Parameter(i) => parameters[i],
            Leaf::Value(i) if i < parameters.len() => parameters[i],
            Leaf::Value(i) => prepared[i - parameters.len()],
            Leaf::Time => values(equations.time),
            Leaf::StateCoordinate(i) => values(equations.state_coordinates[i]),
            Leaf::StateSpeed(i) => values(speeds[i]),
            Leaf::Coordinate(i) => values(equations.coordinates[i]),
            Leaf::Speed(i) => values(equations.speeds[i]),
            Leaf::Carrier(i) => values(equations.carriers[i]),
            Leaf::SpeedRate(i) => values(equations.velocity_rate_symbols[i]),
            Leaf::CarrierRate(i) => values(equations.outputs.carrier_rates[i]),
            Leaf::Multiplier(i) => {
                let symbol = equations.outputs.reactions.iter().find(|(_, at)| *at == i);
                symbol.map_or(f64::NAN, |(symbol, _)| values(*symbol))
            }
            Leaf::Input(i) => values(equations.inputs[i]),
        }))
    }
}
