//! The derive of [holonomy](https://docs.rs/holonomy): a mechanism declared on a struct of parameters becomes its
//! equations of motion.
//!
//! Depend on `holonomy`, which re-exports the derive; this crate is its macro half.
#![deny(missing_docs)]

use proc_macro::TokenStream;

/// Derives the minimal equations of motion and every constraint reaction of a declared mechanism.
///
/// The struct's fields are the parameters. Everything else stands in attributes below the derive, one statement each;
/// expressions are Rust expressions.
///
/// ```
/// use holonomy::{ConstrainedSystem, State};
///
/// /// A pendulum in the plane, its rod kept as a constraint.
/// #[derive(ConstrainedSystem, Clone)]
/// #[coordinates(x, y)]
/// #[inertia(diag(m, m))]
/// #[forces(0, -m*g)]
/// #[potential_energy(m*g*y)]
/// #[configuration(of(alpha), x = l*sin(alpha), y = -l*cos(alpha))]
/// #[constraint(rod: (powi(x, 2) + powi(y, 2) - powi(l, 2))/2 == 0)]
/// struct Pendulum {
///     m: f64,
///     l: f64,
///     g: f64,
/// }
///
/// # fn main() -> Result<(), holonomy::Error> {
/// let pendulum = Pendulum { m: 1.0, l: 2.0, g: 9.81 }.prepare()?;
/// let start = State::<Pendulum> { alpha: 0.1, dot_alpha: 0.0 };
/// let run = pendulum.simulate(start).until(1.0)?;
/// let (t, end) = run.last();
/// assert!((pendulum.energy(t, end) - pendulum.energy(0.0, &start)).abs() < 1e-6);
/// // The rod's force on the mass is Cᵀ λ: with C = [x, y] it is l·λ along the rod.
/// println!("{}", 2.0 * pendulum.multipliers(t, end, &[]).rod);
/// # Ok(())
/// # }
/// ```
///
/// # Statements
///
/// | statement | what it declares |
/// |---|---|
/// | `coordinates(x, y)` | the coordinates x, with doc comments before the names |
/// | `speeds(v1, v2)` | the speeds v; without it v = ẋ, each called `dot_x` |
/// | `kinematics(v1 = .., ..)` or `kinematics(dot(x) = .., ..)` | v = B ẋ + b0 (2.2) or ẋ = A v + a0 (2.1); the other direction is derived, or checked where both are given |
/// | `inertia(diag(..))`, `inertia(matrix([a, b], [_, c]))` | M (2.3); `_` stands for the entry across the diagonal |
/// | `forces(..)` | h* (2.3): all of it, gyroscopic terms included, one entry a speed. Beside `kinetic_energy`: the further generalised forces, conjugate to v; may be left out there |
/// | `kinetic_energy(T)` | T(v, x, t), quadratic in v (rates `dot(x)` may stand in it): M is ∂²T/∂v² and h* holds the inertia terms, those of Boltzmann and Hamel included, and −Aᵀ ∂V/∂x of a `potential_energy`; an `inertia` beside it is checked against it |
/// | `constraint(name: left == right)` | a row; its kind is read off what it mentions: f(x, t), φ(v, x, t), which need not be linear in v, or with `dot(v)`, `ddot(q)` a row that is linear in accelerations; f is left minus right |
/// | `constraint(name: left == right, redundant)` | the same, where it may depend on other rows: if it does, identically or at the `start` and beside it, and says nothing else, it stays in C, and the reactions of all rows are those of least norm; a run looks at every step whether it still does |
/// | `configuration(z = 0, x = ..)` | x = g(q, t) (4.2): the named coordinates as functions of the others; `of(alpha)` introduces further q |
/// | `independent(v6, dot(phi))` | the independent speeds u, in this order; else the cheapest pivots choose, and between choices that are as good the weight of the motion as it is derived (a division counts as four operations, a sine with its cosine as twenty), with the reason among the notes of `MODEL`; where a pivot may vanish the motion must be lighter by a twentieth; given several times, the first names the state's speeds and each further one is a chart that is regular elsewhere |
/// | `independent(s = v1 + 2*v2, ..)` | the same with combinations of speeds and rates, linear in them, u = L v + l0, under new names: factors may depend on coordinates, parameters and `t`; another list may name `s` alone, and outputs may mention it |
/// | `configuration(.., speeds(u), dot(alpha) = ..)` or `(.., speeds(u), u = ..)` | quasi-velocities u of the configuration, q̇ = Ã u + ã0 (4.3) or its inverse, as in `kinematics` |
/// | `velocities(of(u), v1 = .., v2 = ..)` | v = g(u, x, t) (5.8): the named speeds (with a configuration its rates or speeds) as functions of the others and of the further ones in `of(..)`; every row must hold by it, which is decided |
/// | `complement(u1 = [..], ..)` | D (3.1) by rows, each with the name of its speed; D Cᵀ ≡ 0 is decided |
/// | `potential_energy(V)` | V(x, t), for `energy`; its forces are added only beside `kinetic_energy`, else they stand in `forces` |
/// | `define(mu = ..)` | names for intermediate quantities |
/// | `output(power = .., mu)` | quantities that the model gives out at run time, in a namespace of their own: what is known of a state may stand in them, accelerations `dot(v)`, `reaction(name)` and outputs above included; `mu` alone gives a define out under its name |
/// | `inputs(tau)` | inputs, given at every call |
/// | `size(n = 20)` | names for integers, used by families |
/// | `function(road(s), derivatives = [droad, ddroad])` | a function from f64 to f64 in scope, by its path, with its derivatives |
/// | `start(theta = 0.3)`, `nominal(9.81)` on fields | figures that judge: the position constraints are closed from the start, then pivots that vanish there and rows that depend on each other there are errors; `MODEL` tells the relative pivot of each chart. They never enter the equations |
/// | `holonomy(crate = path, simplify = off, elimination = recursive)` | where the runtime is found; whether cheaper forms are searched; `recursive` or `matrix`: whether bodies are eliminated joint by joint, with loops closed on top of the tree, or by M_d as a whole, which is else chosen by estimated cycles; joint by joint takes speeds of joints, and constraints of positions or linear in velocities |
/// | `unit(kg)` on fields, and before names in `coordinates`, `speeds`, `inputs`, `output`, `of(..)` and `independent` | a unit: products, quotients and `powi` of m kg s A K mol cd N J W Pa Hz rad V Ohm C F H T Wb, with prefixes, or `1`. As soon as a model declares one, dimensions are inferred and checked: a length plus a mass is an error at the `+`. Numbers are not converted, so that mm beside m is an error as well; literals are pure numbers, 0 fits anything, angles are in radians, `t` is in s. What is not declared follows where it can, stands in `MODEL` and the emitted docs, and may stay unknown |
///
/// Functions: `sin cos tan asin acos atan atan2(y, x) sinh cosh tanh sqrt exp ln abs sign min(a, b) max(a, b) powi(x, n)
/// powf(x, y) dot(q)`, and in constraints and outputs `dot(v) ddot(q)`, with `sign(0)` = 0. `if a < b { .. } else { .. }`, with `<`, `<=`, `>` or `>=`, selects: both
/// branches are evaluated, one is taken, and derivatives are those of the branch that is taken. `t` is time, `PI` is π.
/// Literals are exact: `0.1` is one tenth, `1/2` one half.
///
/// Vectors: `A.x` of a frame A, points, `dot(a, b) cross(a, b) norm(a) unit(a) velocity(P) velocity(P, body) acceleration(P)
/// angular_velocity(B) angular_acceleration(B)`; see below.
///
#[doc = include_str!("geometry.md")]
///
/// # Arrays and families
///
/// Fields may be arrays (`m: [f64; 5]`, the length a literal; `nominal(1, 2, 3, 2, 1)` gives each entry a value, `nominal(1)`
/// all of them one), and `coordinates(a[n])`, `speeds`, `inputs` and
/// `configuration(of(a[n]))` declare families. `a[i + 1]` names an entry; its name in the emitted structs and in `MODEL`
/// is `a_0`, `a_1`, … In every statement an entry may be repeated: `forces(-m[i]*g for i in 0..n)`,
/// `constraint(link[i]: x[i] == x[i + 1] for i in 0..n - 1)`, `define(s[i] = .. for i in 0..n)`,
/// `inertia(matrix([.. for j in 0..n] for i in 0..n))`. `sum(0..n, |j| m[j]*x[j])` and `product(..)` repeat inside an
/// expression. Ranges and indices are integers of literals, sizes and indices, with `+ - * / %`, `min` and `max`.
///
/// ```
/// use holonomy::{ConstrainedSystem, State};
///
/// /// A chain of three equal pendulums in the plane, by their angles.
/// #[derive(ConstrainedSystem, Clone)]
/// #[size(n = 3)]
/// #[coordinates(a[n])]
/// #[inertia(matrix([l[i]*l[j]*cos(a[i] - a[j])*sum(max(i, j)..n, |k| m[k]) for j in 0..n] for i in 0..n))]
/// #[forces(
///     -sum(0..n, |j| sum(max(i, j)..n, |k| m[k])*l[i]*l[j]*sin(a[i] - a[j])*powi(dot(a[j]), 2))
///         - sum(i..n, |k| m[k])*g*l[i]*sin(a[i]) for i in 0..n
/// )]
/// #[potential_energy(-sum(0..n, |i| sum(i..n, |k| m[k])*g*l[i]*cos(a[i])))]
/// struct Chain {
///     m: [f64; 3],
///     l: [f64; 3],
///     g: f64,
/// }
///
/// # fn main() -> Result<(), holonomy::Error> {
/// let chain = Chain { m: [1.0, 2.0, 0.5], l: [0.7, 0.3, 0.5], g: 9.81 }.prepare()?;
/// let start = State::<Chain> { a_0: 0.4, a_2: -0.2, ..Default::default() };
/// let run = chain.simulate(start).until(1.0)?;
/// let (t, end) = run.last();
/// assert!((chain.energy(t, end) - chain.energy(0.0, &start)).abs() < 1e-6);
/// # Ok(())
/// # }
/// ```
///
/// # Speeds of your own choice
///
/// Independent speeds need not be speeds of the model. Speeds along and about the axes of a body often give shorter equations
/// and no pivot that vanishes, where rates along fixed axes have one:
///
/// ```
/// use holonomy::{ConstrainedSystem, State};
///
/// /// A sled on a blade, by its speed along the blade and its turning.
/// #[derive(ConstrainedSystem, Clone)]
/// #[coordinates(x, y, phi)]
/// #[inertia(diag(m, m, i))]
/// #[forces(0, 0, 0)]
/// #[constraint(blade: dot(y)*cos(phi) - dot(x)*sin(phi) == 0)]
/// #[independent(
///     /// along the blade
///     u = dot(x)*cos(phi) + dot(y)*sin(phi),
///     o = dot(phi),
/// )]
/// struct Sled {
///     m: f64,
///     i: f64,
/// }
///
/// # fn main() -> Result<(), holonomy::Error> {
/// assert!(Sled::MODEL.guards.is_empty());
/// let sled = Sled { m: 3.0, i: 0.4 }.prepare()?;
/// let start = State::<Sled> { u: 2.0, o: 0.5, ..Default::default() };
/// let run = sled.simulate(start).until(6.0)?;
/// let (_, end) = run.last();
/// // A circle of radius u/o.
/// assert!((end.x - 4.0 * end.phi.sin()).abs() < 1e-6 && (end.u - 2.0).abs() < 1e-12);
/// # Ok(())
/// # }
/// ```
///
/// # Functions of your own
///
/// `function(road(s), derivatives = [droad, ddroad])` makes `road` a function of the equations; d/ds road(s) is droad(s).
/// Position constraints need two derivatives, velocity constraints one, forces none. A derivative that the equations need
/// and that is missing is an error that names what needs it. Dual numbers, as in `linearize`, need one more; where it is
/// missing their derivative is not a number, and `MODEL.notes` says so.
///
/// ```
/// use holonomy::{ConstrainedSystem, State};
///
/// fn road(x: f64) -> f64 { 0.3 * x.sin() }
/// fn slope(x: f64) -> f64 { 0.3 * x.cos() }
/// fn curvature(x: f64) -> f64 { -0.3 * x.sin() }
/// fn twist(x: f64) -> f64 { -0.3 * x.cos() }
///
/// /// A particle on a road.
/// #[derive(ConstrainedSystem, Clone)]
/// #[coordinates(x, y)]
/// #[function(road(x), derivatives = [slope, curvature, twist])]
/// #[inertia(diag(m, m))]
/// #[forces(0, -m*g)]
/// #[potential_energy(m*g*y)]
/// #[constraint(ground: y == road(x))]
/// #[independent(dot(x))]
/// struct Particle {
///     m: f64,
///     g: f64,
/// }
///
/// # fn main() -> Result<(), holonomy::Error> {
/// let particle = Particle { m: 2.0, g: 9.81 }.prepare()?;
/// let start = State::<Particle> { x: 0.4, y: road(0.4), dot_x: 1.0 };
/// let run = particle.simulate(start).until(2.0)?;
/// let (t, end) = run.last();
/// assert!((end.y - road(end.x)).abs() < 1e-9);
/// assert!((particle.energy(t, end) - particle.energy(0.0, &start)).abs() < 1e-6);
/// # Ok(())
/// # }
/// ```
///
/// # Outputs
///
/// `output(power = .., mu)` names quantities of a state that the model gives out: `outputs` of a prepared model computes
/// them, a trajectory gives them at any time of a run, and `assemble` holds those that depend on coordinates and speeds
/// alone. In an output may stand the time, parameters, inputs, all coordinates and speeds, those of a `configuration` too,
/// their rates `dot(q)`, accelerations `dot(v)` and `ddot(q)` of the motion, `reaction(name)`, the multiplier λ of a
/// constraint in M v̇ = h* + Cᵀ λ, defines, and the outputs above. Outputs are a namespace of their own: one may have the
/// name of a coordinate, which is then what the name means in expressions. An output that has no finite value somewhere
/// does not stop a run.
///
/// ```
/// use holonomy::{ConstrainedSystem, State};
///
/// /// A bead on a rod that turns at the rate w: which torque turns it?
/// #[derive(ConstrainedSystem, Clone)]
/// #[coordinates(x, y)]
/// #[inertia(diag(m, m))]
/// #[forces(0, 0)]
/// #[configuration(of(rho), x = rho*cos(w*t), y = rho*sin(w*t))]
/// #[constraint(rod: y*cos(w*t) - x*sin(w*t) == 0)]
/// #[output(
///     /// About the pivot.
///     torque = rho*reaction(rod),
///     power = w*torque,
///     acceleration = ddot(rho),
/// )]
/// struct Bead {
///     m: f64,
///     w: f64,
/// }
///
/// # fn main() -> Result<(), holonomy::Error> {
/// let bead = Bead { m: 2.0, w: 3.0 }.prepare()?;
/// let start = State::<Bead> { rho: 0.5, dot_rho: 0.25 };
/// // 2 m ρ ρ̇ w, by Coriolis; and ρ̈ = w² ρ.
/// let outputs = bead.outputs(0.0, &start, &[]);
/// assert!((outputs.torque - 1.5).abs() < 1e-14 && (outputs.power - 4.5).abs() < 1e-14);
/// assert!((outputs.acceleration - 4.5).abs() < 1e-14);
/// let run = bead.simulate(start).until(1.0)?;
/// let end = run.at(1.0)?;
/// assert!((run.outputs_at(1.0, &[])?.torque - 12.0*end.rho*end.dot_rho).abs() < 1e-9);
/// # Ok(())
/// # }
/// ```
///
/// # What it emits
///
/// An implementation of `holonomy::ConstrainedSystem` and the structs that it names: `PendulumState`,
/// `PendulumVelocities`, `PendulumMultipliers`, `PendulumParameters`, `PendulumValues`, and `PendulumInputs` and
/// `PendulumOutputs` where there are inputs and outputs. A model that makes no sense does not compile, and the errors stand at the tokens at fault, all at once.
#[proc_macro_derive(
    ConstrainedSystem,
    attributes(
        coordinates,
        speeds,
        kinematics,
        inertia,
        forces,
        kinetic_energy,
        potential_energy,
        constraint,
        configuration,
        velocities,
        independent,
        complement,
        inputs,
        define,
        output,
        start,
        size,
        function,
        frame,
        point,
        particle,
        body,
        gravity,
        force,
        torque,
        generalized_force,
        spring,
        damper,
        armature,
        release,
        holonomy,
        unit,
        nominal
    )
)]
pub fn constrained_system(input: TokenStream) -> TokenStream {
    // An editor runs the derive at every keystroke, and needs the types and the errors: what the functions cost does not matter.
    if in_editor() { holonomy_engine::expand_plainly(input.into()) } else { holonomy_engine::expand(input.into()) }
        .into()
}

/// Whether the macro runs in the server that rust-analyzer keeps for macros.
fn in_editor() -> bool {
    let program = std::env::current_exe().ok();
    program.as_deref().and_then(std::path::Path::file_stem).is_some_and(|name| name == "rust-analyzer-proc-macro-srv")
}
