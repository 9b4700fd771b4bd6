//! A synchroniser that is lost and comes back: the run survives it, and nothing is fired until an
//! operator or the configuration permits it.

use std::time::Duration;

use lfpiv::acquisition::{Command, Mode, Outcome};

use crate::bench::{AfterLoss, Laser, PATIENCE, Plan, QUEUE, Run, timing};

const WAIT: AfterLoss = AfterLoss { waits_for_operator: true, patience: None };
const GO_ON: AfterLoss = AfterLoss { waits_for_operator: false, patience: None };

/// A run in the middle of a long burst.
async fn firing(laser: &Laser, after_loss: AfterLoss) -> Run {
    let plan = Plan { after_loss: Some(after_loss), ..Plan::firing(timing(0.0)) };
    let run = Run::start(laser, plan);
    run.until("pulses in a long burst", || laser.pulses()[1] > 5).await;
    run
}

/// A run whose line is unplugged, detected by a stop request.
async fn pulled(laser: &Laser, after_loss: AfterLoss) -> Run {
    let run = firing(laser, after_loss).await;
    laser.pull_line();
    let refusal = run.control.request(Command::Stop).await.unwrap_err();
    assert!(refusal.reasons[0].contains("Use the hardware interlock"), "{refusal:?}");
    run
}

/// A run whose unit was found to be lost at the end of its burst, and has given all its triggers.
async fn lost(laser: &Laser, after_loss: AfterLoss) -> Run {
    let run = firing(laser, after_loss).await;
    laser.pull_line();
    is_lost(laser, &run).await;
    run
}

/// Waits for the loss and for the end of the burst, after which only the lamps go on. On a busy machine
/// the run may find the unit lost while it still fires. A unit that is found again is made safe, and
/// triggers that it then omits are waited for as long as frames may be late.
async fn is_lost(laser: &Laser, run: &Run) {
    run.until("the loss", || run.control.state().mode == Mode::Lost).await;
    loop {
        let [lamp, q_switch] = laser.pulses();
        run.until("pulses of the lamp", || laser.pulses()[0] >= lamp + 5).await;
        if laser.pulses()[1] == q_switch {
            return;
        }
    }
}

/// A run whose bench is back and that waits for an operator.
async fn waiting(laser: &Laser) -> Run {
    let run = lost(laser, WAIT).await;
    laser.plug_in_line();
    run.until("the return", || run.control.state().mode == Mode::Disarmed).await;
    run
}

async fn resumes_and_stops(laser: &Laser, run: Run) {
    let before = laser.pulses()[1];
    run.until("pulses", || laser.pulses()[1] > before + 5).await;
    run.stop.cancel();
    let ledger = run.ledger.clone();
    run.end().await.unwrap();
    laser.assert_safe();
    let ledger = ledger.lock();
    assert!(ledger.is_balanced());
    for account in ledger.accounts() {
        // Only the line was lost: cameras saw every trigger. Nobody takes shots from the queue.
        let shed = account.outcomes.of(Outcome::Shed);
        assert_eq!(account.triggers, shed + account.open, "{account:?}");
        assert!(account.open <= QUEUE as u64, "{account:?}");
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_unit_that_was_silent_fires_once_an_operator_says_so() {
    let laser = Laser::start();
    let run = firing(&laser, WAIT).await;
    assert!(
        run.control.request(Command::Resume).await.is_err(),
        "it is not waiting for an operator"
    );
    laser.served.unit().silence_after(0);
    is_lost(&laser, &run).await;
    assert!(run.control.state().held[0].contains("searching for it"), "{:?}", run.control.state());
    for command in [Command::Start, Command::Arm, Command::Resume] {
        assert!(run.control.request(command).await.is_err(), "there is no unit to fire");
    }
    laser.served.unit().end_silence();
    run.until("the return", || run.control.state().mode == Mode::Disarmed).await;
    let held = run.control.state().held.join("; ");
    assert!(held.contains("kill -USR1"), "{held}");
    let before = laser.pulses();
    tokio::time::sleep(Duration::from_secs(1)).await;
    assert_eq!(laser.pulses(), before, "neither lamps nor Q-switches");
    run.control.request(Command::Resume).await.unwrap();
    resumes_and_stops(&laser, run).await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_run_resumes_where_permitted_after_its_line_is_plugged_in_again() {
    let laser = Laser::start();
    let run = lost(&laser, GO_ON).await;
    laser.plug_in_line();
    run.until("the return", || run.control.state().mode == Mode::Firing).await;
    resumes_and_stops(&laser, run).await;
}

#[tokio::test(flavor = "multi_thread")]
async fn a_run_that_is_disarmed_while_its_unit_is_lost_stays_disarmed() {
    let laser = Laser::start();
    let run = lost(&laser, GO_ON).await;
    let refusal = run.control.request(Command::Disarm).await.unwrap_err();
    assert!(refusal.reasons[0].contains("use the hardware interlock"), "{refusal:?}");
    laser.plug_in_line();
    run.until("the return", || run.control.state().mode == Mode::Disarmed).await;
    assert_eq!(run.control.state().held, Vec::<String>::new());
    assert!(run.control.request(Command::Resume).await.is_err());
    let before = laser.pulses();
    tokio::time::sleep(Duration::from_secs(1)).await;
    assert_eq!(laser.pulses(), before);
    run.stop.cancel();
    run.end().await.unwrap();
    laser.assert_safe();
}

#[tokio::test(flavor = "multi_thread")]
async fn a_run_that_is_stopped_without_its_unit_says_that_its_state_is_unknown() {
    let laser = Laser::start();
    let run = pulled(&laser, WAIT).await;
    run.stop.cancel();
    let error = run.end().await.unwrap_err().to_string();
    assert!(error.contains("Use the hardware interlock"), "{error}");
}

#[tokio::test(flavor = "multi_thread")]
async fn a_process_terminated_without_its_unit_reports_it() {
    let laser = Laser::start();
    let run = pulled(&laser, WAIT).await;
    let synchroniser = run.synchroniser.clone();
    let told = tokio::task::spawn_blocking(move || synchroniser.make_safe_within(PATIENCE));
    let error = told.await.unwrap().unwrap_err().to_string();
    assert!(error.contains("Use the hardware interlock"), "{error}");
    assert!(run.end().await.is_err());
}

#[tokio::test(flavor = "multi_thread")]
async fn a_unit_that_does_not_come_back_in_time_ends_the_run() {
    let laser = Laser::start();
    let patience = Some(Duration::ZERO);
    let run = pulled(&laser, AfterLoss { patience, ..WAIT }).await;
    let error = run.end().await.unwrap_err().to_string();
    assert!(error.contains("did not come back within 0 s"), "{error}");
    assert!(error.contains("Use the hardware interlock"), "{error}");
}

#[tokio::test(flavor = "multi_thread")]
async fn a_run_loop_that_panics_while_an_operator_is_waited_for_leaves_the_laser_safe() {
    let laser = Laser::start();
    let run = waiting(&laser).await;
    run.panic().await.join().await.unwrap();
    laser.assert_safe();
}

#[tokio::test(flavor = "multi_thread")]
async fn a_run_that_is_stopped_while_an_operator_is_waited_for_ends_well() {
    let laser = Laser::start();
    let run = waiting(&laser).await;
    run.stop.cancel();
    run.end().await.unwrap();
    laser.assert_safe();
}
