//! The bench page in a real browser: Debian's Chromium, driven by the scripts in `web/bench/test`. `make page-tools`
//! installs what they need. Pictures of the views are left in `target/page`.

// All of this crate is test; clippy's exception covers only the functions marked as such.
#![allow(clippy::unwrap_used)]

#[path = "../recorded_run/bench.rs"]
#[allow(dead_code, reason = "not every program needs all of it")]
mod bench;
#[path = "../support/body.rs"]
mod body;
#[path = "../cluster/broker.rs"]
#[allow(dead_code, reason = "not every program needs all of it")]
mod broker;
mod built;
mod daemon;
mod fed;
mod placed;
#[path = "../cluster/processes.rs"]
#[allow(dead_code, reason = "not every program needs all of it")]
mod processes;
mod script;
mod served;
mod statistics;
mod workers;

use std::{path::PathBuf, sync::Mutex};

use daemon::{Daemon, Scene};
use script::{page_folder, run_script};

/// One browser at a time: two would wait for each other's processors.
static BROWSER: Mutex<()> = Mutex::new(());

/// Where the pictures go.
fn pictures() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("target/page")
}

#[test]
fn the_page_shows_a_run_and_controls_it() {
    let _browser = BROWSER.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let folder = tempfile::tempdir().unwrap();
    let mut daemon = Daemon::start(folder.path(), 0, Scene::Body);
    let port = daemon.port;
    let pictures = pictures().display().to_string();
    let arguments = [&daemon.url(), daemon::READ, daemon::CONTROL, &pictures];
    run_script("live.mjs", &arguments, |asked| match asked {
        "kill" => {
            daemon.kill();
            "killed".to_owned()
        }
        "start" => {
            daemon = Daemon::start(folder.path(), port, Scene::Body);
            "started".to_owned()
        }
        other => panic!("asked for {other}"),
    });
}

#[test]
fn a_foreign_page_neither_frames_nor_reads_nor_controls() {
    let _browser = BROWSER.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let folder = tempfile::tempdir().unwrap();
    let daemon = Daemon::start(folder.path(), 0, Scene::Body);
    run_script("foreign.mjs", &[&daemon.url(), daemon::CONTROL], |asked| {
        panic!("asked for {asked}")
    });
    let status = daemon.get("/api/v1/status");
    assert_eq!(status["control"]["mode"], "firing", "nobody has stopped it");
}

/// The numerics of the page, without a browser.
#[test]
fn the_page_reckons_right() {
    run_script("numbers.mjs", &[], |asked| panic!("asked for {asked}"));
}

#[test]
fn the_tools_are_named_once() {
    let lock = std::fs::read_to_string(page_folder().join("package-lock.json")).unwrap();
    assert!(lock.contains("\"integrity\": \"sha512-"), "packages are pinned by their checksums");
    assert!(!lock.contains("\"resolved\""), "the lock file names no place of this machine");
}
