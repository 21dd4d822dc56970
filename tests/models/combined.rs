//! Independent speeds that are combinations: body-fixed ones on top of rates, in several charts, below nonlinear rows.
#![allow(dead_code, missing_docs, reason = "each test file runs its own models; fields are named as in the source")]
#![allow(clippy::duplicated_attributes, reason = "clippy takes the masses of `diag(m, m)` for attributes")]

use holonomy::ConstrainedSystem;

/// The rolling disc of `rolling_disc.rs` in rates alone: T gives the inertia terms, and the angular velocity of the disc in its
/// leaned frame, Kane's speeds, is a combination of the rates.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(cx, cy, cz, yaw, lean, spin)]
#[define(about = dot(spin) + dot(yaw)*sin(lean), across = dot(yaw)*cos(lean))]
#[kinetic_energy(
    m/2*(powi(dot(cx), 2) + powi(dot(cy), 2) + powi(dot(cz), 2))
        + (d*powi(dot(lean), 2) + a*powi(about, 2) + d*powi(across, 2))/2
)]
#[potential_energy(m*g*cz)]
#[constraint(height: cz == r*cos(lean))]
#[constraint(slip_x: dot(cx) - r*(about*cos(yaw) + dot(lean)*sin(yaw)*cos(lean)) == 0)]
#[constraint(slip_y: dot(cy) - r*(about*sin(yaw) - dot(lean)*cos(yaw)*cos(lean)) == 0)]
#[constraint(slip_z: dot(cz) + r*dot(lean)*sin(lean) == 0)]
#[independent(
    w1 = dot(lean),
    w2 = about,
    /// about the line from the contact to the centre
    w3 = across,
)]
pub struct DiscByRates {
    #[nominal(2.0)]
    pub m: f64,
    #[nominal(0.5)]
    pub r: f64,
    #[nominal(9.81)]
    pub g: f64,
    #[nominal(0.125)]
    pub d: f64,
    #[nominal(0.25)]
    pub a: f64,
}

/// A spherical pendulum by its turning about an axis and its speed along it: two such charts cover the sphere, each regular but
/// at the poles of its axis.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, -m*g)]
#[potential_energy(m*g*z)]
#[constraint(rod: (powi(x, 2) + powi(y, 2) + powi(z, 2) - powi(l, 2))/2 == 0)]
#[independent(turn = (x*dot(y) - y*dot(x))/l, dot(z))]
#[independent(roll = (y*dot(z) - z*dot(y))/l, dot(x))]
pub struct SphericalByTurning {
    #[nominal(1.3)]
    pub m: f64,
    #[nominal(0.8)]
    pub l: f64,
    #[nominal(9.81)]
    pub g: f64,
}

/// A blade that is turned the slower the faster it goes: a row that is not linear, in the speeds along the blade and about it,
/// beside one that is. The table moves under it, so that all of them have parts of their own.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, phi)]
#[define(along = (dot(x) - drift*cos(t))*cos(phi) + dot(y)*sin(phi))]
#[inertia(diag(m, m, i))]
#[forces(m*g*tilt, 0, 0)]
#[constraint(blade: dot(y)*cos(phi) - (dot(x) - drift*cos(t))*sin(phi) == 0)]
#[constraint(paced: along*dot(phi) == pace)]
#[independent(u = along, o = dot(phi))]
pub struct PacedBlade {
    #[nominal(1.1)]
    pub m: f64,
    #[nominal(0.4)]
    pub i: f64,
    #[nominal(9.81)]
    pub g: f64,
    #[nominal(0.1)]
    pub tilt: f64,
    #[nominal(0.3)]
    pub drift: f64,
    #[nominal(0.7)]
    pub pace: f64,
}

/// A particle on a turning ring by quasi-velocities of a configuration, its state by a rate that the configuration gives: no
/// carrier, but a combination of them under its own name.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(-k*dot(x), -k*dot(y), -m*g)]
#[configuration(
    of(a, b),
    x = l*sin(a)*cos(b + w*t),
    y = l*sin(a)*sin(b + w*t),
    z = -l*cos(a),
    speeds(p, q),
    dot(a) = p/l,
    dot(b) = q/(l*sin(a)) - w,
)]
#[constraint(rod: (powi(x, 2) + powi(y, 2) + powi(z, 2) - powi(l, 2))/2 == 0)]
#[independent(dot(z), swing = 2*q + cos(a)*p + t)]
#[independent(p, q)]
pub struct SwungParticle {
    #[nominal(1.2)]
    pub m: f64,
    #[nominal(9.81)]
    pub g: f64,
    #[nominal(0.9)]
    pub l: f64,
    #[nominal(0.6)]
    pub k: f64,
    #[nominal(0.5)]
    pub w: f64,
}
