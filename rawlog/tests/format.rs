//! Every later program reads logs that an earlier version of the format wrote.
//!
//! `tests/fixtures/v1` and `v2` must not be rewritten: a new version of the format gets a folder of
//! its own beside them.

// This whole crate is a test; clippy's exception covers only functions marked as tests.
#![allow(clippy::unwrap_used)]

use std::{fs, path::PathBuf};

use lfpiv_hw::RawImage;
use lfpiv_rawlog::{Codec, FORMAT_VERSION, RawLog, RawLogReader, RawLogSettings, Record, recover};

const DESCRIPTION: &[u8] = br#"{"run":"fixture","format":1}"#;
const CODECS: [(&str, Codec); 3] =
    [("raw", Codec::Raw), ("packed", Codec::Packed), ("zstd", Codec::Zstd)];
const RECORDS: u64 = 5;

fn fixture(version: u32, codec: &str) -> PathBuf {
    let fixtures = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures");
    fixtures.join(format!("v{version}")).join(codec)
}

/// The records of the fixture, computed from this formula.
fn record(number: u64) -> Record {
    let head = format!(r#"{{"number":{number},"note":"µm"}}"#).into_bytes();
    let image = |columns: u64, rows: u64, count: &dyn Fn(u64) -> u64| {
        let counts = (0..columns * rows).map(|n| count(n) as u16).collect();
        RawImage::new(columns as usize, rows as usize, counts).ok()
    };
    let image = match number {
        // 12-bit noise on a black level: one whole block and part of another.
        0 => image(20, 11, &|n| 64 + (n * n * 7919 + n) % 97),
        1 => None,
        // 8 bits, 16 bits, and a constant.
        2 => image(16, 9, &|n| n * 37 % 256),
        3 => image(9, 16, &|n| n * 40_503 % 65_536),
        _ => image(128, 2, &|_| 4095),
    };
    Record { head, image }
}

#[test]
fn a_log_of_every_version_is_read() {
    for (version, name) in (1..=FORMAT_VERSION).flat_map(|v| CODECS.map(|(name, _)| (v, name))) {
        let reader = RawLogReader::open(&fixture(version, name)).unwrap().finished();
        assert_eq!(reader.description(), DESCRIPTION);
        let read: Vec<_> = reader.records().map(Result::unwrap).collect();
        let wanted: Vec<_> = (0..RECORDS).map(|number| (number, record(number))).collect();
        assert!(read == wanted, "{name} of version {version} has other records");
        for (sequence, position, head, has_image) in reader.heads().map(Result::unwrap) {
            let wanted = record(sequence);
            assert_eq!((head, has_image), (wanted.head.clone(), wanted.image.is_some()));
            assert_eq!(reader.read(position).unwrap(), wanted);
        }
    }
}

/// Compares the first record of a segment, with its raw image, to the documented bytes.
fn check_first_record(bytes: &[u8], first: usize) {
    let u32_at = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    let head = record(0).head;
    assert_eq!(&bytes[first..first + 4], b"LFRC");
    assert_eq!(u32_at(first + 4), head.len() as u32);
    assert_eq!([16, 20, 24, 28].map(|at| u32_at(first + at)), [20, 11, 1, 440]);
    assert_eq!(u32_at(first + 32), crc32fast::hash(&head));
    let image = record(0).image.unwrap();
    assert_eq!([u32_at(first + 36), u32_at(first + 40)], [image.crc32(); 2]);
    assert_eq!(&bytes[first + 48..first + 48 + head.len()], head);
}

#[test]
fn version_1_is_as_its_document_said_byte_for_byte() {
    let bytes = fs::read(fixture(1, "raw").join("segment_000000.raw")).unwrap();
    let u32_at = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    assert_eq!(&bytes[..8], b"LFPIVRAW");
    assert_eq!([u32_at(8), u32_at(12), u32_at(24)], [1, 0, DESCRIPTION.len() as u32]);
    check_first_record(&bytes, 32 + DESCRIPTION.len());
    assert_eq!(&bytes[bytes.len() - 32..bytes.len() - 28], b"LFEN");
}

#[test]
fn version_2_is_as_the_document_says_byte_for_byte() {
    let bytes = fs::read(fixture(2, "raw").join("segment_000000.raw")).unwrap();
    let u32_at = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    let length = 52 + DESCRIPTION.len();
    assert_eq!(&bytes[..8], b"LFPIVRAW");
    assert_eq!([u32_at(8), u32_at(12)], [2, length as u32]);
    // First segment: no predecessor, and its records begin at 0.
    assert_eq!(bytes[24..48], [0; 24]);
    assert_eq!(&bytes[48..length - 4], DESCRIPTION);
    assert_eq!(u32_at(length - 4), crc32fast::hash(&bytes[..length - 4]));
    assert_eq!(bytes[..length], bytes[length..2 * length]);
    check_first_record(&bytes, 2 * length);
    let footer = bytes.len() - 36;
    assert_eq!(&bytes[footer..footer + 4], b"LFEN");
    // Five records, closed log.
    assert_eq!([4, 8, 12, 28].map(|at| u32_at(footer + at)), [0, 5, 0, 2]);
    assert_eq!([u32_at(footer + 16), u32_at(footer + 20)], [footer as u32, 0]);
}

#[test]
fn a_crash_of_version_1_is_recovered() {
    let run = tempfile::tempdir().unwrap();
    let folder = run.path().join("raw");
    fs::create_dir(&folder).unwrap();
    let bytes = fs::read(fixture(1, "packed").join("segment_000000.raw")).unwrap();
    fs::write(folder.join("segment_000000.raw.part"), &bytes[..bytes.len() - 40]).unwrap();
    let recovery = recover(&folder).unwrap();
    assert_eq!(recovery.segments[0].records, RECORDS - 1);
    let reader = RawLogReader::open(&folder).unwrap();
    let read: Vec<_> = reader.records().map(Result::unwrap).collect();
    assert_eq!(read, (0..RECORDS - 1).map(|number| (number, record(number))).collect::<Vec<_>>());
}

/// Writes the fixture for a new version of the format; run once.
#[test]
#[ignore = "writes the fixture of a new format version"]
fn write_the_fixture() {
    for (name, codec) in CODECS {
        let settings = RawLogSettings { codec, ..Default::default() };
        let (log, writer) =
            RawLog::create(&fixture(FORMAT_VERSION, name), DESCRIPTION, &settings).unwrap();
        for number in 0..RECORDS {
            log.append_blocking(record(number)).unwrap();
        }
        writer.close().unwrap();
    }
}
