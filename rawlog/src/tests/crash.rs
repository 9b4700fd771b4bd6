//! Power cuts and process deaths at every operation: acknowledged records survive, in order, once.

use std::{io::ErrorKind, sync::Arc};

use proptest::{collection::vec, prelude::*, test_runner::RngSeed};
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::{
    super::{
        RawLogError, RawLogReader,
        recovery::recover_on,
        segments::{Progress, Segments},
        storage::model::{Content, Faults, ModelDisk},
    },
    DESCRIPTION, folder, limits,
    reading::read_all,
    record,
};

#[derive(Debug, Clone, Copy)]
enum Action {
    Append,
    Flush,
    Sync,
}

#[derive(Debug, Clone)]
struct Fault {
    /// Share (of 256) of the operations after which the disk fails.
    after: u8,
    kind: ErrorKind,
    stays_failed: bool,
}

/// LogWatermarks after this many operations.
#[derive(Debug, Clone, Copy)]
struct Acknowledged {
    operations: usize,
    progress: Progress,
}

fn actions() -> impl Strategy<Value = Vec<Action>> {
    let action =
        prop_oneof![4 => Just(Action::Append), 2 => Just(Action::Flush), 1 => Just(Action::Sync)];
    vec(action, 1..40)
}

fn fault() -> impl Strategy<Value = Option<Fault>> {
    let kind = prop_oneof![
        Just(ErrorKind::StorageFull),
        Just(ErrorKind::ReadOnlyFilesystem),
        Just(ErrorKind::Other)
    ];
    let fault = (any::<u8>(), kind, any::<bool>());
    proptest::option::of(fault.prop_map(|(after, kind, stays_failed)| Fault {
        after,
        kind,
        stays_failed,
    }))
}

const OLDER_DESCRIPTION: &[u8] = br#"{"run":"past"}"#;

/// An earlier log on the same disk, whose blocks may reappear.
fn older_log() -> Content {
    let disk = ModelDisk::default();
    let mut segments =
        Segments::create(Arc::new(disk.clone()), "old".as_ref(), OLDER_DESCRIPTION, &limits())
            .unwrap();
    for number in 0..12 {
        segments.append(&record(number)).unwrap();
    }
    segments.finish().unwrap();
    disk.content()
}

/// Runs the actions until they or the disk end; returns the watermarks after each action.
fn write(disk: &ModelDisk, actions: &[Action]) -> Vec<Acknowledged> {
    let mut acknowledged = Vec::new();
    let mut note = |progress| {
        acknowledged.push(Acknowledged { operations: disk.operations(), progress });
    };
    let storage = Arc::new(disk.clone());
    let Ok(mut segments) = Segments::create(storage, folder(), DESCRIPTION, &limits()) else {
        return acknowledged;
    };
    note(segments.progress());
    let mut number = 0;
    let mut act = |segments: &mut Segments, action| match action {
        Action::Append => {
            number += 1;
            segments.append(&record(number - 1))
        }
        Action::Flush => segments.flush(),
        Action::Sync => segments.flush().and_then(|()| segments.sync()),
    };
    for action in actions {
        if act(&mut segments, *action).is_err() {
            segments.rescue();
            note(segments.progress());
            return acknowledged;
        }
        note(segments.progress());
    }
    if segments.finish().is_ok() {
        note(segments.progress());
    }
    acknowledged
}

/// The sequence numbers read, after checking content and order, and whether damage was reported.
fn right_records(disk: &ModelDisk) -> (Vec<u64>, bool) {
    let reader = match RawLogReader::open_on(Arc::new(disk.clone()), folder()) {
        Ok(reader) => reader.finished(),
        Err(RawLogError::NoSegment { .. }) => return (Vec::new(), false),
        Err(error) => panic!("{error}"),
    };
    if reader.description() == OLDER_DESCRIPTION {
        // The first bytes of the log are lost and an older log shows in their place.
        return (Vec::new(), false);
    }
    assert_eq!(reader.description(), DESCRIPTION);
    let (right, errors) = read_all(&reader);
    (right, !errors.is_empty())
}

/// The number of records read, none of which may be missing in between.
fn count_right_records(disk: &ModelDisk) -> u64 {
    let (right, is_damaged) = right_records(disk);
    assert!(!is_damaged && right.iter().copied().eq(0..right.len() as u64), "{right:?}");
    right.len() as u64
}

fn sealed_files(content: &Content) -> Vec<(String, Vec<u8>)> {
    let named = content.named().into_iter();
    let sealed = named
        .filter(|(path, _)| path.starts_with(folder()) && path.extension() == Some("raw".as_ref()));
    sealed.map(|(path, bytes)| (path.display().to_string(), bytes.to_vec())).collect()
}

/// Recovers what a crash left and checks it against the watermarks; returns the recovered disk.
fn check_recovery(left: Content, at_least: u64) -> ModelDisk {
    let sealed_before = sealed_files(&left);
    let disk = ModelDisk::holding(left);
    match recover_on(&disk, folder()) {
        Ok(_) => {}
        Err(RawLogError::NoSegment { .. }) => assert_eq!(at_least, 0),
        Err(error) => panic!("{error}"),
    }
    let content = disk.content();
    for (path, bytes) in sealed_before {
        assert!(content.file(path.as_ref()) == Some(&bytes), "{path} was touched");
    }
    // A power cut may keep later records without earlier ones, but only unacknowledged ones.
    let (right, is_damaged) = right_records(&disk);
    let promised = right.iter().take_while(|number| **number < at_least).count() as u64;
    assert_eq!(promised, at_least, "{at_least} records were promised: {right:?}");
    let has_holes = !right.iter().copied().eq(0..right.len() as u64);
    assert!(is_damaged || !has_holes, "missing records were not reported: {right:?}");
    if let Ok(again) = recover_on(&disk, folder()) {
        assert!(again.segments.is_empty(), "{again:?}");
    }
    assert!(disk.content() == content, "the second recovery changed something");
    disk
}

fn last_before(acknowledged: &[Acknowledged], operations: usize) -> Progress {
    let before = acknowledged.iter().take_while(|noted| noted.operations <= operations);
    before.last().map(|noted| noted.progress).unwrap_or_default()
}

/// Interrupts the recovery at some operation, and recovers from that.
fn check_recovery_that_is_cut(left: &Content, at_least: u64, random: &mut impl Rng) {
    let disk = ModelDisk::holding(left.clone());
    let _ = recover_on(&disk, folder());
    let operations = random.random_range(0..=disk.operations());
    check_recovery(disk.after_power_cut(operations, random), at_least);
    check_recovery(disk.after_death(operations, random.random()), at_least);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, rng_seed: RngSeed::Fixed(11), ..Default::default() })]

    #[test]
    fn acknowledged_records_survive_a_crash_at_every_operation(
        actions in actions(), fault in fault(), seed in any::<u64>()
    ) {
        let whole = ModelDisk::holding(older_log());
        write(&whole, &actions);
        let disk = ModelDisk::holding(older_log());
        if let Some(Fault { after, kind, stays_failed }) = fault {
            let at = whole.operations() as u64 * u64::from(after) / 256;
            disk.set_faults(Faults { fails_at: Some((at, kind)), stays_failed, ..Default::default() });
        }
        let acknowledged = write(&disk, &actions);
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        for operations in 0..=disk.operations() {
            let progress = last_before(&acknowledged, operations);
            for share in [0, random.random()] {
                let left = check_recovery(disk.after_death(operations, share), progress.written);
                count_right_records(&left);
            }
            for _ in 0..3 {
                let left = disk.after_power_cut(operations, &mut random);
                check_recovery(left.clone(), progress.synced);
                check_recovery_that_is_cut(&left, progress.synced, &mut random);
            }
        }
        if fault.is_none() {
            let appended = actions.iter().filter(|a| matches!(a, Action::Append)).count();
            prop_assert_eq!(count_right_records(&disk), appended as u64);
        }
    }
}

/// Guards the test above against a model disk that loses nothing and a log that syncs nothing.
#[test]
fn the_model_disk_loses_unsynced_data() {
    let disk = ModelDisk::default();
    let storage = Arc::new(disk.clone());
    let mut segments = Segments::create(storage, folder(), DESCRIPTION, &limits()).unwrap();
    for number in 0..5 {
        segments.append(&record(number)).unwrap();
        segments.flush().unwrap();
    }
    let mut random = Pcg64Mcg::seed_from_u64(1);
    let counts: Vec<usize> = (0..40)
        .map(|_| {
            let left = disk.after_power_cut(disk.operations(), &mut random);
            right_records(&check_recovery(left, 0)).0.len()
        })
        .collect();
    assert!(counts.contains(&0) && counts.iter().any(|count| *count > 1), "{counts:?}");
    assert_eq!(count_right_records(&check_recovery(disk.after_death(disk.operations(), 0), 5)), 5);
}

/// A log on a disk that fails at its next operation, with three records that are written but not synced.
fn about_to_fail() -> (ModelDisk, Segments) {
    let disk = ModelDisk::default();
    let storage = Arc::new(disk.clone());
    let mut segments = Segments::create(storage, folder(), DESCRIPTION, &limits()).unwrap();
    (0..3).for_each(|number| segments.append(&record(number)).unwrap());
    segments.flush().unwrap();
    disk.set_faults(Faults { fails_at: Some((0, ErrorKind::StorageFull)), ..Default::default() });
    (disk, segments)
}

#[test]
fn records_before_a_failed_write_are_synced() {
    let (disk, mut segments) = about_to_fail();
    assert!(segments.append(&record(3)).and_then(|()| segments.flush()).is_err());
    segments.rescue();
    assert_eq!(segments.progress().synced, 3);
    let left = disk.after_power_cut(disk.operations(), &mut Pcg64Mcg::seed_from_u64(1));
    check_recovery(left, 3);
}

/// A second sync may succeed without having written anything.
#[test]
fn a_failed_sync_is_not_tried_again() {
    let (disk, mut segments) = about_to_fail();
    assert!(segments.sync().is_err());
    let before = disk.operations();
    segments.rescue();
    assert_eq!((disk.operations(), segments.progress().synced), (before, 0));
}
