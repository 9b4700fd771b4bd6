//! Frames arrive unchanged over the wires and are assigned correctly.

use std::{fs, process::Command, sync::Arc};

use lfpiv::cli::Streamed;
use lfpiv_core::{lightfield::ImagePair, measurement::Processor};
use lfpiv_hw::gige::ImageSize;
use lfpiv_sim::wire::{ScenePictures, WireSettings, bench::WireBench};

use crate::{
    bench::{Patterns, SIZE, Taken, connect, patterns, small, take, wire},
    network::in_private_network,
};

#[test]
fn two_hundred_shots_arrive_byte_for_byte() {
    const SHOTS: u64 = 200;
    in_private_network("shots::two_hundred_shots_arrive_byte_for_byte", || {
        let folder = tempfile::tempdir().unwrap();
        let wire = wire(folder.path());
        let instruments = patterns(&wire);
        let taken = take(connect(&wire, SIZE), SHOTS, 40.0, |_| {});
        let report = taken.ended.as_ref().unwrap();
        assert_eq!(report.triggers, SHOTS);
        taken.assert_pictures(&Patterns(SIZE));
        let sent = instruments.report();
        assert_eq!(sent.q_switches, [SHOTS; 2]);
        let streams = taken.ledger.streams();
        for (frames, stream) in sent.frames.iter().zip(streams) {
            assert!(frames.sent <= 2 * SHOTS, "{frames:?}");
            assert!(stream.completed + stream.failed <= frames.sent, "{frames:?} {stream:?}");
        }
        let complete = taken.complete(0);
        assert_eq!((taken.complete(1), taken.shots.len() as u64), (complete, complete));
        assert!(complete > 0);
        // A machine that does other things too may send and receive too slowly; nothing is lost silently.
        let undisturbed = streams.iter().all(|stream| stream.completed == 2 * SHOTS);
        assert_eq!(complete == SHOTS, undisturbed, "{sent:?} {streams:?}");
        assert!(!undisturbed || taken.shots.iter().all(|shot| shot.suspect.is_empty()));
        println!("{complete} of {SHOTS} shots in {:.1} s", taken.seconds);
    });
}

/// As `lfpiv bench --set loopback` measures.
#[test]
fn the_binary_drives_its_own_bench_and_says_how_fast() {
    in_private_network("shots::the_binary_drives_its_own_bench_and_says_how_fast", || {
        let folder = tempfile::tempdir().unwrap();
        let shipped = concat!(env!("CARGO_MANIFEST_DIR"), "/config/loopback-bench.toml");
        let port = format!("port = \"{}\"", folder.path().join("port").display());
        let text = fs::read_to_string(shipped).unwrap();
        let text = text.replacen("port = \"results/loopback/synchroniser\"", &port, 1);
        assert!(text.contains(&port));
        let config = folder.path().join("bench.toml");
        fs::write(&config, text).unwrap();
        let output = Command::new(env!("CARGO_BIN_EXE_lfpiv"))
            .args(["sim-bench", "--drive", "4", "--config"])
            .arg(&config)
            .output()
            .unwrap();
        let told: Streamed = serde_json::from_slice(&output.stdout)
            .unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(&output.stderr)));
        assert_eq!(told.whole_shots, 4);
        assert!(told.frames_per_s > 0.0 && told.mb_per_s > told.frames_per_s, "{told:?}");
    });
}

#[test]
fn velocity_over_the_wires_is_velocity_in_process_bit_for_bit() {
    const SHOTS: u64 = 3;
    in_private_network("shots::velocity_over_the_wires_is_velocity_in_process_bit_for_bit", || {
        let config = small();
        let (scene, geometry) = (config.simulation.clone().unwrap(), config.bench_geometry());
        let taken = scene_taken(ScenePictures {
            scene: scene.clone(),
            geometry: geometry.clone(),
            seed: scene.seed,
        });
        assert_eq!(taken.complete(0), SHOTS);
        let processor = Processor::new(config.measurement()).unwrap();
        for shot in taken.shots {
            let sent = scene.shot(&geometry, scene.seed, shot.trigger);
            let cameras = shot.cameras.into_iter().map(|frames| frames.map(|frame| frame.image));
            let received = ImagePair { cameras: cameras.collect() };
            let over_wires = processor.process(&received).unwrap().field;
            let in_process = processor.process(&ImagePair { cameras: sent.images }).unwrap();
            assert!(over_wires.valid_share() > 0.9, "{}", over_wires.valid_share());
            assert_eq!(over_wires, in_process.field);
        }
    });

    fn scene_taken(pictures: ScenePictures) -> Taken {
        let folder = tempfile::tempdir().unwrap();
        let wire = wire(folder.path());
        let size = ImageSize::from(&pictures.geometry.optics.sensor);
        let bits = pictures.scene.sensor.bits.into();
        let _instruments = WireBench::start(&wire, size, bits, Arc::new(pictures)).unwrap();
        take(connect(&wire, size), SHOTS, 5.0, |_| {})
    }
}

/// The bench's cameras are slower than configured: both light pulses fall into exposure 1 and none
/// into exposure 2, although the schedule was right for the configuration.
#[test]
fn a_wrong_delay_gives_a_wrong_and_a_dark_image() {
    in_private_network("shots::a_wrong_delay_gives_a_wrong_and_a_dark_image", || {
        let folder = tempfile::tempdir().unwrap();
        let right = wire(folder.path());
        let slow = WireSettings { camera_latency_us: 150.0, ..right };
        let _instruments = patterns(&slow);
        let taken = take(connect(&slow, SIZE), 2, 10.0, |_| {});
        assert_eq!(taken.complete(0), 2);
        for shot in &taken.shots {
            for [a, b] in &shot.cameras {
                let [twice_lit, dark] = [a, b].map(|frame| &frame.image);
                // `Patterns` shows an exposure with two pulses as black, too; a scene would show both.
                assert!(twice_lit.counts().iter().all(|count| *count == 0));
                assert!(dark.counts().iter().all(|count| *count == 0));
            }
        }
    });
}
