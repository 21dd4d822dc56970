//! Curves in panels, as an SVG file.

use plotters::coord::Shift;
use plotters::prelude::*;
use std::error::Error;
use std::path::Path;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// The colours of curves, in their order in a panel.
const COLOURS: [RGBColor; 4] =
    [RGBColor(31, 119, 180), RGBColor(214, 39, 40), RGBColor(44, 160, 44), RGBColor(148, 103, 189)];

/// One curve: its label, empty where a panel has only one, and its points.
pub type Curve = (&'static str, Vec<(f64, f64)>);

/// Curves over common axes.
pub struct Panel {
    pub title: &'static str,
    /// What the axes carry, with units: across, then up.
    pub labels: [&'static str; 2],
    /// Whether a unit is as long on both axes: for paths.
    pub equal: bool,
    pub curves: Vec<Curve>,
}

/// Draws panels in columns, each column from top to bottom.
pub fn draw(path: &Path, columns: &[&[Panel]]) -> Result<(), Box<dyn Error>> {
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder)?;
    }
    // Large, because the backend rounds to whole pixels: a small drawing shows steps in the curves.
    let root = SVGBackend::new(path, (1000 * columns.len() as u32, 1280)).into_drawing_area();
    root.fill(&WHITE)?;
    for (area, panels) in root.split_evenly((1, columns.len())).iter().zip(columns) {
        for (area, panel) in area.split_evenly((panels.len(), 1)).iter().zip(*panels) {
            chart(area, panel)?;
        }
    }
    root.present()?;
    Ok(())
}

fn chart(area: &Area<'_>, panel: &Panel) -> Result<(), Box<dyn Error>> {
    let points = || panel.curves.iter().flat_map(|(_, points)| points.iter().copied());
    let mut across = span(points().map(|p| p.0), if panel.equal { 0.05 } else { 0.0 });
    let mut along = span(points().map(|p| p.1), 0.05);
    if panel.equal {
        let (width, height) = area.dim_in_pixel();
        let ratio = (f64::from(width) - 144.0) / (f64::from(height) - 150.0);
        let (dx, dy) = (across.1 - across.0, along.1 - along.0);
        widen(&mut across, ratio * dy - dx);
        widen(&mut along, dx / ratio - dy);
    }
    let mut chart = ChartBuilder::on(area)
        .caption(panel.title, ("sans-serif", 34))
        .margin(24)
        .x_label_area_size(68)
        .y_label_area_size(110)
        .build_cartesian_2d(across.0..across.1, along.0..along.1)?;
    chart
        .configure_mesh()
        .x_desc(panel.labels[0])
        .y_desc(panel.labels[1])
        .label_style(("sans-serif", 24))
        .light_line_style(WHITE)
        .draw()?;
    for ((label, points), colour) in panel.curves.iter().zip(COLOURS.into_iter().cycle()) {
        let series = chart.draw_series(LineSeries::new(points.iter().copied(), colour.stroke_width(3)))?;
        if !label.is_empty() {
            series.label(*label).legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], colour.stroke_width(3)));
        }
    }
    if panel.curves.len() > 1 {
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
