//! A bench that is not as drawn: cameras beside their poses, light that differs, particles lit outside
//! of the volume, diffraction.

use crate::{
    Figure, Row,
    report::{
        Report,
        section::{Compared, Section},
        tables::{mean, mean_error, mean_of_components, mean_true_followed},
        text::number,
    },
};

/// Error, valid vectors and coverage of every case, beside the first: means over the seeds.
pub fn imperfect_bench(report: &Report) -> Option<Section> {
    let rows = report.shown_in(Figure::ImperfectBench);
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
    (!compared.is_empty()).then(|| Section {
        id: "imperfect",
        title: "A bench that is not as drawn",
        caption: "Images of a bench with faults that the reconstruction is not told of, alone and \
                  together: bench/report.toml says what each case has. Errors are means of |error| \
                  over all vectors, valid or not; in brackets, over those of the bench as drawn. \
                  Coverage is of valid vectors: 68 and 95 % lie within the stated intervals where \
                  uncertainties are right. The paper's bench has no faults."
            .to_owned(),
        compared,
        ..Section::default()
    })
}

fn line(rows: &[&Row], drawn: &[&Row]) -> Option<Compared> {
    let row = rows.first()?;
    let percent = |share: Option<f64>| Some(number(100.0 * share?));
    let ours = format!(
        "{} voxel along x, y, z (× {}; true particles, followed: {} in the mean), {} % valid, {} \
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
