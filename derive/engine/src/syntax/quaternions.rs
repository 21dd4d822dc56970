//! Frames by unit quaternions, as far as names tell: which coordinates are whose, and what the speeds are called.
//!
//! The four coordinates of such a frame have three speeds, the components of its angular velocity, and a fourth one, the rate of
//! the norm, which is zero. Everybody who needs the names of the speeds, those who know the types of a model with errors among
//! them, asks here.

use proc_macro2::Ident;
use syn::ext::IdentExt;

use super::declarations::Declarations;
use super::expression::{AXES, Expression, Term};
use super::joints::is_quaternion;

/// A well-formed `B = quaternion(base, e0, e1, e2, e3)`.
#[derive(Clone, Debug)]
pub struct Quaternion {
    /// Its place among the frames.
    pub frame: usize,
    /// The frame's name.
    pub name: Ident,
    /// The places of e0, e1, e2, e3 among the coordinates.
    pub coordinates: [usize; 4],
}

impl Quaternion {
    /// `omega_B_x` and so on: the angular velocity of the frame against its base, in its own axes.
    pub fn angular(&self, axis: usize) -> String {
        format!("omega_{}_{}", self.name.unraw(), AXES[axis])
    }

    /// `norm_rate_B`: the rate of the norm, relative to it.
    pub fn norm_rate(&self) -> String {
        format!("norm_rate_{}", self.name.unraw())
    }

    /// `norm_B`: the row that holds the norm.
    pub fn norm(&self) -> String {
        format!("norm_{}", self.name.unraw())
    }
}

/// What one of v is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Speed {
    /// A name of `speeds`, by its place there.
    Given(usize),
    /// The rate of a coordinate, by its place.
    Rate(usize),
    /// A component of the angular velocity of a quaternion's frame.
    Angular(usize, usize),
    /// The rate of a quaternion's norm.
    Norm(usize),
}

impl Declarations {
    /// The frames by quaternions, in the order of the frames. What is wrong with any other is reported where frames are read.
    pub fn quaternions(&self) -> Vec<Quaternion> {
        let mut found: Vec<Quaternion> = Vec::new();
        for (frame, declared) in self.geometry.frames.iter().enumerate() {
            let Some(places) = self.components(&declared.value) else { continue };
            let taken = |place: &usize| found.iter().any(|other| other.coordinates.contains(place));
            if !places.iter().any(taken) {
                found.push(Quaternion { frame, name: declared.name.clone(), coordinates: places });
            }
        }
        found
    }

    /// The places of four different coordinates.
    fn components(&self, frame: &Expression) -> Option<[usize; 4]> {
        let (Term::Call(function, arguments), _) = frame.terms().last()? else { return None };
        let [_, components @ ..] = arguments.as_slice() else { return None };
        if !is_quaternion(function) || components.len() != 4 {
            return None;
        }
        let place = |at: &usize| match &frame.terms()[*at].0 {
            Term::Name(name) => self.coordinates.iter().position(|coordinate| coordinate.ident == name),
            _ => None,
        };
        let places: Vec<usize> = components.iter().map(place).collect::<Option<_>>()?;
        let different = (0..4).all(|i| !places[..i].contains(&places[i]));
        different.then(|| [places[0], places[1], places[2], places[3]])
    }

    /// v, in order: those of `speeds` and then the rates of norms; without `speeds` the rates of the coordinates, where those of
    /// a quaternion stand for its first one.
    pub fn all_speeds(&self, quaternions: &[Quaternion]) -> Vec<Speed> {
        if let Some(speeds) = &self.speeds {
            let given = (0..speeds.names.len()).map(Speed::Given);
            return given.chain((0..quaternions.len()).map(Speed::Norm)).collect();
        }
        let mut speeds = Vec::new();
        for place in 0..self.coordinates.len() {
            match quaternions.iter().position(|quaternion| quaternion.coordinates.contains(&place)) {
                None => speeds.push(Speed::Rate(place)),
                Some(at) if quaternions[at].coordinates.iter().all(|other| *other >= place) => {
                    speeds.extend((0..3).map(|axis| Speed::Angular(at, axis)));
                    speeds.push(Speed::Norm(at));
                }
                Some(_) => {}
            }
        }
        speeds
    }

    /// The name of one of v.
    pub fn speed_name(&self, speed: Speed, quaternions: &[Quaternion]) -> String {
        match speed {
            Speed::Given(at) => self.speeds.as_ref().map_or(String::new(), |speeds| speeds.names[at].ident.to_string()),
            Speed::Rate(at) => format!("dot_{}", self.coordinates[at].ident),
            Speed::Angular(at, axis) => quaternions[at].angular(axis),
            Speed::Norm(at) => quaternions[at].norm_rate(),
        }
    }
}
