//! Whole runs: from the simulated bench to files and HTTP.

use std::{
    num::NonZeroU64,
    path::{Path, PathBuf},
    sync::Arc,
    time::Duration,
};

use lfpiv::{
    acquisition::{Outcome, OverloadPolicy},
    archive::ShotResult,
    cli::daemon::{Daemon, DaemonPlan, DaemonReport},
    config::ConfigFile,
    pipeline::{Observer, ShotRecord, Stage},
};
use lfpiv_core::{lightfield::ImagePair, velocimetry::PairResult};
use parking_lot::Mutex;
use serde_json::Value;
use tokio_util::sync::CancellationToken;

use crate::{
    bench::{Trick, bench, configuration, quick_result},
    client::get,
};

fn plan(file: &ConfigFile, shots: u64, overload: OverloadPolicy) -> DaemonPlan {
    DaemonPlan::new(file.clone(), NonZeroU64::new(shots), overload)
}

/// Records every shot that leaves the pool.
fn recorder() -> (Observer, Arc<Mutex<Vec<ShotRecord>>>) {
    let records: Arc<Mutex<Vec<ShotRecord>>> = Arc::default();
    let seen = records.clone();
    (
        Box::new(move |record: &ShotRecord, _: Option<&ShotResult>| {
            seen.lock().push(record.clone())
        }),
        records,
    )
}

fn stages(records: &Mutex<Vec<ShotRecord>>) -> Vec<(u64, Stage)> {
    records.lock().iter().map(|record| (record.shot, record.stage)).collect()
}

/// Runs with `process` in place of the workers.
async fn run<P>(
    plan: DaemonPlan,
    tricks: &[(usize, u64, Trick)],
    stop: CancellationToken,
    process: P,
) -> (anyhow::Result<DaemonReport>, Arc<Mutex<Vec<ShotRecord>>>)
where
    P: Fn(&ImagePair) -> Result<PairResult, String> + Send + Sync + 'static,
{
    let (bench, _) = bench(&plan.file, tricks);
    let (observer, records) = recorder();
    let daemon = Daemon::prepare(plan).await.unwrap();
    (daemon.run(bench, move || Ok(process), observer, stop).await, records)
}

fn ledger_file(folder: &Path) -> Value {
    serde_json::from_slice(&std::fs::read(folder.join("ledger.json")).unwrap()).unwrap()
}

fn files(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[tokio::test]
async fn a_bounded_run_waits_for_every_shot() {
    let root = tempfile::tempdir().unwrap();
    let mut file = configuration(root.path());
    file.config.pipeline.queue = 1;
    let plan = plan(&file, 5, OverloadPolicy::Wait);
    let slow = |pair: &ImagePair| {
        assert_eq!(pair.cameras.len(), 2);
        std::thread::sleep(Duration::from_millis(150));
        Ok(quick_result(pair))
    };
    let (ended, records) = run(plan, &[], CancellationToken::new(), slow).await;
    let report = ended.unwrap();
    assert_eq!(stages(&records), (0..5).map(|shot| (shot, Stage::Done)).collect::<Vec<_>>());
    for account in report.ledger.accounts() {
        assert_eq!((account.triggers, account.outcomes.of(Outcome::Complete)), (5, 5));
    }
    let names = files(&report.folder);
    let expected = ["configuration.toml", "ledger.json", "lock", "raw", "shot_000000.vti"];
    assert_eq!(names[..5], expected);
    assert_eq!(names[9..], ["velocity.vti.series", "velocity_000000.nc"]);
    let ledger = ledger_file(&report.folder);
    assert_eq!(ledger["balanced"], true);
    assert_eq!(ledger["cameras"][1]["outcomes"]["complete"], 5);
    assert_eq!(ledger["exceptions"], serde_json::json!([]));
}

#[tokio::test]
async fn files_for_paraview_can_be_left_out() {
    let root = tempfile::tempdir().unwrap();
    let mut file = configuration(root.path());
    file.config.output.paraview = false;
    let plan = plan(&file, 2, OverloadPolicy::Wait);
    let quick = |pair: &ImagePair| Ok(quick_result(pair));
    let (ended, _) = run(plan, &[], CancellationToken::new(), quick).await;
    let names = files(&ended.unwrap().folder);
    assert_eq!(names[4..], ["velocity_000000.nc"], "{names:?}");
}

/// A reconstruction that does not return is reported; it may return later.
#[tokio::test(flavor = "multi_thread")]
async fn a_hung_worker_is_reported() {
    let root = tempfile::tempdir().unwrap();
    let mut file = configuration(root.path());
    file.config.pipeline.first_pair_patience_s = 0.1;
    let plan = plan(&file, 1, OverloadPolicy::Wait);
    let (bench, _) = bench(&plan.file, &[]);
    let (observer, _) = recorder();
    let daemon = Daemon::prepare(plan).await.unwrap();
    let address = daemon.address();
    let (release, released) = std::sync::mpsc::channel::<()>();
    let released = Mutex::new(released);
    let hangs = move |pair: &ImagePair| {
        released.lock().recv_timeout(Duration::from_secs(120)).map_err(|e| e.to_string())?;
        Ok::<_, String>(quick_result(pair))
    };
    let stop = CancellationToken::new();
    let running = tokio::spawn(daemon.run(bench, move || Ok(hangs), observer, stop));
    let unwell = loop {
        let health = get(address, "/healthz").await;
        if health.status == 503 {
            break String::from_utf8(health.body).unwrap();
        }
        assert!(!running.is_finished());
        tokio::time::sleep(Duration::from_millis(10)).await;
    };
    assert!(unwell.contains("the worker of shot 0 hangs"), "{unwell}");
    release.send(()).unwrap();
    let report = running.await.unwrap().unwrap();
    assert_eq!(report.ledger.accounts()[0].outcomes.of(Outcome::Complete), 1);
}

#[tokio::test]
async fn an_overloaded_run_sheds_shots_and_lists_them() {
    let root = tempfile::tempdir().unwrap();
    let mut file = configuration(root.path());
    file.config.pipeline.queue = 1;
    let plan = plan(&file, 8, OverloadPolicy::Shed);
    let slow = |pair: &ImagePair| {
        std::thread::sleep(Duration::from_millis(1500));
        Ok(quick_result(pair))
    };
    let (ended, records) = run(plan, &[], CancellationToken::new(), slow).await;
    let report = ended.unwrap();
    let account = report.ledger.accounts()[0];
    let (done, shed) = (records.lock().len() as u64, account.outcomes.of(Outcome::Shed));
    assert!(done >= 1 && shed >= 1, "{account:?}");
    assert_eq!(done + shed, 8);
    let listed = ledger_file(&report.folder)["exceptions"].as_array().unwrap().len() as u64;
    assert_eq!(listed, shed);
}

#[tokio::test]
async fn a_panic_and_a_lost_frame_affect_only_their_shots() {
    let root = tempfile::tempdir().unwrap();
    let file = configuration(root.path());
    let plan = plan(&file, 5, OverloadPolicy::Wait);
    let count = std::sync::atomic::AtomicUsize::new(0);
    let process = move |pair: &ImagePair| {
        let calls = count.fetch_add(1, std::sync::atomic::Ordering::SeqCst);
        assert!(calls != 1, "a bug in shot 1");
        Ok(quick_result(pair))
    };
    let tricks = [(1, 6, Trick::Damage)];
    let (ended, records) = run(plan, &tricks, CancellationToken::new(), process).await;
    let report = ended.unwrap();
    let expected = [(0, Stage::Done), (1, Stage::Failed), (2, Stage::Done), (4, Stage::Done)];
    assert_eq!(stages(&records), expected);
    let ledger = ledger_file(&report.folder);
    let message = ledger["without_result"][0]["message"].as_str().unwrap();
    assert!(message.contains("panicked: a bug in shot 1"), "{message}");
    assert_eq!(
        ledger["exceptions"][0]["cameras"],
        serde_json::json!(["unpaired", "missing_packets"])
    );
}

#[tokio::test(flavor = "multi_thread")]
async fn a_run_can_be_watched_and_stopped() {
    let root = tempfile::tempdir().unwrap();
    let file = configuration(root.path());
    let (bench, _) = bench(&file, &[]);
    let (observer, records) = recorder();
    let stop = CancellationToken::new();
    let daemon = Daemon::prepare(plan(&file, 500, OverloadPolicy::Wait)).await.unwrap();
    let (address, folder) = (daemon.address(), daemon.folder().to_owned());
    let process = |pair: &ImagePair| {
        std::thread::sleep(Duration::from_millis(30));
        Ok::<_, String>(quick_result(pair))
    };
    let running = tokio::spawn(daemon.run(bench, move || Ok(process), observer, stop.clone()));
    while get(address, "/api/v1/results/latest").await.status != 200 {
        tokio::time::sleep(Duration::from_millis(50)).await;
    }
    let status = get(address, "/api/v1/status").await.json();
    assert_eq!(
        (&status["state"], &status["configuration"]["overload"]),
        (&"running".into(), &"wait".into())
    );
    assert_eq!(status["results_dir"], folder.display().to_string());
    stop.cancel();
    let report = tokio::time::timeout(Duration::from_secs(20), running).await.unwrap().unwrap();
    let report = report.unwrap();
    assert!(report.acquisition.triggers < 500);
    let account = report.ledger.accounts()[0];
    assert!(account.is_balanced() && account.open == 0);
    assert_eq!(account.outcomes.of(Outcome::Complete), records.lock().len() as u64);
    assert!(std::net::TcpStream::connect(address).is_err(), "the server has ended");
    assert!(files(&folder).iter().all(|name| !name.ends_with(".part")));
}

#[tokio::test]
async fn a_lost_camera_fails_the_run_and_keeps_the_results() {
    let root = tempfile::tempdir().unwrap();
    let file = configuration(root.path());
    let plan = plan(&file, 20, OverloadPolicy::Wait);
    let tricks = [(0, 8, Trick::Fail)];
    let quick = |pair: &ImagePair| Ok(quick_result(pair));
    let (ended, records) = run(plan, &tricks, CancellationToken::new(), quick).await;
    let error = format!("{:#}", ended.unwrap_err());
    assert!(error.contains("ended early") && error.contains("no heartbeat"), "{error}");
    assert!(records.lock().len() >= 3);
    let folder: PathBuf = std::fs::read_dir(root.path()).unwrap().next().unwrap().unwrap().path();
    let ledger = ledger_file(&folder);
    assert!(ledger["error"].as_str().unwrap().contains("no heartbeat"));
    assert_eq!((&ledger["balanced"], &ledger["cameras"][0]["open"]), (&true.into(), &0.into()));
    assert!(files(&folder).contains(&"velocity_000000.nc".to_owned()));
}

#[tokio::test]
async fn tables_that_cannot_be_built_fail_the_run_before_a_shot() {
    let root = tempfile::tempdir().unwrap();
    let file = configuration(root.path());
    let (bench, calls) = bench(&file, &[]);
    let daemon = Daemon::prepare(plan(&file, 1, OverloadPolicy::Wait)).await.unwrap();
    type Process = fn(&ImagePair) -> Result<PairResult, String>;
    let processor = || -> anyhow::Result<Process> { anyhow::bail!("the volume is out of sight") };
    let ended = daemon.run(bench, processor, recorder().0, CancellationToken::new()).await;
    assert!(ended.unwrap_err().to_string().contains("out of sight"));
    assert_eq!(*calls.lock(), ["make safe", "reads back safe"]);
}

#[tokio::test]
async fn an_address_in_use_is_reported() {
    let taken = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let root = tempfile::tempdir().unwrap();
    let mut file = configuration(root.path());
    file.config.server.address = taken.local_addr().unwrap();
    let error = Daemon::prepare(plan(&file, 1, OverloadPolicy::Wait)).await.err().unwrap();
    assert!(error.to_string().contains("is another lfpiv running?"), "{error}");
    assert_eq!(std::fs::read_dir(root.path()).unwrap().count(), 0, "no empty run is left behind");
}
