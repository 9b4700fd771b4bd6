//! Configurations, and the real binary.

use std::{
    ffi::OsStr,
    path::{Path, PathBuf},
    process::{Command, Output},
};

use lfpiv::config::{Config, ConfigFile};
use lfpiv_core::velocimetry::{Interrogation, PointCloud, VelocityField};
use lfpiv_sim::{Flow, FrameOfPair, Truth};

/// The configurations in `config/`.
pub const SHIPPED: [&str; 6] = ["sim", "jet", "bench", "paper", "loopback", "loopback-bench"];

/// The folder of the whole project: tests of other crates share this file.
fn project() -> &'static Path {
    let crate_folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let has_configurations = |folder: &&Path| folder.join("config").is_dir();
    crate_folder.ancestors().find(has_configurations).expect("the folder config")
}

/// The program: that of this crate, or the one beside this crate's.
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

/// What a run of `lfpiv` left behind.
pub struct Done {
    /// Whether the exit code was 0.
    pub success: bool,
    /// Standard output.
    pub stdout: String,
    /// Standard error.
    pub stderr: String,
}

/// Runs `lfpiv` with these arguments to its end.
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

/// What it says.
pub fn small_bench() -> Config {
    ConfigFile::load(&small_configuration()).expect("small.toml").config
}

/// Difference of every vector from the flow at its place, in voxels along x, y, z.
pub fn errors_vox(field: &VelocityField, flow: &Flow) -> Vec<[f64; 3]> {
    let error = |(n, measured): (usize, &[f32; 3])| {
        let moved_mm = flow.displacement_mm(field.grid.position_mm(n), field.dt_s);
        std::array::from_fn(|axis| f64::from(measured[axis]) - moved_mm[axis] / field.voxel_mm)
    };
    field.displacement_vox.iter().enumerate().map(error).collect()
}

/// Mean |error| of each component over all vectors, valid or not, in voxels.
pub fn mean_error_vox(field: &VelocityField, flow: &Flow) -> [f64; 3] {
    let errors = errors_vox(field, flow);
    std::array::from_fn(|axis| {
        errors.iter().map(|error| error[axis].abs()).sum::<f64>() / errors.len() as f64
    })
}

/// The fields that the true particles give: what images and reconstruction add to.
pub struct TrueParticles {
    /// By the configured windows alone.
    pub by_windows: VelocityField,
    /// As configured, where single particles are followed.
    pub followed: VelocityField,
}

/// The true particles measured without images.
pub fn true_particles(config: &Config, truth: &Truth) -> TrueParticles {
    let settings = &config.velocimetry;
    let margin = (settings.max_displacement_vox / 2.0).ceil() as usize + 1;
    let interrogation = Interrogation::new(&config.volume, margin, settings);
    let grid = interrogation.cloud_grid();
    let cloud = |frame| {
        let lit = truth.particles.iter().filter_map(|p| Some((p.lit_mm(frame)?, p.intensity)));
        PointCloud::from_particles(&lit.collect::<Vec<_>>(), &grid)
    };
    let [a, b] = [FrameOfPair::A, FrameOfPair::B].map(cloud);
    TrueParticles {
        by_windows: interrogation.measure_by_windows(&a, &b, truth.dt_s),
        followed: interrogation.measure(&a, &b, truth.dt_s),
    }
}

/// The text of the small bench's configuration with one piece replaced, as a file in `folder`.
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
