//! Every model with an answer of its own against the oracle, at random states and random parameters.

mod claims;
mod models;
mod oracle;
mod support;

use claims::compiled::{claim, other_claim};
use holonomy::ConstrainedSystem;
use oracle::{System, check, closed, read_models};
use support::splitmix::SplitMix;

/// States of each model.
const STATES: usize = 25;

/// Holds the emitted code of a model against its declaration.
fn agrees<M: ConstrainedSystem>(random: &mut SplitMix, build: impl Fn(&[f64]) -> M) {
    let declared: Vec<_> = models::SOURCES.iter().flat_map(|source| read_models(source)).collect();
    let declared = declared.iter().find(|d| d.name == M::MODEL.name).expect("the model is declared in the sources");
    let (mut worst, mut compared) = (0.0_f64, 0);
    for _ in 0..STATES {
        // parameters near the nominal ones; lengths and masses stay positive
        let parameters: Vec<f64> = declared.nominal().iter().map(|p| p * random.between(0.7, 1.4)).collect();
        let system = System { model: declared, parameters: parameters.clone(), inputs: Vec::new() };
        let model = build(&parameters).prepare().expect("the parameters are good");
        let t = random.between(0.0, 3.0);
        let guess = random.vector(declared.state_coordinates().len(), 0.2, 1.2);
        let q = closed(&system, t, &guess).expect("Newton's method closes near the guess");
        let u = random.vector(M::MODEL.state_speeds.len(), -2.0, 2.0);
        for claim in [claim(&model, t, &q, &u, &[]), other_claim(&model, t, &q, &u, &[])] {
            let report = check(&system, &claim);
            report.assert(&format!("{} at t = {t}, q = {q:?}, u = {u:?}, parameters {parameters:?}", declared.name));
            worst = worst.max(report.worst);
            compared += report.compared;
        }
    }
    println!("{:24} {compared:6} numbers compared, largest error {worst:.1e} of its bound", declared.name);
}

/// One call for each model: its parameters in the order of the fields.
macro_rules! all {
    ($random:expr, $($model:ident($($field:ident),*))*) => {
        $(agrees($random, |p| {
            let mut p = p.iter().copied();
            models::$model { $($field: p.next().expect("a parameter")),* }
        });)*
    };
}

#[test]
fn every_model_agrees_with_the_oracle() {
    let random = &mut SplitMix::new(4);
    all!(random,
        RollingDisk(m, r, j, g)
        RollingDiskOnFloor(m, r, j, g)
        SlidingDisk(m, r, j, g)
        RollingDiskInStages(m, r, j, g)
        RollingDiskSecondStage(m, r, j, g)
        RollingDisc(m, r, g, d, a)
        Pendulum(m, l, g)
        HangingPendulum(m, l, g)
        PendulumByAngle(m, l, g)
        BeadOnRod(m, w, g)
        BeadByDistance(m, w, g)
        ConicalPendulum(m, r, opening, g)
        Atwood(m1, m2, c, g)
        DoublePendulum(m1, m2, l1, l2, g)
        Sleigh(m, i, a)
        SleighInPlane(m, i, a)
        KnifeEdge(m, i, g, incline)
    );
}
