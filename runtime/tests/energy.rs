//! Undriven motions keep their energy over many revolutions, whatever charts they run through.

mod models {
    include!("models/pendulum.rs");
}

use holonomy::prelude::*;
use holonomy::simulate::Charts;
use models::{Pendulum, PendulumState};

/// Speeds at the bottom: a swing, nearly over the top, over it, and a fast rotation with nearly four turns a second.
const SPEEDS: [f64; 4] = [3.0, 4.43, 5.5, 12.0];

/// In 100 s at 1e-10 a tenth of the 1e-7 that 1,000 s may cost: the loss grows in proportion to the time.
#[test]
fn energy_is_lost_slowly() {
    let (m, l, g) = (2.0, 0.5, 9.81);
    let pendulum = Pendulum { m, l, g }.prepare().unwrap();
    for dot_x in SPEEDS {
        let start = PendulumState { x: 0.0, y: -l, dot_x };
        let kinetic = m * dot_x * dot_x / 2.0;
        for charts in [Charts::Change, Charts::General] {
            let run =
                pendulum.simulate(start).tolerance(1e-10, 1e-10).charts(charts).dense(false).until(100.0).unwrap();
            let energies = run.iter().zip(run.velocities()).map(|((t, s), v)| {
                let x = pendulum.coordinates(t, s);
                pendulum.kinetic_energy(t, &x, v) + m * g * (s.y + l)
            });
            let worst = energies.fold(0.0_f64, |worst, energy| worst.max((energy / kinetic - 1.0).abs()));
            println!("{dot_x} m/s, {charts:?}: {worst:.1e}, {:?}", run.statistics());
            assert!(worst < 1e-8, "{dot_x} m/s, {charts:?}: {worst:e}");
            let residuals = run.largest_residuals();
            assert!(residuals.position < 1e-13 && residuals.velocity < 1e-13, "{residuals:?}");
            // Few steps are taken twice.
            let statistics = run.statistics();
            assert!(5 * statistics.rejected < statistics.accepted, "{statistics:?}");
        }
    }
}
