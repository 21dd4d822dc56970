//! One emitted code, several scalars: single precision, dual numbers, dual numbers of dual numbers.
//!
//! The derivatives by dual numbers are held against extrapolated central differences of the same code in f64.

#[path = "../examples/rolling_disk/models.rs"]
mod disks;
mod models;
mod support;

use holonomy::prelude::*;
use holonomy::{Dual, State};
use support::running::entries;
use support::splitmix::SplitMix;

/// Central differences over 2h, extrapolated twice: the error is of the order of h⁶ and of rounding over h.
const STEP: f64 = 1e-2;
const BY_DIFFERENCES: f64 = 1e-8;
/// A few hundred roundings of f32.
const SINGLE: f64 = 1e-4;

/// A point at which a model is evaluated: t, state, inputs and parameters, one list.
struct Point<M: ConstrainedSystem> {
    model: M,
    values: Vec<f64>,
}

/// Everything that the derivative says at a point: the state's rate and the guards.
fn rate<M: ConstrainedSystem, T: Scalar>(model: &M, values: &[T]) -> Vec<T> {
    let (t, rest) = values.split_first().expect("the time");
    let (s, rest) = rest.split_at(M::State::<T>::NAMES.len());
    let (i, p) = rest.split_at(M::MODEL.inputs.len());
    let parameters = M::Parameters::<T>::from_fn(|j| p[j]);
    let prepared = Prepared::with_parameters(model.clone(), parameters).expect("the parameters are good");
    let (s, i) = (M::State::<T>::from_fn(|j| s[j]), M::Inputs::<T>::from_fn(|j| i[j]));
    let (rate, guards) = prepared.derivative(*t, &s, &i);
    let multipliers = prepared.multipliers(*t, &s, &i);
    [entries(&rate), entries(&guards), entries(&multipliers), vec![prepared.energy(*t, &s)]].concat()
}

impl<M: ConstrainedSystem> Point<M> {
    fn new(model: M, random: &mut SplitMix) -> Self {
        let count = 1 + State::<M>::NAMES.len() + M::MODEL.inputs.len();
        let mut values = random.vector(count, 0.2, 1.2);
        values.extend(entries(&model.parameters()));
        Self { model, values }
    }

    fn shifted(&self, direction: &[f64], h: f64) -> Vec<f64> {
        self.values.iter().zip(direction).map(|(value, d)| value + h * d).collect()
    }

    /// The derivative of a function along a direction, by differences.
    fn difference(&self, direction: &[f64], f: impl Fn(&[f64]) -> Vec<f64>) -> Vec<f64> {
        let central = |h: f64| -> Vec<f64> {
            let (ahead, behind) = (f(&self.shifted(direction, h)), f(&self.shifted(direction, -h)));
            ahead.iter().zip(&behind).map(|(a, b)| (a - b) / (2.0 * h)).collect()
        };
        let better = |coarse: &[f64], fine: &[f64], power: f64| -> Vec<f64> {
            coarse.iter().zip(fine).map(|(c, f)| f + (f - c) / (power - 1.0)).collect()
        };
        let [a, b, c] = [STEP, STEP / 2.0, STEP / 4.0].map(central);
        better(&better(&a, &b, 4.0), &better(&b, &c, 4.0), 16.0)
    }
}

fn dual(values: &[f64], direction: &[f64]) -> Vec<Dual> {
    values.iter().zip(direction).map(|(&value, &d)| Dual::new(value, d)).collect()
}

fn close(place: &str, computed: &[f64], expected: &[f64], bound: f64) {
    assert_eq!(computed.len(), expected.len(), "{place}");
    let scale = expected.iter().fold(1.0_f64, |scale, e| scale.max(e.abs()));
    for (i, (c, e)) in computed.iter().zip(expected).enumerate() {
        assert!((c - e).abs() <= bound * scale, "{place} [{i}]: {c:e} instead of {e:e} at scale {scale:e}");
    }
}

/// Single precision, first derivatives in every direction, second derivatives in random ones.
fn agrees<M: ConstrainedSystem>(model: M, random: &mut SplitMix) {
    for _ in 0..3 {
        let point = Point::new(model.clone(), random);
        let name = format!("{} at {:?}", M::MODEL.name, point.values);
        let double = rate(&point.model, &point.values);
        let single: Vec<f32> = point.values.iter().map(|&value| value as f32).collect();
        let single: Vec<f64> = rate(&point.model, &single).into_iter().map(f64::from).collect();
        close(&format!("{name}: f32"), &single, &double, SINGLE);

        for k in 0..point.values.len() {
            let direction: Vec<f64> = (0..point.values.len()).map(|i| f64::from(u8::from(i == k))).collect();
            let along = rate(&point.model, &dual(&point.values, &direction));
            let values: Vec<f64> = along.iter().map(|e| e.value).collect();
            close(&format!("{name}: value"), &values, &double, 1e-13);
            let derivatives: Vec<f64> = along.iter().map(|e| e.derivative).collect();
            let expected = point.difference(&direction, |values| rate(&point.model, values));
            close(&format!("{name}: derivative {k}"), &derivatives, &expected, BY_DIFFERENCES);
        }

        let [first, second] = [0, 1].map(|_| random.vector(point.values.len(), -0.5, 0.5));
        let values = dual(&point.values, &first).into_iter().zip(&second);
        let nested: Vec<Dual<Dual>> = values.map(|(value, &d)| Dual::new(value, Dual::constant(d))).collect();
        let twice: Vec<f64> = rate(&point.model, &nested).iter().map(|e| e.derivative.derivative).collect();
        let expected = point.difference(&second, |values| {
            rate(&point.model, &dual(values, &first)).iter().map(|e| e.derivative).collect()
        });
        close(&format!("{name}: second derivative"), &twice, &expected, BY_DIFFERENCES);
    }
}

const M: f64 = 2.0;
const R: f64 = 0.5;
const J: f64 = 0.125;
const G: f64 = 9.81;

#[test]
fn emitted_code_is_generic_over_the_scalar() {
    let random = &mut SplitMix::new(32);
    agrees(disks::RollingDisk { m: M, r: R, j: J, g: G }, random);
    agrees(disks::FloorDisk { m: M, r: R, j: J, g: G }, random);
    agrees(disks::StagedDisk { m: M, r: R, j: J, g: G }, random);
    agrees(models::RollingDisc { m: M, r: R, g: G, d: 0.125, a: 0.25 }, random);
    agrees(models::Sleigh { m: 2.5, i: 0.3, a: 0.4 }, random);
    agrees(models::SleighInPlane { m: 2.5, i: 0.3, a: 0.4 }, random);
    agrees(models::KnifeEdge { m: M, i: 0.7, g: G, incline: 0.5 }, random);
    agrees(models::Pendulum { m: 1.5, l: 0.8, g: G }, random);
    agrees(models::HangingPendulum { m: 1.5, l: 0.8, g: G }, random);
    agrees(models::PendulumByAngle { m: 1.5, l: 0.8, g: G }, random);
    agrees(models::BeadOnRod { m: 0.7, w: 1.25, g: G }, random);
    agrees(models::BeadByDistance { m: 0.7, w: 1.25, g: G }, random);
    agrees(models::DoublePendulum { m1: M, m2: 1.25, l1: 0.9, l2: 0.6, g: G }, random);
}

/// Every function that the language knows, so that each method of the scalar trait is called by emitted code.
#[derive(ConstrainedSystem, Clone)]
#[coordinates(x, y)]
#[inertia(diag(m*(2 + sin(x)), m*exp(y/3)))]
#[forces(sqrt(2 + powi(x, 2))*atan2(y, x) - tan(x/2)*t, ln(1 + powi(y, 4))/powi(x, 3) + cos(PI*x*y)*dot(x))]
#[potential_energy(m*exp(-powi(x, 2))*atan2(x, -y))]
#[constraint(row: y - ln(2 + sin(x))*sqrt(1 + t) == 0)]
#[independent(dot(x))]
struct Functions {
    m: f64,
}

#[test]
fn every_function_has_its_derivative() {
    agrees(Functions { m: 1.25 }, &mut SplitMix::new(5));
}

/// A run in single precision by hand: the types of another scalar fit together.
#[test]
fn a_step_in_single_precision() {
    let disk = disks::StagedDisk { m: M, r: R, j: J, g: G };
    let (single, double) = (disk.clone().prepare_as::<f32>().expect("a disk"), disk.prepare().expect("a disk"));
    let start = [0.0, 0.0, 0.25, 0.3, 0.0, 0.5, -0.25, -6.0];
    let step: disks::StagedDiskState = {
        let s = disks::StagedDiskState::from(start);
        let rate: [f64; 8] = double.derivative(0.0, &s, &[]).0.into();
        disks::StagedDiskState::from_fn(|i| start[i] + 0.01 * rate[i])
    };
    let start = start.map(|x| x as f32);
    let s = disks::StagedDiskState::<f32>::from(start);
    let rate: [f32; 8] = single.derivative(0.0, &s, &[]).0.into();
    let in_single = disks::StagedDiskState::<f32>::from_fn(|i| start[i] + 0.01 * rate[i]);
    let wide: Vec<f64> = entries(&in_single).into_iter().map(f64::from).collect();
    close("step", &wide, &entries(&step), 1e-6);
    assert!((f64::from(single.energy(0.0, &in_single)) - double.energy(0.0, &step)).abs() < 1e-4);
}
