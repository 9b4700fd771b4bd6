//! `lfpiv devices` and `lfpiv init --camera`: from a camera on the network to a configuration.

// All of this is test; clippy's exception covers only the functions marked as such.
#![allow(clippy::unwrap_used)]

use std::{
    fs,
    net::Ipv4Addr,
    path::Path,
    process::{Command, Output},
};

use lfpiv::config::{ConfigFile, Purpose};
use lfpiv_hw::gige::ImageSize;
use lfpiv_sim::wire::camera::FakeGigeCamera;

use crate::network::in_private_network;

const SIZE: ImageSize = ImageSize { columns: 1176, rows: 884 };

fn lfpiv(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_lfpiv")).args(arguments).output().unwrap()
}

fn words(output: &Output) -> String {
    [&output.stdout, &output.stderr]
        .map(|bytes| String::from_utf8_lossy(bytes).into_owned())
        .concat()
}

/// A configuration for one camera that is found by `camera`, and what was said.
fn init(camera: &str, out: &Path) -> Output {
    let port = "serial_port=/dev/serial/by-id/synchroniser";
    let set = ["--set", "cameras=1", "--set", port, "--set", "volume_mm=3 3 2"];
    let out = out.display().to_string();
    lfpiv(&[&["init", "--defaults", "--camera", camera, "--out", &out], &set[..]].concat())
}

#[test]
fn a_configuration_has_the_sensor_of_the_camera_that_answers() {
    in_private_network(
        "first_use::a_configuration_has_the_sensor_of_the_camera_that_answers",
        || {
            let folder = tempfile::tempdir().unwrap();
            let fake = FakeGigeCamera::start(Ipv4Addr::LOCALHOST, "LF1", SIZE, 12).unwrap();
            let listed = lfpiv(&["devices"]);
            assert!(listed.status.success(), "{}", words(&listed));
            assert!(words(&listed).contains("1176 x 884"), "{}", words(&listed));

            // By its address and by its serial number, it is the same camera.
            for (n, camera) in ["127.0.0.1", "LF1"].iter().enumerate() {
                let out = folder.path().join(format!("bench-{n}.toml"));
                let made = init(camera, &out);
                assert!(made.status.success(), "{}", words(&made));
                let config = ConfigFile::load_for(Purpose::Bench, &out).unwrap().config;
                let sensor = &config.optics.sensor;
                assert_eq!((sensor.columns, sensor.rows), (SIZE.columns, SIZE.rows));
                // As many microlenses as fit on it.
                let lens = &config.optics.microlens;
                assert_eq!((lens.columns, lens.rows), (64, 48));
                let camera = &config.instruments.unwrap().camera[0];
                assert_eq!(camera.ip, Some(Ipv4Addr::LOCALHOST));
                let checked = lfpiv(&["check", "--quick", "--config", &out.display().to_string()]);
                assert!(checked.status.success(), "{}", words(&checked));
            }
            assert_eq!(fake.counts().exposures, 0, "nothing is exposed");

            let out = folder.path().join("other.toml");
            let refused = init("127.0.0.9", &out);
            assert!(!refused.status.success());
            assert!(words(&refused).contains("no camera 127.0.0.9 answers"), "{}", words(&refused));
            assert!(fs::metadata(&out).is_err(), "nothing is written");
        },
    );
}
