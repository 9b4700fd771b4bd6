//! Reconstructed particles, projected (paper, Figs. 9 and 11).

use crate::{
    Figure, Projection,
    report::{
        Report,
        heat::HeatMap,
        section::{Panel, Section},
        tables::cameras,
    },
};

/// Width of a picture, about.
const WIDTH: f64 = 260.0;

/// Volumes summed along x onto the y-z plane, the truth first.
pub fn projections(report: &Report) -> Option<Section> {
    let cases: Vec<&str> =
        report.suite.shown_in(Figure::Projection).map(|case| case.name.as_str()).collect();
    let shown = report.record.projections.iter().filter(|p| cases.contains(&p.case.as_str()));
    let panels: Vec<Panel> = shown.map(|projection| panel(report, projection)).collect();
    (!panels.is_empty()).then(|| Section {
        id: "projections",
        title: "Reconstructed particles, projected (paper, Figs. 9 and 11)",
        panels,
        caption: "Light summed along x onto the y-z plane; z, up, is the depth of camera 1. Each \
                  picture has its own scale: full shade is half of its brightest cell or more. \
                  With one camera a particle is drawn out along depth, with two it is a point."
            .to_owned(),
        compared: Vec::new(),
    })
}

fn panel(report: &Report, projection: &Projection) -> Panel {
    let source = projection.method.as_ref().map_or_else(
        || "truth".to_owned(),
        |method| format!("{}, {}", report.suite.label_of(method), cameras(projection.cameras)),
    );
    let brightest = projection.light.iter().copied().fold(0.0f32, f32::max);
    let map = HeatMap {
        size: projection.size,
        values: &projection.light,
        full: 0.5 * brightest,
        axes: ["y", "z"],
        cell: (WIDTH / projection.size[0] as f64).min(WIDTH / projection.size[1] as f64),
    };
    let title = format!("{}: {source}", projection.case);
    Panel::narrow(title, map.svg(&format!("light of {source} on the y-z plane")))
}
