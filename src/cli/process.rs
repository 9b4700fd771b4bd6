//! `lfpiv process`: recorded or imported image pairs to velocity.

use std::{
    collections::HashMap,
    ffi::OsString,
    path::{Path, PathBuf},
};

use anyhow::{Context, bail};
use indicatif::ProgressBar;

use super::{
    output::{count, print, progress_bar},
    process_run::{is_run, process_run},
    solver::{solver_by_name, solver_name},
};
use crate::{
    archive::{
        VtiSeries, VtiSource, find_pair_folders, read_pair, write_velocity, write_volumes,
        write_vti,
    },
    config::{Config, ConfigFile},
    lightfield::{Background, ImagePair},
    pipeline::{PairResult, Processor},
    reconstruction::Solver,
};

/// Arguments of `lfpiv process`.
#[derive(Debug, clap::Args)]
pub struct ProcessArgs {
    /// Configuration file (TOML) of the bench that took the images; a recorded run has its own.
    #[arg(long, value_name = "FILE")]
    pub config: Option<PathBuf>,
    /// Folder for the results: one folder per pair, called as the pair's; a recorded run gets them
    /// in its own.
    #[arg(long, value_name = "OUT")]
    pub out: Option<PathBuf>,
    /// Write the reconstructed volumes, too.
    #[arg(long)]
    pub save_volumes: bool,
    /// Solver to use instead of the configuration's.
    #[arg(long, value_name = "NAME", value_parser = solver_by_name)]
    pub solver: Option<Solver>,
    /// Pair folders, folders of pair folders, or one folder of a recorded run, whose missing
    /// results are made.
    #[arg(required = true, value_name = "DIR")]
    pub folders: Vec<PathBuf>,
}

/// With fewer pairs than this, what they have in common includes particles.
const LEAST_BACKGROUND_PAIRS: usize = 3;

/// Measures every pair; a pair that fails is reported and the others are still measured.
pub fn process(args: &ProcessArgs) -> anyhow::Result<()> {
    if let [folder] = args.folders.as_slice()
        && is_run(folder)
    {
        return process_recorded(folder, args);
    }
    let (Some(config), Some(out)) = (&args.config, &args.out) else {
        bail!(
            "image pairs need --config FILE and --out OUT; only the folder of one recorded run (it \
             has a folder raw) does without"
        )
    };
    let (jobs, mut failures) = jobs(&args.folders, out);
    let (mut run, first) = Run::prepare(args, config, jobs.first())?;
    run.learn_background(&jobs)?;
    for failure in &failures {
        tracing::error!("{failure}");
    }
    let bar = progress_bar(jobs.len(), "pairs");
    let (mut series, mut measured) = (VtiSeries::default(), 0_usize);
    let mut read_already = first;
    for (number, job) in (0..).zip(&jobs) {
        match run.measure(job, read_already.take()) {
            Ok(result) => {
                measured += 1;
                series.push(format!("{}/velocity.vti", job.name), number, None);
                report(&bar, job, &result)?;
            }
            Err(error) => {
                let failure = format!("{}: {error:#}", job.pair.display());
                bar.suspend(|| tracing::error!("{failure}"));
                failures.push(failure);
            }
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    if measured > 0 {
        series.write(&out.join("velocity.vti.series"))?;
    }
    if failures.is_empty() {
        return Ok(());
    }
    bail!("{} could not be measured, see above", count(failures.len(), "pair folder"))
}

/// A run has its configuration and its place for results.
fn process_recorded(folder: &Path, args: &ProcessArgs) -> anyhow::Result<()> {
    if args.config.is_some() || args.out.is_some() || args.solver.is_some() || args.save_volumes {
        bail!(
            "{} is a recorded run: its missing results are made as it was configured, in its own \
             folder. To measure its images otherwise, `lfpiv export` them first",
            folder.display()
        );
    }
    process_run(folder)
}

/// What is the same for all pairs.
struct Run {
    processor: Processor,
    file: ConfigFile,
    save_volumes: bool,
}

impl Run {
    /// Builds the tables, and reads the first pair meanwhile.
    fn prepare(
        args: &ProcessArgs,
        config: &Path,
        first: Option<&Job>,
    ) -> anyhow::Result<(Self, Option<anyhow::Result<ImagePair>>)> {
        let mut file = ConfigFile::load(config)?;
        if let Some(solver) = args.solver {
            file.config.reconstruction.solver = solver;
            let name = solver_name(solver);
            let note = "# Overridden on the command line: reconstruction.solver";
            file.text.push_str(&format!("\n{note} = \"{name}\"\n"));
        }
        let (processor, first) = rayon::join(
            || Processor::new(file.config.measurement()),
            || first.map(|job| read(&file.config, &job.pair)),
        );
        let processor =
            processor.with_context(|| format!("{} cannot be measured with", config.display()))?;
        Ok((Self { processor, file, save_volumes: args.save_volumes }, first))
    }

    fn read(&self, folder: &Path) -> anyhow::Result<ImagePair> {
        read(&self.file.config, folder)
    }

    /// Learns stationary light where the configuration asks for it: from its background images,
    /// or from all the pairs. A pair that cannot be read is reported when its turn comes.
    fn learn_background(&mut self, jobs: &[Job]) -> anyhow::Result<()> {
        let image = &self.file.config.image;
        match (image.background, &image.background_dir) {
            (Background::Constant, _) => Ok(()),
            (Background::Images, None) => bail!(
                "image.background = \"images\" needs image.background_dir, a folder with one \
                 background image per camera and frame, named like a pair"
            ),
            (Background::Images, Some(folder)) => {
                let pair = self.read(folder).context("cannot read the background images")?;
                Ok(self.processor.learn_background(&pair)?)
            }
            (Background::Minimum | Background::Mean, _) => {
                if jobs.len() < LEAST_BACKGROUND_PAIRS {
                    bail!(
                        "image.background takes what {} have in common for stationary light: \
                         at least {LEAST_BACKGROUND_PAIRS} are needed, or particles would be \
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

    /// Measures and stores one pair, and reads it where that has not been tried already.
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
        self.store(&job.results, &result)?;
        if let Some(volumes) = volumes {
            write_volumes(&job.results.join("volumes.nc"), &self.file.text, &volumes)?;
        }
        Ok(result)
    }

    fn store(&self, folder: &Path, result: &PairResult) -> anyhow::Result<()> {
        std::fs::create_dir_all(folder)
            .with_context(|| format!("cannot create {}", folder.display()))?;
        write_velocity(&folder.join("velocity.nc"), &self.file.text, 0, result)?;
        let source = VtiSource { shot: 0, utc_s: None, configuration: &self.file.text };
        write_vti(&folder.join("velocity.vti"), &source, &result.field)?;
        Ok(())
    }
}

fn read(config: &Config, folder: &Path) -> anyhow::Result<ImagePair> {
    Ok(read_pair(folder, config.camera.len(), (&config.optics.sensor).into())?)
}

/// One pair and where its results go.
#[derive(Debug, PartialEq)]
struct Job {
    pair: PathBuf,
    name: String,
    results: PathBuf,
}

/// The pairs below all folders given, and a message for each that cannot be one.
fn jobs(folders: &[PathBuf], out: &Path) -> (Vec<Job>, Vec<String>) {
    let (mut jobs, mut failures) = (Vec::new(), Vec::new());
    let mut taken: HashMap<String, PathBuf> = HashMap::new();
    for folder in folders {
        let pairs = match find_pair_folders(folder) {
            Ok(pairs) => pairs,
            Err(error) => {
                failures.push(error.to_string());
                continue;
            }
        };
        for pair in pairs {
            let name = name_of(&pair);
            if let Some(other) = taken.insert(name.clone(), pair.clone()) {
                failures.push(format!(
                    "{}: its results would replace those of {}: rename one of the folders or \
                     process them with different --out",
                    pair.display(),
                    other.display()
                ));
                taken.insert(name, other);
                continue;
            }
            jobs.push(Job { results: out.join(&name), pair, name });
        }
    }
    (jobs, failures)
}

/// A folder's own name, for `.` and `..` too.
fn name_of(folder: &Path) -> String {
    let own = |path: &Path| path.file_name().map(OsString::from);
    let name = own(folder).or_else(|| folder.canonicalize().ok().as_deref().and_then(own));
    name.map_or_else(|| "pair".to_owned(), |name| name.to_string_lossy().into_owned())
}

fn report(bar: &ProgressBar, job: &Job, result: &PairResult) -> anyhow::Result<()> {
    let seconds = &result.seconds;
    let line = format!(
        "{}: {}, {:.1} % valid{}; decoded in {:.2} s, reconstructed in {:.2} s, correlated in {:.2} s -> {}",
        job.name,
        count(result.field.grid.len(), "vector"),
        100.0 * result.field.valid_share(),
        result.fit.as_ref().map_or(String::new(), |fit| format!(", model fit {}", fit.verdict)),
        seconds.decode_s,
        seconds.reconstruct_s,
        seconds.correlate_s,
        job.results.display()
    );
    bar.suspend(|| {
        for warning in &result.warnings {
            tracing::warn!("{}: {warning}", job.name);
        }
        print(&line)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_pairs_of_one_name_are_not_written_over_each_other() {
        let root = tempfile::tempdir().unwrap();
        let folders: Vec<PathBuf> =
            ["monday/shot_0000", "tuesday/shot_0000"].map(|name| root.path().join(name)).into();
        for folder in &folders {
            std::fs::create_dir_all(folder).unwrap();
            std::fs::write(folder.join("cam1_a.tif"), b"").unwrap();
        }
        let (jobs, failures) = jobs(&folders, Path::new("out"));
        assert_eq!(jobs.len(), 1);
        assert_eq!(jobs[0].results, Path::new("out/shot_0000"));
        assert!(failures[0].contains("tuesday") && failures[0].contains("monday"), "{failures:?}");
    }

    #[test]
    fn a_folder_given_as_a_dot_has_its_own_name() {
        let here = std::env::current_dir().unwrap();
        assert_eq!(name_of(Path::new(".")), here.file_name().unwrap().to_string_lossy());
    }
}
