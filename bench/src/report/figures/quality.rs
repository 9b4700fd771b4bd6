//! Q against seeding density (paper, Fig. 12).

use crate::{
    Figure, paper,
    report::{
        Report,
        chart::{Axis, Chart, Series, Style},
        section::{Compared, Panel, Section},
        tables::{by_volume, cameras, grouped},
        text::number,
    },
};

/// Q against ppm for one camera and two.
pub fn quality_ppm(report: &Report) -> Option<Section> {
    let rows = report.shown_in(Figure::QualityPpm);
    let groups = grouped(&rows, by_volume, |row| Some(row.ppm), |row| row.q);
    if groups.is_empty() {
        return None;
    }
    let mut series: Vec<Series> = groups
        .iter()
        .map(|group| {
            let volume = &group.row.voxels;
            let label =
                format!("{}, {}, {volume}", report.label(group.row), cameras(group.row.cameras));
            Series::new(label, Style::Dots, group.points.clone())
        })
        .collect();
    let densest = rows.iter().map(|row| row.ppm).fold(0.0, f64::max);
    let usable = paper::USABLE_QUALITY;
    series.push(Series::new(
        "usable: Q = 0.75",
        Style::Reference,
        vec![[0.0, usable], [densest, usable]],
    ));
    let chart = Chart {
        x: Axis::from_zero("particles per microlens"),
        y: Axis::between("Q", 0.0, 1.0),
        series,
    };
    let compared = groups
        .iter()
        .filter_map(|group| {
            let least = group.points.iter().map(|point| point[1]).reduce(f64::min)?;
            let paper = match group.row.cameras {
                2 => "above 0.75",
                _ => "below two cameras; no value in the text",
            };
            let what = format!(
                "lowest Q over the densities: {}, {}, {} voxels",
                report.label(group.row),
                cameras(group.row.cameras),
                group.row.voxels
            );
            Some(Compared::new(what, paper, number(least)))
        })
        .collect();
    Some(Section {
        id: "quality-ppm",
        title: "Q against seeding density (paper, Fig. 12)",
        panels: vec![Panel::wide("", chart.svg("Q against particles per microlens"))],
        caption: "Particles on voxel centres, no noise, as in the paper; images by ray tracing."
            .to_owned(),
        compared,
    })
}
