//! How fast the loopback is. Not a test: figures, for those who ask.
//!
//! `cargo test --release -p lfpiv-sim --test gige throughput -- --ignored --nocapture`

use std::{
    fs, thread,
    time::{Duration, Instant},
};

use lfpiv_hw::{
    device::{Camera, FrameStatus},
    gige::{CameraSettings, ImageSize, PixelFormat},
};

use super::{bench::*, network::in_private_network};

const BENCH: ImageSize = ImageSize { columns: 2352, rows: 1768 };
const FRAMES: u64 = 100;
const SILENCE: Duration = Duration::from_secs(2);

#[test]
#[ignore = "a measurement"]
fn two_full_cameras() {
    in_private_network("throughput::two_full_cameras", || {
        for format in [PixelFormat::Mono8, PixelFormat::Mono12Packed, PixelFormat::Mono16] {
            for line_rate in [125e6, f64::INFINITY] {
                measure(format, line_rate);
            }
        }
    });
}

fn measure(format: PixelFormat, line_bytes_per_s: f64) {
    let addresses = [FIRST, SECOND];
    let fakes = addresses.map(|address| fake(address, "LF", BENCH));
    for fake in &fakes {
        fake.set_line_rate(line_bytes_per_s);
        fake.unplug();
        fake.plug_in().unwrap();
    }
    let mut cameras = addresses.map(|ip| {
        let defaults = CameraSettings::default();
        let settings = CameraSettings {
            packet_timeout_us: defaults.packet_timeout_us,
            frame_retention_us: defaults.frame_retention_us,
            ..settings(ip, format)
        };
        connect(&settings, BENCH)
    });
    let image = picture(BENCH, 1);
    let expected = as_sent(&image, format);
    for camera in &mut cameras {
        camera.start().unwrap();
    }
    let (began, busy_before_s) = (Instant::now(), processor_seconds());
    let seconds = thread::scope(|scope| {
        for fake in &fakes {
            let image = &image;
            scope.spawn(move || (0..FRAMES).for_each(|n| _ = fake.expose(image.clone(), n)));
        }
        let read = cameras.each_mut().map(|camera| {
            let expected = &expected;
            scope.spawn(move || read(camera.as_mut(), expected))
        });
        let ends = read.map(|thread| thread.join().unwrap());
        ends.into_iter().max().unwrap().duration_since(began).as_secs_f64()
    });
    let busy = (processor_seconds() - busy_before_s) / seconds;
    let statistics = cameras.each_ref().map(|camera| camera.statistics());
    let completed: u64 = statistics.iter().map(|s| s.completed).sum();
    let rate = completed as f64 / 2.0 / seconds;
    let megabytes = rate * format.payload_bytes(BENCH.pixels()) as f64 / 1e6;
    println!(
        "{:<13} line {:>5.0} MB/s: {rate:6.1} frames/s and {megabytes:6.1} MB/s a camera, {} of {} \
         frames not whole, {busy:.2} processors busy (two cameras, two drivers, comparison)",
        format.name(),
        line_bytes_per_s / 1e6,
        2 * FRAMES - completed,
        2 * FRAMES,
    );
}

/// Reads until all frames have come, or none for a while; returns when the last one came.
fn read(camera: &mut dyn Camera, expected: &[u16]) -> Instant {
    let mut last = Instant::now();
    for _ in 0..FRAMES {
        let Some(frame) = camera.next_frame(SILENCE).unwrap() else { break };
        if frame.status == FrameStatus::Complete {
            assert!(frame.image.counts() == expected);
        }
        last = Instant::now();
    }
    last
}

/// Processor time of this process, in s.
fn processor_seconds() -> f64 {
    let stat = fs::read_to_string("/proc/self/stat").unwrap();
    let fields: Vec<&str> = stat.rsplit(')').next().unwrap().split_whitespace().collect();
    let ticks: f64 = fields[11].parse::<f64>().unwrap() + fields[12].parse::<f64>().unwrap();
    ticks / 100.0
}
