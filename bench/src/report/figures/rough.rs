//! Flows with small scales: what of them is measured, at the vectors and between them.

use crate::{
    Figure, Row,
    report::{
        Report,
        chart::{Axis, Chart, Series, Style},
        section::{Compared, Panel, Section},
        tables::{by_case, grouped, mean, mean_of_components, mean_true_followed},
        text::number,
    },
};

/// Error, valid vectors and coverage of every case and density: means over the seeds.
pub fn rough_flows(report: &Report) -> Option<Section> {
    let rows = report.shown_in(Figure::RoughFlows);
    let mut cases: Vec<(&str, f64)> = Vec::new();
    for row in &rows {
        if !cases.contains(&(row.case.as_str(), row.ppm)) {
            cases.push((&row.case, row.ppm));
        }
    }
    let compared: Vec<Compared> = cases
        .into_iter()
        .filter_map(|(case, ppm)| {
            let of: Vec<&Row> =
                rows.iter().copied().filter(|row| row.case == case && row.ppm == ppm).collect();
            line(&of)
        })
        .collect();
    (!compared.is_empty()).then(|| Section {
        id: "rough",
        title: "Flows with small scales",
        caption: "Turbulence with waves of 16 to 100 voxels, a shear layer four voxels thick, and smooth \
                  flows with few particles; light differs between frames and cameras. Errors are means of \
                  |error| over all vectors, valid or not, and at random places between vectors that have a \
                  value, by cubic convolution. Coverage is of valid vectors: 68 and 95 % lie within the \
                  stated intervals where uncertainties are right. The paper has no such flows."
            .to_owned(),
        compared,
        ..Section::default()
    })
}

fn line(rows: &[&Row]) -> Option<Compared> {
    let row = rows.first()?;
    let percent = |share: Option<f64>| Some(number(100.0 * share?));
    let three = |errors: [f64; 3]| errors.map(number).join(", ");
    let ours = format!(
        "{} voxel along x, y, z at the vectors, {} between them (true particles, tracked: {} in the \
         mean), {} % valid, {} and {} % covered",
        three(mean_of_components(rows, Row::error_vox)?),
        mean_of_components(rows, Row::unseen_vox).map_or_else(|| "–".to_owned(), three),
        mean(rows, mean_true_followed).map_or_else(|| "–".to_owned(), number),
        percent(mean(rows, |row| row.valid_share))?,
        percent(mean(rows, |row| row.covered_68))?,
        percent(mean(rows, |row| row.covered_95))?,
    );
    Some(Compared::new(format!("{}: {} ppm, {} seeds", row.case, row.ppm, rows.len()), "", ours))
}

/// Gain against wavelength, one curve for each amplitude: means over directions and seeds.
pub fn gain(report: &Report) -> Option<Section> {
    let rows = report.shown_in(Figure::Gain);
    let mut amplitudes: Vec<f64> = Vec::new();
    for amplitude in rows.iter().filter_map(|row| row.amplitude_vox) {
        if !amplitudes.iter().any(|known| (known - amplitude).abs() < 1e-6) {
            amplitudes.push(amplitude);
        }
    }
    let (mut series, mut compared) = (Vec::new(), Vec::new());
    for amplitude in amplitudes {
        let of: Vec<&Row> = rows
            .iter()
            .copied()
            .filter(|row| row.amplitude_vox.is_some_and(|a| (a - amplitude).abs() < 1e-6))
            .collect();
        for group in grouped(&of, by_case, |row| row.wavelength_vox, |row| row.gain) {
            let name = format!("{} voxel, {}", number(amplitude), group.row.case);
            for [wavelength, gain] in &group.points {
                let what = format!("gain at {} voxels, {name}", number(*wavelength));
                compared.push(Compared::new(what, "", number(*gain)));
            }
            series.push(Series::new(name, Style::Dots, group.points));
        }
    }
    if series.is_empty() {
        return None;
    }
    let chart = Chart {
        x: Axis::from_zero("wavelength, voxels"),
        y: Axis::between("gain", 0.0, 1.2),
        series,
    };
    Some(Section {
        id: "gain",
        title: "What of a plane wave is measured",
        panels: vec![Panel::wide("gain", chart.svg("gain against wavelength"))],
        caption: "Transverse plane waves along x, y, z and along a diagonal, each alone in the volume: the \
                  part of their amplitude that the vectors 12 voxels or more inside the volume hold, by \
                  least squares. 1 is all of it. A curve for each amplitude."
            .to_owned(),
        compared,
    })
}
