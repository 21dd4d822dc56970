//! Frames by unit quaternions: the rotation, and how its four coordinates move with the angular velocity.
//!
//! With e = (e0, e1, e2, e3), e0 the scalar part, components in the frame's axes become those in its base by R(e) of Euler and
//! Rodrigues, here in its homogeneous form: R Rᵀ = |e|⁴ 1, and along ė = e ∘ (0, ω)/2 + σ e, ω the angular velocity in the
//! frame's axes, Ṙ = R (ω×) + 2 σ R holds for every e, not on |e| = 1 alone. There ω = 2 G(e) ė and σ = e·ė, divided by
//! |e|² elsewhere (Nikravesh, Computer-Aided Analysis of Mechanical Systems, chapter 6, his G = L).
//!
//! Nothing moves along σ, since the row that holds the norm says σ = 0: geometry is differentiated with σ = 0 from the start.

use crate::model::names::Mentions;
use crate::model::vocabulary::Vocabulary;
use crate::symbolic::{Expr, Graph, Matrix, Rational, Rotation, Symbol};
use crate::syntax::{Diagnostics, Expression, Quaternion, Term, messages};

/// The symbols of a frame by a quaternion.
#[derive(Clone, Copy, Debug)]
pub(in crate::model) struct Turning {
    /// The places of e among the coordinates.
    pub coordinates: [usize; 4],
    /// ω against the base, in the frame's axes: speeds, unless the model names speeds of its own.
    pub omega: [Symbol; 3],
    /// ω̇.
    pub omega_rates: [Symbol; 3],
    /// σ, a speed.
    pub norm_rate: Symbol,
}

/// G(e)ᵀ, 4 x 3: signs and places of the entries.
const GYRATION: [[(i64, usize); 3]; 4] =
    [[(-1, 1), (-1, 2), (-1, 3)], [(1, 0), (-1, 3), (1, 2)], [(1, 3), (1, 0), (-1, 1)], [(-1, 2), (1, 1), (1, 0)]];

impl Turning {
    fn components(&self, coordinates: &[Symbol], graph: &Graph) -> [Expr; 4] {
        self.coordinates.map(|place| graph.var(coordinates[place]))
    }

    /// R(e).
    pub fn rotation(&self, coordinates: &[Symbol], graph: &mut Graph) -> Rotation {
        let e = self.components(coordinates, graph);
        let product = |graph: &mut Graph, i: usize, j: usize| graph.mul(e[i], e[j]);
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                if i == j {
                    let squares: [Expr; 4] = std::array::from_fn(|k| {
                        let square = product(graph, k, k);
                        if k == 0 || k == i + 1 { square } else { graph.neg(square) }
                    });
                    return graph.sum(&squares);
                }
                let k = 3 - i - j;
                let (outer, about) = (product(graph, i + 1, j + 1), product(graph, 0, k + 1));
                let half = if (i + 1) % 3 == j { graph.sub(outer, about) } else { graph.add(outer, about) };
                graph.scale(Rational::integer(2), half)
            })
        })
    }

    /// G(e)ᵀ/2, 4 x 3: ė = G(e)ᵀ ω/2 + σ e.
    fn rates(&self, coordinates: &[Symbol], graph: &mut Graph) -> [[Expr; 3]; 4] {
        let e = self.components(coordinates, graph);
        GYRATION.map(|row| row.map(|(sign, place)| graph.scale(Rational::Small(sign, 2), e[place])))
    }

    /// ė with σ = 0, each with the place of its coordinate.
    pub fn moved(&self, coordinates: &[Symbol], graph: &mut Graph) -> [(usize, Expr); 4] {
        let rates = self.rates(coordinates, graph);
        std::array::from_fn(|i| {
            let terms: Vec<Expr> = (0..3)
                .map(|j| {
                    let omega = graph.var(self.omega[j]);
                    graph.mul(rates[i][j], omega)
                })
                .collect();
            (self.coordinates[i], graph.sum(&terms))
        })
    }

    /// (e·e - 1)/2.
    pub fn norm(&self, coordinates: &[Symbol], graph: &mut Graph) -> Expr {
        let square = self.square(coordinates, graph);
        let one = graph.one();
        let excess = graph.sub(square, one);
        graph.scale(Rational::Small(1, 2), excess)
    }

    fn square(&self, coordinates: &[Symbol], graph: &mut Graph) -> Expr {
        let squares = self.components(coordinates, graph).map(|e| graph.powi(e, 2));
        graph.sum(&squares)
    }

    /// Enters ė = A (ω, σ) and its inverse where the columns of ω and σ are known.
    pub fn enter(
        &self,
        (omega, norm): ([usize; 3], usize),
        coordinates: &[Symbol],
        graph: &mut Graph,
        (a, b): (&mut Matrix, &mut Matrix),
    ) {
        let (rates, square) = (self.rates(coordinates, graph), self.square(coordinates, graph));
        let (four, one) = (graph.integer(4), graph.one());
        let four = graph.div(four, square);
        let inverse = graph.div(one, square);
        for (i, e) in self.components(coordinates, graph).into_iter().enumerate() {
            for (j, column) in omega.into_iter().enumerate() {
                // ω = 2 G ė/(e·e)
                let back = graph.mul(four, rates[i][j]);
                a.set(self.coordinates[i], column, rates[i][j]);
                b.set(column, self.coordinates[i], back);
            }
            let back = graph.mul(inverse, e);
            a.set(self.coordinates[i], norm, e);
            b.set(norm, self.coordinates[i], back);
        }
    }
}

impl Vocabulary<'_> {
    /// `quaternion(base, e0, e1, e2, e3)`, the value of the frame of that name; `base` is what the first argument stands for.
    pub(super) fn turned_by_quaternion(
        &mut self,
        called: &str,
        base: Option<usize>,
        (written, arguments): (&Expression, &[usize]),
        diagnostics: &mut Diagnostics,
    ) -> Option<usize> {
        let at = self.quaternions.iter().position(|quaternion| quaternion.name == called);
        let sound = self.check_components(called, written, arguments, diagnostics);
        let (turning, base) = (self.turnings[at.filter(|_| sound)?], base?);
        let rotation = turning.rotation(&self.coordinates, &mut self.graph);
        let spin = turning.omega.map(|symbol| self.graph.var(symbol));
        Some(self.pushed(base, rotation, spin, Mentions::COORDINATES))
    }

    /// Four different coordinates, which no other quaternion has.
    fn check_components(
        &self,
        called: &str,
        written: &Expression,
        arguments: &[usize],
        diagnostics: &mut Diagnostics,
    ) -> bool {
        let terms = written.terms();
        let frames = &self.declarations.geometry.frames;
        let own = frames.iter().position(|frame| frame.name == called);
        let before = |quaternion: &&Quaternion| own.is_some_and(|own| quaternion.frame < own);
        let mut seen: Vec<&str> = Vec::new();
        let mut sound = true;
        for at in arguments.iter().skip(1) {
            let (term, span) = &terms[*at];
            let place = |name: &str| self.declarations.coordinates.iter().position(|known| known.ident == name);
            let message = match term {
                Term::Hole => {
                    sound = false;
                    continue;
                }
                Term::Name(name) => match place(name) {
                    Some(_) if seen.contains(&name.as_str()) => messages::quaternion_component_twice(name),
                    Some(place) => {
                        seen.push(name);
                        let mut others = self.quaternions.iter().filter(before);
                        match others.find(|other| other.coordinates.contains(&place)) {
                            Some(other) => messages::quaternion_component_taken(name, &other.name),
                            None => continue,
                        }
                    }
                    None if self.names.get(name).is_none() => self.names.unknown(name),
                    None => messages::quaternion_component(),
                },
                _ => messages::quaternion_component(),
            };
            diagnostics.report(*span, message);
            sound = false;
        }
        sound
    }
}
