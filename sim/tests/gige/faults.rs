//! What may go wrong: packets, cables, other programs, a daemon that was killed.

use std::{
    io::{BufRead, BufReader},
    thread::sleep,
    time::Duration,
};

use lfpiv_hw::{
    device::{Camera, DeviceError, Frame, FrameStatus},
    gige::{CameraSettings, PixelFormat, open},
};
use lfpiv_sim::wire::camera::{Exposed, Ignored};

use super::{
    bench::*,
    network::{in_private_network, is_program, program},
};

#[test]
fn lost_packets_mark_frames_and_none_is_silently_wrong() {
    const FRAMES: u64 = 60;
    in_private_network("faults::lost_packets_mark_frames_and_none_is_silently_wrong", || {
        let fake = fake(FIRST, "LF1", SIZE);
        let format = PixelFormat::Mono12Packed;
        let settings = CameraSettings {
            packet_timeout_us: 20_000,
            frame_retention_us: 100_000,
            ..settings(FIRST, format)
        };
        let mut camera = connect(&settings, SIZE);
        camera.start().unwrap();
        let (mut whole, mut damaged, mut nameless) = (0, 0, 0);
        for number in 0..FRAMES {
            // 14 packets a frame: about half of the frames are hurt, and some lose the packet that
            // names them.
            fake.set_lost_packet_ratio(if number == 0 { 0.0 } else { 0.05 });
            let image = picture(SIZE, number);
            assert_eq!(fake.expose(image.clone(), number).unwrap(), Exposed::Yes);
            let Some(frame) = frame_or_end(camera.as_mut(), number + 1) else {
                nameless += 1;
                continue;
            };
            assert_eq!(frame.frame_id, number);
            match frame.status {
                FrameStatus::Complete => {
                    whole += 1;
                    assert_eq!(frame.image.counts(), as_sent(&image, format), "frame {number}");
                    assert_eq!(frame.device_timestamp_ns, number);
                }
                FrameStatus::MissingPackets => {
                    damaged += 1;
                    assert!(frame.image.counts().iter().all(|count| *count == 0));
                }
            }
        }
        println!("{whole} whole, {damaged} damaged, {nameless} without a name");
        assert!(whole > 0 && damaged > 0, "{whole} whole, {damaged} damaged");
        let statistics = camera.statistics();
        assert_eq!((statistics.completed, statistics.failed), (whole, damaged + nameless));
        assert!(statistics.missing >= damaged, "{statistics:?}");
    });
}

/// The next frame, or `None` once the stream has done with `frames` frames and delivered no other.
fn frame_or_end(camera: &mut dyn Camera, frames: u64) -> Option<Frame> {
    wait_for(|| {
        let ended = camera.statistics().completed + camera.statistics().failed >= frames;
        // A frame that has been counted is on its way.
        let frame = camera.next_frame(Duration::from_millis(200)).unwrap();
        (ended || frame.is_some()).then_some(frame)
    })
}

#[test]
fn a_camera_that_vanishes_and_returns_goes_on_as_it_was_set() {
    in_private_network("faults::a_camera_that_vanishes_and_returns_goes_on_as_it_was_set", || {
        let log = Log::begin();
        let fake = fake(FIRST, "LF1", SIZE);
        let format = PixelFormat::Mono12Packed;
        let settings = CameraSettings { frames_per_trigger: 2, ..settings(FIRST, format) };
        let mut camera = connect(&settings, SIZE);
        camera.start().unwrap();
        let shoot = |camera: &mut dyn Camera, number: u64| {
            let image = picture(SIZE, number);
            assert_eq!(fake.expose(image.clone(), number).unwrap(), Exposed::Yes);
            let frame = frame(camera);
            assert_eq!(frame.frame_id, number);
            assert_eq!(frame.image.counts(), as_sent(&image, format));
        };
        for number in 0..3 {
            shoot(camera.as_mut(), number);
        }
        fake.unplug();
        let gone = fake.expose(picture(SIZE, 0), 0).unwrap();
        assert_eq!(gone, Exposed::No(Ignored::Unplugged));
        wait_for(|| {
            assert!(camera.next_frame(Duration::from_millis(50)).unwrap().is_none());
            (!camera.is_connected()).then_some(())
        });
        assert!(log.says("connection lost"));
        fake.plug_in().unwrap();
        wait_for(|| {
            assert!(camera.next_frame(Duration::from_millis(50)).unwrap().is_none());
            camera.is_connected().then_some(())
        });
        assert!(log.says("settings applied again, frames continue with number 4"));
        // Frame 3 was the second of a trigger and is gone: the next trigger begins with 4. Its
        // pixels would be wrong, or damaged, with the settings that the camera woke up with.
        for number in 4..8 {
            shoot(camera.as_mut(), number);
        }
        let statistics = camera.statistics();
        assert_eq!((statistics.reconnects, statistics.completed), (1, 7));
    });
}

#[test]
fn a_camera_that_stays_away_is_given_up_and_can_be_started_again() {
    in_private_network(
        "faults::a_camera_that_stays_away_is_given_up_and_can_be_started_again",
        || {
            let fake = fake(FIRST, "LF1", SIZE);
            let format = PixelFormat::Mono8;
            let settings = CameraSettings { reconnect_patience_s: 1.0, ..settings(FIRST, format) };
            let mut camera = connect(&settings, SIZE);
            camera.start().unwrap();
            fake.unplug();
            let error = wait_for(|| camera.next_frame(Duration::from_millis(50)).err());
            assert!(matches!(error, DeviceError::Lost { .. }), "{error}");
            assert!(error.to_string().contains("check its power and cable"), "{error}");
            assert!(camera.next_frame(Duration::ZERO).is_err());
            camera.stop().unwrap();
            assert!(camera.start().is_err());
            fake.plug_in().unwrap();
            wait_for(|| camera.start().ok());
            fake.expose(picture(SIZE, 1), 1).unwrap();
            let sent = as_sent(&picture(SIZE, 1), format);
            assert_eq!(frame(camera.as_mut()).image.counts(), sent);
        },
    );
}

#[test]
fn a_second_controller_is_refused_and_does_not_disturb_the_first() {
    in_private_network(
        "faults::a_second_controller_is_refused_and_does_not_disturb_the_first",
        || {
            let fake = fake(FIRST, "LF1", SIZE);
            let settings =
                CameraSettings { control_patience_s: 1.0, ..settings(FIRST, PixelFormat::Mono8) };
            let mut camera = connect(&settings, SIZE);
            camera.start().unwrap();
            let error = error_of(open("second", &settings, SIZE));
            assert!(matches!(error, DeviceError::Refused { .. }), "{error}");
            for words in ["second", "another program controls the camera at 127.0.0.1"] {
                assert!(error.to_string().contains(words), "{error}");
            }
            for number in 0..3 {
                fake.expose(picture(SIZE, number), number).unwrap();
                assert_eq!(frame(camera.as_mut()).frame_id, number);
            }
        },
    );
}

#[test]
fn after_a_kill_the_next_daemon_waits_for_the_heartbeat_and_goes_on() {
    in_private_network(
        "faults::after_a_kill_the_next_daemon_waits_for_the_heartbeat_and_goes_on",
        || {
            let log = Log::begin();
            let fake = fake(FIRST, "LF1", SIZE);
            let mut first = program("faults::a_daemon_to_be_killed").spawn().unwrap();
            let mut lines = BufReader::new(first.stdout.take().unwrap()).lines();
            let streaming = lines.any(|line| line.unwrap().contains(STREAMING));
            assert!(streaming, "the first daemon did not begin");
            first.kill().unwrap();
            first.wait().unwrap();

            let settings = CameraSettings {
                control_patience_s: LONG.as_secs_f64(),
                ..settings(FIRST, PixelFormat::Mono16)
            };
            let mut camera = connect(&settings, SIZE);
            assert!(log.says("waiting up to 60 s for its heartbeat"));
            camera.start().unwrap();
            for number in 0..3 {
                let image = picture(SIZE, number);
                assert_eq!(fake.expose(image.clone(), number).unwrap(), Exposed::Yes);
                let frame = frame(camera.as_mut());
                assert_eq!(frame.frame_id, number);
                assert_eq!(frame.image.counts(), as_sent(&image, PixelFormat::Mono16));
            }
        },
    );
}

const STREAMING: &str = "the first daemon streams";

/// Not a test: the program that the one above kills.
#[test]
#[ignore = "a program for another test"]
fn a_daemon_to_be_killed() {
    if !is_program() {
        return;
    }
    let mut camera = connect(&settings(FIRST, PixelFormat::Mono8), SIZE);
    camera.start().unwrap();
    println!("{STREAMING}");
    sleep(LONG);
}
