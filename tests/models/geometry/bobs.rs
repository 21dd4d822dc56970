//! Chains of equal pendulums by families: absolute angles from the vertical.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]

use holonomy::ConstrainedSystem;

/// Three of them by their angles; the tension of a link carries what hangs on it.
#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 3)]
#[coordinates(a[n])]
#[frame(L[i] = rotate(N, z, a[i]) for i in 0..n)]
#[point(P[0] = O - l*L[0].y, P[i] = P[i - 1] - l*L[i].y for i in 1..n)]
#[particle(bob[i] = { at: P[i], mass: m } for i in 0..n)]
#[gravity(-g*N.y)]
#[output(
    tension[i] = m*dot(sum(i..n, |j| acceleration(P[j]) + g*N.y), L[i].y) for i in 0..n,
)]
pub struct ThreeBobs {
    #[nominal(0.5)]
    pub m: f64,
    #[nominal(0.2)]
    pub l: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// Ten of them by their angles; the tension of a link carries what hangs on it.
#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 10)]
#[coordinates(a[n])]
#[frame(L[i] = rotate(N, z, a[i]) for i in 0..n)]
#[point(P[0] = O - l*L[0].y, P[i] = P[i - 1] - l*L[i].y for i in 1..n)]
#[particle(bob[i] = { at: P[i], mass: m } for i in 0..n)]
#[gravity(-g*N.y)]
#[output(
    tension[i] = m*dot(sum(i..n, |j| acceleration(P[j]) + g*N.y), L[i].y) for i in 0..n,
)]
pub struct TenBobs {
    #[nominal(0.5)]
    pub m: f64,
    #[nominal(0.2)]
    pub l: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// Twenty of them by their angles; the tension of a link carries what hangs on it.
#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 20)]
#[coordinates(a[n])]
#[frame(L[i] = rotate(N, z, a[i]) for i in 0..n)]
#[point(P[0] = O - l*L[0].y, P[i] = P[i - 1] - l*L[i].y for i in 1..n)]
#[particle(bob[i] = { at: P[i], mass: m } for i in 0..n)]
#[gravity(-g*N.y)]
#[output(
    tension[i] = m*dot(sum(i..n, |j| acceleration(P[j]) + g*N.y), L[i].y) for i in 0..n,
)]
pub struct TwentyBobs {
    #[nominal(0.5)]
    pub m: f64,
    #[nominal(0.2)]
    pub l: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// Three of them in the plane, the links as constraints: their tensions are reactions.
#[derive(ConstrainedSystem, Clone, Debug)]
#[size(n = 3)]
#[coordinates(x[n], y[n])]
#[point(P[i] = O + x[i]*N.x + y[i]*N.y for i in 0..n)]
#[particle(bob[i] = { at: P[i], mass: m } for i in 0..n)]
#[gravity(-g*N.y)]
#[constraint(link[0]: norm(P[0]) == l, link[i]: norm(P[i] - P[i - 1]) == l for i in 1..n)]
#[independent(dot(x[i]) for i in 0..n)]
#[start(x[0] = 0.1, x[1] = 0.2, x[2] = 0.3, y[0] = -0.17, y[1] = -0.34, y[2] = -0.51)]
pub struct ThreeTiedBobs {
    #[nominal(0.5)]
    pub m: f64,
    #[nominal(0.2)]
    pub l: f64,
    #[nominal(9.81)]
    pub g: f64,
}
