//! The motion as a picture: the path of the contact point, the lean, and the contact force.

use crate::motion::Sample;
use plotters::coord::Shift;
use plotters::prelude::*;
use std::error::Error;
use std::path::Path;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// One curve: its label, its colour, its points.
type Curve = (&'static str, RGBColor, Vec<(f64, f64)>);

/// Draws the samples to an SVG file.
pub fn draw(samples: &[Sample], path: &Path) -> Result<(), Box<dyn Error>> {
    // Large, because the backend rounds to whole pixels: a small drawing shows steps in the curves.
    let root = SVGBackend::new(path, (2000, 1280)).into_drawing_area();
    root.fill(&WHITE)?;
    let (left, right) = root.split_horizontally(1040);
    let (above, below) = right.split_vertically(640);
    let blue = RGBColor(31, 119, 180);
    let (red, green) = (RGBColor(214, 39, 40), RGBColor(44, 160, 44));

    let track = samples.iter().map(|(_, p, _)| (p.x, p.y)).collect();
    chart(&left, "path of the contact point", ["x / m", "y / m"], true, &[("", blue, track)])?;
    let lean = samples.iter().map(|(t, p, _)| (*t, p.theta.to_degrees())).collect();
    chart(&above, "lean", ["t / s", "θ / °"], false, &[("", blue, lean)])?;
    let force = |i: usize| samples.iter().map(|(t, _, f)| (*t, f[i])).collect();
    let curves = [("along x", red, force(0)), ("along y", green, force(1)), ("normal", blue, force(2))];
    chart(&below, "force of the floor on the disk", ["t / s", "λ / N"], false, &curves)?;
    root.present()?;
    Ok(())
}

fn chart(area: &Area<'_>, title: &str, labels: [&str; 2], equal: bool, curves: &[Curve]) -> Result<(), Box<dyn Error>> {
    let points = || curves.iter().flat_map(|(_, _, points)| points.iter().copied());
    let mut across = span(points().map(|p| p.0), if equal { 0.05 } else { 0.0 });
    let mut along = span(points().map(|p| p.1), 0.05);
    if equal {
        // One metre is as long on both axes.
        let (width, height) = area.dim_in_pixel();
        let ratio = (f64::from(width) - 144.0) / (f64::from(height) - 150.0);
        let (dx, dy) = (across.1 - across.0, along.1 - along.0);
        widen(&mut across, ratio * dy - dx);
        widen(&mut along, dx / ratio - dy);
    }
    let mut chart = ChartBuilder::on(area)
        .caption(title, ("sans-serif", 34))
        .margin(24)
        .x_label_area_size(68)
        .y_label_area_size(96)
        .build_cartesian_2d(across.0..across.1, along.0..along.1)?;
    chart
        .configure_mesh()
        .x_desc(labels[0])
        .y_desc(labels[1])
        .label_style(("sans-serif", 24))
        .light_line_style(WHITE)
        .draw()?;
    for (label, colour, points) in curves {
        let series = chart.draw_series(LineSeries::new(points.iter().copied(), colour.stroke_width(3)))?;
        if !label.is_empty() {
            let colour = *colour;
            series.label(*label).legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], colour.stroke_width(3)));
        }
    }
    if curves.len() > 1 {
        chart
            .configure_series_labels()
            .label_font(("sans-serif", 24))
            .background_style(WHITE.mix(0.8))
            .border_style(BLACK.mix(0.3))
            .draw()?;
    }
    Ok(())
}

fn span(values: impl Iterator<Item = f64>, margin: f64) -> (f64, f64) {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
    let more = (high - low).max(1e-9) * margin;
    (low - more, high + more)
}

fn widen(range: &mut (f64, f64), by: f64) {
    if by > 0.0 {
        *range = (range.0 - 0.5 * by, range.1 + 0.5 * by);
    }
}
