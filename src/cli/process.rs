//! `lfpiv process`: velocity from recorded or imported image pairs.

use std::{
    collections::HashMap,
    path::{Path, PathBuf},
};

use anyhow::{Context, bail};
use indicatif::ProgressBar;
use lfpiv_core::{
    lightfield::{Background, ImagePair},
    measurement::Processor,
    model::ModelMode,
    reconstruction::Solver,
    velocimetry::PairResult,
};
use tokio::runtime::Runtime;
use tokio_util::sync::CancellationToken;

use super::{
    output::{count, print, progress_bar},
    process_cluster::{ClusterArgs, process_cluster},
    process_jobs::{Existing, Job, jobs, settle_existing},
    process_parts::{Part, merge_parts, process_part},
    process_run::{is_run, process_run},
    run_processor::{background_images, warn_of_nominal_poses},
    solver::{solver_by_name, solver_name},
    stop::stop_on_signals,
};
use crate::{
    acquisition::SynchroniserThread,
    archive::{
        ArchiveError, FileSeries, ShotResult, VtiSource, read_pair, write_particles,
        write_velocity, write_volumes, write_vti, write_vtp,
    },
    config::{Config, ConfigFile},
    pipeline::monotonic,
};

/// Arguments of `lfpiv process`.
#[derive(Debug, clap::Args)]
pub struct ProcessArgs {
    /// Configuration file (TOML) of the bench that took the images; a recorded run has its own.
    #[arg(long, value_name = "FILE")]
    pub config: Option<PathBuf>,
    /// Folder for the results: one folder per pair, named like the pair's folder. Results of a
    /// recorded run go into the run's folder.
    #[arg(long, value_name = "OUT")]
    pub out: Option<PathBuf>,
    /// Also write the reconstructed volumes.
    #[arg(long)]
    pub save_volumes: bool,
    /// Measure only the pairs without results in OUT.
    #[arg(long, conflicts_with = "overwrite")]
    pub resume: bool,
    /// Remove existing results of the pairs in OUT, and measure all pairs.
    #[arg(long)]
    pub overwrite: bool,
    /// Solver to use instead of the configured one.
    #[arg(long, value_name = "NAME", value_parser = solver_by_name)]
    pub solver: Option<Solver>,
    /// Measure one part of the shots without a result of a recorded run, K from 1 to N, into the folder
    /// OUT; the run is only read. For several machines.
    #[arg(long, value_name = "K/N", requires = "out", conflicts_with = "merge")]
    pub part: Option<Part>,
    /// Merge the results of all parts into the recorded run, after checking that each shot is in exactly
    /// one part. Arguments: the folders of the parts; default: RUN/parts/*.
    #[arg(long, value_name = "PART", num_args = 0..)]
    pub merge: Option<Vec<PathBuf>>,
    #[command(flatten)]
    pub cluster: ClusterArgs,
    /// Pair folders, folders of pair folders, or the folder of one recorded run, whose unmeasured
    /// shots are measured.
    #[arg(required = true, value_name = "DIR")]
    pub folders: Vec<PathBuf>,
}

impl ProcessArgs {
    fn existing(&self) -> Existing {
        match (self.resume, self.overwrite) {
            (true, _) => Existing::Keep,
            (_, true) => Existing::Replace,
            _ => Existing::Refuse,
        }
    }
}

/// Name of a pair's result for ParaView.
const VTI: &str = "velocity.vti";

/// Smallest number of pairs for estimating the background. With fewer, it would include particles.
const LEAST_BACKGROUND_PAIRS: usize = 3;

/// Measures every pair; a failing pair is reported and the others are still measured. When
/// interrupted, it ends after the current pair.
pub fn process(args: &ProcessArgs) -> anyhow::Result<()> {
    let (_signals, stop) = stop_between_shots()?;
    if let [folder] = args.folders.as_slice()
        && is_run(folder)
    {
        return process_recorded(folder, args, &stop);
    }
    if args.part.is_some() || args.merge.is_some() || args.cluster.cluster.is_some() {
        bail!(
            "--part, --merge and --cluster are for the folder of one recorded run: it has a folder raw"
        )
    }
    let (Some(config), Some(out)) = (&args.config, &args.out) else {
        bail!(
            "image pairs need --config FILE and --out OUT; only the folder of one recorded run \
             (which has a folder raw) does not need them"
        )
    };
    let file = configuration(args, config)?;
    warn_of_nominal_poses(&file.config);
    let (mut jobs, mut failures) = jobs(&args.folders, out);
    settle_existing(&mut jobs, args.existing(), &file.text, args.save_volumes)?;
    let (mut run, mut read_already) = Run::prepare(args, file, &jobs)?;
    run.learn_background(&jobs)?;
    run.choose_model_again(&jobs);
    for failure in &failures {
        tracing::error!("{failure}");
    }
    let bar = progress_bar(jobs.iter().filter(|job| !job.is_done).count(), "pairs");
    let names: HashMap<u64, &str> = jobs.iter().map(|job| (job.shot, job.name.as_str())).collect();
    let path_of = |shot: u64| format!("{}/{VTI}", names.get(&shot).copied().unwrap_or_default());
    let (mut series, mut finished, mut tried) = (FileSeries::new(path_of), 0_usize, 0_usize);
    let mut full = None;
    for job in &jobs {
        if stop.is_cancelled() {
            break;
        }
        tried += 1;
        if !job.is_done {
            match run.measure(job, read_already.take()) {
                Ok(result) => report(&bar, job, &result)?,
                Err(error) if is_disk_full(&error) => {
                    full = Some(error);
                    break;
                }
                Err(error) => {
                    let failure = format!("{}: {error:#}", job.pair.display());
                    bar.suspend(|| tracing::error!("{failure}"));
                    failures.push(failure);
                    bar.inc(1);
                    continue;
                }
            }
            bar.inc(1);
        }
        finished += 1;
        series.push(job.shot, None);
    }
    bar.finish_and_clear();
    let written = match !series.is_empty() && run.file.config.output.paraview {
        true => series.write(&out.join("velocity.vti.series")),
        false => Ok(()),
    };
    if let Some(full) = full {
        return Err(full.context(unfinished("stopped", finished, jobs.len())));
    }
    written?;
    conclude(failures.len(), (tried < jobs.len()).then_some([finished, jobs.len()]))
}

/// Whether the disk is full, so that no other result could be written either.
fn is_disk_full(error: &anyhow::Error) -> bool {
    let full = |cause: &ArchiveError| matches!(cause, ArchiveError::DiskFull { .. });
    error.downcast_ref::<ArchiveError>().is_some_and(full)
}

/// Message about the progress and how to continue.
fn unfinished(why: &str, finished: usize, pairs: usize) -> String {
    format!(
        "{why}: {finished} of {} have results; repeat the command with --resume to measure the \
         others",
        count(pairs, "pair")
    )
}

/// A token that is cancelled by Ctrl-C or SIGTERM, and the runtime that listens for them, which
/// must be dropped last.
fn stop_between_shots() -> anyhow::Result<(Runtime, CancellationToken)> {
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .worker_threads(1)
        .enable_all()
        .build()
        .context("cannot listen for Ctrl-C")?;
    // There is no laser to wait for.
    let laser = SynchroniserThread::default();
    let words = "the results of the current pair are not written";
    let listening = async { stop_on_signals(&laser, words) };
    let stop = runtime.block_on(listening)?;
    Ok((runtime, stop))
}

/// The final error, if any; failures have been logged. `interrupted` is the number of pairs with
/// results and of all pairs.
fn conclude(failures: usize, interrupted: Option<[usize; 2]>) -> anyhow::Result<()> {
    let failed = format!("{} could not be measured, see above", count(failures, "pair folder"));
    match interrupted {
        Some([finished, pairs]) => bail!(unfinished("interrupted", finished, pairs)),
        None if failures > 0 => bail!(failed),
        None => Ok(()),
    }
}

/// The configuration with the overrides of the command line.
fn configuration(args: &ProcessArgs, config: &Path) -> anyhow::Result<ConfigFile> {
    let mut file = ConfigFile::load(config)?;
    if let Some(solver) = args.solver {
        file.config.reconstruction.solver = solver;
        let name = solver_name(solver);
        let note = "# Overridden on the command line: reconstruction.solver";
        file.text.push_str(&format!("\n{note} = \"{name}\"\n"));
    }
    Ok(file)
}

/// Processes a recorded run, which has its own configuration and result folder.
fn process_recorded(
    folder: &Path,
    args: &ProcessArgs,
    stop: &CancellationToken,
) -> anyhow::Result<()> {
    if args.overwrite {
        bail!(
            "{} is a recorded run: its results are never replaced. To measure its images again, \
             `lfpiv export` them first",
            folder.display()
        );
    }
    let out = args.out.as_deref();
    let own_folder = out.filter(|_| args.part.is_none());
    if args.config.is_some() || own_folder.is_some() || args.solver.is_some() || args.save_volumes {
        bail!(
            "{} is a recorded run: its unmeasured shots are measured with its own configuration, \
             in its own folder. To measure its images with other settings, `lfpiv export` them \
             first",
            folder.display()
        );
    }
    if let Some(url) = &args.cluster.cluster {
        return process_cluster(folder, &args.cluster, url, stop);
    }
    match (args.part.zip(out), &args.merge) {
        (Some((part, out)), _) => process_part(folder, part, out, stop),
        (None, Some(parts)) => merge_parts(folder, parts, stop),
        (None, None) => process_run(folder, stop),
    }
}

/// What all pairs have in common.
struct Run {
    processor: Processor,
    file: ConfigFile,
    save_volumes: bool,
}

impl Run {
    /// Builds the tables while reading the first pair to be measured.
    fn prepare(
        args: &ProcessArgs,
        file: ConfigFile,
        jobs: &[Job],
    ) -> anyhow::Result<(Self, Option<anyhow::Result<ImagePair>>)> {
        let first = jobs.iter().find(|job| !job.is_done);
        let (processor, first) = rayon::join(
            || Processor::timed(file.config.measurement(), monotonic),
            || first.map(|job| read(&file.config, &job.pair)),
        );
        let processor = processor
            .with_context(|| format!("no measurement is possible with {}", file.path.display()))?;
        Ok((Self { processor, file, save_volumes: args.save_volumes }, first))
    }

    /// If the first pair chose the forward model in an earlier call, lets it choose again, so that
    /// all pairs are measured with the same model.
    fn choose_model_again(&self, jobs: &[Job]) {
        let first = jobs.iter().find(|job| job.is_done);
        let Some(first) = first.filter(|_| self.file.config.model.mode == ModelMode::Auto) else {
            return;
        };
        let chosen = self.read(&first.pair).and_then(|pair| Ok(self.processor.process(pair)?));
        if let Err(error) = chosen {
            let pair = first.pair.display();
            tracing::warn!("{pair}: {error:#}; another pair chooses the forward model");
        }
    }

    fn read(&self, folder: &Path) -> anyhow::Result<ImagePair> {
        read(&self.file.config, folder)
    }

    /// Learns stationary light if configured: from background images or from all pairs. A pair that
    /// cannot be read is reported when it is processed.
    fn learn_background(&mut self, jobs: &[Job]) -> anyhow::Result<()> {
        let config = &self.file.config;
        match config.image.background {
            Background::Constant => Ok(()),
            Background::Images => {
                Ok(self.processor.learn_background(&background_images(config)?)?)
            }
            Background::Minimum | Background::Mean => {
                if jobs.len() < LEAST_BACKGROUND_PAIRS {
                    bail!(
                        "image.background estimates stationary light from {}: \
                         at least {LEAST_BACKGROUND_PAIRS} are needed, otherwise particles are \
                         removed; give more folders, or set image.background = \"constant\"",
                        count(jobs.len(), "pair")
                    );
                }
                for job in jobs {
                    if let Ok(pair) = self.read(&job.pair) {
                        self.processor.learn_background(&pair)?;
                    }
                }
                Ok(())
            }
        }
    }

    /// Measures and stores one pair, which is read unless `read_already` is given.
    fn measure(
        &self,
        job: &Job,
        read_already: Option<anyhow::Result<ImagePair>>,
    ) -> anyhow::Result<PairResult> {
        let pair = read_already.unwrap_or_else(|| self.read(&job.pair))?;
        let (result, volumes) = if self.save_volumes {
            let (result, volumes) = self.processor.process_with_volumes(pair)?;
            (result, Some(volumes))
        } else {
            (self.processor.process(pair)?, None)
        };
        let folder = &job.results;
        std::fs::create_dir_all(folder)
            .with_context(|| format!("cannot create {}", folder.display()))?;
        if let Some(volumes) = volumes {
            write_volumes(&folder.join("volumes.nc"), &self.file.text, &volumes)?;
        }
        let paraview = self.file.config.output.paraview;
        let source = VtiSource { shot: job.shot, utc_s: None, configuration: &self.file.text };
        if paraview {
            write_vti(&folder.join(VTI), &source, &result.field)?;
        }
        if let Some(particles) = result.particles.as_ref().filter(|_| paraview) {
            write_vtp(&folder.join("particles.vtp"), &source, &result.field, particles)?;
        }
        let result = ShotResult::from(result);
        write_particles(&folder.join("particles.nc"), &self.file.text, job.shot, &result)?;
        // Written last: this file marks complete results.
        write_velocity(&folder.join("velocity.nc"), &self.file.text, job.shot, &result)?;
        Ok(result.measured)
    }
}

fn read(config: &Config, folder: &Path) -> anyhow::Result<ImagePair> {
    Ok(read_pair(folder, config.camera.len(), (&config.optics.sensor).into())?)
}

fn report(bar: &ProgressBar, job: &Job, result: &PairResult) -> anyhow::Result<()> {
    let seconds = &result.seconds;
    let through =
        |placed: &Vec<_>| format!(" through {} in the images", count(placed.len(), "particle"));
    let line = format!(
        "{}: {}{}, {:.1} % valid{}; decoded in {:.2} s, reconstructed in {:.2} s, correlated in \
         {:.2} s, judged in {:.2} s -> {}",
        job.name,
        count(result.field.grid.len(), "vector"),
        result.particles.as_ref().map_or(String::new(), through),
        100.0 * result.field.valid_share(),
        result.fit.as_ref().map_or(String::new(), |fit| format!(", model fit {}", fit.verdict)),
        seconds.decode_s,
        seconds.reconstruct_s,
        seconds.correlate_s,
        seconds.judge_s,
        job.results.display()
    );
    bar.suspend(|| {
        for warning in &result.warnings {
            tracing::warn!("{}: {warning}", job.name);
        }
        print(&line)
    })
}
