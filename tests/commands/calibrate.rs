//! `lfpiv calibrate grid` on ray-traced white images, compared with the true micro-image grid.

use std::{
    fs,
    path::{Path, PathBuf},
};

use lfpiv_core::lightfield::MicroImageGrid;
use serde_json::Value;

use crate::support::{Done, lfpiv, small_configuration};

/// Flaws of both cameras: array, dust, dead lenses, and a second aperture that cuts off 1.9 px at
/// the corner.
const FLAWS: &str = "
[[simulation.camera]]
array_rotation_deg = 1.0
array_shift_mm = [0.02, -0.03]
array_pitch_scale = [1.01, 1.006]
dead_microlenses = 4
dust = { specks = 12, radius_mm = 0.02, transmission = 0.5 }

[[simulation.camera]]
array_rotation_deg = -0.4
array_shift_mm = [-0.04, 0.01]
array_pitch_scale = [0.993, 0.993]
exit_pupil_mm = 20.0
vignetting = { radius_mm = 6.4, behind_lens_mm = 100.0 }
";

/// A folder with white and dark images of the small bench with flaws, and its configuration.
struct Bench {
    root: tempfile::TempDir,
    config: PathBuf,
}

impl Bench {
    fn simulated() -> Self {
        let root = tempfile::tempdir().unwrap();
        let config = root.path().join("imperfect.toml");
        fs::write(&config, fs::read_to_string(small_configuration()).unwrap() + FLAWS).unwrap();
        let out = root.path().join("images");
        let done = lfpiv(
            ["simulate", "--shots", "0", "--white", "3", "--dark", "2", "--seed", "7", "--config"]
                .map(PathBuf::from)
                .into_iter()
                .chain([config.clone(), "--out".into(), out]),
        );
        assert!(done.success, "{}", done.stderr);
        Self { root, config }
    }

    fn image(&self, kind: &str, camera: usize, number: usize) -> PathBuf {
        self.root.path().join(format!("images/{kind}/cam{camera}_{number:02}.tif"))
    }

    fn out(&self, name: &str) -> PathBuf {
        self.root.path().join(name)
    }

    /// Calibrates a camera from all of its images, with further arguments.
    fn calibrate(&self, camera: usize, out: &Path, further: &[&str]) -> Done {
        let white = (0..3).map(|number| self.image("white", camera, number));
        let dark = (0..2).map(|number| self.image("dark", camera, number));
        let arguments = ["calibrate", "grid", "--white"].map(PathBuf::from).into_iter();
        lfpiv(
            arguments
                .chain(white)
                .chain([PathBuf::from("--dark")])
                .chain(dark)
                .chain(["--out".into(), out.to_owned()])
                .chain(further.iter().map(PathBuf::from)),
        )
    }

    fn truth(&self, camera: usize) -> MicroImageGrid {
        read(&self.root.path().join(format!("images/white/cam{camera}_grid_true.json")))
    }
}

fn read<T: serde::de::DeserializeOwned>(path: &Path) -> T {
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

/// The largest distance between the centres of lenses of the same number.
fn worst_px(found: &MicroImageGrid, truth: &MicroImageGrid, from: [f64; 2]) -> f64 {
    let [nx, ny] = truth.microlenses;
    let distance = |n: usize| {
        let [i, j] = [(n % nx) as f64, (n / nx) as f64];
        let (a, b) = (truth.centre_px(i, j), found.centre_px(i - from[0], j - from[1]));
        (a[0] - b[0]).hypot(a[1] - b[1])
    };
    (0..nx * ny).map(distance).fold(0.0, f64::max)
}

#[test]
fn grids_of_imperfect_cameras_are_found() {
    let bench = Bench::simulated();
    for (camera, limit_px) in [(1, 0.02), (2, 0.05)] {
        grid_of_a_configured_camera(&bench, camera, limit_px);
    }
    grid_of_nothing_but_images(&bench);
}

fn grid_of_a_configured_camera(bench: &Bench, camera: usize, limit_px: f64) {
    let config = bench.config.to_str().unwrap();
    let out = bench.out(&format!("grid{camera}.json"));
    let number = camera.to_string();
    let done = bench.calibrate(camera, &out, &["--config", config, "--camera", &number]);
    assert!(done.success, "{}", done.stderr);
    let found: MicroImageGrid = read(&out);
    assert_eq!(found.microlenses, [41, 41]);
    let worst = worst_px(&found, &bench.truth(camera), [0.0; 2]);
    assert!(worst < limit_px, "camera {camera}: {worst} px, {}", done.stdout);
    assert!(!done.stdout.contains("warning"), "{}", done.stdout);
    let file: Value = read(&out);
    assert_eq!(file["camera"], format!("cam{camera}"));
    assert_eq!((&file["version"], &file["array"]), (&1.into(), &"square".into()));
    assert_eq!(file["estimators_agree"], true);
    assert_eq!(file["inputs"]["white"].as_array().unwrap().len(), 3);
    assert_eq!(file["states"][0].as_str().unwrap().len(), 41);
    assert_eq!(file["open_share"].as_array().unwrap().len(), 41);
    let second = &file["micro_image"]["second_aperture"];
    assert_eq!(second.is_null(), camera == 1, "{second}");
    let counts = &file["lens_counts"];
    let lenses: u64 = counts.as_object().unwrap().values().map(|n| n.as_u64().unwrap()).sum();
    assert_eq!(lenses, 41 * 41);
    assert!(camera == 2 || counts["dark"].as_u64() > Some(1), "{counts}");
    let page = fs::read_to_string(out.with_extension("html")).unwrap();
    assert!(page.contains("data:image/png;base64") && page.contains("Held-out residual"));
}

/// Without a configuration lenses are counted from the first lit one; the lattice is the same.
fn grid_of_nothing_but_images(bench: &Bench) {
    let out = bench.out("grid.json");
    let done = bench.calibrate(2, &out, &[]);
    assert!(done.success, "{}", done.stderr);
    assert!(done.stdout.contains("square, pitch 18.1"), "{}", done.stdout);
    assert!(done.stdout.contains("the f-number matches"), "{}", done.stdout);
    let (found, truth): (MicroImageGrid, _) = (read(&out), bench.truth(2));
    let [column, row] = found.centre_px(0.0, 0.0);
    let worst = worst_px(&found, &truth, truth.lens_at(column, row).map(f64::round));
    assert!(worst < 0.05, "{worst}");
    let file: Value = read(&out);
    let white = fs::read(bench.image("white", 2, 0)).unwrap();
    let digest = ring::digest::digest(&ring::digest::SHA256, &white);
    let expected: String = digest.as_ref().iter().map(|byte| format!("{byte:02x}")).collect();
    assert_eq!(file["inputs"]["white"][0]["sha256"], expected);
    assert_eq!(file["sha256"].as_str().unwrap().len(), expected.len());
}

#[test]
fn images_without_a_grid_are_refused_with_what_to_do() {
    let root = tempfile::tempdir().unwrap();
    let dark = root.path().join("dark.tif");
    image::GrayImage::from_pixel(748, 748, image::Luma([12])).save(&dark).unwrap();
    let out = root.path().join("grid.json");
    let grid = |further: &[&str]| {
        let first = ["calibrate", "grid", "--white"].map(PathBuf::from).into_iter();
        let rest = further.iter().map(PathBuf::from);
        lfpiv(first.chain([dark.clone(), "--out".into(), out.clone()]).chain(rest))
    };
    let done = grid(&[]);
    assert!(!done.success && !out.exists());
    assert!(done.stderr.contains("does not repeat from microlens to microlens"), "{}", done.stderr);
    let config = small_configuration();
    let config = config.to_str().unwrap();
    let done = grid(&["--config", config, "--camera", "3"]);
    assert!(done.stderr.contains("give --camera 1 to 2"), "{}", done.stderr);
    let done = grid(&["--config", config]);
    assert!(!done.success && done.stderr.contains("--camera"), "{}", done.stderr);
}
