//! `lfpiv simulate` and `lfpiv check` through the real binary.

use std::{fs, path::Path};

use image::{ColorType, ImageReader};

use crate::support::{changed_configuration, lfpiv, simulate, small_configuration};

const IMAGES: [&str; 4] = ["cam1_a.tif", "cam1_b.tif", "cam2_a.tif", "cam2_b.tif"];

fn read(folder: &Path, name: &str) -> Vec<u8> {
    fs::read(folder.join("shot_0000").join(name)).expect(name)
}

#[test]
fn a_seed_names_its_images_and_its_truth() {
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
fn the_truth_holds_particles_flow_and_dt() {
    let root = tempfile::tempdir().unwrap();
    assert!(simulate(&small_configuration(), root.path(), 1, 5).success);
    let truth: serde_json::Value =
        serde_json::from_slice(&read(root.path(), "truth.json")).unwrap();
    assert_eq!(truth["dt_s"], 1e-4);
    assert_eq!(truth["flow"]["kind"], "uniform");
    let particles = truth["particles"].as_array().unwrap();
    // 0.5 per microlens over 24 x 20 microlenses, and those that cross the edges.
    assert!((200..400).contains(&particles.len()), "{}", particles.len());
    for particle in particles {
        let moved_mm = |axis: usize| {
            particle["b_mm"][axis].as_f64().unwrap() - particle["a_mm"][axis].as_f64().unwrap()
        };
        assert!((moved_mm(0) - 0.1).abs() < 1e-9 && (moved_mm(1) + 0.05).abs() < 1e-9);
    }
}

#[test]
fn images_are_as_deep_as_the_sensor() {
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

#[test]
fn simulating_without_a_scene_says_what_to_add() {
    let root = tempfile::tempdir().unwrap();
    let text = fs::read_to_string(small_configuration()).unwrap();
    let config = root.path().join("real.toml");
    fs::write(&config, text.split("[simulation]").next().unwrap()).unwrap();
    let done = simulate(&config, &root.path().join("out"), 1, 5);
    assert!(!done.success);
    assert!(done.stderr.contains("real.toml has no [simulation] table"), "{}", done.stderr);
}

#[test]
fn check_prints_what_will_be_done() {
    let config = small_configuration();
    let done =
        lfpiv(["check".as_ref(), "--quick".as_ref(), "--config".as_ref(), config.as_os_str()]);
    assert!(done.success, "{}", done.stderr);
    for expected in ["is valid", "24 x 20 x 16 voxels of 0.1 mm", "41 x 41 microlenses", "MB"] {
        assert!(done.stdout.contains(expected), "{expected}: {}", done.stdout);
    }
}

#[test]
fn check_refuses_a_wrong_file_with_its_place_and_an_exit_code() {
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
