//! h* from T against Lagrange's equations in x, worked out with ẍ and the chain rule, and against what books print.

use super::complete;
use crate::model::{InitialSystem, build};
use crate::projection::AsIs;
use crate::symbolic::{Expr, Kind, Symbol};
use crate::syntax::tests::{declarations, rendered};

fn system(source: &str) -> InitialSystem {
    match build(&declarations(source)) {
        Ok(system) => system,
        Err(errors) => panic!("{:#?}", rendered(source, &errors)),
    }
}

/// Aᵀ (d/dt ∂T̄/∂ẋ − ∂T̄/∂x + ∂V/∂x) − (M v̇ − h*) with T̄(ẋ, x, t) = T(B ẋ + b0, x, t): zero where h* is right.
fn defect(source: &str) -> Vec<String> {
    let mut system = system(source);
    complete(&mut system, &mut AsIs);
    let kinetic = system.kinetic.expect("a kinetic energy");
    let n = system.speeds.len();
    let g = &mut system.graph;
    let fresh = |g: &mut crate::symbolic::Graph, letter: &str| -> Vec<Symbol> {
        (0..n).map(|i| g.symbol(&format!("{letter}{i}"), Kind::Speed)).collect()
    };
    let (rates, dv) = (fresh(g, "rate"), fresh(g, "dv"));
    let (v, r, vdot) = (g.vars(&system.speeds), g.vars(&rates), g.vars(&dv));
    let plus = |g: &mut crate::symbolic::Graph, a: Vec<Expr>, b: &[Expr]| -> Vec<Expr> {
        a.into_iter().zip(b).map(|(a, b)| g.add(a, *b)).collect()
    };
    let moved = system.kinematics.b.mul_vec(g, &r);
    let of_rates = plus(g, moved, &system.kinematics.b0);
    let moved = system.kinematics.a.mul_vec(g, &v);
    let of_speeds = plus(g, moved, &system.kinematics.a0);
    let map: Vec<(Symbol, Expr)> = system.speeds.iter().copied().zip(of_rates).collect();
    let in_rates = g.substitute(&[kinetic], &map)[0];
    let one = g.one();
    // ẍ along the motion, v̇ included.
    let mut tangent: Vec<(Symbol, Expr)> = system.coordinates.iter().copied().zip(of_speeds.clone()).collect();
    tangent.push((system.time, one));
    tangent.extend(system.speeds.iter().copied().zip(vdot.clone()));
    let second = g.along(&of_speeds, &tangent);
    let momenta = g.jacobian(&[in_rates], &rates).row(0).to_vec();
    let mut tangent: Vec<(Symbol, Expr)> = system.coordinates.iter().copied().zip(r).collect();
    tangent.push((system.time, one));
    tangent.extend(rates.iter().copied().zip(second));
    let turned = g.along(&momenta, &tangent);
    let lagrangian = system.potential.map_or(in_rates, |potential| g.sub(in_rates, potential));
    let slopes = g.jacobian(&[lagrangian], &system.coordinates).row(0).to_vec();
    let left: Vec<Expr> = turned.into_iter().zip(slopes).map(|(a, b)| g.sub(a, b)).collect();
    let back: Vec<(Symbol, Expr)> = rates.iter().copied().zip(of_speeds).collect();
    let left = g.substitute(&left, &back);
    let left = system.kinematics.a.transpose().mul_vec(g, &left);
    let inertial = system.inertia.mul_vec(g, &vdot);
    let mut wrong = Vec::new();
    for i in 0..n {
        let right = g.sub(inertial[i], system.forces[i]);
        if !g.identical(left[i], right) {
            let difference = g.sub(left[i], right);
            wrong.push(format!("{i}: {}", g.display(difference)));
        }
    }
    wrong
}

const FIELDS: &str = "struct Model { m: f64, r: f64, j: f64, g: f64, a: f64, w: f64, j1: f64, j2: f64, j3: f64 }";

fn exact(statements: &str) {
    let wrong = defect(&format!("{statements} {FIELDS}"));
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Whether h* is this list: with its negative as further forces nothing is left.
fn forces_are(statements: &str, expected: &[&str]) {
    let negative: Vec<String> = expected.iter().map(|force| format!("-({force})")).collect();
    let mut found = system(&format!("{statements} #[forces({})] {FIELDS}", negative.join(", ")));
    complete(&mut found, &mut AsIs);
    for (force, text) in found.forces.iter().zip(expected) {
        assert!(found.graph.vanishes(*force), "not {text}: {} is left", found.graph.display(*force));
    }
}

/// The disk of section 6, its kinematics (6.3).
const DISK: &str = "
#[coordinates(x, y, z, phi, theta, psi)]
#[speeds(v1, v2, v3, v4, v5, v6)]
#[kinematics(
    v1 = dot(x)*cos(phi) + dot(y)*sin(phi) - r*sin(theta)*dot(phi),
    v2 = -dot(x)*sin(theta)*sin(phi) + dot(y)*sin(theta)*cos(phi) + dot(z)*cos(theta),
    v3 = dot(x)*cos(theta)*sin(phi) - dot(y)*cos(theta)*cos(phi) + dot(z)*sin(theta) - r*dot(theta),
    v4 = -dot(theta),
    v5 = dot(phi)*cos(theta),
    v6 = dot(psi) + dot(phi)*sin(theta),
)]
#[potential_energy(m*g*(z + r*cos(theta)))]";

const DISK_ENERGY: &str = "#[kinetic_energy(m/2*(powi(v1, 2) + powi(v2, 2) + powi(v3, 2)) + j/2*(powi(v4, 2) + powi(v5, 2)) + j*powi(v6, 2))]";

/// Section 6's disk: (6.9) and the forces that (6.10) prints.
#[test]
fn the_disk_has_the_printed_forces() {
    let disk = format!("{DISK} {DISK_ENERGY}");
    forces_are(
        &disk,
        &[
            "m*v5*(v2*tan(theta) - v3)",
            "m*(v4*v3 - v5*v1*tan(theta) - g*cos(theta))",
            "m*(v5*v1 - v4*v2 - g*sin(theta))",
            "j*v5*(v5*tan(theta) - 2*v6)",
            "j*v4*(2*v6 - v5*tan(theta))",
            "0",
        ],
    );
    exact(&disk);
    let found = system(&format!("{disk} #[inertia(diag(m, m, m, j, j, 2*j))] {FIELDS}"));
    assert!(found.graph.is_zero(found.inertia.get(0, 1)));
}

/// The same with T in the rates, so that (2.2) is put into it.
#[test]
fn energy_in_rates() {
    exact(&format!(
        "{DISK} #[kinetic_energy(m/2*(powi(dot(x) + r*(dot(theta)*cos(theta)*sin(phi) + dot(phi)*sin(theta)*cos(phi)), 2)
            + powi(dot(y), 2) + powi(dot(z) - r*dot(theta)*sin(theta), 2)) + j*powi(v6, 2)
            + j/2*(powi(dot(theta), 2) + powi(dot(phi), 2)*powi(cos(theta), 2)))]"
    ));
    forces_are(
        "#[coordinates(rho, al)] #[kinetic_energy(m/2*(powi(dot(rho), 2) + powi(rho*dot(al), 2)))]
         #[potential_energy(-m*g*rho*cos(al))]",
        &["m*rho*powi(dot(al), 2) + m*g*cos(al)", "-2*m*rho*dot(rho)*dot(al) - m*g*rho*sin(al)"],
    );
}

/// The rows that give the body's angular velocity from Euler's angles 3-1-3.
const BODY: &str = "
#[coordinates(psi, theta, phi)]
#[speeds(w1, w2, w3)]";
const BODY_SPEEDS: &str = "#[kinematics(
    w1 = dot(psi)*sin(theta)*sin(phi) + dot(theta)*cos(phi),
    w2 = dot(psi)*sin(theta)*cos(phi) - dot(theta)*sin(phi),
    w3 = dot(psi)*cos(theta) + dot(phi),
)]";
const BODY_RATES: &str = "#[kinematics(
    dot(psi) = (w1*sin(phi) + w2*cos(phi))/sin(theta),
    dot(theta) = w1*cos(phi) - w2*sin(phi),
    dot(phi) = w3 - (w1*sin(phi) + w2*cos(phi))*cos(theta)/sin(theta),
)]";
const BODY_ENERGY: &str = "#[kinetic_energy((j1*powi(w1, 2) + j2*powi(w2, 2) + j3*powi(w3, 2))/2)]";

/// Euler's equations, whichever direction of the kinematics is written down.
#[test]
fn a_body_has_eulers_equations() {
    for kinematics in [BODY_SPEEDS, BODY_RATES] {
        let body = format!("{BODY} {kinematics} {BODY_ENERGY}");
        forces_are(&body, &["(j2 - j3)*w2*w3", "(j3 - j1)*w3*w1", "(j1 - j2)*w1*w2"]);
        exact(&body);
    }
    exact(&format!("{BODY} {BODY_SPEEDS} {BODY_ENERGY} #[potential_energy(m*g*r*cos(theta))]"));
}

/// Coriolis' and the centrifugal force in a turning frame, the frame's angle in A and its motion in a0.
#[test]
fn a_turning_frame() {
    let energy = "#[kinetic_energy(m/2*(powi(v1, 2) + powi(v2, 2)))]";
    // Components of the absolute velocity in the frame: only the frame turns.
    forces_are(
        &format!("#[coordinates(x, y)] #[speeds(v1, v2)] #[kinematics(v1 = dot(x) - w*y, v2 = dot(y) + w*x)] {energy}"),
        &["m*w*v2", "-m*w*v1"],
    );
    forces_are(
        &format!(
            "#[coordinates(x, y)] #[speeds(v1, v2)]
             #[kinematics(dot(x) = cos(w*t)*v1 - sin(w*t)*v2, dot(y) = sin(w*t)*v1 + cos(w*t)*v2)] {energy}"
        ),
        &["m*w*v2", "-m*w*v1"],
    );
    // Velocities relative to the frame, the energy in them: terms linear in v and without v.
    forces_are(
        "#[coordinates(x, y)] #[speeds(v1, v2)] #[kinematics(v1 = dot(x), v2 = dot(y))]
         #[kinetic_energy(m/2*(powi(v1 - w*y, 2) + powi(v2 + w*x, 2)))]",
        &["2*m*w*v2 + m*w*w*x", "-2*m*w*v1 + m*w*w*y"],
    );
    // The frame's own rate changes, and its origin moves.
    exact(
        "#[coordinates(x, y)] #[speeds(v1, v2)]
         #[kinematics(v1 = dot(x) - w*t*y + sin(t), v2 = dot(y) + w*t*x - t*t)]
         #[kinetic_energy(m/2*(powi(v1, 2) + powi(v2, 2)))] #[potential_energy(m*g*(x*sin(w*t*t) + y*cos(w*t*t)))]",
    );
}

/// P4: the sleigh with the components of its blade's velocity.
#[test]
fn the_sleigh() {
    forces_are(
        "#[coordinates(x, y, phi)] #[speeds(u, w1, o)]
         #[kinematics(u = dot(x)*cos(phi) + dot(y)*sin(phi), w1 = -dot(x)*sin(phi) + dot(y)*cos(phi), o = dot(phi))]
         #[kinetic_energy(m/2*(powi(u, 2) + powi(w1 + a*o, 2)) + j/2*powi(o, 2))]",
        &["m*o*(w1 + a*o)", "-m*o*u", "-m*a*u*o"],
    );
}

/// Everything at once: M, A, a0 and p0 depend on place and time, in either direction.
#[test]
fn everything_rheonomic() {
    let energy = "#[kinetic_energy(m*(2 + sin(x*t))*powi(v1, 2)/2 + j*v1*v2*cos(y) + m*(1 + t*t)*powi(v2, 2)
        + v1*x*y*t - v2*sin(x + t) + x*x*y - t*y)] #[potential_energy(m*g*x*cos(y*t))]";
    exact(&format!(
        "#[coordinates(x, y)] #[speeds(v1, v2)]
         #[kinematics(v1 = (2 + t*x)*dot(x) + sin(y*t)*dot(y) + x*y - t, v2 = x*dot(x) - 3*y*dot(y) + cos(x*t))] {energy}"
    ));
    exact(&format!(
        "#[coordinates(x, y)] #[speeds(v1, v2)]
         #[kinematics(dot(x) = (2 + t*x)*v1 + sin(y*t)*v2 + x*y - t, dot(y) = x*v1 - 3*y*v2 + cos(x*t))] {energy}"
    ));
}

/// The listed forces add to those of the energies; where M and h* are given, the potential energy's are in h* already.
#[test]
fn forces_beside_the_energy() {
    let mut with =
        system(&format!("#[coordinates(x)] #[forces(-w*dot(x))] #[kinetic_energy(m*powi(dot(x), 2)/2)] {FIELDS}"));
    complete(&mut with, &mut AsIs);
    assert_eq!(with.graph.display(with.forces[0]), "-w*dot_x");
    let mut given =
        system(&format!("#[coordinates(x)] #[inertia(diag(m))] #[forces(0)] #[potential_energy(x)] {FIELDS}"));
    complete(&mut given, &mut AsIs);
    assert!(given.graph.is_zero(given.forces[0]));
}
