//! Benchmarks of recording: codecs in memory, and the whole log beside a plain copy of the same
//! bytes to the same disk.

use std::{
    fs::{self, File},
    hint::black_box,
    io::{self, Write},
    path::Path,
    time::Instant,
};

use lfpiv_hw::RawImage;
use rustix::time::{ClockId, clock_gettime};
use serde::Serialize;

use super::{
    Codec, RawLog, RawLogError, RawLogReader, RawLogSettings, Record,
    codec::{Encoder, decode},
};

const BYTES_PER_MB: f64 = 1e6;

/// Speed of a codec in memory, on one thread. MB refer to 16-bit counts.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CodecSpeed {
    /// MB of images stored per second.
    pub encode_mb_per_s: f64,
    /// MB of images decoded per second.
    pub decode_mb_per_s: f64,
    /// Compressed size over size of the counts.
    pub share: f64,
}

/// Speed of writing images to disk, including fsync.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct DiskSpeed {
    /// Wall-clock time until all data is synced, in s.
    pub seconds: f64,
    /// Processor time of all threads during that, in s.
    pub processor_s: f64,
    /// Bytes of 16-bit counts.
    pub bytes_in: u64,
    /// Bytes of all files.
    pub bytes_written: u64,
}

impl DiskSpeed {
    /// MB of images per second.
    pub fn mb_per_s(&self) -> f64 {
        self.bytes_in as f64 / BYTES_PER_MB / self.seconds
    }
}

/// Measures a codec: the fastest of `rounds` rounds over all images.
///
/// # Errors
/// Memory allocation fails.
pub fn codec_speed(codec: Codec, images: &[RawImage], rounds: usize) -> io::Result<CodecSpeed> {
    let mut encoder = Encoder::new(codec)?;
    let mut stored: Vec<(u32, Vec<u8>)> = images.iter().map(|_| (0, Vec::new())).collect();
    let (mut encode_s, mut decode_s) = (f64::INFINITY, f64::INFINITY);
    for _ in 0..rounds {
        let started = Instant::now();
        for (image, (number, bytes)) in images.iter().zip(&mut stored) {
            bytes.clear();
            *number = encoder.encode(image, bytes)?;
        }
        encode_s = encode_s.min(started.elapsed().as_secs_f64());
        let started = Instant::now();
        for (image, (number, bytes)) in images.iter().zip(&stored) {
            let size = (image.columns() as u32, image.rows() as u32);
            black_box(decode(bytes, *number, size.0, size.1));
        }
        decode_s = decode_s.min(started.elapsed().as_secs_f64());
    }
    let bytes_in = bytes_of(images) as f64;
    let bytes_stored: usize = stored.iter().map(|(_, bytes)| bytes.len()).sum();
    Ok(CodecSpeed {
        encode_mb_per_s: bytes_in / BYTES_PER_MB / encode_s,
        decode_mb_per_s: bytes_in / BYTES_PER_MB / decode_s,
        share: bytes_stored as f64 / bytes_in,
    })
}

/// Records the images `times` times in a new log.
///
/// # Errors
/// As for the log.
pub fn log_speed(
    folder: &Path,
    codec: Codec,
    images: &[RawImage],
    times: usize,
) -> Result<DiskSpeed, RawLogError> {
    let settings = RawLogSettings { codec, reserve_mb: 0, ..RawLogSettings::default() };
    let clocks = Stopwatch::start();
    let (log, writer) = RawLog::create(folder, b"{}", &settings)?;
    for image in (0..times).flat_map(|_| images) {
        let head = br#"{"camera":1,"frame":"a","frame_id":65535}"#.to_vec();
        log.append_blocking(Record { head, image: Some(image.clone()) })?;
    }
    let marks = writer.close()?;
    let bytes_in = times as u64 * bytes_of(images);
    Ok(clocks.stop(bytes_in, marks.bytes_written))
}

/// Reads a whole log, decoding and checking every image; returns MB of images per second.
///
/// # Errors
/// As for the log.
pub fn reading_mb_per_s(folder: &Path) -> Result<f64, RawLogError> {
    let started = Instant::now();
    let mut bytes = 0;
    for read in RawLogReader::open(folder)?.records() {
        bytes += read?.1.bytes();
    }
    Ok(bytes as f64 / BYTES_PER_MB / started.elapsed().as_secs_f64())
}

/// Writes the counts of the images `times` times to a plain file, syncs it and removes it: a lower
/// bound of the cost of recording.
///
/// # Errors
/// A file operation fails.
pub fn copy_speed(folder: &Path, images: &[RawImage], times: usize) -> io::Result<DiskSpeed> {
    let bytes: Vec<Vec<u8>> = images
        .iter()
        .map(|image| image.counts().iter().flat_map(|count| count.to_le_bytes()).collect())
        .collect();
    let path = folder.join("plain-copy");
    let clocks = Stopwatch::start();
    let mut file = File::create(&path)?;
    for bytes in (0..times).flat_map(|_| &bytes) {
        file.write_all(bytes)?;
    }
    file.sync_all()?;
    let bytes_in = times as u64 * bytes_of(images);
    let speed = clocks.stop(bytes_in, bytes_in);
    fs::remove_file(&path)?;
    Ok(speed)
}

struct Stopwatch {
    started: Instant,
    processor_s: f64,
}

impl Stopwatch {
    fn start() -> Self {
        Self { started: Instant::now(), processor_s: processor_s() }
    }

    fn stop(&self, bytes_in: u64, bytes_written: u64) -> DiskSpeed {
        DiskSpeed {
            seconds: self.started.elapsed().as_secs_f64(),
            processor_s: processor_s() - self.processor_s,
            bytes_in,
            bytes_written,
        }
    }
}

/// Processor time of this process so far, in s.
fn processor_s() -> f64 {
    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
}

fn bytes_of(images: &[RawImage]) -> u64 {
    images.iter().map(|image| 2 * image.counts().len() as u64).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn speeds_count_two_bytes_for_every_pixel() {
        let image = |columns: usize| RawImage::new(columns, 3, vec![900; 3 * columns]).unwrap();
        let images = [image(4), image(5)];
        let speed = codec_speed(Codec::Raw, &images, 1).unwrap();
        assert_eq!(speed.share, 1.0, "not compressed");
        let folder = tempfile::tempdir().unwrap();
        let copied = copy_speed(folder.path(), &images, 7).unwrap();
        assert_eq!(copied.bytes_in, 7 * 2 * 3 * (4 + 5));
        assert_eq!(copied.bytes_in, copied.bytes_written);
    }
}
