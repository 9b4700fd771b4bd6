//! Floods of connections to a daemon, and a check that the run has lost nothing.

use std::{
    fs,
    net::{Ipv4Addr, SocketAddr},
    os::unix::fs::PermissionsExt,
    path::{Path, PathBuf},
    time::{Duration, Instant},
};

use lfpiv::acquisition::journal::RAW_FOLDER;
use serde_json::Value;
use tokio::{
    net::{TcpSocket, TcpStream},
    runtime::Runtime,
};

use crate::bench::{PATIENCE, Running, configuration, images};

/// The usual limit of open files.
pub const OPEN_FILES: u64 = 1024;
/// Number of event streams from one address, and of requests from another.
pub const EACH: usize = 512;
/// Small segments: the log must open new ones during the flood.
pub const RAW_LOG: &str = "[raw_log]\nsegment_mb = 2\n";
const SEGMENTS: usize = 4;

/// A token of scope `read`.
pub const READ: &str = "d41f8c62b07e93a5146fe0c9837b2ad5";
const CONTROL: &str = "7be2905fc3d8416aa0f7249e5b1c63d8";

/// Connection timeout: longer than the system's first retry.
const CONNECTING: Duration = Duration::from_secs(4);

/// Source address of connections.
pub const OPERATOR: Ipv4Addr = Ipv4Addr::new(127, 0, 0, 1);
pub const OTHER: Ipv4Addr = Ipv4Addr::new(127, 0, 0, 2);

/// Open connections.
pub struct Flood {
    runtime: Runtime,
    to: SocketAddr,
    held: Vec<TcpStream>,
}

impl Flood {
    /// Without connections.
    pub fn of(running: &Running) -> Self {
        let to = running.address.trim_start_matches("http://").parse().expect("an address");
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
        Self { runtime: runtime.expect("a runtime"), to, held: Vec::new() }
    }

    /// Connects `count` times and sends `request` on each connection. A full server may refuse.
    pub fn pour(&mut self, from: Ipv4Addr, count: usize, request: &str) {
        let to = self.to;
        for _ in 0..count {
            let connecting = async {
                let socket = TcpSocket::new_v4()?;
                socket.bind(SocketAddr::from((from, 0)))?;
                let stream = socket.connect(to).await?;
                stream.writable().await?;
                stream.try_write(request.as_bytes()).map(|_| stream)
            };
            let patient = async { tokio::time::timeout(CONNECTING, connecting).await };
            match self.runtime.block_on(patient) {
                Ok(Ok(stream)) => self.held.push(stream),
                Ok(Err(_)) => {}
                // The server accepts no more, as intended.
                Err(_) => break,
            }
        }
    }
}

/// Number of files in the raw log of a run.
fn segments(run: &Path) -> usize {
    fs::read_dir(run.join(RAW_FOLDER)).expect("the raw log").count()
}

/// Waits until the log has started new segments.
pub fn wait_for_segments(running: &mut Running) {
    let (began, before) = (Instant::now(), segments(&running.folder));
    while segments(&running.folder) < before + SEGMENTS {
        let ended = running.child.try_wait().expect("a child");
        assert!(ended.is_none(), "the run has ended: {ended:?}");
        assert!(began.elapsed() < 2 * PATIENCE, "nothing is recorded any more");
        std::thread::sleep(Duration::from_millis(20));
    }
}

/// Checks that no trigger was lost; returns the number of triggers and of those with images.
pub fn assert_nothing_lost(run: &Path) -> (u64, u64) {
    let ledger = fs::read(run.join("ledger.json")).expect("a ledger");
    let ledger: Value = serde_json::from_slice(&ledger).expect("JSON");
    assert_eq!(ledger["error"], Value::Null);
    for camera in ledger["cameras"].as_array().expect("cameras") {
        let of = |outcome: &str| camera["outcomes"][outcome].as_u64().expect("a count");
        let triggers = camera["triggers"].as_u64().expect("a count");
        assert_eq!(of("complete") + of("shed"), triggers, "{camera}");
    }
    let triggers = ledger["cameras"][0]["triggers"].as_u64().expect("a count");
    (triggers, images(run).len() as u64)
}

/// A configuration with tokens, in `root`.
pub fn with_tokens(root: &Path) -> PathBuf {
    let config = configuration(root, RAW_LOG);
    let tokens = root.join("tokens");
    fs::write(&tokens, format!("read {READ}\ncontrol {CONTROL}\n")).expect("a file");
    fs::set_permissions(&tokens, PermissionsExt::from_mode(0o600)).expect("its mode");
    let text = fs::read_to_string(&config).expect("the configuration");
    let (server, named) = ("[server]\n", format!("[server]\ntokens = {tokens:?}\n"));
    fs::write(&config, text.replacen(server, &named, 1)).expect("the configuration");
    config
}

/// A request for the event stream.
pub fn stream(token: &str) -> String {
    format!(
        "GET /api/v1/events HTTP/1.1\r\nHost: localhost\r\nAuthorization: Bearer {token}\r\n\r\n"
    )
}

/// A request with an incomplete header.
pub const UNFINISHED: &str = "GET /healthz HTTP/1.1\r\nHost: localhost\r\n";

/// Sends `disarm` from the flooding address; returns how long it took.
pub fn disarm(running: &Running) -> Duration {
    let began = Instant::now();
    let agent = ureq::Agent::config_builder().timeout_global(Some(PATIENCE)).build();
    let agent: ureq::Agent = agent.into();
    let asked = agent
        .post(&format!("{}/api/v1/control/disarm", running.address))
        .header("Authorization", &format!("Bearer {CONTROL}"))
        .send_empty()
        .expect("disarm is answered");
    assert!(asked.status().is_success(), "{asked:?}");
    began.elapsed()
}
