//! The log as a whole: on a failing disk, on a real one, and from damaged files.

mod crash;
mod disk_full;
mod failing_disk;
mod flips;
mod live;
mod missing;
mod reading;
mod recovering;

use std::{path::Path, sync::Arc, time::Duration};

use lfpiv_hw::RawImage;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::{
    Codec, RawLogError, RawLogReader, Record,
    segments::Segments,
    settings::Limits,
    storage::model::{Content, ModelDisk},
};

const DESCRIPTION: &[u8] = br#"{"run":"test"}"#;

fn folder() -> &'static Path {
    Path::new("run/raw")
}

/// Limits that give segments of a few small records.
fn limits() -> Limits {
    Limits {
        codec: Codec::Auto,
        segment_bytes: 1300,
        sync_interval: Duration::from_millis(5),
        queue_bytes: 1_000_000,
        reserve_bytes: 0,
    }
}

/// Record number `number`: all kinds, reproducible.
fn record(number: u64) -> Record {
    let mut random = Pcg64Mcg::seed_from_u64(number);
    let head = format!(r#"{{"number":{number},"note":"{}"}}"#, "n".repeat((number % 23) as usize));
    let (columns, rows) = (random.random_range(1..24), random.random_range(1..12));
    let bits = random.random_range(0..=16_u32);
    let counts = (0..columns * rows).map(|_| random.random_range(0..1_u32 << bits) as u16);
    let image = RawImage::new(columns, rows, counts.collect()).unwrap();
    Record { head: head.into_bytes(), image: (!number.is_multiple_of(4)).then_some(image) }
}

/// A closed log of the first records, on its own disk.
fn sealed_log(records: u64, limits: &Limits) -> ModelDisk {
    let disk = ModelDisk::default();
    let storage = Arc::new(disk.clone());
    let mut segments = Segments::create(storage, folder(), DESCRIPTION, limits).unwrap();
    for number in 0..records {
        segments.append(&record(number)).unwrap();
    }
    segments.finish().unwrap();
    disk
}

/// A reader of a log without a writer.
fn reader(content: &Content) -> Result<RawLogReader, RawLogError> {
    let disk = Arc::new(ModelDisk::holding(content.clone()));
    Ok(RawLogReader::open_on(disk, folder())?.finished())
}
