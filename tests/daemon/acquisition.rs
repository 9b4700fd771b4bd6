//! Acquisition on the simulated bench: bursts, faults, and the end of a run.

use std::{num::NonZeroU64, path::Path, sync::Arc, time::Duration};

use lfpiv::acquisition::{
    AcquisitionError, AcquisitionLinks, AcquisitionReport, AcquisitionSettings, Ledger, Outcome,
    OverloadPolicy, Shot, acquire, shot_queue,
};
use lfpiv_hw::{CameraName, PulseSchedule, TimingSettings};
use parking_lot::Mutex;
use tokio_util::sync::CancellationToken;

use crate::bench::{CallLog, Trick, bench, configuration};

struct Taken {
    ended: Result<AcquisitionReport, AcquisitionError>,
    shots: Vec<Shot>,
    ledger: Ledger,
    calls: CallLog,
}

impl Taken {
    fn outcomes(&self, trigger: u64) -> Vec<Option<Outcome>> {
        self.ledger.entry(trigger).unwrap().cameras.clone()
    }

    fn triggers(&self) -> Vec<u64> {
        self.shots.iter().map(|shot| shot.trigger).collect()
    }

    /// The laser is switched off after the last burst and read back before the cameras are stopped.
    fn assert_safe_end(&self) {
        let calls = self.calls.lock();
        let last_fire = calls.iter().rposition(|call| call.starts_with("fire")).unwrap();
        let after = |name: &str| calls[last_fire..].iter().position(|call| call == name).unwrap();
        let order = [after("make safe"), after("reads back safe"), after("camera stop")];
        assert!(order.is_sorted(), "{calls:?}");
    }
}

pub fn settings(shots: u64, overload: OverloadPolicy) -> AcquisitionSettings {
    AcquisitionSettings {
        schedule: PulseSchedule::plan(&TimingSettings::default(), 100.0, 10.0).unwrap(),
        shots: NonZeroU64::new(shots),
        overload,
        // Longer than a loaded machine needs to render a frame.
        patience: Duration::from_secs(2),
        frame_bytes: 2 * 92 * 92,
    }
}

/// Takes shots and settles every received shot as complete.
async fn take(
    settings: AcquisitionSettings,
    tricks: &[(usize, u64, Trick)],
    queue: usize,
    stop: CancellationToken,
    mut seen: impl FnMut(&Shot),
) -> Taken {
    let (bench, calls) = bench(&configuration(Path::new("unused")), tricks);
    let ledger = Arc::new(Mutex::new(Ledger::new(2)));
    let (sender, mut receiver) = shot_queue(queue);
    let links = AcquisitionLinks::new(ledger.clone(), sender, stop);
    let acquiring = tokio::spawn(acquire(bench, settings, links));
    let mut shots = Vec::new();
    while let Some(shot) = receiver.recv().await {
        ledger.lock().settle_all(shot.trigger, Outcome::Complete).unwrap();
        seen(&shot);
        shots.push(shot);
    }
    let ended = acquiring.await.unwrap();
    let ledger = ledger.lock().clone();
    assert!(ledger.is_balanced());
    assert!(ledger.accounts().iter().all(|account| account.open == 0), "{ledger:?}");
    Taken { ended, shots, ledger, calls }
}

#[tokio::test]
async fn shots_come_in_bounded_bursts_after_a_single_one() {
    let settings = settings(8, OverloadPolicy::Wait);
    let taken = take(settings, &[], 3, CancellationToken::new(), |_| {}).await;
    assert_eq!(taken.triggers(), (0..8).collect::<Vec<_>>());
    assert!(taken.shots.iter().all(|shot| shot.suspect.is_empty() && shot.cameras.len() == 2));
    let ids = |shot: &Shot| shot.cameras.iter().flatten().map(|f| f.frame_id).collect::<Vec<_>>();
    assert_eq!(ids(&taken.shots[3]), [6, 7, 6, 7]);
    assert_eq!(taken.ended.as_ref().unwrap().triggers, 8);
    taken.assert_safe_end();

    let calls = taken.calls.lock().clone();
    assert_eq!(calls[0], "make safe", "the laser is disabled before anything else");
    let bursts: Vec<u64> =
        calls.iter().filter_map(|call| call.strip_prefix("fire ")?.parse().ok()).collect();
    assert_eq!((bursts[0], bursts.iter().sum::<u64>()), (1, 8));
    assert!(bursts.iter().all(|shots| *shots <= 3), "no burst beyond the queue: {bursts:?}");
}

#[tokio::test]
async fn lost_damaged_and_repeated_frames_are_accounted_for() {
    // Triggers 1 to 7; frame ids are twice the trigger numbers.
    let tricks = [(0, 4, Trick::Lose), (1, 7, Trick::Damage), (1, 10, Trick::Repeat)];
    let settings = settings(8, OverloadPolicy::Shed);
    let taken = take(settings, &tricks, 8, CancellationToken::new(), |_| {}).await;
    assert_eq!(taken.triggers(), [0, 1, 4, 5, 6, 7]);
    let expect = |first, second| vec![Some(first), Some(second)];
    assert_eq!(taken.outcomes(2), expect(Outcome::MissingPackets, Outcome::Unpaired));
    assert_eq!(taken.outcomes(3), expect(Outcome::Unpaired, Outcome::MissingPackets));
    assert_eq!(taken.ended.as_ref().unwrap().frames.duplicate, 1);
    taken.assert_safe_end();
}

#[tokio::test]
async fn a_full_queue_sheds_and_the_ledger_records_it() {
    let (bench, _) = bench(&configuration(Path::new("unused")), &[]);
    let ledger = Arc::new(Mutex::new(Ledger::new(2)));
    let (sender, mut receiver) = shot_queue(2);
    let settings = settings(6, OverloadPolicy::Shed);
    // No shot is taken before the end.
    let links = AcquisitionLinks::new(ledger.clone(), sender, CancellationToken::new());
    acquire(bench, settings, links).await.unwrap();
    let queued = [receiver.recv().await.unwrap().trigger, receiver.recv().await.unwrap().trigger];
    assert_eq!(queued, [4, 5], "the oldest are shed");
    let account = ledger.lock().accounts()[0];
    assert_eq!((account.triggers, account.open, account.outcomes.of(Outcome::Shed)), (6, 2, 4));
}

#[tokio::test]
async fn a_lost_camera_ends_the_run_safely() {
    for (trick, words) in [(Trick::Fail, "no heartbeat"), (Trick::Panic, "driver bug")] {
        let settings = settings(50, OverloadPolicy::Shed);
        let taken = take(settings, &[(1, 8, trick)], 50, CancellationToken::new(), |_| {}).await;
        let error = taken.ended.as_ref().unwrap_err().to_string();
        assert!(error.contains("cam2") && error.contains(words), "{error}");
        let calls = taken.calls.lock().clone();
        assert_eq!(calls.iter().filter(|call| *call == "camera stop").count(), 2);
        let made_safe = calls.iter().rposition(|call| call == "make safe").unwrap();
        let after = &calls[made_safe..];
        assert!(after.contains(&"reads back safe".to_owned()), "{calls:?}");
        assert!(!after.iter().any(|call| call.starts_with("fire") || call == "program"));
    }
}

#[tokio::test]
async fn a_lost_line_to_the_synchroniser_is_an_alarm() {
    let settings = settings(50, OverloadPolicy::Shed);
    let tricks = [(0, 6, Trick::CutLine)];
    let taken = take(settings, &tricks, 50, CancellationToken::new(), |_| {}).await;
    let error = taken.ended.unwrap_err().to_string();
    assert!(
        error.starts_with("the laser may still fire") && error.contains("no answer"),
        "{error}"
    );
    assert!(error.contains("Use the hardware interlock. Before that: unit"), "{error}");
    let calls = taken.calls.lock();
    let bursts = calls.iter().filter(|call| call.starts_with("fire")).count();
    assert_eq!(bursts, 2, "no burst after the line was lost");
}

#[tokio::test]
async fn a_silent_camera_ends_the_firing() {
    let tricks: Vec<_> = (0..200).map(|id| (1, id, Trick::Lose)).collect();
    let patience = Duration::from_millis(700);
    let settings = AcquisitionSettings { patience, ..settings(50, OverloadPolicy::Shed) };
    let taken = take(settings, &tricks, 50, CancellationToken::new(), |_| {}).await;
    assert!(matches!(
        taken.ended,
        Err(AcquisitionError::Silent { camera: CameraName(1), triggers: 5 })
    ));
    assert_eq!(taken.ledger.accounts()[1].outcomes.of(Outcome::MissedTrigger), 5);
    assert_eq!(taken.ledger.accounts()[0].outcomes.of(Outcome::Unpaired), 5);
    taken.assert_safe_end();
}

/// Triggers come faster than the driver notices.
#[tokio::test]
async fn a_silent_camera_whose_driver_notices_its_loss_is_waited_for() {
    let settings = settings(30, OverloadPolicy::Wait);
    let tricks = [(1, 6, Trick::Unplug)];
    let taken = take(settings, &tricks, 3, CancellationToken::new(), |_| {}).await;
    let triggers = taken.ended.as_ref().unwrap().triggers;
    assert_eq!(triggers, 30);
    let both = vec![Some(Outcome::Complete); 2];
    assert_eq!(taken.outcomes(2), both);
    assert_ne!(taken.outcomes(3), both);
    assert_eq!(taken.outcomes(29), both);
    taken.assert_safe_end();
}

#[tokio::test]
async fn a_stop_ends_the_burst_and_keeps_received_frames() {
    let stop = CancellationToken::new();
    let settings = settings(50, OverloadPolicy::Shed);
    let told = stop.clone();
    let taken = take(settings, &[], 50, stop, |shot| {
        if shot.trigger == 4 {
            told.cancel();
        }
    })
    .await;
    let triggers = taken.ended.as_ref().unwrap().triggers;
    assert!((5..20).contains(&triggers), "{triggers} triggers");
    assert_eq!(taken.ledger.accounts()[0].outcomes.of(Outcome::Complete), triggers);
    taken.assert_safe_end();
}

/// A burst has fifty triggers; triggers are counted as they are seen.
#[tokio::test]
async fn triggers_are_counted_when_they_are_given_and_never_taken_back() {
    let (bench, _) = bench(&configuration(Path::new("unused")), &[]);
    let ledger = Arc::new(Mutex::new(Ledger::new(2)));
    let (sender, mut receiver) = shot_queue(50);
    let stop = CancellationToken::new();
    let links = AcquisitionLinks::new(ledger.clone(), sender, stop.clone());
    let acquiring = tokio::spawn(acquire(bench, settings(50, OverloadPolicy::Shed), links));
    let mut counted = Vec::new();
    loop {
        counted.push(ledger.lock().accounts()[0].triggers);
        let received = tokio::time::timeout(Duration::from_millis(1), receiver.recv()).await;
        match received {
            Ok(Some(shot)) => {
                ledger.lock().settle_all(shot.trigger, Outcome::Complete).unwrap();
                if shot.trigger == 4 {
                    stop.cancel();
                }
            }
            Ok(None) => break,
            Err(_) => {}
        }
    }
    let given = acquiring.await.unwrap().unwrap().triggers;
    counted.push(ledger.lock().accounts()[0].triggers);
    assert!(counted.is_sorted(), "{counted:?}");
    assert_eq!(counted.last(), Some(&given));
}

/// The line is lost in the middle of a burst: triggers that no device saw may not have been given,
/// and do not count as shed.
#[tokio::test]
async fn triggers_without_evidence_do_not_count_as_shed() {
    let settings = settings(50, OverloadPolicy::Shed);
    let tricks = [(0, 16, Trick::CutLine)];
    let taken = take(settings, &tricks, 50, CancellationToken::new(), |_| {}).await;
    assert!(taken.ended.is_err());
    for account in taken.ledger.accounts() {
        // The cameras were some frames ahead.
        let shed = account.outcomes.of(Outcome::Shed);
        assert!(shed <= 10, "{account:?}");
        assert_eq!(account.triggers, taken.ledger.entries().count() as u64);
    }
}
