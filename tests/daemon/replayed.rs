//! Replay of a run with every kind of camera fault, or with a burst that was stopped: every trigger
//! ends as in the run, although frames arrive at other times.

use std::{num::NonZeroU64, path::Path, sync::Arc, time::Duration};

use lfpiv::{
    acquisition::{
        AcquisitionLinks, AcquisitionReport, AcquisitionSettings, Bench, Command, Control, Journal,
        Ledger, Mode, Outcome, OverloadPolicy, acquire, control,
        journal::{Description, JOURNAL_VERSION, RAW_FOLDER, RecordedRun, ledger_of},
        replay::{Replay, Speed, replay},
        shot_queue,
    },
    archive::ShotTime,
};
use lfpiv_hw::device::Camera;
use lfpiv_rawlog::{RawLog, RawLogReader, RawLogSettings};
use lfpiv_sim::faults::{CameraFaults, FaultSettings, FaultyCamera, FrameShares};
use parking_lot::Mutex;
use tokio_util::sync::CancellationToken;

use crate::{
    acquisition::settings,
    bench::{bench, configuration},
};

const SHOTS: u64 = 40;
const PATIENCE: Duration = Duration::from_millis(700);
/// Number of shots after which a run is stopped and started again.
const STOPPED_AFTER: usize = 12;

fn faulty_bench(faults: &FaultSettings) -> Bench {
    let (mut bench, _) = bench(&configuration(Path::new("unused")), &[]);
    let wrap = |(index, camera): (usize, Box<dyn Camera>)| {
        Box::new(FaultyCamera::new(camera, index, faults)) as Box<dyn Camera>
    };
    bench.cameras = bench.cameras.into_iter().enumerate().map(wrap).collect();
    bench
}

/// Takes shots; the pool needs the given time for each. With a control, the run is stopped and
/// started again.
async fn take(
    bench: Bench,
    settings: AcquisitionSettings,
    queue: usize,
    pool: Duration,
    control: Option<Control>,
    equip: impl FnOnce(AcquisitionLinks) -> AcquisitionLinks,
) -> (AcquisitionReport, Ledger) {
    let ledger = Arc::new(Mutex::new(Ledger::new(2)));
    let (sender, mut receiver) = shot_queue(queue);
    let links = equip(AcquisitionLinks::new(ledger.clone(), sender, CancellationToken::new()));
    let acquiring = tokio::spawn(acquire(bench, settings, links));
    let mut received = 0;
    while let Some(shot) = receiver.recv().await {
        tokio::time::sleep(pool).await;
        ledger.lock().settle_all(shot.trigger, Outcome::Complete).unwrap();
        received += 1;
        if let Some(control) = control.as_ref().filter(|_| received == STOPPED_AFTER) {
            control.request(Command::Stop).await.unwrap();
            control.request(Command::Start).await.unwrap();
        }
    }
    let report = acquiring.await.unwrap().unwrap();
    let ledger = ledger.lock().clone();
    assert!(ledger.is_balanced());
    (report, ledger)
}

fn outcomes(ledger: &Ledger) -> Vec<(u64, Vec<Option<Outcome>>)> {
    ledger.entries().map(|entry| (entry.trigger, entry.cameras.clone())).collect()
}

fn times(ledger: &Ledger) -> Vec<(u64, Option<ShotTime>)> {
    ledger.entries().map(|entry| (entry.trigger, entry.time)).collect()
}

fn suspects(ledger: &Ledger) -> Vec<(u64, Vec<String>)> {
    ledger.entries().map(|entry| (entry.trigger, entry.suspect.clone())).collect()
}

async fn record(
    run: &Path,
    faults: &FaultSettings,
    is_stopped: bool,
) -> (AcquisitionReport, Ledger) {
    let description = Description {
        journal_version: JOURNAL_VERSION,
        code_version: String::new(),
        cameras: 2,
        patience_ns: PATIENCE.as_nanos() as u64,
        configuration: String::new(),
    };
    let description = serde_json::to_vec(&description).unwrap();
    let raw = RawLogSettings::default();
    let (log, writer) = RawLog::create(&run.join(RAW_FOLDER), &description, &raw).unwrap();
    let settings =
        AcquisitionSettings { patience: PATIENCE, ..settings(SHOTS, OverloadPolicy::Shed) };
    let journal = Journal::new(log);
    let fixed = Box::new(|_| Err("the schedule is fixed".to_owned()));
    let (control, inbox) = control(Mode::Firing, 100.0, fixed);
    let (bench, control) = (faulty_bench(faults), is_stopped.then_some(control));
    let taken = take(bench, settings, SHOTS as usize, Duration::ZERO, control, |links| {
        AcquisitionLinks { journal, control: inbox, ..links }
    })
    .await;
    tokio::task::spawn_blocking(|| writer.close()).await.unwrap().unwrap();
    taken
}

async fn play(run: &Path, pool: Duration) -> (AcquisitionReport, Ledger) {
    let stop = CancellationToken::new();
    let Replay { bench, clock, bursts, longest_burst, .. } =
        replay(run, Speed::Max, stop.clone()).unwrap();
    let settings = AcquisitionSettings {
        patience: PATIENCE,
        shots: None::<NonZeroU64>,
        ..settings(1, OverloadPolicy::Wait)
    };
    take(bench, settings, longest_burst as usize, pool, None, |links| AcquisitionLinks {
        clock,
        bursts: Some(bursts),
        stop,
        ..links
    })
    .await
}

#[tokio::test]
async fn every_trigger_ends_as_in_the_run() {
    let shares = FrameShares {
        dropped: 0.02,
        late: 0.04,
        reordered: 0.02,
        duplicated: 0.02,
        truncated: 0.02,
        missed_trigger: 0.02,
        ..FrameShares::default()
    };
    let camera = CameraFaults { shares, late_ms: 1000, ..CameraFaults::default() };
    let mut late = 0;
    for seed in [3, 4] {
        let faults = FaultSettings { seed, camera: camera.clone(), ..FaultSettings::default() };
        let root = tempfile::tempdir().unwrap();
        let (report, ledger) = record(root.path(), &faults, false).await;
        assert!(times(&ledger).iter().all(|(_, time)| time.is_some()));
        // A run without a ledger file, as after a kill.
        let recorded = RecordedRun::open(root.path()).unwrap();
        let rebuilt = ledger_of(&recorded, &(0..SHOTS).collect()).unwrap();
        assert_eq!(outcomes(&rebuilt), outcomes(&ledger), "seed {seed}");
        assert_eq!(times(&rebuilt), times(&ledger), "seed {seed}");
        // With a slow and a fast pool, which must not affect the replay's clock.
        for pool in [Duration::ZERO, Duration::from_millis(60)] {
            let (again, replayed) = play(root.path(), pool).await;
            assert_eq!(outcomes(&replayed), outcomes(&ledger), "seed {seed}, {pool:?}");
            assert_eq!(times(&replayed), times(&ledger), "seed {seed}, {pool:?}");
            assert_eq!((again.triggers, again.frames), (report.triggers, report.frames));
        }
        let accounts = ledger.accounts().iter();
        late += accounts.map(|account| account.outcomes.of(Outcome::Late)).sum::<u64>();
    }
    assert!(late > 0, "no frame was late: the test says nothing about time");
}

/// Shots whose frames come after the laser was switched off are suspect, in the run as in its replay.
#[tokio::test]
async fn a_stopped_burst_marks_the_same_shots_as_in_the_run() {
    // The simulated cameras are triggered at once, and many frames arrive later.
    let shares = FrameShares { late: 0.5, ..FrameShares::default() };
    let camera = CameraFaults { shares, late_ms: 400, ..CameraFaults::default() };
    let faults = FaultSettings { seed: 5, camera, ..FaultSettings::default() };
    let root = tempfile::tempdir().unwrap();
    let (report, ledger) = record(root.path(), &faults, true).await;
    let marked = suspects(&ledger);
    let switched_off = |reasons: &[String]| reasons.iter().any(|words| words.contains("switched"));
    let count = marked.iter().filter(|(_, reasons)| switched_off(reasons)).count();
    assert!((1..SHOTS as usize).contains(&count), "{marked:?}");
    let (again, replayed) = play(root.path(), Duration::ZERO).await;
    assert_eq!(suspects(&replayed), marked);
    assert_eq!(outcomes(&replayed), outcomes(&ledger));
    assert_eq!((again.triggers, again.frames), (report.triggers, report.frames));
}

/// Copies the record of a run up to the announcement that this trigger was given.
fn cut_off(run: &Path, trigger: u64, copy: &Path) {
    let reader = RawLogReader::open(&run.join(RAW_FOLDER)).unwrap();
    let raw = RawLogSettings::default();
    let (log, writer) = RawLog::create(&copy.join(RAW_FOLDER), reader.description(), &raw).unwrap();
    for record in reader.records() {
        let record = record.unwrap().1;
        let entry: serde_json::Value = serde_json::from_slice(&record.head).unwrap();
        log.append_blocking(record).unwrap();
        if entry["entry"] == "given" && entry["trigger"] == trigger {
            break;
        }
    }
    writer.close().unwrap();
}

/// The process was killed before the frames of the last trigger were recorded.
#[tokio::test]
async fn a_replay_of_a_record_that_is_cut_off_counts_the_triggers_that_were_given() {
    let [run, copy] = [(); 2].map(|()| tempfile::tempdir().unwrap());
    record(run.path(), &FaultSettings::default(), false).await;
    for trigger in [0, 6] {
        let copy = copy.path().join(trigger.to_string());
        std::fs::create_dir(&copy).unwrap();
        cut_off(run.path(), trigger, &copy);
        let (report, ledger) = play(&copy, Duration::ZERO).await;
        assert_eq!(report.triggers, trigger + 1);
        assert_eq!(ledger.accounts()[0].triggers, trigger + 1);
    }
}
