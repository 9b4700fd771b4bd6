//! A recorded run replayed over the wires, into a daemon that does not know it.

use std::{
    collections::BTreeMap,
    fs,
    io::{BufRead, BufReader, Read},
    path::{Path, PathBuf},
    process::{Child, Command, Output, Stdio},
};

use lfpiv::acquisition::journal::{Entry, RecordedRun};
use lfpiv_hw::{PulseSchedule, synchroniser::line::Direction};
use serde_json::Value;

use crate::{
    network::in_private_network,
    tiny::{configuration, finished_run, images, lfpiv, text},
};

/// A fast laser and fast cameras without warm-up, and queue space for a burst.
const TIMING: &str = "[timing]\nlaser_rate_limit_hz = 40.0\nreadout_us = 5000.0\n\
                      lamp_warm_up_s = 0.0\n";

/// A run that was recorded in process, and configurations for replaying it over the wires.
struct Stage {
    root: tempfile::TempDir,
    recorded: PathBuf,
}

impl Stage {
    fn with_run_of(shots: &str) -> Self {
        let root = tempfile::tempdir().expect("a folder");
        let config = configuration(root.path(), TIMING);
        let bench = fs::read_to_string(&config).expect("the bench");
        // More than one vector per shot.
        fs::write(&config, replaced(&bench, "window_mm = 0.8 ", "window_mm = 0.4 "))
            .expect("a file");
        let recorded = finished_run(&config, shots);
        Self { root, recorded }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.root.path().join(name)
    }

    /// The recorded run's configuration without its scene, with `more` appended.
    fn written(&self, name: &str, more: &str) -> PathBuf {
        let text = fs::read_to_string(self.path("bench.toml")).expect("the bench");
        let text = &text[..text.find("[simulation]").expect("a scene")];
        // The queue holds a whole burst.
        let text = text.replacen("queue = 4", "queue = 32", 1);
        let path = self.path(name);
        fs::write(&path, format!("{text}\n{TIMING}\n{more}")).expect("a file");
        path
    }

    /// For the daemon, with the instruments of `config/loopback.toml`.
    fn daemon(&self) -> String {
        let instruments = table("loopback.toml", "[instruments]", "[image]");
        let folder = self.root.path().display();
        instruments.replace("results/loopback", &folder.to_string())
    }

    /// The same for instruments that lose frames: each is waited for.
    fn daemon_that_loses_frames(&self) -> String {
        replaced(&self.daemon(), "frame_patience_s = 20.0", "frame_patience_s = 5.0")
    }

    /// For the instruments, with the wires of `config/loopback-bench.toml`.
    fn wire(&self) -> PathBuf {
        let wire = table("loopback-bench.toml", "[wire]", "[simulation]");
        let folder = self.root.path().display();
        let wire = wire.replace("results/loopback", &folder.to_string());
        self.written("wire.toml", &format!("{wire}readout_us = 5000.0\n"))
    }

    /// Number and checksum of every frame that the daemon received from a camera.
    fn received(&self, camera: usize) -> Vec<[String; 2]> {
        let list = rows(&self.path("received").join(format!("cam{}.csv", camera + 1)));
        list.iter().map(|row| [row[1].clone(), row[5].clone()]).collect()
    }

    /// Replays `run` over the wires into a daemon that takes `shots` shots; returns the output of
    /// the daemon and of the instruments.
    fn play(&self, run: &Path, more: &[&str], daemon: &str, shots: &str) -> (Output, String) {
        let instruments = Instruments::start(&self.wire(), run, &self.path("sent.csv"), more);
        let config = self.written("daemon.toml", daemon);
        let output = lfpiv(&["run", "--config", utf8(&config), "--shots", shots]);
        (output, instruments.finish())
    }
}

/// Part of a shipped configuration.
fn table(name: &str, from: &str, to: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("config").join(name);
    let text = fs::read_to_string(path).expect("a shipped configuration");
    let from = text.find(from).expect(from);
    let to = from + text[from..].find(to).expect(to);
    text[from..to].to_owned()
}

fn replaced(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "{from}");
    text.replace(from, to)
}

/// A running `lfpiv sim-bench --replay`.
struct Instruments(Child);

impl Instruments {
    fn start(config: &Path, run: &Path, record: &Path, more: &[&str]) -> Self {
        let child = Command::new(env!("CARGO_BIN_EXE_lfpiv"))
            .args(["sim-bench", "--config"])
            .args([config, Path::new("--replay"), run, Path::new("--record"), record])
            .args(more)
            .stdout(Stdio::piped())
            .spawn()
            .expect("the binary starts");
        let mut instruments = Self(child);
        let stdout = instruments.0.stdout.as_mut().expect("a pipe");
        // One byte at a time: the rest is read at the end.
        let lines = BufReader::with_capacity(1, stdout).lines();
        let cameras = lines.map(|line| line.expect("text")).filter(|l| l.starts_with("camera:"));
        assert_eq!(cameras.take(2).count(), 2, "the instruments do not start");
        instruments
    }

    /// Stops them; returns their final output.
    fn finish(mut self) -> String {
        Command::new("kill").arg(self.0.id().to_string()).status().expect("kill");
        let mut told = String::new();
        self.0.stdout.take().expect("a pipe").read_to_string(&mut told).expect("text");
        assert!(self.0.wait().expect("its end").success(), "{told}");
        told
    }
}

impl Drop for Instruments {
    fn drop(&mut self) {
        // It has already exited, unless the test has failed.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

fn utf8(path: &Path) -> &str {
    path.to_str().expect("a UTF-8 path")
}

fn folder_of(output: &Output) -> PathBuf {
    let stdout = text(&output.stdout);
    let folder = stdout.lines().find_map(|line| line.strip_prefix("results: "));
    PathBuf::from(folder.unwrap_or_else(|| panic!("{stdout}{}", text(&output.stderr))).trim())
}

/// Checks that `lfpiv compare` finds the same vectors, bit for bit, and the same ledger.
fn assert_same(run: &Path, again: &Path, shots: usize) {
    let output = lfpiv(&["compare", utf8(run), utf8(again)]);
    let said = text(&output.stdout);
    println!("{said}{}", text(&output.stderr));
    assert!(output.status.success(), "{said}{}", text(&output.stderr));
    assert!(said.contains(&format!("{shots} shots compared with")), "{said}");
    assert!(said.contains("0 different") && said.contains("ledgers are the same"), "{said}");
}

/// Rows of a file of comma-separated values, without its header.
fn rows(path: &Path) -> Vec<Vec<String>> {
    let text = fs::read_to_string(path).expect("a list of frames");
    text.lines().skip(1).map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

/// Checksums of a camera's frames in the order of the triggers.
fn recorded_checksums(run: &Path, camera: usize) -> Vec<String> {
    let shots = images(run);
    let frames = shots.iter().flat_map(|(_, cameras)| &cameras[camera]);
    frames.map(|image| format!("{:08x}", image.crc32())).collect()
}

#[test]
fn a_recorded_run_gives_the_same_vectors_and_ledger_over_the_wires() {
    const SHOTS: usize = 12;
    in_private_network(
        "replayed::a_recorded_run_gives_the_same_vectors_and_ledger_over_the_wires",
        || {
            let stage = Stage::with_run_of("12");
            let (output, told) = stage.play(&stage.recorded, &[], &stage.daemon(), "12");
            assert!(output.status.success(), "{}", text(&output.stderr));
            assert!(told.contains("12 triggers as recorded; dark: 0 with"), "{told}");
            let again = folder_of(&output);
            assert_same(&stage.recorded, &again, SHOTS);
            assert!(images(&again) == images(&stage.recorded), "other pixels");
            for camera in 0..2 {
                let name = format!("cam{}", camera + 1);
                let received = rows(&stage.path("received").join(format!("{name}.csv")));
                let crcs: Vec<_> = received.iter().map(|row| row[5].clone()).collect();
                assert_eq!(crcs, recorded_checksums(&stage.recorded, camera));
                assert!(received.iter().all(|row| row[4] == "complete"));
                let sent = rows(&stage.path("sent.csv"));
                let sent: Vec<_> = sent.into_iter().filter(|row| row[0] == name).collect();
                // Exposure time on the camera's clock, and checksum.
                let of = |rows: &[Vec<String>], time: usize, crc: usize| -> Vec<_> {
                    rows.iter().map(|row| (row[time].clone(), row[crc].clone())).collect()
                };
                assert_eq!(of(&sent, 3, 4), of(&received, 2, 5));
            }
            assert_program_on_the_line(&stage.path("serial.txt"), &again);
        },
    );
}

/// Commands sent by the host, according to the transcript.
fn commands(transcript: &Path) -> String {
    let text = fs::read_to_string(transcript).expect("a transcript");
    let sent = text.lines().filter_map(|line| line.split_once(" > ").map(|(_, bytes)| bytes));
    sent.collect::<String>().replace("\\r\\n", "\n")
}

/// Checks that the bytes on the pseudo-terminal are the schedule of the run, and that the run's
/// record has the same bytes.
fn assert_program_on_the_line(transcript: &Path, run: &Path) {
    let commands = commands(transcript);
    let (mut schedule, mut noted): (Option<PulseSchedule>, _) = (None, String::new());
    for placed in RecordedRun::open(run).expect("a record").entries() {
        match placed.expect("an entry").entry {
            Entry::Programmed { schedule: programmed, .. } => schedule = Some(programmed),
            Entry::Serial { direction: Direction::ToUnit, bytes, .. } => noted.push_str(&bytes),
            _ => {}
        }
    }
    let noted = noted.replace("\\r\\n", "\n");
    assert!(commands.starts_with(&noted) && noted.len() > 500, "{noted}");
    let schedule = schedule.expect("a schedule");
    let value = |command: &str| -> f64 {
        let mut all = noted.lines().filter_map(|line| line.strip_prefix(command));
        let value = all.next_back().unwrap_or_else(|| panic!("{command} in {noted}"));
        value.trim().parse().expect("a number")
    };
    assert!((value(":PULSE0:PER ") - schedule.period_us * 1e-6).abs() < 1e-9);
    let outputs = [
        schedule.lamp_us[0],
        schedule.q_switch_us[0],
        schedule.lamp_us[1],
        schedule.q_switch_us[1],
        schedule.camera_trigger_us,
    ];
    for (channel, delay_us) in (1..).zip(outputs) {
        let delay_s = value(&format!(":PULSE{channel}:DEL "));
        assert!((delay_s - delay_us * 1e-6).abs() < 1e-9, "channel {channel}: {delay_s}");
    }
}

/// The outcomes of one camera in a run's ledger.
fn outcomes(run: &Path, camera: usize) -> BTreeMap<String, u64> {
    let ledger = fs::read(run.join("ledger.json")).expect("a ledger");
    let ledger: Value = serde_json::from_slice(&ledger).expect("JSON");
    assert_eq!(ledger["balanced"], true);
    let outcomes = ledger["cameras"][camera]["outcomes"].as_object().expect("outcomes");
    outcomes
        .iter()
        .map(|(name, number)| (name.clone(), number.as_u64().expect("a count")))
        .collect()
}

/// Frames are dropped and triggers missed during the replay, and the daemon's ledger shows them.
/// Its own record, including the losses, is replayed again and ends in the same way.
#[test]
fn faults_are_in_the_ledger_and_a_record_with_losses_loses_the_same_again() {
    const SHOTS: usize = 16;
    in_private_network(
        "replayed::faults_are_in_the_ledger_and_a_record_with_losses_loses_the_same_again",
        || {
            let stage = Stage::with_run_of("16");
            let faults = stage.path("faults.toml");
            let shares = "[camera.shares]\ndropped = 0.08\nmissed_trigger = 0.06\n\
                          [line]\nslow_ms = 20\n[line.shares]\nslow = 0.2\n";
            fs::write(&faults, format!("seed = 1\n{shares}")).unwrap();
            let with_faults = ["--faults", utf8(&faults)];
            let (output, told) =
                stage.play(&stage.recorded, &with_faults, &stage.daemon_that_loses_frames(), "16");
            let disturbed = folder_of(&output);
            println!("{told}{}", text(&output.stderr));
            assert!(told.contains("Dropped") && told.contains("MissedTrigger"), "{told}");
            assert!(told.contains("serial line; faults:") && told.contains("Slow"), "{told}");
            // With this seed no camera loses both frames of a trigger that it saw.
            let mut whole = vec![true; SHOTS];
            for camera in 0..2 {
                let name = format!("cam{}", camera + 1);
                let mut sent = vec![0_u64; SHOTS];
                for row in rows(&stage.path("sent.csv")).iter().filter(|row| row[0] == name) {
                    sent[row[1].parse::<usize>().unwrap()] += 1;
                }
                let shots_with = |frames| sent.iter().filter(|n| **n == frames).count() as u64;
                let outcomes = outcomes(&disturbed, camera);
                println!("{name}: {sent:?} {outcomes:?}");
                assert_eq!(outcomes["missing_packets"], shots_with(1));
                assert_eq!(outcomes["missed_trigger"], shots_with(0));
                assert_eq!(outcomes["complete"] + outcomes["unpaired"], shots_with(2));
                whole.iter_mut().zip(&sent).for_each(|(whole, frames)| *whole &= *frames == 2);
            }
            let whole = whole.into_iter().filter(|whole| *whole).count();
            assert!((1..SHOTS).contains(&whole), "{whole}");
            assert_eq!(images(&disturbed).len(), whole);

            let received = [stage.received(0), stage.received(1)];
            let (output, told) =
                stage.play(&disturbed, &[], &stage.daemon_that_loses_frames(), "16");
            assert!(told.contains("16 triggers as recorded; dark: 0 with"), "{told}");
            assert_same(&disturbed, &folder_of(&output), whole);
            // Including those of incomplete shots.
            assert_eq!([stage.received(0), stage.received(1)], received);
        },
    );
}

#[test]
fn light_outside_the_record_is_dark_and_truncating_formats_are_refused() {
    in_private_network(
        "replayed::light_outside_the_record_is_dark_and_truncating_formats_are_refused",
        || {
            let stage = Stage::with_run_of("2");
            // Beyond the end of the record.
            let (output, told) = stage.play(&stage.recorded, &[], &stage.daemon(), "3");
            assert!(told.contains("2 triggers as recorded; dark: 0 with other light, 1 after"));
            let taken = images(&folder_of(&output));
            let is_dark = |(_, cameras): &(u64, Vec<[lfpiv_hw::RawImage; 2]>)| {
                let mut counts = cameras.iter().flatten().flat_map(|image| image.counts());
                counts.all(|count| *count == 0)
            };
            assert_eq!(taken.iter().map(is_dark).collect::<Vec<_>>(), [false, false, true]);

            // Lamps of head 2 that fire at another time give different light.
            let config = stage.daemon();
            let slow_lamp =
                replaced(TIMING, "[timing]", "[timing]\nlamp_to_q_switch_us = [180.0, 150.0]");
            let instruments =
                Instruments::start(&stage.wire(), &stage.recorded, &stage.path("sent.csv"), &[]);
            let path = stage.written("daemon.toml", &config);
            let text_of = fs::read_to_string(&path).unwrap();
            fs::write(&path, replaced(&text_of, TIMING, &slow_lamp)).unwrap();
            let output = lfpiv(&["run", "--config", utf8(&path), "--shots", "2"]);
            let told = format!("{}{}", instruments.finish(), text(&output.stderr));
            assert!(told.contains("0 triggers as recorded; dark: 2 with other light"), "{told}");

            // 12 bits do not fit into 8.
            let narrow = replaced(&config, "\"Mono12Packed\"", "\"Mono8\"");
            let (output, told) = stage.play(&stage.recorded, &[], &narrow, "2");
            let said = text(&output.stderr);
            assert!(!output.status.success() && said.contains("Mono8"), "{said}");
            assert!(told.contains("0 triggers as recorded"), "{told}");
        },
    );
}
