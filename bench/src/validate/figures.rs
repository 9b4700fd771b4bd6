//! The paper's Figs. 22 to 24, and what they say along the depth and of fluctuations.

use lfpiv_core::velocimetry::VectorGrid;

use super::{Comparison, Instrument, ProfilePoint, comparison::Slices};
use crate::report::{
    chart::{Axis, Chart, Series, Style},
    heat::HeatMap,
    picture::{Panel, panels, standalone},
};

/// Edge of a vector's cell in a picture for each mm between vectors.
const CELL_PER_MM: f64 = 12.0;

/// A picture with the name of its file.
pub(super) struct Picture {
    /// File name, with its ending.
    pub file: &'static str,
    /// What it shows.
    pub caption: String,
    /// SVG.
    pub svg: String,
}

/// All pictures.
pub(super) fn pictures(comparison: &Comparison) -> Vec<Picture> {
    let mean = "time-averaged streamwise velocity";
    let shade = format!("deepest shade {} m/s, 8 steps", comparison.jet.peak_m_s);
    let chart = |axis, name: &str, quantity: &str, of: Of, truth: fn(&ProfilePoint) -> f64| {
        profile(comparison, axis, name, quantity, of, truth)
    };
    vec![
        Picture {
            file: "fig22.svg",
            caption: format!("Fig. 22: {mean} in the planes x-y (z = 0) and x-z (middle); {shade}"),
            svg: volumes(comparison),
        },
        Picture {
            file: "fig23.svg",
            caption: format!("Fig. 23: {mean} at z = 0, with the region of the volume; {shade}"),
            svg: planes(comparison),
        },
        Picture {
            file: "fig24.svg",
            caption: format!("Fig. 24: {mean} along x at z = 0, averaged along y"),
            svg: chart("x", "x/D", "mean of v, m/s", |p| p.mean_m_s, |p| p.true_mean_m_s),
        },
        Picture {
            file: "rms.svg",
            caption: "Fluctuations of the streamwise velocity along the same line".to_owned(),
            svg: chart("x", "x/D", "rms of v, m/s", |p| p.rms_m_s, |p| p.true_rms_m_s),
        },
        Picture {
            file: "depth.svg",
            caption: format!("The same {mean} along z in the middle of the volume's width"),
            svg: chart("z", "z/D", "mean of v, m/s", |p| p.mean_m_s, |p| p.true_mean_m_s),
        },
    ]
}

/// A measured value of a profile's point.
type Of = fn(&ProfilePoint) -> Option<f64>;

fn profile(
    comparison: &Comparison,
    axis: &str,
    name: &str,
    quantity: &str,
    of: Of,
    truth: fn(&ProfilePoint) -> f64,
) -> String {
    let profiles: Vec<_> = comparison
        .instruments
        .iter()
        .filter_map(|instrument| Some((instrument, instrument.profile(axis)?)))
        .collect();
    // The finest lattice draws the truth.
    let finest = profiles.iter().max_by_key(|(_, profile)| profile.points.len());
    let line = finest.map_or_else(Vec::new, |(_, profile)| {
        profile.points.iter().map(|point| [point.place_over_d, truth(point)]).collect()
    });
    let measured = profiles.iter().map(|(instrument, profile)| {
        let points = profile.points.iter();
        let points = points.filter_map(|point| Some([point.place_over_d, of(point)?]));
        Series::new(instrument.name.clone(), Style::Dots, points.collect())
    });
    let series = std::iter::once(Series::new("truth", Style::Reference, line)).chain(measured);
    let ends = comparison.region.range_mm[if axis == "x" { 0 } else { 2 }];
    let outlet = comparison.jet.outlet_mm[if axis == "x" { 0 } else { 2 }];
    let [low, high] = ends.map(|end| (end - outlet) / comparison.jet.diameter_mm);
    let chart = Chart {
        x: Axis::between(name, low - 0.02, high + 0.02),
        y: Axis::from_zero(quantity),
        series: series.collect(),
    };
    standalone(&chart.svg(&format!("{quantity} against {name}")))
}

/// Planes through the volume for each instrument that has one, and for the truth.
fn volumes(comparison: &Comparison) -> String {
    let with_volume: Vec<&Instrument> =
        comparison.instruments.iter().filter(|instrument| instrument.volume.is_some()).collect();
    let truth =
        with_volume.last().and_then(|last| true_slices(comparison, last.slices.grid.as_ref()?));
    let mut rows = vec![Vec::new(), Vec::new()];
    let named = with_volume.iter().map(|one| (one.name.as_str(), &one.slices));
    for (name, slices) in named.chain(truth.iter().map(|slices| ("truth", slices))) {
        let Some(grid) = &slices.grid else { continue };
        let [nx, ny, nz] = grid.vectors;
        rows[0].push(panel(comparison, name, grid, [nx, ny], &slices.along_xy, ["x", "y"]));
        rows[1].push(panel(comparison, name, grid, [nx, nz], &slices.along_xz, ["x", "z"]));
    }
    panels(&rows)
}

/// The plane z = 0 as every instrument sees it.
fn planes(comparison: &Comparison) -> String {
    let mut row = Vec::new();
    for instrument in comparison.instruments.iter().rev() {
        let Some(grid) = &instrument.slices.grid else { continue };
        let [nx, ny, _] = grid.vectors;
        let values = &instrument.slices.along_xy;
        let mut panel = panel(comparison, &instrument.name, grid, [nx, ny], values, ["x", "y"]);
        if instrument.volume.is_none() {
            panel.marked = Some(marked(comparison, grid));
        }
        row.push(panel);
        if instrument.volume.is_none()
            && let Some(truth) = true_slices(comparison, grid)
        {
            row.push(self::panel(comparison, "truth", grid, [nx, ny], &truth.along_xy, ["x", "y"]));
        }
    }
    let wide: Vec<Panel> = row.drain(..row.len().min(2)).collect();
    panels(&[wide, row])
}

fn panel(
    comparison: &Comparison,
    title: &str,
    grid: &VectorGrid,
    size: [usize; 2],
    values: &[f32],
    axes: [&str; 2],
) -> Panel {
    let map =
        HeatMap { size, values, full: comparison.jet.peak_m_s as f32, axes, cell: cell(grid) };
    Panel { title: title.to_owned(), svg: map.svg(title), marked: None }
}

fn cell(grid: &VectorGrid) -> f64 {
    CELL_PER_MM * grid.spacing_mm
}

/// Left, right, bottom and top of the region in the picture of a lattice, as shares of its width and height.
fn marked(comparison: &Comparison, grid: &VectorGrid) -> [f64; 4] {
    let share = |axis: usize, end: usize| {
        let steps = (comparison.region.range_mm[axis][end] - grid.first_mm[axis]) / grid.spacing_mm;
        ((steps + 0.5) / grid.vectors[axis] as f64).clamp(0.0, 1.0)
    };
    [share(0, 0), share(0, 1), share(1, 0), share(1, 1)]
}

fn true_slices(comparison: &Comparison, grid: &VectorGrid) -> Option<Slices> {
    let means: Vec<f64> =
        (0..grid.len()).map(|n| comparison.jet.mean_m_s(grid.position_mm(n))[1]).collect();
    (!means.is_empty()).then(|| Slices::of(grid, |n| Some(means[n])))
}
