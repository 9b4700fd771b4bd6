//! The ring vortex: vorticity iso-surface and slices (paper, Figs. 14 to 16).

use lfpiv_core::velocimetry::VelocityField;

use crate::{
    Figure, MeasuredField, paper,
    report::{
        Report,
        heat::HeatMap,
        section::{Panel, Section},
        surface::Scalars,
        tables::cameras,
    },
};

/// Height of an iso-surface's picture and width of a slice's, about.
const SURFACE_HEIGHT: i32 = 240;
const SLICE_WIDTH: f64 = 250.0;

/// Where |vorticity| is the paper's level.
pub fn iso_surface(report: &Report) -> Option<Section> {
    let panels: Vec<Panel> = fields(report)
        .map(|measured| {
            let field = &measured.field;
            let size = |v: &[f32; 3]| v.iter().map(|c| f64::from(*c).powi(2)).sum::<f64>().sqrt();
            let scalars = Scalars {
                nodes: field.grid.vectors,
                values: field.vorticity.iter().map(size).collect(),
            };
            let name = source(report, measured);
            let description = format!("vorticity iso-surface of the ring, {name}");
            let svg = scalars.surface_svg(paper::ISO_VORTICITY, SURFACE_HEIGHT, &description);
            Panel::narrow(name, svg)
        })
        .collect();
    (!panels.is_empty()).then(|| Section {
        id: "vorticity",
        title: "Vorticity iso-surface of the ring vortex (paper, Fig. 14)",
        panels,
        caption: format!(
            "Where the magnitude of the vorticity is {} voxel per voxel, the paper's level, on \
             the lattice of the vectors; the true field is sampled at the same places and \
             differentiated alike. The paper's ring is drawn out of shape with one camera and \
             round with two.",
            paper::ISO_VORTICITY
        ),
        compared: Vec::new(),
    })
}

/// v on the central y-z slice, w on the central x-y slice.
pub fn slices(report: &Report) -> Option<Section> {
    let mut panels = Vec::new();
    for measured in fields(report) {
        let name = source(report, measured);
        let largest = largest_true(report, measured);
        let [nx, ny, nz] = measured.field.grid.vectors;
        let v = slice(&measured.field, 0, 1);
        let w = slice(&measured.field, 2, 2);
        panels.push(panel(format!("v on y-z: {name}"), [ny, nz], &v, largest, ["y", "z"]));
        panels.push(panel(format!("w on x-y: {name}"), [nx, ny], &w, largest, ["x", "y"]));
    }
    (!panels.is_empty()).then(|| Section {
        id: "slices",
        title: "Slices through the ring vortex (paper, Figs. 15 and 16)",
        panels,
        caption: "The component v on the central y-z slice and w on the central x-y slice, one \
                  cell per vector; full shade is the largest displacement of the true field, one \
                  colour for each sign. A single camera damps w towards zero."
            .to_owned(),
        compared: Vec::new(),
    })
}

fn fields<'a>(report: &'a Report) -> impl Iterator<Item = &'a MeasuredField> {
    let cases: Vec<&str> =
        report.suite.shown_in(Figure::Vortex).map(|case| case.name.as_str()).collect();
    report.record.fields.iter().filter(move |field| cases.contains(&field.case.as_str()))
}

fn source(report: &Report, measured: &MeasuredField) -> String {
    match &measured.method {
        None => format!("truth, {} ppm", measured.ppm),
        Some(method) => format!(
            "{}, {}, {} ppm",
            report.suite.label_of(method),
            cameras(measured.cameras),
            measured.ppm
        ),
    }
}

/// The largest |component| of the true field of the same case.
fn largest_true(report: &Report, measured: &MeasuredField) -> f32 {
    let truth = fields(report)
        .find(|other| other.method.is_none() && other.case == measured.case)
        .unwrap_or(measured);
    let components = truth.field.displacement_vox.iter().flatten();
    components.fold(0.0f32, |largest, c| largest.max(c.abs()))
}

/// One component on the central slice across an axis, the lower axis along rows.
fn slice(field: &VelocityField, across: usize, component: usize) -> Vec<f32> {
    let nodes = field.grid.vectors;
    let [first, second] = match across {
        0 => [1, 2],
        1 => [0, 2],
        _ => [0, 1],
    };
    let mut values = Vec::with_capacity(nodes[first] * nodes[second]);
    for b in 0..nodes[second] {
        for a in 0..nodes[first] {
            let mut at = [0; 3];
            (at[across], at[first], at[second]) = (nodes[across] / 2, a, b);
            let index = (at[2] * nodes[1] + at[1]) * nodes[0] + at[0];
            values.push(field.displacement_vox[index][component]);
        }
    }
    values
}

fn panel(title: String, size: [usize; 2], values: &[f32], full: f32, axes: [&str; 2]) -> Panel {
    let cell = SLICE_WIDTH / size[0] as f64;
    let map = HeatMap { size, values, full, axes, cell };
    let svg = map.svg(&title);
    Panel::narrow(title, svg)
}
