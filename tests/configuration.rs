//! Configuration files: the shipped ones load; a wrong one is refused with file, line, key, value
//! and what is allowed.

use lfpiv::config::{Config, ConfigFile};
use toml::de::{DeTable, DeValue};

const SHIPPED: [&str; 4] = ["sim", "jet", "bench", "paper"];

fn shipped(name: &str) -> String {
    let path = format!("{}/config/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(path).expect("shipped configuration")
}

/// The bench's configuration with one piece of text replaced, as `run.toml`.
fn refusal(from: &str, to: &str) -> String {
    let text = shipped("bench");
    let at = text.find(from).unwrap_or_else(|| panic!("{from} is not in bench.toml"));
    let changed = format!("{}{to}{}", &text[..at], &text[at + from.len()..]);
    match Config::parse("run.toml", &changed) {
        Ok(_) => panic!("{to} was accepted"),
        Err(error) => error.to_string(),
    }
}

fn line_of(text: &str, byte: usize) -> usize {
    text[..byte].matches('\n').count() + 1
}

#[test]
fn shipped_configurations_load() {
    for name in SHIPPED {
        let config = Config::parse(name, &shipped(name)).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(config.camera.len(), 2, "{name}");
        assert!(config.simulation.is_some(), "{name}");
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
    assert_eq!(paper.reconstruction.refinement, 1);
    let jet = load("jet");
    assert_eq!(jet.volume.voxels, [130, 100, 120]);
    assert_eq!(jet.camera[1].axis.as_slice(), [1.0, 0.0, 0.0]);
}

#[test]
fn a_value_out_of_range_is_shown_with_the_range() {
    let cases = [
        ("voxel_mm = 0.1", "voxel_mm = -0.1", "41:12: volume.voxel_mm = -0.1: allowed 0.001 to 10"),
        ("100, 80, 80]", "100, 0, 80]", "40:16: volume.voxels[1] = 0: allowed 1 to 2000"),
        ("queue = 4", "queue = -4", "75:9: pipeline.queue = -4: allowed 1 to 1000"),
        (
            "# saturation_counts = 4095",
            "saturation_counts = 70000",
            "52:21: image.saturation_counts = 70000: allowed 1 to 65535",
        ),
        (
            "wavelength_mm = 10.0",
            "wavelength_mm = 0.0",
            "93:17: simulation.flow.wavelength_mm = 0.0: allowed 0.01 to 10000",
        ),
        (
            "object_distance_mm = 200.0",
            "object_distance_mm = 50.0",
            "9:22: optics.object_distance_mm = 50.0: allowed: more than the focal length, 100 mm",
        ),
    ];
    for (from, to, expected) in cases {
        assert_eq!(refusal(from, to), format!("run.toml:{expected}"));
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

#[test]
fn an_unknown_key_is_named_with_the_keys_that_exist() {
    let message = refusal("voxel_mm = 0.1", "voxel = 0.1");
    let expected = "run.toml:41:1: volume.voxel: unknown key; allowed: voxels, voxel_mm, centre_mm";
    assert_eq!(message, expected);
    let nested = refusal("wavelength_mm = 10.0", "wavelength = 10.0");
    assert!(
        nested.starts_with("run.toml:93:1: simulation.flow.wavelength: unknown key"),
        "{nested}"
    );
    let table = refusal("[optics.sensor]", "[optics.chip]");
    assert!(table.starts_with("run.toml:19:9: optics.chip: unknown key; allowed: "), "{table}");
}

#[test]
fn a_missing_key_is_named_with_its_range() {
    let message = refusal("voxel_mm = 0.1\n", "");
    let expected = "run.toml:38:1: volume.voxel_mm: required key is missing; allowed 0.001 to 10";
    assert_eq!(message, expected);
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
fn the_second_cameras_bad_vector_is_told_from_the_firsts() {
    let message = refusal("up = [0.0, 0.0, -1.0]", "up = [0.0, 0.0, -2.0]");
    let expected = "run.toml:35:6: camera[1].up = [0.0, 0.0, -2.0]: has length 2, allowed: 1";
    assert!(message.starts_with(expected), "{message}");
    assert!(message.contains("camera[1].axis"), "{message}");
    let not_finite = refusal("up = [0.0, 0.0, -1.0]", "up = [0.0, nan, -1.0]");
    let expected = "run.toml:35:12: camera[1].up[1] = nan: allowed: a finite number";
    assert!(not_finite.starts_with(expected), "{not_finite}");
}

#[test]
fn broken_syntax_is_placed() {
    let overflow = refusal("voxel_mm = 0.1", "voxel_mm = 1e999");
    assert!(overflow.starts_with("run.toml:41:12: not TOML: "), "{overflow}");
    let message = refusal("voxel_mm = 0.1", "voxel_mm = 0.1 0.2");
    assert!(message.starts_with("run.toml:41:12: not TOML: "), "{message}");
    let twice = refusal("voxel_mm = 0.1", "voxel_mm = 0.1\nvoxel_mm = 0.1");
    assert!(twice.starts_with("run.toml:42:1: not TOML: duplicate key"), "{twice}");
}

#[test]
fn all_faults_are_reported_at_once_in_the_order_of_the_file() {
    let text = shipped("bench")
        .replace("overlap = 0.5", "overlap = 2.0")
        .replace("f_number = 4.0", "f_number = nan");
    let message = Config::parse("run.toml", &text).unwrap_err().to_string();
    let lines: Vec<&str> = message.lines().collect();
    assert_eq!(lines.len(), 2, "{message}");
    assert!(lines[0].contains("optics.f_number = nan: allowed 0.5 to 64"), "{message}");
    assert!(lines[1].contains("velocimetry.overlap = 2.0: allowed 0 to 0.9"), "{message}");
}

#[test]
fn a_file_that_cannot_be_read_is_named() {
    let message = ConfigFile::load("no/such.toml".as_ref()).unwrap_err().to_string();
    assert!(message.contains("no/such.toml"), "{message}");
}

/// Paths and byte ranges of all numbers in a document.
fn numbers(table: &DeTable<'_>, above: &str, found: &mut Vec<(String, std::ops::Range<usize>)>) {
    for (key, value) in table.iter() {
        let path = format!("{above}{}", key.get_ref());
        numbers_in(value.get_ref(), value.span(), path, found);
    }
}

fn numbers_in(
    value: &DeValue<'_>,
    span: std::ops::Range<usize>,
    path: String,
    found: &mut Vec<(String, std::ops::Range<usize>)>,
) {
    match value {
        DeValue::Integer(_) | DeValue::Float(_) => found.push((path, span)),
        DeValue::Table(table) => numbers(table, &format!("{path}."), found),
        DeValue::Array(array) => {
            for (index, element) in array.iter().enumerate() {
                let path = format!("{path}[{index}]");
                numbers_in(element.get_ref(), element.span(), path, found);
            }
        }
        _ => {}
    }
}

/// Every number of every shipped file, replaced by one that is none.
#[test]
fn no_number_may_be_nan_or_infinite() {
    for name in SHIPPED {
        let text = shipped(name);
        let document = DeTable::parse(&text).unwrap();
        let mut found = Vec::new();
        numbers(document.get_ref(), "", &mut found);
        assert!(found.len() > 40, "{name}: {}", found.len());
        for (path, span) in found {
            for wrong in ["nan", "-nan", "inf", "+inf", "-inf"] {
                let changed = format!("{}{wrong}{}", &text[..span.start], &text[span.end..]);
                let message = match Config::parse("run.toml", &changed) {
                    Ok(_) => panic!("{name}: {path} = {wrong} was accepted"),
                    Err(error) => error.to_string(),
                };
                let place = format!("run.toml:{}:", line_of(&text, span.start));
                let named = format!("{path} = {wrong}");
                let told = message.lines().any(|line| {
                    line.starts_with(&place) && line.contains(&named) && line.contains("allowed")
                });
                assert!(told, "{path} = {wrong}: {message}");
            }
        }
    }
}

/// Numbers far outside any range are refused too, wherever a range is declared.
#[test]
fn no_length_or_count_may_be_negative_or_huge() {
    for key in [
        "focal_length_mm",
        "f_number",
        "object_distance_mm",
        "pitch_mm",
        "columns",
        "rows",
        "pixel_pitch_um",
        "voxel_mm",
        "dt_us",
        "rate_hz",
        "refinement",
        "window_mm",
        "overlap",
        "passes",
        "max_displacement_vox",
        "median_threshold",
        "median_epsilon_vox",
        "queue",
        "ppm",
        "intensity_spread",
        "wavelength_mm",
        "bits",
        "gain_counts_per_electron",
        "offset_counts",
        "background_electrons",
        "read_noise_electrons",
    ] {
        let text = shipped("bench");
        let start = text.find(&format!("\n{key} = ")).expect(key) + 1;
        let end = start + text[start..].find('\n').expect("end of line");
        for wrong in ["-7", "123456789123"] {
            let changed = format!("{}{key} = {wrong}{}", &text[..start], &text[end..]);
            let message = match Config::parse("run.toml", &changed) {
                Ok(_) => panic!("{key} = {wrong} was accepted"),
                Err(error) => error.to_string(),
            };
            assert!(message.contains(&format!("{key} = {wrong}: allowed")), "{message}");
        }
    }
}
