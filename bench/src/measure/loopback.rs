//! Frames over real wires: simulated instruments, this program's drivers, and no processing.

use std::{
    io::Write,
    path::{Path, PathBuf},
    process::Command,
};

use lfpiv::{archive::write_replacing, cli::Streamed};

use super::{Findings, Surroundings};
use crate::{BenchmarkError, case::Setting};

/// Two cameras need two addresses: a network of its own has them.
const PRIVATE_NETWORK: &str = include_str!("../../../scripts/private-network.sh");

/// Shots at each rate.
const SHOTS: u64 = 40;

/// Runs `lfpiv sim-bench --drive` at every rate, each in a network of its own.
pub(super) fn measure(
    setting: &Setting,
    surroundings: &mut Surroundings,
    findings: &mut Findings,
) -> Result<(), BenchmarkError> {
    let configured = [setting.config.shot.rate_hz];
    let rates = &setting.case.rates_hz;
    for &rate_hz in if rates.is_empty() { &configured[..] } else { rates } {
        let config = configuration(setting, rate_hz, surroundings.work)?;
        let streamed = drive(surroundings.program, &config)?;
        let mut row = setting.row(None, setting.scene.seed);
        row.rate_hz = Some(rate_hz);
        row.seconds = Some(streamed.seconds);
        row.seconds_of = format!("{SHOTS} shots, programming the synchroniser included");
        row.cpu_s = Some(streamed.processor_seconds);
        row.whole_share = Some(streamed.whole_shots as f64 / SHOTS as f64);
        row.frames_per_s = Some(streamed.frames_per_s);
        row.mb_per_s = Some(streamed.mb_per_s);
        row.copies_per_frame = Some(streamed.copies_per_frame);
        findings.add(row, surroundings);
    }
    Ok(())
}

fn configuration(setting: &Setting, rate_hz: f64, work: &Path) -> Result<PathBuf, BenchmarkError> {
    let path = work.join("loopback.toml");
    let mut config = setting.config.clone();
    config.shot.rate_hz = rate_hz;
    if let Some(wire) = &mut config.wire {
        wire.port = work.join("synchroniser");
    }
    let malformed = |error: toml::ser::Error| BenchmarkError::Malformed {
        path: path.clone(),
        reason: error.to_string(),
    };
    let text = toml::to_string(&config).map_err(malformed)?;
    write_replacing(&path, |writer| writer.write_all(text.as_bytes()))?;
    Ok(path)
}

fn drive(program: &Path, config: &Path) -> Result<Streamed, BenchmarkError> {
    let mut command = Command::new("sh");
    command.arg("-c").arg(PRIVATE_NETWORK).arg("sh").arg(program);
    command.args(["sim-bench", "--drive", &SHOTS.to_string(), "--config"]).arg(config);
    let spawn = |reason| BenchmarkError::Spawn { program: program.into(), reason };
    let output = command.env("RUST_LOG", "error").output().map_err(spawn)?;
    let told = String::from_utf8_lossy(&output.stdout);
    serde_json::from_str(&told).map_err(|_| BenchmarkError::Child {
        command: format!("{} sim-bench --drive in a network of its own", program.display()),
        message: String::from_utf8_lossy(&output.stderr).into_owned(),
    })
}
