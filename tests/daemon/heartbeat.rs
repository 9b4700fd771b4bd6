//! The run loop's heartbeat continues while it waits, but not while it hangs.

use std::{
    path::Path,
    sync::Arc,
    time::{Duration, Instant},
};

use lfpiv::acquisition::{
    AcquisitionLinks, Bench, Heartbeat, Ledger, Outcome, OverloadPolicy, acquire, shot_queue,
};
use lfpiv_hw::{
    PulseSchedule,
    device::{DeviceError, Synchroniser, SynchroniserState},
};
use parking_lot::Mutex;
use tokio_util::sync::CancellationToken;

use crate::{
    acquisition::settings,
    bench::{bench, configuration},
};

/// A unit whose lamps warm up slowly, or whose line answers `fire` slowly.
struct SlowUnit {
    inner: Box<dyn Synchroniser>,
    warm_up: Duration,
    hangs: Duration,
}

impl Synchroniser for SlowUnit {
    fn identify(&mut self) -> Result<String, DeviceError> {
        self.inner.identify()
    }

    fn program(&mut self, schedule: &PulseSchedule) -> Result<(), DeviceError> {
        self.inner.program(schedule)
    }

    fn arm(&mut self) -> Result<Duration, DeviceError> {
        self.inner.arm()?;
        Ok(std::mem::take(&mut self.warm_up))
    }

    fn fire(&mut self, shots: u64) -> Result<(), DeviceError> {
        std::thread::sleep(std::mem::take(&mut self.hangs));
        self.inner.fire(shots)
    }

    fn trigger_count(&mut self) -> Result<Option<u64>, DeviceError> {
        self.inner.trigger_count()
    }

    fn state(&mut self) -> Result<SynchroniserState, DeviceError> {
        self.inner.state()
    }

    fn make_safe(&mut self) -> Result<(), DeviceError> {
        self.inner.make_safe()
    }
}

/// The longest silence of a run of three shots; the pool takes the first shot after `pool`.
async fn longest_silence(warm_up: Duration, pool: Duration, hangs: Duration) -> Duration {
    let (Bench { cameras, synchroniser, .. }, _) = bench(&configuration(Path::new("unused")), &[]);
    let unit = SlowUnit { inner: synchroniser, warm_up, hangs };
    let bench = Bench::new(cameras, Box::new(unit));
    let settings = settings(3, OverloadPolicy::Wait);
    let ledger = Arc::new(Mutex::new(Ledger::new(2)));
    let (sender, mut receiver) = shot_queue(1);
    let links = AcquisitionLinks::new(ledger.clone(), sender, CancellationToken::new());
    let heartbeat: Heartbeat = links.heartbeat.clone();
    let acquiring = tokio::spawn(acquire(bench, settings, links));
    let taking = tokio::spawn(async move {
        tokio::time::sleep(pool).await;
        while let Some(shot) = receiver.recv().await {
            ledger.lock().settle_all(shot.trigger, Outcome::Complete).unwrap();
        }
    });
    let mut longest = Duration::ZERO;
    while !acquiring.is_finished() {
        longest = longest.max(heartbeat.silent_for(Instant::now()));
        tokio::time::sleep(Duration::from_millis(10)).await;
    }
    acquiring.await.unwrap().unwrap();
    taking.await.unwrap();
    assert!(heartbeat.has_begun());
    let later = Instant::now() + Duration::from_secs(60);
    assert_eq!(heartbeat.silent_for(later), Duration::ZERO, "it rests in the end");
    longest
}

const LONG: Duration = Duration::from_secs(3);
/// Far longer than a loop iteration, far shorter than the waits.
const SILENCE: Duration = Duration::from_millis(1500);

#[tokio::test]
async fn the_heartbeat_continues_while_waiting_for_lamps() {
    let silence = longest_silence(LONG, Duration::ZERO, Duration::ZERO).await;
    assert!(silence < SILENCE, "{silence:?}");
}

#[tokio::test]
async fn the_heartbeat_continues_while_waiting_for_the_pool() {
    let silence = longest_silence(Duration::ZERO, LONG, Duration::ZERO).await;
    assert!(silence < SILENCE, "{silence:?}");
}

#[tokio::test]
async fn the_heartbeat_stops_while_the_line_does_not_answer() {
    let silence = longest_silence(Duration::ZERO, Duration::ZERO, LONG).await;
    assert!(silence > SILENCE, "{silence:?}");
}
