//! How well marks are foretold where the card was not: what a calibration is worth.

use rayon::prelude::*;
use serde::Serialize;

use super::{
    VolumeError,
    adjustment::{Adjusted, Bench, Sighting},
};

/// How well marks are foretold at positions that the fit did not know: root mean squares of one
/// coordinate, in microlenses.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct HeldOut {
    /// Of a mark's mean over all views.
    pub mean_microlenses: f64,
    /// Of a mark in a single view.
    pub view_microlenses: f64,
    /// Marks that were foretold.
    pub marks: usize,
}

/// Leaves out one position after the other, but not the first and the last: nobody measures beyond the
/// card. Where the stage is uncertain, the card's place there is found from its marks; their places on the
/// card, and both cameras, then tell how well they are foretold.
pub(super) fn held_out(
    bench: &Bench<'_>,
    sightings: &[Sighting],
    all: &Adjusted,
) -> Result<HeldOut, VolumeError> {
    let inner: Vec<usize> = (1..bench.origins_mm.len() - 1).collect();
    let sums: Vec<[f64; 3]> = inner
        .into_par_iter()
        .map(|position| {
            let (here, others): (Vec<Sighting>, Vec<Sighting>) =
                sightings.iter().cloned().partition(|sighting| sighting.position == position);
            let adjusted = bench.adjust(&others, Some(all))?;
            // An uncertain stage is not the cameras' fault.
            let stage_mm = bench.place_card(&here, &adjusted, position)?;
            let mut sums = [0.0; 3];
            for sighting in &here {
                for (mark, off) in bench.differences(sighting, &adjusted, &stage_mm) {
                    // Over a disc of radius R the mean square of either coordinate is R²/4.
                    let radius_mm = bench.optics.pupil_diameter_mm() / 2.0;
                    let mean: f64 = off[0].iter().map(|mm| mm * mm).sum();
                    let leaning: f64 =
                        off[1].iter().map(|slope| (slope * radius_mm).powi(2) / 4.0).sum();
                    sums[0] += mean;
                    sums[1] += mean + leaning + 2.0 * mark.views_rms_mm * mark.views_rms_mm;
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
