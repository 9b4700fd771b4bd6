//! Q and ε against iterations, and what ordered subsets gain (paper, Figs. 4 and 13).

use lfpiv_core::reconstruction::Solver;

use crate::{
    Curve, Figure, paper,
    report::{
        Report,
        chart::{Axis, Chart, Series, Style},
        section::{Compared, Panel, Section},
        tables::cameras,
        text::number,
    },
};

/// A curve counts as converged from where all of it is this close to its last value.
const CONVERGED: f64 = 0.01;

/// One that comes that close only after this share of its passes had not converged.
const SETTLED_BEFORE: f64 = 0.75;

/// Q after every pass, and the ratio of times at Q = 0.75.
pub fn quality_iterations(report: &Report) -> Option<Section> {
    let shown = curves(report, "q(iteration)");
    if shown.is_empty() {
        return None;
    }
    let mut compared: Vec<Compared> = shown
        .iter()
        .filter_map(|curve| {
            let (passes, last) = (converged_after(curve)?, curve.points.last()?[1]);
            let paper = match report.suite.solver_of(&curve.method) {
                Some(Solver::OsSart) => number(paper::PASSES_OS_SART),
                Some(Solver::Sart) => number(paper::PASSES_SART),
                _ => "–".to_owned(),
            };
            Some(Compared::new(
                format!("iterations until Q is within 0.01 of its last, {}", name(report, curve)),
                paper,
                format!("{} (Q {})", converged(curve, passes), number(last)),
            ))
        })
        .collect();
    let gains = accelerations(report);
    let usable = Some(paper::USABLE_QUALITY);
    let mut panels = panels(report, &shown, Axis::between("Q", 0.0, 1.0), usable);
    panels.extend(gain_panel(&gains));
    compared.extend(gains.into_iter().map(|gain| {
        Compared::new(
            format!("SART's time over OS-SART's at Q = 0.75, {} ppm", gain.ppm),
            format!("≥ {}", number(paper::ACCELERATION)),
            gain.ratio.map_or_else(|| "Q = 0.75 not reached by both".to_owned(), number),
        )
    }));
    Some(Section {
        id: "quality-iterations",
        title: "Q against iterations (paper, Fig. 13)",
        panels,
        caption: "The paper's solvers on a smaller volume than its 100³ voxels, because a pass of \
                  SART over that takes long; every row says which. A slab that is as deep as the \
                  paper's volume for both cameras holds as many particles per voxel at the same \
                  ppm. Time is that of the passes alone."
            .to_owned(),
        compared,
    })
}

/// ε after every pass.
pub fn error_iterations(report: &Report) -> Option<Section> {
    let shown = curves(report, "relative_error(iteration)");
    if shown.is_empty() {
        return None;
    }
    let compared = shown
        .iter()
        .filter_map(|curve| {
            let paper = match report.suite.solver_of(&curve.method) {
                Some(Solver::OsSart) => number(paper::EXAMPLE_PASSES_OS_SART),
                Some(Solver::Sart) => number(paper::EXAMPLE_PASSES_SART),
                _ => "–".to_owned(),
            };
            let what =
                format!("iterations until ε is within 0.01 of its last, {}", name(report, curve));
            Some(Compared::new(what, paper, converged(curve, converged_after(curve)?)))
        })
        .collect();
    Some(Section {
        id: "error-iterations",
        title: "Reconstruction error against iterations (paper, Fig. 4)",
        panels: panels(report, &shown, Axis::from_zero("ε over ε of a dark volume"), None),
        caption:
            "ε of the paper's Eq. 3, divided by that of a dark volume so that it begins at 1. \
                  The paper's example is a system of equations that it does not describe further."
                .to_owned(),
        compared,
    })
}

/// What OS-SART gains over SART at one density.
pub struct Gain {
    /// Particles per microlens.
    pub ppm: f64,
    /// SART's time to Q = 0.75 over OS-SART's; absent where one never reaches it.
    pub ratio: Option<f64>,
}

/// The gain at every density that both were watched at.
pub fn accelerations(report: &Report) -> Vec<Gain> {
    let quality = curves(report, "q(iteration)");
    let by = |solver: Solver| -> Vec<&Curve> {
        let wanted = |curve: &&&Curve| report.suite.solver_of(&curve.method) == Some(solver);
        quality.iter().filter(wanted).copied().collect()
    };
    let (slow, fast) = (by(Solver::Sart), by(Solver::OsSart));
    let pairs = slow.iter().filter_map(|slow| {
        let same = |fast: &&&Curve| {
            (fast.ppm, fast.cameras, &fast.case) == (slow.ppm, slow.cameras, &slow.case)
        };
        Some((slow, fast.iter().find(same)?))
    });
    pairs
        .map(|(slow, fast)| Gain {
            ppm: slow.ppm,
            ratio: seconds_to(report, slow).zip(seconds_to(report, fast)).map(|(s, f)| s / f),
        })
        .collect()
}

/// Time until a curve of Q first reaches 0.75, in s.
fn seconds_to(report: &Report, quality: &Curve) -> Option<f64> {
    let nth = quality.points.iter().position(|point| point[1] >= paper::USABLE_QUALITY)?;
    let of_same = |curve: &&Curve| {
        curve.name == "seconds(iteration)"
            && (&curve.case, &curve.method, curve.ppm, curve.cameras)
                == (&quality.case, &quality.method, quality.ppm, quality.cameras)
    };
    Some(report.record.curves.iter().find(of_same)?.points.get(nth)?[1])
}

fn curves<'a>(report: &'a Report, name: &str) -> Vec<&'a Curve> {
    let shown: Vec<&str> =
        report.suite.shown_in(Figure::Convergence).map(|case| case.name.as_str()).collect();
    let mut curves: Vec<&Curve> = report
        .record
        .curves
        .iter()
        .filter(|curve| curve.name == name && shown.contains(&curve.case.as_str()))
        .collect();
    // The first seed stands for all.
    curves.dedup_by(|b, a| {
        (&a.case, &a.method, a.ppm, a.cameras) == (&b.case, &b.method, b.ppm, b.cameras)
    });
    curves
}

fn name(report: &Report, curve: &Curve) -> String {
    let method = report.suite.label_of(&curve.method);
    format!("{method}, {} ppm, {}", curve.ppm, cameras(curve.cameras))
}

/// Passes after which a curve stays close to its last value.
fn converged_after(curve: &Curve) -> Option<f64> {
    let last = curve.points.last()?[1];
    let away = curve.points.iter().rposition(|point| (point[1] - last).abs() > CONVERGED);
    Some(curve.points[away.map_or(0, |n| n + 1)][0])
}

/// "57", or that the curve was still on its way when it ended.
fn converged(curve: &Curve, passes: f64) -> String {
    let run = curve.points.len() as f64;
    if passes <= SETTLED_BEFORE * run {
        format!("{passes:.0}")
    } else {
        format!("more than {run:.0}")
    }
}

/// The acceleration against seeding density.
fn gain_panel(gains: &[Gain]) -> Option<Panel> {
    let points: Vec<[f64; 2]> =
        gains.iter().filter_map(|gain| Some([gain.ppm, gain.ratio?])).collect();
    let most = points.iter().map(|point| point[0]).reduce(f64::max)?;
    let paper = vec![[0.0, paper::ACCELERATION], [most, paper::ACCELERATION]];
    let chart = Chart {
        x: Axis::from_zero("particles per microlens"),
        y: Axis::from_zero("SART's time over OS-SART's at Q = 0.75"),
        series: vec![
            Series::new("acceleration", Style::Dots, points),
            Series::new("paper: at least 2", Style::Reference, paper),
        ],
    };
    Some(Panel::wide("Acceleration at Q = 0.75", chart.svg("acceleration against density")))
}

/// One chart per case and density.
fn panels(report: &Report, curves: &[&Curve], y: Axis, line: Option<f64>) -> Vec<Panel> {
    let mut keys: Vec<(&str, f64)> = Vec::new();
    for curve in curves {
        if !keys.contains(&(curve.case.as_str(), curve.ppm)) {
            keys.push((&curve.case, curve.ppm));
        }
    }
    keys.into_iter()
        .map(|(case, ppm)| {
            let here: Vec<&&Curve> =
                curves.iter().filter(|curve| curve.case == case && curve.ppm == ppm).collect();
            let longest = here.iter().map(|curve| curve.points.len()).max().unwrap_or(1) as f64;
            let mut series: Vec<Series> = here
                .iter()
                .map(|curve| Series::new(name(report, curve), Style::Line, curve.points.clone()))
                .collect();
            series.extend(line.map(|at| {
                Series::new(format!("{at}"), Style::Reference, vec![[1.0, at], [longest, at]])
            }));
            let row = report.record.rows.iter().find(|row| row.case == case);
            let voxels = row.map_or("", |row| row.voxels.as_str());
            let chart = Chart { x: Axis::log("iteration"), y: y.clone(), series };
            let title = format!("{case}: {voxels} voxels, {ppm} ppm");
            Panel::wide(title, chart.svg(&format!("{} against iterations", y.label)))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_has_converged_when_it_stays_near_its_end() {
        let points = [0.1, 0.5, 0.895, 0.7, 0.9, 0.905].into_iter().zip(1..);
        let curve = Curve {
            case: String::new(),
            method: String::new(),
            cameras: 2,
            ppm: 1.0,
            seed: 1,
            name: String::new(),
            points: points.map(|(q, n)| [f64::from(n), q]).collect(),
        };
        assert_eq!(converged_after(&curve), Some(5.0));
    }
}
