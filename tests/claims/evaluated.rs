//! What the engine's equations claim at a state, by evaluating its expressions.

use holonomy_engine::projection::{AsIs, Equations, Guard, inverse_dynamics, project};
use holonomy_engine::simplify::Search;
use holonomy_engine::symbolic::{Algebra, Expr, Function, Given, Graph, Matrix, Rational, Symbol};
use holonomy_engine::syntax::Elimination;
use holonomy_engine::{model, syntax};
use nalgebra::{DMatrix, DVector};
use oracle::{ChartClaim, Claim, Dual, Multiplier, Number, System, derivative};
use quote::ToTokens;
use std::collections::BTreeMap;

/// The oracle's numbers as an algebra of the engine.
struct Over<'a, N>(BTreeMap<Symbol, N>, &'a Graph);

impl<N: Number> Algebra for Over<'_, N> {
    type Value = N;
    fn number(&mut self, value: &Rational) -> N {
        N::constant(value.to_f64())
    }
    fn symbol(&mut self, symbol: Symbol) -> N {
        self.0[&symbol]
    }
    fn add(&mut self, a: &N, b: &N) -> N {
        *a + *b
    }
    fn mul(&mut self, a: &N, b: &N) -> N {
        *a * *b
    }
    fn recip(&mut self, a: &N) -> N {
        N::one() / *a
    }
    fn function(&mut self, function: Function, arguments: &[N]) -> N {
        let first = arguments[0];
        match function {
            Function::Sin => first.sin_cos().0,
            Function::Cos => first.sin_cos().1,
            Function::Whole => first,
            Function::Sqrt => first.sqrt(),
            Function::Atan2 => first.atan2(arguments[1]),
            Function::Exp => first.exp(),
            Function::Ln => first.ln(),
            Function::Asin => first.asin(),
            Function::Acos => first.acos(),
            Function::Atan => first.atan2(N::one()),
            Function::Sinh => first.sinh_cosh().0,
            Function::Cosh => first.sinh_cosh().1,
            Function::Tanh => first.sinh_cosh().0 / first.sinh_cosh().1,
            Function::Abs => first.abs(),
            Function::Sign if first.value() == 0.0 => N::zero(),
            Function::Sign => N::constant(first.value().signum()),
            Function::Power => (arguments[1] * first.ln()).exp(),
            Function::Given(at) => {
                let given = &self.1.given()[at as usize];
                let of_same = |other: &&Given| other.function == given.function && other.order == 0;
                let name = &self.1.given().iter().find(of_same).expect("the function itself").name;
                assert!(!given.missing, "a derivative that nobody gave");
                derivative(name, given.order, first)
            }
            Function::Select => arguments[if first.value() < 0.0 { 1 } else { 2 }],
        }
    }
}

/// The equations of a model's source text, as they are before any simplification.
///
/// # Errors
/// What the engine says about a model that it refuses.
pub fn projected(source: &str) -> Result<Equations, String> {
    let declarations = syntax::parse(tokens(source)).map_err(said)?;
    let system = model::build(&declarations).map_err(said)?;
    let mut equations = project(system, &mut AsIs).map_err(said)?;
    inverse_dynamics(&mut equations);
    Ok(equations)
}

/// The same eliminated joint by joint, where the model is a tree with rows that bind it linearly.
///
/// # Errors
/// What the engine says about a model that it refuses.
pub fn joint_by_joint(source: &str) -> Result<Equations, String> {
    let declarations = syntax::parse(tokens(source)).map_err(said)?;
    let mut system = model::build(&declarations).map_err(said)?;
    system.elimination = Elimination::Recursive;
    let mut equations = project(system, &mut AsIs).map_err(said)?;
    inverse_dynamics(&mut equations);
    Ok(equations)
}

/// The equations as they are emitted: in the cheapest forms found.
///
/// # Errors
/// What the engine says about a model that it refuses.
pub fn simplified(source: &str) -> Result<Equations, String> {
    holonomy_engine::analyse(tokens(source)).map(|analysis| analysis.equations).map_err(said)
}

/// The same without a search for cheaper forms.
///
/// # Errors
/// What the engine says about a model that it refuses.
pub fn plain(source: &str) -> Result<Equations, String> {
    holonomy_engine::analyse_by(tokens(source), Search::Off).map(|analysis| analysis.equations).map_err(said)
}

/// What the derive gets of a struct: everything but the `derive` itself.
fn tokens(source: &str) -> proc_macro2::TokenStream {
    let mut item: syn::ItemStruct = syn::parse_str(source).expect("a struct");
    item.attrs.retain(|a| !a.path().is_ident("derive"));
    item.into_token_stream()
}

fn said(diagnostics: syntax::Diagnostics) -> String {
    diagnostics.iter().map(|d| d.message.as_str()).collect::<Vec<_>>().join("; ")
}

/// The engine's equations with numbers for parameters and inputs.
pub struct Evaluated<'a> {
    /// The equations.
    pub equations: &'a Equations,
    /// The declared model with its parameters and inputs.
    pub system: &'a System<'a>,
}

impl Evaluated<'_> {
    fn values<N: Number>(&self, t: N, groups: [(&[Symbol], &[N]); 2]) -> Over<'_, N> {
        let equations = self.equations;
        let constants = |symbols: &[Symbol], values: &[f64]| -> Vec<(Symbol, N)> {
            symbols.iter().copied().zip(values.iter().map(|&value| N::constant(value))).collect()
        };
        let mut map =
            BTreeMap::from([(equations.graph.pi_symbol(), N::constant(std::f64::consts::PI)), (equations.time, t)]);
        // fields that no equation uses are no parameters
        let system = self.system;
        let named =
            |symbol: &Symbol| system.model.parameters.iter().position(|(p, _)| p == equations.graph.name(*symbol));
        let used = equations.parameters.iter().map(|p| system.parameters[named(p).expect("a field")]);
        map.extend(constants(&equations.parameters, &used.collect::<Vec<_>>()));
        map.extend(constants(&equations.inputs, &system.inputs));
        for (symbols, values) in groups {
            map.extend(symbols.iter().copied().zip(values.iter().copied()));
        }
        Over(map, &equations.graph)
    }

    /// Functions of the state.
    fn of_state<N: Number>(&self, expressions: &[Expr], t: N, q: &[N], u: &[N]) -> Vec<N> {
        let e = self.equations;
        let mut algebra = self.values(t, [(&e.state_coordinates, q), (&e.state_speeds, u)]);
        e.graph.evaluate_in(expressions, &mut algebra)
    }

    /// v of the state (q, u).
    pub fn velocities(&self, t: f64, q: &[f64], u: &[f64]) -> Vec<f64> {
        self.of_state(&self.equations.velocities, t, q, u)
    }

    /// The state (q, u) in the speeds of a chart.
    fn in_chart(&self, chart: usize, t: f64, q: &[f64], u: &[f64], v: &[f64]) -> ChartClaim {
        let e = self.equations;
        // v replaces what a speed of the same symbol is in the state
        let mut algebra = self.values(t, [(&e.state_coordinates, q), (&e.state_speeds, u)]);
        algebra.0.extend(e.speeds.iter().copied().zip(v.iter().copied()));
        let speeds = e.graph.evaluate_in(&e.chart_speeds[chart], &mut algebra);
        let guards = |guards: &[Guard]| guards.iter().map(|guard| guard.expr).collect::<Vec<_>>();
        let (symbols, rates, accelerations, velocities, guards) = match chart.checked_sub(1).map(|at| &e.charts[at]) {
            Some(c) => (&c.speeds, &c.coordinate_rates, &c.accelerations, &c.velocities, guards(&c.guards)),
            None => (&e.state_speeds, &e.coordinate_rates, &e.accelerations, &e.velocities, guards(&e.guards)),
        };
        let value = |expressions: &[Expr]| {
            let mut algebra = self.values(t, [(&e.state_coordinates, q), (symbols, &speeds)]);
            e.graph.evaluate_in(expressions, &mut algebra)
        };
        ChartClaim {
            velocities: value(velocities),
            coordinate_rates: value(rates),
            accelerations: value(accelerations),
            guards: value(&guards),
            speeds,
        }
    }

    /// Everything that the equations say about the state (q, u).
    pub fn claim(&self, t: f64, q: &[f64], u: &[f64]) -> Claim {
        let e = self.equations;
        let state = |expressions: &[Expr]| self.of_state(expressions, t, q, u);
        let coordinates = state(&e.initial_coordinates);
        let velocities = state(&e.velocities);
        let initial = |expressions: &[Expr]| {
            let mut algebra = self.values(t, [(&e.coordinates, &coordinates), (&e.speeds, &velocities)]);
            e.graph.evaluate_in(expressions, &mut algebra)
        };
        // M v of given v
        let momenta = |v: &[f64]| {
            let mut algebra = self.values(t, [(&e.coordinates, &coordinates), (&e.speeds, v)]);
            e.graph.evaluate_in(&e.momenta, &mut algebra)
        };
        let inertia = || {
            let columns = (0..e.speeds.len()).map(|j| {
                let unit: Vec<f64> = (0..e.speeds.len()).map(|i| if i == j { 1.0 } else { 0.0 }).collect();
                momenta(&unit)
            });
            DMatrix::from_columns(&columns.map(Into::into).collect::<Vec<DVector<f64>>>())
        };
        // M v̇ - h* of given v̇
        let needed = |rates: &[f64]| {
            let mut algebra = self.values(t, [(&e.coordinates, &coordinates), (&e.speeds, &velocities)]);
            algebra.0.extend(e.velocity_rate_symbols.iter().copied().zip(rates.iter().copied()));
            e.graph.evaluate_in(&e.inverse_dynamics, &mut algebra)
        };
        let of_bodies = !e.momenta.is_empty();
        let matrix =
            |matrix: &Matrix, values: Vec<f64>| DMatrix::from_row_slice(matrix.rows(), matrix.columns(), &values);
        let named = |symbols: &[Symbol]| symbols.iter().map(|&s| e.graph.name(s).to_string()).collect();
        let (rates, accelerations) = (state(&e.coordinate_rates), state(&e.accelerations));
        let moving = |values: &[f64], rates: &[f64]| -> Vec<Dual<f64>> {
            values.iter().zip(rates).map(|(&value, &rate)| Dual::moving(value, rate)).collect()
        };
        let along = self.of_state(&e.velocities, Dual::moving(t, 1.0), &moving(q, &rates), &moving(u, &accelerations));
        let multipliers = state(&e.multipliers).into_iter().zip(&e.multiplier_names).zip(&e.multiplier_rows);
        let outputs = e.outputs.names.iter().cloned().zip(state(&e.outputs.values)).collect();
        // q̈ along the motion
        let second =
            self.of_state(&e.coordinate_rates, Dual::moving(t, 1.0), &moving(q, &rates), &moving(u, &accelerations));
        let multipliers: Vec<Multiplier> =
            multipliers.map(|((value, name), &row)| Multiplier { name: name.clone(), value, row }).collect();
        let given_rates = state(&e.velocity_rates);
        let known = |symbol: &Symbol| -> Option<(f64, f64)> {
            let place = |symbols: &[Symbol]| symbols.iter().position(|other| other == symbol);
            let of_coordinate = |x: &Symbol| format!("dot_{}", e.graph.name(*x)) == e.graph.name(*symbol);
            place(&e.speeds)
                .map(|i| (velocities[i], given_rates[i]))
                .or(e.state_coordinates.iter().position(of_coordinate).map(|i| (rates[i], second[i].rate)))
                .or(place(&e.state_speeds).map(|i| (u[i], accelerations[i])))
        };
        let carriers: Option<Vec<(f64, f64)>> = e.carriers.iter().map(known).collect();
        let carried_outputs = carriers.map(|carriers| {
            let (w, dw): (Vec<f64>, Vec<f64>) = carriers.into_iter().unzip();
            let mut algebra = self.values(t, [(&e.state_speeds, u), (&e.state_coordinates, q)]);
            algebra.0.extend(e.carriers.iter().copied().zip(w));
            algebra.0.extend(e.outputs.carrier_rates.iter().copied().zip(dw));
            algebra.0.extend(e.outputs.reactions.iter().map(|(symbol, at)| (*symbol, multipliers[*at].value)));
            e.graph.evaluate_in(&e.outputs.carried, &mut algebra)
        });
        let complement = matrix(&e.complement, state(e.complement.entries()));
        let complement_bias = state(&e.complement_bias);
        Claim {
            t,
            state_coordinates: q.to_vec(),
            speed_names: named(&e.state_speeds),
            speeds: u.to_vec(),
            coordinate_rates: rates,
            accelerations,
            velocity_rates: along.iter().map(|v| v.rate).collect(),
            given_rates: given_rates.clone(),
            mass_matrix: match e.is_recursive() {
                true => &complement * inertia() * complement.transpose(),
                false => matrix(&e.mass_matrix, state(e.mass_matrix.entries())),
            },
            forcing: match e.is_recursive() {
                true => (-&complement * DVector::from(needed(&complement_bias))).as_slice().to_vec(),
                false => state(&e.forcing),
            },
            complement,
            complement_bias,
            guards: state(&e.guards.iter().map(|guard| guard.expr).collect::<Vec<_>>()),
            multipliers,
            row_names: e.row_names(),
            constraint_matrix: matrix(&e.constraint_matrix, initial(e.constraint_matrix.entries())),
            constraint_bias: initial(&e.constraint_bias),
            velocity_residual: e.velocity_row_names().into_iter().zip(initial(&e.velocity_residual)).collect(),
            position_residual: e.position_names.iter().cloned().zip(initial(&e.position_residual)).collect(),
            kinematic_matrix: matrix(&e.kinematic_matrix, initial(e.kinematic_matrix.entries())),
            kinematic_bias: initial(&e.kinematic_bias),
            inertia: match e.is_recursive() {
                true => inertia(),
                false => matrix(&e.inertia, initial(e.inertia.entries())),
            },
            momenta: of_bodies.then(|| momenta(&velocities)),
            inverse_dynamics: of_bodies.then(|| needed(&given_rates)),
            forces: initial(&e.forces),
            kinetic_energy: initial(&[e.kinetic_energy])[0],
            potential_energy: e.potential_energy.map(|potential| initial(&[potential])[0]),
            charts: (0..e.chart_speeds.len()).map(|chart| self.in_chart(chart, t, q, u, &velocities)).collect(),
            outputs,
            carried_outputs,
            coordinates,
            velocities,
        }
    }
}
