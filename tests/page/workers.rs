//! Workers of a run on the page: real ones, by way of a real NATS server.

use std::{collections::BTreeMap, fs};

use lfpiv::cluster::{Attempt, Begin, CoordinatorClient};

use crate::{
    BROWSER,
    broker::{Nats, first_job},
    daemon::{CONTROL, Daemon, READ, Scene, configuration},
    pictures,
    processes::{Process, worker},
    script::run_script,
};

/// A worker's name, and its reason: words of others.
const HOSTILE: &str = "<img src=x onerror=\"window.taken=1\">";

#[test]
fn the_page_shows_workers_and_the_shots_that_wait_for_them() {
    let _browser = BROWSER.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let folder = tempfile::tempdir().unwrap();
    let root = folder.path();
    let mut nats = Nats::start(root);
    let config = configuration(root, 0, Scene::Flow);
    let cluster = format!("\n[cluster]\nurl = \"{}\"\nheartbeat_timeout_s = 2.0\n", nats.url());
    fs::write(&config, fs::read_to_string(&config).unwrap() + &cluster).unwrap();
    let daemon = Daemon::run(&config);
    let (url, pictures) = (nats.url(), pictures().display().to_string());
    let mut workers: BTreeMap<String, Process> = BTreeMap::new();
    run_script("workers.mjs", &[&daemon.url(), READ, CONTROL, &pictures], |asked| {
        let (what, name) = asked.split_once(' ').unwrap();
        match what {
            "start" => drop(workers.insert(name.to_owned(), worker(root, &url, name, &[]))),
            "kill" => workers.remove(name).unwrap().kill(),
            "end" => assert_eq!(workers.remove(name).unwrap().terminate().code, Some(0)),
            "fail" => return fail(&url).to_string(),
            "broker" if name == "ends" => nats.kill_and_forget(),
            "broker" => nats.start_again(),
            _ => panic!("asked for {asked}"),
        }
        "done".to_owned()
    });
}

/// Fails at a shot three times, so that it is given up, and names it.
fn fail(url: &str) -> u64 {
    let job = first_job(url);
    let client = CoordinatorClient::new(&job.address, &job.tokens);
    let shot = job.shot.number;
    for delivery in 1..=3 {
        let attempt = Attempt { issue: job.issue, delivery };
        assert_eq!(client.begin(shot, attempt, HOSTILE).unwrap(), Begin::Measure);
        client.fail(shot, attempt, HOSTILE, &format!("too dark {HOSTILE}")).unwrap();
    }
    shot
}
