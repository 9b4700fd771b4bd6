//! How long one simulated shot takes: 1 ppm in 10 × 10 × 10 mm (10,000 particles), two cameras,
//! 4096 rays per particle and frame, on the real sensor or (argument `paper`) the paper's.
//!
//! `cargo run --release -p lfpiv-sim --example time_a_shot [paper]`

use std::time::Instant;

use lfpiv_hw::{MicrolensArray, Optics, Pose, Sensor};
use lfpiv_sim::{
    BenchGeometry, Flow, Scene, Volume,
    flow::RingVortex,
    particles::FrameOfPair::{A, B},
};
use nalgebra::Vector3;

fn main() {
    let paper = std::env::args().nth(1).as_deref() == Some("paper");
    let (lenses, pixels) =
        if paper { ([251, 251], [4582, 4582]) } else { ([129, 97], [2352, 1768]) };
    let origin_mm = Vector3::zeros();
    let bench = BenchGeometry {
        optics: Optics {
            focal_length_mm: 100.0,
            f_number: 4.0,
            object_distance_mm: 200.0,
            microlens: MicrolensArray {
                pitch_mm: 0.1,
                focal_length_mm: 0.8,
                columns: lenses[0],
                rows: lenses[1],
            },
            sensor: Sensor { columns: pixels[0], rows: pixels[1], pixel_pitch_um: 5.5 },
        },
        poses: vec![
            Pose { right: Vector3::x(), up: Vector3::y(), axis: Vector3::z(), origin_mm },
            Pose { right: Vector3::x(), up: -Vector3::z(), axis: Vector3::y(), origin_mm },
        ],
        volume: Volume { voxels: [100; 3], voxel_mm: 0.1, centre_mm: [0.0; 3] },
        dt_s: 100e-6,
        empty: None,
    };
    let scene = Scene { flow: Flow::RingVortex(RingVortex::default()), ..Scene::default() };

    let start = Instant::now();
    let truth = scene.truth(&bench, 1, 0);
    println!(
        "{:6.2} s  {} particles and their paths",
        start.elapsed().as_secs_f64(),
        truth.particles.len()
    );
    for (camera, frame) in [(0, A), (0, B), (1, A), (1, B)] {
        let start = Instant::now();
        let light = scene.light(&bench, &truth, camera, frame);
        let traced_s = start.elapsed().as_secs_f64();
        let raw = scene.sensor.expose(&light, &[0]);
        let exposed_s = start.elapsed().as_secs_f64() - traced_s;
        let brightest = raw.counts().iter().max().copied().unwrap_or(0);
        println!("{traced_s:6.2} s rays {exposed_s:6.2} s sensor; brightest {brightest} counts");
    }
    let start = Instant::now();
    let shot = scene.shot(&bench, 1, 0);
    println!(
        "{:6.2} s  the whole shot, {} images",
        start.elapsed().as_secs_f64(),
        2 * shot.images.len()
    );
}
