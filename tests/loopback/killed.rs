//! A killed daemon: the current burst is the last one.

use std::{
    fs::{self, File},
    io::{BufRead, BufReader},
    path::{Path, PathBuf},
    process::{Child, Command, Stdio},
    sync::Arc,
    thread,
    time::{Duration, Instant},
};

use lfpiv_hw::gige::ImageSize;
use lfpiv_sim::wire::bench::WireBench;

use crate::{
    bench::{LONG, Repeated, small, wire},
    network::in_private_network,
};

/// Shot rate of the daemon below.
const RATE_HZ: f64 = 20.0;

/// Configuration of the small bench on real wires.
fn configuration(folder: &Path, port: &Path) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/small.toml");
    let text = fs::read_to_string(path).expect("small.toml");
    let text = &text[..text.find("[simulation]").expect("a scene")];
    let results = format!("dir = \"{}\"", folder.join("results").display());
    let text = text.replacen("dir = \"results\"", &results, 1);
    let rate = text.lines().find(|line| line.starts_with("rate_hz")).expect("a rate");
    let text = text.replacen(rate, &format!("rate_hz = {RATE_HZ:.1}"), 1);
    let camera = |ip: &str| {
        format!(
            "[[instruments.camera]]\nip = \"{ip}\"\npacket_size_bytes = 16000\n\
             frame_retention_us = 2000000\n"
        )
    };
    format!(
        "{text}\n[timing]\nlaser_rate_limit_hz = 40.0\nreadout_us = 5000.0\nlamp_warm_up_s = 0.0\n\
         [instruments]\nframe_patience_s = 10.0\n{}{}[instruments.synchroniser]\n\
         driver = \"bnc-575\"\nport = \"{}\"\nreply_timeout_ms = 5000\npacing_ms = 0\n",
        camera("127.0.0.1"),
        camera("127.0.0.2"),
        port.display()
    )
}

/// Instruments, and a configuration for a daemon that uses them.
fn instruments(folder: &Path) -> (WireBench, PathBuf) {
    let wire = wire(folder);
    let size = ImageSize::from(&small().optics.sensor);
    let pictures = Arc::new(Repeated::new(size));
    let instruments = WireBench::start(&wire, size, 12, pictures).expect("a bench");
    let config = folder.join("loopback.toml");
    fs::write(&config, configuration(folder, &wire.port)).expect("a file");
    (instruments, config)
}

/// Kills the daemon when a test fails. Otherwise it would wait for its instruments for ever and
/// keep the test's output open.
struct Daemon(Child);

impl Drop for Daemon {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// What the last daemon with this configuration says.
fn log_of(config: &Path) -> PathBuf {
    config.with_extension("log")
}

fn daemon(config: &Path, shots: Option<u64>) -> Daemon {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lfpiv"));
    let log = File::create(log_of(config)).expect("a log");
    command.args(["run", "--config"]).arg(config).stdout(Stdio::piped()).stderr(log);
    if let Some(shots) = shots {
        command.args(["--shots", &shots.to_string()]);
    }
    Daemon(command.spawn().expect("the binary starts"))
}

fn q_switch_pulses(instruments: &WireBench) -> u64 {
    instruments.report().q_switches[0]
}

/// Waits until this many Q-switch pulses were given.
fn wait_for_pulses(instruments: &WireBench, count: u64, Daemon(daemon): &mut Daemon) {
    let began = Instant::now();
    while q_switch_pulses(instruments) < count {
        assert!(began.elapsed() < LONG, "no shots: {:?}", daemon.try_wait());
        thread::sleep(Duration::from_millis(20));
    }
}

/// SIGTERM switches the laser off at once, not at the end of the burst, and reads it back; until
/// then `/metrics` shows the cameras' stream counters.
#[test]
fn a_terminated_daemon_makes_the_laser_safe_at_once() {
    in_private_network("killed::a_terminated_daemon_makes_the_laser_safe_at_once", || {
        let folder = tempfile::tempdir().unwrap();
        let (instruments, config) = instruments(folder.path());
        let mut daemon = daemon(&config, None);
        let mut lines = BufReader::new(daemon.0.stdout.take().unwrap()).lines();
        let status = lines.next().unwrap().unwrap();
        wait_for_pulses(&instruments, 30, &mut daemon);

        let metrics = status.replace("status:", "").replace("/api/v1/status", "/metrics");
        let mut answer = ureq::get(metrics.trim()).call().unwrap();
        let told = answer.body_mut().read_to_string().unwrap();
        let counted = told.lines().filter(|line| {
            line.starts_with("lfpiv_stream_frames_completed_total{")
                && line.rsplit(' ').next().is_some_and(|n| n.parse::<u64>().unwrap() > 0)
        });
        assert_eq!(counted.count(), 2, "{told}");

        let at_end = q_switch_pulses(&instruments);
        Command::new("kill").arg(daemon.0.id().to_string()).status().unwrap();
        assert!(daemon.0.wait().unwrap().success());
        let after = q_switch_pulses(&instruments);
        // Signal, command and read-back take a few periods on a busy machine; a burst has 100.
        assert!(after - at_end <= 30, "{at_end} {after}");
        let unit = instruments.unit();
        assert!(!unit.is_running() && (1..=8).all(|channel| !unit.is_enabled(channel)));
    });
}

/// A second SIGTERM during the commands that make the laser safe: the process exits early, but not
/// before the read-back.
#[test]
fn a_daemon_terminated_twice_ends_after_the_read_back() {
    in_private_network("killed::a_daemon_terminated_twice_ends_after_the_read_back", || {
        let folder = tempfile::tempdir().unwrap();
        let (instruments, config) = instruments(folder.path());
        let transcript = folder.path().join("serial.log");
        let paced = format!("pacing_ms = 60\ntranscript = {transcript:?}");
        let text = fs::read_to_string(&config).unwrap().replacen("pacing_ms = 0", &paced, 1);
        fs::write(&config, text).unwrap();
        let mut daemon = daemon(&config, None);
        wait_for_pulses(&instruments, 10, &mut daemon);

        let terminate =
            || Command::new("kill").arg(daemon.0.id().to_string()).status().unwrap().success();
        let heard = || fs::read_to_string(&transcript).unwrap();
        let orders = |text: &str| text.matches(&off(2)).count();
        let before = orders(&heard());
        assert!(terminate());
        let told = Instant::now();
        while orders(&heard()) == before {
            assert!(told.elapsed() < LONG, "{}", heard());
            thread::sleep(Duration::from_millis(5));
        }
        assert!(terminate());
        assert_eq!(daemon.0.wait().unwrap().code(), Some(130));

        let text = heard();
        let last = &text[text.rfind(&off(2)).unwrap()..];
        for output in [2, 4, 1, 3, 0, 5, 6, 7, 8] {
            let read_back = format!("> :PULSE{output}:STATE?\\r\\n");
            // Asked again where instruments on a busy machine reply late.
            let next_line = |(at, _): (usize, &str)| last[at..].lines().nth(1);
            let next_lines = last.match_indices(&read_back).filter_map(next_line);
            let answers: Vec<&str> = next_lines.filter(|line| line.contains(" < ")).collect();
            let all_off = answers.iter().all(|line| line.ends_with("< 0\\r\\n"));
            assert!(!answers.is_empty() && all_off, "{output}: {last}");
        }
        let unit = instruments.unit();
        assert!(!unit.is_running() && (1..=8).all(|channel| !unit.is_enabled(channel)));
    });
}

/// An off command as in the transcript.
fn off(output: u8) -> String {
    format!(":PULSE{output}:STATE OFF")
}

/// A SIGKILLed daemon leaves at most one burst of Q-switch pulses behind. The next daemon connects
/// to unit and cameras, which are still controlled by the old one, and measures.
#[test]
fn a_killed_daemon_leaves_no_more_than_one_burst() {
    in_private_network("killed::a_killed_daemon_leaves_no_more_than_one_burst", || {
        let folder = tempfile::tempdir().unwrap();
        let (instruments, config) = instruments(folder.path());

        let mut first = daemon(&config, None);
        wait_for_pulses(&instruments, 30, &mut first);
        first.0.kill().unwrap();
        let at_kill = q_switch_pulses(&instruments);
        first.0.wait().unwrap();
        // The longest burst takes five seconds.
        thread::sleep(Duration::from_secs(7));
        let after = q_switch_pulses(&instruments);
        println!("{at_kill} pulses when killed, {after} in the end");
        assert!(after - at_kill <= (5.0 * RATE_HZ) as u64, "{at_kill} {after}");
        thread::sleep(Duration::from_secs(2));
        assert_eq!(q_switch_pulses(&instruments), after);

        let status = daemon(&config, Some(2)).0.wait().unwrap();
        assert!(status.success(), "{status}: {}", fs::read_to_string(log_of(&config)).unwrap());
        assert_eq!(q_switch_pulses(&instruments), after + 2);
    });
}
