//! What each part of the forward model costs and buys.

use crate::{
    Figure, Row,
    report::{
        Report,
        section::{Compared, Section},
        tables::mean_error,
        text::number,
    },
};

/// Error and seconds of every case, beside those of the first at the same seeding and seed.
pub fn model_parts(report: &Report) -> Option<Section> {
    let rows = report.shown_in(Figure::ModelParts);
    let first = rows.first()?;
    let of_first = |row: &&&Row| row.case == first.case;
    let compared: Vec<Compared> = rows
        .iter()
        .filter_map(|row| {
            let same = |other: &&&Row| other.ppm == row.ppm && other.seed == row.seed;
            line(row, rows.iter().filter(of_first).find(same)?)
        })
        .collect();
    (!compared.is_empty()).then(|| Section {
        id: "model-parts",
        title: "What each part of the model costs and buys",
        caption: "The same pairs with parts of the forward model forced on or off. In brackets, \
                  error and reconstruction time over those of the first case, which has every part \
                  that its configuration allows. The paper has one model."
            .to_owned(),
        compared,
        ..Section::default()
    })
}

fn line(row: &Row, first: &Row) -> Option<Compared> {
    let (error, seconds) = (mean_error(row)?, row.reconstruct_s?);
    let what = format!("{}: {} ppm, seed {}", row.case, row.ppm, row.seed);
    let ours = format!(
        "mean error {} voxel (× {}), reconstruction {} s (× {})",
        number(error),
        number(error / mean_error(first)?),
        number(seconds),
        number(seconds / first.reconstruct_s?)
    );
    Some(Compared::new(what, "", ours))
}
