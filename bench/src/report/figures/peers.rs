//! Other programs and this one in the peers' run.

use crate::{
    Row,
    report::{
        Report,
        chart::{Axis, Chart, Series, Style},
        section::{Panel, Section},
        tables::mean_error,
    },
};

/// Q, or displacement error, against seconds: a curve over the passes of every program's setting.
pub fn beside(report: &Report) -> Option<Section> {
    let mut cases: Vec<&str> = Vec::new();
    for row in report.peers {
        if !cases.contains(&row.case.as_str()) {
            cases.push(&row.case);
        }
    }
    let panels: Vec<Panel> = cases
        .into_iter()
        .filter_map(|case| {
            let rows: Vec<&Row> = report.peers.iter().filter(|row| row.case == case).collect();
            let svg = chart(report, &rows, |row| row.q.map(|q| 1.0 - q), "1 − Q")
                .or_else(|| chart(report, &rows, mean_error, "mean |error|, voxels"))?;
            Some(Panel::wide(case, svg))
        })
        .collect();
    (!panels.is_empty()).then(|| Section {
        id: "beside",
        title: "Beside other programs",
        panels,
        caption:
            "ASTRA's SART and OpenPIV's 3-D correlation, which has a single pass only, on the \
                  same views and the same volumes as this program, and SciPy's radial basis functions \
                  through the same true particles, in a run of their own. Of \
                  programs that repeat, a curve shows what every further sweep or pass brings. \
                  Matrix assembly is not in the seconds."
                .to_owned(),
        compared: Vec::new(),
    })
}

/// One series for each program, setting and number of threads, its points in the order of the passes.
fn chart(
    report: &Report,
    rows: &[&Row],
    y: impl Fn(&Row) -> Option<f64>,
    label: &str,
) -> Option<String> {
    let mut groups: Vec<Vec<&Row>> = Vec::new();
    for &row in rows.iter().filter(|row| row.seconds.is_some() && y(row).is_some()) {
        let same = |other: &Row| {
            (&other.peer, &other.method, other.threads) == (&row.peer, &row.method, row.threads)
        };
        match groups.iter_mut().find(|group| same(group[0])) {
            Some(group) => group.push(row),
            None => groups.push(vec![row]),
        }
    }
    let series = |mut group: Vec<&Row>| {
        group.sort_by_key(|row| row.iterations);
        let points = group.iter().filter_map(|row| Some([row.seconds?, y(row)?])).collect();
        let style = if group.len() > 1 { Style::Dots } else { Style::Scatter };
        let threads = if group[0].threads == 1 { "thread" } else { "threads" };
        let name = format!("{}, {} {threads}", report.label(group[0]), group[0].threads);
        Series::new(name, style, points)
    };
    let series: Vec<Series> = groups.into_iter().map(series).collect();
    let chart = Chart { x: Axis::log("seconds"), y: Axis::log(label), series };
    (!chart.series.is_empty()).then(|| chart.svg(&format!("{label} against seconds")))
}
