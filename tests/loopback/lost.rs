//! A bench that is lost during a run, synchroniser and cameras together, and comes back.

use std::{fs, path::Path, process::Command, sync::Arc, thread, time::Duration};

use lfpiv::config::ConfigFile;
use lfpiv_hw::gige::ImageSize;
use lfpiv_sim::wire::{WireSettings, bench::WireBench};
use serde_json::Value;

use crate::{
    bench::{LONG, Repeated, wire},
    network::in_private_network,
    tiny::{Running, configuration, images, lfpiv, text},
};

const CAMERA: &str = "packet_size_bytes = 16000\nframe_retention_us = 2000000\n";

fn switch_on(wire: &WireSettings, config: &Path) -> WireBench {
    let size = ImageSize::from(&ConfigFile::load(config).expect("a bench").config.optics.sensor);
    WireBench::start(wire, size, 12, Arc::new(Repeated::new(size))).expect("instruments")
}

fn q_switch_pulses(instruments: &WireBench) -> u64 {
    instruments.report().q_switches[0]
}

fn wait_for_pulses(instruments: &WireBench, count: u64) {
    let began = std::time::Instant::now();
    while q_switch_pulses(instruments) < count {
        assert!(began.elapsed() < LONG, "no shots");
        thread::sleep(Duration::from_millis(20));
    }
}

#[test]
fn a_run_waits_for_a_lost_bench_and_then_for_the_operator() {
    in_private_network("lost::a_run_waits_for_a_lost_bench_and_then_for_the_operator", || {
        let folder = tempfile::tempdir().unwrap();
        let wire = wire(folder.path());
        let config = configuration(folder.path(), "");
        let scene = fs::read_to_string(&config).unwrap();
        let bench = &scene[..scene.find("[simulation]").unwrap()];
        let instruments = format!(
            "{bench}\n[timing]\nlaser_rate_limit_hz = 40.0\nreadout_us = 5000.0\n\
                 lamp_warm_up_s = 0.0\n[instruments]\nframe_patience_s = 3.0\n\
                 [[instruments.camera]]\nip = \"127.0.0.1\"\n{CAMERA}\
                 [[instruments.camera]]\nip = \"127.0.0.2\"\n{CAMERA}\
                 [instruments.synchroniser]\ndriver = \"bnc-575\"\nport = {:?}\npacing_ms = 0\n",
            wire.port
        );
        fs::write(&config, instruments).unwrap();
        let instruments = switch_on(&wire, &config);
        let running = Running::start(&config, &[]);
        wait_for_pulses(&instruments, 20);

        drop(instruments);
        let status = running.wait_until(|status| status["state"] == "bench_lost");
        assert_eq!(status["control"]["mode"], "lost");
        let health = ureq::get(&format!("{}/healthz", running.address)).call();
        assert!(matches!(health, Err(ureq::Error::StatusCode(503))), "{health:?}");
        thread::sleep(Duration::from_secs(3));

        let instruments = switch_on(&wire, &config);
        let status = running.wait_until(|status| status["control"]["mode"] == "disarmed");
        assert_eq!(status["state"], "running");
        assert!(status["control"]["held"][0].as_str().unwrap().contains("kill -USR1"));
        thread::sleep(Duration::from_secs(2));
        let unit = instruments.unit();
        assert!(!unit.is_running() && (1..=8).all(|channel| !unit.is_enabled(channel)));
        drop(unit);
        assert_eq!(q_switch_pulses(&instruments), 0, "no operator has permitted firing");

        let shots = |status: &Value| status["shots"]["triggered"].as_u64().unwrap();
        let before = shots(&status);
        let id = running.child.id().to_string();
        assert!(Command::new("kill").args(["-USR1", &id]).status().unwrap().success());
        wait_for_pulses(&instruments, 20);
        running.wait_until(|status| shots(status) > before);
        let run = running.terminate();

        let ledger: Value =
            serde_json::from_slice(&fs::read(run.join("ledger.json")).unwrap()).unwrap();
        println!("{}", ledger["cameras"]);
        assert_eq!((&ledger["balanced"], &ledger["error"]), (&true.into(), &Value::Null));
        let taken: Vec<u64> = images(&run).into_iter().map(|(shot, _)| shot).collect();
        assert!(taken.iter().any(|shot| *shot < before), "{taken:?}");
        assert!(taken.iter().any(|shot| *shot >= before), "{taken:?}");

        let run = run.to_str().unwrap();
        let out = folder.path().join("again");
        for command in [&["process", run][..], &["replay", "--out", out.to_str().unwrap(), run]] {
            let output = lfpiv(command);
            println!("{}{}", text(&output.stdout), text(&output.stderr));
            assert!(output.status.success(), "{command:?}");
        }
    });
}
