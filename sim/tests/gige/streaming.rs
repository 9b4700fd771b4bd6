//! What is exposed arrives, pixel for pixel, and settings are what they should be.

use std::{
    sync::mpsc::sync_channel,
    thread,
    time::{Duration, SystemTime},
};

use lfpiv_hw::{
    device::{DeviceError, FrameStatus},
    gige::{Access, CameraSettings, ImageSize, PixelFormat, list_devices, open},
};
use lfpiv_sim::wire::camera::{Exposed, Ignored};

use super::{bench::*, network::in_private_network};

#[test]
fn every_pixel_format_arrives_as_it_was_sent() {
    in_private_network("streaming::every_pixel_format_arrives_as_it_was_sent", || {
        let fake = fake(FIRST, "LF1", SIZE);
        for format in PixelFormat::ALL {
            let mut camera = connect(&settings(FIRST, format), SIZE);
            camera.start().unwrap();
            for number in 0..3 {
                let image = picture(SIZE, number);
                let timestamp_ns = 1_000_000_007 * (number + 1);
                assert_eq!(fake.expose(image.clone(), timestamp_ns).unwrap(), Exposed::Yes);
                let frame = frame(camera.as_mut());
                assert_eq!(frame.status, FrameStatus::Complete, "{format:?}");
                assert_eq!(frame.image.counts(), as_sent(&image, format), "{format:?}");
                assert_eq!(frame.frame_id, number);
                assert_eq!(frame.device_timestamp_ns, timestamp_ns);
                let now_ns = since_epoch().as_nanos() as u64;
                assert!(now_ns - frame.host_timestamp_ns < LONG.as_nanos() as u64);
            }
            camera.stop().unwrap();
            assert_eq!(camera.statistics().completed, 3);
        }
        assert_eq!((fake.counts().sent, fake.counts().untriggered), (15, 0));
    });
}

fn since_epoch() -> Duration {
    SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap()
}

/// The frame counters wrap on the way: they begin at 65,400.
#[test]
fn two_cameras_deliver_two_hundred_shots_each_byte_for_byte() {
    const SHOTS: u64 = 200;
    in_private_network(
        "streaming::two_cameras_deliver_two_hundred_shots_each_byte_for_byte",
        || {
            let formats = [PixelFormat::Mono12Packed, PixelFormat::Mono16];
            let fakes = [(FIRST, "LF1"), (SECOND, "LF2")].map(|(ip, name)| fake(ip, name, SIZE));
            let mut cameras = [0, 1].map(|index| {
                let settings = CameraSettings {
                    frames_per_trigger: 2,
                    ..settings([FIRST, SECOND][index], formats[index])
                };
                connect(&settings, SIZE)
            });
            for camera in &mut cameras {
                camera.start().unwrap();
            }
            // A frame is exposed when the driver has room for it, however slow this machine is.
            const AHEAD: usize = 4;
            let room = [0, 1].map(|_| sync_channel::<()>(AHEAD));
            let (expose, taken): (Vec<_>, Vec<_>) = room.into_iter().unzip();
            thread::scope(|scope| {
                for (index, (fake, expose)) in fakes.iter().zip(expose).enumerate() {
                    scope.spawn(move || {
                        for frame in 0..2 * SHOTS {
                            expose.send(()).unwrap();
                            let image = picture(SIZE, 2 * frame + index as u64);
                            assert_eq!(fake.expose(image, frame).unwrap(), Exposed::Yes);
                        }
                    });
                }
                for (index, (camera, taken)) in cameras.iter_mut().zip(taken).enumerate() {
                    scope.spawn(move || {
                        for number in 0..2 * SHOTS {
                            let frame = frame(camera.as_mut());
                            taken.recv().unwrap();
                            let image = picture(SIZE, 2 * number + index as u64);
                            assert_eq!(frame.status, FrameStatus::Complete, "frame {number}");
                            assert_eq!(frame.frame_id, number);
                            assert_eq!(frame.device_timestamp_ns, number);
                            assert_eq!(frame.image.counts(), as_sent(&image, formats[index]));
                        }
                    });
                }
            });
            for (fake, camera) in fakes.iter().zip(&mut cameras) {
                assert!(fake.last_frame_id() < 65_400, "the counter has not wrapped");
                let statistics = camera.statistics();
                assert_eq!((statistics.completed, statistics.failed), (2 * SHOTS, 0));
                assert_eq!((statistics.underruns, statistics.missing), (0, 0));
            }
        },
    );
}

#[test]
fn a_part_of_the_sensor_and_the_other_settings_arrive_in_the_camera() {
    in_private_network(
        "streaming::a_part_of_the_sensor_and_the_other_settings_arrive_in_the_camera",
        || {
            let fake = fake(FIRST, "LF1", SIZE);
            let part = ImageSize { columns: 100, rows: 80 };
            let settings = CameraSettings {
                ip: None,
                serial: Some("LF1".into()),
                offset_px: Some([40, 30]),
                exposure_us: Some(200.0),
                gain_db: Some(6.0),
                inter_packet_delay_ns: 1000,
                ptp: true,
                ..settings(FIRST, PixelFormat::Mono12)
            };
            let mut camera = connect(&settings, part);
            camera.start().unwrap();
            let image = picture(SIZE, 5);
            fake.expose(image.clone(), 1).unwrap();
            let frame = frame(camera.as_mut());
            assert_eq!((frame.image.columns(), frame.image.rows()), (100, 80));
            for row in 0..part.rows {
                assert_eq!(frame.image.row(row), &image.row(row + 30)[40..140], "row {row}");
            }
        },
    );
}

#[test]
fn what_the_camera_does_not_take_is_refused_with_both_values() {
    in_private_network(
        "streaming::what_the_camera_does_not_take_is_refused_with_both_values",
        || {
            let _fake = fake(FIRST, "LF1", SIZE);
            let good = settings(FIRST, PixelFormat::Mono8);
            let refusal = |settings: &CameraSettings, size: ImageSize| {
                let error = error_of(open("cam1", settings, size));
                assert!(matches!(error, DeviceError::Refused { .. }), "{error}");
                error.to_string()
            };
            let large = ImageSize { columns: 2352, rows: 1768 };
            let words = refusal(&good, large);
            for part in ["cam1", "384 x 312", "2352 x 1768", "optics.sensor"] {
                assert!(words.contains(part), "{words}");
            }
            let beyond = CameraSettings { offset_px: Some([300, 0]), ..good.clone() };
            assert!(refusal(&beyond, ImageSize { columns: 100, rows: 100 }).contains("(300, 0)"));
            let loud = CameraSettings { gain_db: Some(48.0), ..good.clone() };
            assert!(refusal(&loud, SIZE).contains("gain"));
            let line = CameraSettings { trigger_line: "Line7".into(), ..good.clone() };
            assert!(refusal(&line, SIZE).contains("Line7"));
            let own = CameraSettings { features: "DoubleShutter=On".into(), ..good.clone() };
            assert!(refusal(&own, SIZE).contains("DoubleShutter"));
            // Nothing of that stays behind.
            connect(&good, SIZE).start().unwrap();

            let absent = CameraSettings { ip: Some(SECOND), ..good.clone() };
            let error = error_of(open("cam2", &absent, SIZE));
            assert!(matches!(error, DeviceError::NotFound { .. }), "{error}");
            let absent = CameraSettings { ip: None, serial: Some("LF9".into()), ..good };
            let error = error_of(open("cam2", &absent, SIZE)).to_string();
            assert!(error.contains("LF9"), "{error}");
        },
    );
}

#[test]
fn triggers_count_only_while_the_camera_waits_for_its_line() {
    in_private_network(
        "streaming::triggers_count_only_while_the_camera_waits_for_its_line",
        || {
            let fake = fake(FIRST, "LF1", SIZE);
            let ignored = |reason| {
                let exposed = fake.expose(picture(SIZE, 0), 0).unwrap();
                assert_eq!(exposed, Exposed::No(reason));
            };
            ignored(Ignored::NotAcquiring);
            let other_line = CameraSettings {
                trigger_line: "Line2".into(),
                ..settings(FIRST, PixelFormat::Mono8)
            };
            let mut camera = connect(&other_line, SIZE);
            ignored(Ignored::NotAcquiring);
            camera.start().unwrap();
            ignored(Ignored::OtherSource);
            drop(camera);
            let mut camera = connect(&settings(FIRST, PixelFormat::Mono8), SIZE);
            for first in [0, 2] {
                camera.start().unwrap();
                for number in first..first + 2 {
                    fake.expose(picture(SIZE, number), number).unwrap();
                    let frame = frame(camera.as_mut());
                    // Frames are counted from the start of each stream.
                    assert_eq!(frame.frame_id, number - first);
                    let sent = as_sent(&picture(SIZE, number), PixelFormat::Mono8);
                    assert_eq!(frame.image.counts(), sent);
                }
                camera.stop().unwrap();
                camera.stop().unwrap();
                ignored(Ignored::NotAcquiring);
            }
            let counts = fake.counts();
            assert_eq!((counts.exposures, counts.sent, counts.ignored), (9, 4, 5));
        },
    );
}

#[test]
fn cameras_are_listed_with_who_uses_them() {
    in_private_network("streaming::cameras_are_listed_with_who_uses_them", || {
        let _fakes = [(FIRST, "LF1"), (SECOND, "LF2")].map(|(ip, name)| fake(ip, name, SIZE));
        let _camera = connect(&settings(SECOND, PixelFormat::Mono8), SIZE);
        let found = wait_for(|| {
            let mut found = list_devices().unwrap();
            found.sort_by(|a, b| a.serial.cmp(&b.serial));
            (found.len() == 2).then_some(found)
        });
        let line = |at: usize| (found[at].serial.as_str(), found[at].address.as_str());
        assert_eq!([line(0), line(1)], [("LF1", "127.0.0.1"), ("LF2", "127.0.0.2")]);
        assert_eq!([&found[0].access, &found[1].access], [&Access::Free, &Access::InUse]);
        // Who is in use cannot be asked.
        assert_eq!([found[0].sensor, found[1].sensor], [Some(SIZE), None]);
        assert_eq!((&*found[0].vendor, &*found[0].model), ("lfpiv", "simulated light field"));
    });
}

/// Scheduling policy and nice level of a thread, from its `stat` (proc_pid_stat(5), fields 41 and 19).
fn scheduling(thread_stat: &str) -> (u64, i64) {
    let after_name = thread_stat.rsplit_once(')').unwrap().1;
    let fields: Vec<&str> = after_name.split_whitespace().collect();
    (fields[38].parse().unwrap(), fields[16].parse().unwrap())
}

/// Whether this process may raise priorities: `nice` says so when it may not.
fn may_raise_priorities() -> bool {
    let raised = std::process::Command::new("nice").args(["-n", "-1", "true"]).output().unwrap();
    raised.stderr.is_empty()
}

#[test]
fn the_thread_that_receives_frames_runs_before_others() {
    const ROUND_ROBIN: u64 = 2;
    in_private_network("streaming::the_thread_that_receives_frames_runs_before_others", || {
        if !may_raise_priorities() {
            println!("not permitted here: nothing to see");
            return;
        }
        let fake = fake(FIRST, "LF1", SIZE);
        let mut camera = connect(&settings(FIRST, PixelFormat::Mono12Packed), SIZE);
        camera.start().unwrap();
        fake.expose(picture(SIZE, 1), 1).unwrap();
        frame(camera.as_mut());
        let threads = std::fs::read_dir("/proc/self/task").unwrap().map(|thread| {
            let folder = thread.unwrap().path();
            ["comm", "stat"].map(|file| std::fs::read_to_string(folder.join(file)).unwrap())
        });
        let receiving: Vec<_> = threads.filter(|[name, _]| name.contains("gv_stream")).collect();
        assert!(
            !receiving.is_empty(),
            "no thread of Aravis has the name that it gives its streams"
        );
        for [name, stat] in &receiving {
            let (policy, nice) = scheduling(stat);
            assert!(policy == ROUND_ROBIN || nice < 0, "{name}: policy {policy}, nice {nice}");
        }
        camera.stop().unwrap();
    });
}
