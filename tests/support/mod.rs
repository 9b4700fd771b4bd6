//! Configurations and the real binary, for tests.

use std::{
    ffi::OsStr,
    path::{Path, PathBuf},
    process::{Command, Output},
};

use lfpiv::config::{Config, ConfigFile};

/// Error measures shared with the tests of the numerics.
#[path = "../../core/tests/support/errors.rs"]
mod errors;

#[allow(unused_imports, reason = "not every test has a truth")]
pub use errors::*;

/// Names of the bench configurations in `config/`.
pub const SHIPPED: [&str; 7] =
    ["sim", "jet", "bench", "imperfect", "paper", "loopback", "loopback-bench"];

/// Root folder of the project; tests of other crates share this file.
fn project() -> &'static Path {
    let crate_folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let has_configurations = |folder: &&Path| folder.join("config").is_dir();
    crate_folder.ancestors().find(has_configurations).expect("the folder config")
}

/// The binary under test: this crate's, or the one next to this crate's test binary.
fn program() -> PathBuf {
    match (option_env!("CARGO_BIN_EXE_lfpiv"), option_env!("CARGO_BIN_EXE_lfpiv-bench")) {
        (Some(own), _) => own.into(),
        (None, Some(other)) => Path::new(other).with_file_name("lfpiv"),
        (None, None) => unreachable!("a crate without programs starts none"),
    }
}

/// The text of a configuration in `config/`.
pub fn shipped(name: &str) -> String {
    let path = project().join("config").join(name);
    std::fs::read_to_string(path.with_extension("toml")).expect("shipped configuration")
}

/// Result of a run of `lfpiv`.
pub struct Done {
    /// Whether the exit code was 0.
    pub success: bool,
    /// Standard output.
    pub stdout: String,
    /// Standard error.
    pub stderr: String,
}

/// Runs `lfpiv` with these arguments and waits for its end.
pub fn lfpiv<A: AsRef<OsStr>>(arguments: impl IntoIterator<Item = A>) -> Done {
    let output: Output = Command::new(program())
        .args(arguments)
        .env_remove("RUST_LOG")
        .output()
        .expect("the binary starts");
    let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!stderr.contains("panicked"), "{stderr}");
    Done {
        success: output.status.success(),
        stdout: String::from_utf8_lossy(&output.stdout).into_owned(),
        stderr,
    }
}

/// The configuration of a bench that is quick to simulate and to measure.
pub fn small_configuration() -> PathBuf {
    project().join("tests/data/small.toml")
}

/// The parsed configuration of the small bench.
pub fn small_bench() -> Config {
    ConfigFile::load(&small_configuration()).expect("small.toml").config
}

/// Writes the small bench's configuration, with some text replaced, to a file in `folder`.
pub fn changed_configuration(folder: &Path, from: &str, to: &str) -> PathBuf {
    let text = std::fs::read_to_string(small_configuration()).expect("small.toml");
    assert!(text.contains(from), "{from}");
    let path = folder.join("changed.toml");
    std::fs::write(&path, text.replacen(from, to, 1)).expect("a file in the test's folder");
    path
}

/// Simulates `shots` pairs of the small bench into `out`.
pub fn simulate(config: &Path, out: &Path, shots: u32, seed: u32) -> Done {
    let (shots, seed) = (shots.to_string(), seed.to_string());
    let arguments: [&OsStr; 9] = [
        "simulate".as_ref(),
        "--config".as_ref(),
        config.as_ref(),
        "--out".as_ref(),
        out.as_ref(),
        "--shots".as_ref(),
        shots.as_ref(),
        "--seed".as_ref(),
        seed.as_ref(),
    ];
    lfpiv(arguments)
}

/// Processes pair folders with the small bench's configuration.
pub fn process(out: &Path, folders: &[PathBuf]) -> Done {
    let config = small_configuration();
    let fixed: [&OsStr; 5] =
        ["process".as_ref(), "--config".as_ref(), config.as_ref(), "--out".as_ref(), out.as_ref()];
    lfpiv(fixed.into_iter().chain(folders.iter().map(AsRef::as_ref)))
}
