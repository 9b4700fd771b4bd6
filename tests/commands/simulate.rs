//! `lfpiv simulate` and `lfpiv check` through the real binary.

use std::{fs, path::Path};

use image::{ColorType, ImageReader};

use crate::support::{changed_configuration, lfpiv, simulate, small_configuration};

const IMAGES: [&str; 4] = ["cam1_a.tif", "cam1_b.tif", "cam2_a.tif", "cam2_b.tif"];

fn read(folder: &Path, name: &str) -> Vec<u8> {
    fs::read(folder.join("shot_0000").join(name)).expect(name)
}

#[test]
fn a_seed_determines_images_and_truth() {
    let root = tempfile::tempdir().unwrap();
    let folders = ["first", "again", "other"].map(|name| root.path().join(name));
    for (folder, seed) in folders.iter().zip([5, 5, 6]) {
        assert!(simulate(&small_configuration(), folder, 1, seed).success);
    }
    let [first, again, other] = folders;
    for name in IMAGES.into_iter().chain(["truth.json"]) {
        assert!(read(&first, name) == read(&again, name), "{name}");
        assert!(read(&first, name) != read(&other, name), "{name}");
    }
}

#[test]
fn the_truth_contains_particles_flow_and_dt() {
    let root = tempfile::tempdir().unwrap();
    assert!(simulate(&small_configuration(), root.path(), 1, 5).success);
    let truth: serde_json::Value =
        serde_json::from_slice(&read(root.path(), "truth.json")).unwrap();
    assert_eq!(truth["dt_s"], 1e-4);
    assert_eq!(truth["flow"]["kind"], "uniform");
    let particles = truth["particles"].as_array().unwrap();
    // 0.5 per microlens over 24 x 20 microlenses, and particles that cross the edges.
    assert!((200..400).contains(&particles.len()), "{}", particles.len());
    for particle in particles {
        let moved_mm = |axis: usize| {
            particle["b_mm"][axis].as_f64().unwrap() - particle["a_mm"][axis].as_f64().unwrap()
        };
        assert!((moved_mm(0) - 0.1).abs() < 1e-9 && (moved_mm(1) + 0.05).abs() < 1e-9);
    }
}

#[test]
fn images_have_the_depth_of_the_sensor() {
    let root = tempfile::tempdir().unwrap();
    for (bits, expected) in [("8", ColorType::L8), ("12", ColorType::L16)] {
        let config = changed_configuration(root.path(), "bits = 12", &format!("bits = {bits}"));
        let out = root.path().join(bits);
        assert!(simulate(&config, &out, 1, 5).success);
        let image = ImageReader::open(out.join("shot_0000/cam2_b.tif")).unwrap().decode().unwrap();
        assert_eq!(image.color(), expected);
        assert_eq!((image.width(), image.height()), (748, 748));
    }
}

#[test]
fn a_recorded_pair_is_never_overwritten() {
    let root = tempfile::tempdir().unwrap();
    assert!(simulate(&small_configuration(), root.path(), 1, 5).success);
    let before = read(root.path(), "cam1_a.tif");
    let done = simulate(&small_configuration(), root.path(), 1, 6);
    assert!(!done.success);
    assert!(done.stderr.contains("shot_0000 exists already"), "{}", done.stderr);
    assert!(before == read(root.path(), "cam1_a.tif"));
}

/// For an array turned by half a degree, rows of micro-images rise to the right; pixel rows are
/// counted downwards.
#[test]
fn white_and_dark_images_come_with_the_true_grid() {
    let root = tempfile::tempdir().unwrap();
    let turned = "[simulation]\n\
                  camera = [{}, { array_rotation_deg = 0.5, gain = 0.8 }]\n";
    let config = changed_configuration(root.path(), "[simulation]\n", turned);
    let out = root.path().join("out");
    let simulate = |extra: &[&str]| {
        let fixed = ["simulate", "--shots", "0", "--config", config.to_str().unwrap(), "--out"];
        lfpiv(fixed.into_iter().chain([out.to_str().unwrap()]).chain(extra.iter().copied()))
    };
    let done = simulate(&["--white", "2", "--dark", "1", "--seed", "4"]);
    assert!(done.success, "{}", done.stderr);
    let expected = "0 shots, 2 white images and 1 dark image of each camera with seed 4 in";
    assert!(done.stdout.starts_with(expected), "{}", done.stdout);
    let counts = |name: &str| {
        let image = ImageReader::open(out.join(name)).unwrap().decode().unwrap().into_luma16();
        assert_eq!(image.dimensions(), (748, 748));
        image
    };
    for camera in ["cam1", "cam2"] {
        let [first, second] =
            ["00", "01"].map(|number| counts(&format!("white/{camera}_{number}.tif")));
        assert!(first != second, "noise of their own");
        let brightest = first.pixels().map(|pixel| pixel.0[0]).max().unwrap();
        assert!((2700..3500).contains(&brightest), "{brightest}");
        let dark = counts(&format!("dark/{camera}_00.tif"));
        assert!(dark.pixels().all(|pixel| pixel.0[0] < 110));
        let text = fs::read_to_string(out.join(format!("white/{camera}_grid_true.json"))).unwrap();
        let grid: serde_json::Value = serde_json::from_str(&text).unwrap();
        assert_eq!((&grid["camera"], &grid["microlenses"][0]), (&camera.into(), &41.into()));
        let number = |key: &str, index: usize| grid[key][index].as_f64().unwrap();
        let angle: f64 = if camera == "cam2" { 0.5_f64.to_radians() } else { 0.0 };
        let pitch_px = 0.1004 / 0.0055;
        assert!((number("column_px", 1) - pitch_px * angle.cos()).abs() < 1e-9);
        assert!((number("row_px", 1) + pitch_px * angle.sin()).abs() < 1e-9);
        assert!(grid["meaning"].as_str().unwrap().contains("j along +up"));
        // The pixel in the centre of a micro-image is lit, the corner between four is not.
        let at = |i: f64, j: f64| {
            let place = |key: &str| number(key, 0) + number(key, 1) * i + number(key, 2) * j;
            let pixel = [place("column_px"), place("row_px")].map(|px| px.round() as u32);
            first.get_pixel(pixel[0], pixel[1]).0[0]
        };
        let (middle, corner) = (at(3.0, 30.0), at(3.5, 30.5));
        assert!(middle > 1500 && corner < 200, "{middle} and {corner}");
    }
    let again = simulate(&["--dark", "1"]);
    assert!(!again.success && again.stderr.contains("dark exists already"), "{}", again.stderr);
}

#[test]
fn an_impossible_camera_is_refused_with_its_key() {
    let root = tempfile::tempdir().unwrap();
    let behind = "[simulation]\ncamera = [{ exit_pupil_mm = 200 }]\n";
    let config = changed_configuration(root.path(), "[simulation]\n", behind);
    let done = simulate(&config, &root.path().join("out"), 1, 5);
    let expected =
        "simulation.camera[0].exit_pupil_mm = 200: allowed: less than the image distance";
    assert!(!done.success && done.stderr.contains(expected), "{}", done.stderr);
}

#[test]
fn simulating_without_a_scene_tells_what_to_add() {
    let root = tempfile::tempdir().unwrap();
    let text = fs::read_to_string(small_configuration()).unwrap();
    let config = root.path().join("real.toml");
    fs::write(&config, text.split("[simulation]").next().unwrap()).unwrap();
    let done = simulate(&config, &root.path().join("out"), 1, 5);
    assert!(!done.success);
    assert!(done.stderr.contains("real.toml has no [simulation] table"), "{}", done.stderr);
}

#[test]
fn check_prints_the_plan() {
    let config = small_configuration();
    let done =
        lfpiv(["check".as_ref(), "--quick".as_ref(), "--config".as_ref(), config.as_os_str()]);
    assert!(done.success, "{}", done.stderr);
    for expected in ["is valid", "24 x 20 x 16 voxels of 0.1 mm", "41 x 41 microlenses", "MB"] {
        assert!(done.stdout.contains(expected), "{expected}: {}", done.stdout);
    }
}

#[test]
fn check_refuses_a_wrong_file_with_location_and_exit_code() {
    let root = tempfile::tempdir().unwrap();
    let config = changed_configuration(root.path(), "voxel_mm = 0.1", "voxel_mm = nan");
    let done =
        lfpiv(["check".as_ref(), "--quick".as_ref(), "--config".as_ref(), config.as_os_str()]);
    assert!(!done.success);
    assert!(done.stdout.is_empty(), "{}", done.stdout);
    let expected = ": volume.voxel_mm = nan: allowed 0.001 to 10";
    assert!(done.stderr.contains(expected), "{}", done.stderr);
    assert!(done.stderr.contains("changed.toml:"), "{}", done.stderr);
}
