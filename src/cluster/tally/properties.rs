//! Any reports in any order.

use std::collections::{BTreeMap, BTreeSet};

use proptest::prelude::*;

use super::*;

const SHOTS: u64 = 3;

fn report() -> impl Strategy<Value = (u64, Report)> {
    let attempt = (1..3_u32, 1..14_u32).prop_map(|(issue, delivery)| Attempt { issue, delivery });
    let kind = (0..8_u8, 0..3_u8, attempt);
    // One shot more than there are.
    (0..=SHOTS, kind).prop_map(|(shot, (kind, number, attempt))| {
        let worker = format!("worker {}", attempt.delivery % 4);
        let report = match kind {
            0..5 => Report::Begun { attempt, worker },
            5 => Report::Failed { attempt, worker, reason: "dark".into() },
            6 => Report::Delivered { attempt, worker, result_sha256: number.to_string() },
            _ if number == 0 => Report::Unreadable { reason: "torn".into() },
            _ => Report::Begun { attempt, worker },
        };
        (shot, report)
    })
}

/// The rules in the words of docs/cluster.md, looked up in the whole list of reports.
struct Expected {
    done: BTreeMap<u64, String>,
    dead: BTreeSet<u64>,
    unequal: BTreeSet<u64>,
}

impl Expected {
    fn of(reports: &[(u64, Report)]) -> Self {
        let (mut done, mut dead, mut unequal) = (BTreeMap::new(), BTreeSet::new(), BTreeSet::new());
        for shot in 0..SHOTS {
            let own: Vec<&Report> =
                reports.iter().filter(|(of, _)| *of == shot).map(|(_, report)| report).collect();
            let (mut tried, mut delivered, mut failed) =
                (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
            let mut hashes = Vec::new();
            let mut unreadable = false;
            for report in own {
                match report {
                    Report::Begun { attempt, .. } => drop(tried.insert(*attempt)),
                    Report::Failed { attempt, .. } => drop(failed.insert(*attempt)),
                    Report::Unreadable { .. } => unreadable = true,
                    Report::Delivered { attempt, result_sha256, .. } => {
                        delivered.insert(*attempt);
                        hashes.push(result_sha256.clone());
                    }
                }
            }
            tried.extend(delivered.iter().chain(&failed));
            let failures = failed.difference(&delivered).count();
            let lost = tried.iter().filter(|attempt| {
                let later = |other: &&Attempt| {
                    other.issue == attempt.issue && other.delivery > attempt.delivery
                };
                !failed.contains(attempt)
                    && !delivered.contains(attempt)
                    && tried.iter().any(|other| later(&other))
            });
            let is_dead = unreadable || failures >= 3 || lost.count() >= 10;
            match hashes.first() {
                Some(first) => {
                    done.insert(shot, first.clone());
                    if hashes.iter().any(|hash| hash != first) {
                        unequal.insert(shot);
                    }
                }
                None if is_dead => drop(dead.insert(shot)),
                None => {}
            }
        }
        Self { done, dead, unequal }
    }
}

fn told(reports: &[(u64, Report)]) -> (Tally, Vec<Verdict>) {
    let mut tally = Tally::of(0..SHOTS);
    let verdicts = reports.iter().map(|(shot, report)| tally.take(*shot, report)).collect();
    (tally, verdicts)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn the_first_result_counts_and_tries_are_counted(
        reports in prop::collection::vec(report(), 0..120)
    ) {
        let expected = Expected::of(&reports);
        let (tally, verdicts) = told(&reports);
        let open: BTreeSet<u64> = tally.open().collect();
        let dead: BTreeSet<u64> = tally.dead().into_keys().collect();
        prop_assert_eq!(&dead, &expected.dead);
        prop_assert_eq!(tally.unequal().into_keys().collect::<BTreeSet<_>>(), expected.unequal);
        let mut firsts = BTreeMap::new();
        for ((shot, report), verdict) in reports.iter().zip(&verdicts) {
            if *shot == SHOTS {
                prop_assert_eq!(*verdict, Verdict::Unknown);
                continue;
            }
            let Report::Delivered { result_sha256, .. } = report else {
                prop_assert_eq!(*verdict, Verdict::Noted);
                continue;
            };
            let right = match firsts.get(shot) {
                None => Verdict::First,
                Some(first) if first == result_sha256 => Verdict::Duplicate,
                Some(_) => Verdict::Unequal,
            };
            prop_assert_eq!(*verdict, right);
            firsts.entry(*shot).or_insert_with(|| result_sha256.clone());
        }
        prop_assert_eq!(&firsts, &expected.done);
        // Every shot is in one state.
        for shot in 0..SHOTS {
            let state = tally.state(shot).unwrap();
            prop_assert_eq!(state == ShotState::Open, open.contains(&shot));
            prop_assert_eq!(state == ShotState::Done, firsts.contains_key(&shot));
            prop_assert_eq!(matches!(state, ShotState::Dead(_)), dead.contains(&shot));
        }
        prop_assert_eq!(tally.by_worker().values().sum::<usize>(), firsts.len());
    }

    #[test]
    fn any_order_and_any_repetition_lead_to_the_same_states(
        (reports, other) in prop::collection::vec(report(), 0..120)
            .prop_flat_map(|reports| {
                let twice = [reports.clone(), reports.clone()].concat();
                (Just(reports), Just(twice).prop_shuffle())
            })
    ) {
        let ((one, _), (two, _)) = (told(&reports), told(&other));
        for shot in 0..SHOTS {
            let kinds = [&one, &two].map(|tally| std::mem::discriminant(&tally.state(shot).unwrap()));
            prop_assert_eq!(kinds[0], kinds[1]);
        }
        prop_assert_eq!(one.unequal().into_keys().collect::<Vec<_>>(), two.unequal().into_keys().collect::<Vec<_>>());
        prop_assert_eq!((one.attempts(), one.lost(), one.last_issue()), (two.attempts(), two.lost(), two.last_issue()));
    }
}

#[test]
fn three_failures_or_ten_lost_workers_give_a_shot_up_with_reasons() {
    let failed = |delivery| Report::Failed {
        attempt: Attempt { issue: 1, delivery },
        worker: format!("w{delivery}"),
        reason: "too dark".into(),
    };
    let mut tally = Tally::of([7]);
    tally.take(7, &failed(1));
    tally.take(7, &failed(1));
    tally.take(7, &failed(2));
    assert_eq!(tally.state(7), Some(ShotState::Open));
    tally.take(7, &failed(3));
    let reasons = ["w1: too dark", "w2: too dark", "w3: too dark"].map(String::from).to_vec();
    assert_eq!(tally.state(7), Some(ShotState::Dead(reasons)));

    let mut tally = Tally::of([7]);
    for delivery in 1..=11 {
        assert_eq!(tally.state(7), Some(ShotState::Open), "{delivery}");
        let attempt = Attempt { issue: 1, delivery };
        tally.take(7, &Report::Begun { attempt, worker: format!("w{delivery}") });
    }
    // The eleventh may still go on.
    let Some(ShotState::Dead(reasons)) = tally.state(7) else { panic!("{:?}", tally.state(7)) };
    assert_eq!((reasons.len(), reasons[0].as_str()), (10, "w1: did not end"));
    // A slow worker that delivers after all.
    let attempt = Attempt { issue: 1, delivery: 4 };
    let result_sha256 = "0".to_owned();
    let delivered = Report::Delivered { attempt, worker: "w4".into(), result_sha256 };
    assert_eq!(tally.take(7, &delivered), Verdict::First);
    assert_eq!(tally.state(7), Some(ShotState::Done));
}
