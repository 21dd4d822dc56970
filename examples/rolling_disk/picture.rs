//! The motion as a picture: the path of the contact point, the lean, and the contact force.

use crate::common::picture::{Panel, draw as drawn};
use crate::motion::Sample;
use std::error::Error;
use std::path::Path;

/// Draws the samples to an SVG file.
pub fn draw(samples: &[Sample], path: &Path) -> Result<(), Box<dyn Error>> {
    let force = |i: usize| samples.iter().map(|(t, _, f)| (*t, f[i])).collect();
    let track = Panel {
        title: "path of the contact point",
        labels: ["x / m", "y / m"],
        equal: true,
        curves: vec![("", samples.iter().map(|(_, p, _)| (p.x, p.y)).collect())],
    };
    let lean = Panel {
        title: "lean",
        labels: ["t / s", "θ / °"],
        equal: false,
        curves: vec![("", samples.iter().map(|(t, p, _)| (*t, p.theta.to_degrees())).collect())],
    };
    let forces = Panel {
        title: "force of the floor on the disk",
        labels: ["t / s", "λ / N"],
        equal: false,
        curves: vec![("normal", force(2)), ("along x", force(0)), ("along y", force(1))],
    };
    drawn(path, &[&[track], &[lean, forces]])
}
