//! All assembly modes of planar mechanisms, against intersections of circles and counts on fine grids.
#![allow(missing_docs, reason = "models of this test alone")]

use std::f64::consts::{PI, TAU};

use holonomy::{AssemblyMode, ConstrainedSystem, Error, Prepared, Scalar, State};

/// By the absolute angles of the bars.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(crank, coupler, rocker)]
#[inertia(diag(1, 2, 3))]
#[forces(0, 0, 0)]
#[constraint(across: a*cos(crank) + b*cos(coupler) == d + c*cos(rocker))]
#[constraint(upwards: a*sin(crank) + b*sin(coupler) == c*sin(rocker))]
#[independent(dot(crank))]
struct FourBar {
    a: f64,
    b: f64,
    c: f64,
    d: f64,
}

/// The slide lies beside the crank's axis, and rises.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(crank, rod, slide)]
#[inertia(diag(1, 1, 1))]
#[forces(0, 0, 0)]
#[constraint(across: a*cos(crank) + b*cos(rod) == slide)]
#[constraint(upwards: a*sin(crank) + b*sin(rod) == e + rise*t)]
#[independent(dot(crank))]
struct SliderCrank {
    a: f64,
    b: f64,
    e: f64,
    rise: f64,
}

/// A four-bar linkage with a dyad from a point of its coupler to the ground.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(crank, coupler, rocker, link, lever)]
#[define(px = cos(crank) + 0.9*cos(coupler + 0.7), py = sin(crank) + 0.9*sin(coupler + 0.7))]
#[inertia(diag(1, 1, 1, 1, 1))]
#[forces(0, 0, 0, 0, 0)]
#[constraint(across: cos(crank) + 3*cos(coupler) == 2.5 + 2*cos(rocker))]
#[constraint(upwards: sin(crank) + 3*sin(coupler) == 2*sin(rocker))]
#[constraint(dyad_across: px + 2*cos(link) == 1 + 1.8*cos(lever))]
#[constraint(dyad_upwards: py + 2*sin(link) == -1 + 1.8*sin(lever))]
#[independent(dot(crank))]
struct SixBar;

/// A platform on three legs; the place of its first corner, its angle, and the lengths of the legs.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, phi, l1, l2, l3)]
#[inertia(diag(1, 1, 1, 1, 1, 1))]
#[forces(0, 0, 0, 0, 0, 0)]
#[constraint(first: x*x + y*y == l1*l1)]
#[constraint(second: powi(x + 1.8*cos(phi) - 4, 2) + powi(y + 1.8*sin(phi), 2) == l2*l2)]
#[constraint(third:
    powi(x - 0.9*cos(phi) - 2*sin(phi) - 1.5, 2) + powi(y - 0.9*sin(phi) + 2*cos(phi) - 3.5, 2) == l3*l3)]
#[independent(dot(x), dot(y), dot(phi))]
struct Platform;

/// The loops of Andrews' squeezing mechanism with its published lengths.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(beta, theta, gamma, phi, delta, omega, epsilon)]
#[define(
    tip_x = 0.007*cos(beta) - 0.028*cos(beta + theta),
    tip_y = 0.007*sin(beta) - 0.028*sin(beta + theta),
)]
#[inertia(diag(1, 1, 1, 1, 1, 1, 1))]
#[forces(0, 0, 0, 0, 0, 0, 0)]
#[constraint(b_x: tip_x == -0.03635 + 0.035*sin(gamma))]
#[constraint(b_y: tip_y == 0.03273 - 0.035*cos(gamma))]
#[constraint(delta_x: tip_x == -0.06934 + 0.04*cos(delta) + 0.02*sin(phi + delta))]
#[constraint(delta_y: tip_y == -0.00227 + 0.04*sin(delta) - 0.02*cos(phi + delta))]
#[constraint(epsilon_x: tip_x == -0.06934 + 0.04*sin(epsilon) + 0.02*cos(omega + epsilon))]
#[constraint(epsilon_y: tip_y == -0.00227 - 0.04*cos(epsilon) + 0.02*sin(omega + epsilon))]
#[independent(dot(beta))]
struct Squeezer;

/// Two cranks on a pair of gears lift a weight.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(small, large, height)]
#[inertia(diag(1, 1, 1))]
#[forces(0, 0, 0)]
#[constraint(gears: small == 2*large + 0.4)]
#[constraint(cranks: height == cos(small) + cos(large))]
#[independent(dot(large))]
struct Geared;

/// A slide on a lever, as far out as a mass tells that moves by itself.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(a, x, y)]
#[inertia(diag(1, 1, m))]
#[forces(0, 0, 0)]
#[constraint(out: x == m*sin(a))]
#[independent(dot(a), dot(y))]
struct Weighed {
    m: f64,
}

/// A bead on a ring.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y)]
#[inertia(diag(1, 1))]
#[forces(0, 0)]
#[constraint(ring: x*x + y*y == l*l)]
#[independent(dot(x))]
struct Ring {
    l: f64,
}

/// A bead on a sphere.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(x, y, z)]
#[inertia(diag(1, 1, 1))]
#[forces(0, 0, 0)]
#[constraint(sphere: x*x + y*y + z*z == l*l)]
#[independent(dot(y), dot(z))]
#[output(product = x*y)]
struct Sphere {
    l: f64,
}

/// A ball that turns about its centre, and some of its directions.
#[derive(ConstrainedSystem, Clone, Debug)]
#[coordinates(e0, e1, e2, e3)]
#[frame(B = quaternion(N, e0, e1, e2, e3))]
#[body(ball = { frame: B, center: O, mass: 1, inertia: sphere(1, 1) })]
#[output(zx = dot(B.z, N.x), zy = dot(B.z, N.y), zz = dot(B.z, N.z), xx = dot(B.x, N.x), xy = dot(B.x, N.y))]
struct Ball;

type Point = (f64, f64);

fn on_circle((x, y): Point, r: f64, angle: f64) -> Point {
    (x + r * angle.cos(), y + r * angle.sin())
}

fn direction(from: Point, to: Point) -> f64 {
    (to.1 - from.1).atan2(to.0 - from.0)
}

/// Where circles meet: none or two points.
fn meeting(a: Point, ra: f64, b: Point, rb: f64) -> Vec<Point> {
    let distance = (b.0 - a.0).hypot(b.1 - a.1);
    let cosine = (distance * distance + ra * ra - rb * rb) / (2.0 * distance * ra);
    if cosine.abs() > 1.0 {
        return Vec::new();
    }
    [-1.0, 1.0].map(|side| on_circle(a, ra, direction(a, b) + side * cosine.acos())).into()
}

fn apart(a: f64, b: f64) -> f64 {
    (a - b - ((a - b) / TAU).round() * TAU).abs()
}

/// Each expected list of angles is that of exactly one mode.
fn assert_same<M: ConstrainedSystem>(
    modes: &[AssemblyMode<M>],
    angles: impl Fn(&M::State<f64>) -> Vec<f64>,
    expected: &[Vec<f64>],
) {
    assert_eq!(modes.len(), expected.len(), "{modes:?}");
    for one in expected {
        let near = |mode: &&AssemblyMode<M>| {
            angles(&mode.state).iter().zip(one).all(|(found, angle)| apart(*found, *angle) < 1e-12)
        };
        assert_eq!(modes.iter().filter(near).count(), 1, "{one:?} among {modes:?}");
    }
    assert!(modes.windows(2).all(|pair| pair[0].distance <= pair[1].distance));
    assert!(modes.iter().all(|mode| mode.starts > 1 && mode.unmet.is_none() && mode.report.unmet().count() == 0));
}

fn four_bar(a: f64, b: f64, c: f64, d: f64) -> Prepared<FourBar> {
    FourBar { a, b, c, d }.prepare().expect("good parameters")
}

#[test]
fn a_four_bar_with_its_crank_held_has_two_modes() {
    let model = four_bar(1.0, 3.0, 2.0, 2.5);
    for i in 0..8 {
        let crank = 0.3 + 0.77 * f64::from(i);
        let guess = State::<FourBar> { crank, coupler: 0.4, rocker: 1.2, ..Default::default() };
        let found = model.assemble(guess).hold("crank").modes(30).expect("it closes");
        let (p, ground) = (on_circle((0.0, 0.0), 1.0, crank), (2.5, 0.0));
        let expected: Vec<Vec<f64>> = meeting(p, 3.0, ground, 2.0)
            .into_iter()
            .map(|q| vec![crank, direction(p, q), direction(ground, q)])
            .collect();
        assert_eq!(expected.len(), 2);
        assert_same(&found.modes, |s| vec![s.crank, s.coupler, s.rocker], &expected);
        let starts: usize = found.modes.iter().map(|mode| mode.starts).sum();
        assert_eq!((starts + found.unclosed, found.movable), (31, 0));
        // The nearest to the guess is the one that a single assembly finds, angles within half a turn.
        let single = model.assemble(guess).hold("crank").solve().expect("it closes");
        assert!((single.rocker - found.modes[0].state.rocker).abs() < 1e-12, "{single:?} {found:?}");
        for mode in &found.modes {
            assert!(
                mode.state.crank == crank
                    && (mode.state.coupler - 0.4).abs() <= PI
                    && (mode.state.rocker - 1.2).abs() <= PI
            );
        }
    }
}

#[test]
fn links_that_cannot_meet_are_told_with_the_least_residual() {
    // The crank's pin is 3 from the rocker's, and the links are 1.2 and 1 long.
    let guess = State::<FourBar> { crank: PI, coupler: 2.0, rocker: 2.5, ..Default::default() };
    let error = four_bar(1.0, 1.2, 1.0, 2.0).assemble(guess).hold("crank").modes(30).unwrap_err();
    let Error::Assembly { residual, ref report, .. } = error else { panic!("{error}") };
    // The links point at each other nearly; nothing comes nearer than 3 − 1.2 − 1.
    assert!((0.8..0.81).contains(&residual.abs()), "{error}");
    assert_eq!(report.conflicts, ["crank"]);
}

#[test]
fn where_two_modes_meet_they_are_one() {
    // Stretched: 0.75 + 0.25 = 2 − 1.
    let guess = State::<FourBar> { coupler: 0.5, rocker: 2.0, ..Default::default() };
    let found = four_bar(1.0, 0.75, 0.25, 2.0).assemble(guess).hold("crank").modes(40).expect("it closes");
    assert_eq!((found.modes.len(), found.movable), (1, 0), "{found:?}");
    let state = &found.modes[0].state;
    assert!(state.coupler.abs() < 1e-6 && (state.rocker - PI).abs() < 1e-6, "{state:?}");
}

#[test]
fn what_is_not_held_is_told() {
    let model = four_bar(1.0, 3.0, 2.0, 2.5);
    let guess = State::<FourBar> { crank: 0.3, coupler: 0.4, rocker: 1.2, ..Default::default() };
    let error = model.assemble(guess).modes(5).unwrap_err();
    assert_eq!(error, Error::Movable { freedom: 1, among: vec!["crank", "coupler", "rocker"] });
    assert!(error.to_string().contains("hold or set 1 more of `crank`, `coupler`, `rocker`"), "{error}");
    // Six coordinates, three legs: the place and the angle are free, or the lengths.
    let platform = Platform.prepare().expect("no parameters");
    let guess = State::<Platform> { x: 1.0, y: 1.0, l1: 1.6, l2: 3.1, l3: 2.9, ..Default::default() };
    let error = platform.assemble(guess).hold("l1").modes(5).unwrap_err();
    assert!(matches!(error, Error::Movable { freedom: 2, .. }), "{error}");
    // A crank as long as the ground, a coupler as long as the rocker: folded, the pins of both lie on each other, and they turn.
    let folded = four_bar(2.0, 1.5, 1.5, 2.0).assemble(State::<FourBar>::default()).hold("crank").modes(5).unwrap_err();
    assert_eq!(folded, Error::Movable { freedom: 1, among: vec!["coupler", "rocker"] });
}

#[test]
fn a_slider_crank_has_two_modes_at_any_size_and_at_any_time() {
    for (size, t) in [(1.0, 0.0), (1e-3, 0.0), (250.0, 0.0), (0.4, 1.5)] {
        let (a, b, e, rise) = (size, 2.5 * size, 0.3 * size, 0.2 * size);
        let model = SliderCrank { a, b, e, rise }.prepare().expect("good parameters");
        let guess = State::<SliderCrank> { crank: 0.9, ..Default::default() };
        let found = model.assemble(guess).hold("crank").at_time(t).modes(20).expect("it closes");
        let rod = ((e + rise * t - a * 0.9_f64.sin()) / b).asin();
        assert_same(&found.modes, |s| vec![s.rod], &[vec![rod], vec![PI - rod]]);
        for mode in &found.modes {
            let slide = a * 0.9_f64.cos() + b * mode.state.rod.cos();
            assert!((mode.state.slide - slide).abs() < 1e-12 * size, "{mode:?}");
        }
        // Held at the slide, it has two cranks. Their names do not matter, nor does it what holds it.
        let slide = 0.4 * a + b;
        let held = model.assemble(guess).set("slide", slide).at_time(t).modes(20).expect("it closes");
        let met =
            model.assemble(guess).meet("place", slide, |_, _, s| s.slide).at_time(t).modes(20).expect("it closes");
        let pin = (slide, e + rise * t);
        let expected: Vec<Vec<f64>> = meeting((0.0, 0.0), a, pin, b)
            .into_iter()
            .map(|p| vec![direction((0.0, 0.0), p), direction(p, pin)])
            .collect();
        assert_eq!(expected.len(), 2);
        assert_same(&held.modes, |s| vec![s.crank, s.rod], &expected);
        assert_same(&met.modes, |s| vec![s.crank, s.rod], &expected);
    }
}

#[test]
fn two_loops_have_four_modes_and_velocities_in_each() {
    let model = SixBar.prepare().expect("no parameters");
    let crank = 1.1;
    let guess = State::<SixBar> { crank, ..Default::default() };
    let found = model.assemble(guess).hold("crank").set("dot_crank", 2.0).modes(60).expect("it closes");
    let (p, ground) = (on_circle((0.0, 0.0), 1.0, crank), (2.5, 0.0));
    let mut expected = Vec::new();
    for q in meeting(p, 3.0, ground, 2.0) {
        let coupler = direction(p, q);
        let (point, pivot) = (on_circle(p, 0.9, coupler + 0.7), (1.0, -1.0));
        for joint in meeting(point, 2.0, pivot, 1.8) {
            expected.push(vec![coupler, direction(ground, q), direction(point, joint), direction(pivot, joint)]);
        }
    }
    assert_eq!(expected.len(), 4);
    assert_same(&found.modes, |s| vec![s.coupler, s.rocker, s.link, s.lever], &expected);
    assert!(found.modes.iter().all(|mode| mode.state.dot_crank == 2.0));
    // The same again: nothing is left to chance.
    let again = model.assemble(guess).hold("crank").set("dot_crank", 2.0).modes(60).expect("it closes");
    assert_eq!(format!("{again:?}"), format!("{found:?}"));
}

/// The platform's third equation over its angle, the first two solved for its place: each root is a mode.
fn platform_roots([l1, l2, l3]: [f64; 3]) -> Vec<(f64, f64)> {
    let value = |phi: f64| {
        let (s, c) = phi.sin_cos();
        let corners = [(1.8 * c - 4.0, 1.8 * s), (-0.9 * c - 2.0 * s - 1.5, -0.9 * s + 2.0 * c - 3.5)];
        let right = |(x, y): Point, l: f64| (l * l - l1 * l1 - x * x - y * y) / 2.0;
        let (r2, r3) = (right(corners[0], l2), right(corners[1], l3));
        let determinant = corners[0].0 * corners[1].1 - corners[0].1 * corners[1].0;
        let (x, y) = (r2 * corners[1].1 - corners[0].1 * r3, corners[0].0 * r3 - r2 * corners[1].0);
        x * x + y * y - l1 * l1 * determinant * determinant
    };
    let n = 40_000;
    let grid: Vec<f64> = (0..=n).map(|i| -PI + TAU * (f64::from(i) + 0.123) / f64::from(n)).collect();
    grid.windows(2).filter(|pair| value(pair[0]) * value(pair[1]) < 0.0).map(|pair| (pair[0], pair[1])).collect()
}

#[test]
fn a_platform_on_three_legs_has_up_to_six_modes() {
    let model = Platform.prepare().expect("no parameters");
    let mut counts = Vec::new();
    for legs in [[1.6, 3.1, 2.9], [1.6, 3.1, 1.5], [2.4, 2.2, 2.3], [3.0, 1.2, 2.0]] {
        let [l1, l2, l3] = legs;
        let guess = State::<Platform> { x: 1.0, y: 1.0, l1, l2, l3, ..Default::default() };
        let found = model.assemble(guess).hold("l1").hold("l2").hold("l3").modes(150).expect("it closes");
        let roots = platform_roots(legs);
        assert_eq!(found.modes.len(), roots.len(), "{legs:?} {roots:?} {found:?}");
        for (low, high) in roots {
            let inside = |mode: &&AssemblyMode<Platform>| {
                let middle = 0.5 * (low + high);
                apart(mode.state.phi, middle) <= 0.5 * (high - low) + 1e-12
            };
            assert_eq!(found.modes.iter().filter(inside).count(), 1, "{low} {high} {found:?}");
        }
        for mode in &found.modes {
            assert!(model.position_residual_at(0.0, &mode.state).iter().all(|f| f.abs() < 1e-13), "{mode:?}");
        }
        // Most of the starts end where no small step makes the residual smaller; full steps go on from there, and most arrive.
        assert!(found.unclosed < 75, "{legs:?} {}", found.unclosed);
        counts.push(found.modes.len());
    }
    assert!(counts.contains(&6) && counts.contains(&2), "{counts:?}");
}

#[test]
fn the_squeezing_mechanism_has_all_sides_of_its_three_loops() {
    let model = Squeezer.prepare().expect("no parameters");
    let published = [-0.061_713_890_014_276_45, 0.0, 0.455_279_819_163_070_37];
    let [beta, theta, gamma] = published;
    let guess = State::<Squeezer> {
        beta,
        theta,
        gamma,
        phi: 0.22,
        delta: 0.49,
        omega: -0.22,
        epsilon: 1.23,
        ..Default::default()
    };
    let found = model.assemble(guess).hold("beta").modes(80).expect("it closes");
    let (pin, b, a) = (on_circle((0.0, 0.0), 0.007, beta), (-0.03635, 0.03273), (-0.06934, -0.00227));
    let quarter = PI / 2.0;
    let mut expected = Vec::new();
    for tip in meeting(pin, 0.028, b, 0.035) {
        let (theta, gamma) = (direction(tip, pin) - beta, direction(b, tip) + quarter);
        for elbow in meeting(a, 0.04, tip, 0.02) {
            for other in meeting(a, 0.04, tip, 0.02) {
                let (delta, epsilon) = (direction(a, elbow), direction(a, other) + quarter);
                let (phi, omega) = (direction(elbow, tip) + quarter - delta, direction(other, tip) - epsilon);
                expected.push(vec![theta, gamma, phi, delta, omega, epsilon]);
            }
        }
    }
    assert!(expected.len() == 4 || expected.len() == 8, "{}", expected.len());
    assert_same(&found.modes, |s| vec![s.theta, s.gamma, s.phi, s.delta, s.omega, s.epsilon], &expected);
    // The guess leads to the published configuration.
    let nearest = &found.modes[0].state;
    assert!(apart(nearest.theta, theta) < 1e-12 && apart(nearest.gamma, gamma) < 1e-12, "{nearest:?}");
}

#[test]
fn gears_count_turns_and_modes_that_differ_by_turns_alone_are_one() {
    let model = Geared.prepare().expect("no parameters");
    let guess = State::<Geared> { large: 0.2, height: 0.5, ..Default::default() };
    let found = model.assemble(guess).hold("height").modes(60).expect("it closes");
    let value = |large: f64| (2.0 * large + 0.4).cos() + large.cos() - 0.5;
    let grid = (0..10_000).map(|i| TAU * f64::from(i) / 10_000.0);
    let count = grid.filter(|a| value(*a) * value(a + TAU / 10_000.0) < 0.0).count();
    assert_eq!(found.modes.len(), count, "{found:?}");
    for mode in &found.modes {
        assert!(value(mode.state.large).abs() < 1e-13 && (mode.state.large - 0.2).abs() < PI + 1e-9, "{mode:?}");
        assert!((mode.state.small - 2.0 * mode.state.large - 0.4).abs() < 1e-13);
    }
}

#[test]
fn parameters_that_the_model_refuses_end_no_search() {
    // m (cos a, sin a) = (3, 0): on the other side m were −3.
    let model = Weighed { m: 1.0 }.prepare().expect("a good parameter");
    let asked = |a: f64| {
        let assembly = model.assemble(State::<Weighed> { a, ..Default::default() }).hold("y").solve_for("m");
        assembly.meet("balance", 3.0, |model, _, s| model.parameters().m * s.a.sin_cos().1)
    };
    let found = asked(0.5).hold("x").modes(40).expect("one side is good");
    assert_eq!((found.modes.len(), found.movable), (1, 0), "{found:?}");
    let mode = &found.modes[0];
    assert!((mode.parameters.m - 3.0).abs() < 1e-14 && mode.state.a.abs() < 1e-14, "{mode:?}");
    // Held there, full steps lead to nothing else.
    let error = asked(PI).hold("a").modes(5).unwrap_err();
    assert!(matches!(error, Error::Assembly { constraint: "balance", .. }), "{error}");
}

#[test]
fn equations_without_a_length_in_them_tell_none() {
    for l in [2.5e-4, 2.5, 2.5e4] {
        let sphere = Sphere { l }.prepare().expect("a good parameter");
        for x in [0.0, 1e-6 * l, 1e-2 * l] {
            let guess = State::<Sphere> { x, ..Default::default() };
            let found = sphere.assemble(guess).set("z", 0.6 * l).set("product", 0.0).modes(40).expect("it closes");
            assert_eq!((found.modes.len(), found.movable), (4, 0), "{l} {x}: {found:?}");
            for mode in &found.modes {
                let State::<Sphere> { x, y, .. } = mode.state;
                assert!((x.abs() + y.abs() - 0.8 * l).abs() < 1e-12 * l && mode.starts > 3, "{mode:?}");
            }
        }
    }
}

#[test]
fn the_two_signs_of_a_quaternion_are_one_attitude() {
    let model = Ball.prepare().expect("no parameters");
    let guess = State::<Ball> { e0: -0.9, e1: 0.3, e2: 0.2, e3: -0.1, ..Default::default() };
    let asked = || model.assemble(guess).set("zx", 0.36).set("zy", 0.48).set("xy", 0.2);
    let found = asked().modes(80).expect("it closes");
    // z may point up or down, 0.8 both ways, and x at right angles to it meets its circle x² + z² = 0.96 in two points.
    let mut expected = Vec::new();
    for zz in [0.8, -0.8] {
        let (square, half, rest): (f64, f64, f64) =
            (0.36 * 0.36 + zz * zz, 0.36 * 0.096, 0.096 * 0.096 - 0.96 * zz * zz);
        let root = (half * half - square * rest).sqrt();
        expected.extend([-1.0, 1.0].map(|sign| (zz, (-half + sign * root) / square)));
    }
    assert_eq!((found.modes.len(), found.movable), (4, 0), "{found:?}");
    for (zz, xx) in expected {
        let near = |mode: &&AssemblyMode<Ball>| {
            let told = model.outputs(0.0, &mode.state, &[]);
            (told.zz - zz).abs() < 1e-12 && (told.xx - xx).abs() < 1e-12
        };
        assert_eq!(found.modes.iter().filter(near).count(), 1, "{zz} {xx}");
    }
    // However few starts there are, of the two signs the one nearer to the guess is given.
    for starts in [5, 10, 20, 40, 80] {
        for mode in asked().modes(starts).expect("it closes").modes {
            let State::<Ball> { e0, e1, e2, e3, .. } = mode.state;
            assert!(-0.9 * e0 + 0.3 * e1 + 0.2 * e2 - 0.1 * e3 > 0.0, "{mode:?}");
        }
    }
    // Where a part of it is held, it has a sign: zz = 1 − 2 (e1² + e2²) leaves e3² = 0.09 of the norm.
    let held = model.assemble(guess).hold("e0").set("zx", 0.36).set("zy", 0.48).modes(40).expect("it closes");
    let last = |modes: &[AssemblyMode<Ball>]| {
        let mut last: Vec<f64> = modes.iter().map(|mode| mode.state.e3).collect();
        last.sort_by(f64::total_cmp);
        last
    };
    let e3 = last(&held.modes);
    assert!(e3.len() == 2 && (e3[0] + 0.3).abs() < 1e-13 && (e3[1] - 0.3).abs() < 1e-13, "{held:?}");
    // Upright and with a part held it is turned one way or the other, and all other parts differ by their signs alone.
    let guess = State::<Ball> { e0: 0.6, e1: 0.1, e2: 0.1, e3: 0.7, ..Default::default() };
    let held = model.assemble(guess).hold("e0").set("zx", 0.0).set("zy", 0.0).modes(40).expect("it closes");
    let e3 = last(&held.modes);
    assert!(e3.len() == 2 && (e3[0] + 0.8).abs() < 1e-13 && (e3[1] - 0.8).abs() < 1e-13, "{held:?}");
    // Half a turn away no sign is nearer to the guess: as it is, and turned about each axis.
    let guess = State::<Ball> { e0: 1.0, ..Default::default() };
    let halves = model.assemble(guess).set("zx", 0.0).set("zy", 0.0).set("xy", 0.0).modes(80).expect("it closes");
    assert_eq!((halves.modes.len(), halves.movable), (4, 0), "{halves:?}");
}

#[test]
fn a_guess_near_zero_tells_no_lengths() {
    let ring = Ring { l: 0.5 }.prepare().expect("a good parameter");
    for y in [0.0, 1e-9, -1e-3] {
        let found = ring.assemble(State::<Ring> { x: 0.3, y, ..Default::default() }).hold("x").modes(10);
        let found = found.expect("it closes");
        let mut heights: Vec<f64> = found.modes.iter().map(|mode| mode.state.y).collect();
        heights.sort_by(f64::total_cmp);
        let near = |at: usize, y: f64| heights.get(at).is_some_and(|height| (height - y).abs() < 1e-13);
        assert!(heights.len() == 2 && near(0, -0.4) && near(1, 0.4), "{found:?}");
        // The distance is in lengths of the mechanism, not of the guess.
        assert!(found.modes.iter().all(|mode| mode.distance > 0.1 && mode.distance < 10.0), "{found:?}");
    }
}

#[test]
fn what_is_held_altogether_has_one_mode_or_none() {
    let model = four_bar(1.0, 3.0, 2.0, 2.5);
    let guess = State::<FourBar> { crank: 0.3, coupler: 0.4, rocker: 1.2, ..Default::default() };
    let closed = model.assemble(guess).hold("crank").solve().expect("it closes");
    let held = |guess| model.assemble(guess).hold("crank").hold("coupler").hold("rocker").modes(3);
    let found = held(closed).expect("it is closed");
    assert_eq!((found.modes.len(), found.modes[0].starts, found.modes[0].state), (1, 4, closed));
    assert!(matches!(held(guess).unwrap_err(), Error::Assembly { .. }));
}
