//! What recovery reports and what it leaves alone.

use super::{
    super::{
        RawLogError,
        names::{part_path, sealed_path, torn_path},
        recovery::recover_on,
        storage::model::{Content, ModelDisk},
    },
    folder, limits, reader,
    reading::{newer, read_all},
    record, sealed_log,
};

/// The last segment of a closed log, as it was before sealing.
pub(super) fn unsealed(disk: &ModelDisk) -> (Content, u32) {
    let content = disk.content();
    let last = (0..).take_while(|n| content.file(&sealed_path(folder(), *n)).is_some()).count() - 1;
    let last = last as u32;
    let mut bytes = content.file(&sealed_path(folder(), last)).unwrap().clone();
    bytes.truncate(bytes.len() - 36);
    let mut left = content;
    left.remove(&sealed_path(folder(), last));
    left.add(&part_path(folder(), last), bytes);
    (left, last)
}

#[test]
fn a_torn_record_is_cut_kept_and_named() {
    let (mut left, last) = unsealed(&sealed_log(20, &limits()));
    let part = part_path(folder(), last);
    let whole = left.file(&part).unwrap().clone();
    left.file_mut(&part).unwrap().truncate(whole.len() - 3);
    let disk = ModelDisk::holding(left);
    let recovery = recover_on(&disk, folder()).unwrap();
    let [segment] = &recovery.segments[..] else { panic!("{recovery:?}") };
    let torn = segment.torn.as_ref().unwrap();
    assert_eq!(segment.path.as_ref().unwrap(), &sealed_path(folder(), last));
    assert_eq!(torn.segment, part);
    assert_eq!(torn.offset + torn.bytes, whole.len() as u64 - 3);
    assert_eq!(torn.record, Some(19));
    assert_eq!(torn.moved_to, torn_path(folder(), last, 1));
    let content = disk.content();
    assert_eq!(
        content.file(&torn.moved_to).unwrap(),
        &whole[torn.offset as usize..whole.len() - 3]
    );
    let message = torn.to_string();
    assert!(message.contains("segment_00000") && message.contains("record 19"), "{message}");
    let read: Vec<_> = reader(&content).unwrap().records().map(Result::unwrap).collect();
    assert_eq!(read.len(), 19);
    assert!(recover_on(&disk, folder()).unwrap().segments.is_empty());
}

#[test]
fn whole_records_behind_a_damaged_one_stay_in_the_log() {
    let (whole, last) = unsealed(&sealed_log(20, &limits()));
    let part = part_path(folder(), last);
    let heads = reader(&whole).unwrap().heads().map(Result::unwrap);
    let in_last: Vec<_> = heads.filter(|(_, position, ..)| position.segment == last).collect();
    for (number, position, ..) in in_last {
        // One byte in the header, one in the head.
        for byte in [9, 50] {
            let mut left = whole.clone();
            left.file_mut(&part).unwrap()[position.offset as usize + byte] ^= 1;
            let disk = ModelDisk::holding(left);
            let recovery = recover_on(&disk, folder()).unwrap();
            assert_eq!(recovery.segments[0].torn, None, "record {number}");
            let (right, errors) = read_all(&reader(&disk.content()).unwrap());
            assert_eq!(right, (0..20).filter(|n| *n != number).collect::<Vec<_>>());
            assert!(matches!(errors[..], [RawLogError::Damaged(_)]), "{errors:?}");
        }
    }
}

#[test]
fn a_log_that_died_between_two_segments_ends_with_the_first() {
    let content = sealed_log(20, &limits()).content();
    let mut left = Content::default();
    left.add(&part_path(folder(), 0), content.file(&sealed_path(folder(), 0)).unwrap().clone());
    let records = reader(&left).unwrap().records().map(Result::unwrap).count();
    for next in [None, Some(Vec::new()), Some(vec![0; 90])] {
        let mut left = left.clone();
        if let Some(bytes) = next {
            left.add(&part_path(folder(), 1), bytes);
        }
        let disk = ModelDisk::holding(left);
        recover_on(&disk, folder()).unwrap();
        let (right, errors) = read_all(&reader(&disk.content()).unwrap());
        assert_eq!((right.len(), errors.len()), (records, 0), "{errors:?}");
    }
}

#[test]
fn a_segment_without_a_header_is_left_alone_and_reported() {
    let (mut left, last) = unsealed(&sealed_log(20, &limits()));
    let part = part_path(folder(), last);
    left.file_mut(&part).unwrap()[..140].fill(0);
    let disk = ModelDisk::holding(left.clone());
    assert!(recover_on(&disk, folder()).unwrap().segments.is_empty());
    assert!(disk.content() == left);
    let (right, errors) = read_all(&reader(&left).unwrap());
    assert!(!right.is_empty());
    let message = errors[0].to_string();
    assert!(message.contains("raw.part") && message.contains("its records are lost"), "{message}");
}

#[test]
fn a_second_torn_tail_does_not_take_the_place_of_the_first() {
    let (mut left, last) = unsealed(&sealed_log(20, &limits()));
    left.add(&torn_path(folder(), last, 1), b"earlier".to_vec());
    left.file_mut(&part_path(folder(), last)).unwrap().extend(b"torn");
    let disk = ModelDisk::holding(left);
    let recovery = recover_on(&disk, folder()).unwrap();
    let torn = recovery.segments[0].torn.clone().unwrap();
    assert_eq!(torn.moved_to, torn_path(folder(), last, 2));
    let content = disk.content();
    assert_eq!(content.file(&torn_path(folder(), last, 1)).unwrap(), b"earlier");
    assert_eq!(content.file(&torn.moved_to).unwrap(), b"torn");
}

#[test]
fn a_segment_that_lacks_only_its_name_is_renamed() {
    let disk = sealed_log(20, &limits());
    let (mut left, last) = unsealed(&disk);
    let sealed = disk.content().file(&sealed_path(folder(), last)).unwrap().clone();
    *left.file_mut(&part_path(folder(), last)).unwrap() = sealed;
    let recovered = ModelDisk::holding(left);
    let recovery = recover_on(&recovered, folder()).unwrap();
    assert_eq!(recovery.segments[0].torn, None);
    assert_eq!(recovered.content().named(), disk.content().named());
}

#[test]
fn a_newer_version_is_refused_and_not_touched() {
    let (mut left, last) = unsealed(&sealed_log(20, &limits()));
    left = newer(left, &part_path(folder(), last));
    let disk = ModelDisk::holding(left.clone());
    let error = recover_on(&disk, folder()).unwrap_err();
    assert!(matches!(error, RawLogError::NewerVersion { found: 7, .. }));
    assert!(error.to_string().contains("version 7"), "{error}");
    assert_eq!(disk.content(), left);
}

#[test]
fn a_folder_without_a_log_is_no_log() {
    let error = recover_on(&ModelDisk::default(), folder()).unwrap_err();
    assert!(error.to_string().contains("contains no raw log"), "{error}");
}

#[test]
fn a_completed_run_needs_no_recovery() {
    let disk = sealed_log(9, &limits());
    let before = disk.content();
    assert!(recover_on(&disk, folder()).unwrap().segments.is_empty());
    assert_eq!(disk.content(), before);
    let read = reader(&before).unwrap().records().map(Result::unwrap).collect::<Vec<_>>();
    let wanted: Vec<_> = (0..9).map(|n| (n, record(n))).collect();
    assert_eq!(read, wanted);
}
