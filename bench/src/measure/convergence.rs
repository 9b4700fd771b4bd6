//! Q and ε after every pass (paper, Figs. 4 and 13).
//!
//! The solvers over the whole volume are watched pass by pass; any other method gives one row, as a
//! [volume](super::volume) measurement does. Time is that of the passes alone: neither the residual
//! nor the comparison with the truth counts.

use lfpiv::pipeline::monotonic;
use lfpiv_core::{
    model::thin_lens_model,
    reconstruction::{
        ConvergenceLog, Domain, Footprint, ReconstructionSettings, Reconstructor, SartOptions,
        Solver, pr_sart, sart, subsets::balanced_subsets,
    },
};

use super::{Findings, Surroundings, volume};
use crate::{
    BenchmarkError, Curve, Method,
    case::Setting,
    truth::{Frame, reconstructor, true_volume},
};

/// Reconstructs frame a of every seed's shot with every method, pass by pass.
pub(super) fn measure(
    setting: &Setting,
    methods: &[Option<&Method>],
    surroundings: &mut Surroundings,
    findings: &mut Findings,
) -> Result<(), BenchmarkError> {
    for &method in methods {
        let config = setting.config_with(method);
        let settings = &config.reconstruction;
        let Some(passes) = watched_passes(settings) else {
            volume::measure(setting, &[method], surroundings, findings)?;
            continue;
        };
        let reconstructor = reconstructor(&config)?;
        let options = options(settings, &reconstructor, passes);
        let footprint_mm = match settings.footprint {
            Footprint::Voxel => config.volume.voxel_mm,
            Footprint::Auto | Footprint::Point => 0.0,
        };
        let model =
            thin_lens_model(&config.optics, &config.poses(), &config.volume.grid(), footprint_mm)?;
        for &seed in &setting.case.seeds {
            let truth = setting.scene.truth(&setting.bench, seed, 0);
            let frame = Frame::simulate(setting, &truth, &reconstructor);
            let expected = true_volume(setting, &truth, &config.volume.grid());
            let mut log = ConvergenceLog::with_truth(expected.clone());
            let mut observe = |report: &_, volume: &_| log.record(report, volume);
            let solved = if settings.solver == Solver::PrSart {
                let dark: Vec<f32> = frame.levels.iter().map(|l| l.dark_below()).collect();
                pr_sart(model.as_ref(), &frame.views, &dark, &options, &mut observe)
            } else {
                let voxels = (0..config.volume.grid().len() as u32).collect();
                sart(model.as_ref(), &frame.views, voxels, &options, &mut observe)
            };
            let mut row = setting.row(method, seed);
            row.seconds = Some(log.seconds());
            row.seconds_of = "all passes of the solver on one frame".to_owned();
            row.iterations = Some(log.passes.len());
            volume::fill(&mut row, &solved.on_grid(&config.volume.grid()), &expected);
            let dark: f64 = expected.intensity.iter().map(|&e| f64::from(e).powi(2)).sum();
            findings.curves.extend(
                curves(&log, dark.sqrt()).map(|(name, points)| Curve::of(&row, name, points)),
            );
            findings.add(row, surroundings);
        }
    }
    Ok(())
}

/// Passes of a solver that can be watched.
fn watched_passes(settings: &ReconstructionSettings) -> Option<usize> {
    match settings.solver {
        Solver::Sart | Solver::OsSart | Solver::PrSart if settings.domain == Domain::Volume => {
            settings.passes
        }
        _ => None,
    }
}

fn options(
    settings: &ReconstructionSettings,
    reconstructor: &Reconstructor,
    passes: usize,
) -> SartOptions {
    let cameras = reconstructor.layouts().len().max(1);
    SartOptions {
        relaxation: settings.relaxation.unwrap_or(1.0) as f32,
        passes,
        subsets: balanced_subsets(
            reconstructor.layouts(),
            reconstructor.subsets_per_pass() / cameras,
        ),
        clock: monotonic,
    }
}

fn curves(log: &ConvergenceLog, dark: f64) -> impl Iterator<Item = (&'static str, Vec<[f64; 2]>)> {
    let points = |figure: &dyn Fn(usize) -> Option<f64>| -> Vec<[f64; 2]> {
        let point = |n| Some([(n + 1) as f64, figure(n)?]);
        (0..log.passes.len()).filter_map(point).collect()
    };
    let mut elapsed = 0.0;
    let seconds: Vec<f64> = log
        .passes
        .iter()
        .map(|point| {
            elapsed += point.report.seconds;
            elapsed
        })
        .collect();
    [
        ("q(iteration)", points(&|n| log.passes[n].quality)),
        ("relative_error(iteration)", points(&|n| Some(log.passes[n].error? / dark))),
        ("seconds(iteration)", points(&|n| seconds.get(n).copied())),
    ]
    .into_iter()
}
