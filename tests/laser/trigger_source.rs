//! A trigger source that becomes too fast, while idle or firing. The reaction time is tested with
//! the driver in simulated time; here only the reaction itself.

use lfpiv::acquisition::{Command, OverloadPolicy};

use crate::bench::{Laser, Plan, Run, external, without_room};

const WITHIN_WHAT_IS_DECLARED: Option<f64> = Some(18.0);
const TOO_FAST: Option<f64> = Some(60.0);

fn laser() -> Laser {
    let laser = Laser::start();
    laser.served.unit().trigger_input(WITHIN_WHAT_IS_DECLARED);
    laser
}

async fn assert_seen(laser: &Laser, run: Run) {
    laser.served.unit().trigger_input(TOO_FAST);
    let begun = std::time::Instant::now();
    let error = run.end().await.unwrap_err().to_string();
    println!("the run ended {:.2} s later: {error}", begun.elapsed().as_secs_f64());
    assert!(error.contains("at most 20 per second, as declared"), "{error}");
    laser.assert_safe();
}

#[tokio::test(flavor = "multi_thread")]
async fn while_armed() {
    let laser = laser();
    let run = Run::start(&laser, Plan::armed(external(0.0)));
    run.until("lamps", || laser.pulses()[0] > 60).await;
    assert_seen(&laser, run).await;
    assert_eq!(laser.pulses()[1], 0);
}

#[tokio::test(flavor = "multi_thread")]
async fn while_lamps_warm_up() {
    let laser = laser();
    let run = Run::start(&laser, Plan::firing(external(600.0)));
    run.until("lamps", || laser.pulses()[0] > 60).await;
    assert_seen(&laser, run).await;
    assert_eq!(laser.pulses()[1], 0);
}

#[tokio::test(flavor = "multi_thread")]
async fn while_held_by_the_disk() {
    let folder = tempfile::tempdir().unwrap();
    let (journal, _writer) = without_room(folder.path());
    let laser = laser();
    let run = Run::start(&laser, Plan { journal, ..Plan::armed(external(0.0)) });
    run.until("lamps", || laser.pulses()[0] > 2).await;
    run.control.request(Command::Start).await.unwrap();
    run.until("the gate", || !run.control.state().held.is_empty()).await;
    assert_seen(&laser, run).await;
    assert_eq!(laser.pulses()[1], 0);
}

/// Shots are not taken from the queue, whose capacity is two.
#[tokio::test(flavor = "multi_thread")]
async fn between_bursts() {
    let laser = laser();
    let plan = Plan { overload: OverloadPolicy::Wait, ..Plan::firing(external(0.0)) };
    let run = Run::start(&laser, plan);
    run.until("two shots", || laser.pulses()[1] == 2).await;
    let lamps = laser.pulses()[0];
    run.until("lamps", || laser.pulses()[0] > lamps + 60).await;
    assert_seen(&laser, run).await;
    assert_eq!(laser.pulses()[1], 2);
}

#[tokio::test(flavor = "multi_thread")]
async fn while_firing() {
    let laser = laser();
    let run = Run::start(&laser, Plan::firing(external(0.0)));
    run.until("pulses in a long burst", || laser.pulses()[1] > 5).await;
    assert_seen(&laser, run).await;
}
