//! From bodies to M and h*: Newton's and Euler's equations projected onto partial velocities.
//!
//! With V = (v, ω) the twists of the nodes that are heavy, V = J v + V0 and V̇ = J v̇ + γ, the bodies' own equations
//! 𝓜 V̇ + Ω × 𝓜 V = F, multiplied by Jᵀ, are (2.3) with
//!
//! ```text
//!     M = Jᵀ 𝓜 J,      h* = Jᵀ (F − 𝓜 γ − Ω × 𝓜 V)
//! ```
//!
//! which is the first stage of a chain of projections (4.10), its reactions those of joints that were never written as
//! constraints. Velocities and accelerations are found outwards along the tree of twists, forces are collected inwards.
//!
//! | file | idea |
//! |---|---|
//! | `rotors` | symmetric bodies need not turn their axes |
//! | `sweep` | velocities and accelerations, outwards |
//! | `partial` | partial velocities step by step, and what moves with them |
//! | `spatial` | inertias about points, moved and turned |
//! | `acting` | what acts at the nodes for v̇ = 0 |
//! | `recursive` | composite inertias and forces inwards, where each speed moves one joint: O(n²) in a chain |
//! | `direct` | body by body, where v are speeds of the model's own |
//! | `articulated` | inertias of what gives way, and v̇ by them: O(n) |
//! | `tree` | the equations of a tree, without M |
//! | `loops` | λ and v̇ of a tree whose joints are tied by rows |
//! | `inverse` | M v and M v̇ - h* without M: O(n) |
//! | `energy` | V of gravity |
//! | `lines` | springs, dampers, armatures |
//! | `further` | all that acts along the speeds and is no body's |
//! | `releases` | reactions of joints that are no constraints |

mod acting;
mod articulated;
mod direct;
mod energy;
mod further;
mod inverse;
mod lines;
mod loops;
mod partial;
mod recursive;
mod releases;
mod rotors;
mod spatial;
mod sweep;
mod tree;

pub use inverse::tell as inverse_dynamics;
pub use loops::Tree;
pub use partial::ways;

use super::Simplifier;
use super::constraints::{DifferentiatedRow, motion_of_norm};
use crate::model::InitialSystem;
use crate::symbolic::{Expr, Matrix};
use crate::syntax::Elimination;
use acting::acting;
use further::further;

/// M, h*, T and V of a system of bodies; what the model lists as forces is added to h*. Where the motion is to be eliminated joint by
/// joint and can be, there is a tree instead of M, which its rows close.
pub fn complete(system: &mut InitialSystem, simplifier: &mut dyn Simplifier) -> Option<Tree> {
    let mut mechanism = system.mechanism.take()?;
    let motion = motion_of_norm(system);
    let n = system.speeds.len();
    let speeds = releases::extended(system, &mut mechanism);
    let own = system.joint_speeds || system.rates_are_speeds();
    rotors::stop(&mut system.graph, &mut mechanism);
    if system.elimination == Elimination::Recursive
        && let Some(tree) = tree::complete(system, &mechanism, &speeds, &motion)
    {
        return Some(tree);
    }
    let potential = energy::potential(&mut system.graph, &mechanism);
    let mut further = further(system, &mechanism, &speeds, &motion, potential);
    let graph = &mut system.graph;
    let mut sums = match own {
        true => {
            let columns = partial::columns(graph, &mechanism, &speeds);
            let acting = acting(graph, &mechanism, &motion);
            let inertia = recursive::inertia(graph, &mechanism, &columns, &acting.own, speeds.len());
            let forces = recursive::collected(graph, &mechanism, &columns, acting.wrenches, speeds.len());
            Sums { inertia, forces, kinetic: acting.kinetic }
        }
        false => direct::equations(graph, simplifier, &mechanism, &speeds, &motion),
    };
    further.add_to(graph, &mut sums.inertia, &mut sums.forces);
    sums.kinetic = graph.add(sums.kinetic, further.kinetic);
    let mut potential = further.potential.total(graph);
    releases::hold(graph, &mechanism.releases, &mut sums, &mut potential);
    let told: Vec<Expr> = releases::asked(system, &mechanism.releases, &sums);
    releases::tell(system, &mechanism.releases, &told);
    let graph = &mut system.graph;
    let mut inertia = Matrix::zeros(graph, n, n);
    for (i, j) in (0..n).flat_map(|i| (0..=i).map(move |j| (i, j))) {
        let entry = sums.inertia.get(i, j);
        let entry = if graph.vanishes(entry) { graph.zero() } else { simplifier.one(graph, entry) };
        inertia.set(i, j, entry);
        inertia.set(j, i, entry);
    }
    system.inertia = inertia;
    system.forces = sums.forces[..n].iter().map(|force| simplifier.one(graph, *force)).collect();
    system.kinetic = Some(sums.kinetic);
    system.potential = potential;
    releases::hold_along(graph, &mechanism.releases, &mut further, &mut None);
    mechanism.along = own.then_some(further.along);
    system.mechanism = Some(mechanism);
    None
}

/// v̇ and λ of a tree with these rows, which are independent of one another; whether there are any.
pub fn close(system: &mut InitialSystem, tree: Tree, rows: &[&DifferentiatedRow]) -> bool {
    let Some(mechanism) = &system.mechanism else { return false };
    system.swept = tree.closed(&mut system.graph, mechanism, rows);
    system.swept.is_some()
}

/// What bodies and lines add up to.
struct Sums {
    /// M, its lower triangle.
    inertia: Matrix,
    /// h*.
    forces: Vec<Expr>,
    /// T.
    kinetic: Expr,
}
