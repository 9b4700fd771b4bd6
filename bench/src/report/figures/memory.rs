//! Memory of the explicit weight matrix, whole and by ordered subsets (paper, section 4.1).

use super::growth::voxels;
use crate::{
    Row, paper,
    report::{
        Report,
        chart::{Axis, Chart, Series, Style},
        section::{Compared, Panel, Section},
        tables::cameras,
        text::number,
    },
};

/// The two against the volume, for every method that has subsets.
pub fn matrices(report: &Report) -> Option<Section> {
    let rows: Vec<(&Row, f64, f64)> = report
        .record
        .rows
        .iter()
        .filter_map(|row| Some((row, row.matrix_mb?, row.subset_matrix_mb?)))
        .collect();
    if rows.is_empty() {
        return None;
    }
    let series = rows.iter().flat_map(|(row, whole, subset)| {
        [("all views", *whole), ("largest subset", *subset)].map(|(what, megabytes)| {
            let name = format!("{}, {what}: {} MB", report.label(row), number(megabytes));
            Series::new(name, Style::Scatter, vec![[voxels(row), megabytes]])
        })
    });
    let chart = Chart {
        x: Axis::log("voxels of the volume"),
        y: Axis::log("weight matrix, MB"),
        series: series.collect(),
    };
    let compared = rows
        .iter()
        .map(|(row, whole, subset)| {
            Compared::new(
                format!(
                    "largest subset over the whole matrix: {}, {} voxels, {}",
                    report.label(row),
                    row.voxels,
                    cameras(row.cameras)
                ),
                format!("1/12 = {}", number(paper::MEMORY_SHARE)),
                format!("1/{:.1} = {}", whole / subset, number(subset / whole)),
            )
        })
        .collect();
    Some(Section {
        id: "matrices",
        title: "Memory of the weight matrix, whole and by ordered subsets (paper, section 4.1)",
        panels: vec![Panel::wide("", chart.svg("sizes of the matrices against voxels"))],
        caption: "Bytes of the explicit sparse matrix (8 per entry), counted for all views of all \
                  cameras and for the largest ordered subset, which is all that is held at a time. \
                  The default solvers hold no matrix at all: their tables are in the memory that \
                  the whole-process rows show."
            .to_owned(),
        compared,
    })
}
