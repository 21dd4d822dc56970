//! Motions of the rolling disk against golden data: a trajectory to t = 10, steady turning, the stability of straight rolling.

#[path = "models/rolling_disk.rs"]
mod models;
mod support;

use holonomy::ConstrainedSystem;
use models::{RollingDisk, RollingDiskInStages, RollingDiskOnFloor, RollingDiskSecondStage};
use serde_json::Value;
use support::golden::{assert_close, list, numbers, parse};
use support::running::Running;

const GOLDEN: &str = include_str!("data/rolling_disk.json");

/// How a formulation writes a state of the rolling disk and reads its reactions.
trait Formulation: ConstrainedSystem {
    fn with(params: [f64; 4]) -> Self;
    /// The state of q = (x, y, phi, theta, psi) and omega = (phi', theta', psi').
    fn state_of(q: &[f64], omega: &[f64]) -> Vec<f64>;
    /// q and omega of a state.
    fn read(y: &[f64]) -> (Vec<f64>, Vec<f64>);
    /// The ground's force on the disk in the inertial frame: along x, y, z.
    fn contact_force(disk: &Running<Self>, y: &[f64]) -> [f64; 3];
}

macro_rules! quasi_velocities {
    ($model:ident) => {
        impl Formulation for $model {
            fn with([m, r, j, g]: [f64; 4]) -> Self {
                Self { m, r, j, g }
            }
            fn state_of(q: &[f64], omega: &[f64]) -> Vec<f64> {
                let (sin, cos) = q[3].sin_cos();
                vec![q[0], q[1], 0.0, q[2], q[3], q[4], omega[2] + omega[0] * sin, omega[0] * cos, -omega[1]]
            }
            fn read(y: &[f64]) -> (Vec<f64>, Vec<f64>) {
                let (sin, cos) = y[4].sin_cos();
                let turning = y[7] / cos;
                (vec![y[0], y[1], y[3], y[4], y[5]], vec![turning, -y[8], y[6] - turning * sin])
            }
            fn contact_force(disk: &Running<Self>, y: &[f64]) -> [f64; 3] {
                let ((sp, cp), (st, ct)) = (y[3].sin_cos(), y[4].sin_cos());
                let [a, b, c] =
                    ["no_slip_along", "no_slip_across", "contact"].map(|name| disk.multiplier(name, 0.0, y));
                // A_1 of (6.2)
                [cp * a - st * sp * b + ct * sp * c, sp * a + st * cp * b - ct * cp * c, ct * b + st * c]
            }
        }
    };
}

macro_rules! generalised {
    ($model:ident, $normal:expr) => {
        impl Formulation for $model {
            fn with([m, r, j, g]: [f64; 4]) -> Self {
                Self { m, r, j, g }
            }
            fn state_of(q: &[f64], omega: &[f64]) -> Vec<f64> {
                q.iter().chain(omega).copied().collect()
            }
            fn read(y: &[f64]) -> (Vec<f64>, Vec<f64>) {
                (y[..5].to_vec(), y[5..].to_vec())
            }
            fn contact_force(disk: &Running<Self>, y: &[f64]) -> [f64; 3] {
                let [x, y_force] = ["rolling_x", "rolling_y"].map(|name| disk.multiplier(name, 0.0, y));
                [x, y_force, $normal(disk, y)]
            }
        }
    };
}

quasi_velocities!(RollingDisk);
quasi_velocities!(RollingDiskOnFloor);
generalised!(RollingDiskInStages, |disk: &Running<RollingDiskInStages>, y: &[f64]| disk.multiplier("contact", 0.0, y));
// The second stage by itself has no normal force among its rows: N = m g − m r (theta'' sin + theta'^2 cos).
generalised!(RollingDiskSecondStage, |disk: &Running<RollingDiskSecondStage>, y: &[f64]| {
    let RollingDiskSecondStage { m, r, g, .. } = *disk.0.system();
    let (sin, cos) = y[3].sin_cos();
    m * g - m * r * (disk.accelerations(0.0, y)[1] * sin + y[6] * y[6] * cos)
});

fn params(block: &Value) -> [f64; 4] {
    ["m", "r", "J", "g"].map(|p| block["params"][p].as_f64().expect("a number"))
}

/// Runs a formulation through the states of a golden motion and compares everything that is told there.
fn follows<M: Formulation>(block: &Value, tolerance: f64) {
    let disk = Running::new(M::with(params(block)));
    let golden = list(&block["states"]);
    let times: Vec<f64> = golden.iter().map(|state| state["t"].as_f64().expect("a time")).collect();
    let start = M::state_of(&numbers(&golden[0]["q"]), &numbers(&golden[0]["omega"]));
    let run = disk.run(&start, &times, 0.05);
    for (step, (y, expected)) in run.iter().zip(golden).enumerate() {
        let (q, omega) = M::read(y);
        let told = |name: &str| {
            if expected[name].is_null() { &block[name] } else { &expected[name] }
        };
        let close = |name: &str, computed: &[f64]| {
            if !told(name).is_null() {
                assert_close(
                    &format!("{} {name} at {}", M::MODEL.name, expected["t"]),
                    computed,
                    &numbers(told(name)),
                    tolerance,
                );
            }
        };
        close("q", &q);
        close("omega", &omega);
        close("energy", &[disk.energy(0.0, y)]);
        let [x, y_force, z] = M::contact_force(&disk, y);
        close("lambda_z_rolling", &[z]);
        // the horizontal reaction of a steady turn is told once, for its start
        if step == 0 || !expected["lambda"].is_null() {
            close("lambda", &[x, y_force]);
        }
        if !expected["v"].is_null() && M::MODEL.velocities.len() == 6 {
            close("v", &disk.velocities(0.0, y));
        }
    }
}

#[test]
fn every_formulation_follows_the_trajectory() {
    let golden = parse(GOLDEN);
    follows::<RollingDisk>(&golden["trajectory"], 1e-9);
    follows::<RollingDiskOnFloor>(&golden["trajectory"], 1e-9);
    follows::<RollingDiskInStages>(&golden["trajectory"], 1e-9);
    follows::<RollingDiskSecondStage>(&golden["trajectory"], 1e-9);
}

#[test]
fn every_formulation_turns_steadily() {
    let golden = parse(GOLDEN);
    follows::<RollingDisk>(&golden["steady_turning"], 1e-9);
    follows::<RollingDiskOnFloor>(&golden["steady_turning"], 1e-9);
    follows::<RollingDiskInStages>(&golden["steady_turning"], 1e-9);
    follows::<RollingDiskSecondStage>(&golden["steady_turning"], 1e-9);
}

/// The square of the only pair of eigenvalues ±L that is not zero: half the trace of the squared Jacobian.
fn eigenvalue_squared<M: Formulation>(params: [f64; 4], q: &[f64], omega: &[f64]) -> f64 {
    let disk = Running::new(M::with(params));
    let jacobian = disk.jacobian(0.0, &M::state_of(q, omega));
    (&jacobian * &jacobian).trace() / 2.0
}

fn stability<M: Formulation>(golden: &Value) {
    let block = &golden["straight_rolling_stability"];
    for row in list(&block["rows"]) {
        let omega = [0.0, 0.0, row["psidot"].as_f64().expect("a rate")];
        let squared = eigenvalue_squared::<M>(params(block), &[0.0; 5], &omega);
        // on the threshold the two terms of L² cancel: m g r/(m r² + J) is their size
        let [m, r, j, g] = params(block);
        let expected = row["eigenvalue_squared"].as_f64().expect("L²");
        let scale = expected.abs().max(m * g * r / (m * r * r + j));
        assert!((squared - expected).abs() <= 1e-12 * scale, "{}: {squared} instead of {expected}", M::MODEL.name);
    }
    let block = &golden["steady_turning"];
    let start = &list(&block["states"])[0];
    let squared = eigenvalue_squared::<M>(params(block), &numbers(&start["q"]), &numbers(&start["omega"]));
    assert_close(M::MODEL.name, &[squared], &numbers(&block["eigenvalue_squared"]), 1e-12);
}

#[test]
fn every_formulation_has_the_eigenvalues() {
    let golden = parse(GOLDEN);
    stability::<RollingDisk>(&golden);
    stability::<RollingDiskOnFloor>(&golden);
    stability::<RollingDiskInStages>(&golden);
    stability::<RollingDiskSecondStage>(&golden);
}
