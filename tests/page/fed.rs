//! The server alone, fed with more shots than any bench gives, and with words that would like to be markup.

use std::{path::PathBuf, sync::Arc, time::Duration};

use lfpiv::{
    acquisition::{Journal, Ledger, Outcome},
    archive::ShotResult,
    config::ServerSettings,
    pipeline::Board,
    server::{
        ApiState, CalibrationSummary, ConfigurationSummary, Phase, Protection, RunInfo, serve,
    },
};
use lfpiv_core::velocimetry::{
    MeasuredParticle, PairResult, StageSeconds, VectorGrid, VectorStatus, VelocityField,
};
use parking_lot::Mutex;
use tokio::{net::TcpListener, runtime::Runtime};
use tokio_util::sync::CancellationToken;

use crate::{BROWSER, script::run_script};

const HOSTILE: &str = "<img src=x onerror=\"window.taken=1\"><script>window.taken=1</script>";
/// The hash of a calibration file.
const CALIBRATION: &str = "f0e4c2f76c58916ec258f246851bea091d14d4247a2fc3e18694461b1816e13b";
/// Shots fed at once, and the pause behind them: the log of events holds 2048.
const AT_ONCE: u64 = 200;
const PAUSE: Duration = Duration::from_millis(60);

#[test]
fn five_thousand_shots_leave_nothing_behind() {
    let _browser = BROWSER.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    feed(5000);
}

/// A day at some hertz.
#[test]
#[ignore = "takes many minutes: make soak"]
fn long_a_day_of_shots_leaves_nothing_behind() {
    let _browser = BROWSER.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    feed(288_000);
}

fn feed(shots: u64) {
    let runtime = Runtime::new().unwrap();
    let mut feeder = Feeder::new(&runtime);
    let (url, shots) = (feeder.url.clone(), shots.to_string());
    run_script("fed.mjs", &[&url, &shots, CALIBRATION], |asked| {
        let count = asked.strip_prefix("feed ").unwrap().parse().unwrap();
        feeder.feed(count);
        (feeder.next - 1).to_string()
    });
}

struct Feeder {
    url: String,
    board: Arc<Board>,
    ledger: Arc<Mutex<Ledger>>,
    next: u64,
    stop: CancellationToken,
}

impl Feeder {
    fn new(runtime: &Runtime) -> Self {
        let mut settings = ServerSettings::default();
        settings.address.set_port(0);
        settings.requests_per_s = 1e5;
        let (board, ledger) = (Arc::new(Board::new()), Arc::new(Mutex::new(Ledger::new(2))));
        let state = ApiState::new(info(), ledger.clone(), board.clone(), Journal::none());
        state.set_phase(Phase::Running);
        let protection = Protection::open(&settings).unwrap();
        let listener = runtime.block_on(TcpListener::bind(settings.address)).unwrap();
        let url = format!("http://{}", listener.local_addr().unwrap());
        let stop = CancellationToken::new();
        runtime.spawn(serve(listener, state, protection, stop.clone()));
        Self { url, board, ledger, next: 0, stop }
    }

    fn feed(&mut self, count: u64) {
        for shot in self.next..self.next + count {
            self.ledger.lock().enter(shot).unwrap();
            self.board.processing(shot);
            if shot % 10 == 7 {
                self.board.failed(shot, format!("camera 2 is dark {HOSTILE}"));
            } else {
                self.board.done(shot, Arc::new(ShotResult::from(result(shot))));
            }
            self.ledger.lock().settle_all(shot, Outcome::Complete).unwrap();
            if shot % AT_ONCE == AT_ONCE - 1 {
                std::thread::sleep(PAUSE);
            }
        }
        self.next += count;
    }
}

impl Drop for Feeder {
    fn drop(&mut self) {
        self.stop.cancel();
    }
}

/// A vortex that grows and shrinks from shot to shot.
fn result(shot: u64) -> PairResult {
    let vectors = [12, 10, 8];
    let count = vectors.iter().product();
    let grid = VectorGrid { vectors, first_mm: [-4.4, -3.6, -2.8], spacing_mm: 0.8 };
    let strength = 0.3 + 0.1 * (shot as f32 * 0.3).sin();
    let displacement = (0..count).map(|index| {
        let [x, y, z] = grid.position_mm(index).map(|mm| mm as f32);
        [-strength * y, strength * x, 0.1 * z]
    });
    PairResult {
        field: VelocityField {
            displacement_vox: displacement.collect(),
            uncertainty_vox: vec![[0.02; 3]; count],
            status: vec![VectorStatus::Valid; count],
            peak_ratio: vec![3.0; count],
            vorticity: vec![[0.0; 3]; count],
            divergence: vec![0.0; count],
            has_gradient: vec![true; count],
            voxel_mm: 0.1,
            dt_s: 1e-4,
            grid,
        },
        seconds: StageSeconds { decode_s: 0.1, reconstruct_s: 0.2, correlate_s: 0.3, judge_s: 0.1 },
        warnings: if shot % 10 == 8 { vec![HOSTILE.to_owned()] } else { Vec::new() },
        model: Default::default(),
        fit: None,
        light: None,
        particles: Some((0..PARTICLES).map(particle).collect()),
    }
}

/// Particles of a shot, of which every fourth disagrees with those about it.
const PARTICLES: usize = 300;

/// On a helix in the volume.
fn particle(n: usize) -> MeasuredParticle {
    let share = n as f64 / PARTICLES as f64;
    let turn = 40.0 * share;
    MeasuredParticle {
        at_mm: [3.0 * turn.cos(), 3.0 * turn.sin(), 6.0 * (share - 0.5)],
        place_uncertainty_vox: [0.005; 3],
        displacement_vox: [share as f32, 0.5, 0.0],
        uncertainty_vox: [0.01; 3],
        light: [400.0; 2],
        agrees: n % 4 != 3,
    }
}

fn info() -> RunInfo {
    RunInfo {
        code_version: "0.0.0".to_owned(),
        model: HOSTILE.to_owned(),
        solver: "os-mart".to_owned(),
        configuration: ConfigurationSummary {
            calibrations: vec![CalibrationSummary {
                camera: "cam2".to_owned(),
                file: PathBuf::from(format!("{HOSTILE}.json")),
                sha256: CALIBRATION.to_owned(),
            }],
            file: PathBuf::from(format!("{HOSTILE}.toml")),
            simulated: true,
            cameras: vec![format!("cam1{HOSTILE}"), "cam2".to_owned()],
            mask: None,
            voxels_xyz: [96, 80, 64],
            voxel_mm: 0.1,
            centre_mm: [0.0; 3],
            max_displacement_vox: 4.0,
            window_mm: 1.6,
            place_particles: true,
            dt_us: 100.0,
            rate_hz: 10.0,
            shots: None,
            overload: "shed".to_owned(),
            queue: 4,
        },
        results_dir: PathBuf::from("/tmp"),
        paraview: false,
    }
}
