//! Packet loss, a lost camera, a silent synchroniser.

use std::{thread, time::Duration};

use lfpiv::acquisition::Outcome;
use lfpiv_hw::gige::CameraSettings;
use lfpiv_sim::wire::{WireSettings, bench::WireBench};

use crate::{
    bench::{
        LONG, Patterns, SIZE, camera, connect, connect_with, connect_within, patterns, take, wire,
    },
    network::in_private_network,
};

#[test]
fn lost_packets_cost_shots_and_never_pixels() {
    const SHOTS: u64 = 40;
    in_private_network("faults::lost_packets_cost_shots_and_never_pixels", || {
        let folder = tempfile::tempdir().unwrap();
        // 27 packets per frame: about a quarter of the frames are damaged. The probability that
        // none of a camera's 80 frames is damaged, or that no shot is intact, is below one in a
        // million.
        let wire = WireSettings { lost_packets: 0.01, ..wire(folder.path()) };
        let _instruments = patterns(&wire);
        // A damaged frame holds back the ten after it, and there are twelve buffers.
        let settings = |index| CameraSettings { frame_retention_us: 500_000, ..camera(index) };
        let taken = take(connect_with(&wire, SIZE, settings), SHOTS, 10.0, |_| {});
        taken.ended.as_ref().unwrap();
        taken.assert_pictures(&Patterns(SIZE));
        for (account, stream) in taken.ledger.accounts().iter().zip(taken.ledger.streams()) {
            let damaged = account.outcomes.of(Outcome::MissingPackets);
            println!("{account:?} {stream:?}");
            assert_eq!(account.triggers, SHOTS);
            assert!(stream.failed > 0 && damaged > 0, "{account:?} {stream:?}");
        }
        assert!(taken.complete(0) > 0);
    });
}

/// The cable of camera 2 is unplugged during a burst and plugged in again.
#[test]
fn a_run_waits_for_a_lost_camera() {
    const SHOTS: u64 = 60;
    in_private_network("faults::a_run_waits_for_a_lost_camera", || {
        let folder = tempfile::tempdir().unwrap();
        let wire = wire(folder.path());
        let instruments = patterns(&wire);
        let bench = connect(&wire, SIZE);
        let taken = thread::scope(|scope| {
            let (told, tell) = std::sync::mpsc::channel();
            let instruments = &instruments;
            let fault = move || {
                tell.recv_timeout(LONG).expect("ten shots");
                instruments.camera(1).unplug();
                thread::sleep(Duration::from_secs(3));
                instruments.camera(1).plug_in().unwrap();
            };
            scope.spawn(fault);
            take(bench, SHOTS, 10.0, |shot| {
                if shot.trigger == 10 {
                    told.send(()).unwrap();
                }
            })
        });
        let report = taken.ended.as_ref().unwrap();
        assert_eq!(report.triggers, SHOTS);
        taken.assert_pictures(&Patterns(SIZE));
        let stream = taken.ledger.streams()[1];
        assert_eq!(stream.reconnects, 1, "{stream:?}");
        let [first, second] = [taken.complete(0), taken.complete(1)];
        assert_eq!(first, second);
        let last = taken.shots.last().unwrap();
        println!("{first} of {SHOTS} shots whole, {stream:?}");
        assert_eq!(last.trigger, SHOTS - 1);
        // At most a burst is lost, and there are intact shots on both sides of the gap.
        assert!((11..SHOTS).contains(&first), "{first}");
        // Q-switches go off before the cameras' triggers when the burst is ended. How many triggers
        // come in between depends on the machine; every other intact shot was lit.
        let lit = first - taken.dark_shots();
        assert!(lit >= 11, "{lit} of {first}");
        for pulses in instruments.report().q_switches {
            assert!((lit..=SHOTS).contains(&pulses), "{pulses}");
        }
    });
}

#[test]
fn a_synchroniser_that_falls_silent_ends_the_run_and_its_burst_ends_itself() {
    in_private_network(
        "faults::a_synchroniser_that_falls_silent_ends_the_run_and_its_burst_ends_itself",
        || disturbed_in_a_burst(|instruments| instruments.unit().silence_after(0)),
    );
}

#[test]
fn a_serial_line_that_is_cut_ends_the_run_and_its_burst_ends_itself() {
    in_private_network(
        "faults::a_serial_line_that_is_cut_ends_the_run_and_its_burst_ends_itself",
        || disturbed_in_a_burst(WireBench::cut_line),
    );
}

/// Checks that the run ends and reports an unknown state, that at most one more burst of Q-switch
/// pulses is given, and that frames that had arrived are intact.
fn disturbed_in_a_burst(disturb: impl Fn(&WireBench)) {
    const RATE_HZ: f64 = 20.0;
    let folder = tempfile::tempdir().expect("a folder");
    let wire = wire(folder.path());
    let instruments = patterns(&wire);
    // A loss that occurs earlier, on a busy machine, is just as good.
    let bench = connect_within(&wire, SIZE, camera, 1000);
    let taken = take(bench, 400, RATE_HZ, |shot| {
        if shot.trigger == 5 {
            disturb(&instruments);
        }
    });
    let error = taken.ended.as_ref().expect_err("a lost unit").to_string();
    assert!(error.contains("interlock"), "{error}");
    taken.assert_pictures(&Patterns(SIZE));
    // A single shot comes first, then bursts of at most five seconds.
    thread::sleep(Duration::from_secs(6));
    let after_burst = instruments.report().q_switches;
    assert!(after_burst[0] <= 1 + (5.0 * RATE_HZ) as u64, "{after_burst:?}");
    thread::sleep(Duration::from_secs(1));
    assert_eq!(instruments.report().q_switches, after_burst);
}
