//! `lfpiv process` through the real binary: a bad pair is reported and does not affect others.

use std::{
    fs,
    io::{BufRead, BufReader},
    path::{Path, PathBuf},
    process::{Command, Stdio},
};

use image::{DynamicImage, ImageFormat};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use serde_json::Value;

use crate::support::{changed_configuration, lfpiv, process, simulate, small_configuration};

/// A simulated pair copied to `root/name` and then damaged.
fn damaged(root: &Path, name: &str, damage: impl FnOnce(&Path)) -> PathBuf {
    let source = root.join("pairs/shot_0000");
    if !source.exists() {
        assert!(simulate(&small_configuration(), &root.join("pairs"), 1, 5).success);
    }
    let folder = root.join(name);
    fs::create_dir(&folder).expect("a new folder");
    for entry in fs::read_dir(source).expect("the simulated pair") {
        let path = entry.expect("an entry").path();
        fs::copy(&path, folder.join(path.file_name().expect("a name"))).expect("a copy");
    }
    damage(&folder);
    folder
}

fn save(image: DynamicImage, path: PathBuf) {
    image.save_with_format(path, ImageFormat::Tiff).expect("an image");
}

fn truncate(path: &Path) {
    let whole = fs::read(path).expect("an image");
    fs::write(path, &whole[..whole.len() / 2]).expect("half an image");
}

/// A damaged folder and the expected message.
fn bad_folders(root: &Path) -> Vec<(PathBuf, &'static str)> {
    let remove = |file: &'static str| {
        move |folder: &Path| fs::remove_file(folder.join(file)).expect("an image")
    };
    vec![
        (damaged(root, "missing", remove("cam2_b.tif")), "cam2_b.tif is missing: with 2 cameras"),
        (damaged(root, "truncated", |folder| truncate(&folder.join("cam1_a.tif"))), "cam1_a.tif: "),
        (
            damaged(root, "empty", |folder| {
                fs::write(folder.join("cam1_b.tif"), b"").expect("a file")
            }),
            "cam1_b.tif: ",
        ),
        (
            damaged(root, "small", |folder| {
                save(DynamicImage::new_luma16(700, 748), folder.join("cam2_a.tif"))
            }),
            "cam2_a.tif has 700 x 748 pixels but the configured sensor has 748 x 748",
        ),
        (
            damaged(root, "colour", |folder| {
                save(DynamicImage::new_rgb8(748, 748), folder.join("cam1_b.tif"))
            }),
            "cam1_b.tif is colour or transparent",
        ),
        (
            damaged(root, "text", |folder| {
                fs::write(folder.join("cam2_a.tif"), "no image").expect("a file")
            }),
            "cam2_a.tif: ",
        ),
    ]
}

#[test]
fn every_bad_folder_is_reported_with_its_fault() {
    let root = tempfile::tempdir().unwrap();
    let bad = bad_folders(root.path());
    let folders: Vec<PathBuf> = bad.iter().map(|(folder, _)| folder.clone()).collect();
    let done = process(&root.path().join("out"), &folders);
    assert!(!done.success);
    assert!(done.stdout.is_empty(), "{}", done.stdout);
    let summary = done.stderr.rsplit("\nerror: ").next().unwrap();
    assert!(summary.starts_with("6 pair folders could not be measured"), "{summary}");
    for (folder, fault) in bad {
        let name = folder.display().to_string();
        let said = |line: &&str| line.contains(&name) && line.contains(fault);
        assert_eq!(done.stderr.lines().filter(said).count(), 1, "{name}: {}", done.stderr);
    }
}

#[test]
fn good_pairs_are_measured_although_others_are_bad() {
    let root = tempfile::tempdir().unwrap();
    let bad = damaged(root.path(), "bad", |folder| truncate(&folder.join("cam2_b.tif")));
    let good = damaged(root.path(), "good", |_| ());
    let out = root.path().join("out");
    let done = process(&out, &[bad, root.path().join("absent"), good]);
    assert!(!done.success);
    assert!(done.stderr.contains("2 pair folders could not be measured"), "{}", done.stderr);
    assert!(done.stdout.starts_with("good: "), "{}", done.stdout);
    assert!(out.join("good/velocity.nc").is_file());
    assert!(!out.join("good/volumes.nc").exists());
    assert!(!out.join("bad").exists());
}

#[test]
fn a_folder_of_pairs_is_processed_pair_by_pair() {
    let root = tempfile::tempdir().unwrap();
    let pairs = root.path().join("pairs");
    assert!(simulate(&small_configuration(), &pairs, 2, 5).success);
    let out = root.path().join("out");
    let done = process(&out, &[pairs]);
    assert!(done.success, "{}", done.stderr);
    for name in ["shot_0000", "shot_0001"] {
        assert!(done.stdout.contains(&format!("{name}: ")), "{}", done.stdout);
        assert!(out.join(name).join("velocity.nc").is_file());
    }
    let leftovers = fs::read_dir(out.join("shot_0000")).unwrap().filter(|entry| {
        entry.as_ref().unwrap().path().extension().is_some_and(|extension| extension == "part")
    });
    assert_eq!(leftovers.count(), 0);
}

/// The pairs in the output, and the files listed for ParaView.
fn listed(out: &Path) -> Vec<String> {
    let series = fs::read(out.join("velocity.vti.series")).expect("a series");
    let series: Value = serde_json::from_slice(&series).expect("JSON");
    let files = series["files"].as_array().expect("a list").iter();
    files.map(|file| file["name"].as_str().expect("a name").to_owned()).collect()
}

#[test]
fn existing_results_are_kept_by_default() {
    let root = tempfile::tempdir().unwrap();
    let (pairs, out) = (root.path().join("pairs"), root.path().join("out"));
    assert!(simulate(&small_configuration(), &pairs, 2, 5).success);
    let with = |option: &str| process(&out, &[option.into(), pairs.clone()]);
    assert!(process(&out, std::slice::from_ref(&pairs)).success);
    let first = fs::read(out.join("shot_0000/velocity.nc")).unwrap();

    let again = process(&out, std::slice::from_ref(&pairs));
    assert!(!again.success && again.stdout.is_empty(), "{}", again.stdout);
    for words in ["2 of 2 pairs have results already", "--resume", "--overwrite"] {
        assert!(again.stderr.contains(words), "{}", again.stderr);
    }
    fs::remove_file(out.join("shot_0001/velocity.nc")).unwrap();
    fs::remove_file(out.join("velocity.vti.series")).unwrap();
    let resumed = with("--resume");
    assert!(resumed.success, "{}", resumed.stderr);
    assert!(resumed.stdout.starts_with("shot_0001: "), "{}", resumed.stdout);
    assert_eq!(resumed.stdout.lines().count(), 1);
    assert_eq!(listed(&out), ["shot_0000/velocity.vti", "shot_0001/velocity.vti"]);
    assert_eq!(fs::read(out.join("shot_0000/velocity.nc")).unwrap(), first);

    let other = changed_configuration(root.path(), "window_mm = 0.8", "window_mm = 1.2");
    let paths = [other, out.clone(), pairs.clone()];
    let [config, to, from] = paths.each_ref().map(|path| path.as_os_str());
    let other = |option: &str| {
        let options = ["process", option, "--config"].map(AsRef::as_ref);
        lfpiv(options.into_iter().chain([config, "--out".as_ref(), to, from]))
    };
    let refused = other("--resume");
    assert!(!refused.success);
    assert!(refused.stderr.contains("another configuration"), "{}", refused.stderr);
    assert_eq!(fs::read(out.join("shot_0000/velocity.nc")).unwrap(), first);
    let replaced = other("--overwrite");
    assert!(replaced.success && replaced.stdout.lines().count() == 2, "{}", replaced.stderr);
    assert_ne!(fs::read(out.join("shot_0000/velocity.nc")).unwrap(), first);
}

/// So many pairs that the signal arrives long before the last one.
#[test]
fn an_interrupted_command_reports_it_and_is_resumed() {
    const PAIRS: usize = 60;
    const LEFT: usize = 3;
    let root = tempfile::tempdir().unwrap();
    let (pairs, out) = (root.path().join("pairs"), root.path().join("out"));
    assert!(simulate(&small_configuration(), &pairs, 1, 5).success);
    let folder = |pair: usize| pairs.join(format!("shot_{pair:04}"));
    for pair in 1..PAIRS {
        fs::create_dir(folder(pair)).unwrap();
        for image in fs::read_dir(folder(0)).unwrap().flatten() {
            fs::hard_link(image.path(), folder(pair).join(image.file_name())).unwrap();
        }
    }
    let mut child = Command::new(env!("CARGO_BIN_EXE_lfpiv"))
        .args(["process", "--config"])
        .args([&small_configuration(), Path::new("--out"), &out, &pairs])
        .stderr(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut told = BufReader::new(child.stdout.take().unwrap()).lines().map(Result::unwrap);
    assert!(told.next().unwrap().starts_with("shot_0000: "));
    let interrupt = format!("kill -INT {}", child.id());
    assert!(Command::new("sh").args(["-c", &interrupt]).status().unwrap().success());
    let ended = child.wait_with_output().unwrap();
    let said = String::from_utf8_lossy(&ended.stderr);
    assert!(!ended.status.success() && said.contains("stopping: "), "{said}");
    let measured = listed(&out).len();
    let words = format!("interrupted: {measured} of {PAIRS} pairs have results");
    assert!(said.contains(&words) && said.contains("--resume"), "{said}");
    assert!((1..PAIRS).contains(&measured));

    // The remaining pairs would show nothing new.
    for pair in measured + LEFT..PAIRS {
        fs::remove_dir_all(folder(pair)).unwrap();
    }
    let resumed = process(&out, &["--resume".into(), pairs.clone()]);
    assert!(resumed.success, "{}", resumed.stderr);
    let left = LEFT.min(PAIRS - measured);
    assert_eq!(resumed.stdout.lines().count(), left, "{}", resumed.stdout);
    assert_eq!(listed(&out).len(), measured + left);
}

#[test]
fn the_chosen_model_is_logged_and_stored() {
    let root = tempfile::tempdir().unwrap();
    assert!(simulate(&small_configuration(), &root.path().join("pairs"), 1, 5).success);
    let table = "[model]\nmode = \"auto\"\naperture_coverage = \"on\"\n[volume]";
    let config = changed_configuration(root.path(), "[volume]", table);
    let out = root.path().join("out");
    let paths = [config, out.clone(), root.path().join("pairs")];
    let [config, to, pairs] = paths.each_ref().map(|path| path.as_os_str());
    let done =
        lfpiv(["process".as_ref(), "--config".as_ref(), config, "--out".as_ref(), to, pairs]);
    assert!(done.success, "{}", done.stderr);
    assert!(done.stderr.contains("model chosen: with"), "{}", done.stderr);
    assert!(done.stderr.contains("aperture coverage: forced by the configuration"));
    let file = netcdf::open(out.join("shot_0000/velocity.nc")).unwrap();
    let text = |name: &str| match file.attribute(name).unwrap().value().unwrap() {
        netcdf::AttributeValue::Str(text) => text,
        other => panic!("{other:?}"),
    };
    assert!(text("model").contains("voxels split by"), "{}", text("model"));
    let choice: Value = serde_json::from_str(&text("model_choice")).unwrap();
    assert_eq!(choice["mode"], "auto");
    // The small bench has 0.5 particles per microlens.
    let ppm = choice["scene"]["seeding_ppm"].as_f64().unwrap();
    assert!((0.35..0.65).contains(&ppm), "{choice}");
    let parts = choice["parts"].as_array().unwrap();
    assert_eq!(parts.len(), 5);
    assert!(parts.iter().any(|part| part["part"] == "aperture_coverage" && part["forced"] == true));
}

#[test]
fn stored_volumes_are_correlated_again() {
    let root = tempfile::tempdir().unwrap();
    let (config, out) = (small_configuration(), root.path().join("out"));
    assert!(simulate(&config, &root.path().join("pairs"), 1, 5).success);
    let done = process(&out, &["--save-volumes".into(), root.path().join("pairs")]);
    assert!(done.success, "{}", done.stderr);
    let volumes = out.join("shot_0000/volumes.nc");
    let again = root.path().join("again");
    let correlate = |config: &Path, volumes: &Path| {
        let paths = [config, again.as_path(), volumes].map(Path::as_os_str);
        let [config, out, volumes] = paths;
        lfpiv(["correlate".as_ref(), "--config".as_ref(), config, "--out".as_ref(), out, volumes])
    };
    // Voxels are coarser than those correlated by `process`, so windows are larger.
    let wide = changed_configuration(root.path(), "window_mm = 0.8", "window_mm = 1.2");
    let done = correlate(&wide, &volumes);
    assert!(done.success, "{}", done.stderr);
    assert!(done.stdout.contains("vectors, "), "{}", done.stdout);
    assert!(again.join("velocity.vti").is_file());
    let file = netcdf::open(again.join("velocity.nc")).unwrap();
    let values = |name: &str| -> Vec<f64> { file.variable(name).unwrap().get_values(..).unwrap() };
    let valid = values("valid");
    assert!(valid.iter().sum::<f64>() > 0.8 * valid.len() as f64, "{valid:?}");
    for (name, truth) in [("u", 1.0), ("v", -0.5), ("w", 0.25)] {
        let errors = values(name).into_iter().zip(&valid).filter(|(_, valid)| **valid == 1.0);
        let mean = errors.map(|(v, _)| (v - truth).abs()).sum::<f64>() / valid.iter().sum::<f64>();
        // A window contains some twenty particles; one voxel is 1 m/s.
        assert!(mean < 0.3, "{name}: {mean}");
    }
    let other =
        changed_configuration(root.path(), "voxels = [24, 20, 16]", "voxels = [24, 20, 18]");
    let done = correlate(&other, &volumes);
    assert!(!done.success);
    assert!(done.stderr.contains("voxels, not [18, 20, 24]"), "{}", done.stderr);
}

/// With any damage to the file the program ends normally with an error.
#[test]
fn a_damaged_volume_file_never_crashes_the_program() {
    let root = tempfile::tempdir().unwrap();
    let config = changed_configuration(root.path(), "voxels = [24, 20, 16]", "voxels = [8, 8, 8]");
    let whole = root.path().join("whole.nc");
    let mut file = netcdf::create(&whole).unwrap();
    for name in ["z", "y", "x"] {
        file.add_dimension(name, 8).unwrap();
    }
    for name in ["a", "b"] {
        let mut frame = file.add_variable::<f32>(name, &["z", "y", "x"]).unwrap();
        frame.put_attribute("units", "1").unwrap();
        frame.put_values(&[1.0f32; 512], ..).unwrap();
    }
    file.close().unwrap();
    let bytes = fs::read(&whole).unwrap();
    let mut random = Pcg64Mcg::seed_from_u64(3);
    for case in 0..100 {
        let mut bytes = bytes.clone();
        for _ in 0..random.random_range(1..4) {
            // The file's metadata is at its beginning.
            let reach = if random.random() { 2048.min(bytes.len()) } else { bytes.len() };
            let at = random.random_range(0..reach);
            bytes[at] ^= 1 << random.random_range(0..8);
        }
        if case % 10 == 0 {
            bytes.truncate(random.random_range(0..bytes.len()));
        }
        let path = root.path().join("damaged.nc");
        fs::write(&path, &bytes).unwrap();
        let output = Command::new(env!("CARGO_BIN_EXE_lfpiv"))
            .args(["correlate", "--config"])
            .args([config.as_path(), "--out".as_ref(), &root.path().join("out"), &path])
            .output()
            .unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(matches!(output.status.code(), Some(0 | 1)), "case {case}: {said}");
        assert!(output.status.success() || said.contains("damaged.nc"), "case {case}: {said}");
        assert!(!said.contains("panicked") && said.lines().count() < 10, "case {case}: {said}");
    }
}

#[test]
fn a_folder_without_pairs_gives_an_explanation() {
    let root = tempfile::tempdir().unwrap();
    let done = process(&root.path().join("out"), &[root.path().to_path_buf()]);
    assert!(!done.success);
    assert!(
        done.stderr.contains("a pair folder holds cam1_a.tif and cam1_b.tif"),
        "{}",
        done.stderr
    );
}

#[test]
fn an_unknown_solver_is_refused_with_the_known_ones() {
    let done = lfpiv(["process", "--config", "x", "--out", "y", "--solver", "magic", "z"]);
    assert!(!done.success);
    assert!(done.stderr.contains("unknown solver `magic`"), "{}", done.stderr);
    assert!(done.stderr.contains("os-mart"), "{}", done.stderr);
}
