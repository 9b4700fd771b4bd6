//! Panics of the run loop in every state.

use lfpiv::acquisition::{Command, Mode};

use crate::bench::{Laser, Plan, Run, timing, without_room};

/// Checks that the unit is safe once the owner of the thread has waited for it. The run loop's task
/// is gone by then, so only the thread can still be sending commands.
async fn assert_made_safe(laser: &Laser, run: Run) {
    run.panic().await.join().await.unwrap();
    let sent = laser.sent();
    laser.assert_safe();
    assert_eq!(laser.sent(), sent);
}

#[tokio::test(flavor = "multi_thread")]
async fn while_programming() {
    let laser = Laser::start();
    let run = Run::start(&laser, Plan::firing(timing(0.0)));
    let is_timing = |line: &String| line.starts_with(":PULSE0:PER ");
    run.until("timing", || laser.transcript.sent_lines().iter().any(is_timing)).await;
    assert_made_safe(&laser, run).await;
    assert_eq!(laser.pulses(), [0; 2]);
}

#[tokio::test(flavor = "multi_thread")]
async fn while_arming() {
    let laser = Laser::start();
    let run = Run::start(&laser, Plan::firing(timing(600.0)));
    run.until("lamps", || laser.pulses()[0] > 2).await;
    assert_made_safe(&laser, run).await;
    assert_eq!(laser.pulses()[1], 0);
}

#[tokio::test(flavor = "multi_thread")]
async fn while_held() {
    let folder = tempfile::tempdir().unwrap();
    let (journal, _writer) = without_room(folder.path());
    let laser = Laser::start();
    let run = Run::start(&laser, Plan { journal, ..Plan::armed(timing(0.0)) });
    run.until("lamps", || laser.pulses()[0] > 2).await;
    run.control.request(Command::Start).await.unwrap();
    run.until("the gate", || !run.control.state().held.is_empty()).await;
    assert_eq!(run.control.state().mode, Mode::Firing);
    assert_made_safe(&laser, run).await;
    assert_eq!(laser.pulses()[1], 0);
}

#[tokio::test(flavor = "multi_thread")]
async fn while_firing() {
    let laser = Laser::start();
    let run = Run::start(&laser, Plan::firing(timing(0.0)));
    run.until("pulses in a long burst", || laser.pulses()[1] > 5).await;
    assert_made_safe(&laser, run).await;
}

#[tokio::test(flavor = "multi_thread")]
async fn while_closing() {
    let laser = Laser::start();
    let run = Run::start(&laser, Plan::firing(timing(0.0)));
    run.until("pulses in a long burst", || laser.pulses()[1] > 5).await;
    let before = laser.sent();
    run.stop.cancel();
    let is_off = |line: &String| line.ends_with(":STATE OFF");
    run.until("orders", || laser.transcript.sent_lines()[before..].iter().any(is_off)).await;
    assert_made_safe(&laser, run).await;
}

/// Nobody outside the task owns the thread: the runtime's shutdown waits for it.
#[test]
fn with_the_runtime() {
    let laser = Laser::start();
    let runtime = tokio::runtime::Builder::new_multi_thread().enable_all().build().unwrap();
    runtime.block_on(async {
        let run = Run::start(&laser, Plan::firing(timing(0.0)));
        run.until("pulses in a long burst", || laser.pulses()[1] > 5).await;
    });
    drop(runtime);
    laser.assert_safe();
}
