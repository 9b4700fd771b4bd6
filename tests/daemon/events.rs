//! Event streams: complete, resumable, and without effect on the run.

use std::{net::SocketAddr, num::NonZeroU64, sync::Arc, time::Duration};

use lfpiv::{
    acquisition::{Ledger, Outcome, OverloadPolicy},
    archive::ShotResult,
    cli::daemon::{Daemon, DaemonPlan},
    config::ServerSettings,
    pipeline::{Board, EVENTS_IN_MEMORY, EventKind, ShotRecord, Watermarks},
    server::Phase,
};
use lfpiv_core::lightfield::ImagePair;
use serde_json::Value;
use tokio::{
    io::{AsyncBufReadExt, AsyncWriteExt, BufReader, Lines},
    net::TcpStream,
};
use tokio_util::sync::CancellationToken;

use crate::{
    bench::{bench, configuration, quick_result},
    client::Ask,
    server::{Server, settings},
};

/// One received event.
#[derive(Debug, Clone, PartialEq)]
pub struct ReceivedEvent {
    pub name: String,
    pub id: Option<String>,
    pub data: Value,
}

/// An open event stream.
pub struct Watch {
    lines: Lines<BufReader<TcpStream>>,
}

impl Watch {
    pub async fn open(address: SocketAddr, last_id: Option<&str>) -> Self {
        let ask = Ask::get("/api/v1/events");
        let ask = match last_id {
            Some(id) => ask.with("Last-Event-ID", id),
            None => ask,
        };
        let mut stream = TcpStream::connect(address).await.unwrap();
        stream.write_all(&ask.bytes(address)).await.unwrap();
        let mut lines = BufReader::new(stream).lines();
        let status = lines.next_line().await.unwrap().unwrap();
        assert!(status.contains("200"), "{status}");
        Self { lines }
    }

    /// The next event; `None` when the server has ended the stream.
    pub async fn next(&mut self) -> Option<ReceivedEvent> {
        let (mut name, mut id) = (None, None);
        loop {
            let line = self.lines.next_line();
            let line = tokio::time::timeout(Duration::from_secs(30), line).await.expect("silence");
            let line = line.ok().flatten()?;
            // Chunk sizes, comments and headers are skipped.
            if let Some(text) = line.strip_prefix("event: ") {
                name = Some(text.to_owned());
            } else if let Some(text) = line.strip_prefix("id: ") {
                id = Some(text.to_owned());
            } else if let Some(text) = line.strip_prefix("data: ") {
                // The data is the last line of an event.
                let data = serde_json::from_str(text).unwrap();
                return Some(ReceivedEvent { name: name.unwrap(), id, data });
            }
        }
    }

    async fn names(&mut self, count: usize) -> Vec<String> {
        let mut names = Vec::new();
        for _ in 0..count {
            names.push(self.next().await.unwrap().name);
        }
        names
    }
}

const SHOTS: u64 = 60;
const STREAMS: usize = 200;

#[tokio::test(flavor = "multi_thread")]
async fn two_hundred_streams_see_every_shot_and_the_run_loses_none() {
    let root = tempfile::tempdir().unwrap();
    let mut file = configuration(root.path());
    file.config.server = settings();
    file.config.server.guests = 2 * STREAMS;
    let plan = DaemonPlan::new(file, NonZeroU64::new(SHOTS), OverloadPolicy::Wait);
    let (instruments, _) = bench(&plan.file, &[]);
    let daemon = Daemon::prepare(plan).await.unwrap();
    let address = daemon.address();
    let opened = Arc::new(tokio::sync::Barrier::new(STREAMS + 1));
    let watchers: Vec<_> = (0..STREAMS)
        .map(|_| {
            let opened = opened.clone();
            tokio::spawn(async move {
                let mut watch = Watch::open(address, None).await;
                let first = watch.next().await.unwrap();
                assert_eq!(first.name, "status");
                opened.wait().await;
                let mut told = vec![first];
                while let Some(event) = watch.next().await {
                    told.push(event);
                }
                told
            })
        })
        .collect();
    // The run begins when all streams are open.
    let (begin, begun) = std::sync::mpsc::channel();
    tokio::spawn(async move {
        opened.wait().await;
        begin.send(()).unwrap();
    });
    let processor = move || {
        begun.recv_timeout(Duration::from_secs(30))?;
        Ok(|pair: &ImagePair| Ok::<_, String>(quick_result(pair)))
    };
    let observer = Box::new(|_: &ShotRecord, _: Option<&ShotResult>| {});
    let report =
        daemon.run(instruments, processor, observer, CancellationToken::new()).await.unwrap();
    for account in report.ledger.accounts() {
        assert_eq!((account.triggers, account.outcomes.of(Outcome::Complete)), (SHOTS, SHOTS));
    }
    for watcher in watchers {
        let told = watcher.await.unwrap();
        for name in ["shot", "result"] {
            let shots = told.iter().filter(|event| event.name == name);
            let shots: Vec<u64> = shots.map(|event| event.data["shot"].as_u64().unwrap()).collect();
            assert_eq!(shots, (0..SHOTS).collect::<Vec<_>>(), "{name}");
        }
        assert!(told.iter().all(|event| event.name != "missed"));
        let last = told.last().unwrap();
        assert_eq!((last.name.as_str(), &last.data["state"]), ("status", &"finished".into()));
        assert_eq!(last.data["shots"]["done"], SHOTS);
    }
}

#[tokio::test]
async fn a_stream_begins_with_the_status_and_resumes_after_the_last_event() {
    let server = Server::start(Ledger::new(2), Board::new()).await;
    server.board.failed(1, "dark".to_owned());
    let mut watch = Watch::open(server.address, None).await;
    let present = watch.next().await.unwrap();
    assert_eq!((present.name.as_str(), &present.data["state"]), ("status", &"running".into()));
    // The failed shot also changes the status, which is published at the next check or was
    // published before.
    for shot in 2..5 {
        server.board.failed(shot, "dark".to_owned());
    }
    let mut seen = watch.next().await.unwrap();
    while seen.data["shot"] != 2 {
        assert_eq!(seen.name, "status");
        seen = watch.next().await.unwrap();
    }
    drop(watch);
    let mut again = Watch::open(server.address, seen.id.as_deref()).await;
    let mut shots = Vec::new();
    while shots.len() < 2 {
        let event = again.next().await.unwrap();
        assert_ne!(event.name, "missed");
        shots.extend(event.data["shot"].as_u64());
    }
    assert_eq!(shots, [3, 4]);
}

#[tokio::test]
async fn events_that_cannot_be_resumed_are_reported_as_missed() {
    let server = Server::start(Ledger::new(2), Board::new()).await;
    for id in ["4bf92f-17", "nonsense", "", "-", "1-1-1"] {
        let mut watch = Watch::open(server.address, Some(id)).await;
        let first = watch.next().await.unwrap();
        assert_eq!((first.name.as_str(), &first.data["missed"]), ("missed", &Value::Null), "{id}");
        assert_eq!(watch.next().await.unwrap().name, "status");
    }
    let first_id = Watch::open(server.address, None).await.next().await.unwrap().id.unwrap();
    let (run, at) = first_id.split_once('-').unwrap();
    let at: u64 = at.parse().unwrap();
    for shot in 0..EVENTS_IN_MEMORY as u64 + 50 {
        server.board.failed(shot, "dark".to_owned());
    }
    let mut late = Watch::open(server.address, Some(&first_id)).await;
    let missed = late.next().await.unwrap();
    assert_eq!(missed.name, "missed");
    let next = late.next().await.unwrap();
    let next_id = next.id.unwrap();
    let (next_run, next_at) = next_id.split_once('-').unwrap();
    assert_eq!(next_run, run);
    let next_at: u64 = next_at.parse().unwrap();
    assert_eq!(missed.data["missed"], next_at - at - 1, "no event is neither told nor counted");
    // An id in the future counts as the last one.
    let mut early = Watch::open(server.address, Some(&format!("{run}-{}", u64::MAX))).await;
    server.board.failed(99_999, "dark".to_owned());
    let event = early.next().await.unwrap();
    assert!(event.data["shot"] == 99_999 || event.name == "status", "{event:?}");
}

#[tokio::test(flavor = "multi_thread")]
async fn a_reader_that_does_not_read_delays_nobody_and_misses_events() {
    // For a busy machine that reads the streams late.
    let server = Server::empty(&ServerSettings { client_patience_s: 600.0, ..settings() }).await;
    let mut slow = Watch::open(server.address, None).await;
    let mut quick = Watch::open(server.address, None).await;
    assert_eq!(slow.next().await.unwrap().name, "status");
    // More than all buffers between server and client can hold.
    let (long, count) = ("x".repeat(16_000), 2 * EVENTS_IN_MEMORY);
    for shot in 0..count as u64 {
        server.board.failed(shot, long.clone());
        if shot % 64 == 0 {
            tokio::task::yield_now().await;
        }
    }
    // If publishing waited for the slow reader, this line would not be reached.
    server.state.set_phase(Phase::Finished);
    server.stop.cancel();
    let read = |mut watch: Watch| async move {
        let (mut shots, mut missed, mut last) = (0, 0, None);
        while let Some(event) = watch.next().await {
            match event.name.as_str() {
                "shot" => shots += 1,
                "missed" => missed += event.data["missed"].as_u64().unwrap(),
                _ => {}
            }
            last = Some(event);
        }
        (shots, missed, last.unwrap())
    };
    assert_eq!(quick.names(1).await, ["status"]);
    for watch in [slow, quick] {
        let (shots, missed, last) = read(watch).await;
        assert!(missed > 0, "{shots} shots came");
        assert!(shots >= EVENTS_IN_MEMORY as u64 - 1);
        assert!(shots + missed >= count as u64);
        assert_eq!(last.data["state"], "finished");
    }
    server.task.await.unwrap();
}

#[tokio::test]
async fn phases_and_watermarks_are_published() {
    let server = Server::start(Ledger::new(2), Board::new()).await;
    let mut watch = Watch::open(server.address, None).await;
    assert_eq!(watch.next().await.unwrap().data["watermarks"], Value::Null);
    let marks = Watermarks { acquired: 9, paired: 8, written: 7, fsynced: 6, processed: 5 };
    server.board.set_watermarks(marks);
    let told = watch.next().await.unwrap();
    assert_eq!((told.name.as_str(), &told.data["fsynced"]), ("watermarks", &6.into()));
    let status = watch.next().await.unwrap();
    assert_eq!(
        (status.name.as_str(), &status.data["watermarks"]["written"]),
        ("status", &7.into())
    );
    assert_eq!(server.get("/api/v1/status").await.json()["watermarks"]["processed"], 5);
    server.state.set_phase(Phase::Failed("cam1: gone".to_owned()));
    assert_eq!(watch.next().await.unwrap().data["error"], "cam1: gone");
    assert!(EventKind::ALL.iter().any(|kind| kind.name() == "watermarks"));
}
