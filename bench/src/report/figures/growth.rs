//! The whole process: what a user waits for, and how it grows with the volume.

use crate::{
    Figure, Measure, Row,
    report::{
        Report,
        chart::{Axis, Chart, Series, Style},
        section::{Compared, Panel, Section},
        text::number,
    },
};

/// Seconds and memory of `lfpiv process`, as a table alone.
pub fn whole_process(report: &Report) -> Option<Section> {
    let cases = report.suite.cases.iter().filter(|case| case.measure == Measure::Process);
    let names: Vec<&str> = cases.map(|case| case.name.as_str()).collect();
    let rows = report.rows_of(&names);
    let compared: Vec<Compared> = rows
        .iter()
        .filter_map(|row| {
            let what = format!(
                "{}: {} voxels, {} ppm, {}",
                row.case,
                row.voxels,
                row.ppm,
                report.label(row)
            );
            let ours = format!(
                "{} s ({} s of processor time), {} × the reference kernel, {} MB",
                number(row.seconds?),
                row.cpu_s.map_or_else(|| "–".to_owned(), number),
                number(row.kernel_ratio.unwrap_or(f64::NAN)),
                row.peak_mb.map_or_else(|| "–".to_owned(), number)
            );
            Some(Compared::new(what, "not stated", ours))
        })
        .collect();
    (!compared.is_empty()).then(|| Section {
        id: "process",
        title: "The whole process",
        panels: Vec::new(),
        caption: "lfpiv process on one pair as a process of its own: configuration, tables, TIFF, \
                  two reconstructions, correlation, NetCDF and ParaView files. Seconds from start \
                  to end, median of the repeats, and processor time of all threads; peak resident memory of that process. The \
                  reference kernel is a fixed amount of multiply-adds in cache and in memory, \
                  timed in the same run: the ratio is what can be compared between machines."
            .to_owned(),
        compared,
    })
}

/// Time and memory against the number of voxels.
pub fn growth(report: &Report) -> Option<Section> {
    let rows = report.shown_in(Figure::Growth);
    let series_of = |figure: fn(&Row) -> Option<f64>, name: &str| -> Option<Series> {
        let mut points: Vec<[f64; 2]> =
            rows.iter().filter_map(|row| Some([voxels(row), figure(row)?])).collect();
        points.sort_by(|a, b| a[0].total_cmp(&b[0]));
        (points.len() > 1).then(|| Series::new(name, Style::Dots, points))
    };
    let seconds = series_of(|row| row.seconds, "seconds")?;
    let memory = series_of(|row| row.peak_mb, "peak memory, MB");
    let mut compared = grown("seconds", &seconds);
    compared.extend(memory.iter().flat_map(|memory| grown("memory", memory)));
    let chart = |mut series: Series, label: &str| {
        let first = series.points[0];
        let last = series.points[series.points.len() - 1][0];
        let proportional = vec![first, [last, first[1] * last / first[0]]];
        series.label = label.to_owned();
        Chart {
            x: Axis::log("voxels of the volume"),
            y: Axis::log(label),
            series: vec![
                series,
                Series::new("in proportion to the voxels", Style::Reference, proportional),
            ],
        }
    };
    let mut panels = vec![Panel::wide("", chart(seconds, "seconds").svg("seconds against voxels"))];
    panels.extend(memory.map(|memory| {
        Panel::wide("", chart(memory, "peak memory, MB").svg("peak memory against voxels"))
    }));
    Some(Section {
        id: "growth",
        title: "Growth with the volume at fixed seeding density",
        panels,
        caption: "lfpiv process on cubes of growing edge at the same particles per microlens, so \
                  that particles grow with the face and voxels with the volume. The sensor is the \
                  same for all: images and their decoding are a share that does not grow."
            .to_owned(),
        compared,
    })
}

/// From one size to the next: by how much the figure grew where the voxels grew by how much.
fn grown(what: &str, series: &Series) -> Vec<Compared> {
    series
        .points
        .windows(2)
        .map(|pair| {
            let ([voxels_a, a], [voxels_b, b]) = (pair[0], pair[1]);
            let edge = |voxels: f64| voxels.cbrt().round();
            Compared::new(
                format!("{what}, {}³ -> {}³ voxels", edge(voxels_a), edge(voxels_b)),
                "not stated",
                format!("× {} for × {} voxels", number(b / a), number(voxels_b / voxels_a)),
            )
        })
        .collect()
}

/// The number of voxels of a row's volume.
pub fn voxels(row: &Row) -> f64 {
    row.voxels.split('x').filter_map(|n| n.parse::<f64>().ok()).product()
}
