//! Bounded bursts: fired, waited for, counted, renewed.

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

/// How often the run loop looks at the time.
pub(super) const TICK: Duration = Duration::from_millis(20);
/// Triggers without a frame after which a camera counts as silent and firing ends.
const SILENT_TRIGGERS: u64 = 5;
/// How much longer than planned a burst may take.
const BURST_GRACE: Duration = Duration::from_secs(2);
/// How long frames on their way are waited for once the run is being stopped.
const STOP_GRACE: Duration = Duration::from_secs(5);

impl Run {
    /// Shots of the next burst, armed and ready to be fired; `None` when the run is over.
    pub(super) async fn next_burst(&mut self) -> Result<Option<u64>, AcquisitionError> {
        loop {
            self.note_serial().await?;
            if !self.await_cameras().await? || self.stop.is_cancelled() {
                return Ok(None);
            }
            match self.mode() {
                Mode::Firing => {}
                mode => {
                    self.rest(mode).await?;
                    continue;
                }
            }
            let Some(shots) = self.size_of_burst().await? else { return Ok(None) };
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

    /// Shots that the next burst should have; zero when there is no room for them yet, `None` when
    /// there is nothing left to do.
    async fn size_of_burst(&mut self) -> Result<Option<u64>, AcquisitionError> {
        if let Some(script) = self.bursts.clone() {
            return self.size_of_scripted_burst(script.next()).await;
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
            OverloadPolicy::Wait => self.room(1).await?.min(wanted),
        }))
    }

    /// As [`Self::size_of_burst`], where a script decides.
    async fn size_of_scripted_burst(
        &mut self,
        scripted: ScriptedBurst,
    ) -> Result<Option<u64>, AcquisitionError> {
        let (shots, schedule) = match scripted {
            ScriptedBurst::Over => return Ok(None),
            ScriptedBurst::NotYet => {
                self.attend(TICK).await?;
                return Ok(Some(0));
            }
            ScriptedBurst::Fire { shots, schedule } => (shots, schedule),
        };
        // What was recorded before this burst has been delivered; it comes first.
        if let Ok(event) = self.events.try_recv() {
            self.handle(Some(event)).await?;
            return Ok(Some(0));
        }
        if *schedule != self.settings.schedule {
            self.settings.schedule = (*schedule).clone();
            self.is_programmed = false;
        }
        Ok(Some(if self.room(shots).await? < shots { 0 } else { shots }))
    }

    /// Places in the queue, `least` of them when there are so many; zero when something else
    /// happened before there was room.
    async fn room(&mut self, least: u64) -> Result<u64, AcquisitionError> {
        let stop = self.stop.clone();
        let least = usize::try_from(least).unwrap_or(usize::MAX);
        tokio::select! {
            biased;
            () = stop.cancelled() => Ok(0),
            error = self.synchroniser.fault() => Err(error),
            room = self.queue.room(least) => match room {
                Ok(room) => Ok(room as u64),
                Err(Closed) => Err(AcquisitionError::QueueClosed),
            },
            () = self.heartbeat.turn() => Ok(0),
            event = self.events.recv() => self.handle(event).await.map(|()| 0),
            request = self.control.next() => self.handle_request(request).await.map(|()| 0),
        }
    }

    /// Fires one burst and waits until each of its triggers is ruled on, or, once the run is
    /// being stopped, for as long as [`STOP_GRACE`].
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
                _ = tick.tick() => self.look_at_the_time().await?,
                request = self.control.next() => self.handle_request(request).await?,
                error = self.synchroniser.fault() => return Err(error),
                () = stop.cancelled(), if stop_by.is_none() => {
                    self.make_safe().await?;
                    self.note(Entry::Stopping { at_ns: self.at_ns() }).await?;
                    stop_by = Some(Instant::now() + STOP_GRACE);
                }
            }
            if !self.broken_off && !self.all_connected() {
                self.break_off().await?;
            }
            let all_ruled = self.pairing.open_triggers() == 0;
            let scripted = self.bursts.as_ref().is_some_and(|script| script.burst_is_over());
            let over = self.time >= planned_end
                || all_ruled
                || self.broken_off
                || stop_by.is_some()
                || scripted && self.events.is_empty();
            if !ended && over {
                ended = self.try_end_burst().await?;
            }
            // Frames may set the pace of a simulated bench: a burst ends late while they come.
            let last_sign = planned_end.max(self.last_frame);
            if !ended && self.time > last_sign + self.settings.patience + BURST_GRACE {
                return Err(AcquisitionError::Endless { shots });
            }
            if stop_by.is_some_and(|end| Instant::now() > end) {
                break;
            }
        }
        if self.stop.is_cancelled() || self.broken_off {
            return Ok(());
        }
        if self.fired == fired_before {
            return Err(AcquisitionError::NoTriggers { shots });
        }
        self.check_silence().await
    }

    /// Time goes on while nothing is seen. It must not overtake what was seen and waits to be
    /// taken: that is looked for after the clock was read.
    pub(super) async fn look_at_the_time(&mut self) -> Result<(), AcquisitionError> {
        let now = self.clock.now();
        if self.events.is_empty() { self.time_passes(now).await } else { Ok(()) }
    }

    /// Lets the lamps warm up, if they need to; false when the run is stopped meanwhile, or when
    /// something else is asked of it.
    async fn wait_until_armed(&mut self) -> Result<bool, AcquisitionError> {
        let wait = self.synchroniser.call(|unit| unit.arm()).await?;
        let armed = tokio::time::sleep(wait);
        tokio::pin!(armed);
        let stop = self.stop.clone();
        loop {
            tokio::select! {
                // Whoever wants the laser safe is heard before it is ready.
                biased;
                () = stop.cancelled() => return Ok(false),
                error = self.synchroniser.fault() => return Err(error),
                request = self.control.next() => self.handle_request(request).await?,
                event = self.events.recv() => self.handle(event).await?,
                () = &mut armed => break,
                () = self.heartbeat.turn() => {}
            }
        }
        Ok(self.mode() == Mode::Firing && self.is_programmed && self.all_connected())
    }

    async fn fire(&mut self, shots: u64) -> Result<(), AcquisitionError> {
        self.broken_off = false;
        self.time_passes(self.clock.now()).await?;
        self.burst_ends = self.time + self.planned_duration(shots);
        (self.is_burst_open, self.is_burst_begun) = (true, false);
        let first = self.pairing.fired(shots, self.time);
        self.fired += shots;
        self.presence.iter_mut().for_each(|camera| camera.silent += shots);
        self.note(Entry::Fired { at_ns: self.at_ns(), first, shots }).await?;
        // The disk may have had to be waited for, laser safe: then this burst ends before it begins.
        if self.broken_off || !self.is_programmed || self.stop.is_cancelled() {
            return Ok(());
        }
        self.is_burst_begun = true;
        let started = self.synchroniser.call(move |unit| {
            unit.fire(shots)?;
            Ok(unit.started_after())
        });
        let started_after = started.await?;
        let start = self.burst_start(started_after);
        self.note(Entry::BurstStarted { first, start }).await.map(|_| ())
    }

    /// How the burst that was just accepted began, and what UTC is. One that is played again began
    /// as it did then.
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

    /// A period more than the triggers need: the last one's frames must be read out.
    fn planned_duration(&self, shots: u64) -> Duration {
        self.settings.period() * u32::try_from(shots).unwrap_or(u32::MAX).saturating_add(1)
    }

    /// Once the unit no longer fires, compares its count with what was asked for.
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
            // A unit that does not count is taken at its word, up to now; frames say the rest.
            _ if self.is_burst_begun => self.pairing.due_by(self.clock.now()),
            _ => self.pairing.due_by(Duration::ZERO),
        };
        self.is_burst_open = false;
        self.note(Entry::BurstEnded { at_ns: self.at_ns(), given }).await?;
        let rulings = self.pairing.burst_ended(given)?;
        self.apply(rulings).await?;
        Ok(true)
    }

    /// Firing goes on only while every camera delivers. One that has vanished is waited for by
    /// [`Run::await_cameras`]; one that is there and says nothing ends the run.
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
