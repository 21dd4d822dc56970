//! Where constraints lose their rank: an error value that names rows, guard and figure, in every form, and never a silent NaN.

#[path = "models/kinds.rs"]
mod kinds;
#[path = "models/linkages.rs"]
#[allow(dead_code)]
mod linkages;
mod support;

use holonomy::forms::NullSpaceMethod;
use holonomy::simulate::Crossing;
use holonomy::{ConstrainedSystem, Error, Prepared, State, Trajectory};
use kinds::{AppellHamel, TripleRod};
use linkages::{SliderCrank, SliderCrankState};
use support::splitmix::SplitMix;

const METHODS: [NullSpaceMethod; 3] = [NullSpaceMethod::Lu, NullSpaceMethod::Qr, NullSpaceMethod::Svd];

/// A particle on two crossing planes: the constraint has no direction where they cross.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z)]
#[inertia(diag(m, m, m))]
#[forces(0, 0, -m*g)]
#[constraint(planes: (x*x - y*y)/2 == 0)]
#[independent(dot(x), dot(z))]
struct CrossingPlanes {
    #[nominal(2.0)]
    m: f64,
    #[nominal(9.81)]
    g: f64,
}

fn crossing_planes() -> Prepared<CrossingPlanes> {
    CrossingPlanes { m: 2.0, g: 9.81 }.prepare().expect("good parameters")
}

#[test]
fn crossing_planes_lose_their_direction_on_the_crossing() {
    let model = crossing_planes();
    let s = State::<CrossingPlanes> { x: 0.3, y: -0.3, dot_x: 0.5, ..Default::default() };
    assert_eq!(model.check_rank(0.0, &s), Ok(1.0));
    let crossing = State::<CrossingPlanes> { dot_x: 0.5, ..Default::default() };
    let expected = |guard, time| Error::Dependent { rows: vec!["planes"], value: 0.0, guard, time };
    let guard = CrossingPlanes::MODEL.guards.iter().find(|guard| guard.name.contains('y')).expect("a pivot");
    assert_eq!(model.check_rank(2.0, &crossing), Err(expected(Some(guard.name), Some(2.0))));
    let text = model.check_rank(2.0, &crossing).unwrap_err().to_string();
    assert!(["`planes`", guard.name, "t = 2", "0e0"].iter().all(|part| text.contains(part)), "{text}");
    let full = model.initial_equations(0.0, &[0.0; 3], &[0.5, 0.5, 0.0].into(), &[]);
    assert_eq!(full.check_rank(), Err(expected(None, None)));
    assert_eq!(full.solve(), Err(expected(None, None)));
    assert_eq!(full.multipliers(), Err(expected(None, None)));
    // v = (1, 1)/2 runs along one plane: C v̇ + c0* = 0·v̇ + 0 holds, and nothing binds. The general form falls freely.
    for method in METHODS {
        let (rates, multipliers) = full.solve_by(method).expect("consistent");
        assert_eq!((rates.as_slice(), multipliers.as_slice()), ([0.0, 0.0, -9.81].as_slice(), [0.0].as_slice()));
    }
    // v = (1, 0)/2 leaves both: ẋ² − ẏ² = 1/4 cannot be made zero by any v̇.
    let full = model.initial_equations(0.0, &[0.0; 3], &[0.5, 0.0, 0.0].into(), &[]);
    for method in METHODS {
        assert_eq!(full.solve_by(method), Err(Error::Inconsistent { rows: vec!["planes"], residual: 0.25 }));
    }
    // A run that gets there leaves its chart, and stays in the plane in which it falls; one that is told not to pass stops with the
    // error of the mechanism itself.
    let start = State::<CrossingPlanes> { x: 0.3, y: -0.3, dot_x: -0.5, ..Default::default() };
    let run = model.simulate(start).until(1.0).expect("it passes");
    let (_, end) = run.last();
    let exact = [-0.2, 0.2, -0.5 * 9.81];
    assert!([end.x, end.y, end.z].iter().zip(exact).all(|(found, exact)| (found - exact).abs() < 1e-9), "{end:?}");
    assert_eq!(run.statistics().crossings, 1);
    let error = model.simulate(start).crossing(Crossing::Refuse).until(1.0).unwrap_err().error;
    assert!(
        matches!(&error, Error::Dependent { rows, guard: Some(_), time: Some(_), .. } if *rows == ["planes"]),
        "{error:?}"
    );
}

/// A particle on two cylinders, which touch along a line where d = a + b; a plane that has no part in it leans.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z, w)]
#[inertia(diag(m, m, m, m))]
#[forces(0, 0, -m*g, -m*g)]
#[constraint(left: (x*x + y*y - a*a)/2 == 0)]
#[constraint(right: (powi(x - d, 2) + y*y - b*b)/2 == 0)]
#[constraint(slope: z - w/2 == 0)]
#[independent(dot(w))]
struct TouchingCylinders {
    #[nominal(2.0)]
    m: f64,
    #[nominal(1.0)]
    a: f64,
    #[nominal(0.5)]
    b: f64,
    #[nominal(1.2)]
    d: f64,
    #[nominal(9.81)]
    g: f64,
}

#[test]
fn cylinders_that_touch_bind_one_direction_twice() {
    let model = TouchingCylinders { m: 2.0, a: 1.0, b: 0.5, d: 1.5, g: 9.81 }.prepare().expect("good parameters");
    let expected = ["left", "right"];
    // Along the line of contact, and as near as an assembly finds it: half the digits, as for every double root.
    for (x, y) in [(1.0, 0.0), (1.0, 1e-14)] {
        let s = State::<TouchingCylinders> { x, y, ..Default::default() };
        match model.check_rank(0.5, &s).unwrap_err() {
            Error::Dependent { rows, value, time: Some(0.5), .. } => assert!(rows == expected && value < 1e-12),
            other => panic!("{other:?}"),
        }
        // At rest both say the same of v̇, and the reactions' sum is unique: nothing pushes, as gravity runs along the line.
        let full = model.initial_equations(0.0, &[x, y, 0.0, 0.0], &[0.0; 4].into(), &[]);
        assert!(matches!(full.solve(), Err(Error::Dependent { rows, .. }) if rows == expected));
        for method in METHODS {
            let (rates, multipliers) = full.solve_by(method).expect("consistent");
            // (z, w): z̈ = ẅ/2, ẅ (1/4 + 1) = −g (1/2 + 1)
            assert!((rates[3] + 9.81 * 1.2).abs() < 1e-12 && (rates[2] + 9.81 * 0.6).abs() < 1e-12);
            assert!(rates[0].abs() < 1e-12 && multipliers[0].abs() < 1e-12 && multipliers[1].abs() < 1e-12);
        }
        // Across the line with a velocity, the two circles bend away from each other.
        let full = model.initial_equations(0.0, &[x, y, 0.0, 0.0], &[0.0, 1.0, 0.0, 0.0].into(), &[]);
        for method in METHODS {
            match full.solve_by(method).unwrap_err() {
                Error::Inconsistent { rows, residual } => assert!(rows == expected && residual.abs() > 0.1),
                other => panic!("{other:?}"),
            }
        }
    }
    // Circles that cut each other are independent.
    let model = TouchingCylinders { m: 2.0, a: 1.0, b: 0.5, d: 1.2, g: 9.81 }.prepare().expect("good parameters");
    let guess = State::<TouchingCylinders> { x: 0.9, y: 0.4, ..Default::default() };
    let s = model.assemble(guess).solve().expect("two points");
    assert!(model.check_rank(0.0, &s).expect("full rank") > 0.1);
}

#[test]
fn the_machine_of_appell_and_hamel_at_rest_is_bound_in_no_direction() {
    let model = AppellHamel { m1: 1.0, m2: 2.0, g: 9.81, c: 1.5 }.prepare().expect("good parameters");
    let moving = State::<AppellHamel> { dot_x: 0.6, dot_y: 0.8, dot_z: -1.0 / 1.5, ..Default::default() };
    assert_eq!(model.check_rank(0.0, &moving), Ok(1.0));
    let rest = State::<AppellHamel>::default();
    match model.check_rank(3.0, &rest).unwrap_err() {
        Error::Dependent { rows, value: 0.0, guard: Some(guard), time: Some(3.0) } => {
            assert_eq!(rows, ["cone"]);
            assert!(AppellHamel::MODEL.guards.iter().any(|entry| entry.name == guard));
        }
        other => panic!("{other:?}"),
    }
    let full = model.initial_equations_at(0.0, &rest, &[]);
    let expected = Error::Dependent { rows: vec!["cone"], value: 0.0, guard: None, time: None };
    assert_eq!(full.solve(), Err(expected.clone()));
    assert_eq!(full.multipliers(), Err(expected));
    // A run does not start there.
    let error = model.simulate(rest).until(1.0).unwrap_err().error;
    assert!(
        matches!(error, Error::ChartSingularity { value: 0.0, time: 0.0, .. } | Error::Dependent { .. }),
        "{error}"
    );
}

#[test]
fn rows_that_are_marked_redundant_are_no_loss() {
    let model = TripleRod { m: 2.0, g: 9.81, l: 0.5 }.prepare().expect("good parameters");
    let s = State::<TripleRod> { x: 0.3, y: -0.4, dot_x: 0.2 };
    assert_eq!(model.check_rank(0.0, &s), Ok(1.0));
    let full = model.initial_equations_at(0.0, &s, &[]);
    let names: Vec<&str> = full.rows.clone();
    assert_eq!(names.len(), 3);
    // (2.8) needs independent rows, and says which are not; the general form shares the load as the model does.
    assert!(matches!(full.solve(), Err(Error::Dependent { rows, .. }) if rows == names));
    let expected: [f64; 3] = model.multipliers(0.0, &s, &[]).into();
    let rates: [f64; 2] = model.velocity_rates(0.0, &s, &[]).into();
    for method in METHODS {
        let (found, multipliers) = full.solve_by(method).expect("consistent");
        assert!(found.iter().zip(rates).all(|(found, rate)| (found - rate).abs() < 1e-12));
        assert!(multipliers.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-12));
    }
    let (found, _) = full.independent_rows().expect("finite").solve().expect("one row");
    assert!(found.iter().zip(rates).all(|(found, rate)| (found - rate).abs() < 1e-12));
    // On the point where the rods are fixed all directions are lost, redundant or not.
    let fixed = model.check_rank(0.0, &State::<TripleRod>::default());
    assert!(matches!(fixed, Err(Error::Dependent { rows, .. }) if rows.len() == 1));
}

/// A slider-crank of equal lengths of random size and mass, its start on the branch β = α, a tolerance, and the number of the case.
fn slider_cranks() -> impl Iterator<Item = (usize, Prepared<SliderCrank>, SliderCrankState, f64)> {
    let mut random = SplitMix::new(77);
    (0..200).map(move |number| {
        let mut about = |value: f64| value * random.between(0.65, 1.35);
        let [l, m1, m2, m3, g, alpha] = [1.0, 1.0, 1.0, 1.0, 9.81, 0.5].map(&mut about);
        let dot_alpha = random.between(-6.0, 6.0);
        let model = SliderCrank { l, m1, m2, m3, g }.prepare().expect("good parameters");
        let start = SliderCrankState { alpha, beta: alpha, x: 2.0 * l * alpha.cos(), dot_alpha };
        (number, model, start, [1e-8, 1e-10, 1e-13][number % 3])
    })
}

/// The largest change of the energy along a run, relative to the largest of its parts, and where.
fn energy_lost(model: &Prepared<SliderCrank>, run: &Trajectory<SliderCrank>) -> (f64, usize) {
    let energies = run.iter().zip(run.velocities()).map(|((t, s), v)| {
        let x = model.coordinates(t, s);
        (model.kinetic_energy(t, &x, v), model.potential_energy(t, &x).expect("it has one"))
    });
    let energies: Vec<(f64, f64)> = energies.collect();
    let at_start = energies[0].0 + energies[0].1;
    let most = energies.iter().fold(at_start.abs(), |most, (kinetic, _)| most.max(*kinetic));
    let lost = energies.iter().map(|(kinetic, potential)| (kinetic + potential - at_start).abs() / most);
    lost.zip(0..).fold((0.0, 0), |worst, lost| if lost.0 > worst.0 { lost } else { worst })
}

/// Where crank and rod of one length stand on top of each other, two motions meet: a run that is told not to pass ends there with
/// the row that is lost, after few steps, and with its energy, whatever the step sizes that lead up to it.
#[test]
fn a_slider_crank_ends_where_its_branches_meet_if_told_to() {
    for (number, model, start, tolerance) in slider_cranks() {
        let run = model.simulate(start).crossing(Crossing::Refuse).tolerance(tolerance, tolerance);
        let stopped = run.until(20.0).expect_err("it gets there");
        let Error::Dependent { rows, guard, value, .. } = &stopped.error else { panic!("{number}: {}", stopped.error) };
        assert!(rows.contains(&"loop_y") && *guard == Some("cos(beta)"), "{number}: {rows:?}, {guard:?}");
        assert!(*value <= 1e-5, "{number}: {value:e}");
        let run = &stopped.trajectory;
        let steps = run.statistics().accepted + run.statistics().rejected;
        assert!(steps < 2000, "{number}: {steps} steps");
        let (lost, step) = energy_lost(&model, run);
        assert!(lost < 100.0 * tolerance.max(1e-11), "{number}: {lost:e} at step {step} of {steps}");
    }
}

/// Otherwise it passes, with its energy and without a jump to the motion β = π − α, however slowly.
#[test]
fn a_slider_crank_passes_where_its_branches_meet() {
    let (mut crossings, mut worst) = (0, [0.0_f64; 2]);
    for (number, model, start, tolerance) in slider_cranks() {
        let run = model.simulate(start).tolerance(tolerance, tolerance).until(1.2);
        let run = run.unwrap_or_else(|stopped| panic!("{number}: {stopped}, {:?}", stopped.trajectory));
        let apart = run.states().iter().map(|s| (s.beta - s.alpha).abs()).fold(0.0, f64::max);
        assert!(apart < 10.0 * tolerance.max(1e-11), "{number}: {apart:e}");
        let (lost, step) = energy_lost(&model, &run);
        assert!(lost < 20.0 * tolerance.max(1e-11), "{number}: {lost:e} at step {step}");
        worst = [worst[0].max(apart / tolerance.max(1e-11)), worst[1].max(lost / tolerance.max(1e-11))];
        crossings += run.statistics().crossings;
    }
    println!("{crossings} crossings, β - α and energy in units of the tolerance: {worst:.1?}");
    assert!(crossings > 150, "{crossings}");
}
