//! The initial system: kinematics (2.1), (2.2), dynamics (2.3) and constraints.

use proc_macro2::Span;

use super::mechanism::Mechanism;
use crate::symbolic::{Expr, Graph, Matrix, Symbol};
use crate::syntax::{Elimination, Place};

/// A model with its names resolved: n coordinates x and n speeds v that nothing ties yet, and the rows that will.
///
/// Every expression is over [`Graph`]'s symbols; rates `dot(x)` are replaced by A v + a0.
#[derive(Clone, Debug)]
pub struct InitialSystem {
    /// The arena of all expressions.
    pub graph: Graph,
    /// t.
    pub time: Symbol,
    /// The fields that the model mentions, in the order of the fields.
    pub parameters: Vec<Symbol>,
    /// The inputs.
    pub inputs: Vec<Symbol>,
    /// x, the initial coordinates, n of them.
    pub coordinates: Vec<Symbol>,
    /// v, n of them; named `dot_x` where the model does not name them.
    pub speeds: Vec<Symbol>,
    /// (2.1), (2.2).
    pub kinematics: Kinematics,
    /// Whether v are the rates of coordinates and the angular velocities of frames by quaternions.
    pub joint_speeds: bool,
    /// M of (2.3), n x n, symmetric.
    pub inertia: Matrix,
    /// h* of (2.3), n. Where there is a kinetic energy, the generalised forces in it that the model lists: the
    /// projection adds the inertia terms.
    pub forces: Vec<Expr>,
    /// T(v, x, t), quadratic in v, where the model gives it; `inertia` is its second derivative then.
    pub kinetic: Option<Expr>,
    /// V, where the model gives it.
    pub potential: Option<Expr>,
    /// The bodies, where the model has any: `inertia` is all zeros then and `forces` what the model lists besides, until the
    /// projection finds M, h*, T and V.
    pub mechanism: Option<Mechanism>,
    /// How the motion of bodies is to be found.
    pub elimination: Elimination,
    /// v̇ and λ of a tree that was eliminated joint by joint: then `inertia` has no entries.
    pub swept: Option<Swept>,
    /// The constraints in order.
    pub rows: Vec<Row>,
    /// x = g(q, t) (4.2), where the model gives it.
    pub configuration: Option<Configuration>,
    /// The choices of independent speeds that the model names: the first gives the state's speeds, the others are
    /// further charts.
    pub independent: Vec<Independent>,
    /// The independent speeds that were chosen for the model where it leaves the choice open, and all who ask must agree.
    pub chosen: Option<Chosen>,
    /// v = g(u, x, t) (5.8), where the model gives it.
    pub velocities: Option<Velocities>,
    /// D of (3.1) by rows, where the model gives it.
    pub complement: Option<Vec<ComplementRow>>,
    /// What the model tells besides its motion.
    pub outputs: Outputs,
    /// Where statements about the whole begin, for errors.
    pub places: Places,
    /// Numbers for judging, from `start`: coordinates and speeds.
    pub start: Vec<(Symbol, f64)>,
    /// Numbers for judging, from `nominal`: parameters.
    pub nominal: Vec<(Symbol, f64)>,
}

impl InitialSystem {
    /// The rates of norms of quaternions, which are zero.
    pub fn norm_rates(&self) -> Vec<Symbol> {
        let rate = |row: &Row| match row.kind {
            RowKind::Norm { rate, .. } => Some(rate),
            _ => None,
        };
        self.rows.iter().filter_map(rate).collect()
    }

    /// Zeros for these.
    pub fn norms_held(&self) -> Vec<(Symbol, Expr)> {
        self.norm_rates().into_iter().map(|rate| (rate, self.graph.zero())).collect()
    }

    /// Whether the speeds are those of joints, and tied by nothing but rows that bind them linearly.
    pub fn is_tree(&self) -> bool {
        let linear = |row: &Row| matches!(row.kind, RowKind::Position(_) | RowKind::Norm { .. } | RowKind::Velocity(_));
        self.rows.iter().all(linear)
            && self.configuration.is_none()
            && self.velocities.is_none()
            && self.complement.is_none()
            && (self.joint_speeds || self.rates_are_speeds())
    }

    /// Whether v are the rates of x themselves.
    pub fn rates_are_speeds(&self) -> bool {
        let (a, n) = (&self.kinematics.a, self.speeds.len());
        let unit = |i: usize, j: usize| match i == j {
            true => self.graph.is_one(a.get(i, j)),
            false => self.graph.is_zero(a.get(i, j)),
        };
        (0..n).all(|i| self.graph.is_zero(self.kinematics.a0[i]) && (0..n).all(|j| unit(i, j)))
    }
}

/// The motion of a tree whose joints are tied by rows, over (x, v).
#[derive(Clone, Debug)]
pub struct Swept {
    /// v̇.
    pub rates: Vec<Expr>,
    /// λ of the independent rows.
    pub multipliers: Vec<Expr>,
    /// The position of each speed with its pivot of M, from the leaves inwards.
    pub pivots: Vec<(usize, Expr)>,
    /// The position of each of these rows with its pivot of C M⁻¹ Cᵀ, in the order of elimination.
    pub compliances: Vec<(usize, Expr)>,
}

/// Both directions of the kinematics.
#[derive(Clone, Debug)]
pub struct Kinematics {
    /// A(x, t), n x n: ẋ = A v + a0 (2.1).
    pub a: Matrix,
    /// a0(x, t), n.
    pub a0: Vec<Expr>,
    /// B(x, t), n x n: v = B ẋ + b0 (2.2).
    pub b: Matrix,
    /// b0(x, t), n.
    pub b0: Vec<Expr>,
    /// What must not vanish for the inverse to exist: factors of the pivots that are not numbers.
    pub pivots: Vec<Expr>,
}

/// A constraint.
#[derive(Clone, Debug)]
pub struct Row {
    /// Its name, and that of its multiplier.
    pub name: String,
    /// The name's place.
    pub span: Span,
    /// What it binds.
    pub kind: RowKind,
    /// Whether it may depend on other rows.
    pub redundant: bool,
    /// Its columns of C for what is released, in the order of the mechanism's releases.
    pub released: Vec<Expr>,
}

/// What a constraint binds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RowKind {
    /// f(x, t) = 0.
    Position(Expr),
    /// f(x) = 0 for the norm of a quaternion, whose rate is a speed of its own: at velocity level the row says that this is
    /// zero. No force is needed to hold it: it has no multiplier.
    Norm {
        /// (e·e - 1)/2.
        f: Expr,
        /// σ, with ḟ = e·e σ.
        rate: Symbol,
    },
    /// φ(v, x, t) = 0, linear in v.
    Velocity(Expr),
    /// φ(v, x, t) = 0, not linear in v.
    Nonlinear(Expr),
    /// C v̇ + c0* = 0 (2.4) as the model states it, both free of v̇.
    Acceleration {
        /// The row of C.
        gradient: Vec<Expr>,
        /// c0*.
        bias: Expr,
    },
}

/// x = g(q, t) (4.2).
#[derive(Clone, Debug)]
pub struct Configuration {
    /// q: the initial coordinates that are not given by others, then the further ones.
    pub coordinates: Vec<Symbol>,
    /// q̇, named `dot_q`.
    pub rates: Vec<Symbol>,
    /// The carriers of the motion: q̇ itself, or the quasi-velocities that the configuration names.
    pub speeds: Vec<Symbol>,
    /// q̇ = Ã u + ã0 (4.3) and its inverse; trivial where the carriers are q̇.
    pub kinematics: Kinematics,
    /// g, one for each x.
    pub map: Vec<Expr>,
    /// The statement's place.
    pub span: Span,
}

/// A choice of independent speeds.
#[derive(Clone, Debug)]
pub struct Independent {
    /// The speeds in order: u.
    pub speeds: Vec<IndependentSpeed>,
    /// The statement's place.
    pub span: Span,
}

/// A choice of independent speeds among the carriers that the model did not make.
#[derive(Clone, Debug)]
pub struct Chosen {
    /// The speeds, in the order of the carriers.
    pub speeds: Vec<Symbol>,
    /// Why these, where it was not the pivots alone that decided.
    pub reason: Option<String>,
}

/// v = g(u, x, t) (5.8), or the carriers of a configuration so.
#[derive(Clone, Debug)]
pub struct Velocities {
    /// u: the carriers that are not given by others, then the further ones.
    pub speeds: Vec<Symbol>,
    /// The given carriers with their values over u, the state's coordinates and t.
    pub map: Vec<(Symbol, Expr)>,
    /// The statement's place.
    pub span: Span,
}

/// A speed that the model wants to be independent.
#[derive(Clone, Debug)]
pub struct IndependentSpeed {
    /// The speed in the state: a carrier itself, or a symbol of its own for a combination of them.
    pub symbol: Symbol,
    /// u over the carriers: v, or with a configuration its rates or quasi-velocities.
    pub expr: Expr,
    /// The row L of u = L w + l0, one entry a carrier.
    pub gradient: Vec<Expr>,
    /// l0.
    pub offset: Expr,
    /// Its place in the list.
    pub place: Place,
}

/// A row of D.
#[derive(Clone, Debug)]
pub struct ComplementRow {
    /// The name of the row's speed u.
    pub name: String,
    /// The entries: n, one for each v; where there is a configuration, one for each q̇.
    pub entries: Vec<Expr>,
    /// The name's place.
    pub span: Span,
}

/// The outputs with the symbols that only they mention.
#[derive(Clone, Debug, Default)]
pub struct Outputs {
    /// The outputs in order.
    pub entries: Vec<Output>,
    /// v̇.
    pub accelerations: Vec<Symbol>,
    /// The rates of the configuration's further coordinates.
    pub further_rates: Vec<Symbol>,
    /// Their second rates.
    pub further_accelerations: Vec<Symbol>,
    /// The rates of the configuration's quasi-velocities.
    pub quasi_rates: Vec<Symbol>,
    /// The reactions that some output mentions.
    pub reactions: Vec<Reaction>,
}

/// An output.
#[derive(Clone, Debug)]
pub struct Output {
    /// Its name.
    pub name: String,
    /// The name's place.
    pub span: Span,
    /// What it is, over x, v, v̇, inputs, t and the symbols of [`Outputs`].
    pub expr: Expr,
}

/// A reaction that is mentioned.
#[derive(Clone, Debug)]
pub struct Reaction {
    /// The constraint's name.
    pub name: String,
    /// What stands for its multiplier.
    pub symbol: Symbol,
    /// Where it is mentioned first.
    pub span: Span,
}

/// Places for errors about a whole statement. Where the model does not make the statement, the place is the name of
/// the struct.
#[derive(Clone, Copy, Debug)]
pub struct Places {
    /// The struct's name.
    pub model: Span,
    /// `kinematics`
    pub kinematics: Span,
    /// `inertia`
    pub inertia: Span,
    /// `complement`
    pub complement: Span,
    /// `start`
    pub start: Span,
}
