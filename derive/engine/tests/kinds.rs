//! Constraints of every kind in mixtures: what the engine derives against the full equations (2.8), and against
//! differences of the rows themselves along the motion.

#[path = "kinds/combinations.rs"]
mod combinations;
#[path = "kinds/speeds.rs"]
mod speeds;

use holonomy_engine::projection::{Equations, Level};
use holonomy_engine::symbolic::{Expr, Matrix, Symbol};
use quote::quote;

/// One state of a model, with every symbol at a number.
struct At<'a> {
    e: &'a Equations,
    numbers: Vec<(Symbol, f64)>,
}

/// Numbers between 0.4 and 1.6 that look random.
fn number(k: usize) -> f64 {
    1.0 + 0.6 * (1.7 * k as f64 + 0.9).sin()
}

impl<'a> At<'a> {
    fn new(e: &'a Equations) -> Self {
        let own = e.parameters.iter().chain(&e.inputs).chain(&e.state_coordinates).chain(&e.state_speeds);
        let numbers = own.chain([&e.time]).enumerate().map(|(k, s)| (*s, number(k))).collect();
        At { e, numbers }
    }

    fn value(&self, roots: &[Expr]) -> Vec<f64> {
        let of = |s: Symbol| self.numbers.iter().find(|(other, _)| *other == s).map(|(_, value)| *value);
        let pi = self.e.graph.pi_symbol();
        self.e.graph.evaluate(roots, &|s| if s == pi { std::f64::consts::PI } else { of(s).unwrap_or(f64::NAN) })
    }

    fn matrix(&self, m: &Matrix) -> Vec<Vec<f64>> {
        let entries = self.value(m.entries());
        (0..m.rows()).map(|i| entries[i * m.columns()..(i + 1) * m.columns()].to_vec()).collect()
    }

    /// The same parameters, with x and v as they stand for the functions of the initial system.
    fn initial(&self, t: f64, x: &[f64], v: &[f64]) -> At<'a> {
        let e = self.e;
        let mut numbers: Vec<(Symbol, f64)> =
            self.numbers.iter().copied().filter(|(s, _)| e.parameters.contains(s) || e.inputs.contains(s)).collect();
        numbers.push((e.time, t));
        numbers.extend(e.coordinates.iter().copied().zip(x.iter().copied()));
        numbers.extend(e.speeds.iter().copied().zip(v.iter().copied()));
        At { e, numbers }
    }

    /// The state a while later along the motion.
    fn moved(&self, by: f64) -> At<'a> {
        let e = self.e;
        let rates = self.value(&e.coordinate_rates).into_iter().chain(self.value(&e.accelerations));
        let state: Vec<Symbol> = e.state_coordinates.iter().chain(&e.state_speeds).copied().collect();
        let mut numbers = self.numbers.clone();
        for (s, rate) in state.into_iter().zip(rates).chain([(e.time, 1.0)]) {
            numbers.iter_mut().filter(|(other, _)| *other == s).for_each(|(_, value)| *value += by * rate);
        }
        At { e, numbers }
    }

    fn time(&self) -> f64 {
        self.value(&[self.e.graph.var(self.e.time)])[0]
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[track_caller]
fn close(what: &str, a: &[f64], b: &[f64], tolerance: f64) {
    assert_eq!(a.len(), b.len(), "{what}");
    let scale = a.iter().chain(b).fold(1.0, |scale: f64, e| scale.max(e.abs()));
    for (a, b) in a.iter().zip(b) {
        assert!((a - b).abs() <= tolerance * scale, "{what}: {a} {b} (scale {scale})");
    }
}

/// Everything that must hold at a state: (2.8), D, M_d, and the rates against differences.
#[track_caller]
fn checked(tokens: proc_macro2::TokenStream) -> Equations {
    let e = match holonomy_engine::analyse(tokens) {
        Ok(analysis) => analysis.equations,
        Err(errors) => panic!("{:?}", errors.iter().map(|e| e.message.clone()).collect::<Vec<_>>()),
    };
    let at = At::new(&e);
    let (t, x, v) = (at.time(), at.value(&e.initial_coordinates), at.value(&e.velocities));
    let initial = at.initial(t, &x, &v);
    let (m, h) = (initial.matrix(&e.inertia), initial.value(&e.forces));
    let (c, c0) = (initial.matrix(&e.constraint_matrix), initial.value(&e.constraint_bias));
    let rates = at.value(&e.velocity_rates);
    let named = at.value(&e.multipliers);
    let mut lambda = vec![f64::NAN; c.len()];
    e.multiplier_rows.iter().zip(&named).for_each(|(row, value)| {
        if let Some(row) = row {
            lambda[*row] = *value;
        }
    });
    // (2.8)
    let reached: Vec<f64> = c.iter().map(|row| dot(row, &rates)).collect();
    let bias: Vec<f64> = c0.iter().map(|c0| -c0).collect();
    close("C v' + c0 = 0", &reached, &bias, 1e-10);
    let inertial: Vec<f64> = m.iter().map(|row| dot(row, &rates)).collect();
    let acting: Vec<f64> =
        (0..h.len()).map(|j| h[j] + c.iter().zip(&lambda).map(|(row, lambda)| row[j] * lambda).sum::<f64>()).collect();
    if e.configuration_is_stated() {
        close("M v' = h + C' lambda", &inertial, &acting, 1e-9);
    }
    // D, a_u, M_d, h_u*
    let d = at.matrix(&e.complement);
    for row in &d {
        close("D C' = 0", &c.iter().map(|c| dot(c, row)).collect::<Vec<_>>(), &vec![0.0; c.len()], 1e-10);
    }
    let u = at.value(&e.accelerations);
    let nu: Vec<f64> = e
        .reduced_speeds
        .iter()
        .map(|s| u[e.state_speeds.iter().position(|other| other == s).expect("a speed of the state")])
        .collect();
    let a_u = at.value(&e.complement_bias);
    let from_nu: Vec<f64> =
        (0..a_u.len()).map(|j| a_u[j] + d.iter().zip(&nu).map(|(row, nu)| row[j] * nu).sum::<f64>()).collect();
    close("v' = D' nu + a_u", &rates, &from_nu, 1e-10);
    let reduced: Vec<f64> = at.matrix(&e.mass_matrix).iter().map(|row| dot(row, &nu)).collect();
    close("M_d nu = h_u", &reduced, &at.value(&e.forcing), 1e-10);
    // Differences along the motion.
    let step = 1e-5;
    let (before, after) = (at.moved(-step), at.moved(step));
    let difference = |f: &dyn Fn(&At<'_>) -> Vec<f64>| -> Vec<f64> {
        f(&after).iter().zip(f(&before)).map(|(b, a)| (b - a) / (2.0 * step)).collect()
    };
    close("v' by differences", &difference(&|at| at.value(&e.velocities)), &rates, 1e-7);
    let phi = |at: &At<'_>| {
        let (x, v) = (at.value(&e.initial_coordinates), at.value(&e.velocities));
        at.initial(at.time(), &x, &v).value(&e.velocity_residual)
    };
    close("phi' = 0", &difference(&phi), &vec![0.0; e.velocity_residual.len()], 1e-6);
    for guard in at.value(&e.guards.iter().map(|g| g.expr).collect::<Vec<_>>()) {
        assert!(guard.is_finite() && guard != 0.0);
    }
    e
}

/// Whether every reaction belongs to a row.
trait Stated {
    fn configuration_is_stated(&self) -> bool;
}

impl Stated for Equations {
    fn configuration_is_stated(&self) -> bool {
        let independent = self.rows.iter().filter(|row| !row.redundant).count();
        independent + self.reduced_speeds.len() == self.speeds.len()
    }
}

fn names(e: &Equations, symbols: &[Symbol]) -> Vec<String> {
    symbols.iter().map(|s| e.graph.name(*s).to_owned()).collect()
}

#[test]
fn a_nonlinear_velocity_row_leaves_all_speeds_in_the_state() {
    let e = checked(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(m, m))]
        #[forces(0, -m*g)]
        #[constraint(speed: (powi(dot(x), 2) + powi(dot(y), 2) - powi(c, 2))/2 == 0)]
        struct P6 { m: f64, g: f64, c: f64 }
    });
    assert_eq!(names(&e, &e.state_speeds), ["dot_x", "dot_y"]);
    assert_eq!(e.reduced_speeds.len(), 1);
    assert_eq!((e.rows[0].level, e.rows[0].linear), (Level::Velocity, false));
    // No guard but the one that vanishes with the row: the pivot of D is none.
    assert_eq!(e.guards.len(), 1);
    assert_eq!(e.guards[0].rows, ["speed"]);
    assert!(e.guards[0].name.contains("dot_x") && e.guards[0].name.contains("dot_y"), "{}", e.guards[0].name);
    assert!(e.notes.iter().any(|note| note.contains("`speed` is not linear in the velocities")), "{:?}", e.notes);
}

#[test]
fn rheonomic_nonlinear_rows() {
    let e = checked(quote! {
        #[coordinates(x, y, z)]
        #[inertia(diag(m, m, 2*m))]
        #[forces(0, -x*dot(y), -m*g)]
        #[constraint(slope: powi(dot(x), 2) + powi(dot(y), 2) == powi(a*(1 + t) + x*y, 2)*powi(dot(z), 2) + sin(t*z))]
        struct Slope { m: f64, g: f64, a: f64 }
    });
    assert_eq!(e.state_speeds.len(), 3);
    assert_eq!(e.complement.rows(), 2);
}

#[test]
fn acceleration_rows() {
    let e = checked(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(m, m))]
        #[forces(0, -m*g)]
        #[constraint(push: ddot(x) + k*ddot(y) == cos(t))]
        struct P8 { m: f64, g: f64, k: f64 }
    });
    assert_eq!((e.rows[0].level, e.rows[0].linear), (Level::Acceleration, true));
    assert!(e.velocity_residual.is_empty() && e.guards.is_empty());
    assert_eq!(names(&e, &e.reduced_speeds), ["dot_y"]);
    assert!(e.notes.iter().any(|note| note.contains("`push` binds accelerations and no velocity")), "{:?}", e.notes);
    let e = checked(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(m, m))]
        #[forces(0, -m*g)]
        #[constraint(path: dot(x)*ddot(y) - dot(y)*ddot(x) == kappa*powi(sqrt(powi(dot(x), 2) + powi(dot(y), 2)), 3))]
        struct Curvature { m: f64, g: f64, kappa: f64 }
    });
    assert_eq!(e.guards.len(), 1, "{:?}", e.guards);
}

#[test]
fn accelerations_of_coordinates_follow_from_named_speeds() {
    // The row binds d/dt (A v + a0), and A, a0 depend on x and t.
    let e = checked(quote! {
        #[coordinates(x, y)]
        #[speeds(v1, v2)]
        #[kinematics(dot(x) = v1*(2 + sin(y*t)) + t*y, dot(y) = v2 + x*v1 + cos(t))]
        #[inertia(matrix([a, b], [_, 2*a]))]
        #[forces(-y*v2, v1*x)]
        #[constraint(push: ddot(x) + x*dot(v2) == cos(t)*v1)]
        struct Driven { a: f64, b: f64 }
    });
    let at = At::new(&e);
    let step = 1e-5;
    let rate = |at: &At<'_>| at.value(&e.coordinate_rates)[0];
    let second = (rate(&at.moved(step)) - rate(&at.moved(-step))) / (2.0 * step);
    let state: Vec<Expr> = e.state_coordinates.iter().chain(&e.state_speeds).map(|s| e.graph.var(*s)).collect();
    let [x, _, v1, _] = at.value(&state)[..] else { panic!("four entries") };
    let v2 = at.value(&e.accelerations)[1];
    close("push", &[second + x * v2], &[at.time().cos() * v1], 1e-7);
}

#[test]
fn all_kinds_at_once() {
    let e = checked(quote! {
        #[coordinates(x, y, z, p, q)]
        #[speeds(v1, v2, v3, v4, v5)]
        #[kinematics(
            dot(x) = v1 + sin(t), dot(y) = v2*(1 + x*x), dot(z) = v3 - v1*y, dot(p) = 2*v4, dot(q) = v5 + t*v4
        )]
        #[inertia(matrix(
            [m + x*x, 0, b, 0, 0], [_, m, 0, 0, b*t], [_, _, 2*m, 0, 0], [_, _, _, m, b], [_, _, _, _, 3*m + t]
        ))]
        #[forces(-x, v1*v2, -m*g, v5*p, -v4)]
        #[constraint(ball: powi(x, 2) + y*y + z*z == powi(r*(1 + t), 2))]
        #[constraint(roll: v4 - x*v5 == sin(t))]
        #[constraint(speed: v2*v2 + v5*v5*(2 + sin(x*t)) == c*c + v1*p)]
        #[constraint(push: dot(v5) + v1*ddot(z) == powi(v2, 2)*t)]
        #[independent(v1, v2, v5)]
        struct Mixture { m: f64, b: f64, g: f64, r: f64, c: f64 }
    });
    assert_eq!(names(&e, &e.state_speeds), ["v1", "v2", "v5"]);
    assert_eq!((e.reduced_speeds.len(), e.constraint_matrix.rows(), e.velocity_residual.len()), (1, 4, 3));
}

#[test]
fn behind_a_configuration() {
    // The configuration satisfies `rod` and `second`; the others bind the rates of alpha, z and p.
    let e = checked(quote! {
        #[coordinates(x, y, z, p)]
        #[inertia(diag(m, m, m, 2*m))]
        #[forces(0, -m*g, -z*dot(p), dot(x))]
        #[configuration(of(alpha), x = l*sin(alpha) + t, y = -l*cos(alpha))]
        #[constraint(rod: (powi(x - t, 2) + powi(y, 2) - powi(l, 2))/2 == 0)]
        #[constraint(speed: powi(dot(x), 2) + powi(dot(z), 2) == c*c + dot(p))]
        #[constraint(push: ddot(y) + z*ddot(z) == sin(t)*dot(p))]
        struct Hung { m: f64, l: f64, g: f64, c: f64 }
    });
    assert_eq!(names(&e, &e.state_speeds), ["dot_z", "dot_p", "dot_alpha"]);
    assert_eq!(e.reduced_speeds.len(), 1);
    let e = checked(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(m, m))]
        #[forces(0, -m*g)]
        #[configuration(of(alpha), x = l*sin(alpha), y = -l*cos(alpha))]
        #[constraint(second: x*ddot(x) + y*ddot(y) + powi(dot(x), 2) + powi(dot(y), 2) == 0)]
        struct Absorbed { m: f64, l: f64, g: f64 }
    });
    assert_eq!(e.reduced_speeds.len(), 1);
    assert_eq!(e.rows[0].level, Level::Acceleration);
}

#[test]
fn with_a_complement_of_the_user() {
    let e = checked(quote! {
        #[coordinates(x, y, z)]
        #[inertia(matrix([m, b, 0], [_, m, 0], [_, _, m]))]
        #[forces(0, -m*g, dot(x)*dot(y))]
        #[constraint(rod: (powi(x, 2) + powi(y, 2) - powi(l, 2))/2 == 0)]
        #[complement(swing = [-y, x, 0], lift = [0, 0, 1])]
        #[constraint(speed: powi(dot(x), 2) + powi(dot(y), 2) + dot(z)*t == c)]
        struct Swung { m: f64, b: f64, g: f64, l: f64, c: f64 }
    });
    assert_eq!(names(&e, &e.state_speeds), ["swing", "lift"]);
}

#[test]
fn motions_that_are_prescribed_altogether() {
    let e = checked(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(m, 2*m))]
        #[forces(0, -m*g)]
        #[constraint(speed: powi(dot(x), 2) + powi(dot(y), 2)*x == t)]
        #[constraint(push: ddot(x) + ddot(y) == sin(t))]
        struct Prescribed { m: f64, g: f64 }
    });
    assert_eq!((e.complement.rows(), e.mass_matrix.rows()), (0, 0));
    let e = checked(quote! {
        #[coordinates(x)]
        #[inertia(diag(m))]
        #[forces(-k*x)]
        #[constraint(push: ddot(x) == sin(t))]
        struct Pushed { m: f64, k: f64 }
    });
    assert!(e.reduced_speeds.is_empty() && e.state_speeds.len() == 1);
    let e = checked(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(m, m))]
        #[forces(-k*x, 0)]
        #[constraint(rail: y == sin(t))]
        #[constraint(push: ddot(x) == dot(y))]
        struct Carried { m: f64, k: f64 }
    });
    assert!(e.reduced_speeds.is_empty() && e.state_speeds.len() == 1);
    let e = checked(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(m, m))]
        #[forces(-k*x, t)]
        struct Free { m: f64, k: f64 }
    });
    assert_eq!(e.reduced_speeds.len(), 2);
}

#[test]
fn an_inertia_that_is_definite_only_on_the_motions() {
    checked(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(m, 0))]
        #[forces(-k*x, -k*y)]
        #[constraint(tie: ddot(y) == 2*ddot(x) + t)]
        struct Massless { m: f64, k: f64 }
    });
    // No pivot that cannot vanish, and M is singular on the speeds of the state: D3 is left, with its guard.
    let e = checked(quote! {
        #[coordinates(x, y, z)]
        #[inertia(diag(m, m, 0))]
        #[forces(-k*x, 0, -k*y)]
        #[constraint(speed: powi(dot(x), 2) + powi(dot(y), 2) == powi(dot(z), 2))]
        #[constraint(rail: x == sin(t))]
        struct MasslessFast { m: f64, k: f64 }
    });
    assert!(e.guards.iter().all(|guard| guard.rows == ["speed"] || guard.rows.is_empty()), "{:?}", e.guards);
}

/// λ of all rows is the shortest that gives the same reaction: it lies in the range of C.
#[track_caller]
fn shortest(e: &Equations) -> Vec<f64> {
    let at = At::new(e);
    let (x, v) = (at.value(&e.initial_coordinates), at.value(&e.velocities));
    let c = at.initial(at.time(), &x, &v).matrix(&e.constraint_matrix);
    let lambda = at.value(&e.multipliers);
    assert_eq!(lambda.len(), c.len());
    // Orthogonal to every z with Cᵀ z = 0: project λ on the rows of Cᵀ one by one (Gram-Schmidt) and nothing is left.
    let (n, mut rest, mut basis) = (c[0].len(), lambda.clone(), Vec::<Vec<f64>>::new());
    for j in 0..n {
        let mut column: Vec<f64> = c.iter().map(|row| row[j]).collect();
        for b in &basis {
            let part = dot(&column, b);
            column.iter_mut().zip(b).for_each(|(a, b)| *a -= part * b);
        }
        let norm = dot(&column, &column).sqrt();
        if norm > 1e-8 {
            column.iter_mut().for_each(|a| *a /= norm);
            let part = dot(&rest, &column);
            rest.iter_mut().zip(&column).for_each(|(a, b)| *a -= part * b);
            basis.push(column);
        }
    }
    close("λ in the range of C", &rest, &vec![0.0; rest.len()], 1e-9 * lambda.iter().fold(1.0, |s, l| l.abs().max(s)));
    lambda
}

#[test]
fn a_duplicated_rod_carries_half_each() {
    let e = checked(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(m, m))]
        #[forces(0, -m*g)]
        #[constraint(rod: (powi(x, 2) + powi(y, 2) - powi(l, 2))/2 == 0)]
        #[constraint(again: (powi(x, 2) + powi(y, 2) - powi(l, 2))/2 == 0, redundant)]
        struct P14 { m: f64, g: f64, l: f64 }
    });
    let lambda = shortest(&e);
    close("half each", &lambda[..1], &lambda[1..], 1e-14);
    assert_eq!((e.rows[0].redundant, e.rows[1].redundant), (false, true));
    assert_eq!((e.position_residual.len(), e.velocity_residual.len(), e.state_speeds.len()), (2, 2, 1));
    assert!(
        e.notes.iter().any(|note| note.contains("`again` depends on the other rows: it is `rod`")),
        "{:?}",
        e.notes
    );
}

#[test]
fn redundant_rows_of_every_kind() {
    let e = checked(quote! {
        #[coordinates(x, y, z, p)]
        #[speeds(v1, v2, v3, v4)]
        #[kinematics(dot(x) = v1 + y*v2, dot(y) = v2*(2 + sin(t)), dot(z) = v3 + t, dot(p) = v4)]
        #[inertia(matrix([m, b, 0, 0], [_, 2*m, 0, b*x], [_, _, m, 0], [_, _, _, 3*m]))]
        #[forces(v2, -m*g, v1*v3, x*t)]
        #[constraint(sum: x*v1 + 2*v2 - v3 == sin(t), redundant)]
        #[constraint(one: x*v1 + v3 == 0)]
        #[constraint(two: v2 - v3 == sin(t)/2)]
        #[constraint(speed: v1*v1 + v4*v4 == c + x)]
        #[constraint(brake: 2*v1*dot(v1) + 2*v4*dot(v4) == v1 + y*v2, redundant)]
        #[constraint(extra: p*v3*t == v4*y, redundant)]
        struct Many { m: f64, b: f64, g: f64, c: f64 }
    });
    let redundant: Vec<bool> = e.rows.iter().map(|row| row.redundant).collect();
    assert_eq!(redundant, [true, false, false, false, true, false]);
    assert!(
        e.notes.iter().any(|note| note.contains("`extra` is marked as redundant, but independent")),
        "{:?}",
        e.notes
    );
    shortest(&e);
}

#[test]
fn redundant_rows_behind_a_configuration() {
    // Both rods are satisfied by the configuration; the rail and its double bind the rates.
    let e = checked(quote! {
        #[coordinates(x, y, z)]
        #[inertia(diag(m, 2*m, m))]
        #[forces(0, -m*g, -z)]
        #[configuration(of(alpha), x = l*sin(alpha), y = -l*cos(alpha))]
        #[constraint(rod: powi(x, 2) + powi(y, 2) == powi(l, 2))]
        #[constraint(again: (powi(x, 2) + powi(y, 2) - powi(l, 2))*t == 0, redundant)]
        #[constraint(rail: dot(z) == dot(x)*t)]
        #[constraint(rails: 3*dot(z) == 3*dot(x)*t, redundant)]
        struct Railed { m: f64, g: f64, l: f64 }
    });
    assert_eq!((e.rows.len(), e.reduced_speeds.len()), (4, 1));
}

#[test]
fn redundant_rows_that_say_something_else_are_refused() {
    let positions = refused(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(m, m))]
        #[forces(0, 0)]
        #[constraint(rail: y == x)]
        #[constraint(other: y == x + 1, redundant)]
        struct Other { m: f64 }
    });
    assert!(positions.contains("`other` contradicts the others: its rates are those of `rail`"), "{positions}");
    let velocities = refused(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(m, m))]
        #[forces(0, 0)]
        #[constraint(rail: dot(y) == dot(x))]
        #[constraint(other: dot(y) == dot(x) + t, redundant)]
        struct Other { m: f64 }
    });
    assert!(velocities.contains("`other` is not redundant: it binds what `rail` binds"), "{velocities}");
    // On the motions, v1 = 0: there the acceleration row says the same.
    checked(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(m, m))]
        #[forces(x, y)]
        #[constraint(rail: dot(y) == 0)]
        #[constraint(damped: ddot(y) + dot(y) == 0, redundant)]
        struct Damped { m: f64 }
    });
}

fn refused(tokens: proc_macro2::TokenStream) -> String {
    let errors = holonomy_engine::analyse(tokens).expect_err("the model makes no sense");
    errors.iter().map(|e| e.message.clone()).collect::<Vec<_>>().join("\n")
}

#[test]
fn rows_that_repeat_each_other_behind_a_configuration_say_the_same() {
    let on_a_circle = |second: proc_macro2::TokenStream| {
        quote! {
            #[coordinates(x, y)]
            #[inertia(diag(m, m))]
            #[forces(0, -m*g)]
            #[configuration(of(alpha), x = l*sin(alpha), y = -l*cos(alpha))]
            #[constraint(first: dot(x) == t)]
            #second
            struct Driven { m: f64, g: f64, l: f64 }
        }
    };
    checked(on_a_circle(quote!(#[constraint(second: dot(y)*y == -t*x)])));
    let text = refused(on_a_circle(quote!(#[constraint(second: dot(y)*y == -2*t*x)])));
    assert!(text.contains("`second` cannot hold: the configuration"), "{text}");
    checked(on_a_circle(quote!(#[constraint(second: y*ddot(y) + powi(dot(y), 2) + x + t*t == 0)])));
    let text = refused(on_a_circle(quote!(#[constraint(second: y*ddot(y) + powi(dot(y), 2) + 2*x + t*t == 0)])));
    assert!(text.contains("`second` cannot hold: on the motions"), "{text}");
    // Neither row binds nothing there: they bind the same.
    let along_a_line = |second: proc_macro2::TokenStream| {
        quote! {
            #[coordinates(x, y)]
            #[inertia(diag(m, m))]
            #[forces(0, -m*g)]
            #[configuration(of(s), x = s, y = 2*s)]
            #[constraint(first: ddot(x) == a*t)]
            #second
            struct Driven { m: f64, g: f64, a: f64 }
        }
    };
    checked(along_a_line(quote!(#[constraint(second: ddot(y) == 2*a*t)])));
    let text = refused(along_a_line(quote!(#[constraint(second: ddot(y) == 3*a*t)])));
    assert!(text.contains("`second` cannot hold: on the motions") && text.contains("that -t*a be 0"), "{text}");
}

#[test]
fn rows_that_depend_on_each_other_are_refused() {
    let twice = refused(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(m, m))]
        #[forces(0, 0)]
        #[constraint(speed: powi(dot(x), 2) + powi(dot(y), 2) == c)]
        #[constraint(again: 3*powi(dot(x), 2) + 3*powi(dot(y), 2) == 3*c)]
        struct Twice { m: f64, c: f64 }
    });
    assert!(twice.contains("`again` depends on the other rows: it is 3*`speed`"), "{twice}");
    let conflict = refused(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(m, m))]
        #[forces(0, 0)]
        #[constraint(speed: powi(dot(x), 2) + powi(dot(y), 2) == c*t)]
        #[constraint(again: dot(x)*ddot(x) + dot(y)*ddot(y) == c)]
        struct Conflict { m: f64, c: f64 }
    });
    assert!(conflict.contains("`again` binds the same accelerations as 1/2*`speed`"), "{conflict}");
    let contradiction = refused(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(m, m))]
        #[forces(0, 0)]
        #[constraint(speed: powi(dot(x), 2) + powi(dot(y), 2) == c)]
        #[constraint(again: 3*powi(dot(x), 2) + 3*powi(dot(y), 2) == c)]
        struct Contradiction { m: f64, c: f64 }
    });
    assert!(contradiction.contains("`again` contradicts the others"), "{contradiction}");
    let second = refused(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(m, m))]
        #[forces(0, 0)]
        #[constraint(rail: y == x)]
        #[constraint(again: ddot(y) == ddot(x))]
        struct Second { m: f64 }
    });
    assert!(second.contains("`again` depends on the other rows: it is `rail`"), "{second}");
    let on_motions = refused(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(m, m))]
        #[forces(0, 0)]
        #[constraint(rail: dot(y) == 0)]
        #[constraint(product: dot(x)*dot(y) == 0)]
        struct OnMotions { m: f64 }
    });
    assert!(on_motions.contains("`product` depends on the other rows: on the motions"), "{on_motions}");
    // Independent in general, but not where the rail leaves dot(y) = 0.
    let together = |speeds: proc_macro2::TokenStream| {
        refused(quote! {
            #[coordinates(x, y, z)]
            #[inertia(diag(m, m, m))]
            #[forces(0, 0, 0)]
            #[constraint(rail: dot(y) == 0)]
            #[constraint(speed: powi(dot(x), 2) + powi(dot(y), 2) + powi(dot(z), 2) == c)]
            #speeds
            struct Together { m: f64, c: f64 }
        })
    };
    let product = quote!(powi(dot(x), 2) + powi(dot(y), 2) + powi(dot(z), 2) + 2 * dot(x) * dot(y) * dot(z));
    let text = together(quote!(#[constraint(product: #product == c)]));
    assert!(text.contains("`product` depends on the other rows: on the motions"), "{text}");
    let text = together(quote!(#[constraint(product: #product == c*t)]));
    assert!(text.contains("`product` cannot hold: on the motions"), "{text}");
    let excluded = refused(quote! {
        #[coordinates(x, y)]
        #[inertia(diag(m, m))]
        #[forces(0, 0)]
        #[constraint(rail: dot(y) == 0)]
        #[constraint(product: dot(x)*dot(y) == x)]
        struct Excluded { m: f64 }
    });
    assert!(excluded.contains("`product` cannot hold"), "{excluded}");
}

/// A position row that repeats one velocity row shares its reaction, whatever rows there are before that.
#[test]
fn a_merged_row_has_the_reaction_of_the_row_that_it_repeats() {
    let e = checked(quote! {
        #[coordinates(x, y, z)]
        #[inertia(diag(m, m, m))]
        #[forces(0, f, -m*g)]
        #[inputs(f)]
        #[constraint(floor: z == 0)]
        #[constraint(glide: dot(y) == 0)]
        #[constraint(rail: 4*y == 1)]
        struct Glider { m: f64, g: f64 }
    });
    let at = At::new(&e);
    let lambda = at.value(&e.multipliers);
    let of = |name: &str| lambda[e.multiplier_names.iter().position(|n| n == name).expect("it has a name")];
    let (f, g, m) = (number(2), number(1), number(0));
    close("floor", &[of("floor")], &[m * g], 1e-14);
    close("glide and rail", &[of("glide"), 4.0 * of("rail")], &[-f, -f], 1e-14);
}
