//! The oracle's geometry by itself: mechanisms by bodies, against the same by equations that were worked out by hand. No engine.

mod random;
mod support;

use nalgebra::DMatrix;
use oracle::{Declaration, Scaled, System, closed, onto_velocity_rows, read_models};
use random::{counted, mechanism};
use support::golden::{assert_close, assert_close_at};
use support::splitmix::SplitMix;

const TOLERANCE: f64 = 1e-13;
const STATES: usize = 20;

fn model(source: &str) -> Declaration {
    read_models(source).remove(0)
}

fn values(entries: &[Scaled]) -> Vec<f64> {
    entries.iter().map(|e| e.value).collect()
}

/// The mechanism by bodies and its twin by equations say the same at random states.
fn are_twins(bodies: &str, equations: &str) {
    let models = [bodies, equations].map(model);
    let [one, other] = &models;
    assert_eq!((&one.coordinates, &one.speeds, &one.inputs), (&other.coordinates, &other.speeds, &other.inputs));
    let names =
        |model: &Declaration| model.constraints.iter().map(|row| (row.name.clone(), row.level)).collect::<Vec<_>>();
    assert_eq!(names(one), names(other));
    let mut random = SplitMix::new(31);
    for _ in 0..STATES {
        let parameters = random.vector(one.parameters.len(), 0.5, 1.5);
        let inputs = random.vector(one.inputs.len(), -1.0, 1.0);
        let [one, other] =
            models.each_ref().map(|model| System { model, parameters: parameters.clone(), inputs: inputs.clone() });
        let t = random.between(0.0, 2.0);
        let x = closed(&one, t, &random.vector(one.model.coordinates.len(), 0.2, 1.0)).expect("it closes");
        let v = onto_velocity_rows(&one, t, &x, &random.vector(one.model.n(), -1.0, 1.0)).expect("it moves");
        let said = [&one, &other].map(|system| {
            let (dynamics, rows, motion) =
                (system.dynamics(t, &x, &v), system.rows(t, &x, &v), system.motion(t, &x, &v));
            let matrix = |m: &DMatrix<Scaled>| values(m.as_slice());
            [
                ("A", matrix(&dynamics.a)),
                ("a0", values(dynamics.a0.as_slice())),
                ("M", matrix(&dynamics.m)),
                ("h*", values(dynamics.h.as_slice())),
                ("T", vec![dynamics.kinetic.value]),
                ("V", dynamics.potential.map(|v| vec![v.value]).unwrap_or_default()),
                ("C", matrix(&rows.c)),
                ("c0*", values(rows.c0.as_slice())),
                ("v̇", motion.acceleration.as_slice().to_vec()),
                ("λ", motion.multipliers.as_slice().to_vec()),
                ("M v̇ − h*", motion.reaction.as_slice().to_vec()),
            ]
        });
        let [one, other] = said;
        for ((what, one), (_, other)) in one.iter().zip(&other) {
            // through the matrix of all accelerations and forces, some digits are lost
            let tolerance = if matches!(*what, "v̇" | "λ" | "M v̇ − h*") { 100.0 } else { 1.0 } * TOLERANCE;
            // everything is of order one, and what vanishes does so by cancelling
            let scale = other.iter().fold(1.0_f64, |scale, e| scale.max(e.abs()));
            assert_eq!(one.len(), other.len(), "{what}");
            for (one, other) in one.iter().zip(other) {
                assert!((one - other).abs() <= tolerance * scale, "{what}: {one:e} and {other:e} at scale {scale:e}");
            }
        }
    }
}

#[test]
fn pendulum() {
    let bodies = "#[derive(ConstrainedSystem)]
        #[coordinates(a)]
        #[frame(A = rotate(N, z, a))]
        #[body(bar = { frame: A, center: O + l/2*A.x, mass: m, inertia: rod(m, l, x) })]
        #[gravity(-g*N.y)]
        struct Pendulum { m: f64, l: f64, g: f64 }";
    let equations = "#[derive(ConstrainedSystem)]
        #[coordinates(a)]
        #[inertia(diag(m*l*l/3))]
        #[forces(-m*g*l/2*cos(a))]
        #[potential_energy(m*g*l/2*sin(a))]
        struct Pendulum { m: f64, l: f64, g: f64 }";
    are_twins(bodies, equations);
}

/// Two rods, the second angle relative; a motor in the elbow with its rotor, friction, and a spring that is turned.
#[test]
fn double_pendulum() {
    let bodies = "#[derive(ConstrainedSystem)]
        #[coordinates(a, b)]
        #[inputs(tau)]
        #[frame(A = rotate(N, z, a), B = rotate(A, z, b))]
        #[point(P = O + l*A.x)]
        #[body(upper = { frame: A, center: O + l/2*A.x, mass: m, inertia: rod(m, l, x) })]
        #[body(lower = { frame: B, center: P + l/2*B.x, mass: m, inertia: cylinder(m, r, l, x) })]
        #[gravity(-g*N.y)]
        #[torque(drive = { on: B, value: tau*N.z, from: upper })]
        #[generalized_force(a = -c*dot(a))]
        #[damper(friction = { of: 2*b, coefficient: c })]
        #[spring(winding = { of: b + a, stiffness: k, length: 1/2 })]
        #[armature(rotor = { of: 3*b, inertia: j })]
        struct Two { m: f64, l: f64, r: f64, g: f64, c: f64, k: f64, j: f64 }";
    let equations = "#[derive(ConstrainedSystem)]
        #[coordinates(a, b)]
        #[inputs(tau)]
        #[define(i = m*l*l/3 + m*r*r/4, half = m*l*l/2, wound = k*(a + b - 1/2))]
        #[inertia(matrix([4*m*l*l/3 + i + 2*half*cos(b), i + half*cos(b)], [_, i + 9*j]))]
        #[forces(
            half*sin(b)*(2*dot(a)*dot(b) + powi(dot(b), 2)) - m*g*l*(3*cos(a) + cos(a + b))/2 - c*dot(a) - wound,
            -half*sin(b)*powi(dot(a), 2) - m*g*l*cos(a + b)/2 + tau - 4*c*dot(b) - wound,
        )]
        #[potential_energy(m*g*l*(3*sin(a) + sin(a + b))/2 + k*powi(a + b - 1/2, 2)/2)]
        struct Two { m: f64, l: f64, r: f64, g: f64, c: f64, k: f64, j: f64 }";
    are_twins(bodies, equations);
}

/// A free body by a quaternion behind a rotation, by Euler's equations in its own axes.
#[test]
fn rock_by_a_quaternion() {
    let bodies = "#[derive(ConstrainedSystem)]
        #[coordinates(x, e0, e1, e2, e3)]
        #[frame(B = quaternion(rotate(N, x, a), e0, e1, e2, e3))]
        #[body(rock = { frame: B, center: O + x*N.x, mass: m, inertia: diag(i, j, k) })]
        #[torque(jet = { on: rock, value: p*B.x + q*N.x })]
        #[constraint(slide: dot(x) - r*dot(angular_velocity(B), B.z) == 0)]
        struct Rock { a: f64, m: f64, i: f64, j: f64, k: f64, p: f64, q: f64, r: f64 }";
    let equations = "#[derive(ConstrainedSystem)]
        #[coordinates(x, e0, e1, e2, e3)]
        #[speeds(dot_x, omega_B_x, omega_B_y, omega_B_z, norm_rate_B)]
        #[define(w1 = omega_B_x, w2 = omega_B_y, w3 = omega_B_z)]
        #[kinematics(
            dot(x) = dot_x,
            dot(e0) = -(e1*w1 + e2*w2 + e3*w3)/2 + e0*norm_rate_B,
            dot(e1) = (e0*w1 - e3*w2 + e2*w3)/2 + e1*norm_rate_B,
            dot(e2) = (e3*w1 + e0*w2 - e1*w3)/2 + e2*norm_rate_B,
            dot(e3) = (-e2*w1 + e1*w2 + e0*w3)/2 + e3*norm_rate_B,
        )]
        #[inertia(diag(m, i, j, k, 1))]
        #[forces(
            0,
            p + q*(e0*e0 + e1*e1 - e2*e2 - e3*e3) - (k - j)*w2*w3,
            2*q*(e1*e2 - e0*e3) - (i - k)*w3*w1,
            2*q*(e1*e3 + e0*e2) - (j - i)*w1*w2,
            0,
        )]
        #[constraint(slide: dot_x - r*w3 == 0)]
        #[constraint(norm_B: (e0*e0 + e1*e1 + e2*e2 + e3*e3)/2 == 1/2)]
        struct Rock { a: f64, m: f64, i: f64, j: f64, k: f64, p: f64, q: f64, r: f64 }";
    are_twins(bodies, equations);
}

/// A top about its fixed point, in the angles z-x-z, by Lagrange's equations.
#[test]
fn heavy_top() {
    let bodies = "#[derive(ConstrainedSystem)]
        #[coordinates(psi, theta, phi)]
        #[frame(T = rotate(rotate(rotate(N, z, psi), x, theta), z, phi))]
        #[body(top = { frame: T, center: O + l*T.z, mass: m, inertia: diag(j, j, k), about: O })]
        #[gravity(-g*N.z)]
        struct Top { m: f64, l: f64, j: f64, k: f64, g: f64 }";
    let equations = "#[derive(ConstrainedSystem)]
        #[coordinates(psi, theta, phi)]
        #[define(s = sin(theta), c = cos(theta), spin = dot(phi) + dot(psi)*c)]
        #[inertia(matrix([j*s*s + k*c*c, 0, k*c], [_, j, 0], [_, _, k]))]
        #[forces(
            (k - 2*j)*dot(psi)*dot(theta)*s*c + k*spin*s*dot(theta),
            j*powi(dot(psi), 2)*s*c - k*spin*dot(psi)*s + m*g*l*s,
            k*dot(psi)*dot(theta)*s,
        )]
        #[potential_energy(m*g*l*c)]
        struct Top { m: f64, l: f64, j: f64, k: f64, g: f64 }";
    are_twins(bodies, equations);
}

/// The disk of the paper: its speeds are components of velocities in the frame of its axis, its equations those of the paper.
#[test]
fn rolling_disk() {
    let bodies = "#[derive(ConstrainedSystem)]
        #[coordinates(x, y, z, phi, theta, psi)]
        #[speeds(v1, v2, v3, v4, v5, v6)]
        #[frame(F = rotate(rotate(N, z, phi), x, PI/2 - theta), D = rotate(F, z, psi))]
        #[point(P = O + x*N.x + y*N.y + z*N.z, G = P + r*F.y)]
        #[define(w = angular_velocity(D))]
        #[kinematics(
            v1 = dot(velocity(G), F.x), v2 = dot(velocity(G), F.y), v3 = dot(velocity(G), F.z),
            v4 = dot(w, F.x), v5 = dot(w, F.y), v6 = dot(w, F.z),
        )]
        #[body(disk = { frame: D, center: G, mass: m, inertia: diag(j, j, 2*j) })]
        #[gravity(-g*N.z)]
        #[constraint(no_slip: velocity(P, disk) == 0, expressed = F)]
        struct Disk { m: f64, r: f64, j: f64, g: f64 }";
    let paper = "#[derive(ConstrainedSystem)]
        #[coordinates(x, y, z, phi, theta, psi)]
        #[speeds(v1, v2, v3, v4, v5, v6)]
        #[kinematics(
            v1 = dot(x)*cos(phi) + dot(y)*sin(phi) - r*sin(theta)*dot(phi),
            v2 = -dot(x)*sin(theta)*sin(phi) + dot(y)*sin(theta)*cos(phi) + dot(z)*cos(theta),
            v3 = dot(x)*cos(theta)*sin(phi) - dot(y)*cos(theta)*cos(phi) + dot(z)*sin(theta) - r*dot(theta),
            v4 = -dot(theta),
            v5 = dot(phi)*cos(theta),
            v6 = dot(psi) + dot(phi)*sin(theta),
        )]
        #[inertia(diag(m, m, m, j, j, 2*j))]
        #[forces(
            m*v5*(v2*tan(theta) - v3),
            m*(v4*v3 - v5*v1*tan(theta) - g*cos(theta)),
            m*(v5*v1 - v4*v2 - g*sin(theta)),
            j*v5*(v5*tan(theta) - 2*v6),
            j*v4*(2*v6 - v5*tan(theta)),
            0,
        )]
        #[potential_energy(m*g*(z + r*cos(theta)))]
        #[constraint(no_slip_x: v1 + r*v6 == 0, no_slip_y: v2 == 0, no_slip_z: v3 - r*v4 == 0)]
        struct Disk { m: f64, r: f64, j: f64, g: f64 }";
    are_twins(bodies, paper);
}

#[test]
fn sleigh() {
    let bodies = "#[derive(ConstrainedSystem)]
        #[coordinates(x, y, theta)]
        #[frame(A = rotate(N, z, theta))]
        #[point(P = O + x*N.x + y*N.y)]
        #[body(sleigh = { frame: A, center: P + a*A.x, mass: m, inertia: planar(i) })]
        #[constraint(blade: dot(velocity(P), A.y) == 0)]
        struct Sleigh { m: f64, i: f64, a: f64 }";
    let equations = "#[derive(ConstrainedSystem)]
        #[coordinates(x, y, theta)]
        #[inertia(matrix([m, 0, -m*a*sin(theta)], [_, m, m*a*cos(theta)], [_, _, i + m*a*a]))]
        #[forces(m*a*cos(theta)*powi(dot(theta), 2), m*a*sin(theta)*powi(dot(theta), 2), 0)]
        #[constraint(blade: -dot(x)*sin(theta) + dot(y)*cos(theta) == 0)]
        struct Sleigh { m: f64, i: f64, a: f64 }";
    are_twins(bodies, equations);
}

/// Three beads by families: on springs and dampers between points, one pushed and one pushing back, on a turntable that time turns.
#[test]
fn beads_on_a_turntable() {
    let bodies = "#[derive(ConstrainedSystem)]
        #[size(n = 3)]
        #[coordinates(s[n])]
        #[inputs(f)]
        #[frame(A = rotate(N, z, w*t))]
        #[point(B[0] = O + s[0]*A.x + h*A.y, B[i] = B[i - 1] + s[i]*A.x for i in 1..n)]
        #[particle(bead[i] = { at: B[i], mass: m[i] } for i in 0..n)]
        #[spring(link[i] = { from: B[i - 1], to: B[i], stiffness: k, length: l } for i in 1..n)]
        #[damper(oil[i] = { to: B[i - 1], from: B[i], coefficient: c } for i in 1..n)]
        #[force(push = { at: B[0], value: f*unit(A.x + A.y), from: B[2] })]
        struct Beads { m: [f64; 3], k: f64, l: f64, c: f64, w: f64, h: f64 }";
    // each bead at its distance d along the groove, which goes round
    let equations = "#[derive(ConstrainedSystem)]
        #[coordinates(s_0, s_1, s_2)]
        #[inputs(f)]
        #[define(d0 = s_0, d1 = d0 + s_1, d2 = d1 + s_2, w2 = powi(w, 2), push = f/sqrt(2))]
        #[define(m12 = m_1 + m_2, v1 = dot(s_0) + dot(s_1), v2 = v1 + dot(s_2))]
        #[kinetic_energy(
            (m_0*(powi(dot(s_0) - h*w, 2) + w2*powi(d0, 2)) + m_1*(powi(v1 - h*w, 2) + w2*powi(d1, 2))
                + m_2*(powi(v2 - h*w, 2) + w2*powi(d2, 2)))/2
        )]
        #[potential_energy(k*(powi(s_1 - l, 2) + powi(s_2 - l, 2))/2)]
        #[forces(0, -c*dot(s_1) - push, -c*dot(s_2) - push)]
        struct Beads { m_0: f64, m_1: f64, m_2: f64, k: f64, l: f64, c: f64, w: f64, h: f64 }";
    are_twins(bodies, equations);
}

/// A four-bar linkage closed by a vector equation: its row across the plane is dropped.
#[test]
fn four_bar() {
    let bodies = "#[derive(ConstrainedSystem)]
        #[coordinates(q1, q2, q3)]
        #[frame(A = rotate(N, z, q1), B = rotate(N, z, q2), C = rotate(N, z, q3))]
        #[point(P = O + a*A.x, Q = P + b*B.x, S = O + N.x + c*C.x)]
        #[body(crank = { frame: A, center: O + a/2*A.x, mass: m, inertia: rod(m, a, x) })]
        #[body(coupler = { frame: B, center: P + b/2*B.x, mass: m, inertia: rod(m, b, x) })]
        #[body(rocker = { frame: C, center: O + N.x + c/2*C.x, mass: m, inertia: rod(m, c, x) })]
        #[gravity(-g*N.y)]
        #[constraint(closure: Q == S)]
        struct FourBar { m: f64, a: f64, b: f64, c: f64, g: f64 }";
    let equations = "#[derive(ConstrainedSystem)]
        #[coordinates(q1, q2, q3)]
        #[define(d = q1 - q2)]
        #[inertia(matrix([m*a*a*4/3, m*a*b/2*cos(d), 0], [_, m*b*b/3, 0], [_, _, m*c*c/3]))]
        #[forces(
            -m*a*b/2*sin(d)*powi(dot(q2), 2) - m*g*a*cos(q1)*3/2,
            m*a*b/2*sin(d)*powi(dot(q1), 2) - m*g*b/2*cos(q2),
            -m*g*c/2*cos(q3),
        )]
        #[potential_energy(m*g*(3*a*sin(q1) + b*sin(q2) + c*sin(q3))/2)]
        #[constraint(closure_x: a*cos(q1) + b*cos(q2) == 1 + c*cos(q3))]
        #[constraint(closure_y: a*sin(q1) + b*sin(q2) == c*sin(q3))]
        struct FourBar { m: f64, a: f64, b: f64, c: f64, g: f64 }";
    are_twins(bodies, equations);
}

/// Every form of inertia against the integrals that it stands for: a body that turns about its centre with the angular velocity
/// (2, 3, 5), whose kinetic energy is a sum over the entries of the tensor.
#[test]
fn forms_of_inertia() {
    let m = 1.7;
    let (l, r, h) = (0.6, 0.4, 0.9);
    let forms = [
        ("rod(m, l, y)", [m * l * l / 12.0, 0.0, m * l * l / 12.0], [0.0; 3]),
        ("disk(m, r, x)", [m * r * r / 2.0, m * r * r / 4.0, m * r * r / 4.0], [0.0; 3]),
        (
            "cylinder(m, r, h, z)",
            [m * (3.0 * r * r + h * h) / 12.0, m * (3.0 * r * r + h * h) / 12.0, m * r * r / 2.0],
            [0.0; 3],
        ),
        ("sphere(m, r)", [0.4 * m * r * r; 3], [0.0; 3]),
        (
            "cuboid(m, l, r, h)",
            [m * (r * r + h * h) / 12.0, m * (l * l + h * h) / 12.0, m * (l * l + r * r) / 12.0],
            [0.0; 3],
        ),
        ("planar(l)", [0.0, 0.0, l], [0.0; 3]),
        ("diag(l, r, h)", [l, r, h], [0.0; 3]),
        ("matrix([2, -l/9, r/9], [_, 3, -h/9], [_, _, 4])", [2.0, 3.0, 4.0], [-l / 9.0, r / 9.0, -h / 9.0]),
    ];
    for (form, diagonal, [xy, xz, yz]) in forms {
        let source = format!(
            "#[derive(ConstrainedSystem)]
            #[coordinates(a, b, c)]
            #[speeds(wx, wy, wz)]
            #[frame(A = rotate(rotate(rotate(N, x, a), unit(3*N.y + 4*N.z), -b), -y, c))]
            #[kinematics(
                wx = dot(angular_velocity(A), A.x),
                wy = dot(angular_velocity(A), A.y),
                wz = dot(angular_velocity(A), A.z),
            )]
            #[body(body = {{ frame: A, center: O, mass: m, inertia: {form} }})]
            struct Body {{ m: f64, l: f64, r: f64, h: f64 }}"
        );
        let model = model(&source);
        let system = System { model: &model, parameters: vec![m, l, r, h], inputs: Vec::new() };
        let w = [2.0, 3.0, 5.0];
        let dynamics = system.dynamics(0.0, &[0.3, -0.4, 0.7], &w);
        let squares: f64 = (0..3).map(|i| diagonal[i] * w[i] * w[i] / 2.0).sum();
        let energy = squares + xy * w[0] * w[1] + xz * w[0] * w[2] + yz * w[1] * w[2];
        assert_close(form, &[dynamics.kinetic.value], &[energy], TOLERANCE);
        // Euler: I ẇ = −w × (I w)
        let tensor = nalgebra::Matrix3::new(diagonal[0], xy, xz, xy, diagonal[1], yz, xz, yz, diagonal[2]);
        let euler = (tensor * nalgebra::Vector3::from(w)).cross(&nalgebra::Vector3::from(w));
        assert_close_at(form, &values(dynamics.h.as_slice()), euler.as_slice(), TOLERANCE, 1.0);
        assert_close(form, &values(dynamics.m.as_slice()), tensor.as_slice(), TOLERANCE);
    }
}

/// How many random mechanisms are looked at.
const MECHANISMS: usize = 60;

/// A random state of a mechanism, on its constraints.
fn state(system: &System<'_>, random: &mut SplitMix) -> Option<(f64, Vec<f64>, Vec<f64>)> {
    let t = random.between(0.0, 2.0);
    let x = closed(system, t, &random.vector(system.model.coordinates.len(), -1.0, 1.0))?;
    let v = onto_velocity_rows(system, t, &x, &random.vector(system.model.n(), -1.0, 1.0))?;
    Some((t, x, v))
}

/// Statements by which a mechanism gains or loses energy.
fn feeds(line: &str) -> bool {
    ["#[force(", "#[forces(", "#[torque(", "#[damper(", "#[generalized_force("]
        .iter()
        .any(|statement| line.starts_with(statement))
}

/// Where no force takes energy and time moves nothing, the motion by the full system keeps T + V.
#[test]
fn random_mechanisms_keep_their_energy() {
    let mut random = SplitMix::new(8);
    let (mut found, mut conservative) = (Vec::new(), 0);
    for number in 0..MECHANISMS {
        let mechanism = mechanism(7, number);
        let source: String =
            mechanism.source.lines().filter(|line| !feeds(line)).flat_map(|line| [line, "\n"]).collect();
        let declared = model(&source);
        let mut system = System::nominal(&declared);
        system.inputs = random.vector(declared.inputs.len(), -1.0, 1.0);
        let place = format!("{}\n{}", mechanism.name, mechanism.source);
        let (t, x, v) = (0..20).find_map(|_| state(&system, &mut random)).unwrap_or_else(|| panic!("{place}"));
        let motion = system.motion(t, &x, &v);
        let rows = system.rows(t, &x, &v);
        // M v̇ − h* = Cᵀ λ, with the M and h* that the bodies add up to
        let reaction = rows.c.map(|e| e.value).transpose() * &motion.multipliers;
        let scale = motion.reaction.amax().max(1.0) * motion.condition;
        assert!((&motion.reaction - reaction).amax() <= 1e-13 * scale, "{place}");
        found.extend(mechanism.classes.clone());
        let in_time = ["*t", "(t)", "*cross(N.z, P1)", "acceleration(Held)"].iter().any(|sign| source.contains(sign));
        if in_time {
            continue;
        }
        conservative += 1;
        let rates = system.rates(t, &x, &v);
        let along = |values: &[f64], rates: &[f64], h: f64| -> Vec<f64> {
            values.iter().zip(rates).map(|(value, rate)| value + h * rate).collect()
        };
        let energy = |h: f64| {
            let dynamics = system.dynamics(t, &along(&x, &rates, h), &along(&v, motion.acceleration.as_slice(), h));
            dynamics.kinetic.value + dynamics.potential.map_or(0.0, |potential| potential.value)
        };
        let step = 1e-3 / (1.0 + motion.acceleration.amax());
        let change =
            (8.0 * (energy(step) - energy(-step)) - (energy(2.0 * step) - energy(-2.0 * step))) / (12.0 * step);
        let dynamics = system.dynamics(t, &x, &v);
        let size = dynamics.kinetic.size + dynamics.potential.map_or(0.0, |potential| potential.size);
        let power = dynamics.h.iter().zip(&v).fold(size, |sum, (h, v)| sum + (h.value * v).abs());
        assert!(change.abs() <= 1e-9 * power + 1e-14 * size / step, "{change:e} at {power:e}, {place}");
    }
    println!("{}{conservative} of them conservative", counted(found.iter().map(String::as_str)));
    assert!(conservative >= MECHANISMS / 2, "{conservative}");
}
