//! Columns of the page's tables of rows.

use super::{
    Report,
    text::{number, round_number},
};
use crate::Row;

/// A heading, and what a row has to say under it.
pub type Column = (&'static str, fn(&Report, &Row) -> String);

/// The columns of the page; the CSV file has all there are.
pub const COLUMNS: [Column; 22] = [
    ("case", |_, row| row.case.clone()),
    ("method", |report, row| report.label(row)),
    ("ppm", |_, row| known(row.ppm)),
    ("cameras", |_, row| known(row.cameras as f64)),
    ("voxels", |_, row| row.voxels.clone()),
    ("seed", |_, row| row.seed.to_string()),
    ("seconds", |_, row| value(row.seconds)),
    ("CPU / s", |_, row| value(row.cpu_s)),
    ("× kernel", |_, row| value(row.kernel_ratio)),
    ("Q", |_, row| value(row.q)),
    ("error x, y, z / voxel", |_, row| three(row.error_vox())),
    ("true particles, windows only", |_, row| three(row.true_windows_vox())),
    ("true particles, tracked", |_, row| three(row.true_followed_vox())),
    ("valid / %", |_, row| value(row.valid_share.map(|share| 100.0 * share))),
    ("particles found, false / %", |_, row| two(row.particles_found, row.particles_false, 100.0)),
    ("particles: median, mean error / voxel", |_, row| {
        two(row.particles_median_error_vox, row.particles_mean_error_vox, 1.0)
    }),
    ("FWHM / mm", |_, row| value(row.fwhm_mm)),
    ("peak / MB", |_, row| value(row.peak_mb)),
    ("threads", |_, row| row.threads.to_string()),
    ("machine", |_, row| row.machine.clone()),
    ("version", |_, row| row.version.clone()),
    ("date", |_, row| row.date.clone()),
];

/// Peers' rows do not say everything.
fn known(figure: f64) -> String {
    if figure > 0.0 { round_number(figure) } else { String::new() }
}

fn value(figure: Option<f64>) -> String {
    figure.map_or_else(String::new, number)
}

fn two(one: Option<f64>, other: Option<f64>, unit: f64) -> String {
    let figures = one.zip(other).map(|(one, other)| [one, other].map(|f| number(unit * f)));
    figures.map_or_else(String::new, |figures| figures.join(" "))
}

fn three(figures: Option<[f64; 3]>) -> String {
    figures.map_or_else(String::new, |figures| figures.map(number).join(" "))
}
