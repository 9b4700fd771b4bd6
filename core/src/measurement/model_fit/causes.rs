//! Assessment of the evidence: verdict and likely causes.
//!
//! Thresholds are in natural units: pixels of a micro-image, standard deviations of the light,
//! microlens pitches in the volume. `docs/model-fit.md` lists them with the values of correct and
//! wrong benches; for how they were fitted see docs/decisions.md, "Fitted constants".

use lfpiv_hw::CameraName;

use super::{agreement::Agreement, disparity::Disparity};
use crate::{lightfield::MicroImages, measurement::Measurement, reconstruction::FitVerdict};

/// Distance of micro-images from their configured positions, in pitches. Above the first threshold
/// they take light from wrong views, above the second from wrong microlenses.
const MISPLACED_PITCHES: f64 = 0.1;
const LOST_PITCHES: f64 = 0.2;

/// A shift this close to half a pitch, in pitches, indicates a wrong number of microlenses.
const HALF_PITCH_TOLERANCE: f64 = 0.12;

/// Residual relative to the light's standard deviation. Correct benches: 0.16 to 0.27; some hundred
/// particles on a few hundred microlenses with unmodelled diffraction: 0.36. So the first threshold
/// counts only together with other evidence.
const HIGH_UNEXPLAINED: f64 = 0.26;
const MORE_UNEXPLAINED: f64 = 0.4;
const MOST_UNEXPLAINED: f64 = 0.5;

/// With this share of saturated pixels, particle images are clipped: light stays unexplained on any
/// bench.
const CLIPPED_SHARE: f64 = 0.03;

/// Correlation of the cameras' light along the common direction. Correct benches: 0.95 to 0.99, and
/// from 0.86 with particles on voxel centres and without noise; a camera rotated by one degree:
/// 0.66 to 0.89; other shots: -0.5 to 0.5. With few bins random values scatter more, so it counts
/// alone only when it is low and over many bins. Below the usual values it counts if light stays
/// unexplained, too.
const USUAL_AGREEMENT: f64 = 0.85;
const LEAST_AGREEMENT: f64 = 0.5;
const PARTIAL_AGREEMENT: f64 = 0.75;
const CLEAR_AGREEMENT: f64 = 0.65;
const NO_AGREEMENT: f64 = 0.35;
const MANY_BINS: usize = 60;

/// Distance between the cameras' particle positions, in microlens pitches in the volume, and
/// relative to its noise. Correct benches: 0.03 to 0.18.
const FAR_APART_PITCHES: f64 = 0.22;
const FAR_APART_NOISE: f64 = 3.0;

/// Largest relative change of the object distance within the linear range. Beyond it, light that is
/// wider than modelled has the same effect if few particles are far from focus.
const MAX_DISTANCE_CHANGE: f64 = 0.03;

/// Above these a bench error is probable, if there is other evidence as well.
const PROBABLE_PITCHES: f64 = 0.3;
const PROBABLE_NOISE: f64 = 2.0;

/// A component with at least this share of the bench error is named.
const NAMED_SHARE: f64 = 0.4;

/// Share of windows with particles that give valid vectors.
const PARTLY_VALID: f64 = 0.85;
const MOST_VALID: f64 = 0.6;
const FEW_VALID: f64 = 0.3;
const HARDLY_VALID: f64 = 0.15;

/// The evidence about a pair's fit.
pub struct Evidence<'a> {
    pub measurement: &'a Measurement,
    /// Whether every camera sees light in both frames.
    pub lit: bool,
    /// Whether the residual depends on the bench.
    pub residual_counts: bool,
    /// Largest share of saturated pixels of any camera, among lit ones, 0 to 1.
    pub saturated_share: f64,
    pub micro_images: &'a [Option<MicroImages>],
    pub unexplained: Vec<f64>,
    pub agreement: Option<Agreement>,
    pub disparity: Option<Disparity>,
    /// Of the windows with particles, if there are enough of them.
    pub valid_share: Option<f64>,
}

impl Evidence<'_> {
    /// Whether a camera's residual is above `limit` and depends on the bench.
    fn is_unexplained(&self, limit: f64) -> bool {
        self.residual_counts && self.unexplained.iter().any(|&unexplained| unexplained > limit)
    }

    /// Whether the distance between the cameras' particle positions is significant.
    fn has_probable_bench_error(&self) -> bool {
        let pitch_mm = self.measurement.optics.object_pitch_mm();
        self.disparity.as_ref().is_some_and(|found| {
            found.rms_mm > (PROBABLE_PITCHES * pitch_mm).max(PROBABLE_NOISE * found.noise_mm)
                && !self.is_beyond_a_step(found)
        })
    }

    /// Whether a bench error is outside the linear range.
    fn is_beyond_a_step(&self, found: &Disparity) -> bool {
        found.parameters[6].abs() > MAX_DISTANCE_CHANGE * self.measurement.optics.object_distance_mm
    }
}

/// The verdict, which is the worst of all findings, and the likely causes in order. The causes are
/// those of the first finding, which explains later ones.
pub fn judge(evidence: &Evidence<'_>) -> (FitVerdict, Vec<String>) {
    let looks = [misplaced_micro_images, different_particles, apart, unexplained, no_vectors];
    let findings: Vec<Finding> = looks
        .iter()
        .map(|look| look(evidence))
        .filter(|(verdict, _)| *verdict != FitVerdict::Good)
        .collect();
    let worst = findings.iter().map(|(verdict, _)| *verdict).max().unwrap_or_default();
    (worst, findings.into_iter().next().map(|(_, causes)| causes).unwrap_or_default())
}

type Finding = (FitVerdict, Vec<String>);

fn good() -> Finding {
    (FitVerdict::Good, Vec::new())
}

/// Checks the micro-image positions. They determine the views, so this comes first.
fn misplaced_micro_images(evidence: &Evidence<'_>) -> Finding {
    let optics = &evidence.measurement.optics;
    let pitch_px = optics.micro_image_pitch_mm() / optics.pixel_pitch_mm();
    let (mut verdict, mut causes) = good();
    for (n, found) in evidence.micro_images.iter().enumerate() {
        let Some(found) = found else { continue };
        let worst = found.farthest_px[0].max(found.farthest_px[1]) / pitch_px;
        if worst <= MISPLACED_PITCHES {
            continue;
        }
        verdict = verdict.max(match worst > LOST_PITCHES {
            true => FitVerdict::Poor,
            false => FitVerdict::Doubtful,
        });
        causes.extend(micro_image_causes(evidence, CameraName(n), found, pitch_px));
    }
    if verdict == FitVerdict::Good && !evidence.lit {
        // The frames' own warnings name the dark camera.
        return (FitVerdict::Poor, Vec::new());
    }
    (verdict, causes)
}

fn micro_image_causes(
    evidence: &Evidence<'_>,
    camera: CameraName,
    found: &MicroImages,
    pitch_px: f64,
) -> Vec<String> {
    let optics = &evidence.measurement.optics;
    let lens = &optics.microlens;
    let half_px = [optics.sensor.columns, optics.sensor.rows].map(|pixels| pixels as f64 / 2.0);
    let mut ranked: Vec<(f64, String)> = Vec::new();
    for (axis, (name, count)) in
        [("columns", lens.columns), ("rows", lens.rows)].into_iter().enumerate()
    {
        let shift_px = found.offset_px[axis];
        let in_pitches = shift_px.abs() / pitch_px;
        if (in_pitches - 0.5).abs() < HALF_PITCH_TOLERANCE {
            ranked.push((
                shift_px.abs(),
                format!(
                    "{camera}: [optics.microlens] {name} = {count} is wrong by an odd number: \
                     the micro-images are half a pitch ({:.1} pixels) off",
                    shift_px.abs()
                ),
            ));
        } else {
            ranked.push((
                shift_px.abs(),
                format!(
                    "{camera}: the microlens array, or the sensor's window, is shifted by \
                     {shift_px:.1} pixels along the {name}"
                ),
            ));
        }
    }
    let excess = (found.pitch_excess[0] + found.pitch_excess[1]) / 2.0;
    ranked.push((
        excess.abs() * half_px[0],
        format!(
            "{camera}: [optics.microlens] pitch_mm = {} instead of {:.5} (or \
             [optics.sensor] pixel_pitch_um = {} instead of {:.4}): the micro-images' pitch is \
             {:+.2} % off",
            lens.pitch_mm,
            lens.pitch_mm * (1.0 + excess),
            optics.sensor.pixel_pitch_um,
            optics.sensor.pixel_pitch_um / (1.0 + excess),
            100.0 * excess
        ),
    ));
    let turned = (found.turned_rad[0] + found.turned_rad[1]) / 2.0;
    ranked.push((
        turned.abs() * half_px[0],
        format!(
            "{camera}: the microlens array is rotated by {:.2} degrees on the sensor",
            turned.to_degrees()
        ),
    ));
    ranked.sort_by(|a, b| b.0.total_cmp(&a.0));
    let least_px = MISPLACED_PITCHES * pitch_px / 2.0;
    let named = ranked.iter().filter(|(px, _)| *px > least_px).count().max(1);
    ranked.into_iter().take(named.min(2)).map(|(_, cause)| cause).collect()
}

const OTHER_SHOT: &str = "the images of cam1 and cam2 are from different shots: paired by hand, \
                          or not triggered together";
const WRONG_POSE: &str =
    "the pose of a [[camera]] differs from the configuration, or the cameras are exchanged";
const MIRRORED: &str = "cam2 (or cam1) is mirrored, or upside down: right, up and axis of its \
                        [[camera]] are not those of its images";
const MIRRORED_ACROSS: &str = "cam2 (or cam1) is mirrored along the direction that only it \
                               sees, or the cameras are exchanged";
const WRONG_OPTICS: &str =
    "[optics] does not match the cameras: object_distance_mm, focal_length_mm, f_number";
const THICK_SHEET: &str = "particles outside [volume] are lit: the light sheet is thicker";

/// Checks that both cameras saw the same particles.
fn different_particles(evidence: &Evidence<'_>) -> Finding {
    let Some(agreement) = &evidence.agreement else { return good() };
    let unexplained = evidence.is_unexplained(HIGH_UNEXPLAINED);
    let alone = agreement.direct < NO_AGREEMENT && agreement.bins >= MANY_BINS;
    // Dense particles correlate by chance. A slightly wrong pose also reduces the agreement, but
    // the disparity measures by how much.
    let unclear = agreement.direct < PARTIAL_AGREEMENT
        && evidence.valid_share.is_some_and(|share| share < PARTLY_VALID)
        && !evidence.has_probable_bench_error();
    let verdict = match unexplained {
        true if agreement.direct < LEAST_AGREEMENT => FitVerdict::Poor,
        _ if alone => FitVerdict::Doubtful,
        true if unclear => FitVerdict::Doubtful,
        _ => return good(),
    };
    let mut causes = Vec::new();
    if agreement.mirrored >= LEAST_AGREEMENT {
        causes.extend([MIRRORED, OTHER_SHOT, WRONG_POSE].map(str::to_owned));
    } else if agreement.best >= CLEAR_AGREEMENT {
        causes.push(format!(
            "cam2 is {:.2} mm from its configured position along the direction that both \
             cameras see",
            agreement.best_shift_mm
        ));
        causes.extend([WRONG_POSE, OTHER_SHOT].map(str::to_owned));
    } else {
        causes.extend([OTHER_SHOT, WRONG_POSE, MIRRORED].map(str::to_owned));
    }
    (verdict, causes)
}

/// Checks that both cameras place the particles at the same positions.
fn apart(evidence: &Evidence<'_>) -> Finding {
    let Some(found) = &evidence.disparity else { return good() };
    let pitch_mm = evidence.measurement.optics.object_pitch_mm();
    let far_mm = (FAR_APART_PITCHES * pitch_mm).max(FAR_APART_NOISE * found.noise_mm);
    let probable = evidence.has_probable_bench_error() && evidence.is_unexplained(HIGH_UNEXPLAINED);
    if found.rms_mm < far_mm && !probable
        || evidence.is_beyond_a_step(found)
        || evidence.is_unexplained(MOST_UNEXPLAINED)
    {
        return good();
    }
    (FitVerdict::Doubtful, bench_error_causes(evidence.measurement, found))
}

/// The components of a bench error as text, the largest first.
fn bench_error_causes(measurement: &Measurement, found: &Disparity) -> Vec<String> {
    let p = &found.parameters;
    let origin = measurement.cameras[1].origin_mm;
    let shift = format!(
        "cam2 is {:.2} mm from its configured position, as cam1 sees it: origin_mm = \
         [{:.2}, {:.2}, {:.2}] would fit",
        p[0].hypot(p[1]).hypot(p[2]),
        origin[0] + p[0],
        origin[1] + p[1],
        origin[2] + p[2]
    );
    let rotation = format!(
        "cam2 is rotated by {:.2}, {:.2}, {:.2} degrees about x, y, z from its configured \
         directions, as cam1 sees it",
        p[3].to_degrees(),
        p[4].to_degrees(),
        p[5].to_degrees()
    );
    let distance = format!(
        "[optics] object_distance_mm = {} is wrong: {:.1} would fit (or focal_length_mm, or the \
         magnification)",
        measurement.optics.object_distance_mm,
        measurement.optics.object_distance_mm + p[6]
    );
    let mut ranked: Vec<(f64, String)> =
        found.parts_mm.into_iter().zip([shift, rotation, distance]).collect();
    ranked.sort_by(|a, b| b.0.total_cmp(&a.0));
    let named = ranked.iter().filter(|(part, _)| *part > NAMED_SHARE * found.rms_mm).count().max(1);
    ranked.into_iter().take(named).map(|(_, cause)| cause).collect()
}

/// Checks for unexplained light while micro-images and common profiles are consistent.
fn unexplained(evidence: &Evidence<'_>) -> Finding {
    let doubted = evidence.is_unexplained(MORE_UNEXPLAINED)
        || evidence.is_unexplained(HIGH_UNEXPLAINED) && has_other_evidence(evidence);
    if !doubted {
        return good();
    }
    let flattened = evidence.saturated_share > CLIPPED_SHARE;
    // Light that is not explained and windows without vectors come from different faults on a correct bench.
    let both_fail = evidence.valid_share.is_some_and(|share| share < FEW_VALID);
    let is_poor = evidence.is_unexplained(MOST_UNEXPLAINED) || both_fail;
    let verdict = match is_poor && !flattened {
        true => FitVerdict::Poor,
        false => FitVerdict::Doubtful,
    };
    let saturated = flattened.then(|| {
        let percent = 100.0 * evidence.saturated_share;
        format!(
            "{percent:.0} % of the lit pixels are saturated, which clips the images of \
             particles: reduce gain or laser energy"
        )
    });
    let causes: &[&str] = match &evidence.agreement {
        None => &[WRONG_OPTICS, WRONG_POSE, THICK_SHEET],
        Some(agreement) if agreement.direct < CLEAR_AGREEMENT => {
            &[OTHER_SHOT, MIRRORED_ACROSS, WRONG_POSE, WRONG_OPTICS, THICK_SHEET]
        }
        Some(agreement) if agreement.direct < USUAL_AGREEMENT => {
            &[WRONG_POSE, THICK_SHEET, WRONG_OPTICS, MIRRORED_ACROSS]
        }
        Some(_) => &[MIRRORED_ACROSS, WRONG_POSE, WRONG_OPTICS, THICK_SHEET],
    };
    // A significant bench error is more likely than any of these.
    let fitted = evidence.disparity.as_ref().filter(|_| evidence.has_probable_bench_error());
    let fitted = fitted.map(|found| bench_error_causes(evidence.measurement, found));
    let others = causes.iter().map(|&cause| cause.to_owned());
    (
        verdict,
        saturated
            .into_iter()
            .chain(fitted.filter(|_| verdict == FitVerdict::Doubtful).into_iter().flatten().take(1))
            .chain(others)
            .collect(),
    )
}

/// Whether vectors are missing, or the cameras agree less than on a correct bench.
fn has_other_evidence(evidence: &Evidence<'_>) -> bool {
    let disagree = |agreement: &Agreement| agreement.direct < USUAL_AGREEMENT;
    evidence.valid_share.is_some_and(|share| share < MOST_VALID)
        || evidence.agreement.as_ref().is_some_and(disagree)
}

/// Checks that windows with particles give vectors.
fn no_vectors(evidence: &Evidence<'_>) -> Finding {
    let Some(valid_share) = evidence.valid_share else { return good() };
    if valid_share >= FEW_VALID {
        return good();
    }
    let verdict = match valid_share < HARDLY_VALID {
        true => FitVerdict::Poor,
        false => FitVerdict::Doubtful,
    };
    let most_vox = evidence.measurement.velocimetry.max_displacement_vox;
    let causes = vec![
        "frames a and b are from different shots, or from different cameras".to_owned(),
        format!(
            "particles move further than max_displacement_vox = {most_vox}: shorten [shot] dt_us \
             or raise it"
        ),
        "particles leave the light sheet between the pulses".to_owned(),
    ];
    (verdict, causes)
}
