//! Displacement errors of the ring vortex (paper, Figs. 17 and 18).

use crate::{
    Figure, Row, paper,
    report::{
        Report,
        chart::{Axis, Chart, Series, Style},
        section::{Compared, Panel, Section},
        tables::{by_volume, cameras, grouped},
        text::number,
    },
};

/// A component: its name, column, and curve.
const COMPONENTS: [(&str, usize, &str); 2] =
    [("v", 1, "cdf_y(error_vox)"), ("w", 2, "cdf_z(error_vox)")];

/// Figures of a row along x, y, z.
type FigureOf = fn(&Row) -> Option<[f64; 3]>;

/// What is drawn beside the images: a name for the legend, and the figures along x, y, z.
const TRUE_PARTICLES: [(&str, FigureOf); 2] = [
    ("true particles, windows only", Row::true_windows_vox),
    ("true particles, tracked", Row::true_followed_vox),
];

/// Mean error of v and w against seeding density.
pub fn error_ppm(report: &Report) -> Option<Section> {
    let rows = report.shown_in(Figure::ErrorPpm);
    let mut compared = Vec::new();
    let panels: Vec<Panel> = COMPONENTS
        .into_iter()
        .map(|(name, axis, _)| {
            let error = |row: &Row| row.error_vox().map(|error| error[axis]);
            let groups = grouped(&rows, by_volume, |row| Some(row.ppm), error);
            let mut series: Vec<Series> = groups
                .iter()
                .map(|group| {
                    Series::new(label(report, group.row), Style::Dots, group.points.clone())
                })
                .collect();
            for (name, figures) in TRUE_PARTICLES {
                let figure = |row: &Row| figures(row).map(|error| error[axis]);
                if let Some(group) = grouped(&rows, by_volume, |row| Some(row.ppm), figure).first()
                {
                    series.push(Series::new(name, Style::Reference, group.points.clone()));
                }
            }
            for group in &groups {
                let most = group.points.iter().map(|point| point[1]).fold(0.0, f64::max);
                let paper = match (group.row.cameras, name) {
                    (1, "w") => format!("{} (OS-SART)", paper::ERROR_W_ONE_CAMERA_VOX),
                    (1, _) => "close to two cameras".to_owned(),
                    _ => format!("< {}", paper::ERROR_TWO_CAMERAS_VOX),
                };
                let what = format!("largest σ of {name}, voxels: {}", label(report, group.row));
                compared.push(Compared::new(what, paper, number(most)));
            }
            let chart = Chart {
                x: Axis::from_zero("particles per microlens"),
                y: Axis::from_zero(&format!("mean |error| of {name}, voxels")),
                series,
            };
            Panel::wide(name, chart.svg(&format!("mean error of {name} against density")))
        })
        .collect();
    (!panels.is_empty()).then(|| Section {
        id: "error-ppm",
        title: "Displacement error against seeding density (paper, Fig. 17)",
        panels,
        caption: "σ of the paper's Eq. 6 against the analytic flow, all vectors counted, valid or \
                  not. w is the component along the depth of camera 1. Particles sit on voxel \
                  centres in the middle of the pair, so in neither frame do they stay there."
            .to_owned(),
        compared,
    })
}

/// Share of the vectors within an error.
pub fn cumulative(report: &Report) -> Option<Section> {
    let rows = report.shown_in(Figure::Cumulative);
    let mut compared = Vec::new();
    let panels: Vec<Panel> = COMPONENTS
        .into_iter()
        .filter_map(|(name, axis, curve_name)| {
            let mut series = Vec::new();
            for row in &rows {
                let curve = report.record.curves.iter().find(|curve| {
                    curve.name == curve_name
                        && (&curve.case, &curve.method) == (&row.case, &row.method)
                        && (curve.cameras, curve.ppm, curve.seed)
                            == (row.cameras, row.ppm, row.seed)
                });
                let (Some(curve), Some(within)) = (curve, row.within()) else { continue };
                let name_of = format!("{}, {} ppm", label(report, row), row.ppm);
                let paper = match (row.cameras, name) {
                    (1, "w") => format!("< {}", paper::WITHIN_W_ONE_CAMERA),
                    (2, "w") => number(paper::WITHIN_W),
                    _ => format!("about {}", paper::WITHIN_V),
                };
                let what = format!("share of {name} within 0.3 voxel, {name_of}");
                compared.push(Compared::new(what, paper, number(within[axis])));
                series.push(Series::new(name_of, Style::Line, curve.points.clone()));
            }
            let chart = Chart {
                x: Axis::between(&format!("|error| of {name}, voxels"), 0.0, 0.5),
                y: Axis::between("share of the vectors", 0.0, 1.0),
                series,
            };
            (!chart.series.is_empty()).then(|| {
                Panel::wide(name, chart.svg(&format!("cumulative distribution of {name}'s error")))
            })
        })
        .collect();
    (!panels.is_empty()).then(|| Section {
        id: "cumulative",
        title: "Cumulative error (paper, Fig. 18)",
        panels,
        caption: "Share of the vectors whose error is at most the abscissa. In the table, vectors \
                  that are marked invalid count as misses. The paper's shares are at 1.6 ppm."
            .to_owned(),
        compared,
    })
}

fn label(report: &Report, row: &Row) -> String {
    format!("{}, {}", report.label(row), cameras(row.cameras))
}
