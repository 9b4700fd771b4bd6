//! What recording costs with each codec, beside a plain copy of the same bytes and beside the
//! libraries that were not taken: `cargo bench --package lfpiv-bench --bench raw_log`. The table in docs/raw-log.md is
//! its output.
#![allow(clippy::unwrap_used)]

use std::{fs, hint::black_box, path::Path, time::Instant};

use bitpacking::{BitPacker, BitPacker4x};
use lfpiv::config::ConfigFile;
use lfpiv_hw::RawImage;
use lfpiv_rawlog::{
    Codec,
    measure::{DiskSpeed, codec_speed, copy_speed, log_speed, reading_mb_per_s},
};
use lfpiv_sim::{BenchGeometry, Scene};

const CODECS: [(&str, Codec); 3] =
    [("raw", Codec::Raw), ("packed", Codec::Packed), ("zstd", Codec::Zstd)];

/// Bytes of counts that each log and copy has.
const RECORDED_BYTES: usize = 250_000_000;

/// Turns on the disk, of which the fastest counts.
const TURNS: usize = 5;

/// Rounds in memory, of which the fastest counts.
const ROUNDS: usize = 7;

fn main() {
    // `cargo test --benches` starts this, too.
    if !std::env::args().any(|argument| argument == "--bench") {
        return;
    }
    for (name, images) in cases() {
        println!("\n{name}, ray-traced at 1 ppm with shot and read noise; MB of 16-bit counts\n");
        in_memory(&images);
        on_disk(&images);
    }
}

/// The bench of config/bench.toml, a quarter of its sensor's width and height, and 8 bits.
fn cases() -> Vec<(String, Vec<RawImage>)> {
    let config = Path::new("config/bench.toml");
    let config = ConfigFile::load(config).unwrap().config;
    let (large, scene) = (config.bench_geometry(), config.simulation.clone().unwrap());
    let mut small = large.clone();
    (small.optics.sensor.columns, small.optics.sensor.rows) = (588, 442);
    (small.optics.microlens.columns, small.optics.microlens.rows) = (32, 24);
    small.volume.voxels = small.volume.voxels.map(|voxels| voxels / 4);
    let mut eight_bits = scene.clone();
    eight_bits.sensor.bits = 8;
    eight_bits.sensor.gain_counts_per_electron /= 16.0;
    eight_bits.sensor.offset_counts /= 16.0;
    vec![case(&small, &scene, 8), case(&large, &scene, 2), case(&large, &eight_bits, 2)]
}

fn case(bench: &BenchGeometry, scene: &Scene, shots: u64) -> (String, Vec<RawImage>) {
    let images: Vec<RawImage> =
        (0..shots).flat_map(|shot| scene.shot(bench, 1, shot).images).flatten().collect();
    let sensor = &bench.optics.sensor;
    (format!("{} x {}, {} bit", sensor.columns, sensor.rows, scene.sensor.bits), images)
}

fn in_memory(images: &[RawImage]) {
    println!("| in memory, one thread | share | encode MB/s | decode MB/s |\n|---|---|---|---|");
    for (name, codec) in CODECS {
        let speed = codec_speed(codec, images, ROUNDS).unwrap();
        println!(
            "| {name} | {:.3} | {:.0} | {:.0} |",
            speed.share, speed.encode_mb_per_s, speed.decode_mb_per_s
        );
    }
    peer("lz4 of byte planes (lz4_flex)", images, |counts| {
        lz4_flex::block::compress(&byte_planes(counts)).len()
    });
    peer("zstd of differences between pixels", images, |counts| {
        zstd::bulk::compress(&byte_planes(&differences(counts)), 1).unwrap().len()
    });
    peer("packed by the crate bitpacking", images, bitpacked_bytes);
}

fn peer(name: &str, images: &[RawImage], stored_bytes: impl Fn(&[u16]) -> usize) {
    let (mut seconds, mut stored) = (f64::INFINITY, 0);
    for _ in 0..ROUNDS {
        let started = Instant::now();
        stored = images.iter().map(|image| stored_bytes(black_box(image.counts()))).sum();
        seconds = seconds.min(started.elapsed().as_secs_f64());
    }
    let bytes = bytes_of(images) as f64;
    println!("| {name} | {:.3} | {:.0} | |", stored as f64 / bytes, bytes / 1e6 / seconds);
}

fn on_disk(images: &[RawImage]) {
    let times = RECORDED_BYTES.div_ceil(bytes_of(images));
    let folder = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap();
    let mut copies = Vec::new();
    let mut logs = CODECS.map(|_| Vec::new());
    let mut reading = CODECS.map(|_| 0_f64);
    // A copy that does not count goes before each: whoever follows a removed file finds memory
    // for its pages free.
    let copy = || copy_speed(folder.path(), images, times).unwrap();
    for _ in 0..TURNS {
        copy();
        copies.push(copy());
        for (number, (_, codec)) in CODECS.into_iter().enumerate() {
            copy();
            let log = folder.path().join("raw");
            logs[number].push(log_speed(&log, codec, images, times).unwrap());
            reading[number] = reading[number].max(reading_mb_per_s(&log).unwrap());
            fs::remove_dir_all(&log).unwrap();
        }
    }
    let copy = fastest(&copies);
    println!(
        "\n| to disk and fsynced | share | MB/s | time over plain copy | processor s per GB | read \
         MB/s |\n|---|---|---|---|---|---|"
    );
    println!("| plain copy | 1.000 | {:.0} | 1.00 | {:.2} | |", copy.mb_per_s(), processor(&copy));
    for (number, (name, _)) in CODECS.into_iter().enumerate() {
        let log = fastest(&logs[number]);
        println!(
            "| log, {name} | {:.3} | {:.0} | {:.2} | {:.2} | {:.0} |",
            log.bytes_written as f64 / log.bytes_in as f64,
            log.mb_per_s(),
            log.seconds / copy.seconds,
            processor(&log),
            reading[number],
        );
    }
}

fn fastest(speeds: &[DiskSpeed]) -> DiskSpeed {
    *speeds.iter().min_by(|a, b| a.seconds.total_cmp(&b.seconds)).unwrap()
}

fn processor(speed: &DiskSpeed) -> f64 {
    speed.processor_s / (speed.bytes_in as f64 / 1e9)
}

fn bytes_of(images: &[RawImage]) -> usize {
    images.iter().map(|image| 2 * image.counts().len()).sum()
}

fn byte_planes(counts: &[u16]) -> Vec<u8> {
    let mut planes = Vec::with_capacity(2 * counts.len());
    planes.extend(counts.iter().map(|count| *count as u8));
    planes.extend(counts.iter().map(|count| (*count >> 8) as u8));
    planes
}

/// Each count less the one before, small numbers of either sign as small ones.
fn differences(counts: &[u16]) -> Vec<u16> {
    let mut before = 0;
    let difference = |count: &u16| {
        let difference = count.wrapping_sub(before) as i16;
        before = *count;
        ((difference << 1) ^ (difference >> 15)) as u16
    };
    counts.iter().map(difference).collect()
}

fn bitpacked_bytes(counts: &[u16]) -> usize {
    let packer = BitPacker4x::new();
    let mut packed = vec![0; 4 * counts.len() + 1024];
    let mut end = 0;
    let mut block = [0_u32; BitPacker4x::BLOCK_LEN];
    for counts in counts.chunks_exact(block.len()) {
        let smallest = counts.iter().copied().min().unwrap_or(0);
        for (difference, count) in block.iter_mut().zip(counts) {
            *difference = u32::from(count - smallest);
        }
        let width = packer.num_bits(&block);
        packed[end..end + 2].copy_from_slice(&smallest.to_le_bytes());
        packed[end + 2] = width;
        end += 3 + packer.compress(&block, &mut packed[end + 3..], width);
    }
    black_box(&packed);
    end
}
