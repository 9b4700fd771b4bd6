use std::{
    thread,
    time::{Duration, Instant},
};

use lfpiv_hw::{
    PulseSchedule, TimingSettings,
    device::{DeviceError, Frame, StreamStatistics, SynchroniserState},
};

use super::*;
use crate::{flow::Uniform, shared_bench::SHOTS_KEPT, test_bench};

const PATIENCE: Duration = Duration::from_secs(20);
const MOMENT: Duration = Duration::from_millis(30);

/// A bench that renders in about a millisecond.
fn quick(pacing: Pacing) -> SimulatedBench {
    connect(scene(), test_bench::small(), 5, pacing)
}

fn scene() -> Scene {
    let flow = crate::Flow::Uniform(Uniform { velocity_m_s: [1.0, 0.0, 0.0] });
    Scene { ppm: 0.1, rays_per_particle: 64, flow, ..Scene::default() }
}

/// 50 Hz.
fn schedule() -> PulseSchedule {
    let quick_camera = TimingSettings {
        laser_rate_limit_hz: 1000.0,
        readout_us: 2000.0,
        ..TimingSettings::default()
    };
    PulseSchedule::plan(&quick_camera, 200.0, 50.0).unwrap()
}

fn ready(pacing: Pacing) -> SimulatedBench {
    let mut bench = quick(pacing);
    for camera in &mut bench.cameras {
        camera.start().unwrap();
    }
    bench.synchroniser.program(&schedule()).unwrap();
    bench
}

/// The next `count` frames of `camera`.
fn drain(camera: &mut dyn Camera, count: usize) -> Vec<Frame> {
    (0..count).map(|_| camera.next_frame(PATIENCE).unwrap().expect("a frame in time")).collect()
}

fn is_refused<T>(result: Result<T, DeviceError>) -> bool {
    matches!(result, Err(DeviceError::Refused { .. }))
}

#[test]
fn two_camera_threads_receive_a_burst_at_the_programmed_rate() {
    let mut bench = ready(Pacing::RealTime);
    let shots = 5;
    let fired = Instant::now();
    bench.synchroniser.fire(shots).unwrap();
    let threads: Vec<_> = bench
        .cameras
        .drain(..)
        .map(|mut camera| {
            thread::spawn(move || {
                let frames = drain(camera.as_mut(), 2 * shots as usize);
                assert!(camera.next_frame(MOMENT).unwrap().is_none());
                assert_eq!(camera.statistics().completed, 2 * shots);
                camera.stop().unwrap();
                frames
            })
        })
        .collect();
    let frames: Vec<Vec<Frame>> = threads.into_iter().map(|t| t.join().unwrap()).collect();
    // The last frame is read out slightly more than 4 ms after the fifth T0.
    assert!(fired.elapsed() >= Duration::from_millis(4 * 20 + 4));
    for camera in &frames {
        for (id, frame) in camera.iter().enumerate() {
            assert_eq!(frame.frame_id, id as u64);
            let since_first = frame.device_timestamp_ns - camera[0].device_timestamp_ns;
            let between_exposures = if id % 2 == 1 { 202_000 } else { 0 };
            assert_eq!(since_first, 20_000_000 * (id as u64 / 2) + between_exposures);
        }
    }
    let origin_apart = frames[1][0].device_timestamp_ns.abs_diff(frames[0][0].device_timestamp_ns);
    assert!(origin_apart > 1_000_000_000);
    assert_eq!(bench.synchroniser.state().unwrap(), SynchroniserState::Armed);
    assert_eq!(bench.synchroniser.trigger_count().unwrap(), Some(shots));
}

#[test]
fn frames_show_the_shots_of_the_scene_at_the_programmed_separation() {
    let mut bench = ready(Pacing::AsFramesAreTaken);
    bench.synchroniser.fire(3).unwrap();
    let geometry = BenchGeometry { dt_s: 200e-6, ..test_bench::small() };
    for shot in 0..3 {
        let expected = scene().shot(&geometry, 5, shot);
        for (camera, images) in bench.cameras.iter_mut().zip(&expected.images) {
            for (frame, image) in drain(camera.as_mut(), 2).iter().zip(images) {
                assert_eq!(frame.image, *image);
                assert_eq!(frame.frame_id / 2, shot);
            }
        }
    }
    assert_eq!(bench.synchroniser.state().unwrap(), SynchroniserState::Armed);
}

#[test]
fn frames_taken_set_the_pace() {
    let mut bench = ready(Pacing::AsFramesAreTaken);
    bench.synchroniser.fire(1000).unwrap();
    // A single camera advances as far as its allowed lead over the other.
    let ahead = drain(bench.cameras[0].as_mut(), 2 * LEAD_SHOTS);
    assert!(bench.cameras[0].next_frame(MOMENT).unwrap().is_none());
    assert_eq!(bench.synchroniser.trigger_count().unwrap(), Some(LEAD_SHOTS as u64));
    let apart = ahead[2].device_timestamp_ns - ahead[0].device_timestamp_ns;
    assert_eq!(apart, 20_000_000);
    // Once the other has stopped, it does not limit the lead.
    bench.cameras[1].stop().unwrap();
    drain(bench.cameras[0].as_mut(), 2);
    bench.synchroniser.make_safe().unwrap();
    assert_eq!(bench.synchroniser.state().unwrap(), SynchroniserState::Safe);
}

/// Shots that one camera may be ahead.
const LEAD_SHOTS: usize = crate::LEAD as usize;

#[test]
fn a_waiting_camera_is_woken_by_the_burst() {
    for pacing in [Pacing::RealTime, Pacing::AsFramesAreTaken] {
        let mut bench = ready(pacing);
        let mut camera = bench.cameras.remove(0);
        let asked = Instant::now();
        let waiting = thread::spawn(move || camera.next_frame(PATIENCE).unwrap().is_some());
        thread::sleep(MOMENT);
        bench.synchroniser.fire(1).unwrap();
        assert!(waiting.join().unwrap());
        assert!(asked.elapsed() < PATIENCE / 2);
    }
}

#[test]
fn making_safe_ends_a_burst_for_waiting_cameras_and_is_idempotent() {
    let mut bench = ready(Pacing::RealTime);
    bench.synchroniser.fire(9_000_000).unwrap();
    assert_eq!(bench.synchroniser.state().unwrap(), SynchroniserState::Firing);
    drain(bench.cameras[0].as_mut(), 2);
    bench.synchroniser.make_safe().unwrap();
    bench.synchroniser.make_safe().unwrap();
    assert_eq!(bench.synchroniser.state().unwrap(), SynchroniserState::Safe);
    let given = bench.synchroniser.trigger_count().unwrap().unwrap();
    thread::sleep(2 * MOMENT);
    assert_eq!(bench.synchroniser.trigger_count().unwrap(), Some(given));
    // Triggered frames still arrive, and no more.
    drain(bench.cameras[0].as_mut(), 2 * given as usize - 2);
    assert!(bench.cameras[0].next_frame(MOMENT).unwrap().is_none());
    assert!(is_refused(bench.synchroniser.fire(1)));
    bench.synchroniser.program(&schedule()).unwrap();
    assert_eq!(bench.synchroniser.trigger_count().unwrap(), Some(0));
    bench.synchroniser.fire(1).unwrap();
    assert_eq!(drain(bench.cameras[0].as_mut(), 2)[0].frame_id, 2 * given);
}

#[test]
fn an_idle_camera_times_out() {
    let mut bench = ready(Pacing::RealTime);
    let asked = Instant::now();
    assert!(bench.cameras[0].next_frame(MOMENT).unwrap().is_none());
    assert!(asked.elapsed() >= MOMENT);
    assert!(bench.cameras[0].next_frame(Duration::ZERO).unwrap().is_none());
}

#[test]
fn a_restarted_camera_counts_from_zero_and_misses_what_came_before() {
    let mut bench = ready(Pacing::AsFramesAreTaken);
    bench.cameras[1].stop().unwrap();
    bench.synchroniser.fire(4).unwrap();
    drain(bench.cameras[0].as_mut(), 6);
    bench.cameras[1].start().unwrap();
    assert_eq!(bench.cameras[1].statistics(), StreamStatistics::default());
    assert!(bench.cameras[1].next_frame(Duration::ZERO).unwrap().is_none());
    drain(bench.cameras[0].as_mut(), 2);
    bench.synchroniser.fire(1).unwrap();
    assert_eq!(drain(bench.cameras[1].as_mut(), 1)[0].frame_id, 0);
}

#[test]
fn calls_out_of_turn_are_refused() {
    let mut bench = quick(Pacing::RealTime);
    assert_eq!(bench.synchroniser.state().unwrap(), SynchroniserState::Safe);
    assert!(bench.synchroniser.identify().unwrap().contains("simulated"));
    assert!(is_refused(bench.synchroniser.fire(1)));
    assert!(is_refused(bench.cameras[0].next_frame(MOMENT)));
    bench.cameras[0].stop().unwrap();
    bench.cameras[0].start().unwrap();
    assert!(is_refused(bench.cameras[0].start()));
    bench.synchroniser.program(&schedule()).unwrap();
    assert_eq!(bench.synchroniser.state().unwrap(), SynchroniserState::Armed);
    assert!(is_refused(bench.synchroniser.fire(0)));
    bench.synchroniser.fire(9_000_000).unwrap();
    assert!(is_refused(bench.synchroniser.fire(1)));
    assert!(is_refused(bench.synchroniser.program(&schedule())));
    let endless = PulseSchedule { period_us: f64::INFINITY, ..schedule() };
    assert!(is_refused(bench.synchroniser.program(&endless)));
}

#[test]
fn a_shot_is_rendered_once_for_all_and_few_are_kept() {
    let bench = SharedBench::new(scene(), test_bench::small(), 5, Pacing::RealTime);
    let mut state = bench.lock();
    let first = state.rendered(0);
    assert!(Arc::ptr_eq(&first, &state.rendered(0)));
    for number in 1..20 {
        state.rendered(number);
    }
    assert_eq!(state.rendered.len(), SHOTS_KEPT);
    assert!(!Arc::ptr_eq(&first, &state.rendered(0)));
}
