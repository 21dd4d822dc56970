//! Each rule, and a contradiction for each place.

use super::{Units, check, declared};
use crate::syntax::tests::{declarations, rendered};
use crate::syntax::{Declarations, Diagnostics};

fn checked(source: &str) -> (Vec<String>, Units) {
    let declarations: Declarations = declarations(source);
    let mut diagnostics = Diagnostics::new();
    declared(&declarations, &mut diagnostics);
    let units = check(&declarations, &mut diagnostics);
    (rendered(source, &diagnostics), units)
}

fn units(source: &str) -> Units {
    let (errors, units) = checked(source);
    assert!(errors.is_empty(), "{source}: {errors:#?}");
    units
}

/// What is said, without its places.
fn said(source: &str) -> Vec<String> {
    let (errors, _) = checked(source);
    errors.iter().map(|error| error.split_once(": ").expect("a place and a message").1.to_owned()).collect()
}

/// The unit of an output over `m: kg`, `l: m`, `tau: s`, `x: m`, `a: 1`, `v: m/s`.
fn output(value: &str) -> (Vec<String>, Option<String>) {
    let source = format!(
        "#[coordinates(#[unit(m)] x, #[unit(rad)] a)] #[speeds(#[unit(m/s)] v, w)] #[kinematics(v = dot(x), w = dot(a))] \
         #[define(zero = 0, two = 1 + 1)] #[function(road(s), derivatives = [slope])] #[output(out = {value})] \
         struct M {{ #[unit(kg)] m: f64, #[unit(m)] l: f64, #[unit(s)] tau: f64, p: f64, q: f64 }}"
    );
    let (errors, units) = checked(&source);
    let errors = errors.iter().map(|error| error.split_once(' ').expect("a place").1.to_owned()).collect();
    (errors, units.of_output("out").map(str::to_owned))
}

#[test]
fn expressions_have_the_dimensions_of_their_rules() {
    for (value, expected) in [
        ("l + x", "m"),
        ("0 + l", "m"),
        ("l - 0*m", "m"),
        ("zero + m", "kg"),
        ("-m*l/tau", "kg*m/s"),
        ("2*PI*l", "m"),
        ("t", "s"),
        ("t/tau", "1"),
        ("dot(x)", "m/s"),
        ("ddot(x)", "m/s/s"),
        ("dot(v)", "m/s/s"),
        ("w", "1/s"),
        ("sin(x/l)", "1"),
        ("sqrt(l*x)", "m"),
        ("sqrt(l)", "m^(1/2)"),
        ("powi(l, 3)", "m*m*m"),
        ("powi(l, -two)", "1/m/m"),
        ("powf(l, 1/2)", "m^(1/2)"),
        ("powi(l, 4)", "m^4"),
        ("powf(x/l, a)", "1"),
        ("atan2(x, l)", "1"),
        ("min(x, l)", "m"),
        ("max(0, v)", "m/s"),
        ("abs(v)", "m/s"),
        ("sign(v)", "1"),
        ("if v < 0 { x } else { l }", "m"),
        ("m*powi(v, 2)/2", "N*m"),
        ("m*v/tau", "N"),
        ("m*powi(v, 2)/tau", "W"),
        ("dot(l*N.x, v*N.y)", "m*m/s"),
        ("norm(cross(l*N.x, v*N.y))", "m*m/s"),
        ("norm(unit(l*N.x))", "1"),
    ] {
        assert_eq!(output(value), (Vec::new(), Some(expected.to_owned())), "{value}");
    }
}

#[test]
fn what_is_not_known_is_no_error() {
    assert_eq!(output("p"), (Vec::new(), None));
    assert_eq!(output("p + sqrt(q)*road(l)"), (Vec::new(), None));
    // It follows where it is used.
    assert_eq!(output("p + l - powi(q, 2) + road(l)"), (Vec::new(), Some("m".to_owned())));
}

#[test]
fn contradictions_stand_at_their_operators() {
    for (value, expected) in [
        ("l + m", "`+`: a length (m) plus a mass (kg)"),
        ("l - tau", "`-`: a length (m) minus a time (s)"),
        ("1 + x", "`+`: a pure number plus a length (m)"),
        ("sin(l)", "`l`: `sin` of a length (m): its argument must be a pure number"),
        ("exp(2*l)", "`2*l`: `exp` of a length (m): its argument must be a pure number"),
        ("min(l, m)", "`min`: a length (m) compared with a mass (kg)"),
        ("atan2(l, m)", "`atan2`: a length (m) over a mass (kg)"),
        ("if l < m { x } else { l }", "`if`: a length (m) compared with a mass (kg)"),
        ("if l < x { m } else { l }", "`if`: a mass (kg) in one branch and, in the other, a length (m)"),
        ("powf(l, a)", "`l`: a length (m) to a power that is no constant: the base must be a pure number"),
        ("powf(a, l)", "`l`: an exponent must be a pure number, and this is a length (m)"),
        ("m*l + road(l) - road(m)", "`m`: the argument of `road` must be a length (m), and this is a mass (kg)"),
        ("dot(l*N.x, v*N.y) + m", "`+`: something in m*m/s plus a mass (kg)"),
    ] {
        assert_eq!(output(value).0, [expected], "{value}");
    }
}

#[test]
fn a_contradiction_is_told_once_and_tells_nothing_further() {
    assert_eq!(output("(l + m) + tau").0.len(), 1);
    assert_eq!(output("sin(l + m)").0.len(), 1);
    assert_eq!(output("(l + m)*(tau + m)").0.len(), 2);
}

#[test]
fn without_units_nothing_is_checked() {
    let source = "#[coordinates(x)] #[inertia(diag(m))] #[forces(sin(x) + x + m + t)] struct M { m: f64 }";
    assert_eq!(checked(source), (Vec::new(), Units::default()));
    // Numbers alone make no second of the time.
    let source = "#[coordinates(x)] #[inertia(diag(m))] #[forces(sin(x) + x + m + t)] struct M { #[unit(1)] m: f64 }";
    assert_eq!(units(source).of("x"), Some("1"));
}

#[test]
fn scales_are_no_numbers() {
    let source = "#[coordinates(#[unit(mm)] x)] #[inertia(diag(m))] #[forces(k*(l - x))] \
                  struct M { #[unit(kg)] m: f64, #[unit(m)] l: f64, k: f64 }";
    assert_eq!(said(source), ["a length (m) minus a length (mm); numbers are not converted, so give both in one unit"]);
    let source = "#[coordinates(#[unit(mm)] x)] #[inertia(diag(m))] #[forces(k*(l - x))] \
                  struct M { #[unit(g)] m: f64, #[unit(mm)] l: f64, k: f64 }";
    assert_eq!(units(source).of("k"), Some("10^-3*N/m"));
}

#[test]
fn names_of_units() {
    let of = |unit: &str| {
        said(&format!("#[coordinates(x)] #[inertia(diag(m))] #[forces(0)] struct M {{ #[unit({unit})] m: f64 }}"))
    };
    for known in ["kg*m*m", "N*s/m", "1", "kPa", "mol*K", "Ohm*A/V", "powi(s, -2)*Hz", "rad", "mN*um", "cd/GHz"] {
        assert!(of(known).is_empty(), "{known}");
    }
    let unknown = of("meter/sec");
    for (message, name, meant) in [(&unknown[0], "meter", "m"), (&unknown[1], "sec", "s")] {
        assert!(message.starts_with(&format!("there is no unit `{name}` (units are products")), "{unknown:?}");
        assert!(message.ends_with(&format!("with prefixes); did you mean `{meant}`?")), "{unknown:?}");
    }
    assert_eq!(
        of("N*deg"),
        ["`deg` is no power of ten of the other units, and numbers are not converted; angles are in radians: `rad`"]
    );
    assert!(of("rpm")[0].ends_with("write `rad/s`") && of("krad")[0].starts_with("there is no unit `krad`"));
}

/// A pendulum, statement by statement.
const PENDULUM: &str = "#[coordinates(q, s)] #[frame(A = rotate(N, z, q))] #[point(P = O + l*A.x, Q = prismatic(P, A.y, s))] \
    #[body(bar = { frame: A, center: P, mass: m, inertia: rod(m, l, x) })] #[particle(bob = { at: Q, mass: m2 })] #[inputs(f, tau)] \
    #[gravity(-g*N.y)] #[force(push = { at: Q, value: f*N.x })] #[torque(drive = { on: A, value: tau*N.z })] \
    #[spring(k1 = { from: O, to: Q, stiffness: k, length: l0 }, k2 = { of: q, stiffness: kq })] \
    #[damper(d1 = { of: s, coefficient: c }, d2 = { of: q, coefficient: cq })] #[armature(rotor = { of: q, inertia: j })] \
    #[generalized_force(q = gq, s = gs)] #[constraint(slot: dot(Q, N.x) == 0)] #[constraint(roll: dot(s) == r*dot(q))] \
    #[constraint(slow: ddot(s) == b*ddot(q))] #[release(pull = { point: P, along: A.x })] \
    #[define(held = 2*reaction(slot))] #[output(swing = dot(angular_momentum(bar, O), N.z), lift = momentum(bar), hold = held, turn = angular_velocity(A), fall = acceleration(Q))]";

const FIELDS: [&str; 15] = ["m: kg", "l", "m2", "g", "k", "l0", "kq", "c", "cq", "j", "gq", "gs", "r", "b", "none"];

/// The pendulum with one statement written differently, and with fields of these units.
fn pendulum(from: &str, to: &str, given: &[(&str, &str)]) -> String {
    assert!(PENDULUM.contains(from), "{from}");
    let fields = FIELDS.map(|field| {
        let name = field.split(':').next().unwrap_or(field);
        let unit = given.iter().find(|(known, _)| *known == name).map(|(_, unit)| *unit);
        let unit = unit.or(field.split_once(": ").map(|(_, unit)| unit));
        format!("{} {name}: f64", unit.map_or_else(String::new, |unit| format!("#[unit({unit})]")))
    });
    format!("{} struct M {{ {} }}", PENDULUM.replacen(from, to, 1), fields.join(", "))
}

#[test]
fn mechanics_tells_units() {
    let units = units(&pendulum("N", "N", &[("l", "m")]));
    for (name, unit) in [
        ("q", "1"),
        ("dot_q", "1/s"),
        ("s", "m"),
        ("dot_s", "m/s"),
        ("m2", "kg"),
        ("g", "m/s/s"),
        ("f", "N"),
        ("tau", "N*m"),
        ("k", "N/m"),
        ("l0", "m"),
        ("kq", "N*m"),
        ("c", "N*s/m"),
        ("cq", "N*m*s"),
        ("j", "kg*m*m"),
        ("gq", "N*m"),
        ("gs", "N"),
        ("r", "m"),
        ("b", "m"),
    ] {
        assert_eq!(units.of(name), Some(unit), "{name}");
    }
    assert_eq!(units.of("none"), None);
    for (output, unit) in [("swing", "N*m*s"), ("lift", "kg*m/s"), ("hold", "N"), ("turn", "1/s"), ("fall", "m/s/s")] {
        assert_eq!(units.of_output(output), Some(unit), "{output}");
    }
    for row in ["slot", "roll", "slow", "pull"] {
        assert_eq!(units.of_multiplier(row), Some("N"), "{row}");
    }
}

#[test]
fn mechanics_contradicts() {
    for (from, to, given, expected) in [
        ("rotate(N, z, q)", "rotate(N, z, l)", ("l", "m"), "an angle must be a pure number, and this is a length (m)"),
        ("O + l*A.x", "O + m*A.x", ("l", "m"), "a length (m) plus a mass (kg)"),
        ("mass: m,", "mass: l,", ("l", "m"), "the mass of a body must be a mass (kg), and this is a length (m)"),
        (
            "rod(m, l, x)",
            "rod(m, m, x)",
            ("l", "m"),
            "a measure of a rod must be a length (m), and this is a mass (kg)",
        ),
        (
            "rod(m, l, x)",
            "diag(m, 0, 0)",
            ("l", "m"),
            "the inertia of a body must be a moment of inertia (kg*m*m), and this is a mass (kg)",
        ),
        ("-g*N.y", "-m*N.y", ("l", "m"), "gravity must be an acceleration (m/s/s), and this is a mass (kg)"),
        (
            "f*N.x",
            "m*g*l*N.x",
            ("l", "m"),
            "this value must be a force (N), and this is a torque or energy (N*m); the unit of `g` follows from `gravity`",
        ),
        ("tau*N.z", "m*N.z", ("l", "m"), "this value must be a torque or energy (N*m), and this is a mass (kg)"),
        (
            "stiffness: k,",
            "stiffness: m,",
            ("l", "m"),
            "the stiffness of this spring must be a stiffness (N/m), and this is a mass (kg)",
        ),
        (
            "coefficient: c ",
            "coefficient: m ",
            ("l", "m"),
            "the coefficient of this damper must be a damping (N*s/m), and this is a mass (kg)",
        ),
        (
            "inertia: j",
            "inertia: m",
            ("l", "m"),
            "the inertia of this armature must be a moment of inertia (kg*m*m), and this is a mass (kg)",
        ),
        (
            "q = gq",
            "q = m",
            ("l", "m"),
            "the force whose power is that with the rate of `q` must be a torque or energy (N*m), and this is a mass (kg)",
        ),
        ("== 0)", "== m)", ("l", "m"), "a length (m) set equal to a mass (kg)"),
    ] {
        assert_eq!(said(&pendulum(from, to, &[given])), [expected], "{to}");
    }
}

#[test]
fn equations_tell_units_and_contradict() {
    let model = |forces: &str, inertia: &str, energy: &str| {
        format!(
            "#[coordinates(x, phi)] #[speeds(v, w)] #[kinematics(v = dot(x), w = dot(phi) + v/r)] #[inertia({inertia})] \
             #[forces({forces})] #[potential_energy({energy})] #[define(n = sin(phi))] #[independent(u = v + r*w)] \
             struct M {{ #[unit(kg)] m: f64, #[unit(m)] r: f64, g: f64, j: f64 }}"
        )
    };
    let found = units(&model("-m*g, g*j/r*n", "diag(m, j)", "m*g*x"));
    for (name, unit) in [("x", "m"), ("v", "m/s"), ("w", "1/s"), ("g", "m/s/s"), ("j", "kg*m*m"), ("u", "m/s")] {
        assert_eq!(found.of(name), Some(unit), "{name}");
    }
    assert_eq!(
        said(&model("-m*g, 0", "matrix([m, m*r], [_, m])", "m*g*x")),
        [
            "the inertia whose energy is that with `w` and `w` must be a moment of inertia (kg*m*m), and this is a mass (kg)"
        ]
    );
    assert_eq!(
        said(&model("-m*g, m*g", "diag(m, m*r*r)", "m*g*x")),
        [
            "the force whose power is that with `w` must be a torque or energy (N*m), and this is a force (N); the unit of `g` follows \
          from `potential_energy`"
        ]
    );
    assert_eq!(
        said(&model("0, 0", "diag(m, m*r*r)", "m*x")),
        [
            "`potential_energy` must be a torque or energy (N*m), and this is a mass times a length (kg*m); the unit of `x` follows \
          from `kinematics`"
        ]
    );
}

#[test]
fn units_stand_before_names_of_lists() {
    let source = "#[size(m = 2)] #[coordinates(#[unit(m)] /** where */ x[m], #[unit(rad)] y)] #[inputs(#[unit(N)] f)] \
                  #[inertia(diag(a, a, b))] #[forces(f, 0, 0)] struct M { a: f64, b: f64 }";
    let found = units(source);
    assert_eq!(
        (found.of("x_0"), found.of("x_1"), found.of("y"), found.of("f")),
        (Some("m"), Some("m"), Some("rad"), Some("N"))
    );
    assert_eq!(declarations(source).coordinates[0].docs, [" where "]);
}
