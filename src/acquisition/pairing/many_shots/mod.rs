//! Thousands of shots with random faults: checks which frames are paired and how triggers end.

mod bench;
mod camera;

use std::{collections::BTreeSet, time::Duration};

use bench::{Faults, ModelBench};
use camera::FrameTruth;

use crate::acquisition::{Outcome, Shot};

/// Statistics of a run.
#[derive(Debug, Default)]
struct Tally {
    triggers: u64,
    paired: u64,
    /// Shots with frames of different triggers that are marked as suspect.
    mixed_suspect: u64,
    mixed_unmarked: u64,
    /// Correct shots that are marked as suspect.
    right_suspect: u64,
    /// Correct shots under a wrong number. This happens where no camera saw the first trigger of a
    /// burst, since only the host's clock distinguishes it from the last one.
    misnumbered: u64,
    outcomes: [u64; Outcome::ALL.len()],
    withdrawn: u64,
    restarts: u64,
    duplicate: u64,
    stray: u64,
}

impl Tally {
    fn add(&mut self, bench: &ModelBench) {
        self.triggers += bench.given;
        self.withdrawn += bench.withdrawn;
        self.restarts += bench.restarts;
        self.duplicate += bench.pairing.counters().duplicate;
        self.stray += bench.pairing.counters().stray;
        for account in bench.ledger.accounts() {
            for (sum, outcome) in self.outcomes.iter_mut().zip(Outcome::ALL) {
                *sum += account.outcomes.of(outcome);
            }
        }
        bench.shots.iter().for_each(|shot| self.add_shot(shot, &bench.begun_unseen));
    }

    fn add_shot(&mut self, shot: &Shot, begun_unseen: &BTreeSet<u64>) {
        let truths = truths(shot);
        let mixed = truths.iter().any(|truth| truth.trigger != truths[0].trigger);
        let suspect = !shot.suspect.is_empty();
        self.paired += 1;
        self.mixed_suspect += u64::from(mixed && suspect);
        self.mixed_unmarked += u64::from(mixed && !suspect);
        self.right_suspect += u64::from(!mixed && suspect);
        let misnumbered = !mixed && truths[0].trigger != shot.trigger;
        assert!(!misnumbered || suspect || begun_unseen.contains(&truths[0].trigger), "{shot:?}");
        self.misnumbered += u64::from(misnumbered);
    }

    fn share(&self, of: u64) -> f64 {
        of as f64 / self.paired as f64
    }
}

/// The true identity of a shot's frames, camera by camera, a before b.
fn truths(shot: &Shot) -> Vec<FrameTruth> {
    let frames = shot.cameras.iter().flatten();
    frames.map(|frame| FrameTruth::of_count(frame.image.counts()[0])).collect()
}

/// A run of at least `triggers` triggers, with all accounting rules checked.
fn run(seed: u64, faults: Faults, triggers: u64) -> ModelBench {
    let mut bench = ModelBench::new(seed, faults);
    while bench.given < triggers {
        bench.random_burst();
    }
    bench.advance(bench.now + Duration::from_secs(10));
    bench.finish();
    for account in bench.ledger.accounts() {
        assert_eq!(
            (account.open, account.triggers),
            (0, bench.given),
            "one outcome for each trigger"
        );
    }
    let ends = bench.ledger.entries().map(|entry| entry.cameras.iter().flatten().count());
    assert_eq!(ends.sum::<usize>() as u64, 2 * bench.given);
    let counted = bench.pairing.counters();
    assert_eq!(bench.pairing.held_frames(), 0);
    assert_eq!(counted.paired, 4 * bench.shots.len() as u64);
    assert_frames_are_used_once(&bench.shots);
    bench
}

fn assert_frames_are_used_once(shots: &[Shot]) {
    let mut used = BTreeSet::new();
    for shot in shots {
        assert_eq!(shot.residuals_ns.len(), shot.cameras.len());
        for (index, truth) in truths(shot).into_iter().enumerate() {
            assert_eq!(truth.camera, index / 2, "{shot:?}");
            assert!(truth.half == index % 2 || !shot.suspect.is_empty(), "{shot:?}");
            assert!(used.insert(truth), "{truth:?} is in two shots");
        }
    }
}

#[test]
fn no_wrong_pair_in_ten_thousand_shots_with_faults() {
    let mut all = Tally::default();
    // Upper bounds for the shares of correct and of wrong shots that are suspect.
    let severities =
        [(0.003, 0.003, 0.005, 0.0005), (0.01, 0.01, 0.02, 0.002), (0.04, 0.03, 0.04, 0.008)];
    for (share, burst_share, most_suspect, most_mixed) in severities {
        let faults = Faults { share, overtaking: 0.1, burst_share };
        let mut tally = Tally::default();
        for seed in 0..3 {
            let bench = run(100 + seed, faults, 2500);
            tally.add(&bench);
            all.add(&bench);
        }
        let right_suspect = tally.share(tally.right_suspect);
        println!("each fault in {share} of frames and triggers, {burst_share} of bursts:");
        println!("  correct but suspect: {right_suspect:.4}; {tally:?}");
        assert_eq!(tally.mixed_unmarked, 0);
        assert!(right_suspect < most_suspect, "{tally:?}");
        assert!(tally.share(tally.mixed_suspect) < most_mixed, "{tally:?}");
    }
    assert!(all.triggers >= 20_000 && all.paired > 10_000, "{all:?}");
    assert!(all.restarts > 20 && all.withdrawn > 20 && all.duplicate > 100, "{all:?}");
    for (outcome, count) in Outcome::ALL.iter().zip(all.outcomes) {
        // Outcomes of processing, and of a synchroniser that cannot be asked.
        let of_others = matches!(outcome, Outcome::Shed | Outcome::WriteFailed | Outcome::NotFired);
        assert_eq!(count == 0, of_others, "{outcome:?}: {count}");
    }
}

#[test]
fn without_faults_every_shot_is_paired_and_none_suspect() {
    for seed in 0..4 {
        let bench = run(seed, Faults::NONE, 1000);
        assert_eq!(bench.shots.len() as u64, bench.given);
        for shot in &bench.shots {
            assert!(shot.suspect.is_empty(), "{:?}", shot.suspect);
            let truths = truths(shot);
            assert!(truths.iter().all(|truth| truth.trigger == shot.trigger), "{shot:?}");
        }
    }
}

/// Two clocks that differ by 200 ppm drift apart by a whole period in 500 s.
#[test]
fn after_a_long_pause_a_drift_is_no_missed_trigger() {
    for shots_before in [0, 1, 30] {
        let mut bench = ModelBench::new(7, Faults::NONE);
        bench.cameras[0].set_clock(1e-4, 1000);
        bench.cameras[1].set_clock(-1e-4, 1000);
        bench.burst(1, 1, None);
        if shots_before > 0 {
            bench.burst(shots_before, shots_before, None);
        }
        bench.advance(bench.now + Duration::from_secs(500));
        let known = bench.pairing.has_reference(bench.now);
        assert_eq!(known, shots_before == 30, "rates are known only after shots");
        if !known {
            bench.burst(1, 1, None);
        }
        bench.burst(10, 10, None);
        assert_eq!(bench.shots.len() as u64, bench.given);
        for shot in &bench.shots {
            assert!(shot.suspect.is_empty(), "{:?}", shot.suspect);
            assert!(truths(shot).iter().all(|truth| truth.trigger == shot.trigger), "{shot:?}");
        }
    }
}

#[test]
fn residuals_are_as_small_as_the_timestamps_are_exact() {
    let bench = run(3, Faults::NONE, 1000);
    for camera in 0..2 {
        let mut sizes: Vec<u64> =
            bench.shots.iter().map(|shot| shot.residuals_ns[camera].unsigned_abs()).collect();
        sizes.sort_unstable();
        let (median, most) = (sizes[sizes.len() / 2], sizes[sizes.len() * 99 / 100]);
        println!("camera {camera}: residuals of {median} ns, 99 % below {most} ns");
        assert!(median > 0 && median < 4000 && most < 50_000, "{median} {most}");
    }
}
