//! The conservation law under random sequences of transitions, valid or not, compared with a model
//! that counts naively.

use std::collections::{BTreeMap, BTreeSet};

use proptest::{
    prelude::*,
    test_runner::{Config, RngAlgorithm, TestRng, TestRunner},
};

use super::*;

const CAMERAS: usize = 2;

#[derive(Debug, Clone)]
enum Transition {
    Enter(u64),
    Queue(u64, bool),
    Settle(u64, usize, Outcome),
    SettleAll(u64, Outcome),
}

/// Few triggers, so that most transitions interact; one camera that does not exist.
fn transition() -> impl Strategy<Value = Transition> {
    let trigger = 0_u64..12;
    let outcome = prop::sample::select(Outcome::ALL.to_vec());
    prop_oneof![
        3 => trigger.clone().prop_map(Transition::Enter),
        1 => (trigger.clone(), any::<bool>()).prop_map(|(t, odd)| Transition::Queue(t, odd)),
        4 => (trigger.clone(), 0..=CAMERAS, outcome.clone())
            .prop_map(|(t, camera, outcome)| Transition::Settle(t, camera, outcome)),
        1 => (trigger, outcome).prop_map(|(t, outcome)| Transition::SettleAll(t, outcome)),
    ]
}

/// The expected state: the outcome of each entered trigger and camera.
type Model = BTreeMap<u64, [Option<Outcome>; CAMERAS]>;

/// Applies a transition to the model; `false` if it is not allowed.
fn model_allows(model: &mut Model, transition: &Transition) -> bool {
    match *transition {
        Transition::Enter(trigger) => {
            let new = !model.contains_key(&trigger);
            model.entry(trigger).or_default();
            new
        }
        Transition::Queue(..) => true,
        Transition::Settle(trigger, camera, outcome) => {
            match model.get_mut(&trigger).and_then(|cameras| cameras.get_mut(camera)) {
                Some(slot @ None) => {
                    *slot = Some(outcome);
                    true
                }
                _ => false,
            }
        }
        Transition::SettleAll(trigger, outcome) => match model.get_mut(&trigger) {
            Some(cameras) if *cameras == [None; CAMERAS] => {
                *cameras = [Some(outcome); CAMERAS];
                true
            }
            _ => false,
        },
    }
}

fn apply(ledger: &mut Ledger, transition: &Transition) -> Result<(), LedgerError> {
    match transition.clone() {
        Transition::Enter(trigger) => ledger.enter(trigger),
        Transition::Queue(trigger, odd) => {
            let suspect = if odd { vec!["odd".to_owned()] } else { Vec::new() };
            ledger.mark_queued(trigger, &suspect);
            Ok(())
        }
        Transition::Settle(trigger, camera, outcome) => ledger.settle(trigger, camera, outcome),
        Transition::SettleAll(trigger, outcome) => ledger.settle_all(trigger, outcome),
    }
}

/// The observable state of a ledger.
fn snapshot(ledger: &Ledger) -> (Vec<Account>, Vec<TriggerEntry>) {
    (ledger.accounts().to_vec(), ledger.entries().cloned().collect())
}

fn agrees(ledger: &Ledger, model: &Model) -> Result<(), TestCaseError> {
    let entered: BTreeSet<u64> = ledger.entries().map(|entry| entry.trigger).collect();
    prop_assert!(entered.iter().eq(model.keys()));
    for (camera, account) in ledger.accounts().iter().enumerate() {
        let ends: Vec<Option<Outcome>> = model.values().map(|cameras| cameras[camera]).collect();
        prop_assert_eq!(account.triggers, ends.len() as u64);
        prop_assert_eq!(account.open, ends.iter().filter(|end| end.is_none()).count() as u64);
        for outcome in Outcome::ALL {
            let count = ends.iter().filter(|end| **end == Some(outcome)).count() as u64;
            prop_assert_eq!(account.outcomes.of(outcome), count);
        }
    }
    let open = model.values().filter(|cameras| cameras.contains(&None)).count() as u64;
    prop_assert_eq!(ledger.in_pool() + ledger.awaiting_frames(), open);
    Ok(())
}

/// After every transition the law holds and the sums match the model; a refused transition changes
/// nothing.
#[test]
fn conservation_holds_after_every_transition() {
    let config = Config { cases: 3000, failure_persistence: None, ..Config::default() };
    let random = TestRng::from_seed(RngAlgorithm::ChaCha, &[7; 32]);
    let transitions = prop::collection::vec(transition(), 1..80);
    let tested = TestRunner::new_with_rng(config, random).run(&transitions, |transitions| {
        let (mut ledger, mut model) = (Ledger::new(CAMERAS), Model::new());
        for transition in transitions {
            let before = snapshot(&ledger);
            let done = apply(&mut ledger, &transition);
            for (account, before) in ledger.accounts().iter().zip(&before.0) {
                prop_assert!(account.triggers >= before.triggers, "no count falls");
            }
            prop_assert_eq!(done.is_ok(), model_allows(&mut model, &transition));
            prop_assert!(ledger.is_balanced());
            if done.is_err() {
                prop_assert_eq!(snapshot(&ledger), before);
            }
            agrees(&ledger, &model)?;
        }
        Ok(())
    });
    tested.unwrap();
}
