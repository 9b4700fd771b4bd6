//! The server alone, for a run that does not change.

use std::{
    net::SocketAddr,
    os::unix::fs::PermissionsExt,
    path::{Path, PathBuf},
    sync::Arc,
};

use lfpiv::{
    acquisition::{Journal, Ledger},
    config::ServerSettings,
    pipeline::Board,
    server::{ApiState, ConfigurationSummary, Phase, Protection, RunInfo, serve},
};
use parking_lot::Mutex;
use serde_json::Value;
use tokio::{net::TcpListener, task::JoinHandle};
use tokio_util::sync::CancellationToken;

use crate::client::{Answer, get};

pub const READ: &str = "9c27d5f01ab8463e70c1f94d2e58b6a3";
pub const CONTROL: &str = "Zr8+qT1/vXo2Lk9wBe5HdM==";

pub struct Server {
    pub address: SocketAddr,
    pub state: ApiState,
    pub board: Arc<Board>,
    pub stop: CancellationToken,
    pub task: JoinHandle<()>,
}

/// Settings with which the rate limit affects no test.
pub fn settings() -> ServerSettings {
    let mut settings = ServerSettings::default();
    settings.address.set_port(0);
    settings.requests_per_s = 1e5;
    settings
}

/// Settings with one token per scope, in a file in `folder`.
pub fn with_tokens(folder: &Path) -> ServerSettings {
    let path = folder.join("tokens");
    std::fs::write(&path, format!("# lab\nread {READ}\ncontrol {CONTROL}\n")).unwrap();
    std::fs::set_permissions(&path, PermissionsExt::from_mode(0o600)).unwrap();
    ServerSettings { tokens: Some(path), ..settings() }
}

fn info() -> RunInfo {
    RunInfo {
        code_version: "0.0.0".to_owned(),
        model: "thin lens".to_owned(),
        solver: "os-mart".to_owned(),
        configuration: ConfigurationSummary {
            calibrations: Vec::new(),
            file: PathBuf::from("bench.toml"),
            simulated: true,
            cameras: vec!["cam1".to_owned(), "cam2".to_owned()],
            mask: None,
            voxels_xyz: [3, 2, 1],
            voxel_mm: 0.1,
            centre_mm: [0.0; 3],
            max_displacement_vox: 2.0,
            window_mm: 1.6,
            place_particles: true,
            dt_us: 100.0,
            rate_hz: 10.0,
            shots: None,
            overload: "shed".to_owned(),
            queue: 4,
        },
        results_dir: PathBuf::from("/data/run-1"),
        paraview: true,
    }
}

impl Server {
    pub async fn start(ledger: Ledger, board: Board) -> Self {
        Self::with(ledger, board, &settings(), |state| state).await
    }

    /// A server of an empty run with these settings.
    pub async fn empty(settings: &ServerSettings) -> Self {
        Self::with(Ledger::new(2), Board::new(), settings, |state| state).await
    }

    pub async fn with(
        ledger: Ledger,
        board: Board,
        settings: &ServerSettings,
        equip: impl FnOnce(ApiState) -> ApiState,
    ) -> Self {
        let board = Arc::new(board);
        let state = equip(ApiState::new(
            info(),
            Arc::new(Mutex::new(ledger)),
            board.clone(),
            Journal::none(),
        ));
        state.set_phase(Phase::Running);
        let protection = Protection::open(settings).unwrap();
        let listener = TcpListener::bind(settings.address).await.unwrap();
        let (address, stop) = (listener.local_addr().unwrap(), CancellationToken::new());
        let task = tokio::spawn(serve(listener, state.clone(), protection, stop.clone()));
        Self { address, state, board, stop, task }
    }

    pub async fn get(&self, path: &str) -> Answer {
        get(self.address, path).await
    }

    pub async fn assert_error(&self, path: &str, status: u16, words: &str) -> Value {
        let answer = self.get(path).await;
        let error = answer.error(status);
        assert!(error.contains(words), "{path}: {error}");
        answer.json()
    }
}
