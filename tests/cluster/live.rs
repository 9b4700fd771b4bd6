//! Workers that measure the shots of a run while it goes on.

use std::{
    fs,
    path::{Path, PathBuf},
    time::Duration,
};

use serde_json::Value;

use crate::{
    bench::{configuration, lfpiv, text},
    broker::Nats,
    dying::DyingWorkers,
    killed::KILLS,
    processes::{Process, coordinator, path, wait_until, worker},
    proxy::Proxy,
    recorded::{MODEL, assert_same, copied, remove_results, stored_so_far},
};

const SHOTS: u64 = 40;
/// How long the network is cut after that was noticed.
const CUT: Duration = Duration::from_secs(3);

/// A running `lfpiv run` with a broker.
struct Run {
    process: Process,
    folder: PathBuf,
    address: String,
}

impl Run {
    fn start(root: &Path, url: &str, more: &[&str]) -> Self {
        let cluster = format!("{MODEL}\n[cluster]\nurl = \"{url}\"\nheartbeat_timeout_s = 1.0");
        let config = configuration(root, &cluster);
        let process = Process::start(root, &[&["run", "--config", path(&config)], more].concat());
        let line = |name: &str| {
            let output = process.output();
            let line = output.lines().find_map(|line| line.strip_prefix(name));
            line.map(|line| line.trim().to_owned())
        };
        wait_until("the run has begun", || line("workers:").is_some());
        let address = line("status:").expect("an address").replace("/api/v1/status", "");
        Self { folder: line("results:").expect("a folder").into(), address, process }
    }

    fn status(&self) -> Value {
        ureq::get(format!("{}/api/v1/status", self.address))
            .call()
            .expect("an answer")
            .body_mut()
            .read_json()
            .expect("JSON")
    }

    /// Whether a worker has a shot in hand.
    fn has_in_hand(&self, worker: &str) -> bool {
        let status = self.status();
        let workers = status["cluster"]["workers"].as_array().expect("workers");
        let of = workers.iter().find(|of| of["worker"] == worker);
        of.is_some_and(|of| of["in_hand"].as_u64() >= Some(1))
    }

    fn metrics(&self) -> String {
        let mut answer = ureq::get(format!("{}/metrics", self.address)).call().expect("an answer");
        answer.body_mut().read_to_string().expect("text")
    }

    fn has(&self, shots: usize) {
        wait_until("results", || stored_so_far(&self.folder) >= shots);
    }
}

/// The same record measured by one machine.
fn measured_alone(run: &Path, to: &Path) -> PathBuf {
    let alone = copied(run, to);
    remove_results(&alone);
    let output = lfpiv(&["process", path(&alone)]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    alone
}

#[test]
fn a_run_goes_on_without_a_broker_and_every_shot_is_measured_once() {
    let root = tempfile::tempdir().expect("a folder");
    let mut nats = Nats::start(root.path());
    nats.kill_and_forget();
    let run = Run::start(root.path(), &nats.url(), &["--shots", &SHOTS.to_string()]);
    wait_until("all shots are recorded", || run.status()["watermarks"]["fsynced"] == SHOTS);
    assert!(run.process.log().contains("recording continues"), "{}", run.process.log());
    // The daemon has measured the shot that decides the forward model.
    wait_until("the others wait", || run.status()["cluster"]["shots"]["backlog"] == SHOTS - 1);
    assert_eq!(run.status()["cluster"]["connected"], false);
    assert_eq!(run.status()["cluster"]["workers"], Value::Array(Vec::new()));
    assert!(run.metrics().contains("lfpiv_cluster_broker_up 0"), "{}", run.metrics());

    nats.start_again();
    let shared = ["--shared", path(&run.folder)];
    let workers: [&[&str]; 3] = [&shared, &[], &["--slots", "2"]];
    let [one, two, three] = ["one", "two", "three"].map(|name| name.to_owned());
    let mut workers: Vec<Process> = [&one, &two, &three]
        .iter()
        .zip(workers)
        .map(|(name, more)| worker(root.path(), &nats.url(), name, more))
        .collect();
    run.has(8);
    let status = run.status();
    let cluster = &status["cluster"];
    assert_eq!(cluster["connected"], true, "{cluster}");
    assert!(cluster["shots_per_s"].as_f64().expect("a rate") > 0.0, "{cluster}");
    let first = &cluster["workers"][0];
    assert!(first["worker"].is_string() && first["shots"].is_u64(), "{cluster}");
    assert!(run.metrics().contains("lfpiv_cluster_worker_shots_total{worker=\""));
    workers.swap_remove(1).kill();
    run.has(16);
    nats.kill_and_forget();
    nats.start_again();

    let folder = run.folder.clone();
    let ended = run.process.wait();
    assert_eq!(ended.code, Some(0), "{ended:?}");
    assert!(ended.stdout.contains("0 results refused"), "{ended:?}");
    println!("{}", ended.stdout);
    let ledger = fs::read_to_string(folder.join("ledger.json")).expect("a ledger");
    let ledger: Value = serde_json::from_str(&ledger).expect("JSON");
    assert_eq!(ledger["cameras"][0]["outcomes"]["complete"], SHOTS, "{ledger}");
    assert_same(&measured_alone(&folder, &root.path().join("alone")), &folder);
    for worker in workers {
        assert_eq!(worker.terminate().code, Some(0));
    }
}

/// Workers die at random moments, and the network between all of them and the broker is cut for some seconds.
#[test]
fn no_shot_of_a_run_that_goes_on_is_lost_with_workers_or_the_network() {
    let root = tempfile::tempdir().expect("a folder");
    let nats = Nats::start(root.path());
    let network = Proxy::to(nats.port());
    let url = network.url();
    let run = Run::start(root.path(), &url, &["--shots", &SHOTS.to_string()]);
    let mut workers = DyingWorkers::start(root.path(), &url, 21);
    for kill in 0..KILLS {
        // Progress between the kills, at any speed: or the same shot could die ten times.
        run.has(kill + 1);
        match kill {
            // One at least dies over a shot, at any speed.
            0 => workers.kill_one_over_a_shot(|name| run.has_in_hand(name)),
            _ => workers.kill_one(),
        }
        if kill == KILLS / 2 {
            network.cut();
            wait_until("the cut is noticed", || run.status()["cluster"]["connected"] == false);
            workers.kill_one();
            std::thread::sleep(CUT);
            network.mend();
        }
    }
    let folder = run.folder.clone();
    let ended = run.process.wait();
    assert_eq!(ended.code, Some(0), "{ended:?}");
    assert!(ended.stdout.contains("0 results refused"), "{ended:?}");
    // Handed out again, and so reported.
    let reported = ended.stdout.lines().find(|line| line.contains(" measurements started, "));
    let numbers = reported.expect("a report").split(' ').filter_map(|word| word.parse().ok());
    let numbers: Vec<u64> = numbers.collect();
    println!("{}", reported.expect("a report"));
    let [begun, not_ended, ..] = numbers[..] else { panic!("{ended:?}") };
    assert!(not_ended >= 1 && begun >= SHOTS - 1 + not_ended, "{ended:?}");
    let ledger = fs::read_to_string(folder.join("ledger.json")).expect("a ledger");
    let ledger: Value = serde_json::from_str(&ledger).expect("JSON");
    for camera in ledger["cameras"].as_array().expect("cameras") {
        assert_eq!(camera["outcomes"]["complete"], SHOTS, "{ledger}");
    }
    assert_same(&measured_alone(&folder, &root.path().join("alone")), &folder);
}

/// The daemon is killed in the middle of an endless run.
#[test]
fn a_killed_run_is_finished_with_what_was_delivered() {
    let root = tempfile::tempdir().expect("a folder");
    let nats = Nats::start(root.path());
    let _workers = ["one", "two"].map(|name| worker(root.path(), &nats.url(), name, &[]));
    let run = Run::start(root.path(), &nats.url(), &[]);
    run.has(10);
    let folder = run.folder.clone();
    run.process.kill();
    let ended = coordinator(root.path(), &folder, &nats.url(), &[]).wait();
    assert_eq!(ended.code, Some(0), "{ended:?}");
    assert!(ended.stderr.contains("delivered to an earlier coordinator are stored"), "{ended:?}");
    assert_same(&measured_alone(&folder, &root.path().join("alone")), &folder);
}

/// Shots that nobody has measured at the end of a run are left to `lfpiv process`.
#[test]
fn a_run_that_is_told_to_stop_leaves_the_backlog_on_disk() {
    let root = tempfile::tempdir().expect("a folder");
    let nats = Nats::start(root.path());
    let run = Run::start(root.path(), &nats.url(), &[]);
    // Before a shot has decided the forward model, nothing is published, and there is nothing to report.
    run.has(1);
    wait_until("a backlog", || run.status()["cluster"]["shots"]["backlog"].as_u64() >= Some(5));
    let folder = run.folder.clone();
    let ended = run.process.terminate();
    assert_eq!(ended.code, Some(0), "{ended:?}");
    assert!(ended.stdout.contains("shots were not measured yet: lfpiv process"), "{ended:?}");
    assert!(ended.stdout.contains("0 measurements started"), "{ended:?}");

    let _worker = worker(root.path(), &nats.url(), "one", &[]);
    let ended = coordinator(root.path(), &folder, &nats.url(), &[]).wait();
    assert_eq!(ended.code, Some(0), "{ended:?}");
    assert_same(&measured_alone(&folder, &root.path().join("alone")), &folder);
}
