//! A bench that is not as drawn: cameras beside their poses, light that differs, particles lit outside
//! of the volume, diffraction; and what a calibration makes of one.

use crate::{
    Figure, Row,
    report::{
        Report,
        section::{Compared, Section},
        tables::{mean, mean_error, mean_of_components, mean_true_followed},
        text::number,
    },
};

/// A bench with faults that the reconstruction does not know.
pub fn imperfect_bench(report: &Report) -> Option<Section> {
    let compared = beside_the_first(report, Figure::ImperfectBench)?;
    Some(Section {
        id: "imperfect",
        title: "A bench that is not as drawn",
        caption: "Images of a bench with faults that the reconstruction does not know, alone and \
                  together: bench/report.toml says what each case has. Errors are means of |error| \
                  over all vectors, valid or not; in brackets, over those of the bench as drawn. \
                  Coverage is of valid vectors: 68 and 95 % lie within the stated intervals where \
                  uncertainties are right. The paper's bench has no faults."
            .to_owned(),
        compared,
        ..Section::default()
    })
}

/// The bench of config/imperfect.toml, by the calibration that the reconstruction is given.
pub fn calibration(report: &Report) -> Option<Section> {
    let compared = beside_the_first(report, Figure::Calibration)?;
    Some(Section {
        id: "calibration",
        title: "A bench that is not as drawn, calibrated",
        caption: "Arrays turned and of another pitch, distorting lenses with their stops beside them, camera 2 \
                  two voxels and 0.2 degrees beside its pose, another gain, water behind tilted walls: with \
                  the true map, with what `lfpiv calibrate` finds in simulated white, dark and card images, \
                  and with steps left out, which must give no valid vector."
            .to_owned(),
        compared,
        ..Section::default()
    })
}

/// Error, valid vectors and coverage of a figure's cases, beside the first: means over the seeds.
fn beside_the_first(report: &Report, figure: Figure) -> Option<Vec<Compared>> {
    let rows = report.shown_in(figure);
    let first = rows.first()?;
    let mut cases: Vec<(&str, f64)> = Vec::new();
    for row in &rows {
        if !cases.contains(&(row.case.as_str(), row.ppm)) {
            cases.push((&row.case, row.ppm));
        }
    }
    let of = |case: &str, ppm: f64| -> Vec<&Row> {
        rows.iter().copied().filter(|row| row.case == case && row.ppm == ppm).collect()
    };
    let compared: Vec<Compared> = cases
        .iter()
        .filter_map(|&(case, ppm)| line(&of(case, ppm), &of(&first.case, ppm)))
        .collect();
    (!compared.is_empty()).then_some(compared)
}

fn line(rows: &[&Row], drawn: &[&Row]) -> Option<Compared> {
    let row = rows.first()?;
    let percent = |share: Option<f64>| Some(number(100.0 * share?));
    let ours = format!(
        "{} voxel along x, y, z (× {}; true particles, tracked: {} in the mean), {} % valid, {} \
         and {} % covered",
        mean_of_components(rows, Row::error_vox)?.map(number).join(", "),
        number(mean(rows, mean_error)? / mean(drawn, mean_error)?),
        mean(rows, mean_true_followed).map_or_else(|| "–".to_owned(), number),
        percent(mean(rows, |row| row.valid_share))?,
        percent(mean(rows, |row| row.covered_68))?,
        percent(mean(rows, |row| row.covered_95))?,
    );
    Some(Compared::new(format!("{}: {} ppm, {} seeds", row.case, row.ppm, rows.len()), "", ours))
}
