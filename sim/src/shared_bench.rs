//! What the devices of a simulated bench share: the scene, the clock, triggers and rendered shots.

use std::{
    collections::BTreeMap,
    sync::{Arc, Condvar, Mutex, MutexGuard, OnceLock, PoisonError},
    time::{Duration, Instant},
};

use lfpiv_hw::{PulseSchedule, device::StreamStatistics};

use crate::{
    BenchGeometry, Scene, SimulatedShot,
    triggers::{Pacing, Triggers},
};

/// Shots kept rendered. A camera further behind the others than this renders again.
pub(crate) const SHOTS_KEPT: usize = 4;

/// A shot that is rendered by whoever asks first; others wait for it.
pub(crate) type RenderedShot = Arc<OnceLock<SimulatedShot>>;

/// What the devices of one bench share.
pub(crate) struct SharedBench {
    scene: Scene,
    geometry: BenchGeometry,
    seed: u64,
    connected: Instant,
    state: Mutex<BenchState>,
    changed: Condvar,
}

/// The part of it that changes.
pub(crate) struct BenchState {
    pub(crate) triggers: Triggers,
    /// One per camera; `None` while it is stopped.
    pub(crate) streams: Vec<Option<Stream>>,
    pub(crate) rendered: BTreeMap<u64, RenderedShot>,
}

/// A started camera.
#[derive(Debug, Clone)]
pub(crate) struct Stream {
    /// Number of the first trigger after the start.
    pub(crate) first_trigger: u64,
    /// Frames handed out, or being rendered.
    pub(crate) frames: u64,
    pub(crate) statistics: StreamStatistics,
}

impl Stream {
    /// The trigger whose frame comes next.
    pub(crate) fn next_trigger(&self) -> u64 {
        self.first_trigger + self.frames / 2
    }
}

impl BenchState {
    /// Gives the triggers that are due.
    pub(crate) fn advance(&mut self, now_ns: u64) {
        let slowest = self.streams.iter().flatten().map(Stream::next_trigger).min();
        self.triggers.advance(now_ns, slowest);
    }

    /// The place of the shot of trigger `number`, rendered or not.
    pub(crate) fn rendered(&mut self, number: u64) -> RenderedShot {
        let shot = Arc::clone(self.rendered.entry(number).or_default());
        while self.rendered.len() > SHOTS_KEPT {
            self.rendered.pop_first();
        }
        shot
    }

    /// Forgets rendered shots that no started camera will ask for.
    pub(crate) fn forget_delivered(&mut self) {
        let slowest = self.streams.iter().flatten().map(Stream::next_trigger).min();
        self.rendered.retain(|&number, _| slowest.is_some_and(|slowest| number >= slowest));
    }
}

impl SharedBench {
    pub(crate) fn new(scene: Scene, geometry: BenchGeometry, seed: u64, pacing: Pacing) -> Self {
        let state = BenchState {
            triggers: Triggers::new(pacing),
            streams: vec![None; geometry.poses.len()],
            rendered: BTreeMap::new(),
        };
        Self {
            scene,
            geometry,
            seed,
            connected: Instant::now(),
            state: Mutex::new(state),
            changed: Condvar::new(),
        }
    }

    /// The bench's clock, in ns.
    pub(crate) fn now_ns(&self) -> u64 {
        self.connected.elapsed().as_nanos() as u64
    }

    /// The state. Every change is one call without a panic in it: a poisoned lock is whole.
    pub(crate) fn lock(&self) -> MutexGuard<'_, BenchState> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Wakes all waiting calls.
    pub(crate) fn notify(&self) {
        self.changed.notify_all();
    }

    /// Sleeps until something changes, but at most for `at_most`.
    pub(crate) fn wait<'a>(
        &self,
        state: MutexGuard<'a, BenchState>,
        at_most: Duration,
    ) -> MutexGuard<'a, BenchState> {
        let woken = self.changed.wait_timeout(state, at_most);
        woken.unwrap_or_else(PoisonError::into_inner).0
    }

    /// Both cameras' images of one shot.
    pub(crate) fn render(&self, schedule: &PulseSchedule, shot: u64) -> SimulatedShot {
        let geometry = BenchGeometry { dt_s: schedule.dt_us * 1e-6, ..self.geometry.clone() };
        self.scene.shot(&geometry, self.seed, shot)
    }
}
