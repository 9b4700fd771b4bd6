//! Acquisition with deliberately disturbed cameras: the ledger must agree with the injected faults.

use std::{sync::Arc, time::Duration};

use lfpiv::acquisition::{
    AcquisitionError, AcquisitionLinks, AcquisitionReport, AcquisitionSettings, Ledger, Outcome,
    OverloadPolicy, Shot, acquire, shot_queue,
};
use lfpiv_hw::{
    CameraName,
    device::{Camera, DeviceError, Frame, StreamStatistics},
};
use lfpiv_sim::faults::{
    CameraFaults, ClockJump, FaultRecord, FaultSettings, FaultyCamera, FrameFault, FrameShares,
};
use parking_lot::Mutex;
use tokio_util::sync::CancellationToken;

use crate::{
    acquisition::settings,
    bench::{CallLog, bench, configuration},
};

const SHOTS: u64 = 120;
/// Far longer than a loaded machine delays a frame of the quick bench.
const PATIENCE: Duration = Duration::from_secs(3);
/// A few per cent.
const SHARE: f64 = 0.03;

/// Writes the true trigger into `host_timestamp_ns`, which pairing does not use.
struct Truthful(Box<dyn Camera>);

impl Camera for Truthful {
    fn name(&self) -> &str {
        self.0.name()
    }

    fn start(&mut self) -> Result<(), DeviceError> {
        self.0.start()
    }

    fn next_frame(&mut self, timeout: Duration) -> Result<Option<Frame>, DeviceError> {
        let frame = self.0.next_frame(timeout)?;
        Ok(frame.map(|frame| Frame { host_timestamp_ns: frame.frame_id / 2, ..frame }))
    }

    fn stop(&mut self) -> Result<(), DeviceError> {
        self.0.stop()
    }

    fn statistics(&self) -> StreamStatistics {
        self.0.statistics()
    }
}

fn true_triggers(shot: &Shot) -> Vec<u64> {
    shot.cameras.iter().flatten().map(|frame| frame.host_timestamp_ns).collect()
}

struct Taken {
    ended: Result<AcquisitionReport, AcquisitionError>,
    shots: Vec<Shot>,
    ledger: Ledger,
    calls: CallLog,
    records: Vec<FaultRecord<FrameFault>>,
}

impl Taken {
    /// Triggers for which `fault` was injected in a camera.
    fn befallen(&self, camera: usize, fault: FrameFault) -> Vec<u64> {
        let faults = self.records[camera].faults();
        let triggers = faults.iter().filter(|f| f.fault == fault).map(|f| f.number / 2);
        let mut triggers: Vec<u64> = triggers.collect();
        triggers.dedup();
        triggers
    }

    /// Triggers with this outcome for a camera, by the ledger.
    fn ended_as(&self, camera: usize, outcome: Outcome) -> Vec<u64> {
        let ended = self.ledger.entries().filter(|e| e.cameras[camera] == Some(outcome));
        ended.map(|entry| entry.trigger).collect()
    }

    fn counters(&self) -> lfpiv::acquisition::pairing::FrameCounters {
        self.ended.as_ref().unwrap().frames
    }

    fn suspects(&self) -> Vec<u64> {
        let suspect = self.shots.iter().filter(|shot| !shot.suspect.is_empty());
        suspect.map(|shot| shot.trigger).collect()
    }

    fn assert_safe_end(&self) {
        let calls = self.calls.lock();
        let last_fire = calls.iter().rposition(|call| call.starts_with("fire")).unwrap();
        let after = |name: &str| calls[last_fire..].iter().position(|call| call == name).unwrap();
        assert!(after("make safe") < after("reads back safe"), "{calls:?}");
        let last_stop = calls[last_fire..].iter().rposition(|call| call == "camera stop").unwrap();
        assert!(after("reads back safe") < last_stop, "{calls:?}");
    }

    /// Properties that hold for any faults.
    fn assert_in_order(&self) {
        assert!(self.ledger.is_balanced());
        for account in self.ledger.accounts() {
            assert_eq!(account.open, 0, "{account:?}");
        }
        assert!(self.ledger.entries().all(|entry| entry.is_settled()));
        for shot in &self.shots {
            let triggers = true_triggers(shot);
            let right = triggers.iter().all(|trigger| *trigger == shot.trigger);
            assert!(right || !shot.suspect.is_empty(), "shot {} is {triggers:?}", shot.trigger);
        }
        self.assert_safe_end();
    }

    /// Checks the whole run: every trigger was given and every frame is counted.
    fn assert_whole(&self) {
        self.assert_in_order();
        let report = self.ended.as_ref().unwrap();
        assert_eq!(report.triggers, SHOTS);
        let given: u64 = self.records.iter().map(FaultRecord::given).sum();
        assert_eq!(report.frames.received, given);
        assert!(self.ledger.accounts().iter().all(|account| account.triggers == SHOTS));
    }

    /// Frames lost by one camera leave the other's unpaired; everything else is complete.
    fn assert_lost(&self, lost: [&[u64]; 2], outcome: Outcome) {
        for trigger in 0..SHOTS {
            let found = &self.ledger.entry(trigger).unwrap().cameras;
            let hit = lost.map(|triggers| triggers.contains(&trigger));
            let expected = hit.map(|own| match (own, hit.contains(&true)) {
                (true, _) => outcome,
                (false, true) => Outcome::Unpaired,
                (false, false) => Outcome::Complete,
            });
            assert_eq!(found[..], expected.map(Some), "trigger {trigger}");
        }
    }
}

async fn take(camera: CameraFaults) -> Taken {
    take_with_seed(11, camera).await
}

async fn take_with_seed(seed: u64, camera: CameraFaults) -> Taken {
    let faults = FaultSettings { seed, camera, ..FaultSettings::default() };
    let (mut bench, calls) = bench(&configuration("unused".as_ref()), &[]);
    let mut records = Vec::new();
    let wrapped = bench.cameras.into_iter().enumerate().map(|(index, camera)| {
        let camera = FaultyCamera::new(Truthful(camera), index, &faults);
        records.push(camera.record());
        Box::new(camera) as Box<dyn Camera>
    });
    bench.cameras = wrapped.collect();
    let ledger = Arc::new(Mutex::new(Ledger::new(2)));
    let (sender, mut receiver) = shot_queue(SHOTS as usize);
    let settings =
        AcquisitionSettings { patience: PATIENCE, ..settings(SHOTS, OverloadPolicy::Shed) };
    let links = AcquisitionLinks::new(ledger.clone(), sender, CancellationToken::new());
    let acquiring = tokio::spawn(acquire(bench, settings, links));
    let mut shots = Vec::new();
    while let Some(shot) = receiver.recv().await {
        ledger.lock().settle_all(shot.trigger, Outcome::Complete).unwrap();
        shots.push(shot);
    }
    let ended = tokio::time::timeout(Duration::from_secs(60), acquiring).await;
    let ended = ended.expect("the run hangs").unwrap();
    let ledger = ledger.lock().clone();
    Taken { ended, shots, ledger, calls, records }
}

fn only(shares: FrameShares) -> CameraFaults {
    CameraFaults { shares, ..CameraFaults::default() }
}

fn none() -> FrameShares {
    FrameShares::default()
}

#[tokio::test]
async fn dropped_frames_cost_their_triggers_and_no_others() {
    let taken = take(only(FrameShares { dropped: SHARE, ..none() })).await;
    taken.assert_whole();
    let lost = [0, 1].map(|camera| taken.befallen(camera, FrameFault::Dropped));
    assert!(lost.iter().all(|lost| lost.len() >= 3), "{lost:?}");
    taken.assert_lost([&lost[0], &lost[1]], Outcome::MissingPackets);
    assert!(taken.suspects().is_empty());
}

#[tokio::test]
async fn truncated_frames_cost_their_triggers_and_no_others() {
    let taken = take(only(FrameShares { truncated: SHARE, ..none() })).await;
    taken.assert_whole();
    let lost = [0, 1].map(|camera| taken.befallen(camera, FrameFault::Truncated));
    assert!(lost.iter().all(|lost| lost.len() >= 3), "{lost:?}");
    taken.assert_lost([&lost[0], &lost[1]], Outcome::MissingPackets);
    assert!(taken.suspects().is_empty());
}

#[tokio::test]
async fn duplicated_frames_are_counted_and_cost_nothing() {
    let taken = take(only(FrameShares { duplicated: SHARE, ..none() })).await;
    taken.assert_whole();
    taken.assert_lost([&[], &[]], Outcome::Complete);
    let injected: u64 = taken.records.iter().map(|r| r.count(|_| true)).sum();
    assert!(injected >= 6, "{injected}");
    // The copy of a frame that completed its shot arrives after the shot has left.
    let counters = taken.counters();
    assert_eq!(counters.duplicate + counters.stray, injected);
}

#[tokio::test]
async fn frames_that_are_corrupted_or_cropped_and_claim_to_be_whole_are_paired() {
    let shares = FrameShares { corrupted: SHARE, cropped: SHARE, ..none() };
    let taken = take(only(shares)).await;
    taken.assert_whole();
    taken.assert_lost([&[], &[]], Outcome::Complete);
    let rows = configuration("unused".as_ref()).config.optics.sensor.rows;
    for camera in [0, 1] {
        let cropped: Vec<u64> = taken
            .shots
            .iter()
            .filter(|shot| shot.cameras[camera].iter().any(|frame| frame.image.rows() < rows))
            .map(|shot| shot.trigger)
            .collect();
        assert!(!cropped.is_empty());
        assert_eq!(cropped, taken.befallen(camera, FrameFault::Cropped));
    }
}

#[tokio::test]
async fn late_frames_are_waited_for_and_then_given_up() {
    let late =
        |late_ms| CameraFaults { late_ms, ..only(FrameShares { late: SHARE / 2.0, ..none() }) };
    let soon = take(late(PATIENCE.as_millis() as u64 / 3)).await;
    soon.assert_whole();
    assert!(soon.records.iter().all(|record| record.count(|_| true) >= 2));
    soon.assert_lost([&[], &[]], Outcome::Complete);

    // Too late, but known to be late.
    let too_late = take(late(PATIENCE.as_millis() as u64 * 3 / 2)).await;
    too_late.assert_whole();
    let lost = [0, 1].map(|camera| too_late.befallen(camera, FrameFault::Late));
    too_late.assert_lost([&lost[0], &lost[1]], Outcome::Late);
}

#[tokio::test]
async fn frames_out_of_order_are_paired_by_number() {
    let taken = take(only(FrameShares { reordered: SHARE, ..none() })).await;
    taken.assert_whole();
    assert!(taken.suspects().is_empty());
    // The last frame of a burst is overtaken only by the next burst, which is too late.
    let (mut burst_ends, mut fired) = (Vec::new(), 0);
    for call in taken.calls.lock().iter() {
        fired += call.strip_prefix("fire ").map_or(0, |shots| shots.parse::<u64>().unwrap());
        burst_ends.push(fired.saturating_sub(1));
    }
    for camera in [0, 1] {
        let reordered = taken.befallen(camera, FrameFault::Reordered);
        assert!(reordered.len() >= 3, "{reordered:?}");
        let kept = reordered.iter().filter(|trigger| !burst_ends.contains(trigger));
        for trigger in kept {
            let other = taken.befallen(1 - camera, FrameFault::Reordered);
            let complete = taken.ledger.entry(*trigger).unwrap().is_complete();
            assert!(complete || other.contains(trigger), "trigger {trigger}");
        }
    }
}

#[tokio::test]
async fn missed_triggers_shift_no_other_shot() {
    let taken = take(only(FrameShares { missed_trigger: SHARE, ..none() })).await;
    taken.assert_whole();
    for camera in [0, 1] {
        let missed = taken.befallen(camera, FrameFault::MissedTrigger);
        assert!(missed.len() >= 2, "{missed:?}");
        assert_eq!(taken.ended_as(camera, Outcome::MissedTrigger), missed);
    }
    // Before the clocks are fitted, only a frame's number shows that the first trigger was missed.
    assert!(taken.befallen(0, FrameFault::MissedTrigger).contains(&0));
    assert!(taken.suspects().iter().all(|trigger| *trigger < 5), "{:?}", taken.suspects());
}

#[tokio::test]
async fn a_drifting_clock_is_followed() {
    let drift =
        CameraFaults { clock_drift_ppm: 100.0, only: Some(vec![CameraName(1)]), ..only(none()) };
    let taken = take(drift).await;
    taken.assert_whole();
    taken.assert_lost([&[], &[]], Outcome::Complete);
    assert!(taken.suspects().is_empty());
}

#[tokio::test]
async fn a_clock_jump_marks_shots_as_suspect_until_the_clock_is_fitted_again() {
    for jump_ns in [37_000_000, -37_000_000, -3_000_000_000] {
        let jump = ClockJump { frame: 90, jump_ns };
        let faults = CameraFaults {
            clock_jumps: vec![jump],
            only: Some(vec![CameraName(1)]),
            ..only(none())
        };
        let taken = take(faults).await;
        taken.assert_whole();
        taken.assert_lost([&[], &[]], Outcome::Complete);
        let suspects = taken.suspects();
        assert_eq!(suspects.first(), Some(&45), "{jump_ns}: {suspects:?}");
        // From the next burst on the clocks are compared anew.
        assert!(suspects.len() < 60 && !suspects.contains(&(SHOTS - 1)), "{jump_ns}: {suspects:?}");
    }
}

#[tokio::test]
async fn all_faults_together_violate_no_invariant() {
    let share = SHARE / 2.0;
    let faults = CameraFaults {
        shares: FrameShares {
            dropped: share,
            late: share,
            reordered: share,
            duplicated: share,
            truncated: share,
            cropped: share,
            corrupted: share,
            missed_trigger: share,
        },
        late_ms: PATIENCE.as_millis() as u64 / 2,
        clock_drift_ppm: 100.0,
        clock_jumps: vec![ClockJump { frame: 140, jump_ns: 31_000_000 }],
        ..CameraFaults::default()
    };
    // The runs mostly wait, so they wait together.
    let runs: Vec<_> =
        (11..19).map(|seed| tokio::spawn(take_with_seed(seed, faults.clone()))).collect();
    for run in runs {
        let taken = run.await.unwrap();
        taken.assert_whole();
        let injected: u64 = taken.records.iter().map(|record| record.count(|_| true)).sum();
        let complete = taken.ledger.accounts()[0].outcomes.of(Outcome::Complete);
        println!("{injected} faults, {complete} of {SHOTS} complete: {:?}", taken.counters());
        assert!(injected > 40, "{injected}");
        assert!((SHOTS / 2..SHOTS).contains(&complete), "{complete}");
    }
}

#[tokio::test]
async fn a_camera_that_is_disconnected_ends_the_run_safely() {
    let faults = CameraFaults {
        disconnect_after: Some(60),
        only: Some(vec![CameraName(1)]),
        ..CameraFaults::default()
    };
    let taken = take(faults).await;
    taken.assert_in_order();
    let error = taken.ended.as_ref().unwrap_err().to_string();
    assert!(error.contains("cam2: connection lost: disconnected on purpose"), "{error}");
}
