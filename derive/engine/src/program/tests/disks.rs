//! The rolling disk by hand, in two of its formulations.

use super::models::{Given, pendulum, reduce, solve, symbols};
use crate::projection::{Equations, Guard, GuardKind};
use crate::symbolic::{Graph, Kind, Matrix};

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
        .map(|e| Guard {
            expr: *e,
            name: g.display(*e),
            kind: GuardKind::Positive,
            origin: "pivot of M_d".to_owned(),
            rows: vec![],
            start: None,
        })
        .filter(|guard| g.stage(guard.expr) > crate::symbolic::Stage::Parameter)
        .collect();
    let vars = g.vars(&v);
    let identity = Matrix::identity(g, 3);
    let none = Matrix::zeros(g, 0, 3);
    Equations {
        parameters,
        state_coordinates: x.clone(),
        state_speeds: v.clone(),
        reduced_speeds: v.clone(),
        coordinate_rates: vars.clone(),
        initial_coordinates: g.vars(&x),
        velocities: vars.clone(),
        coordinates: x,
        speeds: v.clone(),
        velocity_rates: accelerations.clone(),
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
        norms: 0,
        velocity_residual: Vec::new(),
        kinetic_energy: zero,
        potential_energy: None,
        outputs: crate::projection::Outputs::default(),
        rows: Vec::new(),
        position_names: Vec::new(),
        multiplier_names: Vec::new(),
        multiplier_rows: Vec::new(),
        chart_speeds: vec![vars.clone()],
        carriers: v.clone(),
        carried_velocities: vars.clone(),
        carried_rates: vars.clone(),
        ..equations
    }
}
