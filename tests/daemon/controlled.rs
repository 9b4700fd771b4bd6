//! A run that is armed, started, stopped, re-timed and made safe over HTTP.

use std::{
    path::Path,
    time::{Duration, Instant},
};

use lfpiv::{
    acquisition::{
        Mode, OverloadPolicy,
        journal::{Entry, RecordedRun},
    },
    cli::daemon::{Daemon, DaemonPlan},
};
use serde_json::Value;
use tokio_util::sync::CancellationToken;

use crate::{
    bench::{CallLog, bench, configuration, quick_result},
    client::Ask,
    server::{CONTROL, with_tokens},
};

/// Only a hang takes this long.
const PATIENCE: Duration = Duration::from_secs(900);

async fn post(address: std::net::SocketAddr, path: &str, body: &str) -> Value {
    let ask = Ask::post(path).token(CONTROL);
    let ask = if body.is_empty() { ask } else { ask.json(body) };
    let answer = ask.of(address).await;
    assert_eq!(answer.status, 200, "{path}: {}", String::from_utf8_lossy(&answer.body));
    answer.json()
}

async fn until(address: std::net::SocketAddr, reached: impl Fn(&Value) -> bool) -> Value {
    let began = Instant::now();
    loop {
        let status = Ask::get("/api/v1/status").token(CONTROL).of(address).await.json();
        if reached(&status) {
            return status;
        }
        assert!(began.elapsed() < PATIENCE, "{status}");
        tokio::time::sleep(Duration::from_millis(20)).await;
    }
}

fn fired(calls: &CallLog) -> usize {
    calls.lock().iter().filter(|call| call.starts_with("fire")).count()
}

fn programmed(run: &Path) -> Vec<f64> {
    let recorded = RecordedRun::open(run).unwrap();
    let entries = recorded.entries().map(|placed| placed.unwrap().entry);
    let timings = entries.filter_map(|entry| match entry {
        Entry::Programmed { schedule, .. } => Some(schedule.dt_us),
        _ => None,
    });
    timings.collect()
}

#[tokio::test]
async fn a_run_executes_its_control_requests() {
    let root = tempfile::tempdir().unwrap();
    let mut file = configuration(root.path());
    file.config.server = with_tokens(root.path());
    file.config.server.remote_arming = true;
    let (bench, calls) = bench(&file, &[]);
    let plan = DaemonPlan {
        mode: Mode::Disarmed,
        remote_arming: true,
        ..DaemonPlan::new(file, None, OverloadPolicy::Shed)
    };
    let daemon = Daemon::prepare(plan).await.unwrap();
    let (address, folder) = (daemon.address(), daemon.folder().to_owned());
    let stop = CancellationToken::new();
    let process = || Ok(|pair: &_| Ok::<_, String>(quick_result(pair)));
    let running = tokio::spawn(daemon.run(bench, process, Box::new(|_, _| {}), stop.clone()));

    until(address, |status| status["state"] == "running").await;
    tokio::time::sleep(Duration::from_millis(300)).await;
    assert_eq!(fired(&calls), 0, "it begins with the laser safe");
    let state = post(address, "/api/v1/control/arm", "").await;
    assert_eq!(state["mode"], "armed");
    assert_eq!(fired(&calls), 0, "armed is not firing");
    post(address, "/api/v1/control/note", r#"{"text": "lamps warm"}"#).await;
    assert_eq!(post(address, "/api/v1/control/start", "").await["mode"], "firing");
    until(address, |status| status["shots"]["done"].as_u64() > Some(3)).await;
    let state = post(address, "/api/v1/control/dt", r#"{"dt_us": 150.0}"#).await;
    assert_eq!(state["dt_us"], 150.0);
    let before = until(address, |status| status["control"]["dt_us"] == 150.0).await;
    let done = before["shots"]["done"].as_u64();
    until(address, |status| status["shots"]["done"].as_u64() > done.map(|done| done + 55)).await;

    assert_eq!(post(address, "/api/v1/control/stop", "").await["mode"], "armed");
    let calls_then = calls.lock().clone();
    let last_fire = calls_then.iter().rposition(|call| call.starts_with("fire")).unwrap();
    assert!(calls_then[last_fire..].contains(&"reads back safe".to_owned()), "{calls_then:?}");
    let bursts = fired(&calls);
    assert_eq!(post(address, "/api/v1/control/disarm", "").await["mode"], "disarmed");
    tokio::time::sleep(Duration::from_millis(300)).await;
    assert_eq!(fired(&calls), bursts, "nothing is fired after that");
    let refused = Ask::post("/api/v1/control/dt").json(r#"{"dt_us": 90000.0}"#).token(CONTROL);
    assert_eq!(refused.of(address).await.status, 409, "no schedule has such a dt");

    // A frame of an old shot is read from the raw log.
    let frame = Ask::get("/api/v1/shots/0/frames/1/a.png").token(CONTROL).of(address).await;
    assert_eq!((frame.status, &frame.body[1..4]), (200, b"PNG".as_slice()));

    stop.cancel();
    let report = running.await.unwrap().unwrap();
    assert!(report.ledger.is_balanced());
    let timings = programmed(&folder);
    assert!(timings.contains(&100.0) && timings.contains(&150.0), "{timings:?}");
    let recorded = RecordedRun::open(&folder).unwrap();
    let note = |entry: Entry| matches!(entry, Entry::Note { text, .. } if text == "lamps warm");
    assert!(recorded.entries().any(|placed| note(placed.unwrap().entry)));
}
