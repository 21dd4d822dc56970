//! The oracle by itself: against the golden data of the rolling disk, and its parts against each other. No engine.

mod support;

use nalgebra::DVector;
use oracle::{
    Chosen, Declaration, Dual, Level, Number, Rows, Scaled, System, closed, derivative, onto_velocity_rows, read_models,
};
use quote::ToTokens;
use serde_json::Value;
use support::golden::{assert_close, assert_close_at, list, numbers, parse, picked};
use support::splitmix::SplitMix;

const GOLDEN: &str = include_str!("data/rolling_disk.json");
const SOURCES: [&str; 7] = [
    include_str!("models/blades.rs"),
    include_str!("models/bodies.rs"),
    include_str!("models/kinds.rs"),
    include_str!("models/linkages.rs"),
    include_str!("models/particles.rs"),
    include_str!("models/rolling_disc.rs"),
    include_str!("models/rolling_disk.rs"),
];
const TOLERANCE: f64 = 1e-12;

fn models() -> Vec<Declaration> {
    SOURCES.iter().flat_map(|source| read_models(source)).collect()
}

fn model<'a>(models: &'a [Declaration], name: &str) -> &'a Declaration {
    models.iter().find(|m| m.name == name).expect("the model is declared")
}

fn disk<'a>(models: &'a [Declaration], name: &str, params: &Value) -> System<'a> {
    System { model: model(models, name), parameters: picked(params, &["m", "r", "J", "g"]), inputs: Vec::new() }
}

/// Accelerations are compared at the scale of g and forces at the scale of m g where everything cancels.
fn natural(params: &Value) -> f64 {
    let [m, g] = [&params["m"], &params["g"]].map(|p| p.as_f64().expect("a number"));
    g.max(m * g)
}

fn values(entries: &[Scaled]) -> Vec<f64> {
    entries.iter().map(|e| e.value).collect()
}

/// Rows of a column-major matrix one after the other, as the golden data has them.
fn by_rows(matrix: &nalgebra::DMatrix<Scaled>) -> Vec<f64> {
    values(matrix.transpose().as_slice())
}

#[test]
fn formulation_a_follows_the_golden_data() {
    let models = models();
    for (case, block) in list(&parse(GOLDEN)["cases"]).iter().flat_map(|c| [(c, "quasi"), (c, "quasi_free")]) {
        let golden = &case[block];
        if golden.is_null() {
            continue;
        }
        let system = disk(&models, "RollingDisk", &case["params"]);
        let (x, v) = (numbers(&golden["x"]), numbers(&golden["v"]));
        let close = |name: &str, computed: &[f64]| {
            assert_close_at(name, computed, &numbers(&golden[name]), TOLERANCE, natural(&case["params"]));
        };
        let dynamics = system.dynamics(0.0, &x, &v);
        close("A", &by_rows(&dynamics.a));
        close("M", &by_rows(&dynamics.m));
        close("h", &values(dynamics.h.as_slice()));
        close("xdot", &system.rates(0.0, &x, &v));
        let rows = system.rows(0.0, &x, &v);
        close("C", &by_rows(&rows.c));
        close("c0", &values(rows.c0.as_slice()));
        let motion = system.motion(0.0, &x, &v);
        close("vdot", motion.acceleration.as_slice());
        close("lambda", motion.multipliers.as_slice());
    }
}

#[test]
fn formulation_b_follows_the_golden_data() {
    let models = models();
    for (case, block) in list(&parse(GOLDEN)["cases"]).iter().flat_map(|c| [(c, "holonomic"), (c, "holonomic_free")]) {
        let golden = &case[block];
        if golden.is_null() {
            continue;
        }
        let system = disk(&models, "SlidingDisk", &case["params"]);
        let (q, u) = (numbers(&golden["q"]), numbers(&golden["u"]));
        let close = |name: &str, computed: &[f64]| {
            assert_close_at(name, computed, &numbers(&golden[name]), TOLERANCE, natural(&case["params"]));
        };
        let (x, v) = (system.coordinates(0.0, &q), system.velocities_of(0.0, &q, &u));
        close("v", &v);
        let (d_transposed, a_u) = system.partial_velocities(0.0, &q, &u);
        close("Btilde", &by_rows(&d_transposed));
        close("a_u", &values(a_u.as_slice()));
        let rows = system.rows(0.0, &x, &v);
        close("C", &by_rows(&rows.c));
        close("c0", &values(rows.c0.as_slice()));
        let motion = system.configured_motion(0.0, &q, &u);
        close("r", motion.reaction.as_slice());
        let udot = DVector::from_vec(numbers(&golden["udot"]));
        let expected = d_transposed.map(|e| e.value) * udot + a_u.map(|e| e.value);
        assert_close_at(
            "vdot",
            motion.acceleration.as_slice(),
            expected.as_slice(),
            TOLERANCE,
            natural(&case["params"]),
        );
    }
}

#[test]
fn formulation_c_follows_the_golden_data() {
    let models = models();
    for case in list(&parse(GOLDEN)["cases"]) {
        let golden = &case["nonholonomic"];
        let (q, u) = (numbers(&golden["q"]), numbers(&golden["u"]));
        let close = |name: &str, computed: &[f64]| {
            assert_close_at(name, computed, &numbers(&golden[name]), TOLERANCE, natural(&case["params"]));
        };
        // both stages at once, and the second stage by itself
        let stages = disk(&models, "RollingDiskInStages", &case["params"]);
        let motion = stages.configured_motion(0.0, &q, &u);
        let (d_transposed, a_u) = stages.partial_velocities(0.0, &q, &u);
        let udot = DVector::from_vec(numbers(&golden["udot"]));
        let expected = d_transposed.map(|e| e.value) * udot + a_u.map(|e| e.value);
        assert_close_at(
            "vdot",
            motion.acceleration.as_slice(),
            expected.as_slice(),
            TOLERANCE,
            natural(&case["params"]),
        );
        let second = disk(&models, "RollingDiskSecondStage", &case["params"]);
        let rows: Rows = second.rows(0.0, &q, &u);
        close("C", &by_rows(&rows.c));
        close("c0", &values(rows.c0.as_slice()));
        let motion = second.motion(0.0, &q, &u);
        close("udot", motion.acceleration.as_slice());
        close("lambda", motion.multipliers.as_slice());
        let dynamics = second.dynamics(0.0, &q, &u);
        assert_close("M_d", &by_rows(&dynamics.m), &numbers(&case["holonomic"]["M_d"]), TOLERANCE);
        let energy = dynamics.kinetic.value + dynamics.potential.expect("V").value;
        close("energy", &[energy]);
        let sliding = &case["holonomic_free"];
        if !sliding.is_null() {
            let h = second.dynamics(0.0, &numbers(&sliding["q"]), &numbers(&sliding["u"])).h;
            assert_close_at(
                "h_u",
                &values(h.as_slice()),
                &numbers(&sliding["h_u"]),
                TOLERANCE,
                natural(&case["params"]),
            );
        }
    }
}

#[test]
fn a_merged_height_changes_nothing() {
    let models = models();
    for case in list(&parse(GOLDEN)["cases"]) {
        let golden = &case["quasi"];
        let (x, v) = (numbers(&golden["x"]), numbers(&golden["v"]));
        let motion = disk(&models, "RollingDiskOnFloor", &case["params"]).motion(0.0, &x, &v);
        assert_eq!(motion.freedom, 3);
        assert_close_at(
            "vdot",
            motion.acceleration.as_slice(),
            &numbers(&golden["vdot"]),
            TOLERANCE,
            natural(&case["params"]),
        );
        let r: Vec<Vec<f64>> = list(&golden["r"]).iter().map(numbers).collect();
        let total: Vec<f64> = (0..6).map(|i| r.iter().map(|r| r[i]).sum()).collect();
        assert_close("r", motion.reaction.as_slice(), &total, TOLERANCE);
    }
}

/// The two directions of the kinematics undo each other, and Ṙow along a small step is what the dual numbers say.
#[test]
fn every_model_is_consistent_with_itself() {
    let mut random = SplitMix::new(2);
    for model in &models() {
        let system = System::nominal(model);
        for _ in 0..20 {
            let t = random.between(0.0, 2.0);
            let near = |x: &String| match model.start.get(x) {
                Some(start) => start + random.between(-0.1, 0.1),
                None => random.between(0.2, 1.2),
            };
            let guess: Vec<f64> = model.state_coordinates().iter().map(near).collect();
            let q = closed(&system, t, &guess)
                .unwrap_or_else(|| panic!("{}: Newton's method does not close near the guess", model.name));
            let qdot = random.vector(q.len(), -1.0, 1.0);
            let x = system.coordinates(t, &q);
            let v = system.velocities_of(t, &q, &qdot);
            if model.configuration.is_none() {
                assert_close(&model.name, &system.rates(t, &x, &v), &qdot, 1e-13);
                let v = onto_velocity_rows(&system, t, &x, &v).expect("Newton's method closes near the guess");
                let binding = model.constraints.iter().enumerate().filter(|(_, c)| c.level != Level::Acceleration);
                for (row, _) in binding {
                    let residual = system.velocity(row, t, &x, &v);
                    assert!(residual.abs() < 1e-13, "{}: {residual}", model.name);
                }
            }
            bias_is_the_change_of_the_rows(&system, t, &x, &v);
        }
    }
}

/// d/dt of ḟ and φ with v held, by a central difference of fourth order: an independent look at c0*.
fn bias_is_the_change_of_the_rows(system: &System<'_>, t: f64, x: &[f64], v: &[f64]) {
    let rows = system.rows(t, x, v);
    let xdot = system.rates(t, x, v);
    let step = 1e-3;
    for (row, bias) in rows.c0.iter().enumerate().filter(|(row, _)| rows.levels[*row] != Level::Acceleration) {
        // one step along the tangent; the second derivative of the path does not enter the first derivative of the row
        let at = |h: f64| {
            let moved: Vec<f64> = x.iter().zip(&xdot).map(|(x, rate)| x + h * rate).collect();
            system.velocity(row, t + h, &moved, v)
        };
        let difference = (8.0 * (at(step) - at(-step)) - (at(2.0 * step) - at(-2.0 * step))) / (12.0 * step);
        let residual = rows.velocity.iter().find(|(name, _)| *name == rows.names[row]).expect("a row that binds v");
        let size = bias.size.max(residual.1.size);
        // truncation h⁴ f⁽⁵⁾/30 with derivatives that grow by the rates (below 20 here), rounding ε/h
        let bound = size * (20.0 * step).powi(4) / 30.0 + size * f64::EPSILON * 10.0 / step;
        assert!((difference - bias.value).abs() <= bound, "{} row {row}: {difference} {bias:?}", system.model.name);
    }
}

/// A model by families, and what it says with every name written out.
const FAMILIES: [&str; 2] = [
    "#[derive(ConstrainedSystem)]
    #[size(n = 3, last = n - 1)]
    #[coordinates(a[n])]
    #[speeds(w[n])]
    #[inputs(tau[n])]
    #[kinematics(dot(a[i]) = (i + 1)*w[i] + (if a[i] < n/2 { w[(i + 1) % n]/4 } else { 0 }) for i in 0..n)]
    #[define(s[0] = l[0]*sin(a[0]), s[i] = s[i - 1] + l[i]*wave(a[i]) for i in 1..n)]
    #[inertia(matrix([l[i]*l[j]*sum(max(i, j)..n, |k| m[k])/(1 + powi(i - j, 2)) for j in 0..n] for i in 0..n))]
    #[forces(tau[i] - sum(i..n, |k| m[k])*g*l[i]*sin(a[i])/n + product(0..i, |k| s[k]) for i in 0..n)]
    #[constraint(chain[i]: a[i]*w[i] == a[i + 1] + w[last] for i in 0..last, redundant)]
    #[constraint(level: sum(0..=last, |i| a[i]) == 1)]
    #[independent(w[i] for i in last..=last)]
    #[start(a[i] = 0.5 for i in 0..n)]
    struct Model { m: [f64; 3], l: [f64; 3], g: f64 }",
    "#[derive(ConstrainedSystem)]
    #[coordinates(a_0, a_1, a_2)]
    #[speeds(w_0, w_1, w_2)]
    #[inputs(tau_0, tau_1, tau_2)]
    #[kinematics(
        dot(a_0) = w_0 + (if a_0 < 1.5 { w_1/4 } else { 0 }),
        dot(a_1) = 2*w_1 + (if a_1 < 1.5 { w_2/4 } else { 0 }),
        dot(a_2) = 3*w_2 + (if a_2 < 1.5 { w_0/4 } else { 0 }),
    )]
    #[define(s_0 = l_0*sin(a_0), s_1 = s_0 + l_1*sin(a_1)/2, s_2 = s_1 + l_2*sin(a_2)/2)]
    #[inertia(matrix(
        [l_0*l_0*(m_0 + m_1 + m_2), l_0*l_1*(m_1 + m_2)/2, l_0*l_2*m_2/5],
        [_, l_1*l_1*(m_1 + m_2), l_1*l_2*m_2/2],
        [_, _, l_2*l_2*m_2],
    ))]
    #[forces(
        tau_0 - (m_0 + m_1 + m_2)*g*l_0*sin(a_0)/3 + 1,
        tau_1 - (m_1 + m_2)*g*l_1*sin(a_1)/3 + s_0,
        tau_2 - m_2*g*l_2*sin(a_2)/3 + s_0*s_1,
    )]
    #[constraint(chain_0: a_0*w_0 == a_1 + w_2, redundant)]
    #[constraint(chain_1: a_1*w_1 == a_2 + w_2, redundant)]
    #[constraint(level: a_0 + a_1 + a_2 == 1)]
    #[independent(w_2)]
    #[start(a_0 = 0.5, a_1 = 0.5, a_2 = 0.5)]
    struct Model { m_0: f64, m_1: f64, m_2: f64, l_0: f64, l_1: f64, l_2: f64, g: f64 }",
];

#[test]
fn families_are_what_they_stand_for() {
    let models = FAMILIES.map(|source| read_models(source).remove(0));
    let said = models.each_ref().map(|model| {
        let rows: Vec<_> = model.constraints.iter().map(|row| (&row.name, row.level, row.redundant)).collect();
        let listed = |chosen: &Chosen| (chosen.name.clone(), chosen.value.to_token_stream().to_string());
        let independent: Vec<_> = model.charts.iter().flatten().map(listed).collect();
        format!("{:?} {rows:?} {:?} {:?} {independent:?}", model.parameters, model.start, model.inputs)
    });
    assert_eq!(said[0], said[1]);
    let mut random = SplitMix::new(3);
    let (parameters, inputs) = (random.vector(7, 0.5, 1.5), random.vector(3, -1.0, 1.0));
    let (x, v) = (random.vector(3, -1.0, 1.0), random.vector(3, -1.0, 1.0));
    let [one, other] = models.each_ref().map(|model| {
        let system = System { model, parameters: parameters.clone(), inputs: inputs.clone() };
        let (dynamics, rows) = (system.dynamics(0.3, &x, &v), system.rows(0.3, &x, &v));
        let parts = [dynamics.a.as_slice(), dynamics.m.as_slice(), dynamics.h.as_slice(), rows.c.as_slice()];
        [parts.concat(), rows.c0.as_slice().to_vec()].concat().iter().map(|e| e.value).collect::<Vec<_>>()
    });
    assert_close("both", &one, &other, 1e-15);
}

#[test]
fn functions_of_the_models_have_their_derivatives() {
    // of sin(s)/2 and 1/(1 + s²) by hand
    let s = 0.7_f64;
    let expected = [[s.sin() / 2.0, s.cos() / 2.0, -s.sin() / 2.0, -s.cos() / 2.0], {
        let d = 1.0 + s * s;
        [1.0 / d, -2.0 * s / d.powi(2), (6.0 * s * s - 2.0) / d.powi(3), 24.0 * s * (1.0 - s * s) / d.powi(4)]
    }];
    for (name, expected) in ["wave", "bump"].iter().zip(expected) {
        let found: Vec<f64> = (0..4).map(|order| derivative(name, order, s)).collect();
        assert_close(name, &found, &expected, 1e-14);
    }
}

#[test]
fn nested_duals_differentiate_twice() {
    let x = Dual::moving(Dual::moving(0.7, 1.0), Dual::constant(1.0));
    let (sin, cos) = x.sin_cos();
    let f = (sin * cos / (x.exp() + x.powi(3))).sqrt() + x.ln().atan2(x);
    assert_close("f, f', f''", &[f.value.value, f.value.rate, f.rate.rate], &EXPECTED, 1e-14);
}

/// From mpmath: `mp.diff(lambda x: mp.sqrt(mp.sin(x)*mp.cos(x)/(mp.exp(x)+x**3))+mp.atan2(mp.log(x), x), 0.7, k)`.
const EXPECTED: [f64; 3] = [-0.014005913706163331, 1.938968239147956, -4.569216700849505];
