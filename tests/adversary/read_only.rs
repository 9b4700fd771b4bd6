//! A file system that becomes read-only after an error while records are synced.

use std::{thread, time::Duration};

use lfpiv_rawlog::{RawLog, RawLogReader, RawLogSettings, Record, recover};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::{loop_disk::LoopDisk, small_disk::in_namespace_of};

const MEGABYTES: u32 = 48;
const TURNS: u32 = 40;
/// More records than are written before the error; they all fit.
const MOST_RECORDS: usize = 1200;

#[test]
fn synced_records_survive_a_file_system_error() {
    match in_namespace_of(&["-m"], "read_only::half_of_an_error") {
        Some(passed) => assert!(passed, "see above"),
        None => eprintln!("skipped: only root may break a file system"),
    }
}

#[test]
#[ignore = "the half of synced_records_survive_... that runs in a namespace"]
fn half_of_an_error() {
    let root = tempfile::tempdir().expect("a folder");
    let folder = root.path().join("disk");
    let mut random = Pcg64Mcg::seed_from_u64(3);
    let mut lost = Vec::new();
    for turn in 0..TURNS {
        let Some(mut disk) = LoopDisk::mount(root.path(), &folder, MEGABYTES) else {
            eprintln!("skipped: there are no loop devices here");
            return;
        };
        let raw = folder.join("raw");
        let settings = RawLogSettings { sync_ms: 1, reserve_mb: 0, ..RawLogSettings::default() };
        let (log, writer) = RawLog::create(&raw, b"{}", &settings).expect("a log");
        let record = Record { head: vec![7; random.random_range(500..30_000)], image: None };
        thread::scope(|scope| {
            scope.spawn(|| append_until_it_fails(&log, &record));
            thread::sleep(Duration::from_micros(random.random_range(10_000..80_000)));
            disk.make_read_only();
        });
        writer.close().expect_err("a log on a disk that takes nothing");
        let synced = log.watermarks().synced;
        disk.mount_again();
        recover(&raw).expect("a log that can be made whole");
        let records = RawLogReader::open(&raw).expect("a log").records();
        let kept = records.map_while(Result::ok).filter(|(_, kept)| *kept == record).count() as u64;
        if kept < synced {
            lost.push(format!("turn {turn}: {kept} of {synced}"));
        }
    }
    assert!(lost.is_empty(), "records that were called synced are lost: {lost:?}");
}

fn append_until_it_fails(log: &RawLog, record: &Record) {
    for _ in 0..MOST_RECORDS {
        if log.append_blocking(record.clone()).is_err() {
            break;
        }
        thread::sleep(Duration::from_micros(300));
    }
}
