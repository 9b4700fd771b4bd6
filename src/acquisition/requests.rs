//! Handles requests, between bursts or by ending one.

use std::time::Duration;

use lfpiv_hw::synchroniser::USE_INTERLOCK;

use super::{
    AcquisitionError, Command, Mode, Refusal, control::Request, controller::Run, journal::Entry,
};

/// Longest wait of the run loop between requests.
const IDLE_WAIT: Duration = Duration::from_millis(500);

impl Run {
    pub(super) fn mode(&self) -> Mode {
        self.control.state.lock().mode
    }

    /// Carries out a request and answers it.
    pub(super) async fn handle_request(
        &mut self,
        request: Request,
    ) -> Result<(), AcquisitionError> {
        tracing::info!(command = ?request.command, "request");
        let (done, ended) = match self.carry_out(request.command).await {
            Ok(done) => (done, Ok(())),
            Err(error) => (Err(Refusal::because(error.to_string())), Err(error)),
        };
        let state = self.control.state.lock().clone();
        // The requester may be gone.
        let _ = request.answer.send(done.map(|()| state));
        ended
    }

    async fn carry_out(
        &mut self,
        command: Command,
    ) -> Result<Result<(), Refusal>, AcquisitionError> {
        if self.loss.is_some()
            && let Some(refusal) = self.refuse_without_unit(&command)
        {
            return Ok(Err(refusal));
        }
        match command {
            Command::Start => {
                self.set_mode(Mode::Firing);
                Ok(Ok(()))
            }
            Command::Resume => match self.awaits_operator {
                Some(mode) => {
                    self.set_mode(mode);
                    Ok(Ok(()))
                }
                None => Ok(Err(Refusal::because("the run is not waiting for an operator"))),
            },
            Command::Stop if self.mode() == Mode::Disarmed => {
                Ok(Err(Refusal::because("no shots are being taken: it is disarmed")))
            }
            Command::Stop => {
                // The mode first: it holds even if the unit turns out to be lost.
                self.set_mode(Mode::Armed);
                self.abort_burst().await?;
                Ok(Ok(()))
            }
            Command::Arm if self.mode() == Mode::Firing => {
                Ok(Err(Refusal::because("shots are being taken: stop first")))
            }
            Command::Arm => {
                self.set_mode(Mode::Armed);
                Ok(Ok(()))
            }
            Command::Disarm => {
                self.set_mode(Mode::Disarmed);
                self.abort_burst().await?;
                Ok(Ok(()))
            }
            Command::SetDt { dt_us } => Ok(self.set_dt(dt_us)),
            Command::Note { text } => {
                self.record(Entry::Note { at_ns: self.at_ns(), text }).await?;
                Ok(Ok(()))
            }
        }
    }

    /// Why a request cannot be carried out while the unit is lost; `None` if it needs no unit. A
    /// request for a safer mode is remembered until the unit is back, a request to fire is not.
    fn refuse_without_unit(&mut self, command: &Command) -> Option<Refusal> {
        let resume_mode = &mut self.loss.as_mut()?.resume_mode;
        match command {
            Command::SetDt { .. } | Command::Note { .. } => return None,
            Command::Disarm => *resume_mode = Mode::Disarmed,
            Command::Stop if *resume_mode == Mode::Firing => *resume_mode = Mode::Armed,
            Command::Stop | Command::Start | Command::Arm | Command::Resume => {}
        }
        let reason = match command {
            Command::Disarm => format!("it stays disarmed once it answers; {USE_INTERLOCK}"),
            Command::Stop => format!("no shots are taken then; {USE_INTERLOCK}"),
            _ => "ask again when it is back".to_owned(),
        };
        Some(Refusal::because(format!("the synchroniser does not answer: {reason}")))
    }

    pub(super) fn set_mode(&mut self, mode: Mode) {
        self.awaits_operator = None;
        let mut state = self.control.state.lock();
        state.mode = mode;
        state.held.clear();
    }

    /// Makes the laser safe; a running burst is over.
    pub(super) async fn abort_burst(&mut self) -> Result<(), AcquisitionError> {
        self.is_aborted = true;
        self.make_safe().await
    }

    fn set_dt(&mut self, dt_us: f64) -> Result<(), Refusal> {
        self.settings.schedule = (self.control.plan)(dt_us).map_err(Refusal::because)?;
        self.is_programmed = false;
        self.control.state.lock().dt_us = dt_us;
        Ok(())
    }

    /// While not firing: brings the unit to the requested state and waits for events.
    pub(super) async fn idle(&mut self, mode: Mode) -> Result<(), AcquisitionError> {
        if mode == Mode::Armed && !self.is_armed {
            if !self.is_programmed {
                self.program().await?;
            }
            self.synchroniser.call(|unit| unit.arm()).await?;
            self.is_armed = true;
        }
        self.handle_next_event(IDLE_WAIT).await
    }

    /// Waits for one event, up to a limit, and handles it.
    pub(super) async fn handle_next_event(
        &mut self,
        at_most: Duration,
    ) -> Result<(), AcquisitionError> {
        let stop = self.stop.clone();
        tokio::select! {
            () = stop.cancelled() => Ok(()),
            error = self.synchroniser.fault() => Err(error),
            () = self.heartbeat.keep_alive() => Ok(()),
            event = self.events.recv() => self.handle(event).await,
            request = self.control.next() => self.handle_request(request).await,
            () = tokio::time::sleep(at_most) => Ok(()),
        }
    }
}
