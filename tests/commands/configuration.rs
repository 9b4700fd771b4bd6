//! Configuration files: shipped ones load; a wrong one is refused with file, line, key, value and
//! the allowed values.

use lfpiv::config::{Config, ConfigFile, Purpose};
use lfpiv_core::{model::ModelMode, reconstruction::Footprint};
use lfpiv_hw::TimingSettings;

use crate::support::{SHIPPED, shipped};

/// The bench's configuration with some text replaced.
struct Changed {
    text: String,
    /// First byte of the replacement.
    start: usize,
}

impl Changed {
    fn new(from: &str, to: &str) -> Self {
        let text = shipped("bench");
        let start = text.find(from).unwrap_or_else(|| panic!("{from} is not in bench.toml"));
        let text = format!("{}{to}{}", &text[..start], &text[start + from.len()..]);
        Self { text, start }
    }

    /// The error message for it as `run.toml`.
    fn refusal(&self) -> String {
        match Config::parse("run.toml", &self.text) {
            Ok(_) => panic!("this was accepted:\n{}", self.text),
            Err(error) => error.to_string(),
        }
    }

    /// `run.toml:LINE:COLUMN` of the first `marker` at or after the replacement.
    fn place(&self, marker: &str) -> String {
        let byte = self.start + self.text[self.start..].find(marker).expect(marker);
        self.place_of(byte)
    }

    /// `run.toml:LINE:COLUMN` of the last `marker` before the replacement.
    fn place_before(&self, marker: &str) -> String {
        self.place_of(self.text[..self.start].rfind(marker).expect(marker))
    }

    fn place_of(&self, byte: usize) -> String {
        let line_start = self.text[..byte].rfind('\n').map_or(0, |newline| newline + 1);
        let line = self.text[..byte].matches('\n').count() + 1;
        format!("run.toml:{line}:{}", byte - line_start + 1)
    }
}

/// The error message for the bench's configuration with some text replaced.
fn refusal(from: &str, to: &str) -> String {
    Changed::new(from, to).refusal()
}

#[test]
fn shipped_configurations_load() {
    for name in SHIPPED {
        let config = Config::parse(name, &shipped(name)).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(config.camera.len(), 2, "{name}");
        assert_eq!(config.simulation.is_some(), name != "loopback", "{name}");
        assert_eq!(config.instruments.is_some(), name == "loopback", "{name}");
    }
}

/// The daemon and the simulated bench at the other end of its wires have the same optics.
#[test]
fn both_ends_of_the_loopback_are_one_bench() {
    let load = |name: &str| Config::parse(name, &shipped(name)).unwrap();
    let (daemon, bench) = (load("loopback"), load("loopback-bench"));
    assert_eq!(daemon.bench_geometry(), bench.bench_geometry());
    assert_eq!((&daemon.shot, &daemon.timing), (&bench.shot, &bench.timing));
    let (instruments, wire) = (daemon.instruments.unwrap(), bench.wire.unwrap());
    let ips: Vec<_> = instruments.camera.iter().filter_map(|camera| camera.ip).collect();
    assert_eq!(ips, wire.camera_ips);
    assert_eq!(instruments.synchroniser.port, wire.port.to_str().unwrap());
}

#[test]
fn instruments_match_the_cameras_and_exclude_a_simulation() {
    let text = shipped("loopback");
    let (before, rest) = text.split_once("[[instruments.camera]]").unwrap();
    let (first, rest) = rest.split_once("[[instruments.camera]]").unwrap();
    let after = &rest[rest.find("[instruments.synchroniser]").unwrap()..];
    let lone = format!("{before}[[instruments.camera]]{first}{after}");
    let said = Config::parse("lone", &lone).unwrap_err().to_string();
    assert!(said.contains("1 [[instruments.camera]] tables for 2 [[camera]] tables"), "{said}");
    let both = format!("{text}\n[simulation]\nppm = 1.0\n");
    let said = Config::parse("both", &both).unwrap_err().to_string();
    assert!(said.contains("[simulation] or [instruments], not both"), "{said}");
}

#[test]
fn a_scene_cannot_list_more_cameras_than_the_bench_has() {
    let text = shipped("sim");
    for key in [
        "camera_shift_mm = [[0,0,0], [0,0,0], [0,0,0]]",
        "lighting.camera_light = [1, 1, 1]",
        "camera = [{}, {}, { gain = 0.8 }]",
    ] {
        let text = text.replacen("[simulation]\n", &format!("[simulation]\n{key}\n"), 1);
        let said = Config::parse("three", &text).unwrap_err().to_string();
        assert!(said.contains("lists 3 for 2 [[camera]] tables"), "{said}");
    }
}

#[test]
fn shipped_configurations_describe_the_documented_benches() {
    let load = |name: &str| Config::parse(name, &shipped(name)).unwrap();
    let bench = load("bench");
    assert_eq!(bench.volume.voxels, [100, 80, 80]);
    assert_eq!((bench.optics.microlens.columns, bench.optics.microlens.rows), (129, 97));
    assert_eq!((bench.velocimetry.window_mm, bench.velocimetry.overlap), (1.6, 0.5));
    assert_eq!(bench.shot.dt_us, 100.0);
    let paper = load("paper");
    assert_eq!((paper.optics.sensor.columns, paper.optics.microlens.rows), (4582, 251));
    assert_eq!(paper.reconstruction.footprint, Footprint::Auto);
    let jet = load("jet");
    assert_eq!(jet.volume.voxels, [130, 100, 120]);
    assert_eq!(jet.camera[1].axis.as_slice(), [1.0, 0.0, 0.0]);
}

#[test]
fn a_value_out_of_range_is_shown_with_the_range() {
    let cases = [
        (
            "voxel_mm = 0.1",
            "voxel_mm = -0.1",
            "-0.1",
            "volume.voxel_mm = -0.1: allowed 0.001 to 10",
        ),
        ("voxels = [100,", "voxels = [0,", "0,", "volume.voxels[0] = 0: allowed 1 to 2000"),
        ("queue = 4", "queue = -4", "-4", "pipeline.queue = -4: allowed 1 to 1000"),
        (
            "# saturation_counts = 4095",
            "saturation_counts = 70000",
            "70000",
            "image.saturation_counts = 70000: allowed 1 to 65535",
        ),
        (
            "wavelength_mm = 10.0",
            "wavelength_mm = 0.0",
            "0.0",
            "simulation.flow.wavelength_mm = 0.0: allowed 0.01 to 10000",
        ),
        ("# gap_us = 2.0", "gap_us = -2.0", "-2.0", "timing.gap_us = -2.0: allowed 0 to 10000"),
        (
            "object_distance_mm = 200.0",
            "object_distance_mm = 50.0",
            "50.0",
            "optics.object_distance_mm = 50.0: allowed: more than the focal length, 100 mm",
        ),
    ];
    for (from, to, marker, expected) in cases {
        let changed = Changed::new(from, to);
        assert_eq!(changed.refusal(), format!("{}: {expected}", changed.place(marker)));
    }
}

#[test]
fn a_value_of_the_wrong_type_is_shown_with_what_is_allowed() {
    let cases = [
        (
            "voxel_mm = 0.1",
            "voxel_mm = \"small\"",
            "volume.voxel_mm = \"small\": allowed 0.001 to 10",
        ),
        (
            "shot_noise = true",
            "shot_noise = 1",
            "simulation.sensor.shot_noise = 1: allowed: true or false",
        ),
        (
            "\"os-mart\"\n",
            "\"mart\"\n",
            "reconstruction.solver = \"mart\": allowed: mlos, sart, os-sart",
        ),
        (
            "127.0.0.1:8640",
            "localhost",
            "server.address = \"localhost\": allowed: address and port",
        ),
        ("dir = \"results\"", "dir = 3", "output.dir = 3: allowed: text in quotes"),
        (
            "up = [0.0, 1.0, 0.0]",
            "up = [0.0, 1.0]",
            "camera[0].up = [0.0, 1.0]: allowed: an array of 3",
        ),
    ];
    for (from, to, expected) in cases {
        let message = refusal(from, to);
        assert!(message.contains(expected), "{message}");
    }
}

/// A volume has three voxel counts, not four.
#[test]
fn an_array_with_too_many_elements_is_refused_with_how_many_are_allowed() {
    let cases = [
        ("voxels = [100, 80, 80]", "voxels = [100, 80, 80, 99]", "volume.voxels", "3"),
        ("up = [0.0, 1.0, 0.0]", "up = [0.0, 1.0, 0.0, 0.0, 0.0]", "camera[0].up", "3"),
        (
            "[simulation]\n",
            "[simulation]\nsheet_mm = [6.0, 6.0, 6.0, 6.0, 6.0]\n",
            "simulation.sheet_mm",
            "3",
        ),
        (
            "[simulation]\n",
            "[simulation]\ncamera_shift_mm = [[0, 0, 0, 1], [0, 0, 0]]\n",
            "simulation.camera_shift_mm[0]",
            "3",
        ),
    ];
    for (from, to, key, length) in cases {
        let message = refusal(from, to);
        let expected = format!("allowed: an array of {length}");
        assert!(message.contains(key) && message.contains(&expected), "{message}");
        assert_eq!(message.lines().count(), 1, "{message}");
    }
}

/// A parser needs up to a hundred times the memory of the file.
#[test]
fn a_configuration_that_is_too_large_or_not_a_file_is_not_read() {
    let root = tempfile::tempdir().unwrap();
    let large = root.path().join("large.toml");
    std::fs::write(&large, format!("numbers = [{}]", "1,".repeat(1 << 20))).unwrap();
    let said = ConfigFile::load(&large).unwrap_err().to_string();
    assert!(said.contains("large.toml") && said.contains("at most 1048576 are read"), "{said}");
    let pipe = root.path().join("pipe.toml");
    assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let said = ConfigFile::load(&pipe).unwrap_err().to_string();
    assert!(said.contains("pipe.toml: it is not a regular file"), "{said}");
}

#[test]
fn timing_may_be_left_out_and_declares_an_external_trigger() {
    let timing = |from: &str, to: &str| {
        let text = Changed::new(from, to).text;
        Config::parse("run.toml", &text).map(|config| config.timing)
    };
    let usual = timing("# external_trigger =", "# external_trigger =").unwrap();
    assert_eq!(usual, TimingSettings::default());
    let declared = timing("# external_trigger =", "external_trigger =").unwrap();
    assert_eq!(declared.external_trigger.unwrap().max_rate_hz, 10.0);
    let message = refusal(
        "# external_trigger = { max_rate_hz = 10.0",
        "external_trigger = { max_rate_hz = 0.0",
    );
    let expected = "timing.external_trigger.max_rate_hz = 0.0: allowed 0.001 to 1000";
    assert!(message.contains(expected), "{message}");
    let message = refusal("# gap_us = 2.0", "gap = 2.0");
    assert!(message.contains("timing.gap: unknown key"), "{message}");
}

#[test]
fn the_model_is_a_table_or_a_word() {
    let mode = |text: String| Config::parse("run.toml", &text).map(|config| config.model.mode);
    assert_eq!(mode(shipped("bench")).unwrap(), ModelMode::Explicit);
    assert_eq!(mode(shipped("jet")).unwrap(), ModelMode::Explicit);
    let short = format!("model = \"auto\"\n{}", shipped("jet"));
    assert_eq!(mode(short).unwrap(), ModelMode::Auto);
    let wrong = format!("model = \"best\"\n{}", shipped("jet"));
    let message = mode(wrong).unwrap_err().to_string();
    assert_eq!(message, "run.toml:1:9: model = \"best\": allowed: explicit or auto");
    let message = refusal("diffraction = \"auto\"", "diffraction = \"on\"");
    assert!(
        message.contains("model.diffraction") && message.contains("wavelength_nm"),
        "{message}"
    );
    let message = refusal("pupil_blur = \"auto\"", "pupil_blurr = \"auto\"");
    assert!(message.contains("model.pupil_blurr: unknown key"), "{message}");
}

#[test]
fn an_unknown_key_is_named_with_the_keys_that_exist() {
    let cases = [
        (
            "voxel_mm = 0.1",
            "voxel = 0.1",
            "voxel",
            "volume.voxel: unknown key; allowed: voxels, voxel_mm, centre_mm, mask",
        ),
        (
            "wavelength_mm = 10.0",
            "wavelength = 10.0",
            "wavelength",
            "simulation.flow.wavelength: unknown key; allowed: wavelength_mm, amplitude_m_s, \
             coefficients",
        ),
        (
            "[optics.sensor]",
            "[optics.chip]",
            "chip",
            "optics.chip: unknown key; allowed: focal_length_mm, f_number, object_distance_mm, \
             microlens, sensor",
        ),
    ];
    for (from, to, marker, expected) in cases {
        let changed = Changed::new(from, to);
        assert_eq!(changed.refusal(), format!("{}: {expected}", changed.place(marker)));
    }
}

#[test]
fn a_missing_key_is_named_with_its_range_at_its_table() {
    let changed = Changed::new("voxel_mm = 0.1\n", "");
    let expected = "volume.voxel_mm: required key is missing; allowed 0.001 to 10";
    assert_eq!(changed.refusal(), format!("{}: {expected}", changed.place_before("[volume]")));
}

#[test]
fn cameras_may_be_one_or_two() {
    let text = shipped("bench");
    let first = text.find("[[camera]]\nright").unwrap();
    let second = first + 1 + text[first + 1..].find("[[camera]]").unwrap();
    let end = text.find("[volume]").unwrap();
    let camera = &text[first..second];
    let with = |cameras: String| {
        let changed = format!("{}{cameras}{}", &text[..first], &text[end..]);
        Config::parse("run.toml", &changed).map(|c| c.camera.len()).map_err(|e| e.to_string())
    };
    assert_eq!(with(camera.to_owned()), Ok(1));
    let missing = with(String::new()).unwrap_err();
    assert!(missing.contains("camera: required key is missing"), "{missing}");
    let three = with(camera.repeat(3)).unwrap_err();
    assert!(three.contains("camera: 3 cameras; allowed: 1 or 2"), "{three}");
}

#[test]
fn an_error_in_the_second_camera_is_located_there() {
    let changed = Changed::new("up = [0.0, 0.0, -1.0]", "up = [0.0, 0.0, -2.0]");
    let message = changed.refusal();
    let expected = "camera[1].up = [0.0, 0.0, -2.0]: has length 2, allowed: 1 within 1e-6";
    assert!(message.starts_with(&format!("{}: {expected}", changed.place("["))), "{message}");
    assert!(message.contains("camera[1].axis"), "{message}");
    let changed = Changed::new("up = [0.0, 0.0, -1.0]", "up = [0.0, nan, -1.0]");
    let message = changed.refusal();
    let expected = format!("{}: camera[1].up[1] = nan: allowed", changed.place("nan"));
    assert!(message.starts_with(&expected), "{message}");
}

#[test]
fn syntax_errors_are_located() {
    for (to, marker) in [
        ("voxel_mm = 1e999", "1e999"),
        ("voxel_mm = 0.1 0.2", "0.1"),
        ("voxel_mm = 0.1\nvoxel_mm = 0.2", "voxel_mm = 0.2"),
    ] {
        let changed = Changed::new("voxel_mm = 0.1", to);
        let message = changed.refusal();
        let expected = format!("{}: not TOML: ", changed.place(marker));
        assert!(message.starts_with(&expected), "{expected} {message}");
    }
}

#[test]
fn all_errors_are_reported_together_in_the_order_of_the_file() {
    let text = shipped("bench")
        .replace("overlap = 0.5", "overlap = 2.0")
        .replace("f_number = 4.0", "f_number = nan");
    let message = Config::parse("run.toml", &text).unwrap_err().to_string();
    let lines: Vec<&str> = message.lines().collect();
    assert_eq!(lines.len(), 2, "{message}");
    assert!(lines[0].contains("optics.f_number = nan: allowed 0.5 to 64"), "{message}");
    assert!(lines[1].contains("velocimetry.overlap = 2.0: allowed 0 to 0.9"), "{message}");
}

/// The configuration is stored with every result, and workers are told the address.
#[test]
fn a_broker_is_named_without_a_password_and_workers_get_an_address_that_they_can_use() {
    let with = |table: &str| format!("[cluster]\n{table}\n\n[output]");
    let right = with("url = \"tls://10.0.0.1:4222\"\nserve = \"10.0.0.1:8700\"");
    let changed = Changed::new("[output]", &right);
    let cluster = Config::parse("run.toml", &changed.text).unwrap().cluster.unwrap();
    assert_eq!((cluster.heartbeat_timeout_s, cluster.deadline_s), (30.0, 600.0));
    for (wrong, why) in [
        ("url = \"nats://me:secret@10.0.0.1:4222\"", "a password"),
        ("url = \"http://10.0.0.1\"", "allowed: nats://HOST:PORT"),
        ("url = \"nats://10.0.0.1:4222\"\nserve = \"0.0.0.0:8700\"", "no address that workers"),
        ("url = \"nats://10.0.0.1:4222\"\ndeadline_s = 0", "cluster.deadline_s"),
    ] {
        let words = refusal("[output]", &with(wrong));
        assert!(words.contains(why), "{words}");
    }
    let root = tempfile::tempdir().unwrap();
    let path = root.path().join("run.toml");
    std::fs::write(&path, changed.text + "\n[raw_log]\nkeep = false\n").unwrap();
    let words = ConfigFile::load_for(Purpose::Bench, &path).unwrap_err().to_string();
    assert!(words.contains("raw_log.keep") && words.contains("leave out [cluster]"), "{words}");
}

#[test]
fn a_file_that_cannot_be_read_is_named() {
    let message = ConfigFile::load("no/such.toml".as_ref()).unwrap_err().to_string();
    assert!(message.contains("no/such.toml"), "{message}");
}
