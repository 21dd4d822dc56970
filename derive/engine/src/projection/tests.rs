//! The disk in the paper's formulations, built by hand, against the corrected equations.

use super::{AsIs, Equations, project};
use crate::model::{Configuration, InitialSystem, Kinematics, Places, Row, RowKind};
use crate::symbolic::{Expr, Graph, Kind, Matrix, Rational, Symbol};
use proc_macro2::Span;

struct Disk {
    system: InitialSystem,
}

/// The free disk of section 6 with (2.2) as given by (6.3), (6.9) and (6.10).
fn disk() -> Disk {
    let mut g = Graph::new();
    let p: Vec<Symbol> = ["m", "r", "j", "g"].iter().map(|n| g.symbol(n, Kind::Parameter)).collect();
    let time = g.symbol("t", Kind::Time);
    let xs: Vec<Symbol> =
        ["x", "y", "z", "phi", "theta", "psi"].iter().map(|n| g.symbol(n, Kind::Coordinate)).collect();
    let vs: Vec<Symbol> = (1..7).map(|i| g.symbol(&format!("v{i}"), Kind::Speed)).collect();
    let [m, r, j, gravity] = [g.var(p[0]), g.var(p[1]), g.var(p[2]), g.var(p[3])];
    let (phi, theta) = (g.var(xs[3]), g.var(xs[4]));
    let (sf, cf, s, c) = (g.sin(phi), g.cos(phi), g.sin(theta), g.cos(theta));
    let zero = g.zero();
    let one = g.one();
    g.assume_nonzero(c);
    let neg = |g: &mut Graph, e: Expr| g.neg(e);
    let ssf = g.mul(s, sf);
    let scf = g.mul(s, cf);
    let csf = g.mul(c, sf);
    let ccf = g.mul(c, cf);
    let (mssf, mccf) = (neg(&mut g, ssf), neg(&mut g, ccf));
    let ic = g.powi(c, -1);
    let tan = g.tan(theta);
    let rt = g.mul(r, tan);
    let (rtcf, rtsf) = (g.mul(rt, cf), g.mul(rt, sf));
    let (rcsf, rccf) = (g.mul(r, csf), g.mul(r, ccf));
    let rs = g.mul(r, s);
    let (mrcsf, mrs, mr, mone, mtan) =
        (neg(&mut g, rcsf), neg(&mut g, rs), neg(&mut g, r), neg(&mut g, one), neg(&mut g, tan));
    // (6.2), with the two entries that errata correct.
    let a = Matrix::from_rows(
        vec![
            vec![cf, mssf, csf, mrcsf, rtcf, zero],
            vec![sf, scf, mccf, rccf, rtsf, zero],
            vec![zero, c, s, mrs, zero, zero],
            vec![zero, zero, zero, zero, ic, zero],
            vec![zero, zero, zero, mone, zero, zero],
            vec![zero, zero, zero, zero, mtan, one],
        ],
        6,
    );
    let b = Matrix::from_rows(
        vec![
            vec![cf, sf, zero, mrs, zero, zero],
            vec![mssf, scf, c, zero, zero, zero],
            vec![csf, mccf, s, zero, mr, zero],
            vec![zero, zero, zero, zero, mone, zero],
            vec![zero, zero, zero, c, zero, zero],
            vec![zero, zero, zero, s, zero, one],
        ],
        6,
    );
    let v = g.vars(&vs);
    let two_j = g.scale(Rational::integer(2), j);
    let mut inertia = Matrix::zeros(&g, 6, 6);
    for (i, e) in [m, m, m, j, j, two_j].into_iter().enumerate() {
        inertia.set(i, i, e);
    }
    // (6.10)
    let v2t = g.mul(v[1], tan);
    let d = g.sub(v2t, v[2]);
    let h1 = g.product(&[m, v[4], d]);
    let (a1, a2, a3) = (g.mul(v[3], v[2]), g.product(&[v[4], v[0], tan]), g.mul(gravity, c));
    let a2 = g.add(a2, a3);
    let d = g.sub(a1, a2);
    let h2 = g.mul(m, d);
    let (a1, a2, a3) = (g.mul(v[4], v[0]), g.mul(v[3], v[1]), g.mul(gravity, s));
    let a2 = g.add(a2, a3);
    let d = g.sub(a1, a2);
    let h3 = g.mul(m, d);
    let v5t = g.mul(v[4], tan);
    let two_v6 = g.scale(Rational::integer(2), v[5]);
    let d = g.sub(v5t, two_v6);
    let h4 = g.product(&[j, v[4], d]);
    let d = g.neg(d);
    let h5 = g.product(&[j, v[3], d]);
    let zeros = vec![zero; 6];
    let here = Span::call_site();
    let system = InitialSystem {
        graph: g,
        time,
        parameters: p,
        inputs: vec![],
        coordinates: xs,
        speeds: vs,
        kinematics: Kinematics { a, a0: zeros.clone(), b, b0: zeros, pivots: vec![c] },
        joint_speeds: false,
        inertia,
        forces: vec![h1, h2, h3, h4, h5, zero],
        kinetic: None,
        mechanism: None,
        elimination: crate::syntax::Elimination::Matrix,
        swept: None,
        potential: None,
        rows: vec![],
        configuration: None,
        velocities: None,
        independent: vec![],
        chosen: None,
        complement: None,
        outputs: crate::model::Outputs::default(),
        places: Places { model: here, kinematics: here, inertia: here, complement: here, start: here },
        start: vec![],
        nominal: vec![],
    };
    Disk { system }
}

impl Disk {
    fn row(&mut self, name: &str, kind: RowKind) {
        self.system.rows.push(Row {
            name: name.into(),
            span: Span::call_site(),
            kind,
            redundant: false,
            released: vec![],
        });
    }

    /// (6.5)
    fn rolling(mut self) -> Self {
        let g = &mut self.system.graph;
        let v = g.vars(&self.system.speeds);
        let r = g.var(self.system.parameters[1]);
        let rv6 = g.mul(r, v[5]);
        let along = g.add(v[0], rv6);
        let rv4 = g.mul(r, v[3]);
        let contact = g.sub(v[2], rv4);
        self.row("along", RowKind::Velocity(along));
        self.row("across", RowKind::Velocity(v[1]));
        self.row("contact", RowKind::Velocity(contact));
        self
    }

    /// z = 0 as a configuration with its row (6.1c), and (6.1a), (6.1b).
    fn chain(mut self) -> Self {
        let g = &mut self.system.graph;
        let x = self.system.coordinates.clone();
        let q: Vec<Symbol> = x.iter().copied().filter(|s| g.name(*s) != "z").collect();
        let rates: Vec<Symbol> = q
            .iter()
            .map(|s| format!("dot_{}", g.name(*s)))
            .collect::<Vec<_>>()
            .iter()
            .map(|n| g.symbol(n, Kind::Speed))
            .collect();
        let map = x.iter().map(|s| if g.name(*s) == "z" { g.zero() } else { g.var(*s) }).collect();
        let z = g.var(x[2]);
        let (unit, none) = (Matrix::identity(g, 5), vec![g.zero(); 5]);
        let kinematics = Kinematics { a: unit.clone(), a0: none.clone(), b: unit, b0: none, pivots: vec![] };
        let (speeds, span) = (rates.clone(), Span::call_site());
        self.system.configuration = Some(Configuration { coordinates: q, rates, speeds, kinematics, map, span });
        let v = self.system.graph.vars(&self.system.speeds);
        let xdot = self.system.kinematics.a.mul_vec(&mut self.system.graph, &v);
        let g = &mut self.system.graph;
        let r = g.var(self.system.parameters[1]);
        let phi = g.var(x[3]);
        let (s, c) = (g.sin(phi), g.cos(phi));
        let (a, b) = (g.product(&[r, xdot[5], c]), g.product(&[r, xdot[5], s]));
        let (a, b) = (g.add(xdot[0], a), g.add(xdot[1], b));
        self.row("a", RowKind::Velocity(a));
        self.row("b", RowKind::Velocity(b));
        self.row("c", RowKind::Position(z));
        self
    }
}

fn value(eq: &Equations, e: &[Expr], values: &[(&str, f64)]) -> Vec<f64> {
    eq.graph.evaluate(e, &|s| values.iter().find(|(n, _)| *n == eq.graph.name(s)).map_or(0.0, |(_, v)| *v))
}

const STATE: [(&str, f64); 6] = [("m", 2.0), ("r", 0.5), ("j", 0.125), ("g", 9.81), ("phi", 0.7), ("theta", 0.3)];

/// The accelerations of the rolling disk in closed form (a model page's formulas, derived from the corrected (6.28)).
fn closed_form(w1: f64, w2: f64, w3: f64) -> [f64; 3] {
    let (m, r, j, g) = (2.0, 0.5, 0.125, 9.81);
    let (s, c) = 0.3f64.sin_cos();
    let (v5, v6) = (w1 * c, w3 + w1 * s);
    let phi = -2.0 * w2 * w3 / c;
    let v6d = -m * r * r * v5 * w2 / (m * r * r + 2.0 * j);
    let theta = (m * r * r * v5 * v6 + m * g * r * s + j * v5 * (w1 * s + 2.0 * w3)) / (m * r * r + j);
    [phi, theta, v6d - phi * s - v5 * w2]
}

#[test]
fn six_quasi_velocities() {
    let eq = project(disk().rolling().system, &mut AsIs).unwrap();
    let names: Vec<&str> = eq.state_speeds.iter().map(|s| eq.graph.name(*s)).collect();
    assert_eq!(names, ["v4", "v5", "v6"]);
    let [w1, w2, w3] = [1.1, -0.6, 3.4];
    let (s, c) = 0.3f64.sin_cos();
    let mut values = STATE.to_vec();
    values.extend([("v4", -w2), ("v5", w1 * c), ("v6", w3 + w1 * s)]);
    let u = value(&eq, &eq.accelerations, &values);
    let [phi, theta, psi] = closed_form(w1, w2, w3);
    let expected = [-theta, phi * c - w1 * w2 * s, psi + phi * s + w1 * w2 * c];
    for (a, b) in u.iter().zip(expected) {
        assert!((a - b).abs() < 1e-12, "{u:?} {expected:?}");
    }
    assert!(eq.guards.iter().any(|g| g.name == "cos(theta)"));
}

#[test]
fn two_stages_equal_one() {
    let eq = project(disk().chain().system, &mut AsIs).unwrap();
    let one = project(disk().rolling().system, &mut AsIs).unwrap();
    let names: Vec<&str> = eq.state_speeds.iter().map(|s| eq.graph.name(*s)).collect();
    assert_eq!(names, ["dot_phi", "dot_theta", "dot_psi"]);
    let [w1, w2, w3] = [1.1, -0.6, 3.4];
    let (s, c) = 0.3f64.sin_cos();
    let mut values = STATE.to_vec();
    values.extend([("dot_phi", w1), ("dot_theta", w2), ("dot_psi", w3)]);
    values.extend([("v4", -w2), ("v5", w1 * c), ("v6", w3 + w1 * s)]);
    let u = value(&eq, &eq.accelerations, &values);
    for (a, b) in u.iter().zip(closed_form(w1, w2, w3)) {
        assert!((a - b).abs() < 1e-12, "{u:?}");
    }
    // The contact force in the inertial frame, by both formulations: A_1 λ of (6.12).
    let quasi = value(&one, &one.multipliers, &values);
    let chain = value(&eq, &eq.multipliers, &values);
    let (sf, cf) = 0.7f64.sin_cos();
    let inertial = [
        cf * quasi[0] - s * sf * quasi[1] + c * sf * quasi[2],
        sf * quasi[0] + s * cf * quasi[1] - c * cf * quasi[2],
        c * quasi[1] + s * quasi[2],
    ];
    for (a, b) in chain.iter().zip(inertial) {
        assert!((a - b).abs() < 1e-10, "{chain:?} {inertial:?}");
    }
}

#[test]
fn a_height_is_merged_with_its_rolling_rows() {
    let mut disk = disk().rolling();
    let z = disk.system.graph.var(disk.system.coordinates[2]);
    disk.row("height", RowKind::Position(z));
    let eq = project(disk.system, &mut AsIs).unwrap();
    assert_eq!(eq.row_names(), ["along", "across", "contact"]);
    assert_eq!(eq.position_names, ["height"]);
}

#[test]
fn a_repeated_row_is_an_error_with_its_combination() {
    let mut disk = disk().rolling();
    let g = &mut disk.system.graph;
    let v = g.vars(&disk.system.speeds);
    let r = g.var(disk.system.parameters[1]);
    let rv6 = g.mul(r, v[5]);
    let sum = g.sum(&[v[0], rv6, v[1], v[1]]);
    disk.row("again", RowKind::Velocity(sum));
    let errors = project(disk.system, &mut AsIs).unwrap_err();
    let text = &errors.iter().next().unwrap().message;
    assert!(text.contains("`along` + 2*`across`"), "{text}");
}
