//! Exports the vectors of a run in the formats of other programs.

use anyhow::{Context, bail};

use super::{ExportArgs, Format};
use crate::{
    archive::{Hdf5File, StoredShot, StoredShots, write_csv, write_tecplot},
    cli::output::{count, print, progress_bar},
};

/// Writes the vectors of the selected shots.
pub(super) fn export(args: &ExportArgs) -> anyhow::Result<()> {
    let mut stored = StoredShots::find(&args.run)?;
    let all = stored.len();
    stored.retain(|shot| args.includes(shot));
    if stored.is_empty() {
        let run = args.run.display();
        match all {
            0 => bail!(
                "{run} contains no results: is it the folder of a run, or an output folder of \
                 `lfpiv process`?"
            ),
            _ => bail!("{run} has none of these shots: it has results of {}", count(all, "shot")),
        }
    }
    std::fs::create_dir_all(&args.out)
        .with_context(|| format!("cannot create {}", args.out.display()))?;
    let bar = progress_bar(stored.len(), "shots");
    let configuration = stored.configuration()?;
    let mut writer = Writer { args, configuration, hdf5: None };
    stored.for_each(|shot| {
        bar.inc(1);
        writer.write(&shot)
    })?;
    writer.finish()?;
    bar.finish_and_clear();
    print(&format!("vectors of {} in {}", count(stored.len(), "shot"), args.out.display()))
}

struct Writer<'a> {
    args: &'a ExportArgs,
    configuration: String,
    /// The file for the next shot.
    hdf5: Option<Hdf5File>,
}

impl Writer<'_> {
    fn write(&mut self, shot: &StoredShot) -> anyhow::Result<()> {
        let path = |ending: &str| self.args.out.join(format!("shot_{:06}.{ending}", shot.shot));
        match self.args.format {
            Format::Csv => Ok(write_csv(&path("csv"), shot)?),
            Format::Tecplot => Ok(write_tecplot(&path("dat"), shot)?),
            Format::Hdf5 => self.append(shot),
            // These are exported elsewhere.
            Format::Tiff | Format::Paraview => Ok(()),
        }
    }

    fn append(&mut self, shot: &StoredShot) -> anyhow::Result<()> {
        if self.hdf5.as_ref().is_some_and(|file| !file.accepts(shot)) {
            self.finish()?;
        }
        let file = match self.hdf5.take() {
            Some(file) => file,
            None => {
                let path = self.args.out.join(format!("velocity_{:06}.h5", shot.shot));
                Hdf5File::create(&path, &self.configuration, shot)?
            }
        };
        Ok(self.hdf5.insert(file).append(shot)?)
    }

    fn finish(&mut self) -> anyhow::Result<()> {
        Ok(self.hdf5.take().map_or(Ok(()), Hdf5File::store)?)
    }
}
