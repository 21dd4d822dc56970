//! Reactions of joints that were never written as constraints: what they hold is let go along a coordinate ε that stays zero.
//!
//! The frame or point, and all that hangs on it, moves with ε, ε̇ and ε̈ as well. Columns of C and M for ε̇ then tell the
//! reaction, as if ε = 0 were a constraint; where nothing more is asked of them, ε and its rates are put to zero again.

use super::Vector;
use crate::model::context::Context;
use crate::model::vocabulary::Vocabulary;
use crate::symbolic::{Expr, Graph, Kind, Symbol};
use crate::syntax::{Diagnostics, Element, Term, messages};

/// A coordinate that stays zero.
#[derive(Clone, Copy, Debug)]
pub(in crate::model) struct Released {
    /// ε.
    pub coordinate: Symbol,
    /// ε̇.
    pub rate: Symbol,
    /// ε̈.
    pub second: Symbol,
}

impl Released {
    pub fn new(release: &Element, graph: &mut Graph) -> Self {
        let mut symbol = |order: &str, kind| graph.symbol(&format!("{order}release({})", release.name), kind);
        Released {
            coordinate: symbol("", Kind::Coordinate),
            rate: symbol("dot ", Kind::Speed),
            second: symbol("ddot ", Kind::Speed),
        }
    }

    /// Zeros for all three.
    pub fn zeros(self, graph: &Graph) -> [(Symbol, Expr); 3] {
        [self.coordinate, self.rate, self.second].map(|symbol| (symbol, graph.zero()))
    }
}

impl Vocabulary<'_> {
    /// The releases of a point or of a frame, by their places in the list.
    fn releases_of(&self, key: &str, name: &str) -> Vec<(usize, &Element)> {
        let releases = self.declarations.geometry.releases().enumerate();
        let of = |release: &Element| match release.get(key).map(|written| written.terms()) {
            Some([(Term::Name(other), _)]) => other == name,
            _ => false,
        };
        releases.filter(|(_, release)| of(release)).collect()
    }

    /// A point that is let go.
    pub(super) fn let_go(&mut self, name: &str, position: Vector, diagnostics: &mut Diagnostics) -> Option<Vector> {
        let declarations = self.declarations;
        let mut position = position;
        let places: Vec<usize> = self.releases_of("point", name).iter().map(|(i, _)| *i).collect();
        for i in places {
            let along = declarations.geometry.releases().nth(i).and_then(|release| release.get("along"))?;
            let (direction, _) = self.lower_vector(along, Context::GEOMETRY, diagnostics)?;
            let epsilon = self.graph.var(self.released[i].coordinate);
            let way = direction.times(epsilon, &mut self.graph, &self.geometry);
            position = position.plus(&way, &mut self.graph, &self.geometry);
        }
        Some(position)
    }

    /// The base of a frame that is let go: it turns by ε about the vector first.
    pub(super) fn turned_loose(&mut self, name: &str, base: usize, diagnostics: &mut Diagnostics) -> Option<usize> {
        let declarations = self.declarations;
        let mut base = base;
        let places: Vec<usize> = self.releases_of("frame", name).iter().map(|(i, _)| *i).collect();
        for i in places {
            let about = declarations.geometry.releases().nth(i).and_then(|release| release.get("about"))?;
            let (direction, mentions) = self.lower_vector(about, Context::GEOMETRY, diagnostics)?;
            let axis = direction.expressed(base, &mut self.graph, &self.geometry);
            let square = self.graph.dot(&axis, &axis);
            let one = self.graph.one();
            if !self.graph.identical(square, one) {
                let square = self.graph.display(square);
                diagnostics.report(about.place(), messages::axis_not_unit(square));
                return None;
            }
            let Released { coordinate, rate, .. } = self.released[i];
            let (angle, rate) = (self.graph.var(coordinate), self.graph.var(rate));
            base = self.turned_by(base, axis, (angle, rate), mentions);
        }
        Some(base)
    }

    /// Releases of what the model does not have.
    pub(super) fn check_releases(&self, diagnostics: &mut Diagnostics) {
        let geometry = &self.declarations.geometry;
        for release in geometry.releases() {
            let points = geometry.points.iter().map(|point| &point.name).collect::<Vec<_>>();
            let frames = geometry.frames.iter().map(|frame| &frame.name).collect::<Vec<_>>();
            for (key, known, what) in [("point", points, "point"), ("frame", frames, "frame")] {
                let Some(written) = release.get(key) else { continue };
                let named = match written.terms() {
                    [(Term::Name(name), _)] => known.iter().any(|known| *known == name),
                    [(Term::Hole, _)] => true,
                    _ => false,
                };
                if !named {
                    diagnostics.report(written.place(), messages::release_of_unknown(what));
                }
            }
        }
    }
}
