//! Bounded bursts: fired, waited for, counted, renewed.

use std::time::{Duration, Instant};

use lfpiv_hw::device::SynchroniserState;

use super::{AcquisitionError, OverloadPolicy, absence::Presence, controller::Run, rulings::note};

/// How often the run loop looks at the time.
const TICK: Duration = Duration::from_millis(20);
/// Triggers without a frame after which a camera counts as silent and firing ends.
const SILENT_TRIGGERS: u64 = 5;
/// How often the rate of an external trigger is looked at.
const EXTERNAL_TRIGGER_LOOK: Duration = Duration::from_secs(1);
/// How much longer than planned a burst may take.
const BURST_GRACE: Duration = Duration::from_secs(2);
/// How long frames on their way are waited for once the run is being stopped.
const STOP_GRACE: Duration = Duration::from_secs(5);

impl Run {
    /// Shots of the next burst; `None` when the run is over.
    pub(super) async fn next_burst(&mut self) -> Result<Option<u64>, AcquisitionError> {
        if !self.await_cameras().await? {
            return Ok(None);
        }
        let left = self.settings.shots.map_or(u64::MAX, |shots| shots.get() - self.fired);
        let longest = if self.pairing.has_reference(self.began.elapsed()) {
            self.settings.max_burst()
        } else {
            1
        };
        let shots = match self.settings.overload {
            OverloadPolicy::Shed => left.min(longest),
            OverloadPolicy::Wait => self.keep_places(left.min(longest)).await?,
        };
        Ok((shots > 0 && !self.stop.is_cancelled()).then_some(shots))
    }

    /// Waits for room in the queue and keeps up to `wanted` places; returns how many.
    async fn keep_places(&mut self, wanted: u64) -> Result<u64, AcquisitionError> {
        while wanted > 0 && self.places.is_empty() {
            tokio::select! {
                () = self.stop.cancelled() => return Ok(0),
                () = self.settings.heartbeat.turn() => {}
                event = self.events.recv() => self.handle(event)?,
                place = self.queue.clone().reserve_owned() => {
                    self.places.push_back(place.map_err(|_| AcquisitionError::QueueClosed)?);
                }
            }
        }
        while (self.places.len() as u64) < wanted {
            match self.queue.clone().try_reserve_owned() {
                Ok(place) => self.places.push_back(place),
                Err(_) => break,
            }
        }
        Ok(self.places.len() as u64)
    }

    /// Fires one burst and waits until each of its triggers is ruled on, or, once the run is
    /// being stopped, for as long as [`STOP_GRACE`].
    pub(super) async fn run_burst(&mut self, shots: u64) -> Result<(), AcquisitionError> {
        if !self.wait_until_armed().await? {
            return Ok(());
        }
        let fired_before = self.fired;
        self.fire(shots).await?;
        let planned_end = Instant::now() + self.planned_duration(shots);
        let (mut ended, mut stop_by, mut broken_off) = (false, None, false);
        let mut looked = Instant::now();
        let mut tick = tokio::time::interval(TICK);
        while !ended || self.pairing.open_triggers() > 0 {
            self.settings.heartbeat.beat();
            tokio::select! {
                event = self.events.recv() => self.handle(event)?,
                _ = tick.tick() => {
                    let rulings = self.pairing.tick(self.began.elapsed());
                    self.apply(rulings)?;
                }
                () = self.stop.cancelled(), if stop_by.is_none() => {
                    self.make_safe().await?;
                    stop_by = Some(Instant::now() + STOP_GRACE);
                }
            }
            if !broken_off && !self.all_connected() {
                self.make_safe().await?;
                broken_off = true;
            }
            self.watch_external_trigger(&mut looked).await?;
            let now = Instant::now();
            let all_ruled = self.pairing.open_triggers() == 0;
            let over = now >= planned_end || all_ruled || broken_off || stop_by.is_some();
            if !ended && over {
                ended = self.try_end_burst().await?;
            }
            // Frames may set the pace of a simulated bench: a burst ends late while they come.
            let last_sign = planned_end.max(self.last_frame);
            if !ended && now > last_sign + self.settings.patience + BURST_GRACE {
                return Err(AcquisitionError::Endless { shots });
            }
            if stop_by.is_some_and(|end| now > end) {
                break;
            }
        }
        self.places.clear();
        if self.stop.is_cancelled() || broken_off {
            return Ok(());
        }
        if self.fired == fired_before {
            return Err(AcquisitionError::NoTriggers { shots });
        }
        self.check_silence().await
    }

    /// A source of triggers that is too fast is seen by looking only; the driver ends firing then.
    async fn watch_external_trigger(
        &mut self,
        looked: &mut Instant,
    ) -> Result<(), AcquisitionError> {
        if self.settings.schedule.external_trigger.is_some()
            && looked.elapsed() >= EXTERNAL_TRIGGER_LOOK
        {
            self.synchroniser.call(|unit| unit.state()).await?;
            *looked = Instant::now();
        }
        Ok(())
    }

    /// Lets the lamps warm up, if they need to; false when the run is stopped meanwhile.
    async fn wait_until_armed(&mut self) -> Result<bool, AcquisitionError> {
        let wait = self.synchroniser.call(|unit| unit.arm()).await?;
        let armed = tokio::time::sleep(wait);
        tokio::pin!(armed);
        loop {
            tokio::select! {
                () = self.stop.cancelled() => return Ok(false),
                () = self.settings.heartbeat.turn() => {}
                event = self.events.recv() => self.handle(event)?,
                () = &mut armed => return Ok(true),
            }
        }
    }

    async fn fire(&mut self, shots: u64) -> Result<(), AcquisitionError> {
        let first = self.pairing.fired(shots, self.began.elapsed());
        for trigger in first..first + shots {
            note(self.ledger.lock().enter(trigger));
        }
        self.fired += shots;
        self.presence.iter_mut().for_each(|camera| camera.silent += shots);
        self.synchroniser.call(move |unit| unit.fire(shots)).await
    }

    /// A period more than the triggers need: the last one's frames must be read out.
    fn planned_duration(&self, shots: u64) -> Duration {
        self.settings.period() * u32::try_from(shots).unwrap_or(u32::MAX).saturating_add(1)
    }

    /// Once the unit no longer fires, compares its count with what was asked for.
    async fn try_end_burst(&mut self) -> Result<bool, AcquisitionError> {
        if self.synchroniser.call(|unit| unit.state()).await? == SynchroniserState::Firing {
            return Ok(false);
        }
        let counted = self.synchroniser.call(|unit| unit.trigger_count()).await?;
        let given = match (counted, self.first_count) {
            (Some(counted), Some(first)) => self.given_before + counted.saturating_sub(first),
            // A unit that does not count is taken at its word; frames say the rest.
            _ => self.fired,
        };
        let rulings = self.pairing.burst_ended(given)?;
        self.apply(rulings)?;
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
        Err(AcquisitionError::Silent { camera, triggers: self.presence[camera].silent })
    }
}
