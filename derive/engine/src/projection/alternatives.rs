//! Independent speeds that may be chosen as well as others.
//!
//! Elimination takes the cheapest pivots one after another and does not see what the motion costs. From its choice others are
//! reached by exchanging a dependent speed for an independent one; how good a chart each of them is, its pivots tell, and what it
//! costs, the equations of its motion. This step makes them; who weighs them chooses.

use super::binding::{Binding, binding};
use super::carriers::CarriedRow;
use super::chart::chart;
use super::pivots::NEW_GUARD;
use super::tangent::tangent;
use super::{AsIs, Simplifier};
use crate::model::{Chosen, InitialSystem};
use crate::symbolic::{Expr, Graph, Symbol};
use crate::syntax::Diagnostics;

/// A system that leaves the choice of independent speeds open.
#[derive(Clone, Debug)]
pub struct Alternatives {
    system: InitialSystem,
    binding: Binding,
}

/// One choice of independent speeds, as good a chart as was asked for.
#[derive(Clone, Debug)]
pub struct Alternative {
    /// The arena of its equations.
    pub graph: Graph,
    /// The rates of the coordinates, u̇, and what is watched: what a run computes.
    pub motion: Vec<Expr>,
    /// How good a chart it is.
    pub quality: Quality,
    /// Which carriers are dependent speeds.
    pub dependent: Vec<bool>,
    /// Pairs of a dependent and an independent speed that may change places, in the order of the carriers.
    pub exchanges: Vec<(usize, usize)>,
}

/// How good a chart is, the smaller the better: the ranks of its pivots, the worst first, and how many guards it has.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Quality {
    ranks: Vec<u8>,
    guards: usize,
}

impl Quality {
    /// Whether no pivot is worse than those of the other chart, and nothing more has to be watched.
    pub fn no_worse_than(&self, other: &Quality) -> bool {
        self.ranks <= other.ranks && self.guards <= other.guards
    }

    /// Whether some pivot may vanish that nothing else guards.
    pub fn may_break_down(&self) -> bool {
        self.ranks.first() == Some(&NEW_GUARD)
    }
}

impl Alternatives {
    /// `None` where the model chooses, where there is nothing to choose from, and where the system is in error.
    pub fn of(system: &InitialSystem) -> Option<Self> {
        let open = system.independent.is_empty() && system.velocities.is_none() && system.complement.is_none();
        if !open || system.rows.is_empty() {
            return None;
        }
        let mut system = system.clone();
        let binding = binding(&mut system, &mut AsIs, &mut Diagnostics::new())?;
        // Rows of norms leave no choice.
        let chosen = |row: &CarriedRow| binding.rows[binding.sorted.kept[row.row]].reaction;
        let m = binding.carried.len();
        (binding.carried.iter().any(chosen) && m < binding.carriers.speeds.len())
            .then_some(Alternatives { system, binding })
    }

    /// Expressions in the arena before anything is chosen.
    pub fn size(&self) -> usize {
        self.system.graph.len()
    }

    /// The carriers with their names.
    pub fn carriers(&self) -> Vec<(Symbol, &str)> {
        self.binding.carriers.speeds.iter().map(|symbol| (*symbol, self.system.graph.name(*symbol))).collect()
    }

    /// The choice with these dependent speeds, or the one that the pivots make; `None` where it is no chart, or not as good
    /// a one as is asked for. Pivots are judged in the forms that the simplifier gives them; the rest is left as it comes.
    pub fn with(
        &self,
        dependent: Option<&[bool]>,
        simplifier: &mut dyn Simplifier,
        good: Option<&Quality>,
    ) -> Option<Alternative> {
        let (mut system, mut errors) = (self.system.clone(), Diagnostics::new());
        let Binding { rows, sorted, carriers, carried, .. } = &self.binding;
        let independent = |dependent: &[bool]| -> Vec<Symbol> {
            carriers.speeds.iter().zip(dependent).filter(|(_, dependent)| !**dependent).map(|(w, _)| *w).collect()
        };
        system.chosen = dependent.map(|dependent| Chosen { speeds: independent(dependent), reason: None });
        let tangent = tangent(&mut system, simplifier, rows, &sorted.kept, carried, carriers, 0, &mut errors)?;
        let elimination = tangent.elimination.as_ref()?;
        let mut ranks = elimination.ranks.clone();
        ranks.sort_unstable_by(|a, b| b.cmp(a));
        if good.is_some_and(|good| ranks > good.ranks) {
            return None;
        }
        let width = carriers.speeds.len();
        let dependent: Vec<bool> = (0..width).map(|j| elimination.pivots.contains(&j)).collect();
        let mut exchanges: Vec<(usize, usize)> = Vec::new();
        for (row, pivot) in elimination.pivots.iter().enumerate() {
            let entry = |j: usize| elimination.reduced.get(row, j);
            let others = (0..width).filter(|j| !dependent[*j] && !system.graph.is_zero(entry(*j)));
            exchanges.extend(others.map(|j| (*pivot, j)));
        }
        exchanges.sort_unstable();
        let chart = chart(&mut system, &mut AsIs, rows, &sorted.kept, carriers, tangent, &mut errors)?;
        let mut motion = chart.coordinate_rates(&mut system, &mut AsIs, carriers);
        motion.extend(&chart.solution.accelerations);
        motion.extend(chart.guards.state.iter().map(|guard| guard.expr));
        let quality = Quality { ranks, guards: chart.guards.state.len() };
        let sound = errors.is_empty() && good.is_none_or(|good| quality.no_worse_than(good));
        sound.then_some(Alternative { graph: system.graph, motion, quality, dependent, exchanges })
    }
}
