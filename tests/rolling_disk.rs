//! The rolling disk in its three formulations against golden data in 30 digits: every block, relative error at most 1e-12.
//!
//! The states are well conditioned: |theta| stays below 1.27, so cos(theta), the pivot of the kinematics, is at least 0.29.

#[path = "models/rolling_disk.rs"]
mod models;
mod support;

use models::{RollingDisk, RollingDiskInStages, RollingDiskOnFloor, RollingDiskSecondStage, SlidingDisk};
use nalgebra::{DMatrix, DVector};
use serde_json::Value;
use support::golden::{assert_close_at, list, numbers, parse};
use support::running::{Running, by_rows, dense, entries};

const GOLDEN: &str = include_str!("data/rolling_disk.json");
const TOLERANCE: f64 = 1e-12;

/// The parameters of a case and the golden numbers of one of its blocks.
struct Block<'a> {
    params: [f64; 4],
    golden: &'a Value,
}

impl<'a> Block<'a> {
    fn of(case: &'a Value, name: &str) -> Option<Self> {
        let params = ["m", "r", "J", "g"].map(|p| case["params"][p].as_f64().expect("a number"));
        Some(Self { params, golden: &case[name] }).filter(|block| !block.golden.is_null())
    }

    fn get(&self, name: &str) -> Vec<f64> {
        numbers(&self.golden[name])
    }

    /// Where everything cancels, accelerations are compared at the scale of g and forces at the scale of m g.
    fn close_to(&self, what: &str, computed: &[f64], expected: &[f64]) {
        let [m, _, _, g] = self.params;
        assert_close_at(what, computed, expected, TOLERANCE, g.max(m * g));
    }

    fn close(&self, name: &str, computed: &[f64]) {
        self.close_to(name, computed, &self.get(name));
    }
}

fn blocks<'a>(golden: &'a Value, names: &'a [&'a str]) -> impl Iterator<Item = Block<'a>> {
    list(&golden["cases"]).iter().flat_map(move |case| names.iter().filter_map(move |name| Block::of(case, name)))
}

macro_rules! disk {
    ($model:ident, $params:expr) => {{
        let [m, r, j, g] = $params;
        Running::new($model { m, r, j, g })
    }};
}

/// The state of formulation a: all coordinates, then v6, v5, v4.
fn quasi_state(x: &[f64], v: &[f64]) -> Vec<f64> {
    x.iter().copied().chain([v[5], v[4], v[3]]).collect()
}

#[test]
fn formulation_a_on_the_rolling_manifold() {
    let golden = parse(GOLDEN);
    for block in blocks(&golden, &["quasi"]) {
        let disk = disk!(RollingDisk, block.params);
        let (x, v) = (block.get("x"), block.get("v"));
        let y = quasi_state(&x, &v);
        let s = disk.state(&y);
        block.close("x", &disk.coordinates(0.0, &y));
        block.close("v", &disk.velocities(0.0, &y));
        block.close("xdot", &disk.rate(0.0, &y)[..6]);
        let vdot = block.get("vdot");
        block.close_to("udot", &disk.rate(0.0, &y)[6..], &[vdot[5], vdot[4], vdot[3]]);
        block.close_to("udot", &disk.accelerations(0.0, &y), &[vdot[5], vdot[4], vdot[3]]);
        block.close("vdot", &disk.velocity_rates(0.0, &y));
        block.close("lambda", &disk.multipliers(0.0, &y));
        block.close("D", &by_rows(&disk.0.complement(0.0, &s)));
        let r: Vec<f64> = ["no_slip_along", "no_slip_across", "contact"]
            .iter()
            .flat_map(|name| entries(&disk.0.reactions(0.0, &s, &[]).get(name).expect("a reaction")))
            .collect();
        block.close("r", &r);
        // A_1 λ: the ground's force on the disk in the inertial frame
        let a = dense(&disk.0.kinematic_matrix(0.0, &disk.0.coordinates(0.0, &s)));
        let force = a.view((0, 0), (3, 3)) * DVector::from_vec(disk.multipliers(0.0, &y));
        block.close("contact_force_inertial", force.as_slice());
    }
}

#[test]
fn formulation_a_at_any_velocities() {
    let golden = parse(GOLDEN);
    for block in blocks(&golden, &["quasi", "quasi_free"]) {
        let disk = disk!(RollingDisk, block.params).0;
        let (x, v) = (block.get("x"), block.get("v"));
        let (x, v) =
            (std::array::from_fn(|i| x[i]), models::RollingDiskVelocities::from(std::array::from_fn(|i| v[i])));
        let a = dense(&disk.kinematic_matrix(0.0, &x));
        block.close("A", a.transpose().as_slice());
        block.close("B", a.clone().try_inverse().expect("regular").transpose().as_slice());
        block.close_to("a0", &entries(&disk.kinematic_bias(0.0, &x)), &[0.0; 6]);
        let (m, h) = (dense(&disk.inertia(0.0, &x)), DVector::from_vec(entries(&disk.forces(0.0, &x, &v, &[]))));
        block.close("M", m.transpose().as_slice());
        block.close("h", h.as_slice());
        let (c, c0) = (dense(&disk.constraint_matrix(0.0, &x, &v)), entries(&disk.constraint_bias(0.0, &x, &v)));
        block.close("C", c.transpose().as_slice());
        block.close("c0", &c0);
        // (3.5) and (3.6) from what was emitted: they hold off the rolling manifold as well
        let d = DMatrix::from_row_slice(3, 6, &block.get("D"));
        let matrix = DMatrix::from_rows(
            &c.row_iter().chain((d.clone() * &m).row_iter()).map(|r| r.into_owned()).collect::<Vec<_>>(),
        );
        let right = DVector::from_iterator(6, c0.iter().map(|c0| -c0).chain((d * &h).iter().copied()));
        let vdot = matrix.lu().solve(&right).expect("regular");
        block.close("vdot", vdot.as_slice());
        let lambda = (&c * c.transpose()).lu().solve(&(&c * (m * vdot - h))).expect("independent rows");
        block.close("lambda", lambda.as_slice());
    }
}

#[test]
fn a_merged_height_adds_no_row() {
    let golden = parse(GOLDEN);
    for block in blocks(&golden, &["quasi"]) {
        let disk = disk!(RollingDiskOnFloor, block.params);
        let y = quasi_state(&block.get("x"), &block.get("v"));
        block.close("vdot", &disk.velocity_rates(0.0, &y));
        block.close("D", &by_rows(&disk.0.complement(0.0, &disk.state(&y))));
        let names = ["no_slip_along", "no_slip_across", "contact"];
        block.close("lambda", &names.map(|name| disk.multiplier(name, 0.0, &y)));
        block.close_to("f", &entries(&disk.0.position_residual_at(0.0, &disk.state(&y))), &[0.0]);
        assert_eq!(
            disk.0
                .constraint_bias(
                    0.0,
                    &disk.0.coordinates(0.0, &disk.state(&y)),
                    &disk.0.velocities(0.0, &disk.state(&y))
                )
                .len(),
            3
        );
    }
}

#[test]
fn formulation_b_on_a_smooth_floor() {
    let golden = parse(GOLDEN);
    for block in blocks(&golden, &["holonomic", "holonomic_free"]) {
        let disk = disk!(SlidingDisk, block.params);
        let y: Vec<f64> = block.get("q").into_iter().chain(block.get("u")).collect();
        let s = disk.state(&y);
        let (x, v) = (disk.0.coordinates(0.0, &s), disk.0.velocities(0.0, &s));
        block.close("v", &disk.velocities(0.0, &y));
        block.close("D", &by_rows(&disk.0.complement(0.0, &s)));
        block.close("a_u", &entries(&disk.0.complement_bias(0.0, &s)));
        block.close("M_d", &by_rows(&disk.0.mass_matrix(0.0, &s)));
        block.close("h_u", &disk.forcing(0.0, &y));
        block.close("udot", &disk.accelerations(0.0, &y));
        block.close_to("qdot", &disk.rate(0.0, &y)[..5], &block.get("u"));
        block.close("C", &by_rows(&disk.0.constraint_matrix(0.0, &x, &v)));
        block.close("c0", &entries(&disk.0.constraint_bias(0.0, &x, &v)));
        block.close("lambda_z_smooth", &[disk.multiplier("contact", 0.0, &y)]);
        block.close("r", disk.reaction(0.0, &y).as_slice());
    }
}

/// The rows of formulation c: what both the two stages in one model and the second stage by itself must give.
macro_rules! second_stage {
    ($block:expr, $disk:expr, $y:expr) => {{
        let (block, disk, y) = (&$block, &$disk, &$y);
        let s = disk.state(y);
        block.close("M_omega", &by_rows(&disk.0.mass_matrix(0.0, &s)));
        block.close("h_omega", &disk.forcing(0.0, y));
        block.close("omegadot", &disk.accelerations(0.0, y));
        block.close("qdot", &disk.rate(0.0, y)[..5]);
        block.close("lambda", &["rolling_x", "rolling_y"].map(|name| disk.multiplier(name, 0.0, y)));
        block.close("energy", &[disk.energy(0.0, y)]);
    }};
}

#[test]
fn formulation_c_in_two_stages() {
    let golden = parse(GOLDEN);
    for case in list(&golden["cases"]) {
        let (block, first) = (Block::of(case, "nonholonomic").expect("c"), Block::of(case, "holonomic").expect("b"));
        let disk = disk!(RollingDiskInStages, block.params);
        let y: Vec<f64> = block.get("q").into_iter().chain(block.get("omega")).collect();
        let s = disk.state(&y);
        second_stage!(block, disk, y);
        block.close("lambda_z_rolling", &[disk.multiplier("contact", 0.0, &y)]);
        first.close("v", &disk.velocities(0.0, &y));
        // in the initial space D is the product of both stages' complements
        let d = DMatrix::from_row_slice(3, 5, &block.get("D")) * DMatrix::from_row_slice(5, 6, &first.get("D"));
        block.close_to("D", &by_rows(&disk.0.complement(0.0, &s)), d.transpose().as_slice());
        let udot = DVector::from_vec(block.get("udot"));
        let vdot =
            DMatrix::from_row_slice(5, 6, &first.get("D")).transpose() * udot + DVector::from_vec(first.get("a_u"));
        block.close_to("vdot", &disk.velocity_rates(0.0, &y), vdot.as_slice());
    }
}

#[test]
fn formulation_c_second_stage_by_itself() {
    let golden = parse(GOLDEN);
    for case in list(&golden["cases"]) {
        let (block, first) = (Block::of(case, "nonholonomic").expect("c"), Block::of(case, "holonomic").expect("b"));
        let disk = disk!(RollingDiskSecondStage, block.params);
        let y: Vec<f64> = block.get("q").into_iter().chain(block.get("omega")).collect();
        let s = disk.state(&y);
        let (x, v) = (disk.0.coordinates(0.0, &s), disk.0.velocities(0.0, &s));
        second_stage!(block, disk, y);
        block.close("u", &disk.velocities(0.0, &y));
        block.close("udot", &disk.velocity_rates(0.0, &y));
        block.close("D", &by_rows(&disk.0.complement(0.0, &s)));
        block.close("a_omega", &entries(&disk.0.complement_bias(0.0, &s)));
        block.close("C", &by_rows(&disk.0.constraint_matrix(0.0, &x, &v)));
        block.close("c0", &entries(&disk.0.constraint_bias(0.0, &x, &v)));
        first.close("M_d", &by_rows(&disk.0.inertia(0.0, &x)));
        first.close("h_u", &entries(&disk.0.forces(0.0, &x, &v, &[])));
        if let Some(free) = Block::of(case, "holonomic_free") {
            let (q, u) = (free.get("q"), free.get("u"));
            let v = models::RollingDiskSecondStageVelocities::from(std::array::from_fn(|i| u[i]));
            free.close("h_u", &entries(&disk.0.forces(0.0, &std::array::from_fn(|i| q[i]), &v, &[])));
        }
    }
}
