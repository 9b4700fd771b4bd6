//! Workers that must not measure a run.

use std::time::Duration;

use axum::{Json, Router, extract::Path, routing::get as get_of};
use lfpiv::{
    acquisition::journal::RecordedRun,
    cluster::{Broker, Conditions, CoordinatorClient, Job, JobQueue, PROTOCOL, Shot, Tokens},
};
use lfpiv_rawlog::Position;

use crate::{
    broker::Nats,
    processes::{coordinator, path, worker},
    recorded::{assert_as_on_one_machine, copied, recorded, recorded_otherwise},
};

#[test]
fn a_worker_with_another_configuration_is_refused_and_the_others_go_on() {
    let root = tempfile::tempdir().expect("a folder");
    let run = recorded(root.path());
    let threshold = ("median_threshold = 2.0", "median_threshold = 3.0");
    let other = recorded_otherwise(&root.path().join("bench"), threshold, 2);
    // A run of the same name where the worker looks for it.
    let elsewhere = root.path().join("elsewhere");
    std::fs::create_dir_all(&elsewhere).expect("a folder");
    copied(&other, &elsewhere.join("run"));
    let nats = Nats::start(root.path());
    let coordinator = coordinator(root.path(), &run, &nats.url(), &[]);
    let ended = worker(root.path(), &nats.url(), "unfit", &["--shared", path(&elsewhere)]).wait();
    assert_eq!(ended.code, Some(1), "{ended:?}");
    let reason = "has another configuration than the coordinator's";
    assert!(ended.stderr.contains("refuses run") && ended.stderr.contains(reason), "{ended:?}");

    let _fit = worker(root.path(), &nats.url(), "fit", &[]);
    let ended = coordinator.wait();
    assert_eq!(ended.code, Some(0), "{ended:?}");
    assert!(ended.stdout.contains("fit: 39 shots"), "{ended:?}");
    assert_as_on_one_machine(&run);
}

#[tokio::test]
async fn a_worker_of_another_version_refuses() {
    let root = tempfile::tempdir().expect("a folder");
    let nats = Nats::start(root.path());
    let broker = Broker { url: nats.url(), ..Broker::default() };
    let queue = JobQueue::connect(&broker, "test", "").await.expect("an address");
    let shot: Shot = serde_json::from_str(
        r#"{"number": 0, "frames": [], "dt_us_bits": 0, "suspect": [], "time": null}"#,
    )
    .expect("a shot");
    let job = Job {
        protocol: PROTOCOL,
        run: "other".into(),
        run_name: "run-of-another-version".into(),
        shot,
        issue: 1,
        conditions: Conditions {
            code_version: "999.0.0".into(),
            configuration_sha256: String::new(),
            shots_sha256: String::new(),
            background_crc32: Vec::new(),
        },
        model_sha256: String::new(),
        address: "http://127.0.0.1:1".into(),
        tokens: Tokens { read: String::new(), work: String::new() },
        heartbeat_ms: 100,
        deadline_ms: 10_000,
    };
    let heartbeat_timeout = Duration::from_secs(30);
    let missing = async || queue.missing("other", &[0], heartbeat_timeout).await.expect("a broker");
    assert_eq!(missing().await.len(), 1);
    queue.publish(&job).await.expect("a broker");
    // Offered once more, it is one job.
    assert_eq!(missing().await.len(), 0);
    assert!(queue.publish(&job).await.is_err());

    let url = nats.url();
    let folder = root.path().to_owned();
    let refuses = move || worker(&folder, &url, "old", &[]).wait();
    let ended = tokio::task::spawn_blocking(refuses).await.expect("its end");
    assert_eq!(ended.code, Some(1), "{ended:?}");
    assert!(ended.stderr.contains("its coordinator is lfpiv 999.0.0, and this is"), "{ended:?}");
    // The job is another worker's.
    let taken = loop {
        if let Some(taken) = queue.take().await.expect("a broker") {
            break taken;
        }
    };
    assert_eq!((taken.job.clone(), taken.attempt.issue), (job, 1));
    assert!(taken.attempt.delivery >= 2);
}

/// A coordinator that has measured its reference otherwise, as on a processor with other vector instructions.
#[tokio::test(flavor = "multi_thread")]
async fn a_worker_that_computes_otherwise_refuses() {
    let root = tempfile::tempdir().expect("a folder");
    let run = recorded(root.path());
    let nats = Nats::start(root.path());
    let real = coordinator(root.path(), &run, &nats.url(), &[]);
    let broker = Broker { url: nats.url(), ..Broker::default() };
    let queue = JobQueue::connect(&broker, "test", "").await.expect("an address");
    let taken = loop {
        match queue.take().await {
            Ok(Some(taken)) => break taken,
            _ => tokio::time::sleep(Duration::from_millis(10)).await,
        }
    };
    let mut job = taken.job.clone();
    let (address, tokens) = (job.address.clone(), job.tokens.clone());
    let get =
        move || CoordinatorClient::new(&address, &tokens).assignment().expect("a coordinator");
    let mut assignment = tokio::task::spawn_blocking(get).await.expect("an assignment");
    // The real coordinator ends, and withdraws its jobs; another one has its place.
    let ended = tokio::task::spawn_blocking(|| real.terminate()).await.expect("its end");
    assert_eq!(ended.code, Some(1), "{ended:?}");
    assignment.reference.result_sha256 = "0".repeat(64);
    let record = RecordedRun::open(&run).expect("a run");
    let packed = move |Path((segment, offset)): Path<(u32, u64)>| {
        std::future::ready(record.packed(Position { segment, offset }).expect("a record"))
    };
    let router = Router::new()
        .route("/work/v1/run", get_of(move || std::future::ready(Json(assignment.clone()))))
        .route("/work/v1/records/{segment}/{offset}", get_of(packed));
    let listener = tokio::net::TcpListener::bind("127.0.0.1:0").await.expect("a free port");
    job.address = format!("http://{}", listener.local_addr().expect("an address"));
    tokio::spawn(async { axum::serve(listener, router).await });
    job.run = "other".into();
    queue.publish(&job).await.expect("a broker");

    let (folder, url) = (root.path().to_owned(), nats.url());
    let refuses = move || worker(&folder, &url, "other", &[]).wait();
    let ended = tokio::task::spawn_blocking(refuses).await.expect("its end");
    assert_eq!(ended.code, Some(1), "{ended:?}");
    assert!(ended.stderr.contains("result for shot 0 differs from the coordinator's"), "{ended:?}");
}
