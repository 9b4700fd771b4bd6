//! The raw log of a run, from its start to its end.

use std::{
    fs::{self, File, TryLockError},
    path::Path,
};

use anyhow::{Context, bail};
use lfpiv_rawlog::{
    RawLog, RawLogWriter,
    regular_file::{open_regular, open_regular_with},
};

use super::daemon_plan::DaemonPlan;
use crate::acquisition::{
    AcquisitionSettings, Journal,
    journal::{Description, JOURNAL_VERSION, RAW_FOLDER},
};

/// The record of a run in progress.
pub(super) struct Recording {
    pub journal: Journal,
    writer: Option<RawLogWriter>,
    lock: RunLock,
}

impl Recording {
    /// Starts the record of a run in `folder`, if configured.
    pub fn begin(
        folder: &Path,
        plan: &DaemonPlan,
        acquisition: &AcquisitionSettings,
    ) -> anyhow::Result<Self> {
        let lock = RunLock::take(folder)?;
        let Some(settings) = plan.raw_log.as_ref().filter(|settings| settings.keep) else {
            return Ok(Self { journal: Journal::none(), writer: None, lock });
        };
        let description = Description {
            journal_version: JOURNAL_VERSION,
            code_version: env!("CARGO_PKG_VERSION").to_owned(),
            cameras: plan.file.config.camera.len(),
            patience_ns: u64::try_from(acquisition.patience.as_nanos()).unwrap_or(u64::MAX),
            configuration: plan.file.text.clone(),
        };
        let description =
            serde_json::to_vec(&description).context("the run cannot be described")?;
        let (log, writer) = RawLog::create(&folder.join(RAW_FOLDER), &description, settings)?;
        Ok(Self { journal: Journal::new(log), writer: Some(writer), lock })
    }

    /// Returns the run's lock and a blocking function that writes everything to disk and seals the
    /// last segment. The lock must be held until the run's last file is written.
    pub fn end(self) -> (RunLock, impl FnOnce() -> anyhow::Result<()> + Send + 'static) {
        let Self { writer, lock, .. } = self;
        let close = move || match writer {
            Some(writer) => writer.close().map(|_| ()).context("the raw log could not be closed"),
            None => Ok(()),
        };
        (lock, close)
    }
}

/// Logs which runs in `results_dir` were cut off: they have a record but no ledger, and no process
/// is writing them.
pub(super) fn report_unfinished(results_dir: &Path) {
    for entry in fs::read_dir(results_dir).into_iter().flatten().flatten() {
        let run = entry.path();
        let is_cut_off = run.join(RAW_FOLDER).is_dir() && !run.join("ledger.json").exists();
        if is_cut_off && RunLock::take(&run).is_ok() {
            let run = run.display();
            tracing::warn!("{run} was cut off: `lfpiv process {run}` measures what it recorded");
        }
    }
}

/// Refuses a run that is still being written, because it is incomplete.
///
/// # Errors
/// Another process is writing the run.
pub(super) fn refuse_running(run: &Path) -> anyhow::Result<()> {
    // Opened for reading only, so that runs on read-only disks can be used.
    let Ok(lock) = open_regular(&run.join(LOCK)) else { return Ok(()) };
    match lock.try_lock_shared() {
        Err(TryLockError::WouldBlock) => bail!(
            "{} is running: another lfpiv is writing it; wait until it has ended, or stop it",
            run.display()
        ),
        _ => Ok(()),
    }
}

/// Name of the lock file in the run's folder.
const LOCK: &str = "lock";

/// Ensures that only one process writes a run. The operating system releases the lock when the
/// process ends, for any reason.
pub(super) struct RunLock(#[expect(dead_code, reason = "held, not used")] File);

impl RunLock {
    /// # Errors
    /// Another process is writing the run.
    pub fn take(run: &Path) -> anyhow::Result<Self> {
        let path = run.join(LOCK);
        let file = open_regular_with(File::options().create(true).append(true), &path)
            .with_context(|| format!("cannot open {}", path.display()))?;
        match file.try_lock() {
            Ok(()) => Ok(Self(file)),
            Err(TryLockError::WouldBlock) => bail!(
                "{} is running: another lfpiv is writing it; wait until it has ended, or stop it",
                run.display()
            ),
            Err(TryLockError::Error(error)) => {
                Err(error).with_context(|| format!("cannot lock {}", path.display()))
            }
        }
    }
}
