//! The run does what it is asked, between bursts or by ending one.

use std::time::Duration;

use lfpiv_hw::synchroniser::USE_INTERLOCK;

use super::{
    AcquisitionError, Command, Mode, Refusal, control::Request, controller::Run, journal::Entry,
};

/// How long the run loop sleeps at most while nothing is asked of it.
const REST: Duration = Duration::from_millis(500);

impl Run {
    pub(super) fn mode(&self) -> Mode {
        self.control.state.lock().mode
    }

    /// Takes up a request and answers it.
    pub(super) async fn handle_request(
        &mut self,
        request: Request,
    ) -> Result<(), AcquisitionError> {
        tracing::info!(command = ?request.command, "asked for");
        let (done, ended) = match self.carry_out(request.command).await {
            Ok(done) => (done, Ok(())),
            Err(error) => (Err(Refusal::because(error.to_string())), Err(error)),
        };
        let state = self.control.state.lock().clone();
        // Whoever asked may have gone.
        let _ = request.answer.send(done.map(|()| state));
        ended
    }

    async fn carry_out(
        &mut self,
        command: Command,
    ) -> Result<Result<(), Refusal>, AcquisitionError> {
        if self.loss.is_some()
            && let Some(refusal) = self.without_the_unit(&command)
        {
            return Ok(Err(refusal));
        }
        match command {
            Command::Start => {
                self.set_mode(Mode::Firing);
                Ok(Ok(()))
            }
            Command::GoOn => match self.awaits_operator {
                Some(mode) => {
                    self.set_mode(mode);
                    Ok(Ok(()))
                }
                None => Ok(Err(Refusal::because("the run waits for nobody"))),
            },
            Command::Stop if self.mode() == Mode::Disarmed => {
                Ok(Err(Refusal::because("no shots are being taken: it is disarmed")))
            }
            Command::Stop => {
                // The wish first: it holds even where the unit is found to be lost.
                self.set_mode(Mode::Armed);
                self.break_off().await?;
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
                self.break_off().await?;
                Ok(Ok(()))
            }
            Command::SetDt { dt_us } => Ok(self.set_dt(dt_us)),
            Command::Note { text } => {
                self.note(Entry::Note { at_ns: self.at_ns(), text }).await?;
                Ok(Ok(()))
            }
        }
    }

    /// Why this cannot be done while the unit is lost; `None` for what does not need it. A wish for
    /// less is kept until it is back, a wish to fire is not.
    fn without_the_unit(&mut self, command: &Command) -> Option<Refusal> {
        let then = &mut self.loss.as_mut()?.then;
        match command {
            Command::SetDt { .. } | Command::Note { .. } => return None,
            Command::Disarm => *then = Mode::Disarmed,
            Command::Stop if *then == Mode::Firing => *then = Mode::Armed,
            Command::Stop | Command::Start | Command::Arm | Command::GoOn => {}
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

    /// The laser is safe from now on; a burst that runs is over.
    pub(super) async fn break_off(&mut self) -> Result<(), AcquisitionError> {
        self.broken_off = true;
        self.make_safe().await
    }

    fn set_dt(&mut self, dt_us: f64) -> Result<(), Refusal> {
        self.settings.schedule = (self.control.plan)(dt_us).map_err(Refusal::because)?;
        self.is_programmed = false;
        self.control.state.lock().dt_us = dt_us;
        Ok(())
    }

    /// Nothing is fired: brings the unit to the state asked for and waits for what comes.
    pub(super) async fn rest(&mut self, mode: Mode) -> Result<(), AcquisitionError> {
        if mode == Mode::Armed && !self.is_armed {
            if !self.is_programmed {
                self.program().await?;
            }
            self.synchroniser.call(|unit| unit.arm()).await?;
            self.is_armed = true;
        }
        self.attend(REST).await
    }

    /// Waits for one thing to happen, a while at most, and deals with it.
    pub(super) async fn attend(&mut self, at_most: Duration) -> Result<(), AcquisitionError> {
        let stop = self.stop.clone();
        tokio::select! {
            () = stop.cancelled() => Ok(()),
            error = self.synchroniser.fault() => Err(error),
            () = self.heartbeat.turn() => Ok(()),
            event = self.events.recv() => self.handle(event).await,
            request = self.control.next() => self.handle_request(request).await,
            () = tokio::time::sleep(at_most) => Ok(()),
        }
    }
}
