//! SIGKILL for workers, the broker and the coordinator.

use std::{fs, path::Path, time::Duration};

use crate::{
    broker::Nats,
    dying::DyingWorkers,
    processes::{coordinator, wait_until, worker},
    proxy::Proxy,
    recorded::{SHOTS, assert_as_on_one_machine, recorded, recorded_otherwise, stored_so_far},
};

pub const KILLS: usize = 20;
/// A lost worker's shot goes to another one soon.
const SOON: [&str; 2] = ["--heartbeat-timeout", "1"];

#[test]
fn no_shot_is_lost_with_workers_or_the_broker() {
    no_shot_is_lost(20);
}

#[test]
#[ignore = "long: make soak"]
fn long_no_shot_is_lost_with_workers_or_the_broker_in_ten_runs() {
    (100..110).for_each(no_shot_is_lost);
}

/// Whenever another result is stored, a worker dies at some moment, and another one comes.
fn no_shot_is_lost(seed: u64) {
    let root = tempfile::tempdir().expect("a folder");
    let run = recorded(root.path());
    let mut nats = Nats::start(root.path());
    let url = nats.url();
    let mut workers = DyingWorkers::start(root.path(), &url, seed);
    let mut coordinator = coordinator(root.path(), &run, &nats.url(), &SOON);
    for kill in 0..KILLS {
        // Progress between the kills, at any speed: or the same shot could die ten times.
        wait_until("another result", || {
            !coordinator.is_running() || stored_so_far(&run) > kill.min(SHOTS - 1)
        });
        workers.kill_one();
        if kill == KILLS / 2 {
            nats.kill_and_forget();
            workers.pause(300);
            nats.start_again();
        }
    }
    let ended = coordinator.wait();
    assert_eq!(ended.code, Some(0), "{ended:?}");
    assert_as_on_one_machine(&run);
    assert!(ended.stdout.contains("0 results refused"), "{ended:?}");
    println!("{}", ended.stdout);
}

/// Bytes in the log of delivered results.
fn delivered_bytes(run: &Path) -> u64 {
    let log = fs::read_dir(run.join("delivered/000000")).into_iter().flatten();
    log.map(|file| file.expect("a file").metadata().map_or(0, |file| file.len())).sum()
}

#[test]
fn a_killed_coordinator_goes_on_with_what_was_delivered() {
    let root = tempfile::tempdir().expect("a folder");
    let run = recorded(root.path());
    let nats = Nats::start(root.path());
    let _workers = ["one", "two"].map(|name| worker(root.path(), &nats.url(), name, &[]));
    let killed = coordinator(root.path(), &run, &nats.url(), &SOON);
    // Results of this bench have some 2 kB.
    wait_until("results in the log", || delivered_bytes(&run) > 10_000);
    killed.kill();

    let ended = coordinator(root.path(), &run, &nats.url(), &SOON).wait();
    assert_eq!(ended.code, Some(0), "{ended:?}");
    assert!(ended.stderr.contains("delivered to an earlier coordinator are stored"), "{ended:?}");
    assert_as_on_one_machine(&run);
}

#[test]
fn a_coordinator_that_is_told_to_stop_goes_on_later() {
    let root = tempfile::tempdir().expect("a folder");
    let run = recorded(root.path());
    let nats = Nats::start(root.path());
    let alone = coordinator(root.path(), &run, &nats.url(), &["--status", "127.0.0.1:0"]);
    wait_until("jobs without workers", || alone.log().contains("open shots are offered"));
    let log = alone.log();
    let shown = log.split_whitespace().find(|word| word.ends_with("/api/v1/status"));
    let shown = shown.expect("an address");
    let status: serde_json::Value =
        ureq::get(shown).call().expect("an answer").body_mut().read_json().expect("JSON");
    assert_eq!(status["cluster"]["shots"]["backlog"], SHOTS - 1, "{status}");
    assert_eq!(status["cluster"]["connected"], true, "{status}");
    let metrics = shown.replace("/api/v1/status", "/metrics");
    let mut metrics = ureq::get(metrics).call().expect("an answer");
    let metrics = metrics.body_mut().read_to_string().expect("text");
    assert!(metrics.contains(&format!("lfpiv_cluster_backlog_shots {}", SHOTS - 1)), "{metrics}");
    let elsewhere = ureq::get(shown).header("Host", "example.org").call();
    assert!(matches!(elsewhere, Err(ureq::Error::StatusCode(421))), "{elsewhere:?}");
    let ended = alone.terminate();
    assert_eq!(ended.code, Some(1), "{ended:?}");
    assert!(ended.stderr.contains("39 shots without a result remain"), "{ended:?}");
    assert!(ended.stdout.contains("1 have one now"), "{ended:?}");

    // Nobody has jobs of it any more, and the broker may be gone for a while.
    let mut nats = nats;
    nats.kill_and_forget();
    let waiting = coordinator(root.path(), &run, &nats.url(), &[]);
    let _worker = worker(root.path(), &nats.url(), "one", &[]);
    wait_until("no broker", || {
        waiting.log().contains("no connection") || waiting.log().contains("it is tried again")
    });
    nats.start_again();
    let ended = waiting.wait();
    assert_eq!(ended.code, Some(0), "{ended:?}");
    assert_as_on_one_machine(&run);
}

/// The network between the workers and the broker is cut for 10 s, a worker and the coordinator stand still for a while.
#[test]
fn a_cut_network_and_processes_that_stand_still_cost_time_only() {
    let root = tempfile::tempdir().expect("a folder");
    let run = recorded(root.path());
    let nats = Nats::start(root.path());
    let network = Proxy::to(nats.port());
    let workers =
        ["one", "two", "three"].map(|name| worker(root.path(), &network.url(), name, &[]));
    let mut coordinator = coordinator(root.path(), &run, &nats.url(), &SOON);
    let mut has = |shots: usize| {
        wait_until("results", || !coordinator.is_running() || stored_so_far(&run) >= shots);
    };
    has(5);
    // It has a shot in hand, perhaps, which goes to another one; its own result comes too late.
    workers[0].signal("STOP");
    has(12);
    network.cut();
    std::thread::sleep(Duration::from_secs(10));
    network.mend();
    workers[0].signal("CONT");
    has(20);
    coordinator.signal("STOP");
    std::thread::sleep(Duration::from_secs(2));
    coordinator.signal("CONT");
    let ended = coordinator.wait();
    assert_eq!(ended.code, Some(0), "{ended:?}");
    assert_as_on_one_machine(&run);
    for worker in workers {
        let ended = worker.terminate();
        assert_eq!(ended.code, Some(0), "{ended:?}");
    }
}

/// The jobs of a coordinator that was killed do not hold up those of another one.
#[test]
fn jobs_that_nobody_waits_for_are_left_alone() {
    let root = tempfile::tempdir().expect("a folder");
    let run = recorded(root.path());
    let nats = Nats::start(root.path());
    let dead = coordinator(root.path(), &run, &nats.url(), &[]);
    wait_until("jobs", || dead.log().contains("open shots are offered"));
    dead.kill();
    let _worker = worker(root.path(), &nats.url(), "one", &[]);
    let other = recorded_otherwise(&root.path().join("bench"), ("seed = 1", "seed = 6"), 5);
    let ended = coordinator(root.path(), &other, &nats.url(), &[]).wait();
    assert_eq!(ended.code, Some(0), "{ended:?}");
    assert!(ended.stdout.contains("one: 4 shots"), "{ended:?}");
}
