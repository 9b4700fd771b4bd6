//! Segments that are missing, swapped or from another log are detected by the chain of headers.

use super::{
    super::{
        RawLogError,
        names::{part_path, sealed_path},
        storage::model::Content,
    },
    folder, limits, reader,
    reading::{read_all, segments},
    recovering::unsealed,
    sealed_log,
};

const RECORDS: u64 = 30;

#[test]
fn a_lost_segment_is_reported_once_with_its_records() {
    let whole = sealed_log(RECORDS, &limits()).content();
    for number in 0..segments(&whole) - 1 {
        let mut left = whole.clone();
        left.remove(&sealed_path(folder(), number));
        let (right, errors) = read_all(&reader(&left).unwrap());
        let [RawLogError::Missing { records, .. }] = &errors[..] else { panic!("{errors:?}") };
        let wanted: Vec<u64> = (0..RECORDS).filter(|n| !records.contains(n)).collect();
        assert_eq!(right, wanted);
        assert!(!records.is_empty());
        let message = errors[0].to_string();
        assert!(message.contains(&format!("segment_00000{number}.raw is lost")), "{message}");
    }
}

#[test]
fn lost_last_segments_are_reported() {
    for whole in
        [sealed_log(RECORDS, &limits()).content(), unsealed(&sealed_log(RECORDS, &limits())).0]
    {
        let mut left = whole.clone();
        let last = segments(&sealed_log(RECORDS, &limits()).content()) - 1;
        for number in (1..=last).rev() {
            left.remove(&sealed_path(folder(), number));
            left.remove(&part_path(folder(), number));
            let (right, errors) = read_all(&reader(&left).unwrap());
            let [RawLogError::MissingEnd { first, segment, .. }] = &errors[..] else {
                panic!("{errors:?}")
            };
            assert_eq!((*first, *segment), (right.len() as u64, number));
            assert_eq!(right, (0..*first).collect::<Vec<_>>());
        }
    }
}

#[test]
fn a_log_without_any_damage_says_nothing() {
    let closed = sealed_log(RECORDS, &limits());
    for content in [closed.content(), unsealed(&closed).0] {
        let (right, errors) = read_all(&reader(&content).unwrap());
        assert_eq!(right, (0..RECORDS).collect::<Vec<_>>());
        assert!(errors.is_empty(), "{errors:?}");
    }
}

#[test]
fn a_segment_of_another_log_is_rejected() {
    let mut content = sealed_log(RECORDS, &limits()).content();
    // The same records and description, created at another time.
    let other = sealed_log(RECORDS, &limits()).content();
    let path = sealed_path(folder(), 1);
    *content.file_mut(&path).unwrap() = other.file(&path).unwrap().clone();
    let (_, errors) = read_all(&reader(&content).unwrap());
    let message = errors[0].to_string();
    assert!(message.contains("belongs to another log"), "{message}");
}

#[test]
fn a_rewritten_segment_breaks_the_chain() {
    let mut content = sealed_log(RECORDS, &limits()).content();
    let path = sealed_path(folder(), 1);
    // A whole segment of this log, but not the one that its successor names: cut and recovered.
    let file = content.file_mut(&path).unwrap();
    file.truncate(file.len() - 40);
    let bytes = file.clone();
    content.remove(&path);
    content.add(&part_path(folder(), 1), bytes);
    let content = recovered(content);
    let (_, errors) = read_all(&reader(&content).unwrap());
    let told = errors.iter().any(|error| error.to_string().contains("does not name the segment"));
    assert!(told, "{errors:?}");
}

fn recovered(content: Content) -> Content {
    let disk = super::ModelDisk::holding(content);
    super::super::recovery::recover_on(&disk, folder()).unwrap();
    disk.content()
}

#[test]
fn a_file_with_a_far_too_high_number_is_reported_at_once() {
    let mut content = sealed_log(RECORDS, &limits()).content();
    content.add(&sealed_path(folder(), u32::MAX - 1), b"no segment".to_vec());
    let (right, errors) = read_all(&reader(&content).unwrap());
    assert_eq!(right.len() as u64, RECORDS);
    assert!(matches!(errors[..], [RawLogError::Damaged(_)]), "{errors:?}");
}
