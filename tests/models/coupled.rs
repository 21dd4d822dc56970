//! Loops that can only be closed together.
#![allow(missing_docs, reason = "fields are named as in the source")]
#![allow(clippy::duplicated_attributes, reason = "clippy takes the weights of the forces for attributes")]

use holonomy::ConstrainedSystem;

/// A six-bar linkage by the absolute angles of its bars: a crank and three bars close one loop, a further bar between the
/// second and the fourth closes another. Neither loop determines its own three angles, so that all four rows are one block.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(q1, q2, q3, q4, q5)]
#[inertia(diag(j1, j2, j3, j4, j5))]
#[forces(tau - w1*cos(q1), -w2*cos(q2), -w3*cos(q3), -w4*cos(q4), -w5*cos(q5))]
#[potential_energy(w1*sin(q1) + w2*sin(q2) + w3*sin(q3) + w4*sin(q4) + w5*sin(q5) - tau*q1)]
#[constraint(outer_x: l1*cos(q1) + l2*cos(q2) + l3*cos(q3) + l4*cos(q4) == d)]
#[constraint(outer_y: l1*sin(q1) + l2*sin(q2) + l3*sin(q3) + l4*sin(q4) == 0)]
#[constraint(inner_x: l1*cos(q1) + a*cos(q2) + l5*cos(q5) + b*cos(q4) == d)]
#[constraint(inner_y: l1*sin(q1) + a*sin(q2) + l5*sin(q5) + b*sin(q4) == 0)]
#[independent(dot(q1))]
#[start(q1 = 1.2, q2 = 0.5, q3 = -0.6, q4 = -1.3, q5 = -0.1)]
pub struct SixBar {
    #[nominal(0.5)]
    pub l1: f64,
    #[nominal(1.2)]
    pub l2: f64,
    #[nominal(1.1)]
    pub l3: f64,
    #[nominal(1.3)]
    pub l4: f64,
    #[nominal(1.4)]
    pub l5: f64,
    #[nominal(0.5)]
    pub a: f64,
    #[nominal(0.6)]
    pub b: f64,
    #[nominal(2)]
    pub d: f64,
    #[nominal(0.3)]
    pub j1: f64,
    #[nominal(0.4)]
    pub j2: f64,
    #[nominal(0.5)]
    pub j3: f64,
    #[nominal(0.6)]
    pub j4: f64,
    #[nominal(0.7)]
    pub j5: f64,
    #[nominal(5)]
    pub w1: f64,
    #[nominal(6)]
    pub w2: f64,
    #[nominal(7)]
    pub w3: f64,
    #[nominal(8)]
    pub w4: f64,
    #[nominal(9)]
    pub w5: f64,
    #[nominal(2)]
    pub tau: f64,
}
