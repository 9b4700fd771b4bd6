//! Memory of the explicit weight matrix, whole and by ordered subsets (paper, section 4.1).

use crate::{
    Row, paper,
    report::{
        Report,
        section::{Compared, Panel, Section},
        svg::{Svg, number},
        tables::cameras,
    },
};

const WIDTH: f64 = 860.0;
const ROW: f64 = 44.0;
const BARS: f64 = 420.0;

/// Bars of the two, for every method that has subsets.
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
    let largest = rows.iter().map(|(_, whole, _)| *whole).fold(0.0, f64::max);
    let mut svg = Svg::new(WIDTH, ROW * rows.len() as f64 + 8.0);
    for (n, (row, whole, subset)) in rows.iter().enumerate() {
        let top = 8.0 + n as f64 * ROW;
        for (class, megabytes, offset, what) in
            [("c0", whole, 0.0, "all views"), ("c1", subset, 16.0, "largest subset")]
        {
            let width = BARS * megabytes / largest;
            svg.raw(&format!(
                "<rect class=\"fill {class}\" x=\"190\" y=\"{:.1}\" width=\"{width:.1}\" \
                 height=\"13\"/>",
                top + offset
            ));
            let text = format!("{what}: {} MB", number(*megabytes));
            svg.text("tick", "start", [196.0 + width, top + offset + 11.0], &text);
        }
        svg.text("label", "end", [182.0, top + 18.0], &report.label(row));
    }
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
        panels: vec![Panel::wide("", svg.finish("bars of the matrices' sizes"))],
        caption: "Bytes of the explicit sparse matrix (8 per entry), counted for all views of all \
                  cameras and for the largest ordered subset, which is all that is held at a time. \
                  The default solvers hold no matrix at all: their tables are in the memory that \
                  the whole-process rows show."
            .to_owned(),
        compared,
    })
}
