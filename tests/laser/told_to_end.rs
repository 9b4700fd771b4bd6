//! A process that is told to exit at once does so when the laser has been read back as safe, or
//! after a time limit.

use std::time::Duration;

use lfpiv::acquisition::SynchroniserThread;

use crate::bench::{Laser, PATIENCE, Plan, Run, timing};

async fn firing(laser: &Laser) -> Run {
    let run = Run::start(laser, Plan::firing(timing(0.0)));
    run.until("pulses in a long burst", || laser.pulses()[1] > 5).await;
    run
}

/// What a second signal waits for, independently of the run loop.
async fn told(run: &Run, limit: Duration) -> Result<(), String> {
    let synchroniser = run.synchroniser.clone();
    let told = tokio::task::spawn_blocking(move || synchroniser.make_safe_within(limit));
    told.await.unwrap().map_err(|error| error.to_string())
}

#[tokio::test(flavor = "multi_thread")]
async fn it_waits_for_the_read_back() {
    let laser = Laser::start();
    let run = firing(&laser).await;
    told(&run, PATIENCE).await.unwrap();
    laser.assert_safe();
    let sent = laser.sent();
    let error = run.end().await.unwrap_err().to_string();
    assert!(error.contains("its thread has ended"), "{error}");
    assert_eq!(laser.sent(), sent, "nothing is sent after the read-back");
}

#[tokio::test(flavor = "multi_thread")]
async fn it_does_not_wait_for_ever_and_says_so() {
    let laser = Laser::start();
    let run = firing(&laser).await;
    let error = told(&run, Duration::from_millis(1)).await.unwrap_err();
    assert!(error.contains("not read back within 0.0 s"), "{error}");
    assert!(error.contains("Use the hardware interlock"), "{error}");
    run.synchroniser.join().await.unwrap();
    laser.assert_safe();
}

#[test]
fn without_a_unit_there_is_nothing_to_wait_for() {
    SynchroniserThread::default().make_safe_within(Duration::ZERO).unwrap();
}
