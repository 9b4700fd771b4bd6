//! The whole log, including its thread, on a disk that fills up, fails, or is slow.

use std::{
    io::ErrorKind,
    sync::Arc,
    thread,
    time::{Duration, Instant},
};

use super::{
    super::{
        AppendError, RawLog, RawLogError, RawLogReader, RawLogWriter, recovery::recover_on,
        settings::Limits, storage::model::Faults,
    },
    DESCRIPTION, ModelDisk, folder, limits, record,
};

fn log_on(disk: &ModelDisk, limits: &Limits) -> (RawLog, RawLogWriter) {
    RawLog::create_on(Arc::new(disk.clone()), folder(), DESCRIPTION, limits).unwrap()
}

/// Appends until the log rejects a record; returns the number accepted.
fn append_until_it_fails(log: &RawLog) -> u64 {
    (0..).take_while(|number| log.append_blocking(record(*number)).is_ok()).count() as u64
}

fn wait_until(mut is_so: impl FnMut() -> bool) {
    let started = Instant::now();
    while !is_so() {
        assert!(started.elapsed() < Duration::from_secs(10), "waited for too long");
        thread::sleep(Duration::from_millis(1));
    }
}

/// The number of records on the disk, after checking content and order.
fn records_on(disk: &ModelDisk) -> u64 {
    recover_on(disk, folder()).unwrap();
    let reader = RawLogReader::open_on(Arc::new(disk.clone()), folder()).unwrap();
    let mut count = 0;
    for read in reader.records() {
        assert_eq!(read.unwrap(), (count, record(count)));
        count += 1;
    }
    count
}

#[test]
fn a_full_disk_ends_the_log_and_everything_written_is_there() {
    for quota_bytes in [1500, 4000, 9999, 20_000] {
        let disk = ModelDisk::default();
        let (log, writer) = log_on(&disk, &limits());
        disk.set_faults(Faults { quota_bytes: Some(quota_bytes), ..Default::default() });
        let taken = append_until_it_fails(&log);
        let failure = log.failure().unwrap().to_string();
        assert!(failure.contains("free space on the disk of run/raw/segment_"), "{failure}");
        assert!(failure.contains("`lfpiv process RUN` measures what was recorded"), "{failure}");
        let marks = log.watermarks();
        assert_eq!(marks.appended, taken);
        assert!(marks.written < taken, "{marks:?}");
        assert_eq!(marks.synced, marks.written, "what was written could still be synced");
        assert!(matches!(log.try_append(record(0)), Err(AppendError::Failed(_))));
        assert!(matches!(log.reserve(0), Err(RawLogError::Stopped(_))));
        assert!(matches!(writer.close(), Err(RawLogError::Stopped(_))));
        disk.set_faults(Faults::default());
        assert_eq!(records_on(&disk), marks.written);
    }
}

#[test]
fn written_records_survive_the_failure_of_any_operation() {
    let mut failed = 0;
    for at in 0..60_u64 {
        for kind in [ErrorKind::ReadOnlyFilesystem, ErrorKind::Other] {
            let disk = ModelDisk::default();
            let (log, writer) = log_on(&disk, &limits());
            let fails_at = Some((at, kind));
            disk.set_faults(Faults {
                fails_at,
                stays_failed: at.is_multiple_of(2),
                ..Default::default()
            });
            for number in 0..100 {
                if log.append_blocking(record(number)).is_err() {
                    break;
                }
                if number.is_multiple_of(10) {
                    thread::sleep(Duration::from_micros(300));
                }
            }
            let closed = writer.close();
            let marks = log.watermarks();
            assert_eq!(closed.is_err(), log.failure().is_some());
            failed += usize::from(closed.is_err());
            if let Some(failure) = log.failure() {
                assert!(
                    failure.to_string().contains("recording of raw data has stopped"),
                    "{failure}"
                );
                assert!(failure.to_string().contains("dmesg"), "{failure}");
            }
            disk.set_faults(Faults::default());
            // There may be more: a batch whose truncation failed, too.
            assert!(records_on(&disk) >= marks.written, "{at}: {marks:?}");
        }
    }
    assert!(failed > 100, "{failed} of 120 failed");
}

#[test]
fn a_slow_disk_makes_those_wait_who_append_and_nothing_is_lost() {
    let disk = ModelDisk::default();
    let limits = Limits { queue_bytes: 1000, ..limits() };
    let (log, writer) = log_on(&disk, &limits);
    disk.set_faults(Faults { delay: Duration::from_millis(4), ..Default::default() });
    let mut refused = 0;
    let mut most_waiting = 0;
    for number in 0..200 {
        match log.try_append(record(number)) {
            Ok(sequence) => assert_eq!(sequence, number),
            Err(AppendError::Full(back)) => {
                refused += 1;
                assert_eq!(log.append_blocking(back).unwrap(), number);
            }
            Err(AppendError::Failed(error)) => panic!("{error}"),
        }
        most_waiting = most_waiting.max(log.queued_bytes());
    }
    assert!(refused > 10, "{refused}");
    assert!(most_waiting <= limits.queue_bytes, "{most_waiting}");
    let marks = writer.close().unwrap();
    assert_eq!((marks.appended, marks.written, marks.synced), (200, 200, 200));
    let bytes_in: u64 = (0..200).map(|number| record(number).bytes()).sum();
    assert_eq!(marks.bytes_in, bytes_in);
    let bytes: usize = disk.content().named().values().map(|bytes| bytes.len()).sum();
    assert_eq!(marks.bytes_written, bytes as u64);
    assert_eq!(records_on(&disk), 200);
}

#[test]
fn tasks_wait_for_space_without_blocking_their_thread() {
    let disk = ModelDisk::default();
    let (log, writer) = log_on(&disk, &Limits { queue_bytes: 2000, ..limits() });
    disk.set_faults(Faults { delay: Duration::from_millis(2), ..Default::default() });
    let runtime = tokio::runtime::Builder::new_current_thread().enable_time().build().unwrap();
    let ticks = runtime.block_on(async {
        let appending = async {
            for number in 0..60 {
                assert_eq!(log.append(record(number)).await.unwrap(), number);
            }
        };
        let mut ticks = 0;
        let ticking = async {
            loop {
                tokio::time::sleep(Duration::from_millis(1)).await;
                ticks += 1;
            }
        };
        tokio::select! { () = appending => {}, () = ticking => {} }
        ticks
    });
    assert!(ticks > 5, "{ticks}");
    writer.close().unwrap();
    assert_eq!(records_on(&disk), 60);
}

#[test]
fn a_record_larger_than_the_queue_passes_alone() {
    let disk = ModelDisk::default();
    let (log, writer) = log_on(&disk, &Limits { queue_bytes: 1, ..limits() });
    for number in 0..10 {
        log.append_blocking(record(number)).unwrap();
    }
    writer.close().unwrap();
    assert_eq!(records_on(&disk), 10);
}

#[test]
fn the_arm_gate_refuses_with_reasons() {
    let disk = ModelDisk::default();
    disk.set_faults(Faults { quota_bytes: Some(10_000_000), ..Default::default() });
    let limits = Limits { reserve_bytes: 4_000_000, queue_bytes: 2000, ..limits() };
    let (log, writer) = log_on(&disk, &limits);
    log.reserve(5_900_000).unwrap();
    let message = log.reserve(6_100_000).unwrap_err().to_string();
    assert!(message.contains("has 9 MB free and 11 MB are needed (7 MB of"), "{message}");
    let delay = Duration::from_millis(300);
    disk.set_faults(Faults { delay, ..Default::default() });
    let mut number = 0;
    while log.try_append(record(number)).is_ok() {
        number += 1;
    }
    let error = log.reserve(1).unwrap_err();
    assert!(matches!(error, RawLogError::Backlog { .. }), "{error}");
    disk.set_faults(Faults::default());
    writer.close().unwrap();
    let message = log.reserve(1).unwrap_err().to_string();
    assert!(message.contains("is closed"), "{message}");
}

#[test]
fn watchers_see_every_step_to_the_disk_and_a_failure() {
    let disk = ModelDisk::default();
    let (log, writer) = log_on(&disk, &limits());
    let mut watch = log.watch();
    for number in 0..5 {
        log.append_blocking(record(number)).unwrap();
    }
    wait_until(|| watch.borrow_and_update().synced == 5);
    disk.set_faults(Faults {
        fails_at: Some((0, ErrorKind::Other)),
        stays_failed: true,
        ..Default::default()
    });
    log.append_blocking(record(5)).unwrap();
    wait_until(|| watch.has_changed().unwrap());
    let marks = *watch.borrow();
    assert_eq!((marks.appended, marks.written, marks.synced), (6, 5, 5));
    assert!(log.failure().is_some());
    drop(writer);
}

#[test]
fn waiting_appenders_are_woken_when_the_writer_panics() {
    let disk = ModelDisk::default();
    let (log, writer) = log_on(&disk, &Limits { queue_bytes: 500, ..limits() });
    disk.set_faults(Faults { panics: true, ..Default::default() });
    append_until_it_fails(&log);
    let failure = log.failure().unwrap().to_string();
    assert!(failure.contains("the writer thread of run/raw panicked"), "{failure}");
    assert!(writer.close().is_err());
}

#[test]
fn a_closed_log_rejects_records_and_dropping_the_writer_closes_it() {
    let disk = ModelDisk::default();
    let (log, writer) = log_on(&disk, &limits());
    log.append_blocking(record(0)).unwrap();
    drop(writer);
    assert!(log.failure().is_none());
    let error = log.append_blocking(record(1)).unwrap_err().to_string();
    assert!(error.contains("is closed"), "{error}");
    assert_eq!(log.watermarks().synced, 1);
    assert!(recover_on(&disk, folder()).unwrap().segments.is_empty());
    assert_eq!(records_on(&disk), 1);
}

#[test]
fn a_folder_with_a_log_is_not_written_to() {
    let disk = ModelDisk::default();
    drop(log_on(&disk, &limits()));
    let again = RawLog::create_on(Arc::new(disk), folder(), DESCRIPTION, &limits());
    let message = again.unwrap_err().to_string();
    assert!(message.contains("already holds a raw log"), "{message}");
}

#[test]
fn an_oversized_record_is_refused_and_the_log_continues() {
    let disk = ModelDisk::default();
    let (log, writer) = log_on(&disk, &limits());
    // No pixels, so no memory, but more columns than fit into 32 bits.
    let image = lfpiv_hw::RawImage::new(1 << 33, 0, Vec::new()).unwrap();
    let too_large = super::Record { head: Vec::new(), image: Some(image) };
    let message = log.append_blocking(too_large).unwrap_err().to_string();
    assert!(message.contains("an image of 8589934592 x 0 pixels cannot be"), "{message}");
    assert_eq!(log.append_blocking(record(0)).unwrap(), 0);
    writer.close().unwrap();
    assert_eq!(records_on(&disk), 1);
}
