//! Four images to vectors: error beside that of the true particles, seconds by stage.

use lfpiv::pipeline::monotonic;
use lfpiv_core::{
    lightfield::ImagePair,
    measurement::{Measurement, Processor},
    model::CameraCalibration,
    velocimetry::{PairResult, VelocityField},
};
use lfpiv_sim::{FrameOfPair, Truth};

use super::{Findings, Surroundings};
use crate::{
    BenchmarkError, Calibration, Curve, Figure, MeasuredField, Method, Row,
    between::{error_between_vox, gain},
    case::Setting,
    score::{KnownFlow, Score, true_field},
    true_calibration::true_calibrations,
    truth::true_cloud,
};

/// The images of a seed, and what is behind them.
pub(super) struct Shot {
    pub seed: u64,
    pub pair: ImagePair,
    pub truth: Truth,
}

/// What a method made of a shot.
pub(super) struct Measured<'a> {
    pub row: Row,
    pub field: VelocityField,
    /// What its vectors stand for.
    truth: KnownFlow<'a>,
    score: Score,
}

/// Measures every seed's shot with every method.
pub(super) fn measure(
    setting: &Setting,
    methods: &[Option<&Method>],
    surroundings: &mut Surroundings,
    findings: &mut Findings,
) -> Result<(), BenchmarkError> {
    let calibrations = calibrations(setting, surroundings)?;
    let processors = methods
        .iter()
        .map(|&method| {
            let measurement = Measurement {
                calibrations: calibrations.clone(),
                ..setting.config_with(method).measurement()
            };
            Ok((method, Processor::timed(measurement, monotonic)?))
        })
        .collect::<Result<Vec<_>, BenchmarkError>>()?;
    for &seed in &setting.case.seeds {
        let shot = simulated(setting, seed);
        for (method, processor) in &processors {
            let measured = measured(setting, *method, processor, &shot)?;
            keep_field(setting, &measured, findings);
            add(measured, surroundings, findings);
        }
    }
    Ok(())
}

/// The calibrations that the reconstruction is given.
pub(super) fn calibrations(
    setting: &Setting,
    surroundings: &mut Surroundings,
) -> Result<Vec<CameraCalibration>, BenchmarkError> {
    let Surroundings { program, work, calibrated, .. } = surroundings;
    let mut by_commands = |card| calibrated.found(setting, program, work, card);
    match setting.case.calibration {
        Calibration::None => Ok(Vec::new()),
        Calibration::TrueMap => Ok(true_calibrations(setting)),
        Calibration::GridAlone => by_commands(None),
        Calibration::Commands => match &setting.card {
            Some(card) => by_commands(Some(card)),
            None => Err(BenchmarkError::NoCard { case: setting.case.name.clone() }),
        },
    }
}

/// A seed's shot.
pub(super) fn simulated(setting: &Setting, seed: u64) -> Shot {
    let shot = setting.scene.shot(&setting.bench, seed, 0);
    Shot { seed, pair: ImagePair { cameras: shot.images }, truth: shot.truth }
}

/// Measures a shot, and its true particles by the same windows.
pub(super) fn measured<'a>(
    setting: &'a Setting,
    method: Option<&Method>,
    processor: &Processor,
    shot: &Shot,
) -> Result<Measured<'a>, BenchmarkError> {
    let (windows, flow) = (processor.interrogation(), &setting.scene.flow);
    let [a, b] =
        [FrameOfPair::A, FrameOfPair::B].map(|frame| true_cloud(&shot.truth, frame, windows));
    let dt_s = shot.truth.dt_s;
    let by_windows =
        Score::of(&windows.measure_by_windows(&a, &b, dt_s), KnownFlow::InTheMiddle(flow));
    let result = processor.process(&shot.pair)?;
    let truth = truth_of(setting, &result);
    let score = Score::of(&result.field, truth);
    let mut row = setting.row(method, shot.seed);
    fill(&mut row, &result, &score);
    if let Some(errors_vox) = error_between_vox(&result.field, truth) {
        row.set_unseen(errors_vox);
    }
    let volume = &setting.bench.volume;
    row.gain = setting
        .wave()
        .and_then(|wave| gain(&result.field, wave, volume.centre_mm, volume.extents_mm()));
    row.set_true_windows(by_windows.mean_vox);
    if setting.config.velocimetry.follow_particles {
        let followed = Score::of(&windows.measure(&a, &b, dt_s), KnownFlow::InTheMiddle(flow));
        row.set_true_followed(followed.mean_vox);
    }
    Ok(Measured { row, field: result.field, truth, score })
}

/// What a result's vectors stand for.
fn truth_of<'a>(setting: &'a Setting<'_>, result: &PairResult) -> KnownFlow<'a> {
    match result.particles {
        Some(_) => KnownFlow::OnAverage(&setting.scene.flow),
        None => KnownFlow::InTheMiddle(&setting.scene.flow),
    }
}

/// Adds the row and the distributions of its errors.
pub(super) fn add(measured: Measured, surroundings: &mut Surroundings, findings: &mut Findings) {
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let name = format!("cdf_{name}(error_vox)");
        let points = measured.score.distribution(axis);
        findings.curves.push(Curve::of(&measured.row, name, points));
    }
    findings.add(measured.row, surroundings);
}

/// Keeps the first seed's field where a figure shows it, and the true one once beside it.
fn keep_field(setting: &Setting, measured: &Measured, findings: &mut Findings) {
    let row = &measured.row;
    if row.seed != setting.case.seeds[0] || !setting.case.figures.contains(&Figure::Vortex) {
        return;
    }
    let kept = |method: Option<String>, field: VelocityField| MeasuredField {
        case: row.case.clone(),
        method,
        cameras: row.cameras,
        ppm: row.ppm,
        field,
    };
    if !findings.fields.iter().any(|field| field.case == row.case && field.ppm == row.ppm) {
        findings.fields.push(kept(None, true_field(&measured.field, measured.truth)));
    }
    findings.fields.push(kept(Some(row.method.clone()), measured.field.clone()));
}

fn fill(row: &mut Row, result: &PairResult, score: &Score) {
    let seconds = &result.seconds;
    row.decode_s = Some(seconds.decode_s);
    row.reconstruct_s = Some(seconds.reconstruct_s);
    row.correlate_s = Some(seconds.correlate_s);
    row.judge_s = Some(seconds.judge_s);
    row.seconds = Some(seconds.total_s());
    row.seconds_of = "one pair in a running program: decode, reconstruct, correlate".to_owned();
    row.vectors = Some(result.field.grid.len());
    row.valid_share = Some(result.field.valid_share());
    row.set_error(score.mean_vox);
    row.set_within(score.within);
    (row.covered_68, row.covered_95) = (Some(score.covered[0]), Some(score.covered[1]));
}
