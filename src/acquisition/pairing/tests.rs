//! Pairing of frames that are lost, damaged, duplicated or delayed, with missed triggers.

mod rig;

use proptest::prelude::*;

use super::*;
use rig::*;

fn fate() -> impl Strategy<Value = Fate> {
    prop_oneof![
        6 => Just(Fate::Delivered),
        1 => Just(Fate::Missed),
        1 => Just(Fate::LostFirst),
        1 => Just(Fate::LostSecond),
        1 => Just(Fate::LostBoth),
        1 => Just(Fate::Damaged),
        1 => Just(Fate::Repeated),
        1 => Just(Fate::Delayed),
    ]
}

/// Fates and jitter of each shot, and the number of triggers not given.
type BurstPlan = (Vec<(Vec<Fate>, Vec<u64>)>, usize);

/// One jump of a camera's clock: before which burst, of which camera, by how much. Jumps that add up
/// to whole periods are excluded: they cannot be distinguished from missed triggers.
fn jump() -> impl Strategy<Value = (usize, usize, i64)> {
    let periods = (-30_i64..30, 20_i64..80)
        .prop_map(|(whole, parts)| (100 * whole + parts) * PERIOD_NS as i64 / 100);
    (0_usize..12, 0_usize..2, periods)
}

fn burst_plan() -> impl Strategy<Value = BurstPlan> {
    let shot = (prop::collection::vec(fate(), 2), prop::collection::vec(0_u64..150, 2));
    let cut = prop_oneof![4 => Just(0_usize), 1 => 1_usize..3];
    (prop::collection::vec(shot, 1..7), cut)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// Whatever the cameras do: the sums match, and a shot that mixes two triggers is suspect.
    #[test]
    fn every_trigger_ends_once_and_no_shot_mixes_triggers_unmarked(
        plans in prop::collection::vec(burst_plan(), 1..8),
        (jump_at, camera, jump_ns) in jump(),
    ) {
        let mut rig = Rig::new(2);
        let mut none_missed = true;
        for (burst, (shots, cut)) in plans.into_iter().enumerate() {
            if burst == jump_at {
                rig.jumped_ns[camera] = jump_ns;
            }
            // As the daemon: single shots until the clock differences are known.
            let (length, cut) = if rig.pairing.has_reference(rig.now) { (shots.len(), cut) } else { (1, 0) };
            let (fates, jitter): (Vec<_>, Vec<_>) = shots.into_iter().take(length).unzip();
            none_missed &= fates.iter().flatten().all(|fate| *fate != Fate::Missed);
            rig.burst(&fates, &jitter, cut);
        }
        for account in rig.ledger.accounts() {
            prop_assert_eq!(account.open, 0);
            prop_assert_eq!(account.triggers, rig.given);
        }
        for shot in &rig.shots {
            let triggers = Rig::true_triggers(shot);
            let mixed = triggers.iter().any(|t| *t != triggers[0]);
            prop_assert!(!mixed || !shot.suspect.is_empty(), "{:?}", shot);
            prop_assert!(!none_missed || triggers[0] == shot.trigger);
        }
    }
}

#[test]
fn outcomes_match_the_faults() {
    let mut rig = Rig::new(2);
    let plan = [
        (Fate::Delivered, Fate::Delivered),
        (Fate::Damaged, Fate::Delivered),
        (Fate::Delivered, Fate::LostBoth),
        (Fate::Missed, Fate::Delivered),
        (Fate::Delivered, Fate::LostSecond),
        (Fate::Delivered, Fate::Delayed),
        (Fate::Repeated, Fate::Delivered),
    ];
    for (index, (one, two)) in plan.into_iter().enumerate() {
        if index == 0 {
            rig.burst(&[vec![one, two]], &[vec![1, 2]], 0);
            continue;
        }
        // A good shot on either side shows that the stream continued.
        let good = vec![Fate::Delivered; 2];
        rig.burst(&[good.clone(), vec![one, two], good], &vec![vec![1, 2]; 3], 0);
    }
    let outcomes: Vec<_> = [0, 2, 5, 8, 11, 14, 17]
        .map(|trigger| rig.ledger.entry(trigger).unwrap().cameras.clone())
        .into_iter()
        .map(|cameras| (cameras[0].unwrap(), cameras[1].unwrap()))
        .collect();
    use Outcome::*;
    let expected = [
        (Complete, Complete),
        (MissingPackets, Unpaired),
        (Unpaired, MissingPackets),
        (MissedTrigger, Unpaired),
        (Unpaired, MissingPackets),
        (Unpaired, Late),
        (Complete, Complete),
    ];
    assert_eq!(outcomes, expected);
    assert_eq!(rig.pairing.counters().duplicate, 1);
    assert_eq!(rig.shots.len(), 1 + 2 * 6 + 1);
}

#[test]
fn the_other_camera_shows_a_trigger_missed_at_the_start_of_a_burst() {
    let mut rig = Rig::new(2);
    let good = vec![Fate::Delivered; 2];
    rig.burst(std::slice::from_ref(&good), &[vec![0, 0]], 0);
    let plan = [vec![Fate::Missed, Fate::Delivered], good.clone(), good];
    rig.burst(&plan, &vec![vec![3, 1]; 3], 0);
    let paired: Vec<u64> = rig.shots.iter().map(|shot| shot.trigger).collect();
    assert_eq!(paired, [0, 2, 3]);
    for shot in &rig.shots {
        assert_eq!(Rig::true_triggers(shot), [shot.trigger; 4]);
    }
    let missed = rig.ledger.entry(1).unwrap();
    assert_eq!(missed.cameras, [Some(Outcome::MissedTrigger), Some(Outcome::Unpaired)]);
}

#[test]
fn underruns_reported_by_the_stream_are_charged_to_lost_frames() {
    let mut rig = Rig::new(1);
    rig.fire(2);
    rig.pairing.underruns(0, 2);
    let late = Duration::from_millis(100);
    for id in [2, 3] {
        let at = 1_000_000_000 + PERIOD_NS + (id - 2) * INTERVAL_NS;
        let decisions = rig.pairing.frame(0, frame(id, at, 1), late);
        rig.apply(decisions);
    }
    let decisions = rig.pairing.finish();
    rig.apply(decisions);
    assert_eq!(rig.ledger.entry(0).unwrap().cameras, [Some(Outcome::Underrun)]);
    assert_eq!(rig.ledger.entry(1).unwrap().cameras, [Some(Outcome::Complete)]);
}

#[test]
fn the_end_of_a_run_sheds_pending_triggers() {
    let mut rig = Rig::new(1);
    rig.fire(2);
    let decisions = rig.pairing.frame(0, frame(0, 0, 0), Duration::ZERO);
    rig.apply(decisions);
    let decisions = rig.pairing.finish();
    rig.apply(decisions);
    // The second trigger was not due yet.
    let account = rig.ledger.accounts()[0];
    assert_eq!((account.triggers, account.outcomes.of(Outcome::Shed)), (1, 1));
    assert_eq!(rig.pairing.open_triggers(), 0);
}

#[test]
fn due_triggers_without_a_frame_are_not_fired() {
    let mut rig = Rig::new(2);
    rig.fire(50);
    for camera in [0, 1] {
        for id in 0..2 {
            let decisions =
                rig.pairing.frame(camera, frame(id, id * INTERVAL_NS, 0), Duration::ZERO);
            rig.apply(decisions);
        }
    }
    assert_eq!(rig.ledger.accounts()[0].triggers, 1, "of fifty, one was given so far");
    // The bench is lost; detection takes some periods.
    let now = Duration::from_nanos(PERIOD_NS * 7 / 2);
    let decisions = rig.pairing.tick(now);
    rig.apply(decisions);
    assert_eq!(rig.pairing.due_by(now), 4);
    let decisions = rig.pairing.finish();
    rig.apply(decisions);
    for account in rig.ledger.accounts() {
        let of = |outcome| account.outcomes.of(outcome);
        assert_eq!((account.triggers, of(Outcome::Complete)), (4, 1));
        assert_eq!((of(Outcome::NotFired), of(Outcome::Shed)), (3, 0));
    }
}

#[test]
fn a_lost_synchroniser_keeps_trigger_numbers_and_accounts_consistent() {
    let mut rig = Rig::new(2);
    rig.fire(10);
    // Trigger 0 is complete; for trigger 1 one camera has sent a frame.
    for (camera, id) in [(0, 0), (0, 1), (1, 0), (1, 1), (0, 2)] {
        let at_ns = PERIOD_NS * (id / 2) + INTERVAL_NS * (id % 2);
        rig.now = Duration::from_nanos(at_ns);
        let decisions = rig.pairing.frame(camera, frame(id, at_ns, id / 2), rig.now);
        rig.apply(decisions);
    }
    rig.wait_until(Duration::from_nanos(PERIOD_NS * 7 / 2));
    let (given, decisions) = rig.pairing.burst_lost();
    rig.apply(decisions);
    // Triggers 2 and 3 were due, 4 to 9 were not.
    assert_eq!((given, rig.pairing.open_triggers()), (4, 1));
    rig.wait_until(rig.now + 4 * PATIENCE);
    assert_eq!(rig.pairing.open_triggers(), 0);
    for (account, of_trigger_1) in
        rig.ledger.accounts().iter().zip([Outcome::MissingPackets, Outcome::MissedTrigger])
    {
        let of = |outcome| account.outcomes.of(outcome);
        assert_eq!((account.triggers, account.open), (4, 0));
        assert_eq!((of(Outcome::Complete), of(Outcome::NotFired), of(of_trigger_1)), (1, 2, 1));
    }
    assert_eq!(rig.fire(5), 4, "the next burst continues the numbering");
}

#[test]
fn a_shot_that_was_not_complete_when_the_laser_was_switched_off_is_suspect() {
    let mut rig = Rig::new(1);
    rig.fire(4);
    let deliver = |rig: &mut Rig, id: u64| {
        let at_ns = PERIOD_NS * (id / 2) + INTERVAL_NS * (id % 2);
        let decisions = rig.pairing.frame(0, frame(id, at_ns, id / 2), Duration::ZERO);
        rig.apply(decisions);
    };
    (0..3).for_each(|id| deliver(&mut rig, id));
    rig.pairing.laser_switched_off();
    (3..6).for_each(|id| deliver(&mut rig, id));
    assert_eq!(suspects(&rig), [1, 2], "shot 0 was complete before");
    assert!(rig.shots[1].suspect[0].contains("switched off"), "{:?}", rig.shots[1].suspect);
    // The next burst is lit again.
    let decisions = rig.pairing.burst_ended(3).unwrap();
    rig.apply(decisions);
    rig.fire(1);
    (6..8).for_each(|id| deliver(&mut rig, id));
    assert_eq!(suspects(&rig), [1, 2]);
}

#[test]
fn a_wrong_interval_makes_a_shot_suspect_and_keeps_it() {
    let mut rig = Rig::new(1);
    rig.fire(1);
    let mut decisions = rig.pairing.frame(0, frame(0, 1_000, 0), Duration::ZERO);
    decisions.extend(rig.pairing.frame(0, frame(1, 5_001_000, 0), Duration::ZERO));
    rig.apply(decisions);
    assert!(rig.shots[0].suspect[0].contains("5000000 ns after frame a"));
}

#[test]
fn a_slow_camera_is_waited_for_as_long_as_it_delivers() {
    let mut rig = Rig::new(1);
    rig.fire(4);
    for id in 0..8 {
        // Each frame arrives just within the patience, long after it was due.
        rig.wait_until(rig.now + PATIENCE * 9 / 10);
        let at = id / 2 * PERIOD_NS + id % 2 * INTERVAL_NS;
        let decisions = rig.pairing.frame(0, frame(id, at, id / 2), rig.now);
        rig.apply(decisions);
    }
    assert_eq!(rig.shots.len(), 4);
}

#[test]
fn more_triggers_than_requested_are_an_error() {
    let mut rig = Rig::new(1);
    rig.fire(2);
    assert_eq!(rig.pairing.burst_ended(3).unwrap_err(), ExtraTriggers { counted: 3, asked: 2 });
}

/// Good shots in bursts of the length that the daemon would fire.
fn good_bursts(rig: &mut Rig, lengths: &[usize]) {
    for length in lengths {
        let length = if rig.pairing.has_reference(rig.now) { *length } else { 1 };
        rig.burst(&vec![vec![Fate::Delivered; 2]; length], &vec![vec![1, 2]; length], 0);
    }
}

fn suspects(rig: &Rig) -> Vec<u64> {
    let suspect = rig.shots.iter().filter(|shot| !shot.suspect.is_empty());
    suspect.map(|shot| shot.trigger).collect()
}

fn assert_all_right(rig: &Rig) {
    for shot in &rig.shots {
        assert_eq!(Rig::true_triggers(shot), [shot.trigger; 4]);
    }
}

#[test]
fn a_camera_that_missed_the_very_first_triggers_is_paired_all_the_same() {
    let mut rig = Rig::new(2);
    for _ in 0..2 {
        rig.burst(&[vec![Fate::Missed, Fate::Delivered]], &[vec![1, 2]], 0);
    }
    good_bursts(&mut rig, &[1, 1, 5]);
    assert_all_right(&rig);
    assert_eq!(rig.shots.len(), 7);
    assert_eq!(suspects(&rig), [2], "the number alone is no proof");
}

#[test]
fn after_a_jump_the_clock_fit_restarts() {
    for jump_ns in [40_000_000, -40_000_000, -5_000_040_000_000] {
        let mut rig = Rig::new(2);
        good_bursts(&mut rig, &[1, 4]);
        rig.jumped_ns[1] = jump_ns;
        good_bursts(&mut rig, &[3, 1, 1, 4]);
        assert_all_right(&rig);
        assert!(rig.pairing.has_reference(rig.now));
        let suspects = suspects(&rig);
        assert!(suspects.starts_with(&[5, 6, 7]), "{jump_ns}: {suspects:?}");
        assert_eq!(rig.shots.iter().filter(|shot| shot.trigger > 9).count(), 4);
        assert!(suspects.iter().all(|trigger| *trigger <= 9), "{jump_ns}: {suspects:?}");
    }
}

#[test]
fn a_camera_that_restarts_and_has_missed_triggers_meanwhile_is_paired_again() {
    let mut rig = Rig::new(2);
    good_bursts(&mut rig, &[1, 4]);
    let away = vec![vec![Fate::Delivered, Fate::Missed]; 3];
    rig.burst(&away, &vec![vec![1, 2]; 3], 0);
    // Its clock starts at zero; its driver continues the numbering.
    rig.jumped_ns[1] = -((2 * CLOCK_NS) as i64);
    good_bursts(&mut rig, &[1, 1, 1, 4]);
    assert_all_right(&rig);
    let paired: Vec<u64> = rig.shots.iter().map(|shot| shot.trigger).collect();
    assert_eq!(paired, [0, 1, 2, 3, 4, 8, 9, 10, 11, 12, 13, 14]);
    assert!(suspects(&rig).starts_with(&[8]) && !suspects(&rig).contains(&11));
}

/// A stream whose first frame a was lost: the driver numbers frame b 0.
#[test]
fn a_stream_that_begins_with_a_frame_b_is_paired_from_the_next_trigger_on() {
    for bursts in [&[1, 1, 1, 3][..], &[6]] {
        let mut rig = Rig::new(1);
        let mut number = 0;
        for shots in bursts {
            let first = rig.fire(*shots);
            let start = rig.now;
            for trigger in first..first + shots {
                rig.wait_until(start + Duration::from_nanos(PERIOD_NS) * (trigger - first) as u32);
                let at_ns = CLOCK_NS + rig.now.as_nanos() as u64;
                for half in (0..2).filter(|half| trigger + half > 0) {
                    let sent = frame(number, at_ns + half * INTERVAL_NS, 2 * trigger + half);
                    let decisions = rig.pairing.frame(0, sent, rig.now);
                    rig.apply(decisions);
                    number += 1;
                }
            }
            rig.given += shots;
            let decisions = rig.pairing.burst_ended(rig.given).unwrap();
            rig.apply(decisions);
            rig.wait_until(rig.now + 4 * PATIENCE);
        }
        let paired: Vec<u64> = rig.shots.iter().map(|shot| shot.trigger).collect();
        assert_eq!(paired, (1..rig.given).collect::<Vec<_>>());
        for shot in &rig.shots {
            assert_eq!(Rig::true_triggers(shot), [2 * shot.trigger, 2 * shot.trigger + 1]);
            assert!(shot.suspect.is_empty(), "{:?}", shot.suspect);
        }
        let lost = rig.ledger.entry(0).unwrap();
        assert_eq!(lost.cameras, [Some(Outcome::MissingPackets)]);
        assert_eq!(rig.pairing.counters().unpaired, 1);
    }
}
