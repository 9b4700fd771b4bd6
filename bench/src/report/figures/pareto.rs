//! What accuracy costs: error, or what Q lacks, against seconds; the Pareto front marked.

use crate::{
    Figure, Row,
    report::{
        Report,
        chart::{Axis, Chart, Series, Style},
        section::{Panel, Section},
        tables::{
            by_case, grouped, mean, mean_error, mean_true_followed, mean_true_windows, pareto_front,
        },
        text::number,
    },
};

/// A figure of a row.
type FigureOf = fn(&Row) -> Option<f64>;

/// What is drawn beside the methods: a name for the legend, and the figure.
const TRUE_PARTICLES: [(&str, FigureOf); 2] = [
    ("true particles, windows only", mean_true_windows),
    ("true particles, tracked", mean_true_followed),
];

/// Displacement error against the seconds of a pair.
pub fn error_seconds(report: &Report) -> Option<Section> {
    let panels = panels(report, Figure::ErrorSeconds, mean_error, |rows| {
        let mut lines = Vec::new();
        for (name, figure) in TRUE_PARTICLES {
            if let Some(error) = mean(rows, figure) {
                lines.push((format!("{name}: {}", number(error)), error));
            }
        }
        ("mean |error| of the three components, voxels", lines)
    });
    (!panels.is_empty()).then(|| Section {
        id: "error-seconds",
        title: "Error against seconds",
        panels,
        caption: "Every method on the same images; mean over the seeds. A method on the grey \
                  front is beaten by no other in both time and error. True particles by windows \
                  alone leave more than images in which single particles are followed; true \
                  particles that are followed, too, are what images and reconstruction add to. \
                  Seconds are those of one pair in a running program: decoding, two \
                  reconstructions, correlation, and particles where they are placed."
            .to_owned(),
        compared: Vec::new(),
    })
}

/// What Q lacks to 1 against the seconds of a reconstruction.
pub fn quality_seconds(report: &Report) -> Option<Section> {
    let panels = panels(
        report,
        Figure::QualitySeconds,
        |row| row.q.map(|q| 1.0 - q),
        |_| ("1 − Q", vec![("Q = 0.75".to_owned(), 0.25)]),
    );
    (!panels.is_empty()).then(|| Section {
        id: "quality-seconds",
        title: "Quality against seconds",
        panels,
        caption: "What the quality factor lacks to 1 against the time of one reconstruction, its \
                  start counted; particles on voxel centres as in the paper. Lower is better on \
                  both axes."
            .to_owned(),
        compared: Vec::new(),
    })
}

/// One chart per case and density.
fn panels(
    report: &Report,
    figure: Figure,
    y: impl Fn(&Row) -> Option<f64> + Copy,
    describe: impl Fn(&[&Row]) -> (&'static str, Vec<(String, f64)>),
) -> Vec<Panel> {
    let rows = report.shown_in(figure);
    let mut keys: Vec<(&str, f64)> = Vec::new();
    for row in rows.iter().filter(|row| row.peer.is_none()) {
        if !keys.contains(&(row.case.as_str(), row.ppm)) {
            keys.push((&row.case, row.ppm));
        }
    }
    keys.into_iter()
        .filter_map(|(case, ppm)| {
            let here: Vec<&Row> = rows
                .iter()
                .copied()
                .filter(|row| row.case == case && (row.ppm == ppm || row.peer.is_some()))
                .collect();
            let (label, lines) = describe(&here);
            chart(report, &here, y, label, &lines).map(|svg| {
                let facts = here[0];
                let title = format!(
                    "{case}: {} voxels, {} ppm, {}, noise: {}",
                    facts.voxels, ppm, facts.placement, facts.noise
                );
                Panel::wide(title, svg)
            })
        })
        .collect()
}

fn chart(
    report: &Report,
    rows: &[&Row],
    y: impl Fn(&Row) -> Option<f64> + Copy,
    label: &str,
    lines: &[(String, f64)],
) -> Option<String> {
    // One group per method: its mean time, and its mean figure.
    let times = grouped(rows, by_case, |_| Some(0.0), |row| y(row).and(row.seconds));
    let values = grouped(rows, by_case, |_| Some(0.0), |row| row.seconds.and(y(row)));
    let points: Vec<[f64; 2]> =
        times.iter().zip(&values).map(|(t, v)| [t.points[0][1], v.points[0][1]]).collect();
    if points.is_empty() {
        return None;
    }
    let ends = points
        .iter()
        .fold([f64::MAX, f64::MIN], |[low, high], point| [low.min(point[0]), high.max(point[0])]);
    let mut series = vec![Series::new("Pareto front", Style::Front, pareto_front(&points))];
    series.extend(lines.iter().map(|(name, value)| {
        Series::new(name.clone(), Style::Reference, vec![[ends[0], *value], [ends[1], *value]])
    }));
    series.extend(
        times.iter().zip(&points).map(|(group, point)| {
            Series::new(report.label(group.row), Style::Scatter, vec![*point])
        }),
    );
    let chart = Chart { x: Axis::log("seconds"), y: Axis::log(label), series };
    Some(chart.svg(&format!("{label} against seconds, one dot per method")))
}
