//! What emitted code claims at a state.

use crate::support::running::{dense, entries};
use holonomy::{ConstrainedSystem, Dual, Prepared, Scalar, Vector};
use oracle::{ChartClaim, Claim, Multiplier};

/// Everything that a prepared model says about the state (q, u).
///
/// # Panics
/// If the parameters are refused over dual numbers.
pub fn claim<M: ConstrainedSystem>(model: &Prepared<M>, t: f64, q: &[f64], u: &[f64], inputs: &[f64]) -> Claim {
    let y: Vec<f64> = q.iter().chain(u).copied().collect();
    let s = M::State::<f64>::from_fn(|i| y[i]);
    let i = M::Inputs::<f64>::from_fn(|j| inputs[j]);
    let (x, v) = (model.coordinates(t, &s), model.velocities(t, &s));
    let (rate, _) = model.derivative(t, &s, &i);
    let rate = entries(&rate);
    // v̇ as the derivative of the emitted velocities along the emitted motion
    let dual = model.system().clone().prepare_as::<Dual<f64>>().expect("the parameters are good");
    let moving = M::State::<Dual<f64>>::from_fn(|j| Dual::new(y[j], rate[j]));
    let along = entries(&dual.velocities(Dual::variable(t), &moving));
    let (moving_rate, _) =
        dual.derivative(Dual::variable(t), &moving, &M::Inputs::from_fn(|j| Dual::constant(inputs[j])));
    let second: Vec<f64> = entries(&moving_rate).iter().map(|rate| rate.derivative).collect();
    let (velocities, given_rates) = (entries(&v), entries(&model.velocity_rates(t, &s, &i)));
    // w and ẇ by the names of the carriers
    let known = |name: &&str| {
        let place = |names: &[&str]| names.iter().position(|other| other == name);
        let coordinate = M::MODEL.state_coordinates.iter().position(|x| format!("dot_{x}") == **name);
        place(M::MODEL.velocities)
            .map(|j| (velocities[j], given_rates[j]))
            .or(coordinate.map(|j| (rate[j], second[j])))
            .or(place(M::MODEL.state_speeds).map(|j| (u[j], rate[q.len() + j])))
    };
    let carriers: Option<Vec<(f64, f64)>> = M::MODEL.carriers.iter().map(known).collect();
    let carried_outputs = carriers.map(|carriers| {
        let (w, dw) = (M::Carriers::from_fn(|j| carriers[j].0), M::Carriers::from_fn(|j| carriers[j].1));
        entries(&model.carried_outputs(t, &s, (&w, &dw), &model.multipliers(t, &s, &i), &i))
    });
    let outputs = M::MODEL.outputs.iter().map(|output| output.name.to_string());
    let names = |names: &[&str]| names.iter().map(ToString::to_string).collect::<Vec<_>>();
    let lambda = entries(&model.multipliers(t, &s, &i)).into_iter().zip(M::MODEL.multipliers);
    Claim {
        t,
        state_coordinates: q.to_vec(),
        speed_names: names(M::MODEL.state_speeds),
        speeds: u.to_vec(),
        coordinates: entries(&x),
        velocities,
        coordinate_rates: rate[..q.len()].to_vec(),
        accelerations: rate[q.len()..].to_vec(),
        velocity_rates: along.iter().map(|v| v.derivative).collect(),
        given_rates,
        mass_matrix: dense(&model.mass_matrix(t, &s)),
        forcing: entries(&model.forcing(t, &s, &i)),
        complement: dense(&model.complement(t, &s)),
        complement_bias: entries(&model.complement_bias(t, &s)),
        guards: entries(&model.guards(t, &s)),
        multipliers: lambda
            .map(|(value, info)| Multiplier { name: info.name.to_string(), value, row: info.row })
            .collect(),
        row_names: M::MODEL.rows.iter().map(|row| row.name.to_string()).collect(),
        constraint_matrix: dense(&model.constraint_matrix(t, &x, &v)),
        constraint_bias: entries(&model.constraint_bias(t, &x, &v)),
        velocity_residual: M::MODEL
            .velocity_rows()
            .map(|row| row.name.to_string())
            .zip(entries(&model.velocity_residual(t, &x, &v)))
            .collect(),
        position_residual: names(M::MODEL.position_rows)
            .into_iter()
            .zip(entries(&model.position_residual(t, &x)))
            .collect(),
        kinematic_matrix: dense(&model.kinematic_matrix(t, &x)),
        kinematic_bias: entries(&model.kinematic_bias(t, &x)),
        inertia: dense(&model.inertia(t, &x)),
        forces: entries(&model.forces(t, &x, &v, &i)),
        momenta: Some(entries(&model.momenta(t, &x, &v))),
        inverse_dynamics: Some(entries(&M::inverse_dynamics(
            model.values(),
            t,
            &x,
            &v,
            &model.velocity_rates(t, &s, &i),
            &i,
        ))),
        kinetic_energy: model.kinetic_energy(t, &x, &v),
        potential_energy: model.potential_energy(t, &x),
        charts: (0..M::MODEL.charts.len()).map(|chart| in_chart(model, chart, t, &s, &i)).collect(),
        outputs: outputs.zip(entries(&model.outputs(t, &s, &i))).collect(),
        carried_outputs,
    }
}

/// The same state in the speeds of a chart.
fn in_chart<M: ConstrainedSystem>(
    model: &Prepared<M>,
    chart: usize,
    t: f64,
    s: &M::State<f64>,
    i: &M::Inputs<f64>,
) -> ChartClaim {
    let first = M::MODEL.state_coordinates.len();
    let u = entries(&model.chart_speeds(chart, t, s, &model.velocities(t, s)));
    let y = entries(s);
    let s = M::State::<f64>::from_fn(|i| if i < first { y[i] } else { u[i - first] });
    let (rate, guards) = M::chart_derivative(chart, model.values(), t, &s, i);
    let (rate, guards) = (entries(&rate), entries(&guards));
    ChartClaim {
        velocities: entries(&M::chart_velocities(chart, model.values(), t, &s)),
        coordinate_rates: rate[..first].to_vec(),
        accelerations: rate[first..].to_vec(),
        guards: guards[..M::MODEL.charts[chart].guards.len()].to_vec(),
        speeds: u,
    }
}

/// What the other functions of the same model say: `accelerations` beside `derivative`, M_d and h_u* jointly.
///
/// # Panics
/// If the parameters are refused over dual numbers, or if the guards differ.
pub fn other_claim<M: ConstrainedSystem>(model: &Prepared<M>, t: f64, q: &[f64], u: &[f64], inputs: &[f64]) -> Claim {
    let y: Vec<f64> = q.iter().chain(u).copied().collect();
    let s = M::State::<f64>::from_fn(|i| y[i]);
    let i = M::Inputs::<f64>::from_fn(|j| inputs[j]);
    let (m, h) = model.mass_matrix_and_forcing(t, &s, &i);
    let (guards, alone) = (entries(&model.derivative(t, &s, &i).1), entries(&model.guards(t, &s)));
    let same = |(a, b): (&f64, &f64)| a.signum() == b.signum() && (a - b).abs() <= 1e-9 * a.abs();
    assert!(guards.len() == alone.len() && guards.iter().zip(&alone).all(same), "guards {guards:?} {alone:?}");
    Claim {
        accelerations: entries(&model.accelerations(t, &s, &i)),
        mass_matrix: dense(&m),
        forcing: entries(&h),
        ..claim(model, t, q, u, inputs)
    }
}
