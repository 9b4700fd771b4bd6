//! How fast the loopback is. Not a test: figures, for those who ask.
//!
//! `cargo test --release -p lfpiv-sim --test gige throughput -- --ignored --nocapture`

use std::{fs, thread, time::Instant};

use lfpiv_hw::{
    device::FrameStatus,
    gige::{CameraSettings, ImageSize, PixelFormat},
};

use super::{bench::*, network::in_private_network};

const BENCH: ImageSize = ImageSize { columns: 2352, rows: 1768 };
const FRAMES: u64 = 200;

#[test]
#[ignore = "a measurement"]
fn two_full_cameras() {
    in_private_network("throughput::two_full_cameras", || {
        for format in [PixelFormat::Mono8, PixelFormat::Mono12Packed, PixelFormat::Mono16] {
            measure(format);
        }
    });
}

fn measure(format: PixelFormat) {
    let addresses = [FIRST, SECOND];
    let fakes = addresses.map(|address| fake(address, "LF", BENCH));
    let mut cameras = addresses.map(|address| {
        let settings =
            CameraSettings { socket_buffer_bytes: 64 << 20, ..settings(address, format) };
        connect(&settings, BENCH)
    });
    let image = picture(BENCH, 1);
    let expected = as_sent(&image, format);
    for camera in &mut cameras {
        camera.start().unwrap();
    }
    let (began, busy_before_s) = (Instant::now(), processor_seconds());
    let damaged: u64 = thread::scope(|scope| {
        for fake in &fakes {
            let image = &image;
            scope.spawn(move || (0..FRAMES).for_each(|n| _ = fake.expose(image.clone(), n)));
        }
        let read = cameras.each_mut().map(|camera| {
            let expected = &expected;
            scope.spawn(move || {
                let frames = (0..FRAMES).map(|_| frame(camera.as_mut()));
                frames
                    .map(|frame| match frame.status {
                        FrameStatus::Complete => assert!(frame.image.counts() == expected),
                        FrameStatus::MissingPackets => {}
                    })
                    .count() as u64
                    - camera.statistics().completed
            })
        });
        read.into_iter().map(|thread| thread.join().unwrap()).sum()
    });
    let seconds = began.elapsed().as_secs_f64();
    let busy = (processor_seconds() - busy_before_s) / seconds;
    let rate = FRAMES as f64 / seconds;
    let megabytes = rate * format.payload_bytes(BENCH.pixels()) as f64 / 1e6;
    println!(
        "{:<13} {rate:6.1} frames/s and {megabytes:6.1} MB/s a camera, {damaged} of {} frames \
         damaged, {busy:.2} processors busy (both cameras, both drivers, comparison)",
        format.name(),
        2 * FRAMES
    );
}

/// Processor time of this process, in s.
fn processor_seconds() -> f64 {
    let stat = fs::read_to_string("/proc/self/stat").unwrap();
    let fields: Vec<&str> = stat.rsplit(')').next().unwrap().split_whitespace().collect();
    let ticks: f64 = fields[11].parse::<f64>().unwrap() + fields[12].parse::<f64>().unwrap();
    ticks / 100.0
}
