//! `lfpiv calibrate focus --live`: the plane in focus, from a camera on the network.

// All of this is test; clippy's exception covers only the functions marked as such.
#![allow(clippy::unwrap_used)]

use std::{
    fs,
    io::{BufRead, BufReader, Lines},
    net::Ipv4Addr,
    path::{Path, PathBuf},
    process::{Child, ChildStdout, Command, Stdio},
    sync::Arc,
    time::Instant,
};

use lfpiv_hw::{
    RawImage,
    card::CalibrationCard,
    gige::{self, ImageSize},
};
use lfpiv_sim::wire::camera::FakeGigeCamera;

use crate::{
    bench::{LONG, camera, small},
    network::in_private_network,
};

/// A card across the axis of camera 1, before the plane in focus and behind it.
const CARD: &str = "
card = { pattern = 'dots', spacing_mm = 0.6, dot_diameter_mm = 0.3, fiducial_diameter_mm = 0.4, \
         marks = [9, 9], right = [1, 0, 0], up = [0, 1, 0] }
position = [{ origin_mm = [0, 0, 3] }, { origin_mm = [0, 0, -3] }]
";

fn cards() -> [Arc<RawImage>; 2] {
    let (config, card) = (small(), toml::from_str::<CalibrationCard>(CARD).unwrap());
    let (scene, bench) = (config.simulation.clone().unwrap(), config.bench_geometry());
    [0, 1].map(|position| Arc::new(scene.card_image(&bench, 0, &card, position, 1).unwrap()))
}

fn configuration(folder: &Path) -> PathBuf {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/small.toml");
    let text = fs::read_to_string(path).unwrap();
    let text = &text[..text.find("[simulation]").unwrap()];
    let instruments = "[instruments.synchroniser]\ndriver = 'bnc-575'\nport = '/dev/nowhere'\n\
                       [[instruments.camera]]\nip = '127.0.0.1'\npacket_size_bytes = 16000\n\
                       frame_retention_us = 2000000\n[[instruments.camera]]\nip = '127.0.0.2'\n";
    let path = folder.join("bench.toml");
    fs::write(&path, format!("{text}{instruments}")).unwrap();
    path
}

fn command(config: &Path, number: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lfpiv"));
    command.args(["calibrate", "focus", "--live", "--exposure-us", "3000", "--camera", number]);
    command.arg("--config").arg(config);
    command
}

/// What the command prints; it is ended when a test fails.
struct Live {
    child: Child,
    lines: Lines<BufReader<ChildStdout>>,
}

impl Live {
    fn start(config: &Path) -> Self {
        let mut child = command(config, "1").stdout(Stdio::piped()).spawn().unwrap();
        let lines = BufReader::new(child.stdout.take().unwrap()).lines();
        Self { child, lines }
    }

    /// The first line that has these words.
    fn says(&mut self, words: &str) -> String {
        let asked = Instant::now();
        for line in self.lines.by_ref() {
            let line = line.unwrap();
            println!("{line}");
            if line.contains(words) {
                return line;
            }
            assert!(asked.elapsed() < LONG, "{words}");
        }
        panic!("it ended before it said {words}")
    }
}

impl Drop for Live {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

#[test]
fn a_live_camera_says_where_the_card_is() {
    in_private_network("focus::a_live_camera_says_where_the_card_is", || {
        let folder = tempfile::tempdir().unwrap();
        let config = configuration(folder.path());
        let size = ImageSize::from(&small().optics.sensor);
        let fake = FakeGigeCamera::start(Ipv4Addr::LOCALHOST, "LF1", size, 12).unwrap();
        let mut live = Live::start(&config);
        // Nothing is in view yet; then an even grey.
        live.says("no depth is sharper than the others: place a card");
        fake.show(Arc::new(grey(size, 2000))).unwrap();
        live.says("no depth is sharper than the others: place a card");
        fake.show(Arc::new(grey(size, 4095))).unwrap();
        live.says("100.0 % of the pixels are saturated");

        let [near, far] = cards();
        fake.show(near).unwrap();
        let line = live.says("nearer to the camera than the plane in focus");
        let found_mm: f64 = line.split_whitespace().nth(3).unwrap().parse().unwrap();
        assert!((found_mm - 3.0).abs() < 0.5, "{line}");
        assert!(line.contains("move the camera back by"), "{line}");
        // Every frame has its line.
        live.says("nearer to the camera than the plane in focus");
        fake.show(far).unwrap();
        live.says("behind the plane in focus");

        // Who comes second is told so, and what runs runs on.
        let second = command(&config, "1").output().unwrap();
        let words = String::from_utf8_lossy(&second.stderr).into_owned();
        assert!(!second.status.success() && words.contains("another program controls"), "{words}");
        live.says("behind the plane in focus");

        let terminated = Instant::now();
        Command::new("kill").arg(live.child.id().to_string()).status().unwrap();
        assert!(live.child.wait().unwrap().success());
        println!("ended after {:?}", terminated.elapsed());
        assert_eq!(fake.counts().exposures, 0);
        // It was given back: a run can have it at once.
        let settings = gige::CameraSettings { control_patience_s: 0.0, ..camera(0) };
        drop(gige::open("cam1", &settings, size).unwrap());
    });
}

fn grey(size: ImageSize, count: u16) -> RawImage {
    RawImage::new(size.columns, size.rows, vec![count; size.pixels()]).unwrap()
}

#[test]
fn what_cannot_be_looked_at_is_said() {
    in_private_network("focus::what_cannot_be_looked_at_is_said", || {
        let folder = tempfile::tempdir().unwrap();
        let config = configuration(folder.path());
        let refused = |config: &Path, number: &str| {
            let done = command(config, number).output().unwrap();
            assert!(!done.status.success());
            String::from_utf8_lossy(&done.stderr).into_owned()
        };
        let words = refused(&config, "2");
        assert!(words.contains("cam2") && words.contains("127.0.0.2"), "{words}");
        assert!(refused(&config, "3").contains("give --camera 1 to 2"));
        let simulated = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/small.toml");
        let words = refused(&simulated, "1");
        assert!(words.contains("no [instruments]") && words.contains("--watch"), "{words}");
    });
}
