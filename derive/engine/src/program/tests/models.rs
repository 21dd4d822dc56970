//! Models by hand: the initial system, D, and everything else by the formulas of the paper.

use crate::projection::{Equations, Guard, GuardKind};
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
        guards.push(Guard { expr, name: g.display(expr), kind, origin: "by hand".to_owned() });
    }
    for guard in guards {
        match g.stage(guard.expr) {
            crate::symbolic::Stage::Parameter => parameter_guards.push(guard),
            _ => state_guards.push(guard),
        }
    }
    let zero = g.zero();
    let multiplier_rows = (0..given.names.len()).map(Some).collect();
    Equations {
        time: given.time,
        parameters: given.parameters,
        inputs: Vec::new(),
        state_coordinates: x.clone(),
        state_speeds: u,
        initial_coordinates: graph.vars(&x),
        kinematic_bias: vec![zero; x.len()],
        coordinates: x,
        speeds: v,
        coordinate_rates: rates,
        accelerations,
        mass_matrix: m_d,
        forcing,
        velocities,
        complement: d,
        complement_bias: bias,
        multipliers,
        guards: state_guards,
        parameter_guards,
        kinematic_matrix: given.kinematics,
        inertia,
        forces,
        constraint_matrix: c,
        constraint_bias,
        position_residual: given.residual,
        velocity_residual,
        kinetic_energy,
        potential_energy: None,
        row_names: given.names.clone(),
        position_names: given.names.iter().take(0).cloned().collect(),
        multiplier_names: given.names,
        multiplier_rows,
        notes: vec!["written by hand".to_owned()],
        graph,
    }
}

/// The solution of a symmetric system, and the pivots.
fn solve(g: &mut Graph, matrix: &Matrix, right: &[Expr]) -> (Vec<Expr>, Vec<Expr>) {
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

/// The rolling disk in six quasi-velocities (6.2)-(6.13), corrected; u = v6, v5, v4.
pub fn disk() -> Equations {
    let mut graph = Graph::new();
    let g = &mut graph;
    let time = g.symbol("t", Kind::Time);
    let (parameters, p) = symbols(g, &["m", "r", "j", "g"], Kind::Parameter);
    let (m, r, j, gravity) = (p[0], p[1], p[2], p[3]);
    let (x, q) = symbols(g, &["x", "y", "z", "phi", "theta", "psi"], Kind::Coordinate);
    let (v, w) = symbols(g, &["v1", "v2", "v3", "v4", "v5", "v6"], Kind::Speed);
    let (s, c, tan) = (g.sin(q[4]), g.cos(q[4]), g.tan(q[4]));
    g.assume_nonzero(c);
    let (sin_phi, cos_phi) = (g.sin(q[3]), g.cos(q[3]));
    let (zero, one) = (g.zero(), g.one());
    // The axes ξ (horizontal), η (from P to G) and ζ = ξ × η in the inertial frame.
    let ss = g.mul(s, sin_phi);
    let sc = g.mul(s, cos_phi);
    let cs = g.mul(c, sin_phi);
    let cc = g.mul(c, cos_phi);
    let (minus_ss, minus_cc) = (g.neg(ss), g.neg(cc));
    let xi = [cos_phi, sin_phi, zero];
    let eta = [minus_ss, sc, c];
    let zeta = [cs, minus_cc, s];
    // φ̇ = v5 / c, θ̇ = -v4, ψ̇ = v6 - v5 tan; Ṗ = Ġ - r η̇.
    let over_c = g.powi(c, -1);
    let (minus_one, minus_tan) = (g.neg(one), g.neg(tan));
    let angular = [[zero, over_c, zero], [minus_one, zero, zero], [zero, minus_tan, one]];
    let mut rows = Vec::new();
    for axis in 0..3 {
        let by_phi = g.derivative(eta[axis], x[3]);
        let by_theta = g.derivative(eta[axis], x[4]);
        let mut row = vec![xi[axis], eta[axis], zeta[axis]];
        for (phi, theta) in angular[0].into_iter().zip(angular[1]) {
            let a = g.mul(by_phi, phi);
            let b = g.mul(by_theta, theta);
            let sum = g.add(a, b);
            let arm = g.mul(r, sum);
            row.push(g.neg(arm));
        }
        rows.push(row);
    }
    for row in angular {
        rows.push([[zero; 3], row].concat());
    }
    let kinematics = Matrix::from_rows(rows, 6);
    // h* (6.10): Euler's equations in the frame that does not spin.
    let two = g.integer(2);
    let turn = g.mul(w[4], tan);
    let a = g.mul(w[1], tan);
    let a = g.sub(a, w[2]);
    let h1 = g.product(&[m, w[4], a]);
    let b = g.mul(w[3], w[2]);
    let b2 = g.mul(turn, w[0]);
    let b3 = g.mul(gravity, c);
    let b = g.sub(b, b2);
    let b = g.sub(b, b3);
    let h2 = g.mul(m, b);
    let d = g.mul(w[4], w[0]);
    let d2 = g.mul(w[3], w[1]);
    let d3 = g.mul(gravity, s);
    let d = g.sub(d, d2);
    let d = g.sub(d, d3);
    let h3 = g.mul(m, d);
    let two_v6 = g.mul(two, w[5]);
    let e = g.sub(turn, two_v6);
    let h4 = g.product(&[j, w[4], e]);
    let minus_e = g.neg(e);
    let h5 = g.product(&[j, w[3], minus_e]);
    let two_j = g.mul(two, j);
    let diagonal = [m, m, m, j, j, two_j];
    let inertia = Matrix::from_fn(6, 6, |a, b| if a == b { diagonal[a] } else { zero });
    let minus_r = g.neg(r);
    let constraints = Matrix::from_rows(
        vec![
            vec![one, zero, zero, zero, zero, r],
            vec![zero, one, zero, zero, zero, zero],
            vec![zero, zero, one, minus_r, zero, zero],
        ],
        6,
    );
    let complement = Matrix::from_rows(
        vec![
            vec![minus_r, zero, zero, zero, zero, one],
            vec![zero, zero, zero, zero, one, zero],
            vec![zero, zero, r, one, zero, zero],
        ],
        6,
    );
    let names = ["no_slip_along", "no_slip_across", "contact"].map(str::to_owned).to_vec();
    let above = g.mul(r, c);
    let height = g.add(q[2], above);
    let potential = g.product(&[m, gravity, height]);
    let mut equations = reduce(Given {
        time,
        parameters,
        x,
        v,
        independent: vec![5, 4, 3],
        kinematics,
        inertia,
        forces: vec![h1, h2, h3, h4, h5, zero],
        constraints,
        residual: Vec::new(),
        complement,
        guards: vec![(c, GuardKind::Pivot)],
        names,
        graph,
    });
    equations.potential_energy = Some(potential);
    equations
}

/// The disk's second stage: M_ω (6.27) and h_ω* (6.28) as corrected, in q = phi, theta, psi and ω.
pub fn disk_stage() -> Equations {
    let mut equations = pendulum();
    let g = &mut equations.graph;
    let (parameters, p) = symbols(g, &["m", "r", "j", "g"], Kind::Parameter);
    let (x, q) = symbols(g, &["phi", "theta", "psi"], Kind::Coordinate);
    let (v, w) = symbols(g, &["omega1", "omega2", "omega3"], Kind::Speed);
    let (s, c) = (g.sin(q[1]), g.cos(q[1]));
    let r2 = g.powi(p[1], 2);
    let mr2 = g.mul(p[0], r2);
    let a = g.add(mr2, p[2]);
    let b = g.add(a, p[2]);
    let (zero, two) = (g.zero(), g.integer(2));
    let s2 = g.powi(s, 2);
    let m11 = g.mul(a, s2);
    let m11 = g.add(m11, p[2]);
    let m13 = g.mul(b, s);
    let m = Matrix::from_rows(vec![vec![m11, zero, m13], vec![zero, a, zero], vec![m13, zero, b]], 3);
    let mgr = g.product(&[p[0], p[3], p[1]]);
    let t1 = g.product(&[two, a, w[0], w[1], s, c]);
    let t2 = g.product(&[two, p[2], w[1], w[2], c]);
    let h1 = g.add(t1, t2);
    let h1 = g.neg(h1);
    let t1 = g.product(&[a, w[0], w[0], s, c]);
    let t2 = g.product(&[b, w[0], w[2], c]);
    let t3 = g.mul(mgr, s);
    let h2 = g.sum(&[t1, t2, t3]);
    let t1 = g.product(&[two, a, w[0], w[1], c]);
    let h3 = g.neg(t1);
    let h = vec![h1, h2, h3];
    let (accelerations, pivots) = solve(g, &m, &h);
    equations.guards = pivots
        .iter()
        .map(|e| Guard { expr: *e, name: g.display(*e), kind: GuardKind::Positive, origin: "pivot of M_d".to_owned() })
        .filter(|guard| g.stage(guard.expr) > crate::symbolic::Stage::Parameter)
        .collect();
    let vars = g.vars(&v);
    let identity = Matrix::identity(g, 3);
    let none = Matrix::zeros(g, 0, 3);
    Equations {
        parameters,
        state_coordinates: x.clone(),
        state_speeds: v.clone(),
        coordinate_rates: vars.clone(),
        initial_coordinates: g.vars(&x),
        velocities: vars,
        coordinates: x,
        speeds: v,
        accelerations,
        mass_matrix: m.clone(),
        forcing: h.clone(),
        complement: identity.clone(),
        complement_bias: vec![zero; 3],
        multipliers: Vec::new(),
        parameter_guards: Vec::new(),
        kinematic_matrix: identity,
        kinematic_bias: vec![zero; 3],
        inertia: m,
        forces: h,
        constraint_matrix: none,
        constraint_bias: Vec::new(),
        position_residual: Vec::new(),
        velocity_residual: Vec::new(),
        kinetic_energy: zero,
        potential_energy: None,
        row_names: Vec::new(),
        position_names: Vec::new(),
        multiplier_names: Vec::new(),
        multiplier_rows: Vec::new(),
        ..equations
    }
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
