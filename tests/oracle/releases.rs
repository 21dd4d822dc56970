//! Reactions of joints that were never written as constraints: the model with the joint let go and held by a constraint.

use super::check::Compared;
use super::declaration::{Constraint, Declaration, Level};
use super::geometry::Record;
use super::kkt::UNIT;
use super::number::Scaled;
use super::statements::{expression, plain};
use super::system::{Entry, System};
use proc_macro2::Span;
use syn::{Ident, parse_quote};

impl Compared<'_> {
    /// What holds every release: the multiplier of ε = 0 by the full system with ε and its speed.
    pub(super) fn released(&self) -> Vec<(String, Entry)> {
        let releases = &self.system.model.geometry.releases;
        if releases.is_empty() {
            return Vec::new();
        }
        let mut model = self.system.model.clone();
        releases.iter().for_each(|release| let_go(&mut model, release));
        let System { parameters, inputs, .. } = self.system.clone();
        let system = System { model: &model, parameters, inputs };
        let zeros = vec![0.0; releases.len()];
        let motion = system.motion(
            self.claim.t,
            &[self.claim.coordinates.as_slice(), &zeros].concat(),
            &[self.claim.velocities.as_slice(), &zeros].concat(),
        );
        // with the multipliers of the model itself: where rows depend on each other what holds ε would share in them otherwise
        let (first, rows) = (
            self.claim.velocities.len(),
            system.rows(
                self.claim.t,
                &[self.claim.coordinates.as_slice(), &zeros].concat(),
                &[self.claim.velocities.as_slice(), &zeros].concat(),
            ),
        );
        let known = self.named_reactions();
        let lambda =
            |name: &String| known.iter().find(|(other, _)| other == name).map_or(0.0, |(_, entry)| entry.value);
        let of = |(i, release): (usize, &Record)| {
            let pulled: f64 =
                rows.names.iter().enumerate().map(|(row, name)| rows.c[(row, first + i)].value * lambda(name)).sum();
            let (value, error) = (motion.reaction[first + i] - pulled, motion.reaction_error[first + i]);
            (release.name.clone(), Scaled { value, size: value.abs().max(error / UNIT) })
        };
        releases.iter().enumerate().map(of).collect()
    }
}

/// One more coordinate by which the point moves, or the frame turns, and which a constraint holds at zero.
fn let_go(model: &mut Declaration, release: &Record) {
    let name = format!("epsilon_{}", release.name);
    let epsilon = Ident::new(&name, Span::call_site());
    if let Some(point) = release.entries.get("point") {
        let (point, along) = (plain(point).expect("the name of a point"), release.entry("along"));
        let place = model.geometry.points.get_mut(&point).expect("a point of that name");
        *place = parse_quote!((#place) + #epsilon*(#along));
    } else {
        let (frame, about) = (plain(release.entry("frame")).expect("the name of a frame"), release.entry("about"));
        let axes = model.geometry.frames.get_mut(&frame).expect("a frame of that name");
        *axes = parse_quote!(rotate(#axes, #about, #epsilon));
    }
    model.coordinates.push(name.clone());
    model.speeds.push(format!("dot_{name}"));
    if let Some(rates) = &mut model.rates {
        rates.push(expression(&format!("dot_{name}")));
    }
    if let Some(speeds) = &mut model.speeds_by_rates {
        speeds.push(parse_quote!(dot(#epsilon)));
    }
    model.constraints.push(Constraint {
        name: release.name.clone(),
        left: parse_quote!(#epsilon),
        right: parse_quote!(0),
        level: Level::Position,
        redundant: false,
        expressed: expression("N"),
        in_short: false,
    });
}
