//! Every later program replays runs that an earlier version of the journal recorded.
//!
//! `tests/fixtures/recorded_run_v1` and later ones must not be rewritten: a new version of the
//! journal gets a folder of its own beside them. They were made by
//! `cargo test --test recorded_run write_the_fixture -- --ignored`.

use std::{
    fs,
    path::{Path, PathBuf},
    process::Command,
};

use lfpiv::{
    acquisition::journal::{JOURNAL_VERSION, RecordedRun},
    archive::stored_vectors,
};
use lfpiv_rawlog::{RawLog, RawLogReader, RawLogSettings};
use serde_json::Value;

use crate::bench::{images, lfpiv, text};

const SHOTS: u64 = 2;
/// For each camera's frames a and b, shot by shot.
const CHECKSUMS: [[u32; 4]; 2] = [
    [0xd320_cffa, 0xe63a_45c7, 0xfcdf_3415, 0x26ab_8e9a],
    [0xb5af_b2df, 0xaaa8_ea58, 0x9c1d_fbc0, 0xc3a0_6b69],
];
/// 1e-4 voxel between the pulses: 10 nm in 100 µs, in m/s. Vectors are bit-identical on processors
/// with the same vector instructions; on others sums of products are rounded differently.
const TOLERANCE_M_S: f32 = 1e-4;

fn fixture(version: u32) -> PathBuf {
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures");
    fixtures.join(format!("recorded_run_v{version}"))
}

/// The accounts of a run; outcomes added by later versions are zero.
fn accounts(run: &Path) -> Vec<Value> {
    let ledger = fs::read(run.join("ledger.json")).expect("a ledger");
    let mut ledger: Value = serde_json::from_slice(&ledger).expect("JSON");
    let mut cameras = ledger["cameras"].as_array_mut().map(std::mem::take).expect("accounts");
    for camera in &mut cameras {
        let outcomes = camera["outcomes"].as_object_mut().expect("outcomes");
        outcomes.entry("not_fired").or_insert(0.into());
    }
    cameras
}

#[test]
fn a_run_of_version_1_has_its_images() {
    let shots = images(&fixture(1));
    assert_eq!(shots.len() as u64, SHOTS);
    let found = shots.iter().map(|(_, cameras)| {
        let checksums: Vec<u32> = cameras.iter().flatten().map(|image| image.crc32()).collect();
        <[u32; 4]>::try_from(checksums).expect("four images")
    });
    assert_eq!(found.collect::<Vec<_>>(), CHECKSUMS);
}

/// Times of the shots of each version's fixture: UTC in s, and standard uncertainty in ns.
const TIMES: [[(f64, u64); 2]; 5] = [
    [(1_795_297_055.035_645_6, 7_685_403), (1_795_297_055.062_536, 6_777_876)],
    [(1_795_359_613.255_174_4, 155_269_218), (1_795_359_613.608_595_1, 46_941_562)],
    [(1_795_369_880.012_359_6, 7_623_901), (1_795_369_880.060_607, 16_889_316)],
    [(1_795_381_739.499_643_6, 26_695_004), (1_795_381_739.693_435_4, 79_745_403)],
    [(1_795_693_561.847_449_7, 6_875_179), (1_795_693_561.892_291_8, 14_173_186)],
];

#[test]
fn shots_of_every_version_have_their_times() {
    for (version, expected) in (1..).zip(TIMES) {
        let shots = RecordedRun::open(&fixture(version)).expect("a run").index().shots;
        let times: Vec<_> = shots.values().map(|shot| shot.time.expect("a time")).collect();
        assert_eq!(times.len(), expected.len());
        for (time, (utc_s, uncertainty_ns)) in times.iter().zip(expected) {
            assert!((time.utc_s() - utc_s).abs() < 1e-6, "version {version}: {time:?}");
            assert_eq!(time.uncertainty_ns, uncertainty_ns, "version {version}");
        }
    }
}

#[test]
fn a_run_of_version_1_gives_its_vectors_again() {
    let root = tempfile::tempdir().expect("a folder");
    let out = root.path().join("again");
    // Its own comparison is bit for bit, which other processors need not satisfy.
    let output = lfpiv(&["replay", "--out", out.to_str().unwrap(), fixture(1).to_str().unwrap()]);
    let again = fs::read_dir(&out).expect("results").next().expect("a run").expect("a run").path();
    let (then, now) = (stored_vectors(&fixture(1)).unwrap(), stored_vectors(&again).unwrap());
    println!("{}{}", text(&output.stdout), text(&output.stderr));
    assert_eq!(then.len() as u64, SHOTS);
    assert_eq!(then.keys().collect::<Vec<_>>(), now.keys().collect::<Vec<_>>());
    for (shot, then) in &then {
        let now = &now[shot];
        // Eight variables: u, v, w first; whether a vector is valid and whether replaced last.
        let vectors = then.len() / 8;
        assert_eq!((vectors, now.len()), (27, then.len()));
        assert_eq!(then[6 * vectors..], now[6 * vectors..], "shot {shot}");
        for (a, b) in then.iter().zip(now).take(3 * vectors) {
            let (a, b) = (f32::from_bits(*a), f32::from_bits(*b));
            let missing = a.is_nan() && b.is_nan();
            assert!(
                missing || (a - b).abs() <= TOLERANCE_M_S,
                "shot {shot}: {a} m/s then, {b} now"
            );
        }
    }
    assert_eq!(accounts(&fixture(1)), accounts(&again));
}

#[test]
fn a_run_of_a_later_version_is_refused_by_every_command() {
    let root = tempfile::tempdir().expect("a folder");
    let reader = RawLogReader::open(&fixture(1).join("raw")).unwrap();
    let mut description: Value = serde_json::from_slice(reader.description()).unwrap();
    description["journal_version"] = (JOURNAL_VERSION + 1).into();
    let description = serde_json::to_vec(&description).unwrap();
    let raw = root.path().join("raw");
    let (log, writer) = RawLog::create(&raw, &description, &RawLogSettings::default()).unwrap();
    for record in reader.records() {
        log.append_blocking(record.unwrap().1).unwrap();
    }
    writer.close().unwrap();
    let words = RecordedRun::open(root.path()).unwrap_err().to_string();
    let later = format!("journal version {}", JOURNAL_VERSION + 1);
    let refused = format!("{later}, and this program reads up to {JOURNAL_VERSION}");
    assert!(words.contains(&refused), "{words}");
    let run = root.path().to_str().unwrap();
    let out = root.path().join("out");
    for command in
        [&["replay", run][..], &["process", run], &["export", "--out", out.to_str().unwrap(), run]]
    {
        let output = lfpiv(command);
        let said = text(&output.stderr);
        assert!(!output.status.success() && said.contains(&later), "{said}");
    }
}

/// Creates the fixture for a new version of the journal, once: two shots of a bench with 9 × 9
/// microlenses.
#[test]
#[ignore = "writes the fixture of a new journal version"]
fn write_the_fixture() {
    let fixture = fixture(JOURNAL_VERSION);
    assert!(!fixture.exists(), "there is one already");
    let root = tempfile::tempdir().expect("a folder");
    let small = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/small.toml");
    let mut configuration = fs::read_to_string(small).expect("small.toml");
    for (from, to) in [
        ("columns = 41\nrows = 41", "columns = 9\nrows = 9"),
        ("columns = 748\nrows = 748", "columns = 164\nrows = 164"),
        ("voxels = [24, 20, 16]", "voxels = [8, 8, 8]"),
        ("window_mm = 0.8 ", "window_mm = 0.4 "),
    ] {
        assert!(configuration.contains(from), "{from}");
        configuration = configuration.replacen(from, to, 1);
    }
    fs::write(root.path().join("bench.toml"), configuration).expect("a file");
    // Paths in the record are relative to where it was made.
    let output = Command::new(env!("CARGO_BIN_EXE_lfpiv"))
        .args(["run", "--config", "bench.toml", "--shots", &SHOTS.to_string()])
        .current_dir(root.path())
        .output()
        .expect("the binary starts");
    assert!(output.status.success(), "{}", text(&output.stderr));
    let results = root.path().join("results");
    let run = fs::read_dir(results).expect("results").next().expect("a run").expect("a run").path();
    fs::create_dir_all(fixture.join("raw")).expect("a folder");
    let raw = "raw/segment_000000.raw";
    fs::copy(run.join(raw), fixture.join(raw)).expect("the record");
}
