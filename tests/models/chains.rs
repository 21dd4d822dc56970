//! Chains of equal pendulums by families: Cartesian coordinates by the links' absolute angles, the links kept for their tensions.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]

use holonomy::ConstrainedSystem;

/// Ten of them.
#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 10)]
#[coordinates(x[n], y[n])]
#[inertia(diag(m for i in 0..2*n))]
#[forces(0 for i in 0..n, -m*g for i in 0..n)]
#[potential_energy(m*g*sum(0..n, |i| y[i]))]
#[configuration(
    of(a[n]),
    x[i] = l*sum(0..=i, |j| sin(a[j])) for i in 0..n,
    y[i] = -l*sum(0..=i, |j| cos(a[j])) for i in 0..n,
)]
#[constraint(link[0]: (powi(x[0], 2) + powi(y[0], 2) - powi(l, 2))/2 == 0)]
#[constraint(link[i]: (powi(x[i] - x[i - 1], 2) + powi(y[i] - y[i - 1], 2) - powi(l, 2))/2 == 0 for i in 1..n)]
pub struct TenPendulums {
    #[nominal(0.5)]
    pub m: f64,
    #[nominal(0.2)]
    pub l: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// Twenty of them.
#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 20)]
#[coordinates(x[n], y[n])]
#[inertia(diag(m for i in 0..2*n))]
#[forces(0 for i in 0..n, -m*g for i in 0..n)]
#[potential_energy(m*g*sum(0..n, |i| y[i]))]
#[configuration(
    of(a[n]),
    x[i] = l*sum(0..=i, |j| sin(a[j])) for i in 0..n,
    y[i] = -l*sum(0..=i, |j| cos(a[j])) for i in 0..n,
)]
#[constraint(link[0]: (powi(x[0], 2) + powi(y[0], 2) - powi(l, 2))/2 == 0)]
#[constraint(link[i]: (powi(x[i] - x[i - 1], 2) + powi(y[i] - y[i - 1], 2) - powi(l, 2))/2 == 0 for i in 1..n)]
pub struct TwentyPendulums {
    #[nominal(0.5)]
    pub m: f64,
    #[nominal(0.2)]
    pub l: f64,
    #[nominal(9.81)]
    pub g: f64,
}
