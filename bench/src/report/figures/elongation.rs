//! Width of single particles along depth (paper, Fig. 10).

use crate::{
    Figure, Row, paper,
    report::{
        Report,
        chart::{Axis, Chart, Series, Style},
        section::{Compared, Panel, Section},
        tables::{Group, by_case, cameras, grouped},
        text::number,
    },
};

/// Width against depth, and the means.
pub fn elongation(report: &Report) -> Option<Section> {
    let rows = report.shown_in(Figure::Elongation);
    if rows.iter().all(|row| row.fwhm_mm.is_none()) {
        return None;
    }
    let groups = grouped(&rows, by_case, |row| row.depth_mm, |row| row.fwhm_mm);
    let mut series: Vec<Series> = groups
        .iter()
        .map(|group| {
            let label = format!("{}, {}", group.row.case, label(report, group.row));
            Series::new(label, Style::Dots, group.points.clone())
        })
        .collect();
    let mut compared = means(report, &groups);
    compared.extend(in_focus(report, &rows));
    compared.extend(anywhere(report, &rows));
    let random = report.record.curves.iter().filter(|curve| curve.name == "fwhm_mm(depth_mm)");
    series.extend(random.filter(|curve| rows.iter().any(|row| row.case == curve.case)).map(|c| {
        let label = format!("anywhere, {}", report.suite.label_of(&c.method));
        Series::new(label, Style::Scatter, c.points.clone())
    }));
    let chart = Chart {
        x: Axis { range: [None; 2], ..Axis::from_zero("depth from camera 1's focus, mm") },
        y: Axis::log("FWHM along depth, mm"),
        series,
    };
    Some(Section {
        id: "elongation",
        title: "Elongation against depth (paper, Fig. 10)",
        panels: vec![Panel::wide("", chart.svg("width of single particles against depth"))],
        caption: "Full width at half maximum of the intensity profile along z through the \
                  brightest voxel, interpolated linearly. Single particles on the paper's optics, \
                  each in a small volume of its own with odd voxel counts, so that it sits on a \
                  voxel centre; beside them particles at random places within the paper's volume, \
                  with voxels of 0.05 mm. A particle that is lost counts as wide as its volume."
            .to_owned(),
        compared,
    })
}

/// Mean widths over the depths.
fn means(report: &Report, groups: &[Group]) -> Vec<Compared> {
    let several = groups.iter().filter(|group| group.points.len() > 1);
    several
        .map(|group| {
            let mean = group.points.iter().map(|p| p[1]).sum::<f64>() / group.points.len() as f64;
            let paper = match group.row.cameras {
                1 => number(paper::FWHM_ONE_CAMERA_MM),
                _ => number(paper::FWHM_TWO_CAMERAS_MM),
            };
            let what = format!("mean FWHM over depth, mm: {}", label(report, group.row));
            Compared::new(what, format!("{paper} (OS-SART)"), number(mean))
        })
        .collect()
}

/// Particles at random places.
fn anywhere(report: &Report, rows: &[&Row]) -> Vec<Compared> {
    let value = |figure: Option<f64>| figure.map_or_else(|| "–".to_owned(), number);
    rows.iter()
        .filter(|row| row.depth_mm.is_none())
        .flat_map(|row| {
            let places = row.positions.unwrap_or(0);
            let name = format!("{places} random places, {}", label(report, row));
            let width = format!("mean FWHM, mm: {name}");
            let error = format!("mean depth centroid error, mm: {name}");
            [
                Compared::new(width, "on-grid only", value(row.fwhm_mm)),
                Compared::new(error, "not stated", value(row.centroid_error_mm)),
            ]
        })
        .collect()
}

/// Particles in focus, on the centre of a microlens and wherever else the cases put them.
fn in_focus(report: &Report, rows: &[&Row]) -> Vec<Compared> {
    rows.iter()
        .filter(|row| row.depth_mm == Some(0.0))
        .filter_map(|row| {
            let paper = match row.cameras {
                1 => number(paper::FWHM_FOCUS_ONE_CAMERA_MM),
                _ => number(paper::FWHM_TWO_CAMERAS_MM),
            };
            let what = format!("FWHM in focus, mm: {}, {}", row.case, label(report, row));
            Some(Compared::new(what, format!("{paper} (OS-SART)"), number(row.fwhm_mm?)))
        })
        .collect()
}

fn label(report: &Report, row: &Row) -> String {
    format!("{}, {}", report.label(row), cameras(row.cameras))
}
