//! `lfpiv check`: a bench that cannot measure is refused with file, line and key, and advice is
//! given on what could be better.

use std::{
    fs,
    path::{Path, PathBuf},
};

use lfpiv::config::{ConfigFile, Purpose};

use crate::support::{Done, SHIPPED, changed_configuration, lfpiv, shipped};

fn check(config: &Path) -> Done {
    lfpiv(["check".as_ref(), "--quick".as_ref(), "--config".as_ref(), config.as_os_str()])
}

/// A shipped configuration with some text replaced, as a file in `folder`.
fn changed(folder: &Path, name: &str, changes: &[(&str, &str)]) -> PathBuf {
    let text = changes.iter().fold(shipped(name), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    });
    let path = folder.join("changed.toml");
    fs::write(&path, text).expect("a file in the test's folder");
    path
}

/// The error message for a bench that is loaded for `purpose`.
fn refusal(purpose: Purpose, name: &str, changes: &[(&str, &str)]) -> String {
    let folder = tempfile::tempdir().expect("a folder");
    let path = changed(folder.path(), name, changes);
    match ConfigFile::load_for(purpose, &path) {
        Ok(_) => panic!("{changes:?} was accepted"),
        Err(error) => error.to_string().replace(&path.display().to_string(), "changed.toml"),
    }
}

/// Number of the first line that begins with `key`.
fn line_of(name: &str, key: &str) -> usize {
    1 + shipped(name).lines().position(|line| line.starts_with(key)).expect(key)
}

/// `card.toml` describes a calibration card, so it is left out.
#[test]
fn every_configuration_in_the_repository_is_accepted() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folders = ["config", "tests/data", "bench/peers/cases"];
    let mut files = 0;
    for folder in folders {
        for entry in fs::read_dir(root.join(folder)).expect(folder) {
            let path = entry.expect("an entry").path();
            let is_toml = path.extension().is_some_and(|extension| extension == "toml");
            if is_toml && path.file_name() != Some("card.toml".as_ref()) {
                files += 1;
                if let Err(error) = ConfigFile::load_for(Purpose::Bench, &path) {
                    panic!("{error}");
                }
            }
        }
    }
    assert!(files > SHIPPED.len());
}

#[test]
fn a_volume_outside_the_common_view_is_refused() {
    let line = line_of("bench", "voxels");
    let larger = ("voxels = [100, 80, 80]", "voxels = [400, 400, 400]");
    let said = refusal(Purpose::Images, "bench", &[larger]);
    let place = format!("changed.toml:{line}:10: volume.voxels = [400, 400, 400]: ");
    assert!(said.starts_with(&place) && said.contains("common view"), "{said}");
    let line = line_of("bench", "centre_mm");
    let aside = ("centre_mm = [0.0, 0.0, 0.0]", "centre_mm = [30.0, 0.0, 0.0]");
    let said = refusal(Purpose::Images, "bench", &[aside]);
    let place = format!("changed.toml:{line}:13: volume.centre_mm = [30.0, 0.0, 0.0]: 0 % of the");
    assert!(said.starts_with(&place), "{said}");
}

#[test]
fn two_cameras_with_the_same_view_are_refused() {
    let same = (
        "up = [0.0, 0.0, -1.0]\naxis = [0.0, 1.0, 0.0]",
        "up = [0.0, 1.0, 0.0]\naxis = [0.0, 0.0, 1.0]",
    );
    let said = refusal(Purpose::Images, "bench", &[same]);
    assert!(
        said.contains("camera[1].axis = [0.0, 0.0, 1.0]: cam2 looks from where cam1 does"),
        "{said}"
    );
}

#[test]
fn windows_larger_than_the_volume_are_refused() {
    let said = refusal(Purpose::Volumes, "bench", &[("window_mm = 1.6 ", "window_mm = 8.1 ")]);
    let line = line_of("bench", "window_mm");
    let place =
        format!("changed.toml:{line}:13: velocimetry.window_mm = 8.1: larger than the volume");
    assert!(said.starts_with(&place) && said.contains("8 mm"), "{said}");
    let first = ("passes = 4\n", "passes = 4\nfirst_window_mm = 9.0\n");
    let said = refusal(Purpose::Volumes, "bench", &[first]);
    assert!(said.contains("velocimetry.first_window_mm = 9.0"), "{said}");
    let folder = tempfile::tempdir().expect("a folder");
    let whole = changed(folder.path(), "bench", &[("window_mm = 1.6 ", "window_mm = 8.0 ")]);
    ConfigFile::load_for(Purpose::Volumes, &whole).expect("as large as the volume");
}

#[test]
fn os_mart_on_the_whole_volume_is_refused() {
    let line = line_of("bench", "solver") + 1;
    let whole = |solver: &str| format!("solver = \"{solver}\"\ndomain = \"volume\"");
    let os_mart = "solver = \"os-mart\"";
    let said = refusal(Purpose::Images, "bench", &[(os_mart, &whole("os-mart"))]);
    let place = format!("changed.toml:{line}:10: reconstruction.domain = \"volume\": ");
    assert!(said.starts_with(&place) && said.contains("os-sart"), "{said}");
    let folder = tempfile::tempdir().expect("a folder");
    let paper = changed(folder.path(), "bench", &[(os_mart, &whole("os-sart"))]);
    ConfigFile::load_for(Purpose::Images, &paper).expect("the paper's own form");
}

/// Images may be taken at any rate, and volumes may come from any cameras.
#[test]
fn only_used_settings_must_be_consistent() {
    let rate = [("rate_hz = 10.0", "rate_hz = 1000.0")];
    let said = refusal(Purpose::Bench, "bench", &rate);
    let line = line_of("bench", "rate_hz");
    let laser = "laser rate = 1000 Hz: allowed: at most 10 Hz";
    let place = format!("changed.toml:{line}:11: shot.rate_hz = 1000.0: {laser}");
    assert!(said.starts_with(&place) && said.contains("cameras ready again at"), "{said}");
    let folder = tempfile::tempdir().expect("a folder");
    let faster = changed(folder.path(), "bench", &rate);
    ConfigFile::load_for(Purpose::Images, &faster).expect("images of any rate");
    let large = [("voxels = [100, 80, 80]", "voxels = [400, 400, 400]")];
    let large = changed(folder.path(), "bench", &large);
    ConfigFile::load_for(Purpose::Volumes, &large).expect("volumes of any cameras");
}

#[test]
fn process_and_run_refuse_what_check_refuses() {
    let root = tempfile::tempdir().expect("a folder");
    let path =
        changed_configuration(root.path(), "voxels = [24, 20, 16]", "voxels = [240, 200, 160]");
    let out = root.path().join("out");
    for command in [
        vec!["check", "--quick"],
        vec!["run", "--shots", "1"],
        vec!["process", "--out", out.to_str().expect("text"), "."],
    ] {
        let path = path.to_str().expect("text");
        let done = lfpiv(command.iter().copied().chain(["--config", path]));
        assert!(!done.success, "{command:?}");
        assert!(done.stderr.contains("volume.voxels = [240, 200, 160]: "), "{}", done.stderr);
    }
    assert!(!out.exists());
}

#[test]
fn possible_improvements_are_given_as_advice() {
    let root = tempfile::tempdir().expect("a folder");
    let (sin, cos) = 30.0_f64.to_radians().sin_cos();
    let near = format!("up = [0.0, {cos}, {}]\naxis = [0.0, {sin}, {cos}]", -sin);
    for (from, to, said) in [
        ("f_number = 4.0", "f_number = 4.0", "100 % in the common view"),
        (
            "\nfocal_length_mm = 0.8",
            "\nfocal_length_mm = 0.4",
            "microlenses f/4.0 behind a lens that works at f/8.0",
        ),
        (
            "\nfocal_length_mm = 0.8",
            "\nfocal_length_mm = 0.4",
            "-> micro-images fill 25 % of their pixels",
        ),
        (
            "voxels = [24, 20, 16]",
            "voxels = [60, 20, 16]",
            "-> vectors outside the common view will be invalid",
        ),
        (
            "up = [0.0, 0.0, -1.0]\naxis = [0.0, 1.0, 0.0]",
            &near,
            "-> depth is less accurate than the other components",
        ),
        ("window_mm = 0.8", "window_mm = 0.4", "-> with 5 or more most windows are valid"),
    ] {
        let done = check(&changed_configuration(root.path(), from, to));
        assert!(done.success, "{}", done.stderr);
        assert!(done.stdout.contains(said), "{to}: {}", done.stdout);
    }
}

#[test]
fn seconds_and_memory_are_compared_with_the_rate() {
    let config = crate::support::small_configuration();
    let done = lfpiv(["check".as_ref(), "--config".as_ref(), config.as_os_str()]);
    assert!(done.success, "{}", done.stderr);
    for said in ["per pair on", "for images of waiting pairs at 10 shots/s"] {
        assert!(done.stdout.contains(said), "{}", done.stdout);
    }
}

/// `check` refuses what `process` and `run` refuse.
#[test]
fn missing_background_images_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let image = |more: &str| {
        let to = format!("background = {more}");
        check(&changed_configuration(folder.path(), "background = \"constant\"", &to))
    };
    let unnamed = image("\"images\"");
    assert!(!unnamed.success && unnamed.stderr.contains("background_dir"), "{}", unnamed.stderr);
    let empty = image(&format!("\"images\"\nbackground_dir = {:?}", folder.path()));
    assert!(!empty.success && empty.stderr.contains("cam1_a.tif is missing"), "{}", empty.stderr);
    let pairs = image("\"minimum\"");
    assert!(pairs.success && pairs.stdout.contains("`lfpiv run` refuses"), "{}", pairs.stdout);
}
