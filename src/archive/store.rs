//! Stores the results of a run, shot by shot.
//!
//! ```text
//! DIR/configuration.toml     the configuration of the run
//! DIR/velocity_000000.nc     sealed segment, named by its first shot
//! DIR/particles_000000.nc    the particles of its shots, if they were placed in the images
//! DIR/shot_000000.vti        one per shot, for ParaView, unless switched off
//! DIR/velocity.vti.series    the list of the above
//! ```
//!
//! The open segment is in memory and has at most some 32 MB of vectors and as many of particles. If a finished segment does not fit on
//! the disk, it stays in memory, and no further result is accepted before it is stored.
//!
//! [`super::merge_segments`] merges the segments of a finished run into few files.

mod adopt;

use std::{
    fs,
    io::Write as _,
    path::{Path, PathBuf},
    time::{Duration, Instant},
};

use super::{
    ArchiveError, ShotResult,
    durable::{create_folder, replace},
    netcdf_file::Finished,
    paraview::{FileSeries, VtiSource, write_vti},
    particle_file::{GatheredParticles, particles_beside},
    stored::StoredResults,
    stored_particles::remove_orphans,
    velocity_file::VelocityFile,
};

/// Age at which a segment is sealed. A crash loses the NetCDF results of at most this time.
const SEGMENT_AGE: Duration = Duration::from_secs(60);
/// Largest number of shots in a segment: the library needs some 5 kB of memory per shot.
const SEGMENT_SHOTS: usize = 600;
/// Up to this number of shots the list for ParaView is written after every shot. Beyond it the list
/// is written with every segment, because it is as long as the run.
const SHOTS_LISTED_IMMEDIATELY: usize = 100;

/// Writes the results of one run, from one thread. Call [`Self::close`] at the end to learn of
/// failures.
pub struct ResultStore {
    folder: PathBuf,
    configuration: String,
    segment_age: Duration,
    segment: Option<Segment>,
    /// A finished segment that is not on disk yet.
    unstored: Option<Unstored>,
    /// `None` if no files for ParaView are written.
    series: Option<FileSeries<'static>>,
}

struct Segment {
    file: VelocityFile,
    particles: GatheredParticles,
    opened: Instant,
    shots: Vec<u64>,
}

struct Unstored {
    file: Finished,
    particles: GatheredParticles,
    shots: Vec<u64>,
}

impl ResultStore {
    /// Starts a run in `folder`, which is created if necessary; `configuration` is the run's TOML
    /// text.
    ///
    /// # Errors
    /// [`ArchiveError::AlreadyUsed`] if the folder contains the results of another run;
    /// [`ArchiveError::Io`].
    pub fn create(folder: &Path, configuration: &str) -> Result<Self, ArchiveError> {
        Self::with_segment_age(folder, configuration, SEGMENT_AGE)
    }

    /// [`Self::create`] with another segment age than 60 s.
    pub fn with_segment_age(
        folder: &Path,
        configuration: &str,
        segment_age: Duration,
    ) -> Result<Self, ArchiveError> {
        create_folder(folder)?;
        let copy = folder.join("configuration.toml");
        if copy.exists() {
            return Err(ArchiveError::AlreadyUsed { path: folder.into() });
        }
        replace(&copy, |writer| writer.write_all(configuration.as_bytes()))?;
        Ok(Self {
            folder: folder.into(),
            configuration: configuration.into(),
            segment_age,
            segment: None,
            unstored: None,
            series: Some(FileSeries::new(vti_name)),
        })
    }

    /// Continues a run whose results are in `folder`. Incomplete segments left by a crash are
    /// removed.
    ///
    /// # Errors
    /// [`ArchiveError::Io`]; a sealed segment cannot be read.
    pub fn reopen(
        folder: &Path,
        configuration: &str,
    ) -> Result<(Self, StoredResults), ArchiveError> {
        let stored = StoredResults::find(folder)?;
        for part in &stored.unreadable {
            fs::remove_file(part).map_err(ArchiveError::io("remove", part))?;
        }
        remove_orphans(folder)?;
        let mut series = FileSeries::new(vti_name);
        for shot in &stored.shots {
            if folder.join(vti_name(*shot)).exists() {
                series.push(*shot, stored.times_s.get(shot).copied());
            }
        }
        let (folder, configuration) = (folder.into(), configuration.into());
        let (segment_age, series) = (SEGMENT_AGE, Some(series));
        let store =
            Self { folder, configuration, segment_age, segment: None, unstored: None, series };
        Ok((store, stored))
    }

    /// Sets whether a file for ParaView is written for each shot; the default is yes.
    pub fn for_paraview(mut self, wanted: bool) -> Self {
        self.series = self.series.take().filter(|_| wanted);
        self
    }

    /// The run's folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Stores the result of one shot. First seals the open segment if it has another forward model,
    /// as each file has one model. Afterwards seals the open segment if it is due.
    ///
    /// Each shot is stored once, in any order. On return its `.vti` can be read; its NetCDF record
    /// can be read once the segment is sealed.
    pub fn append(&mut self, shot: u64, result: &ShotResult) -> Result<(), ArchiveError> {
        if self.segment.as_ref().is_some_and(|segment| !segment.file.suits(result)) {
            self.seal()?;
        }
        self.store()?;
        let segment = match self.segment.take() {
            Some(segment) => segment,
            None => self.open_segment(shot, result)?,
        };
        let segment = self.segment.insert(segment);
        match segment.file.append(shot, result) {
            Ok(()) => {
                segment.shots.push(shot);
                segment.particles.add(shot, result);
            }
            Err(error) => {
                self.segment.take_if(|segment| segment.shots.is_empty());
                return Err(error);
            }
        }
        self.write_for_paraview(shot, result)?;
        self.seal_if_due().map(|_| ())
    }

    /// Seals the open segment if it is old enough or full. Call it in pauses of a run, when
    /// [`Self::append`] is not called.
    pub fn seal_if_due(&mut self) -> Result<Option<PathBuf>, ArchiveError> {
        let is_due = |segment: &Segment| {
            segment.opened.elapsed() >= self.segment_age
                || segment.shots.len() >= SEGMENT_SHOTS
                || segment.file.is_full()
                || segment.particles.is_full()
        };
        if self.segment.as_ref().is_some_and(is_due) { self.seal() } else { self.store() }
    }

    fn write_for_paraview(&mut self, shot: u64, result: &ShotResult) -> Result<(), ArchiveError> {
        let Some(series) = &mut self.series else { return Ok(()) };
        let utc_s = result.time.map(|time| time.utc_s());
        let source = VtiSource { shot, utc_s, configuration: &self.configuration };
        write_vti(&self.folder.join(vti_name(shot)), &source, &result.measured.field)?;
        series.push(shot, utc_s);
        if series.len() <= SHOTS_LISTED_IMMEDIATELY { self.write_series() } else { Ok(()) }
    }

    fn write_series(&self) -> Result<(), ArchiveError> {
        let Some(series) = &self.series else { return Ok(()) };
        series.write(&self.folder.join("velocity.vti.series"))
    }

    /// Seals the open segment, if any, and returns its path. If this fails, the next shot or pause
    /// tries again.
    pub fn seal(&mut self) -> Result<Option<PathBuf>, ArchiveError> {
        // Store an earlier segment first: only one can wait.
        let earlier = self.store()?;
        let Some(Segment { file, particles, shots, .. }) = self.segment.take() else {
            return Ok(earlier);
        };
        self.unstored = Some(Unstored { file: file.finish()?, particles, shots });
        self.store()
    }

    /// Writes the finished segment that waits for disk space.
    fn store(&mut self) -> Result<Option<PathBuf>, ArchiveError> {
        let Some(unstored) = &self.unstored else { return Ok(None) };
        let path = unstored.file.path().to_owned();
        // First: vectors are never without their particles.
        unstored.particles.store(&particles_beside(&path), &self.configuration)?;
        unstored.file.store()?;
        self.unstored = None;
        self.write_series()?;
        Ok(Some(path))
    }

    /// Seals the open segment and ends the run.
    ///
    /// # Errors
    /// As [`Self::seal`]; the log lists the shots that are lost.
    pub fn close(mut self) -> Result<(), ArchiveError> {
        let sealed = self.seal();
        self.report_lost();
        sealed.map(|_| ())
    }

    /// Logs which shots have no result on disk, and discards them.
    fn report_lost(&mut self) {
        let unstored = self.unstored.take().map(|unstored| unstored.shots);
        let open = self.segment.take().map(|segment| segment.shots);
        let mut shots: Vec<u64> = [unstored, open].into_iter().flatten().flatten().collect();
        shots.sort_unstable();
        if let [first, .., last] | [first @ last] = shots.as_slice() {
            tracing::error!(
                "{} of the shots {first} to {last} are not on disk: make room, then `lfpiv process \
                 {}` measures them again from their recorded images",
                shots.len(),
                self.folder.display()
            );
        }
    }

    /// A path named by the segment's first shot. A sealed segment may have that name already, if
    /// its first shot could not be stored but later ones were.
    fn unused_name(&self, shot: u64) -> PathBuf {
        let named = |suffix: String| self.folder.join(format!("velocity_{shot:06}{suffix}.nc"));
        let suffixes = (2..MAX_SUFFIX).map(|number| format!("_{number}"));
        let mut names = std::iter::once(String::new()).chain(suffixes).map(named);
        names.find(|path| !path.exists()).unwrap_or_else(|| named(String::new()))
    }

    fn open_segment(&self, shot: u64, result: &ShotResult) -> Result<Segment, ArchiveError> {
        let path = self.unused_name(shot);
        let file = VelocityFile::create(&path, &self.configuration, result)?;
        let (opened, particles, shots) = (Instant::now(), Default::default(), Vec::new());
        Ok(Segment { file, particles, opened, shots })
    }
}

/// Largest suffix tried for a segment name. Names repeat only after a first shot could not be
/// stored.
const MAX_SUFFIX: u32 = 1000;

fn vti_name(shot: u64) -> String {
    format!("shot_{shot:06}.vti")
}

impl Drop for ResultStore {
    fn drop(&mut self) {
        if let Err(error) = self.seal() {
            tracing::error!(%error, "the last results of the run are not sealed");
        }
        self.report_lost();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::archive::test_data::result;
    use lfpiv_core::model::ModelChoice;

    fn names(folder: &Path) -> Vec<String> {
        let mut names: Vec<_> = fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    fn shots_in(path: &Path) -> Vec<i64> {
        netcdf::open(path).unwrap().variable("shot").unwrap().get_values(..).unwrap()
    }

    #[test]
    fn shots_gather_in_a_segment_that_appears_when_closed() {
        let root = tempfile::tempdir().unwrap();
        let folder = root.path().join("runs/one");
        let mut store = ResultStore::create(&folder, "[shot]\n").unwrap();
        for shot in [0, 2, 1] {
            store.append(shot, &result([4, 3, 2])).unwrap();
        }
        assert!(!names(&folder).iter().any(|name| name.contains("velocity_0")));
        store.close().unwrap();
        assert_eq!(
            names(&folder),
            [
                "configuration.toml",
                "shot_000000.vti",
                "shot_000001.vti",
                "shot_000002.vti",
                "velocity.vti.series",
                "velocity_000000.nc"
            ]
        );
        assert_eq!(shots_in(&folder.join("velocity_000000.nc")), [0, 2, 1]);
    }

    #[test]
    fn files_for_paraview_can_be_switched_off() {
        let root = tempfile::tempdir().unwrap();
        let mut store = ResultStore::create(root.path(), "").unwrap().for_paraview(false);
        store.append(0, &result([4, 3, 2])).unwrap();
        store.close().unwrap();
        assert_eq!(names(root.path()), ["configuration.toml", "velocity_000000.nc"]);
    }

    #[test]
    fn a_segment_is_sealed_when_its_time_has_come() {
        let root = tempfile::tempdir().unwrap();
        let mut store = ResultStore::with_segment_age(root.path(), "", Duration::ZERO).unwrap();
        for shot in [5, 6] {
            store.append(shot, &result([4, 3, 2])).unwrap();
            assert_eq!(
                shots_in(&root.path().join(format!("velocity_{shot:06}.nc"))),
                [shot as i64]
            );
        }
    }

    #[test]
    fn another_model_starts_another_segment() {
        let root = tempfile::tempdir().unwrap();
        let mut store = ResultStore::create(root.path(), "").unwrap();
        store.append(0, &result([4, 3, 2])).unwrap();
        let mut other = result([4, 3, 2]);
        other.measured.model = ModelChoice { refinement: 2, ..ModelChoice::default() }.into();
        store.append(1, &other).unwrap();
        store.close().unwrap();
        for (shot, refinement) in [(0, 0), (1, 2)] {
            let path = root.path().join(format!("velocity_{shot:06}.nc"));
            assert_eq!(shots_in(&path), [shot]);
            let file = netcdf::open(&path).unwrap();
            let json = file.attribute("model_choice").unwrap().value().unwrap();
            let netcdf::AttributeValue::Str(json) = json else { panic!("{json:?}") };
            let choice: ModelChoice = serde_json::from_str(&json).unwrap();
            assert_eq!(choice.refinement, refinement);
        }
    }

    #[test]
    fn a_pause_seals_only_segments_that_are_old_enough() {
        let root = tempfile::tempdir().unwrap();
        let hour = Duration::from_secs(3600);
        let mut store = ResultStore::with_segment_age(root.path(), "", hour).unwrap();
        store.append(0, &result([4, 3, 2])).unwrap();
        assert_eq!(store.seal_if_due().unwrap(), None);
        store.segment_age = Duration::ZERO;
        assert_eq!(store.seal_if_due().unwrap(), Some(root.path().join("velocity_000000.nc")));
        assert_eq!(store.seal_if_due().unwrap(), None);
    }

    #[test]
    fn dropping_the_store_seals_it_and_its_folder_is_not_reused() {
        let root = tempfile::tempdir().unwrap();
        let mut store = ResultStore::create(root.path(), "").unwrap();
        store.append(0, &result([4, 3, 2])).unwrap();
        drop(store);
        assert_eq!(shots_in(&root.path().join("velocity_000000.nc")), [0]);
        let again = ResultStore::create(root.path(), "").err().unwrap().to_string();
        assert!(again.contains("already holds results"), "{again}");
    }

    #[test]
    fn a_shot_refused_for_its_grid_does_not_cost_the_others() {
        let root = tempfile::tempdir().unwrap();
        let mut store = ResultStore::create(root.path(), "").unwrap();
        store.append(0, &result([4, 3, 2])).unwrap();
        assert!(store.append(1, &result([5, 3, 2])).is_err());
        store.append(2, &result([4, 3, 2])).unwrap();
        store.close().unwrap();
        assert_eq!(shots_in(&root.path().join("velocity_000000.nc")), [0, 2]);
    }
}
