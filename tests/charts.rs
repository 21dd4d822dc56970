//! Models with several charts: the same motion in every one of them, and the way there and back through v.

use holonomy::{ConstrainedSystem, Matrix, Prepared, Vector};

mod support;

use support::splitmix::SplitMix;

/// A particle on a sphere: no single pair of speeds is independent everywhere.
#[derive(ConstrainedSystem, Clone)]
#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, -m*g)]
#[potential_energy(m*g*z)]
#[constraint(rod: (powi(x, 2) + powi(y, 2) + powi(z, 2) - powi(l, 2))/2 == 0)]
#[independent(dot(x), dot(y))]
#[independent(dot(y), dot(z))]
#[independent(dot(z), dot(x))]
struct SphericalPendulum {
    m: f64,
    l: f64,
    g: f64,
}

/// A blade on a turning table, its velocity in its own axes: A, a0 and η depend on the state and the time.
#[derive(ConstrainedSystem, Clone)]
#[coordinates(x, y, phi)]
#[speeds(u, v, o)]
#[kinematics(
    dot(x) = u*cos(phi) - v*sin(phi) - w*y,
    dot(y) = u*sin(phi) + v*cos(phi) + w*x,
    dot(phi) = o + w*t,
)]
#[inertia(matrix([m, 0, 0], [0, m, m*a], [0, _, i]))]
#[forces(m*o*(v + a*o), -m*o*u, -m*a*o*u)]
#[constraint(blade: u*sin(phi) + v*(2 + cos(phi)) + o*cos(phi) == w*cos(t))]
#[independent(u, o)]
#[independent(v, u)]
#[independent(o, v)]
struct Skate {
    m: f64,
    a: f64,
    i: f64,
    w: f64,
}

/// A double pendulum in Cartesian coordinates by its angles, its tip on a line: two stages, and a chart for each angle.
#[derive(ConstrainedSystem, Clone)]
#[coordinates(x1, y1, x2, y2)]
#[inertia(diag(m, m, m, m))]
#[forces(0, -m*g, 0, -m*g)]
#[configuration(
    of(a, b),
    x1 = l*sin(a),
    y1 = -l*cos(a),
    x2 = l*sin(a) + l*sin(b)*s,
    y2 = -l*cos(a) - l*cos(b)*s,
)]
#[constraint(first: powi(x1, 2) + powi(y1, 2) == powi(l, 2))]
#[constraint(second: powi(x2 - x1, 2) + powi(y2 - y1, 2) == powi(l*s, 2))]
#[constraint(tip: y2 == c*x2 - d)]
#[independent(dot(a))]
#[independent(dot(b))]
struct Elbow {
    m: f64,
    l: f64,
    s: f64,
    g: f64,
    c: f64,
    d: f64,
}

fn close(found: f64, expected: f64, what: &str) {
    assert!((found - expected).abs() <= 1e-11 * (1.0 + expected.abs()), "{what}: {found} and {expected}");
}

/// The state in another chart, and v.
fn moved<M: ConstrainedSystem>(model: &Prepared<M>, chart: usize, t: f64, s: &M::State<f64>) -> M::State<f64> {
    let v = model.velocities(t, s);
    let u: <M::Speeds<f64> as Vector<f64>>::Array = model.chart_speeds(chart, t, s, &v).into();
    let mut array: <M::State<f64> as Vector<f64>>::Array = (*s).into();
    let from = M::MODEL.state_coordinates.len();
    array.as_mut()[from..].copy_from_slice(u.as_ref());
    array.into()
}

/// Every chart of the model has the motion of the first one at a state that is regular in all.
fn agree<M: ConstrainedSystem>(model: &Prepared<M>, t: f64, s: &M::State<f64>)
where
    M::Inputs<f64>: Default,
{
    let inputs = M::Inputs::<f64>::default();
    let names = M::MODEL.velocities;
    let v: <M::Velocities<f64> as Vector<f64>>::Array = model.velocities(t, s).into();
    let rates: <M::Velocities<f64> as Vector<f64>>::Array = model.velocity_rates(t, s, &inputs).into();
    let first: <M::State<f64> as Vector<f64>>::Array = model.derivative(t, s, &inputs).0.into();
    let columns = M::MODEL.state_coordinates.len();
    for (chart, info) in M::MODEL.charts.iter().enumerate() {
        let there = moved(model, chart, t, s);
        let found: <M::Velocities<f64> as Vector<f64>>::Array = model.chart_velocities(chart, t, &there).into();
        for (name, (a, b)) in names.iter().zip(found.as_ref().iter().zip(v.as_ref())) {
            close(*a, *b, &format!("{} of chart {chart}", name));
        }
        let (rate, guards) = model.chart_derivative(chart, t, &there, &inputs);
        let rate: <M::State<f64> as Vector<f64>>::Array = rate.into();
        let guards: <M::ChartGuards<f64> as Vector<f64>>::Array = guards.into();
        assert!(guards.as_ref().len() >= info.guards.len());
        assert!(guards.as_ref()[info.guards.len()..].iter().all(|guard| *guard == 1.0));
        for i in 0..columns {
            close(rate.as_ref()[i], first.as_ref()[i], M::MODEL.state_coordinates[i]);
        }
        for (speed, rate) in info.speeds.iter().zip(&rate.as_ref()[columns..]) {
            if let Some(j) = names.iter().position(|name| name == speed) {
                close(*rate, rates.as_ref()[j], &format!("the rate of {speed} in chart {chart}"));
            } else {
                // The rate of a coordinate of the configuration: its derivative along the motion, by differences.
                let at = M::MODEL.state_coordinates.iter().position(|q| format!("dot_{q}") == **speed);
                let at = at.expect("a speed of the state");
                let h = 1e-5;
                let along = |h: f64| {
                    let mut array: <M::State<f64> as Vector<f64>>::Array = (*s).into();
                    array.as_mut().iter_mut().zip(first.as_ref()).for_each(|(y, rate)| *y += h * rate);
                    let array: <M::State<f64> as Vector<f64>>::Array =
                        model.derivative(t + h, &array.into(), &inputs).0.into();
                    array.as_ref()[at]
                };
                let difference = (along(h) - along(-h)) / (2.0 * h);
                assert!((difference - rate).abs() < 1e-7 * (1.0 + rate.abs()), "{speed}: {difference} and {rate}");
            }
        }
    }
    // The carriers: v, or the rates of the configuration's coordinates.
    let w =
        <M::Carriers<f64> as Vector<f64>>::from_fn(|i| match names.iter().position(|n| *n == M::MODEL.carriers[i]) {
            Some(j) if M::MODEL.carriers.len() == names.len() => v.as_ref()[j],
            _ => first.as_ref()[i],
        });
    let found: <M::Velocities<f64> as Vector<f64>>::Array = model.carried_velocities(t, s, &w).into();
    found.as_ref().iter().zip(v.as_ref()).for_each(|(a, b)| close(*a, *b, "v of the carriers"));
    let found: <M::StateCoordinates<f64> as Vector<f64>>::Array = model.carried_rates(t, s, &w).into();
    found.as_ref().iter().zip(first.as_ref()).for_each(|(a, b)| close(*a, *b, "rates of the carriers"));
}

#[test]
fn all_charts_have_one_motion() {
    let random = &mut SplitMix::new(11);
    for _ in 0..40 {
        let model = SphericalPendulum { m: 2.0, l: 1.3, g: 9.81 }.prepare().expect("good parameters");
        let mut near = |low, high| random.between(low, high);
        let guess = SphericalPendulumState {
            x: near(0.3, 1.0),
            y: near(-1.0, -0.3),
            z: near(-1.0, -0.3),
            dot_x: near(-2.0, 2.0),
            dot_y: near(-2.0, 2.0),
        };
        let s = model.assemble(guess).solve().expect("it closes");
        agree(&model, 0.0, &s);

        let model = Skate { m: 2.0, a: 0.4, i: 0.9, w: 0.7 }.prepare().expect("good parameters");
        let [x, y, phi, u, o] = [0.0; 5].map(|_: f64| near(0.2, 1.1));
        agree(&model, near(0.0, 2.0), &SkateState { x, y, phi, u, o });

        let model = Elbow { m: 1.0, l: 0.8, s: 1.2, g: 9.81, c: 0.2, d: 1.0 }.prepare().expect("good parameters");
        let guess = ElbowState { a: near(0.3, 0.6), b: near(0.9, 1.3), dot_a: near(-1.0, 1.0) };
        let s = model.assemble(guess).hold("a").solve().expect("it closes");
        agree(&model, 0.0, &s);
    }
}

#[test]
fn a_chart_is_regular_where_another_is_not() {
    let model = SphericalPendulum { m: 2.0, l: 1.0, g: 9.81 }.prepare().expect("good parameters");
    // On the equator ẋ and ẏ do not determine ż, whose pivot is z; ẏ and ż do determine ẋ.
    let s = SphericalPendulumState { x: 1.0, y: 0.0, z: 0.0, dot_x: 0.5, dot_y: -2.0 };
    assert_eq!(model.guards(0.0, &s)[0], 0.0);
    let (rate, guards) = model.chart_derivative(1, 0.0, &s, &[]);
    assert_eq!(guards[0], 1.0);
    // The speeds of the chart 1 stand in the slots of the first one: ẏ = 0.5, ż = −2, so ẋ = 0.
    let expected = SphericalPendulumState { x: 0.0, y: 0.5, z: -2.0, dot_x: 0.0, dot_y: -9.81 };
    assert_eq!(rate, expected);
    let [_, second, third] = SphericalPendulum::MODEL.charts else { panic!("three charts") };
    assert_eq!((second.speeds, third.speeds), (["dot_y", "dot_z"].as_slice(), ["dot_z", "dot_x"].as_slice()));
    assert_eq!((second.guards[0].name, third.guards[0].name), ("x", "y"));
    let costs = SphericalPendulum::MODEL.operations;
    assert!(costs.iter().any(|cost| cost.function == "chart_2_derivative" && cost.multiplications > 0));
}

#[test]
fn further_charts_cost_the_first_nothing() {
    /// The same with one chart.
    #[derive(ConstrainedSystem, Clone)]
    #[coordinates(x, y, z)]
    #[inertia(diag(m, m, m))]
    #[forces(0, 0, -m*g)]
    #[potential_energy(m*g*z)]
    #[constraint(rod: (powi(x, 2) + powi(y, 2) + powi(z, 2) - powi(l, 2))/2 == 0)]
    #[independent(dot(x), dot(y))]
    struct OneChart {
        m: f64,
        l: f64,
        g: f64,
    }
    let own = |cost: &&holonomy::FunctionCost| !cost.function.starts_with("chart_") && cost.function != "values";
    let many = SphericalPendulum::MODEL.operations;
    assert!(OneChart::MODEL.operations.iter().filter(own).eq(many.iter().filter(own)));
    let single = OneChart { m: 2.0, l: 1.0, g: 9.81 }.prepare().expect("good parameters");
    let s = OneChartState { x: 0.6, y: 0.0, z: -0.8, dot_x: 0.5, dot_y: -2.0 };
    // A chart that the model does not have counts as the first one.
    assert_eq!(single.chart_derivative(0, 0.0, &s, &[]), single.derivative(0.0, &s, &[]));
    assert_eq!(single.chart_velocities(3, 0.0, &s), single.velocities(0.0, &s));
    assert_eq!(single.mass_matrix(0.0, &s).entry(0, 1), 0.0);
}
