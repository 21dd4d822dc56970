//! Golden motions through the runtime's own integrators: the rolling disk in its three formulations, the sleigh, the knife edge.
//!
//! What the emitted functions give at a state is tested elsewhere; here `simulate` runs them, `every` and `at` read the motion off,
//! and the position row of the first formulation is restored after each step.

#[path = "models/blades.rs"]
mod blades;
#[path = "../examples/rolling_disk/models.rs"]
mod disks;
mod support;

use blades::{KnifeEdge, KnifeEdgeState, Sleigh, SleighInPlane, SleighInPlaneState, SleighState};
use disks::{FloorDisk, FloorDiskInputs, FloorDiskState, RollingDisk, RollingDiskState, StagedDisk, StagedDiskState};
use holonomy::prelude::*;
use holonomy::{State, Trajectory};
use serde_json::Value;
use support::golden::{case, list, numbers, parse, picked};
use support::running::entries;

const DISK: &str = include_str!("data/rolling_disk.json");
const SLEIGH: &str = include_str!("data/chaplygin_sleigh.json");

/// A method, its relative and absolute tolerance per step, and what it must hold at the end of a motion.
type Run = (Method, f64, f64);

/// The methods and what their orders allow in 10 s, in units of the larger of one and the figure.
const RUNS: [Run; 3] = [
    (Method::Dop853, 1e-13, 1e-10),
    (Method::DormandPrince, 1e-12, 1e-9),
    // the error of order 4 is proportional to the fourth power of the step, see the last test
    (Method::Rk4 { step: 1e-3 }, 1e-13, 1e-8),
];

/// Every figure within `bound` times the larger of one and its size; gives the largest error.
fn near(place: &str, computed: &[f64], expected: &[f64], bound: f64) -> f64 {
    assert_eq!(computed.len(), expected.len(), "{place}: number of figures");
    let mut worst = 0.0_f64;
    for (i, (c, e)) in computed.iter().zip(expected).enumerate() {
        let error = (c - e).abs() / e.abs().max(1.0);
        assert!(error <= bound, "{place} [{i}]: {c} instead of {e}, off by {error:e}");
        worst = worst.max(error);
    }
    worst
}

fn params(block: &Value, names: [&str; 4]) -> [f64; 4] {
    names.map(|p| block[p].as_f64().expect("a number"))
}

/// q and omega.
type Figures = ([f64; 5], [f64; 3]);

/// One formulation of the disk: its states from q = (x, y, phi, theta, psi) and omega = (phi', theta', psi'), and back.
struct Formulation<M: ConstrainedSystem> {
    disk: Prepared<M>,
    state: fn(&[f64], &[f64]) -> State<M>,
    read: fn(&State<M>) -> Figures,
}

impl<M: ConstrainedSystem> Formulation<M> {
    /// Runs a golden motion and compares what is told of its states.
    fn follows(&self, block: &Value, (method, tolerance, bound): Run, run: impl Fn(State<M>, f64) -> Trajectory<M>) {
        let golden = list(&block["states"]);
        let end = golden.last().map(|state| state["t"].as_f64().expect("a time")).expect("a state");
        let first = (self.state)(&numbers(&golden[0]["q"]), &numbers(&golden[0]["omega"]));
        let trajectory = run(first, end);
        let mut worst = 0.0_f64;
        for expected in golden {
            let t = expected["t"].as_f64().expect("a time");
            let s = trajectory.at(t).expect("the motion covers the time");
            let (q, omega) = (self.read)(&s);
            let place = |what: &str| format!("{} by {method:?}: {what} at {t}", M::MODEL.name);
            let mut close = |what: &str, computed: &[f64], expected: &Value| {
                if !expected.is_null() {
                    worst = worst.max(near(&place(what), computed, &numbers(expected), bound));
                }
            };
            close("q", &q, &expected["q"]);
            close("omega", &omega, &expected["omega"]);
            close("v", &entries(&self.disk.velocities(t, &s)), &expected["v"]);
            close("energy", &[self.disk.energy(t, &s)], &expected["energy"]);
            // the contact point stays on the floor, and rolls
            near(&place("f"), &entries(&self.disk.position_residual_at(t, &s)), &[0.0], bound);
        }
        let taken = trajectory.statistics();
        println!(
            "{:12} {method:?} {tolerance:.0e}: {} steps, largest error {worst:.1e}",
            M::MODEL.name,
            taken.accepted
        );
    }
}

fn rolling([m, r, j, g]: [f64; 4]) -> Formulation<RollingDisk> {
    Formulation {
        disk: RollingDisk { m, r, j, g }.prepare().expect("the parameters are good"),
        state: |q, omega| {
            let (sin, cos) = q[3].sin_cos();
            RollingDiskState {
                x: q[0],
                y: q[1],
                z: 0.0,
                phi: q[2],
                theta: q[3],
                psi: q[4],
                v6: omega[2] + omega[0] * sin,
                v5: omega[0] * cos,
                v4: -omega[1],
            }
        },
        read: |s| {
            let (sin, cos) = s.theta.sin_cos();
            let turning = s.v5 / cos;
            ([s.x, s.y, s.phi, s.theta, s.psi], [turning, -s.v4, s.v6 - turning * sin])
        },
    }
}

fn staged([m, r, j, g]: [f64; 4]) -> Formulation<StagedDisk> {
    Formulation {
        disk: StagedDisk { m, r, j, g }.prepare().expect("the parameters are good"),
        state: |q, omega| StagedDiskState::from([q[0], q[1], q[2], q[3], q[4], omega[0], omega[1], omega[2]]),
        read: |s| ([s.x, s.y, s.phi, s.theta, s.psi], [s.dot_phi, s.dot_theta, s.dot_psi]),
    }
}

/// The disk on a smooth floor; it rolls where its lowest point starts at rest and the forces of rolling act on it.
fn on_the_floor([m, r, j, g]: [f64; 4]) -> Formulation<FloorDisk> {
    Formulation {
        disk: FloorDisk { m, r, j, g }.prepare().expect("the parameters are good"),
        // x' = -r psi' cos phi, y' = -r psi' sin phi (6.1a), (6.1b); r is 0.5 in all golden motions
        state: |q, omega| {
            let (sin, cos) = q[2].sin_cos();
            let slip = -0.5 * omega[2];
            FloorDiskState::from([q[0], q[1], q[2], q[3], q[4], slip * cos, slip * sin, omega[0], omega[1], omega[2]])
        },
        read: |s| ([s.x, s.y, s.phi, s.theta, s.psi], [s.dot_phi, s.dot_theta, s.dot_psi]),
    }
}

#[test]
fn the_disk_follows_its_trajectories_in_every_formulation() {
    let golden = parse(DISK);
    for name in ["trajectory", "steady_turning"] {
        let block = &golden[name];
        let params = params(&block["params"], ["m", "r", "J", "g"]);
        assert_eq!(params[1], 0.5, "the radius that the smooth floor is told");
        let (rolling, staged, floor) = (rolling(params), staged(params), on_the_floor(params));
        // λ of the staged disk are the floor's forces at the lowest point
        let friction = |_: f64, s: &FloorDiskState| {
            let same = StagedDiskState::from([s.x, s.y, s.phi, s.theta, s.psi, s.dot_phi, s.dot_theta, s.dot_psi]);
            let force = staged.disk.multipliers(0.0, &same, &[]);
            FloorDiskInputs { fx: force.rolling_x, fy: force.rolling_y }
        };
        for run in RUNS {
            let (method, tolerance, _) = run;
            rolling.follows(block, run, |start, end| {
                let simulation = rolling.disk.simulate(start).method(method).tolerance(tolerance, tolerance);
                simulation.until(end).expect("a regular motion")
            });
            staged.follows(block, run, |start, end| {
                let simulation = staged.disk.simulate(start).method(method).tolerance(tolerance, tolerance);
                simulation.until(end).expect("a regular motion")
            });
            floor.follows(block, run, |start, end| {
                let simulation = floor.disk.simulate(start).method(method).tolerance(tolerance, tolerance);
                simulation.inputs(friction).until(end).expect("a regular motion")
            });
        }
    }
}

/// The reactions along a motion that was kept at the golden times only.
#[test]
fn the_disk_is_carried_by_the_golden_reactions() {
    let golden = parse(DISK);
    let block = &golden["trajectory"];
    let staged = staged(params(&block["params"], ["m", "r", "J", "g"]));
    let golden = list(&block["states"]);
    let start = (staged.state)(&numbers(&golden[0]["q"]), &numbers(&golden[0]["omega"]));
    let run = staged.disk.simulate(start).tolerance(1e-13, 1e-13).every(1.0).dense(false).until(10.0);
    let run = run.expect("a regular motion");
    assert_eq!(run.times().len(), golden.len());
    for ((t, s), expected) in run.iter().zip(golden) {
        assert_eq!(t, expected["t"].as_f64().expect("a time"));
        let force = staged.disk.multipliers(t, s, &[]);
        let told = [numbers(&expected["lambda"]), numbers(&expected["lambda_z_rolling"])].concat();
        near(&format!("λ at {t}"), &[force.rolling_x, force.rolling_y, force.contact], &told, 1e-9);
    }
}

/// Runs a model through the rows of a published motion.
fn follows<M: ConstrainedSystem>(
    model: &Prepared<M>,
    start: State<M>,
    rows: &[Value],
    told: impl Fn(&State<M>) -> Vec<f64>,
    expected: impl Fn(&Value) -> Vec<f64>,
) {
    let end = rows.last().expect("a row")["t"].as_f64().expect("a time");
    for (method, tolerance, bound) in RUNS {
        let run = model.simulate(start).method(method).tolerance(tolerance, tolerance).until(end);
        let run = run.expect("a regular motion");
        let mut worst = 0.0_f64;
        for row in rows {
            let t = row["t"].as_f64().expect("a time");
            let s = run.at(t).expect("the motion covers the time");
            let place = format!("{} by {method:?} at {t}", M::MODEL.name);
            worst = worst.max(near(&place, &told(&s), &expected(row), bound));
        }
        println!("{:12} {method:?} {tolerance:.0e}: largest error {worst:.1e}", M::MODEL.name);
    }
}

#[test]
fn sleigh_and_knife_edge_follow_the_published_motions() {
    let golden = parse(SLEIGH);
    let sleigh = case(&golden, "sleigh");
    let [m, i, a] = ["m", "I", "a"].map(|p| sleigh["parameters"][p].as_f64().expect("a number"));
    let rows = list(&sleigh["expected"]);
    let whole = |row: &Value| picked(row, &["x", "y", "theta", "v", "omega", "knife_force"]);
    let start: [f64; 5] = picked(&rows[0], &["x", "y", "theta", "v", "omega"]).try_into().expect("five figures");

    let moving = Sleigh { m, i, a }.prepare().expect("the parameters are good");
    let force = |s: &SleighState| moving.multipliers(0.0, s, &[]).blade;
    follows(&moving, start.into(), rows, |s| vec![s.x, s.y, s.phi, s.u, s.o, force(s)], whole);

    let fixed = SleighInPlane { m, i, a }.prepare().expect("the parameters are good");
    let force = |s: &SleighInPlaneState| fixed.multipliers(0.0, s, &[]).blade;
    follows(&fixed, start.into(), rows, |s| vec![s.x, s.y, s.phi, s.forward, s.turn, force(s)], whole);

    let blade = case(&golden, "knife_edge_on_incline");
    let [m, i, g, incline] = params(&blade["parameters"], ["m", "I", "g", "incline"]);
    let knife = KnifeEdge { m, i, g, incline }.prepare().expect("the parameters are good");
    let start = KnifeEdgeState { turn: 1.5, ..KnifeEdgeState::default() };
    let told = |s: &KnifeEdgeState| {
        let v = knife.velocities(0.0, s);
        vec![s.x, s.y, s.phi, v.dot_x, v.dot_y, v.dot_phi, knife.multipliers(0.0, s, &[]).blade]
    };
    let whole = |row: &Value| picked(row, &["x", "y", "phi", "xd", "yd", "phid", "blade_force"]);
    follows(&knife, start, list(&blade["expected"]), told, whole);
}

/// Halving the step divides the error by the power of the order.
#[test]
fn the_classical_method_has_order_four() {
    let golden = parse(DISK);
    let block = &golden["trajectory"];
    let staged = staged(params(&block["params"], ["m", "r", "J", "g"]));
    let states = list(&block["states"]);
    let start = (staged.state)(&numbers(&states[0]["q"]), &numbers(&states[0]["omega"]));
    let expected = numbers(&states[10]["q"]);
    let error = |step: f64| {
        let run = staged.disk.simulate(start).method(Method::Rk4 { step }).until(10.0).expect("a regular motion");
        let (q, _) = (staged.read)(run.last().1);
        q.iter().zip(&expected).map(|(q, e)| (q - e).abs()).fold(0.0, f64::max)
    };
    let ratios = [0.04, 0.02, 0.01].map(|step| error(step) / error(step / 2.0));
    println!("{ratios:?}");
    assert!(ratios.iter().all(|ratio| (13.0..19.0).contains(ratio)), "{ratios:?}");
}
