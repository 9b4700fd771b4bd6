//! Bounded bursts: fired, awaited, counted, renewed.

use std::time::{Duration, Instant};

use lfpiv_hw::{
    CameraName,
    device::{DeviceError, SynchroniserState},
    synchroniser::USE_INTERLOCK,
};

use super::{
    AcquisitionError, BurstStart, Closed, Mode, OverloadPolicy, ScriptedBurst, controller::Run,
    journal::Entry, presence::Presence,
};

/// Time step of the run loop.
pub(super) const TICK: Duration = Duration::from_millis(20);
/// Triggers without a frame after which a camera counts as silent and firing stops.
const SILENT_TRIGGERS: u64 = 5;
/// How much longer than planned a burst may take.
const BURST_GRACE: Duration = Duration::from_secs(2);
/// How long the run waits for frames in transit once it is being stopped.
const STOP_GRACE: Duration = Duration::from_secs(5);

impl Run {
    /// Number of shots of the next burst, with the unit armed; `None` when the run is over.
    pub(super) async fn next_burst(&mut self) -> Result<Option<u64>, AcquisitionError> {
        loop {
            self.record_serial().await?;
            if !self.await_cameras().await? || self.stop.is_cancelled() {
                return Ok(None);
            }
            match self.mode() {
                Mode::Firing => {}
                mode => {
                    self.idle(mode).await?;
                    continue;
                }
            }
            let Some(shots) = self.next_burst_size().await? else { return Ok(None) };
            if shots == 0 || !self.may_fire(shots).await? {
                continue;
            }
            if !self.is_programmed {
                self.program().await?;
            }
            if self.wait_until_armed().await? {
                return Ok(Some(shots));
            }
        }
    }

    /// Number of shots for the next burst: zero while the queue has no space, `None` when nothing
    /// is left to do.
    async fn next_burst_size(&mut self) -> Result<Option<u64>, AcquisitionError> {
        if let Some(script) = self.bursts.clone() {
            return self.scripted_burst_size(script.next()).await;
        }
        let left = self.settings.shots.map_or(u64::MAX, |shots| shots.get() - self.fired);
        if left == 0 {
            return Ok(None);
        }
        let longest =
            if self.pairing.has_reference(self.time) { self.settings.max_burst() } else { 1 };
        let wanted = left.min(longest);
        Ok(Some(match self.settings.overload {
            OverloadPolicy::Shed => wanted,
            OverloadPolicy::Wait => self.free_places(1).await?.min(wanted),
        }))
    }

    /// As [`Self::next_burst_size`], decided by a script.
    async fn scripted_burst_size(
        &mut self,
        scripted: ScriptedBurst,
    ) -> Result<Option<u64>, AcquisitionError> {
        let (shots, schedule) = match scripted {
            ScriptedBurst::Over => return Ok(None),
            ScriptedBurst::NotYet => {
                self.handle_next_event(TICK).await?;
                return Ok(Some(0));
            }
            ScriptedBurst::Fire { shots, schedule } => (shots, schedule),
        };
        // Events recorded before this burst have been delivered and come first.
        if let Ok(event) = self.events.try_recv() {
            self.handle(Some(event)).await?;
            return Ok(Some(0));
        }
        if *schedule != self.settings.schedule {
            self.settings.schedule = (*schedule).clone();
            self.is_programmed = false;
        }
        Ok(Some(if self.free_places(shots).await? < shots { 0 } else { shots }))
    }

    /// Free places in the queue, waiting for `least` of them; zero when another event came first.
    async fn free_places(&mut self, least: u64) -> Result<u64, AcquisitionError> {
        let stop = self.stop.clone();
        let least = usize::try_from(least).unwrap_or(usize::MAX);
        tokio::select! {
            biased;
            () = stop.cancelled() => Ok(0),
            error = self.synchroniser.fault() => Err(error),
            room = self.queue.free_places(least) => match room {
                Ok(room) => Ok(room as u64),
                Err(Closed) => Err(AcquisitionError::QueueClosed),
            },
            () = self.heartbeat.keep_alive() => Ok(0),
            event = self.events.recv() => self.handle(event).await.map(|()| 0),
            request = self.control.next() => self.handle_request(request).await.map(|()| 0),
        }
    }

    /// Fires one burst and waits until each of its triggers has an outcome, or, once the run is being
    /// stopped, for [`STOP_GRACE`].
    pub(super) async fn run_burst(&mut self, shots: u64) -> Result<(), AcquisitionError> {
        let fired_before = self.fired;
        self.fire(shots).await?;
        let planned_end = self.burst_ends;
        let (mut ended, mut stop_by) = (false, None);
        let mut tick = tokio::time::interval(TICK);
        let stop = self.stop.clone();
        while !ended || self.pairing.open_triggers() > 0 {
            self.heartbeat.beat();
            tokio::select! {
                event = self.events.recv() => self.handle(event).await?,
                _ = tick.tick() => self.tick().await?,
                request = self.control.next() => self.handle_request(request).await?,
                error = self.synchroniser.fault() => return Err(error),
                () = stop.cancelled(), if stop_by.is_none() => {
                    self.make_safe().await?;
                    self.record(Entry::Stopping { at_ns: self.at_ns() }).await?;
                    stop_by = Some(Instant::now() + STOP_GRACE);
                }
            }
            if !self.is_aborted && !self.all_connected() {
                self.abort_burst().await?;
            }
            self.note_switching_off().await?;
            let all_ruled = self.pairing.open_triggers() == 0;
            let scripted = self.bursts.as_ref().is_some_and(|script| script.burst_is_over());
            let over = self.time >= planned_end
                || all_ruled
                || self.is_aborted
                || stop_by.is_some()
                || scripted && self.events.is_empty();
            if !ended && over {
                ended = self.try_end_burst().await?;
            }
            // Frames may set the pace of a simulated bench: a burst lasts as long as they keep coming.
            let last_sign = planned_end.max(self.last_frame);
            if !ended && self.time > last_sign + self.settings.patience + BURST_GRACE {
                return Err(AcquisitionError::BurstOverrun { shots });
            }
            if stop_by.is_some_and(|end| Instant::now() > end) {
                break;
            }
        }
        if self.stop.is_cancelled() || self.is_aborted {
            return Ok(());
        }
        if self.fired == fired_before {
            return Err(AcquisitionError::NoTriggers { shots });
        }
        self.check_silence().await
    }

    /// If the laser was switched off during the burst, now or in the record, marks the shots that may
    /// lack light.
    pub(super) async fn note_switching_off(&mut self) -> Result<(), AcquisitionError> {
        if let Some(script) = &self.bursts
            && script.switching_off_is_due()
            // Frames recorded before it are in the channel by now, and come first.
            && self.events.is_empty()
        {
            script.pass_switching_off();
            self.is_switching_off = true;
        }
        if std::mem::take(&mut self.is_switching_off) {
            self.pairing.laser_switched_off();
            self.record(Entry::SwitchingOff { at_ns: self.at_ns() }).await?;
        }
        Ok(())
    }

    /// Advances time while no event arrives. Events that are waiting must come first: they are checked
    /// after the clock was read.
    pub(super) async fn tick(&mut self) -> Result<(), AcquisitionError> {
        let now = self.clock.now();
        if self.events.is_empty() { self.advance_time(now).await } else { Ok(()) }
    }

    /// Lets the lamps warm up if necessary; false when the run is stopped or receives another request
    /// meanwhile.
    async fn wait_until_armed(&mut self) -> Result<bool, AcquisitionError> {
        let wait = self.synchroniser.call(|unit| unit.arm()).await?;
        let armed = tokio::time::sleep(wait);
        tokio::pin!(armed);
        let stop = self.stop.clone();
        loop {
            tokio::select! {
                // A request for the safe state comes before the end of the warm-up.
                biased;
                () = stop.cancelled() => return Ok(false),
                error = self.synchroniser.fault() => return Err(error),
                request = self.control.next() => self.handle_request(request).await?,
                event = self.events.recv() => self.handle(event).await?,
                () = &mut armed => break,
                () = self.heartbeat.keep_alive() => {}
            }
        }
        Ok(self.mode() == Mode::Firing && self.is_programmed && self.all_connected())
    }

    async fn fire(&mut self, shots: u64) -> Result<(), AcquisitionError> {
        self.is_aborted = false;
        self.advance_time(self.clock.now()).await?;
        self.burst_ends = self.time + self.planned_duration(shots);
        (self.is_burst_open, self.is_burst_accepted) = (true, false);
        let first = self.pairing.fired(shots, self.time);
        self.fired += shots;
        self.presence.iter_mut().for_each(|camera| camera.silent += shots);
        self.record(Entry::Fired { at_ns: self.at_ns(), first, shots }).await?;
        // If the disk had to be waited for, the laser was made safe: the burst ends before it begins.
        if self.is_aborted || !self.is_programmed || self.stop.is_cancelled() {
            return Ok(());
        }
        self.is_burst_accepted = true;
        let started = self.synchroniser.call(move |unit| {
            unit.fire(shots)?;
            Ok(unit.started_after())
        });
        let started_after = started.await?;
        let start = self.burst_start(started_after);
        self.record(Entry::BurstStarted { first, start }).await.map(|_| ())
    }

    /// Start of the burst that was just accepted, with UTC. In a replay, the recorded start.
    fn burst_start(&self, started_after: Option<Instant>) -> BurstStart {
        let fired = BurstStart { not_before_ns: self.at_ns(), clock: None };
        if let Some(script) = &self.bursts {
            return script.burst_start().unwrap_or(fired);
        }
        let now = self.clock.now();
        let since = started_after.map_or(Duration::MAX, |after| after.elapsed());
        let not_before = now.saturating_sub(since).max(self.time);
        BurstStart { not_before_ns: not_before.as_nanos() as u64, clock: self.clock.pair() }
    }

    /// One period more than the triggers need, so that the last frames are read out.
    fn planned_duration(&self, shots: u64) -> Duration {
        self.settings.period() * u32::try_from(shots).unwrap_or(u32::MAX).saturating_add(1)
    }

    /// Once the unit has stopped firing, compares its trigger count with the number requested.
    pub(super) async fn try_end_burst(&mut self) -> Result<bool, AcquisitionError> {
        let state = self.synchroniser.call(|unit| unit.state()).await?;
        if state == SynchroniserState::Firing {
            return Ok(false);
        }
        let counted = self.synchroniser.call(|unit| unit.trigger_count()).await?;
        if state == SynchroniserState::Unknown {
            let (device, detail) = (self.identity.clone(), USE_INTERLOCK.to_owned());
            return Err(AcquisitionError::SynchroniserLost(DeviceError::Lost { device, detail }));
        }
        let given = match (counted, self.first_count) {
            (Some(counted), Some(first)) => self.given_before + counted.saturating_sub(first),
            // Without a counter, assume the triggers due so far; frames show the rest.
            _ if self.is_burst_accepted => self.pairing.due_by(self.clock.now()),
            _ => self.pairing.due_by(Duration::ZERO),
        };
        self.is_burst_open = false;
        self.record(Entry::BurstEnded { at_ns: self.at_ns(), given }).await?;
        let decisions = self.pairing.burst_ended(given)?;
        self.apply(decisions).await?;
        Ok(true)
    }

    /// Stops firing unless every camera delivers. A lost camera is handled by [`Run::await_cameras`]; a
    /// connected but silent one ends the run.
    async fn check_silence(&mut self) -> Result<(), AcquisitionError> {
        let silent = |camera: &Presence| camera.silent >= SILENT_TRIGGERS;
        let Some(camera) = self.presence.iter().position(silent) else { return Ok(()) };
        if self.has_vanished(camera).await? {
            return Ok(());
        }
        let triggers = self.presence[camera].silent;
        Err(AcquisitionError::Silent { camera: CameraName(camera), triggers })
    }
}
