//! Malformed files give an error that says so, never a panic or a result.

use std::{fs, path::PathBuf, sync::OnceLock};

use lfpiv::{
    acquisition::journal::{Description, Entry, JOURNAL_VERSION, RecordedRun},
    archive::{FileDepth, ImageSize, read_grey_tiff, write_grey_tiff},
    config::Config,
};
use lfpiv_hw::RawImage;
use lfpiv_rawlog::{RawLog, RawLogSettings, Record};
use lfpiv_sim::faults::FaultSettings;
use proptest::prelude::*;

use crate::support::{SHIPPED, shipped};

/// Damage to a valid text.
#[derive(Debug, Clone)]
struct Spoiled {
    at: prop::sample::Index,
    length: usize,
    with: Vec<u8>,
}

fn spoiled() -> impl Strategy<Value = Spoiled> {
    (any::<prop::sample::Index>(), 0_usize..40, prop::collection::vec(any::<u8>(), 0..24))
        .prop_map(|(at, length, with)| Spoiled { at, length, with })
}

impl Spoiled {
    fn applied(&self, good: &[u8]) -> Vec<u8> {
        let at = self.at.index(good.len() + 1);
        let end = (at + self.length).min(good.len());
        [&good[..at], &self.with, &good[end..]].concat()
    }
}

/// A file with this content, deleted with the test's folder.
struct Kept {
    _folder: tempfile::TempDir,
    path: PathBuf,
}

fn file(bytes: &[u8]) -> Kept {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("file");
    fs::write(&path, bytes).expect("a file");
    Kept { _folder: folder, path }
}

fn good_tiff() -> &'static [u8] {
    static BYTES: OnceLock<Vec<u8>> = OnceLock::new();
    BYTES.get_or_init(|| {
        let image = RawImage::new(9, 7, (0..63).collect()).expect("an image");
        let kept = file(b"");
        write_grey_tiff(&kept.path, &image, FileDepth::Sixteen).expect("a TIFF");
        fs::read(&kept.path).expect("its bytes")
    })
}

/// A run with this description and this single record.
fn run_of(description: &[u8], head: &[u8]) -> tempfile::TempDir {
    let run = tempfile::tempdir().expect("a folder");
    let settings = RawLogSettings::default();
    let (log, writer) =
        RawLog::create(&run.path().join("raw"), description, &settings).expect("a log");
    let record = Record { head: head.to_vec(), image: None };
    log.append_blocking(record).expect("room");
    writer.close().expect("a closed log");
    run
}

fn description() -> Vec<u8> {
    let description = Description {
        journal_version: 1,
        code_version: "0.0.0".to_owned(),
        cameras: 2,
        patience_ns: 1,
        configuration: String::new(),
    };
    serde_json::to_vec(&description).expect("JSON")
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 300,
        rng_seed: prop::test_runner::RngSeed::Fixed(5),
        ..ProptestConfig::default()
    })]

    #[test]
    fn a_spoiled_configuration_is_read_or_refused_with_its_place(
        which in 0..SHIPPED.len(),
        spoiled in spoiled(),
    ) {
        let text = spoiled.applied(shipped(SHIPPED[which]).as_bytes());
        let text = String::from_utf8_lossy(&text);
        if let Err(error) = Config::parse("spoiled.toml", &text) {
            prop_assert!(error.to_string().contains("spoiled.toml"), "{error}");
        }
    }

    #[test]
    fn random_text_is_not_a_configuration(text in "\\PC{0,200}") {
        prop_assert!(Config::parse("random.toml", &text).is_err());
    }

    #[test]
    fn a_spoiled_tiff_is_read_or_refused_by_name(spoiled in spoiled()) {
        let kept = file(&spoiled.applied(good_tiff()));
        match read_grey_tiff(&kept.path, ImageSize { columns: 9, rows: 7 }) {
            Ok(image) => prop_assert_eq!(image.counts().len(), image.columns() * image.rows()),
            Err(error) => {
                let name = kept.path.display().to_string();
                prop_assert!(error.to_string().contains(&name), "{}", error);
            }
        }
    }

    #[test]
    fn spoiled_fault_settings_are_read_or_refused(spoiled in spoiled()) {
        let good = b"seed = 1\n[camera]\nlate_ms = 250\n[camera.shares]\ndropped = 0.02\n";
        let text = spoiled.applied(good);
        let _ = toml::from_str::<FaultSettings>(&String::from_utf8_lossy(&text));
    }

    #[test]
    fn an_invalid_entry_is_reported_and_later_ones_are_read(
        head in prop::collection::vec(any::<u8>(), 0..64),
    ) {
        prop_assume!(serde_json::from_slice::<Entry>(&head).is_err());
        let run = run_of(&description(), &head);
        let recorded = RecordedRun::open(run.path()).expect("a run");
        let found: Vec<_> = recorded.entries().collect();
        prop_assert_eq!(found.len(), 1);
        prop_assert!(found[0].is_err());
        prop_assert_eq!(recorded.index().damaged.len(), 1);
    }

    #[test]
    fn an_invalid_description_is_refused(spoiled in spoiled()) {
        let bytes = spoiled.applied(&description());
        prop_assume!(serde_json::from_slice::<Description>(&bytes).is_err());
        let run = run_of(&bytes, b"{}");
        let error = RecordedRun::open(run.path()).expect_err("no journal").to_string();
        prop_assert!(error.contains("its description"), "{}", error);
    }
}

#[test]
fn a_journal_of_a_later_program_is_refused_with_what_to_do() {
    let mut later: serde_json::Value = serde_json::from_slice(&description()).expect("JSON");
    later["journal_version"] = (JOURNAL_VERSION + 1).into();
    let later = later.to_string();
    let run = run_of(later.as_bytes(), b"{}");
    let error = RecordedRun::open(run.path()).expect_err("another version").to_string();
    let named = format!("version {}", JOURNAL_VERSION + 1);
    assert!(error.contains(&named) && error.contains("use the lfpiv"), "{error}");
}
