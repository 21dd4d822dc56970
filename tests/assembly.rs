//! Assembly and projection of derived models: closed loops, unequal masses, constraints that are nonlinear in the velocities.

#[path = "models/kinds.rs"]
mod kinds;

use holonomy::{ConstrainedSystem, Error, Prepared, State, Vector};
use kinds::{ConstantSpeed, Pushed};

/// Two unequal masses on a line, at a fixed distance.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(a, b)]
#[inertia(diag(m1, m2))]
#[forces(0, 0)]
#[constraint(distance: b - a - l == 0)]
struct TwoMasses {
    #[nominal(3.0)]
    m1: f64,
    #[nominal(1.0)]
    m2: f64,
    #[nominal(0.5)]
    l: f64,
}

/// The same in quasi-velocities, T written in them: ȧ = p/2, ḃ = 3 (q − p/2).
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(a, b)]
#[speeds(p, q)]
#[kinematics(p = 2*dot(a), q = dot(b)/3 + dot(a))]
#[inertia(matrix([m1/4 + 9*m2/4, -9*m2/2], [_, 9*m2]))]
#[forces(0, 0)]
#[constraint(distance: b - a - l == 0)]
struct TwoMassesOtherwise {
    #[nominal(3.0)]
    m1: f64,
    #[nominal(1.0)]
    m2: f64,
    #[nominal(0.5)]
    l: f64,
}

/// Two masses that nothing ties.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(a, b)]
#[inertia(diag(m1, m2))]
#[forces(0, 0)]
struct Free {
    m1: f64,
    m2: f64,
}

/// A four-bar linkage in the angles of its bars, uniform rods.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(crank, coupler, rocker)]
#[inertia(diag(1, 2, 3))]
#[forces(0, 0, 0)]
#[constraint(across: a*cos(crank) + b*cos(coupler) - c*cos(rocker) - d == 0)]
#[constraint(upwards: a*sin(crank) + b*sin(coupler) - c*sin(rocker) == 0)]
#[start(crank = 0.9, coupler = 0.3, rocker = 1.4)]
#[independent(dot(crank))]
struct FourBar {
    #[nominal(1.0)]
    a: f64,
    #[nominal(3.0)]
    b: f64,
    #[nominal(2.0)]
    c: f64,
    #[nominal(2.5)]
    d: f64,
}

fn two_masses() -> Prepared<TwoMasses> {
    TwoMasses { m1: 3.0, m2: 1.0, l: 0.5 }.prepare().expect("good parameters")
}

fn four_bar() -> Prepared<FourBar> {
    FourBar { a: 1.0, b: 3.0, c: 2.0, d: 2.5 }.prepare().expect("good parameters")
}

fn close(found: f64, expected: f64) -> bool {
    (found - expected).abs() < 1e-13
}

#[test]
fn heavy_parts_move_less_where_that_is_asked_for() {
    let model = two_masses();
    let guess = State::<TwoMasses> { a: 0.0, b: 0.9, ..Default::default() };
    let plain = model.assemble(guess).solve().expect("a solution");
    assert!(close(plain.a, 0.2) && close(plain.b, 0.7), "{plain:?}");
    let weighted = model.assemble(guess).mass_weighted().solve().expect("a solution");
    // The centre of mass stays: m₁ δa + m₂ δb = 0.
    assert!(close(weighted.a, 0.1) && close(weighted.b, 0.6), "{weighted:?}");
    let held = model.assemble(guess).mass_weighted().hold("a").solve().expect("a solution");
    assert!(held.a == 0.0 && close(held.b, 0.5));
    // The projections always measure by mass. That of velocities is an impact: it keeps the momentum.
    let back = model.project_positions(0.0, &[0.0, 0.9]).expect("a solution");
    assert!(close(back.value[0], 0.1) && close(back.value[1], 0.6) && close(back.before[0], 0.4));
    let back = model.project_velocities(0.0, &[0.1, 0.6], &[1.0, -3.0].into()).expect("a solution");
    assert!(close(back.value.dot_a, 0.0) && close(back.value.dot_b, 0.0) && close(back.before[0], -4.0));
    assert!(back.after[0].abs() < 1e-14);
}

#[test]
fn the_measure_does_not_depend_on_the_velocities_that_state_it() {
    let model = TwoMassesOtherwise { m1: 3.0, m2: 1.0, l: 0.5 }.prepare().expect("good parameters");
    let guess = State::<TwoMassesOtherwise> { a: 0.0, b: 0.9, ..Default::default() };
    let weighted = model.assemble(guess).mass_weighted().solve().expect("a solution");
    assert!(close(weighted.a, 0.1) && close(weighted.b, 0.6), "{weighted:?}");
    let back = model.project_positions(0.0, &[0.0, 0.9]).expect("a solution");
    assert!(close(back.value[0], 0.1) && close(back.value[1], 0.6));
    // (ȧ, ḃ) = (1, −3): p = 2, q = 0.
    let back = model.project_velocities(0.0, &[0.1, 0.6], &[2.0, 0.0].into()).expect("a solution");
    assert!(close(back.value.p, 0.0) && close(back.value.q, 0.0) && close(back.before[0], -4.0));
}

#[test]
fn speeds_are_measured_by_mass_as_well() {
    let model = Free { m1: 3.0, m2: 1.0 }.prepare().expect("good parameters");
    let sum = |assembly: holonomy::Assembly<'_, Free>| {
        assembly.meet("sum", 4.0, |_, _, s| s.dot_a + s.dot_b).solve().expect("a solution")
    };
    let plain = sum(model.assemble(Default::default()));
    assert!(close(plain.dot_a, 2.0) && close(plain.dot_b, 2.0));
    let weighted = sum(model.assemble(Default::default()).mass_weighted());
    assert!(close(weighted.dot_a, 1.0) && close(weighted.dot_b, 3.0), "{weighted:?}");
}

/// Newton's method by hand for coupler and rocker, from the same guess.
fn loop_closure(crank: f64) -> (f64, f64) {
    let (mut coupler, mut rocker) = (0.3_f64, 1.4_f64);
    for _ in 0..50 {
        let f = crank.cos() + 3.0 * coupler.cos() - 2.0 * rocker.cos() - 2.5;
        let g = crank.sin() + 3.0 * coupler.sin() - 2.0 * rocker.sin();
        let [p, q, r, s] = [-3.0 * coupler.sin(), 2.0 * rocker.sin(), 3.0 * coupler.cos(), -2.0 * rocker.cos()];
        let det = p * s - q * r;
        coupler -= (f * s - g * q) / det;
        rocker -= (g * p - f * r) / det;
    }
    (coupler, rocker)
}

#[test]
fn a_loop_closes_with_any_angle_and_any_rate_given() {
    let model = four_bar();
    let guess = State::<FourBar> { crank: 0.9, coupler: 0.3, rocker: 1.4, ..Default::default() };
    let s = model.assemble(guess).set("crank", 1.0).set("dot_rocker", 0.4).solve().expect("a solution");
    let (coupler, rocker) = loop_closure(1.0);
    assert!(s.crank == 1.0 && close(s.coupler, coupler) && close(s.rocker, rocker), "{s:?}");
    let v = model.velocities(0.0, &s);
    // The rates by differences of the closure.
    let h = 1e-4;
    let slope = (8.0 * (loop_closure(1.0 + h).1 - loop_closure(1.0 - h).1) - loop_closure(1.0 + 2.0 * h).1
        + loop_closure(1.0 - 2.0 * h).1)
        / (12.0 * h);
    assert!(close(v.dot_rocker, 0.4) && (s.dot_crank * slope - 0.4).abs() < 1e-10);
    // Another angle given, and a bar's length to be found.
    let s = model.assemble(guess).set("rocker", 1.5).solve().expect("a solution");
    assert!(s.rocker == 1.5 && model.position_residual_at(0.0, &s).iter().all(|f| f.abs() < 1e-14));
    let found = model.assemble(guess).hold("crank").set("rocker", 1.5).solve_for("b").solve_all().expect("a solution");
    let (x, y) = (2.5 + 2.0 * 1.5_f64.cos() - 0.9_f64.cos(), 2.0 * 1.5_f64.sin() - 0.9_f64.sin());
    assert!(close(found.parameters.b, x.hypot(y)) && close(found.state.coupler, y.atan2(x)));
    let longer = Prepared::with_parameters(model.system().clone(), found.parameters).expect("good parameters");
    assert!(longer.position_residual_at(0.0, &found.state).iter().all(|f| f.abs() < 1e-14));
    // Two angles of a mechanism with one degree of freedom are one too many.
    match model.assemble(guess).hold("crank").set("rocker", 1.5).solve().expect_err("no solution") {
        Error::Assembly { report, .. } => {
            assert_eq!(report.conflicts, ["crank", "rocker"]);
            let missed: Vec<&str> = report.unmet().map(|entry| entry.name).collect();
            assert!(missed.contains(&"across") || missed.contains(&"upwards"));
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn projections_leave_nothing_tangent() {
    let model = four_bar();
    let x = [1.02, 0.31, 1.39];
    let back = model.project_positions(0.0, &x).expect("a solution");
    assert!(back.after.iter().all(|f| f.abs() < 1e-14) && back.before.iter().any(|f| f.abs() > 1e-2));
    let v = model.project_velocities(0.0, &back.value, &[0.7, -0.2, 0.5].into()).expect("a solution");
    assert!(v.after.iter().all(|phi| phi.abs() < 1e-14) && v.before.iter().any(|phi| phi.abs() > 1e-2));
    // M δv has no part along the tangent direction, which the rates of the closure give.
    let s = State::<FourBar>::from_fn(|i| if i < 3 { back.value[i] } else { 0.0 });
    let d = model.complement_at(0.0, &s);
    let change = [v.value.dot_crank - 0.7, v.value.dot_coupler + 0.2, v.value.dot_rocker - 0.5];
    let work = change[0] * d[(0, 0)] + 2.0 * change[1] * d[(0, 1)] + 3.0 * change[2] * d[(0, 2)];
    assert!(work.abs() < 1e-14);
}

#[test]
fn nonlinear_constraints_bind_the_speeds() {
    let model = ConstantSpeed { m: 2.0, g: 9.81, c: 2.0 }.prepare().expect("good parameters");
    let guess = State::<ConstantSpeed> { dot_x: 3.0, dot_y: 4.0, ..Default::default() };
    // The nearest velocity of that size has the same direction.
    let s = model.assemble(guess).solve().expect("a solution");
    assert!(close(s.dot_x, 1.2) && close(s.dot_y, 1.6), "{s:?}");
    let s = model.assemble(guess).set("dot_x", -1.2).solve().expect("a solution");
    assert!(s.dot_x == -1.2 && close(s.dot_y, 1.6));
    let back = model.project_velocities(0.0, &[0.0; 2], &[3.0, 4.0].into()).expect("a solution");
    assert!(close(back.value.dot_x, 1.2) && close(back.value.dot_y, 1.6) && close(back.before[0], 10.5));
    // Too fast in one direction, and from rest no direction at all.
    match model.assemble(guess).set("dot_x", 2.5).solve().expect_err("no solution") {
        Error::Assembly { constraint: "speed", residual, report } => {
            assert!((residual - 1.125).abs() < 1e-9 && report.conflicts == ["dot_x"]);
        }
        other => panic!("{other:?}"),
    }
    let rest = model.assemble(State::<ConstantSpeed>::default()).solve();
    assert!(matches!(rest, Err(Error::Assembly { constraint: "speed", residual: -2.0, .. })));
    let rest = model.project_velocities(1.0, &[0.0; 2], &[0.0, 0.0].into());
    assert_eq!(rest, Err(Error::Projection { constraint: "speed", residual: -2.0, time: 1.0 }));
}

#[test]
fn constraints_of_accelerations_leave_positions_and_velocities_alone() {
    let model = Pushed { m: 2.0, g: 9.81, k: 0.5 }.prepare().expect("good parameters");
    let guess = State::<Pushed>::from_fn(|i| 0.3 + i as f64);
    assert_eq!(model.assemble(guess).solve(), Ok(guess));
    let (x, v) = (model.coordinates(0.0, &guess), model.velocities(0.0, &guess));
    assert_eq!(model.project_velocities(0.0, &x, &v).expect("nothing to do").value, v);
}
