//! Reading damaged, truncated, mixed-up or foreign files gives errors, and never a wrong record.

use std::path::Path;

use proptest::{collection::vec, prelude::*, test_runner::RngSeed};

use super::{
    super::{
        Position, RawLogError, RawLogReader, Record,
        names::{part_path, sealed_path},
        recovery::recover_on,
        storage::model::{Content, ModelDisk},
    },
    DESCRIPTION, folder, limits, reader, record, sealed_log,
};

const RECORDS: u64 = 30;
/// Bytes of a segment's header, both copies.
const HEADERS: usize = 2 * (52 + DESCRIPTION.len());

/// The sequence numbers read and the errors; panics if a record is wrong.
pub(super) fn read_all(reader: &RawLogReader) -> (Vec<u64>, Vec<RawLogError>) {
    let (mut right, mut errors) = (Vec::new(), Vec::new());
    for read in reader.records() {
        match read {
            Ok((sequence, read)) => {
                assert!(read == record(sequence), "record {sequence} has other content");
                right.push(sequence);
            }
            Err(error) => errors.push(error),
        }
    }
    assert!(right.is_sorted_by(|a, b| a < b), "{right:?}");
    (right, errors)
}

pub(super) fn segments(content: &Content) -> u32 {
    (0..).take_while(|number| content.file(&sealed_path(folder(), *number)).is_some()).count()
        as u32
}

#[test]
fn around_a_damaged_record_all_others_are_read() {
    let whole = sealed_log(RECORDS, &limits()).content();
    let positions: Vec<Position> =
        reader(&whole).unwrap().heads().map(|head| head.unwrap().1).collect();
    assert!(segments(&whole) > 3);
    for (number, position) in positions.iter().enumerate() {
        // In the header, in the head, and in the image if there is one.
        for byte in [9, 49, record(number as u64).head.len() + 48] {
            let has_image = record(number as u64).image.is_some();
            if byte > 49 && !has_image {
                continue;
            }
            let mut damaged = whole.clone();
            let file = damaged.file_mut(&sealed_path(folder(), position.segment)).unwrap();
            file[position.offset as usize + byte] ^= 0x10;
            let (right, errors) = read_all(&reader(&damaged).unwrap());
            let wanted: Vec<u64> = (0..RECORDS).filter(|n| *n != number as u64).collect();
            assert_eq!(right, wanted, "byte {byte} of record {number}");
            assert!(!errors.is_empty());
            let message = errors[0].to_string();
            assert!(message.contains(&format!("segment_00000{}", position.segment)), "{message}");
            assert!(message.contains(&format!("byte {} to", position.offset)), "{message}");
            assert!(message.contains(&format!("(record {number})")), "{message}");
        }
    }
}

#[test]
fn a_sealed_segment_that_is_cut_is_damaged_and_an_unsealed_one_is_not() {
    let whole = sealed_log(RECORDS, &limits()).content();
    let last = segments(&whole) - 1;
    let sealed = sealed_path(folder(), last);
    let bytes = whole.file(&sealed).unwrap().clone();
    for length in 0..bytes.len() {
        let mut cut = whole.clone();
        cut.file_mut(&sealed).unwrap().truncate(length);
        let (_, errors) = read_all(&reader(&cut).unwrap());
        assert!(matches!(errors[..], [RawLogError::Damaged { .. }, ..]), "{length}: {errors:?}");
        let mut running = whole.clone();
        running.remove(&sealed);
        running.add(&part_path(folder(), last), bytes[..length].to_vec());
        let (_, errors) = read_all(&reader(&running).unwrap());
        // The previous segment was sealed only after this one had its header.
        match errors[..] {
            [] => assert!(length >= HEADERS, "{length}"),
            [RawLogError::MissingEnd { .. }] => assert!(length < HEADERS, "{length}"),
            _ => panic!("{length}: {errors:?}"),
        }
    }
}

/// The same log with the version number of a later program.
pub(super) fn newer(mut content: Content, path: &Path) -> Content {
    let file = content.file_mut(path).unwrap();
    let length = u32::from_le_bytes(file[12..16].try_into().unwrap()) as usize;
    file[8] = 7;
    let crc = crc32fast::hash(&file[..length - 4]);
    file[length - 4..length].copy_from_slice(&crc.to_le_bytes());
    file.copy_within(..length, length);
    content
}

#[test]
fn a_newer_version_is_refused_with_advice() {
    let content = newer(sealed_log(3, &limits()).content(), &sealed_path(folder(), 0));
    let message = reader(&content).unwrap_err().to_string();
    assert!(message.contains("version 7") && message.contains("reads up to 2"), "{message}");
    assert!(message.contains("use the lfpiv that recorded it"), "{message}");
}

#[test]
fn a_position_without_a_record_gives_an_error() {
    let content = sealed_log(3, &limits()).content();
    let reader = reader(&content).unwrap();
    for (segment, offset) in [(0, 0), (0, 1 << 40), (9, 50)] {
        let error = reader.read(Position { segment, offset }).unwrap_err();
        assert!(error.to_string().contains("there is no record"), "{error}");
    }
}

fn damaged(mut content: Content, damages: &[(u16, u32, u8)]) -> Content {
    let count = segments(&content);
    for (segment, byte, flip) in damages {
        let path = sealed_path(folder(), u32::from(*segment) % count);
        let file = content.file_mut(&path).unwrap();
        let byte = *byte as usize % file.len();
        file[byte] ^= flip;
    }
    content
}

/// Opens, reads and recovers arbitrary content; whatever is read must be right.
fn use_arbitrary_content(content: Content) {
    if let Ok(reader) = reader(&content) {
        read_all(&reader);
        let mut positions = Vec::new();
        for head in reader.heads().flatten() {
            assert_eq!(head.2, record(head.0).head);
            positions.push(head.1);
        }
        for position in positions {
            if let Ok(read) = reader.read(position) {
                let is_known = (0..RECORDS).any(|number| record(number) == read);
                assert!(is_known, "{:?}", Record { image: None, ..read });
            }
        }
    }
    let _ = recover_on(&ModelDisk::holding(content), folder());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, rng_seed: RngSeed::Fixed(5), ..Default::default() })]

    #[test]
    fn flipped_bytes_never_give_a_wrong_record(
        damages in vec((any::<u16>(), any::<u32>(), 1..=255_u8), 1..6)
    ) {
        use_arbitrary_content(damaged(sealed_log(RECORDS, &limits()).content(), &damages));
    }

    #[test]
    fn pieces_in_any_order_never_give_a_wrong_record(
        pieces in vec((0..3000_usize, 0..400_usize), 0..12), is_sealed in any::<bool>()
    ) {
        let whole = sealed_log(RECORDS, &limits()).content();
        let source: Vec<u8> = (0..segments(&whole))
            .flat_map(|number| whole.file(&sealed_path(folder(), number)).unwrap().clone())
            .collect();
        let mut content = whole;
        let last = segments(&content) - 1;
        let mut bytes = content.file(&sealed_path(folder(), last)).unwrap()[..HEADERS].to_vec();
        for (start, length) in pieces {
            bytes.extend(source.iter().skip(start).take(length));
        }
        content.remove(&sealed_path(folder(), last));
        let path = if is_sealed { sealed_path(folder(), last) } else { part_path(folder(), last) };
        content.add(&path, bytes);
        use_arbitrary_content(content);
    }

    #[test]
    fn random_bytes_are_no_log(bytes in vec(any::<u8>(), 0..300), is_sealed in any::<bool>()) {
        let mut content = Content::default();
        let path = if is_sealed { sealed_path(folder(), 0) } else { part_path(folder(), 0) };
        content.add(&path, bytes);
        prop_assert!(reader(&content).is_err());
        use_arbitrary_content(content);
    }
}
