//! From the initial system to the equations of motion (Blajer 1992, sections 2 to 5; corrected where the print is wrong).
//!
//! | file | idea |
//! |---|---|
//! | `bodies` | M, h*, T and V of bodies, by partial velocities |
//! | [`lagrange`] | the inertia terms of h* from the kinetic energy |
//! | [`constraints`] | rows differentiated to C v̇ + c0* = 0 (2.5), (2.6) |
//! | [`dependence`] | which rows are independent, which repeat others, which contradict |
//! | [`overconstrained`] | which rows repeat others where the constraints hold |
//! | [`elimination`] | C_d⁻¹ by Gauss-Jordan on the arena, pivots recorded |
//! | [`steps`] | what it did to the rows, done to a vector |
//! | [`pivots`] | which entry to divide by next |
//! | [`carriers`] | partial velocities of a configuration (4.9), and the rows that still bind |
//! | [`binding`] | all that is known before speeds are chosen |
//! | [`tangent`] | the basis D and the bias a_u, by pivots |
//! | [`combined`] | the same for speeds that are combinations of the carriers |
//! | [`alternatives`] | speeds that may be chosen as well as others |
//! | [`chart`] | a choice of independent speeds, and the motion in terms of them |
//! | [`back`] | carriers and independent speeds from v |
//! | [`complement`] | the basis D as the user gives it |
//! | [`acceleration`] | the rows that bind only the rates of the state's speeds |
//! | [`given`] | the basis D from v = g(u, x, t) (5.8), (5.9) |
//! | [`start`] | the start that the model names, closed |
//! | `closing` | the two ways in which it is closed |
//! | [`judge`] | the choice of speeds at the start that the model names |
//! | [`offer`] | a better choice, where an error asks for one |
//! | [`dynamics`] | M_d and h_u* (4.10), (5.6) |
//! | [`motion`] | the rates u̇ of the state's speeds |
//! | [`swept`] | the same joint by joint, with λ |
//! | [`factorisation`] | L D Lᵀ along the zero pattern |
//! | [`reactions`] | λ for all rows in the initial space |
//! | [`mod@outputs`] | what the model tells besides its motion |
//! | [`guards`] | every quantity by which the result divides |
//! | [`mod@project`] | the steps in order |
//! | [`equations`] | the result |
//! | `messages` | every sentence that this step can say to a user |

pub mod acceleration;
pub mod alternatives;
pub mod back;
pub mod binding;
mod bodies;
pub mod carriers;
pub mod chart;
mod closing;
pub mod combined;
pub mod complement;
pub mod constraints;
pub mod dependence;
pub mod dynamics;
pub mod elimination;
pub mod equations;
pub mod factorisation;
pub mod given;
pub mod guards;
pub mod judge;
pub mod lagrange;
pub(crate) mod messages;
pub mod motion;
pub mod offer;
pub mod outputs;
pub mod overconstrained;
pub mod pivots;
pub mod project;
pub mod reactions;
pub mod start;
pub mod steps;
pub mod swept;
pub mod tangent;
#[cfg(test)]
mod tests;

pub use alternatives::{Alternative, Alternatives, Quality};
pub use bodies::{inverse_dynamics, ways};
pub use equations::{ChartEquations, Equations, Guard, GuardKind, Level, RowFacts};
pub use motion::{COMPLIANCE_PIVOT, INERTIA_PIVOT};
pub use outputs::{OutputFacts, Outputs};
pub use project::{TANGENT_PIVOT, project};

use crate::symbolic::{Expr, Graph};

/// How the projection asks for cheaper forms on its way: entries that are not reduced before they are divided and
/// multiplied again grow without need.
pub trait Simplifier {
    /// A cheap canonical form of one expression.
    fn one(&mut self, graph: &mut Graph, e: Expr) -> Expr;
    /// Cheaper forms of several expressions that are computed together.
    fn all(&mut self, graph: &mut Graph, roots: &[Expr]) -> Vec<Expr>;
    /// These have the form that they will keep: what is made of them need not be simplified through them where they are
    /// large.
    fn settle(&mut self, _: &mut Graph, _: &[Expr]) {}
    /// What is made of this is not to be simplified through it, however small it is.
    fn keep(&mut self, _: &mut Graph, _: Expr) {}
}

/// Leaves everything as it is.
pub struct AsIs;

impl Simplifier for AsIs {
    fn one(&mut self, _: &mut Graph, e: Expr) -> Expr {
        e
    }
    fn all(&mut self, _: &mut Graph, roots: &[Expr]) -> Vec<Expr> {
        roots.to_vec()
    }
}
