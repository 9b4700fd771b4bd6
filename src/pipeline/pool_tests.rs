//! The pool under panics, failures, full disks and stops.

use std::{
    io,
    sync::atomic::{AtomicUsize, Ordering},
    time::Duration,
};

use lfpiv_hw::{
    RawImage,
    device::{Frame, FrameStatus},
};

use super::*;
use crate::{
    acquisition::{HostClock, Ledger, shot_queue},
    pipeline::{Lookup, RESULTS_IN_MEMORY, ShotRecord, Stage, test_data::result},
};

/// Stores shot numbers; returns an error at shot 2 and panics at shot 7.
#[derive(Clone, Default)]
struct TestSink {
    kept: Arc<Mutex<Vec<u64>>>,
    closed: Arc<AtomicUsize>,
}

impl ResultSink for TestSink {
    type Error = io::Error;

    fn append(&mut self, shot: u64, _: &ShotResult) -> Result<(), io::Error> {
        if shot == 2 {
            return Err(io::Error::other("disk full"));
        }
        assert!(shot != 7, "library bug");
        self.kept.lock().push(shot);
        Ok(())
    }

    fn close(self) -> Result<(), io::Error> {
        self.closed.fetch_add(1, Ordering::SeqCst);
        Ok(())
    }
}

/// A shot whose single image encodes its number.
fn shot(trigger: u64) -> Shot {
    let frame = || Frame {
        image: RawImage::new(1, 1, vec![trigger as u16]).unwrap(),
        frame_id: 0,
        device_timestamp_ns: 0,
        host_timestamp_ns: 0,
        status: FrameStatus::Complete,
    };
    let cameras = vec![[frame(), frame()]];
    let (due, dt_us) = (Duration::ZERO, 100.0);
    let (time, suspect, residuals_ns) = (None, Vec::new(), vec![0]);
    Shot { trigger, cameras, time, due, dt_us, suspect, residuals_ns }
}

fn number(pair: &ImagePair) -> u16 {
    pair.cameras[0][0].counts()[0]
}

struct Rig {
    links: PoolLinks,
    shelf: TestSink,
    seen: Arc<Mutex<Vec<ShotRecord>>>,
}

impl Rig {
    fn new(shots: u64) -> Self {
        let mut ledger = Ledger::new(1);
        (0..shots).for_each(|trigger| ledger.enter(trigger).unwrap());
        let links = PoolLinks {
            ledger: Arc::new(Mutex::new(ledger)),
            journal: Journal::none(),
            clock: Arc::new(HostClock::start()),
            board: Arc::new(Board::new()),
            stop: CancellationToken::new(),
        };
        Self { links, shelf: TestSink::default(), seen: Arc::default() }
    }

    fn pool<P>(&self, workers: usize, process: P) -> Pool<P>
    where
        P: Fn(&ImagePair) -> Result<PairResult, String> + Send + Sync + 'static,
    {
        let seen = self.seen.clone();
        let observer: Observer = Box::new(move |record, _| seen.lock().push(record.clone()));
        let settings = PoolSettings { workers, threads: 2 };
        Pool::new(settings, process, self.shelf.clone(), observer, self.links.clone()).unwrap()
    }

    fn settled(&self, outcome: Outcome) -> u64 {
        let ledger = self.links.ledger.lock();
        assert!(ledger.is_balanced());
        ledger.accounts()[0].outcomes.of(outcome)
    }
}

async fn filled(shots: u64) -> ShotReceiver {
    let (sender, receiver) = shot_queue(shots as usize);
    for trigger in 0..shots {
        assert_eq!(sender.push(shot(trigger)).map(|shed| shed.is_some()), Ok(false));
    }
    receiver
}

#[tokio::test]
async fn a_panic_a_failure_and_a_full_disk_cost_one_shot_each() {
    let rig = Rig::new(5);
    let pool = rig.pool(1, |pair| match number(pair) {
        0 => panic!("index out of bounds"),
        1 => Err("camera 2 is dark".to_owned()),
        _ => Ok(result()),
    });
    pool.run(filled(5).await).await.unwrap();

    let board = &rig.links.board;
    let message = |shot| board.record(shot).unwrap().message.unwrap();
    assert_eq!(message(0), "the worker panicked: index out of bounds");
    assert_eq!(message(1), "camera 2 is dark");
    assert_eq!(message(2), "disk full");
    assert_eq!(board.record(2).unwrap().stage, Stage::WriteFailed);
    assert!(matches!(board.result(2), Lookup::Here(_)), "what was measured can still be read");
    assert!(matches!(board.result(0), Lookup::NoResult(_)));
    assert_eq!(*rig.shelf.kept.lock(), [3, 4]);
    assert_eq!(rig.shelf.closed.load(Ordering::SeqCst), 1);
    assert_eq!((rig.settled(Outcome::Complete), rig.settled(Outcome::WriteFailed)), (4, 1));
    assert_eq!(rig.seen.lock().len(), 5);
    let counts = board.counts();
    assert_eq!((counts.done, counts.failed, counts.write_failed, counts.processing), (2, 2, 1, 0));
}

#[tokio::test]
async fn a_panic_of_the_writer_costs_one_shot() {
    let rig = Rig::new(9);
    rig.pool(1, |_| Ok(result())).run(filled(9).await).await.unwrap();
    let lost = rig.links.board.record(7).unwrap();
    assert_eq!(lost.stage, Stage::WriteFailed);
    assert_eq!(lost.message.unwrap(), "the writer panicked: library bug");
    assert_eq!((rig.settled(Outcome::Complete), rig.settled(Outcome::WriteFailed)), (7, 2));
    assert_eq!(*rig.shelf.kept.lock(), [0, 1, 3, 4, 5, 6, 8]);
    assert_eq!(rig.shelf.closed.load(Ordering::SeqCst), 1);
}

#[tokio::test]
async fn a_panic_inside_rayon_costs_one_shot() {
    use rayon::prelude::*;
    let rig = Rig::new(2);
    let pool = rig.pool(1, |pair| {
        let number = number(pair);
        (0..64).into_par_iter().for_each(|i| assert!(number != 0 || i != 40, "inner"));
        Ok(result())
    });
    pool.run(filled(2).await).await.unwrap();
    assert_eq!(rig.links.board.record(0).unwrap().stage, Stage::Failed);
    assert_eq!(rig.links.board.record(1).unwrap().stage, Stage::Done);
}

#[tokio::test]
async fn a_stop_finishes_the_shot_in_hand_and_sheds_the_rest() {
    let rig = Rig::new(4);
    let stop = rig.links.stop.clone();
    let pool = rig.pool(1, move |_| {
        stop.cancel();
        std::thread::sleep(Duration::from_millis(50));
        Ok(result())
    });
    pool.run(filled(4).await).await.unwrap();
    assert_eq!((rig.settled(Outcome::Complete), rig.settled(Outcome::Shed)), (1, 3));
    assert_eq!(*rig.shelf.kept.lock(), [0]);
}

#[tokio::test]
async fn no_more_shots_are_in_hand_than_there_are_workers() {
    let rig = Rig::new(12);
    let (now, most) = (Arc::new(AtomicUsize::new(0)), Arc::new(AtomicUsize::new(0)));
    let peak = most.clone();
    let pool = rig.pool(2, move |_| {
        peak.fetch_max(now.fetch_add(1, Ordering::SeqCst) + 1, Ordering::SeqCst);
        std::thread::sleep(Duration::from_millis(10));
        now.fetch_sub(1, Ordering::SeqCst);
        Ok(result())
    });
    pool.run(filled(12).await).await.unwrap();
    assert_eq!(most.load(Ordering::SeqCst), 2);
}

#[tokio::test]
async fn suspect_shots_are_processed_and_marked() {
    let rig = Rig::new(1);
    let (sender, receiver) = shot_queue(1);
    let suspect = vec!["camera 1: frame b came late".to_owned()];
    assert!(sender.push(Shot { suspect, ..shot(0) }).is_ok());
    drop(sender);
    rig.pool(1, |_| Ok(result())).run(receiver).await.unwrap();
    let warnings = rig.links.board.record(0).unwrap().warnings;
    assert_eq!(warnings, ["suspect: camera 1: frame b came late"]);
}

#[test]
fn old_results_leave_memory_and_are_known_to_be_on_disk() {
    let board = Board::new();
    for shot in 0..=RESULTS_IN_MEMORY as u64 {
        board.done(shot, Arc::new(result().into()));
    }
    assert!(matches!(board.result(0), Lookup::OnDisk));
    assert!(matches!(board.result(1), Lookup::Here(_)));
    assert!(matches!(board.result(99), Lookup::Unknown));
    assert_eq!(board.latest().unwrap().0, RESULTS_IN_MEMORY as u64);
}
