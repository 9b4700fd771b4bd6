//! SIGKILL at any moment: acknowledged data is on the disk, byte for byte.

use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
    process::{Command, Stdio},
    time::{Duration, Instant},
};

use lfpiv::acquisition::journal::RecordedRun;
use lfpiv_hw::RawImage;
use rand::RngExt;
use tempfile::TempDir;

use crate::{
    bench::{Running, configuration, finished_run, images},
    campaign::{Campaign, Case},
    exported::{argument, shots_in},
    report::FaultKind,
};

/// Small segments and frequent syncs, so that kills hit every stage of writing.
const RAW_LOG: &str = "[raw_log]\nsegment_mb = 2\nsync_ms = 5\n";
/// Shots of the reference run; killed runs are shorter.
const REFERENCE_SHOTS: &str = "120";
/// Longest life of a daemon.
const MOST_ALIVE_US: u64 = 500_000;

/// See the module.
pub struct Kills {
    root: TempDir,
    config: PathBuf,
    reference: BTreeMap<u64, Vec<[RawImage; 2]>>,
    kept: u64,
}

impl Kills {
    /// Records a complete run: other runs see the same images.
    pub fn prepare() -> Self {
        let root = tempfile::tempdir().expect("a folder");
        let config = configuration(root.path(), RAW_LOG);
        let reference = images(&finished_run(&config, REFERENCE_SHOTS)).into_iter().collect();
        Self { root, config, reference, kept: 0 }
    }

    /// Checks that everything acknowledged is there, and that all data is as the cameras delivered it.
    fn check(&mut self, case: &mut Case<'_>, run: &Path, synced: impl Iterator<Item = u64>) {
        let kept: BTreeMap<u64, _> = match RecordedRun::open(run) {
            // Killed before there was a log.
            Err(_) => BTreeMap::new(),
            Ok(_) => images(run).into_iter().collect(),
        };
        self.kept += kept.len() as u64;
        for shot in synced {
            case.tally.acknowledged += 1;
            if !kept.contains_key(&shot) {
                case.fault(FaultKind::Lost, format!("shot {shot} was acknowledged"));
            }
        }
        for (shot, images) in &kept {
            if self.reference.get(shot) != Some(images) {
                case.fault(FaultKind::Lost, format!("shot {shot} is another"));
            }
        }
        let out = self.root.path().join("pairs");
        let _ = fs::remove_dir_all(&out);
        let ended = case.lfpiv(&["export", "--out", argument(&out), argument(run)]);
        let exported = shots_in(&out).len();
        if exported != kept.len() || (ended.code != Some(0) && !kept.is_empty()) {
            let words = ended.last_words();
            case.fault(FaultKind::Lost, format!("{exported} of {} exported: {words}", kept.len()));
        }
    }
}

impl Campaign for Kills {
    fn run(&mut self, case: &mut Case<'_>) {
        let log = self.root.path().join("log");
        let file = fs::File::create(&log).expect("a file");
        let running = Running::logged(&self.config, &["--shots", REFERENCE_SHOTS], file);
        let alive = Duration::from_micros(case.random.random_range(0..MOST_ALIVE_US));
        let synced = running.acknowledged_until(Instant::now() + alive);
        case.note_memory(running.child.id());
        let run = running.kill();
        case.tally.kills += 1;
        case.judge_log(&fs::read_to_string(&log).unwrap_or_default());
        if case.random.random_bool(0.3) {
            kill_recovery(case, &run);
        }
        self.check(case, &run, synced.iter().copied());
        if case.random.random_bool(0.1) && !synced.is_empty() {
            let ended = case.lfpiv(&["process", argument(&run)]);
            if ended.code != Some(0) {
                case.fault(FaultKind::Wrong, format!("not measured: {}", ended.last_words()));
            }
            self.check(case, &run, synced.into_iter());
        }
        let _ = fs::remove_dir_all(run);
    }

    fn remark(&self) -> String {
        format!("{} shots there in all", self.kept)
    }
}

/// Kills the process that finishes the run, too.
fn kill_recovery(case: &mut Case<'_>, run: &Path) {
    let mut child = Command::new(env!("CARGO_BIN_EXE_lfpiv"))
        .args(["process", argument(run)])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the binary starts");
    std::thread::sleep(Duration::from_micros(case.random.random_range(0..200_000)));
    let _ = child.kill();
    let _ = child.wait();
    case.tally.kills += 1;
}
