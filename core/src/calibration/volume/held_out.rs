//! Cross-validation: prediction errors of marks at positions that are left out of the fit.

use rayon::prelude::*;
use serde::Serialize;

use super::{
    VolumeError,
    adjustment::{Adjusted, Bench, Observation},
};

/// Root-mean-square prediction errors of one coordinate of marks at left-out positions, in microlenses.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct HeldOut {
    /// Error of a mark's mean over all views.
    pub mean_microlenses: f64,
    /// Error of a mark in a single view.
    pub view_microlenses: f64,
    /// Number of predicted marks.
    pub marks: usize,
}

/// Leave-one-out cross-validation over the positions. The first and the last are not left out, because the result
/// would be an extrapolation. For an uncertain stage, the card's position is first fitted to its marks.
///
/// # Errors
/// As [`Bench::adjust`].
pub(super) fn held_out(
    bench: &Bench<'_>,
    observations: &[Observation],
    all: &Adjusted,
) -> Result<HeldOut, VolumeError> {
    let inner: Vec<usize> = (1..bench.origins_mm.len() - 1).collect();
    let sums: Vec<[f64; 3]> = inner
        .into_par_iter()
        .map(|position| {
            let (here, others): (Vec<Observation>, Vec<Observation>) = observations
                .iter()
                .cloned()
                .partition(|observation| observation.position == position);
            let adjusted = bench.adjust(&others, Some(all))?;
            // The residuals must not contain the error of the stage.
            let stage_mm = bench.fit_stage(&here, &adjusted, position)?;
            let mut sums = [0.0; 3];
            for observation in &here {
                for (mark, off) in bench.differences(observation, &adjusted, &stage_mm) {
                    // The mean square of a coordinate over a disc of radius R is R²/4.
                    let radius_mm = bench.optics.pupil_diameter_mm() / 2.0;
                    let mean: f64 = off[0].iter().map(|mm| mm * mm).sum();
                    let parallax: f64 =
                        off[1].iter().map(|slope| (slope * radius_mm).powi(2) / 4.0).sum();
                    sums[0] += mean;
                    sums[1] += mean + parallax + 2.0 * mark.views_rms_mm * mark.views_rms_mm;
                    sums[2] += 1.0;
                }
            }
            Ok(sums)
        })
        .collect::<Result<_, VolumeError>>()?;
    let [mean, view, marks] =
        sums.iter().fold([0.0; 3], |sum, part| std::array::from_fn(|n| sum[n] + part[n]));
    let pitch_mm = bench.optics.microlens.pitch_mm;
    let rms = |squares: f64| (squares / (2.0 * marks.max(1.0))).sqrt() / pitch_mm;
    Ok(HeldOut { mean_microlenses: rms(mean), view_microlenses: rms(view), marks: marks as usize })
}
