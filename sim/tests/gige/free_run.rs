//! A camera that is only looked at: it runs freely, and is given back as it was found.

use aravis::prelude::*;
use lfpiv_hw::{
    device::{DeviceError, FrameStatus},
    gige::{CameraSettings, ImageSize, PixelFormat, open_free_running},
};

use super::{bench::*, network::in_private_network};

/// What a run has left in the camera.
fn set_by_a_run() {
    let part = ImageSize { columns: 100, rows: 80 };
    let settings = CameraSettings {
        offset_px: Some([40, 30]),
        exposure_us: Some(200.0),
        gain_db: Some(6.0),
        frames_per_trigger: 2,
        packet_size_bytes: 1500,
        ..settings(FIRST, PixelFormat::Mono12)
    };
    drop(connect(&settings, part));
}

/// What the camera says of itself.
fn state() -> Vec<String> {
    let camera = aravis::Camera::new(Some("127.0.0.1")).unwrap();
    let (x, y, columns, rows) = camera.region().unwrap();
    let numbers = [camera.exposure_time().unwrap(), camera.gain().unwrap()];
    let texts = ["PixelFormat", "TriggerSelector", "TriggerMode", "TriggerSource"]
        .map(|name| camera.string(name).unwrap().to_string());
    let packets = camera.gv_get_packet_size().unwrap();
    [format!("{x} {y} {columns} {rows} {numbers:?} {packets}")].into_iter().chain(texts).collect()
}

#[test]
fn a_borrowed_camera_shows_what_is_in_view_and_is_given_back_as_it_was() {
    in_private_network(
        "free_run::a_borrowed_camera_shows_what_is_in_view_and_is_given_back_as_it_was",
        || {
            let fake = fake(FIRST, "LF1", SIZE);
            set_by_a_run();
            let found = state();
            assert!(found.contains(&"On".to_owned()), "{found:?}");
            let settings = CameraSettings {
                exposure_us: Some(5000.0),
                // Not for a camera without a trigger.
                trigger_line: "Line7".into(),
                features: "DoubleShutter=On".into(),
                ..settings(FIRST, PixelFormat::Mono12Packed)
            };
            let mut camera = open_free_running("cam1", &settings, SIZE).unwrap();
            let seen = picture(SIZE, 3);
            fake.show(seen.clone()).unwrap();
            camera.start().unwrap();
            for number in 0..3 {
                let frame = frame(camera.as_mut());
                assert_eq!((frame.status, frame.frame_id), (FrameStatus::Complete, number));
                assert_eq!(frame.image.counts(), seen.counts());
            }
            assert!(fake.counts().untriggered >= 3 && fake.counts().exposures == 0);
            // Without a word before: as when a program ends.
            drop(camera);
            assert_eq!(state(), found);
        },
    );
}

#[test]
fn a_camera_that_cannot_be_borrowed_keeps_its_settings() {
    in_private_network("free_run::a_camera_that_cannot_be_borrowed_keeps_its_settings", || {
        let fake = fake(FIRST, "LF1", SIZE);
        set_by_a_run();
        let found = state();
        let good =
            CameraSettings { control_patience_s: 0.0, ..settings(FIRST, PixelFormat::Mono8) };
        let loud = CameraSettings { gain_db: Some(48.0), ..good.clone() };
        let error = error_of(open_free_running("cam1", &loud, SIZE)).to_string();
        assert!(error.contains("gain"), "{error}");
        assert_eq!(state(), found);

        let other = connect(&good, SIZE);
        let error = error_of(open_free_running("cam1", &good, SIZE));
        assert!(matches!(error, DeviceError::Refused { .. }), "{error}");
        let words = error.to_string();
        assert!(words.contains("another program controls") && !words.contains("0 s"), "{words}");
        drop(other);
        let mut camera = open_free_running("cam1", &good, SIZE).unwrap();
        camera.start().unwrap();
        fake.unplug();
        drop(camera);
    });
}
