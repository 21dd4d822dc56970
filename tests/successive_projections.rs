//! Successive projections of the rolling disk against golden data: bodies → coordinates → rolling, every block to 1e-12.
//!
//! The first stage takes D and a_u that the derive emits for the disk on a smooth floor, or those of the data; the second one
//! those of the data, or a null space found at run time. The normal force of the smooth floor is not that of the rolling disk.

#[path = "models/rolling_disk.rs"]
mod models;
mod support;

use holonomy::forms::{InitialEquations, NullSpaceMethod, Stages};
use models::{RollingDiskInStages, SlidingDisk};
use nalgebra::{DMatrix, DVector};
use serde_json::Value;
use support::golden::{assert_close_at, list, numbers, parse};
use support::running::{Running, entries};

const GOLDEN: &str = include_str!("data/rolling_disk.json");

struct Case<'a>(&'a Value);

impl Case<'_> {
    fn get(&self, block: &str, name: &str) -> Vec<f64> {
        numbers(&self.0[block][name])
    }

    fn matrix(&self, block: &str, name: &str, rows: usize) -> DMatrix<f64> {
        let entries = self.get(block, name);
        DMatrix::from_row_slice(rows, entries.len() / rows, &entries)
    }

    fn vector(&self, block: &str, name: &str) -> DVector<f64> {
        DVector::from_vec(self.get(block, name))
    }

    fn params(&self) -> [f64; 4] {
        ["m", "r", "J", "g"].map(|p| self.0["params"][p].as_f64().expect("a number"))
    }

    /// The initial system of six velocities and all three rows.
    fn initial(&self) -> InitialEquations {
        let [m, r, j, g] = self.params();
        let disk = Running::new(RollingDiskInStages { m, r, j, g });
        let y = [self.get("nonholonomic", "q"), self.get("nonholonomic", "omega")].concat();
        disk.0.initial_equations_at(0.0, &disk.state(&y), &[])
    }

    fn close(&self, what: &str, computed: &[f64], expected: &[f64]) {
        let [m, _, _, g] = self.params();
        assert_close_at(what, computed, expected, 1e-12, g.max(m * g));
    }

    /// What must come out, however the stages were made.
    fn check(&self, full: &InitialEquations, stages: &Stages) {
        let multipliers = stages.multipliers().expect("a solution");
        let by_name = |name: &str| multipliers[full.rows.iter().position(|row| *row == name).expect("a row")];
        self.close("lambda_z_rolling", &[by_name("contact")], &self.get("nonholonomic", "lambda_z_rolling"));
        self.close("lambda", &["rolling_x", "rolling_y"].map(by_name), &self.get("nonholonomic", "lambda"));
        let natural = stages.natural_multipliers(0).expect("a solution");
        self.close("lambda_z_smooth", natural.as_slice(), &self.get("holonomic", "lambda_z_smooth"));
        let later = stages.natural_multipliers(1).expect("a solution");
        self.close("lambda of the last stage", later.as_slice(), &self.get("nonholonomic", "lambda"));
        let udot = self.vector("nonholonomic", "udot");
        let vdot = self.matrix("holonomic", "D", 5).tr_mul(&udot) + self.vector("holonomic", "a_u");
        self.close("vdot", stages.rates().expect("a solution").as_slice(), vdot.as_slice());
    }
}

fn cases(golden: &Value) -> impl Iterator<Item = Case<'_>> {
    list(&golden["cases"]).iter().map(Case)
}

fn by_rows(matrix: &DMatrix<f64>) -> Vec<f64> {
    matrix.transpose().as_slice().to_vec()
}

#[test]
fn both_stages_as_the_paper_makes_them() {
    let golden = parse(GOLDEN);
    for case in cases(&golden) {
        let full = case.initial();
        let (d, a) = (case.matrix("holonomic", "D", 5), case.vector("holonomic", "a_u"));
        let stages = full.stages().project(&["contact"], &d, &a).expect("the smooth floor");
        let smooth = stages.system();
        assert_eq!(smooth.rows, ["rolling_x", "rolling_y"]);
        case.close("M_d", &by_rows(&smooth.inertia), &case.get("holonomic", "M_d"));
        case.close("h_u", smooth.forces.as_slice(), &case.get("holonomic", "h_u"));
        case.close("u", smooth.velocities.as_slice(), &case.get("holonomic", "u"));
        case.close("C", &by_rows(&smooth.constraint_matrix), &case.get("nonholonomic", "C"));
        case.close("c0", smooth.constraint_bias.as_slice(), &case.get("nonholonomic", "c0"));
        let (d, a) = (case.matrix("nonholonomic", "D", 3), case.vector("nonholonomic", "a_omega"));
        let stages = stages.project(&["rolling_x", "rolling_y"], &d, &a).expect("rolling");
        let rolling = stages.system();
        case.close("M_omega", &by_rows(&rolling.inertia), &case.get("nonholonomic", "M_omega"));
        case.close("h_omega", rolling.forces.as_slice(), &case.get("nonholonomic", "h_omega"));
        case.close("omega", rolling.velocities.as_slice(), &case.get("nonholonomic", "omega"));
        case.close("qdot", &rolling.coordinate_rates().as_slice()[..2], &case.get("nonholonomic", "qdot")[..2]);
        case.check(&full, &stages);
    }
}

#[test]
fn the_derived_complement_and_null_spaces_at_run_time() {
    let golden = parse(GOLDEN);
    for case in cases(&golden) {
        let full = case.initial();
        let [m, r, j, g] = case.params();
        let sliding = Running::new(SlidingDisk { m, r, j, g });
        let s = sliding.state(&[case.get("holonomic", "q"), case.get("holonomic", "u")].concat());
        let d = sliding.0.complement_at(0.0, &s);
        let a = DVector::from_vec(entries(&sliding.0.complement_bias(0.0, &s)));
        for method in [NullSpaceMethod::Lu, NullSpaceMethod::Qr, NullSpaceMethod::Svd] {
            let first = full.stages().project(&["contact"], &d, &a).expect("the smooth floor");
            case.check(&full, &first.project_by(&["rolling_x", "rolling_y"], method).expect("rolling"));
            let first = full.stages().project_by(&["contact"], method).expect("the smooth floor");
            case.check(&full, &first.project_by(&["rolling_x", "rolling_y"], method).expect("rolling"));
        }
    }
}

#[test]
fn the_smooth_floor_carries_another_load_than_the_rolling_disk() {
    let golden = parse(GOLDEN);
    let apart = cases(&golden).filter(|case| {
        let (smooth, rolling) =
            (case.get("holonomic", "lambda_z_smooth")[0], case.get("nonholonomic", "lambda_z_rolling")[0]);
        (smooth - rolling).abs() > 1e-3 * rolling.abs()
    });
    assert!(apart.count() >= 8);
}
