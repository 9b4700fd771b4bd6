//! Control over HTTP, with controls that record what they receive.

use std::{
    future::Future,
    path::Path,
    pin::Pin,
    sync::Arc,
    time::{Duration, Instant},
};

use lfpiv::{
    acquisition::Ledger,
    acquisition::{Command, ControlState, Mode, Refusal},
    config::ServerSettings,
    pipeline::Board,
    server::Controls,
};
use parking_lot::Mutex;
use serde_json::{Value, json};
use tokio::net::TcpStream;

use crate::{
    client::{Answer, Ask},
    server::{CONTROL, READ, Server, with_tokens},
};

/// Executes commands, except for an impossible dt, and is slow to disarm.
pub struct Recording {
    asked: Mutex<Vec<Command>>,
    state: Mutex<ControlState>,
}

const DISARMING: Duration = Duration::from_millis(700);

impl Recording {
    pub fn new() -> Arc<Self> {
        let state = ControlState { mode: Mode::Disarmed, dt_us: 100.0, held: Vec::new() };
        Arc::new(Self { asked: Mutex::default(), state: Mutex::new(state) })
    }
}

/// The double implements the trait: a request outlives the borrow of its controls.
pub struct Bench(pub Arc<Recording>);

impl Controls for Bench {
    fn request(
        &self,
        command: Command,
    ) -> Pin<Box<dyn Future<Output = Result<ControlState, Refusal>> + Send>> {
        let bench = self.0.clone();
        Box::pin(async move {
            if command == Command::Disarm {
                tokio::time::sleep(DISARMING).await;
            }
            bench.asked.lock().push(command.clone());
            let mut state = bench.state.lock();
            match command {
                Command::SetDt { dt_us } if dt_us < 4.0 => {
                    let reasons = vec!["dt_us = 3: the exposure does not end".to_owned()];
                    return Err(Refusal { reasons });
                }
                Command::SetDt { dt_us } => state.dt_us = dt_us,
                Command::Arm => state.mode = Mode::Armed,
                Command::Start => state.mode = Mode::Firing,
                Command::Stop => state.mode = Mode::Armed,
                Command::Disarm => state.mode = Mode::Disarmed,
                Command::Resume | Command::Note { .. } => {}
            }
            Ok(state.clone())
        })
    }

    fn state(&self) -> ControlState {
        self.0.state.lock().clone()
    }
}

async fn controlled(settings: &ServerSettings, enabled_at_bench: bool) -> (Server, Arc<Recording>) {
    let recording = Recording::new();
    let bench = Arc::new(Bench(recording.clone()));
    let equip = |state: lfpiv::server::ApiState| state.with_controls(bench, enabled_at_bench);
    (Server::with(Ledger::new(2), Board::new(), settings, equip).await, recording)
}

async fn post(server: &Server, command: &str, body: Option<Value>) -> Answer {
    let ask = Ask::post(&format!("/api/v1/control/{command}")).token(CONTROL);
    let ask = match body {
        Some(body) => ask.json(&body.to_string()),
        None => ask,
    };
    ask.of(server.address).await
}

fn tokens(folder: &Path) -> ServerSettings {
    ServerSettings { remote_arming: true, ..with_tokens(folder) }
}

#[tokio::test]
async fn commands_reach_the_run_once_and_appear_as_events() {
    let folder = tempfile::tempdir().unwrap();
    let (server, bench) = controlled(&tokens(folder.path()), true).await;
    let mut modes = Vec::new();
    for (command, body) in [
        ("arm", None),
        ("dt", Some(json!({ "dt_us": 50.0 }))),
        ("start", None),
        ("note", Some(json!({ "text": "seeding raised\nto 1 ppm" }))),
        ("stop", None),
        ("disarm", None),
    ] {
        let answer = post(&server, command, body).await;
        assert_eq!(answer.status, 200, "{command}: {answer:?}");
        let state = answer.json();
        assert_eq!(state["pending"], false);
        modes.push(format!("{} {}", state["mode"].as_str().unwrap(), state["dt_us"]));
    }
    let expected =
        ["armed 100.0", "armed 50.0", "firing 50.0", "firing 50.0", "armed 50.0", "disarmed 50.0"];
    assert_eq!(modes, expected);
    let note = Command::Note { text: "seeding raised\nto 1 ppm".to_owned() };
    let commands = [
        Command::Arm,
        Command::SetDt { dt_us: 50.0 },
        Command::Start,
        note,
        Command::Stop,
        Command::Disarm,
    ];
    assert_eq!(*bench.asked.lock(), commands);
    let events = server.board.events().after(0, usize::MAX).events;
    let told = events.iter().filter(|event| event.kind.name() == "control");
    let told: Vec<Value> = told.map(|event| serde_json::from_str(&event.data).unwrap()).collect();
    assert_eq!(told.len(), 6);
    assert_eq!(told[1], json!({ "command": "set_dt", "dt_us": 50.0, "held": [], "mode": "armed" }));
    let status = Ask::get("/api/v1/status").token(READ).of(server.address).await.json();
    assert_eq!(status["control"], json!({ "mode": "disarmed", "dt_us": 50.0, "held": [] }));
    let control = Ask::get("/api/v1/control").token(READ).of(server.address).await.json();
    assert_eq!((&control["controllable"], &control["may_arm"]), (&true.into(), &true.into()));
}

#[tokio::test]
async fn a_refusal_lists_every_reason() {
    let folder = tempfile::tempdir().unwrap();
    let (server, _) = controlled(&tokens(folder.path()), true).await;
    let refused = post(&server, "dt", Some(json!({ "dt_us": 3.0 }))).await;
    assert!(refused.error(409).contains("the exposure does not end"));
    assert_eq!(refused.json()["reasons"], json!(["dt_us = 3: the exposure does not end"]));
}

#[tokio::test]
async fn without_both_permissions_http_cannot_fire_the_laser() {
    let folder = tempfile::tempdir().unwrap();
    let (server, bench) = controlled(&tokens(folder.path()), false).await;
    for command in ["arm", "start"] {
        let refused = post(&server, command, None).await;
        let error = refused.error(409);
        assert!(
            error.contains("server.remote_arming") && error.contains("at the bench"),
            "{error}"
        );
    }
    for command in ["stop", "disarm"] {
        assert_eq!(post(&server, command, None).await.status, 200);
    }
    assert_eq!(*bench.asked.lock(), [Command::Stop, Command::Disarm]);
}

#[tokio::test]
async fn invalid_commands_do_not_reach_the_run() {
    let folder = tempfile::tempdir().unwrap();
    let (server, bench) = controlled(&tokens(folder.path()), true).await;
    for (command, body, status) in [
        ("dt", json!({}), 422),
        ("dt", json!({ "dt_us": "50" }), 422),
        ("dt", json!({ "dt_us": 0.0 }), 422),
        ("dt", json!({ "dt_us": -1e300 }), 422),
        ("dt", json!({ "dt_us": 50.0, "force": true }), 422),
        // Serde would accept this for a type with one member.
        ("dt", json!([50.0]), 422),
        ("note", json!({ "text": "  " }), 422),
        ("note", json!({ "text": "a\u{0}b" }), 422),
        ("note", json!({ "text": "\u{1b}[2J" }), 422),
        ("note", json!({ "words": "x" }), 422),
    ] {
        let refused = post(&server, command, Some(body.clone())).await;
        refused.error(status);
    }
    let ask = || Ask::post("/api/v1/control/dt").token(CONTROL);
    ask().json("{\"dt_us\": 1e999}").of(server.address).await.error(400);
    ask().json("{").of(server.address).await.error(400);
    ask().of(server.address).await.error(415);
    Ask::get("/api/v1/control/arm").token(CONTROL).of(server.address).await.error(405);
    Ask::post("/api/v1/control/fire").token(CONTROL).of(server.address).await.error(404);
    assert_eq!(*bench.asked.lock(), []);
}

#[tokio::test]
async fn a_slow_request_is_completed_without_its_client() {
    let folder = tempfile::tempdir().unwrap();
    let impatient = ServerSettings { client_patience_s: 0.6, ..tokens(folder.path()) };
    let (server, bench) = controlled(&impatient, true).await;
    let began = Instant::now();
    let pending = post(&server, "disarm", None).await;
    assert_eq!((pending.status, &pending.json()["pending"]), (202, &true.into()));
    assert!(began.elapsed() < DISARMING);
    // This client disconnects right after its request.
    let ask = Ask::post("/api/v1/control/disarm").token(CONTROL).bytes(server.address);
    let mut stream = TcpStream::connect(server.address).await.unwrap();
    tokio::io::AsyncWriteExt::write_all(&mut stream, &ask).await.unwrap();
    tokio::time::sleep(Duration::from_millis(100)).await;
    drop(stream);
    // The server shuts down gracefully: it completes pending requests.
    server.stop.cancel();
    server.task.await.unwrap();
    assert_eq!(*bench.asked.lock(), [Command::Disarm, Command::Disarm]);
}
