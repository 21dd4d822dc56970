//! Models by hand: the initial system, D, and everything else by the formulas of the paper.

use crate::projection::{Equations, Guard, GuardKind, Level, RowFacts};
use crate::symbolic::{Expr, Graph, Kind, Matrix, Rational, Symbol};

/// What a model gives; the state holds x and the speeds `independent` of v.
pub struct Given {
    pub graph: Graph,
    pub time: Symbol,
    pub parameters: Vec<Symbol>,
    pub x: Vec<Symbol>,
    pub v: Vec<Symbol>,
    pub independent: Vec<usize>,
    pub kinematics: Matrix,
    pub inertia: Matrix,
    pub forces: Vec<Expr>,
    pub constraints: Matrix,
    pub residual: Vec<Expr>,
    pub complement: Matrix,
    pub guards: Vec<(Expr, GuardKind)>,
    pub names: Vec<String>,
}

pub fn symbols(graph: &mut Graph, names: &[&str], kind: Kind) -> (Vec<Symbol>, Vec<Expr>) {
    let symbols: Vec<Symbol> = names.iter().map(|n| graph.symbol(n, kind)).collect();
    let vars = graph.vars(&symbols);
    (symbols, vars)
}

/// M_d by D M Dᵀ, u̇ by elimination without pivoting, λ by (3.6).
pub fn reduce(given: Given) -> Equations {
    let Given { mut graph, x, v, complement: d, inertia, forces, constraints: c, .. } = given;
    let g = &mut graph;
    let u: Vec<Symbol> = given.independent.iter().map(|i| v[*i]).collect();
    let of_u = g.vars(&u);
    let velocities = d.transpose().mul_vec(g, &of_u);
    let replaced: Vec<(Symbol, Expr)> = v.iter().copied().zip(velocities.iter().copied()).collect();
    let all_v = g.vars(&v);
    let rates_v = given.kinematics.mul_vec(g, &all_v);
    let rates = g.substitute(&rates_v, &replaced);
    let tangent: Vec<(Symbol, Expr)> = x.iter().copied().zip(rates.iter().copied()).collect();
    // a_u = d/dt(Dᵀ) u.
    let d_dot = Matrix::from_rows(d.entries().chunks(v.len()).map(|row| g.along(row, &tangent)).collect(), v.len());
    let bias = d_dot.transpose().mul_vec(g, &of_u);
    let forces_u = g.substitute(&forces, &replaced);
    let m_bias = inertia.mul_vec(g, &bias);
    let net: Vec<Expr> = forces_u.iter().zip(&m_bias).map(|(h, b)| g.sub(*h, *b)).collect();
    let forcing = d.mul_vec(g, &net);
    let m_d = d.mul(g, &inertia).mul(g, &d.transpose());
    let (accelerations, pivots) = solve(g, &m_d, &forcing);
    // M v̇ = h* + Cᵀ λ: (C Cᵀ) λ = C (M v̇ - h*).
    let v_dot = d.transpose().mul_vec(g, &accelerations);
    let v_dot: Vec<Expr> = v_dot.iter().zip(&bias).map(|(a, b)| g.add(*a, *b)).collect();
    let m_v_dot = inertia.mul_vec(g, &v_dot);
    let reaction: Vec<Expr> = m_v_dot.iter().zip(&forces_u).map(|(a, b)| g.sub(*a, *b)).collect();
    let right = c.mul_vec(g, &reaction);
    let cc = c.mul(g, &c.transpose());
    let (multipliers, _) = solve(g, &cc, &right);
    let tangent_v: Vec<(Symbol, Expr)> = x.iter().copied().zip(rates_v.iter().copied()).collect();
    let c_dot = Matrix::from_rows(c.entries().chunks(v.len()).map(|row| g.along(row, &tangent_v)).collect(), v.len());
    let constraint_bias = c_dot.mul_vec(g, &all_v);
    let velocity_residual = c.mul_vec(g, &all_v);
    let m_v = inertia.mul_vec(g, &all_v);
    let products: Vec<Expr> = m_v.iter().zip(&all_v).map(|(a, b)| g.mul(*a, *b)).collect();
    let twice = g.sum(&products);
    let two = g.integer(2);
    let kinetic_energy = g.div(twice, two);
    let mut guards = Vec::new();
    let pivots = pivots.into_iter().map(|p| (p, GuardKind::Positive));
    let (mut state_guards, mut parameter_guards) = (Vec::new(), Vec::new());
    for (expr, kind) in given.guards.into_iter().chain(pivots) {
        guards.push(Guard {
            expr,
            name: g.display(expr),
            kind,
            origin: "by hand".to_owned(),
            rows: vec![],
            start: None,
        });
    }
    for guard in guards {
        match g.stage(guard.expr) {
            crate::symbolic::Stage::Parameter => parameter_guards.push(guard),
            _ => state_guards.push(guard),
        }
    }
    let zero = g.zero();
    let chart_speeds = vec![of_u.clone()];
    let multiplier_rows = (0..given.names.len()).map(Some).collect();
    Equations {
        time: given.time,
        parameters: given.parameters,
        inputs: Vec::new(),
        state_coordinates: x.clone(),
        reduced_speeds: u.clone(),
        state_speeds: u,
        initial_coordinates: graph.vars(&x),
        kinematic_bias: vec![zero; x.len()],
        coordinates: x,
        speeds: v.clone(),
        coordinate_rates: rates,
        accelerations,
        mass_matrix: m_d,
        forcing,
        velocities,
        complement: d,
        complement_bias: bias,
        velocity_rates: v_dot,
        multipliers,
        guards: state_guards,
        parameter_guards,
        kinematic_matrix: given.kinematics,
        inertia,
        forces,
        constraint_matrix: c,
        constraint_bias,
        position_residual: given.residual,
        norms: 0,
        velocity_residual,
        momenta: Vec::new(),
        inverse_dynamics: Vec::new(),
        velocity_rate_symbols: Vec::new(),
        mechanism: None,
        kinetic_energy,
        potential_energy: None,
        outputs: crate::projection::Outputs::default(),
        rows: given.names.iter().map(|name| row(name)).collect(),
        position_names: given.names.iter().take(0).cloned().collect(),
        multiplier_names: given.names,
        multiplier_rows,
        charts: Vec::new(),
        chart_speeds,
        relative_pivots: vec![None],
        combined: false,
        carriers: v.clone(),
        carried_velocities: all_v.clone(),
        carried_rates: rates_v.clone(),
        notes: vec!["written by hand".to_owned()],
        graph,
    }
}

fn row(name: &str) -> RowFacts {
    RowFacts { name: name.to_owned(), level: Level::Velocity, linear: true, redundant: false }
}

/// The solution of a symmetric system, and the pivots.
pub fn solve(g: &mut Graph, matrix: &Matrix, right: &[Expr]) -> (Vec<Expr>, Vec<Expr>) {
    let n = right.len();
    let (mut a, mut b) = (matrix.clone(), right.to_vec());
    let mut pivots = Vec::new();
    for k in 0..n {
        let pivot = a.get(k, k);
        if g.as_number(pivot).is_none() {
            pivots.push(pivot);
        }
        for i in k + 1..n {
            let ratio = g.div(a.get(i, k), pivot);
            for j in k..n {
                let step = g.mul(ratio, a.get(k, j));
                let reduced = g.sub(a.get(i, j), step);
                a.set(i, j, reduced);
            }
            let step = g.mul(ratio, b[k]);
            b[i] = g.sub(b[i], step);
        }
    }
    for k in (0..n).rev() {
        for j in k + 1..n {
            let step = g.mul(a.get(k, j), b[j]);
            b[k] = g.sub(b[k], step);
        }
        b[k] = g.div(b[k], a.get(k, k));
    }
    (b, pivots)
}

/// A point mass on a rod of length l, in x, y with y upwards: y is a pivot.
pub fn pendulum() -> Equations {
    let mut graph = Graph::new();
    let g = &mut graph;
    let time = g.symbol("t", Kind::Time);
    let (parameters, p) = symbols(g, &["m", "l", "g"], Kind::Parameter);
    let (x, q) = symbols(g, &["x", "y"], Kind::Coordinate);
    let (v, _) = symbols(g, &["dot_x", "dot_y"], Kind::Speed);
    let (zero, one) = (g.zero(), g.one());
    let weight = g.mul(p[0], p[2]);
    let weight = g.neg(weight);
    let slope = g.div(q[0], q[1]);
    let slope = g.neg(slope);
    let squares: Vec<Expr> = [q[0], q[1], p[1]].iter().map(|e| g.powi(*e, 2)).collect();
    let sum = g.add(squares[0], squares[1]);
    let gap = g.sub(sum, squares[2]);
    let two = g.integer(2);
    let residual = g.div(gap, two);
    let inertia = Matrix::from_fn(2, 2, |i, j| if i == j { p[0] } else { zero });
    let kinematics = Matrix::identity(g, 2);
    let given = Given {
        time,
        parameters,
        x,
        v,
        independent: vec![0],
        kinematics,
        inertia,
        forces: vec![zero, weight],
        constraints: Matrix::from_rows(vec![q.clone()], 2),
        residual: vec![residual],
        complement: Matrix::from_rows(vec![vec![one, slope]], 2),
        guards: vec![(q[1], GuardKind::Pivot)],
        names: vec!["rod".to_owned()],
        graph,
    };
    let mut equations = reduce(given);
    equations.position_names = vec!["rod".to_owned()];
    let height = equations.graph.var(equations.coordinates[1]);
    let weight = equations.graph.mul(p[0], p[2]);
    equations.potential_energy = Some(equations.graph.mul(weight, height));
    equations
}

/// The pendulum with other multipliers: the given expressions of m, l, g, x, y and dot_x.
pub fn outputs(make: impl FnOnce(&mut Graph, &[Expr]) -> Vec<Expr>) -> Equations {
    let mut equations = pendulum();
    let symbols =
        [equations.parameters.clone(), equations.coordinates.clone(), equations.state_speeds.clone()].concat();
    let vars = equations.graph.vars(&symbols);
    equations.multipliers = make(&mut equations.graph, &vars);
    equations.multiplier_names = (1..=equations.multipliers.len()).map(|i| format!("row_{i}")).collect();
    equations.multiplier_rows = vec![None; equations.multipliers.len()];
    equations
}

/// A chain of `steps` products and sums that nothing simplifies: about six operations a step.
pub fn chain(steps: usize) -> Equations {
    outputs(|g, vars| {
        let (x, y, u) = (vars[3], vars[4], vars[5]);
        let (mut last, mut before) = (g.sin(x), g.cos(x));
        for k in 0..steps {
            // Stays of the order of one: y plus a fraction of what came before.
            let c = Rational::fraction(1, k as i64 % 97 + 3).expect("a denominator");
            let a = g.mul(last, x);
            let b = g.mul(before, u);
            let difference = g.sub(a, b);
            let part = g.product(&[difference, u]);
            let part = g.scale(c, part);
            let next = g.add(part, y);
            (before, last) = (last, next);
        }
        vec![last, before]
    })
}
