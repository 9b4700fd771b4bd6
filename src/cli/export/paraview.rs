//! Exports the vectors and particles of a run for ParaView.

use anyhow::{Context, bail};

use super::ExportArgs;
use crate::{
    archive::{FileSeries, RunResults, StoredShots, VtiSource, write_vti, write_vtp},
    cli::output::{count, print, progress_bar},
    config::Config,
};

/// Writes the vectors of the selected shots, and their particles where they were placed, with the lists
/// `velocity.vti.series` and `particles.pvd`.
pub(super) fn export(args: &ExportArgs) -> anyhow::Result<()> {
    let (run, out) = (args.run.display(), args.out.display());
    let configuration = StoredShots::find(&args.run)?.configuration()?;
    let config = Config::parse("the run's configuration", &configuration)?;
    let results = RunResults::find(&args.run, config.volume.voxel_mm)?;
    let shots: Vec<u64> = results.shots().filter(|shot| args.includes(*shot)).collect();
    match (shots.is_empty(), results.len()) {
        (true, 0) => bail!(
            "{run} is not the folder of a run with results; `lfpiv process` writes the files for \
             ParaView of image pairs beside their results"
        ),
        (true, all) => {
            bail!("{run} has none of these shots: it has results of {}", count(all, "shot"))
        }
        _ => {}
    }
    std::fs::create_dir_all(&args.out).with_context(|| format!("cannot create {out}"))?;
    let bar = progress_bar(shots.len(), "shots");
    let mut vectors = FileSeries::new(|shot| format!("shot_{shot:06}.vti"));
    let mut particles = FileSeries::new(|shot| format!("particles_{shot:06}.vtp"));
    for shot in shots {
        bar.inc(1);
        let Some(result) = results.read_whole(shot)? else { continue };
        let (measured, utc_s) = (&result.measured, result.time.map(|time| time.utc_s()));
        let source = VtiSource { shot, utc_s, configuration: &configuration };
        write_vti(&args.out.join(vectors.name_of(shot)), &source, &measured.field)?;
        vectors.push(shot, utc_s);
        if let Some(placed) = &measured.particles {
            let path = args.out.join(particles.name_of(shot));
            write_vtp(&path, &source, &measured.field, placed)?;
            particles.push(shot, utc_s);
        }
    }
    vectors.write(&args.out.join("velocity.vti.series"))?;
    if !particles.is_empty() {
        particles.write_pvd(&args.out.join("particles.pvd"))?;
    }
    bar.finish_and_clear();
    print(&format!(
        "vectors of {} and particles of {} in {out}",
        count(vectors.len(), "shot"),
        particles.len(),
    ))
}
