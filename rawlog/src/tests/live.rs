//! Reading during a run, on the real disk.

use std::{thread, time::Duration};

use super::{
    super::{
        Codec, RawLog, RawLogReader, RawLogSettings, recover, settings::Limits, storage::Disk,
    },
    DESCRIPTION, limits, record,
};

#[test]
fn a_reader_follows_the_writer_through_its_segments() {
    let run = tempfile::tempdir().unwrap();
    let folder = run.path().join("raw");
    let storage = std::sync::Arc::new(Disk);
    let limits = Limits { sync_interval: Duration::from_millis(1), ..limits() };
    let (log, writer) = RawLog::create_on(storage, &folder, DESCRIPTION, &limits).unwrap();
    let reader = RawLogReader::open(&folder).unwrap();
    let writing = thread::spawn(move || {
        for number in 0..300 {
            log.append_blocking(record(number)).unwrap();
            if number.is_multiple_of(7) {
                thread::sleep(Duration::from_micros(500));
            }
        }
        writer.close().unwrap()
    });
    let mut records = reader.records();
    let mut heads = reader.heads();
    let (mut read, mut ends) = (0, 0);
    while read < 300 {
        let Some(next) = records.next() else {
            ends += 1;
            thread::sleep(Duration::from_micros(200));
            continue;
        };
        assert_eq!(next.unwrap(), (read, record(read)));
        let (sequence, position, head, has_image) = heads.next().unwrap().unwrap();
        let wanted = record(read);
        assert_eq!(
            (sequence, head, has_image),
            (read, wanted.head.clone(), wanted.image.is_some())
        );
        assert_eq!(reader.read(position).unwrap(), wanted);
        read += 1;
    }
    let marks = writing.join().unwrap();
    assert!(marks.segments > 10, "{marks:?}");
    assert!(ends > 0, "the reader never came to the end of what was written");
    assert!(records.next().is_none() && heads.next().is_none());
    assert!(recover(&folder).unwrap().segments.is_empty());
}

#[test]
fn settings_in_their_own_units_make_a_log_with_every_codec() {
    for codec in [Codec::Raw, Codec::Packed, Codec::Zstd, Codec::Auto] {
        let run = tempfile::tempdir().unwrap();
        let folder = run.path().join("raw");
        let settings = RawLogSettings { codec, reserve_mb: 0, ..Default::default() };
        let (log, writer) = RawLog::create(&folder, DESCRIPTION, &settings).unwrap();
        log.reserve(1000).unwrap();
        for number in 0..20 {
            log.append_blocking(record(number)).unwrap();
        }
        writer.close().unwrap();
        let reader = RawLogReader::open(&folder).unwrap();
        let read: Vec<_> = reader.records().map(Result::unwrap).collect();
        assert_eq!(read, (0..20).map(|n| (n, record(n))).collect::<Vec<_>>());
    }
}

#[test]
fn the_table_has_defaults_ranges_and_no_unknown_names() {
    use garde::Validate;
    let parse = |text: &str| toml::from_str::<RawLogSettings>(text);
    assert_eq!(parse("").unwrap(), RawLogSettings::default());
    RawLogSettings::default().validate().unwrap();
    let settings = parse("codec = \"zstd\"\nsegment_mb = 10\nsync_ms = 50").unwrap();
    assert_eq!((settings.codec, settings.segment_bytes()), (Codec::Zstd, 10_000_000));
    assert_eq!(settings.sync_interval(), Duration::from_millis(50));
    assert!(parse("segment_mb = 0").unwrap().validate().is_err());
    assert!(parse("codec = \"lz4\"").is_err());
    assert!(parse("segments_mb = 1").is_err());
}
