//! The log of delivered results: reports and results, checksummed, in the order in which they counted.
//!
//! ```text
//! RUN/delivered/000000/segment_000000.raw    a raw log (docs/raw-log.md), one per coordinator that was started
//! ```
//!
//! The head of a record is a byte, `R` and JSON of a report and its shot, or `D` and a [`Delivery`]. The log's
//! description names the conditions; a log made under others is not read.

use std::{
    fs,
    path::{Path, PathBuf},
    sync::Arc,
};

use lfpiv_core::model::ModelChoice;
use lfpiv_rawlog::{RawLog, RawLogReader, RawLogSettings, RawLogWriter, Record, recover};
use serde::{Deserialize, Serialize};

use super::{Assignment, ClusterError, Conditions, Delivery, PROTOCOL, Report};

/// The folder of logs in the run's folder.
const FOLDER: &str = "delivered";

/// What a log's results depend on.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
struct Description {
    protocol: u32,
    conditions: Conditions,
    model_sha256: String,
}

#[derive(Serialize, Deserialize)]
struct Reported {
    shot: u64,
    #[serde(flatten)]
    report: Report,
}

/// What earlier coordinators have logged.
#[derive(Debug, Default)]
pub struct LoggedDeliveries {
    /// In order; those of delivered results, too.
    pub reports: Vec<(u64, Report)>,
    /// Delivered results, in order.
    pub results: Vec<Delivery>,
}

/// The log that this coordinator writes. It is the only one: the run's lock sees to that.
pub struct DeliveryLog {
    log: RawLog,
    _writer: RawLogWriter,
    root: PathBuf,
}

impl DeliveryLog {
    /// Reads the logs in the run's folder and begins another one.
    ///
    /// # Errors
    /// A folder cannot be listed or written.
    pub fn open(
        run: &Path,
        assignment: &Assignment,
        model: &Arc<ModelChoice>,
    ) -> Result<(Self, LoggedDeliveries), ClusterError> {
        let root = run.join(FOLDER);
        let description = Description {
            protocol: PROTOCOL,
            conditions: assignment.conditions.clone(),
            model_sha256: assignment.reference.model_sha256.clone(),
        };
        let mut logged = LoggedDeliveries::default();
        let (folders, next) = earlier(&root)?;
        for folder in folders {
            // What was never completed has told nobody anything.
            if let Err(reason) = read(&folder, &description, model, &mut logged) {
                tracing::warn!("{}: not read: {reason}", folder.display());
            }
        }
        let folder = root.join(format!("{next:06}"));
        fs::create_dir_all(&folder).map_err(|reason| ClusterError::Folder {
            what: "create",
            path: folder.clone(),
            reason,
        })?;
        let settings = RawLogSettings { reserve_mb: 0, ..RawLogSettings::default() };
        let text = serde_json::to_vec(&description).unwrap_or_default();
        let (log, writer) = RawLog::create(&folder, &text, &settings)?;
        Ok((Self { log, _writer: writer, root }, logged))
    }

    /// Appends a report without a result. Blocks while the disk is slow.
    ///
    /// # Errors
    /// The log has failed.
    pub fn report(&self, shot: u64, report: &Report) -> Result<(), ClusterError> {
        let reported = Reported { shot, report: report.clone() };
        self.append(b'R', &serde_json::to_vec(&reported).unwrap_or_default())
    }

    /// Appends a delivered result, as [`Delivery::encode`] made it.
    ///
    /// # Errors
    /// The log has failed.
    pub fn deliver(&self, bytes: &[u8]) -> Result<(), ClusterError> {
        self.append(b'D', bytes)
    }

    fn append(&self, kind: u8, content: &[u8]) -> Result<(), ClusterError> {
        let head = [&[kind], content].concat();
        self.log.append_blocking(Record { head, image: None })?;
        Ok(())
    }

    /// Removes all logs: the results are in the run's files, and every shot is settled.
    ///
    /// # Errors
    /// A file cannot be removed.
    pub fn remove(self) -> Result<(), ClusterError> {
        let root = self.root.clone();
        drop(self);
        fs::remove_dir_all(&root).map_err(|reason| ClusterError::Folder {
            what: "remove",
            path: root.clone(),
            reason,
        })
    }
}

/// The folders of earlier logs in order, and the number of the next one.
fn earlier(root: &Path) -> Result<(Vec<PathBuf>, u32), ClusterError> {
    let failed = |reason| ClusterError::Folder { what: "list", path: root.to_owned(), reason };
    let mut numbers: Vec<u32> = Vec::new();
    if root.is_dir() {
        for entry in fs::read_dir(root).map_err(failed)? {
            let name = entry.map_err(failed)?.file_name();
            numbers.extend(name.to_str().and_then(|name| name.parse::<u32>().ok()));
        }
    }
    numbers.sort_unstable();
    let next = numbers.last().map_or(0, |last| last + 1);
    Ok((numbers.into_iter().map(|number| root.join(format!("{number:06}"))).collect(), next))
}

/// Adds what a log says. Damaged records cost only themselves.
fn read(
    folder: &Path,
    expected: &Description,
    model: &Arc<ModelChoice>,
    logged: &mut LoggedDeliveries,
) -> Result<(), String> {
    recover(folder).map_err(|error| error.to_string())?;
    let reader = RawLogReader::open(folder).map_err(|error| error.to_string())?.finished();
    let found: Option<Description> = serde_json::from_slice(reader.description()).ok();
    if found.as_ref() != Some(expected) {
        return Err(
            "its results were made under other conditions; their shots are measured anew".into()
        );
    }
    for head in reader.heads() {
        let understood = match head {
            Ok((_, _, head, _)) => take(&head, expected, model, logged),
            Err(error) => Err(error.to_string()),
        };
        if let Err(reason) = understood {
            tracing::warn!("{}: {reason}", folder.display());
        }
    }
    Ok(())
}

fn take(
    head: &[u8],
    expected: &Description,
    model: &Arc<ModelChoice>,
    logged: &mut LoggedDeliveries,
) -> Result<(), String> {
    match head.split_first() {
        Some((b'R', text)) => {
            let Reported { shot, report } =
                serde_json::from_slice(text).map_err(|error| error.to_string())?;
            logged.reports.push((shot, report));
        }
        Some((b'D', bytes)) => {
            let delivery = Delivery::decode(bytes, model, &expected.model_sha256)
                .map_err(|error| error.to_string())?;
            logged.reports.push((delivery.shot, delivery.report()));
            logged.results.push(delivery);
        }
        _ => return Err("a record of an unknown kind".into()),
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use lfpiv_core::velocimetry::{PairResult, VectorGrid, VelocityField};

    use super::*;
    use crate::{
        archive::{RawLevel, ShotResult},
        cluster::{Attempt, Reference, Shot},
    };

    fn conditions() -> Conditions {
        Conditions {
            code_version: "1".into(),
            configuration_sha256: "2".into(),
            shots_sha256: "3".into(),
            background_crc32: vec![4],
        }
    }

    fn open(run: &Path, conditions: &Conditions, model: &str) -> (DeliveryLog, LoggedDeliveries) {
        let shot: Shot = serde_json::from_str(
            r#"{"number": 0, "frames": [], "dt_us_bits": 0, "suspect": [], "time": null}"#,
        )
        .unwrap();
        let (result_sha256, model_sha256) = (String::new(), model.to_owned());
        let assignment = Assignment {
            conditions: conditions.clone(),
            configuration: String::new(),
            reference: Reference { shot, result_sha256, model_sha256 },
            wants_light: false,
        };
        DeliveryLog::open(run, &assignment, &Arc::default()).unwrap()
    }

    fn delivery(shot: u64) -> Delivery {
        let field = VelocityField {
            grid: VectorGrid { vectors: [0; 3], first_mm: [0.0; 3], spacing_mm: 1.0 },
            displacement_vox: vec![],
            uncertainty_vox: vec![],
            status: vec![],
            peak_ratio: vec![],
            vorticity: vec![],
            divergence: vec![],
            has_gradient: vec![],
            voxel_mm: 0.1,
            dt_s: 1e-4,
        };
        let measured = PairResult {
            field,
            seconds: Default::default(),
            warnings: vec!["w".repeat(100)],
            model: Default::default(),
            fit: None,
            light: None,
            particles: None,
        };
        Delivery {
            shot,
            attempt: Attempt { issue: 1, delivery: 1 },
            worker: "one".into(),
            model_sha256: "model".into(),
            result: ShotResult { measured, time: None, raw: RawLevel::Synced },
        }
    }

    #[test]
    fn what_was_delivered_is_read_again_and_damage_costs_itself() {
        let root = tempfile::tempdir().unwrap();
        let (log, logged) = open(root.path(), &conditions(), "model");
        assert!(logged.reports.is_empty() && logged.results.is_empty());
        let failed = Report::Failed {
            attempt: Attempt { issue: 1, delivery: 1 },
            worker: "two".into(),
            reason: "dark".into(),
        };
        log.report(7, &failed).unwrap();
        let deliveries = [5, 6, 7].map(delivery);
        deliveries.iter().for_each(|delivery| log.deliver(&delivery.encode()).unwrap());
        drop(log);

        // Several coordinators, one after the other.
        let (log, logged) = open(root.path(), &conditions(), "model");
        let mut reports = vec![(7, failed)];
        reports.extend(deliveries.iter().map(|delivery| (delivery.shot, delivery.report())));
        assert_eq!(logged.reports, reports);
        let shots = |logged: &LoggedDeliveries| -> Vec<u64> {
            logged.results.iter().map(|delivery| delivery.shot).collect()
        };
        assert_eq!(shots(&logged), [5, 6, 7]);
        log.deliver(&delivery(8).encode()).unwrap();
        drop(log);
        let (log, logged) = open(root.path(), &conditions(), "model");
        assert_eq!(shots(&logged), [5, 6, 7, 8]);
        drop(log);

        let segment = root.path().join("delivered/000000/segment_000000.raw");
        let mut bytes = fs::read(&segment).unwrap();
        let result = deliveries[1].encode();
        let at = bytes.windows(result.len()).position(|window| window == result).unwrap();
        bytes[at + result.len() / 2] ^= 1;
        fs::write(&segment, bytes).unwrap();
        let (_log, logged) = open(root.path(), &conditions(), "model");
        assert_eq!(shots(&logged), [5, 7, 8]);
        assert_eq!(logged.reports.len(), 4);
    }

    #[test]
    fn results_made_under_other_conditions_are_not_read_and_all_is_removed_at_the_end() {
        let root = tempfile::tempdir().unwrap();
        let (log, _) = open(root.path(), &conditions(), "model");
        log.deliver(&delivery(5).encode()).unwrap();
        drop(log);
        let other = Conditions { code_version: "2".into(), ..conditions() };
        for (conditions, model) in [(other, "model"), (conditions(), "another")] {
            let (_log, logged) = open(root.path(), &conditions, model);
            assert!(logged.reports.is_empty() && logged.results.is_empty());
        }
        let (log, logged) = open(root.path(), &conditions(), "model");
        assert_eq!(logged.results.len(), 1);
        log.remove().unwrap();
        assert!(!root.path().join("delivered").exists());
    }
}
