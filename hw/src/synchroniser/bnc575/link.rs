//! Typed commands over the line: every reply checked, every value read back.

use std::time::Instant;

use thiserror::Error;

use super::{
    command::{Command, Parameter, Value, count_of, switch},
    reply::{Refusal, Reply},
    source::Reading,
    unit::is_identity,
};
use crate::{
    device::DeviceError,
    synchroniser::{
        USE_INTERLOCK,
        line::{Dialogue, LineError},
    },
};

/// How often a question is put.
const ATTEMPTS: usize = 3;

/// Why a command did not have its effect.
#[derive(Debug, Error)]
pub enum LinkError {
    /// Line gone or silent.
    #[error(transparent)]
    Line(#[from] LineError),
    /// The unit answered with an error code.
    #[error("{command:?} was answered {refusal}")]
    Refused { command: String, refusal: Refusal },
    /// The unit holds another value than it was sent.
    #[error("{command:?} was sent, but {reply:?} is read back; the value is not what was planned")]
    Differs { command: String, reply: String },
}

impl LinkError {
    /// As the device trait has it; a line without answers is a lost one.
    pub fn into_device_error(self, device: &str) -> DeviceError {
        let device = device.to_owned();
        match self {
            Self::Line(error) => {
                DeviceError::Lost { device, detail: format!("{error}; {USE_INTERLOCK}") }
            }
            other => DeviceError::Refused { device, detail: other.to_string() },
        }
    }
}

/// The unit's end of the dialogue.
pub struct Link {
    dialogue: Dialogue,
}

impl Link {
    pub fn new(dialogue: Dialogue) -> Self {
        Self { dialogue }
    }

    pub fn dialogue(&mut self) -> &mut Dialogue {
        &mut self.dialogue
    }

    /// The time on the line's clock.
    pub fn now(&self) -> Instant {
        self.dialogue.now()
    }

    /// Asks who the unit is. Its answer cannot be mistaken for any other, so it brings the
    /// dialogue in step.
    pub fn identify(&mut self) -> Result<String, LinkError> {
        let text = Command::Identify.to_string();
        repeated(|| self.dialogue.get_in_step(&text, is_identity))
    }

    /// A question whose answer `accept` recognises. Questions may be repeated.
    pub fn ask(
        &mut self,
        command: Command,
        accept: impl Fn(&str) -> bool,
    ) -> Result<String, LinkError> {
        let text = command.to_string();
        let reply = repeated(|| {
            self.get_in_step()?;
            self.dialogue.ask(&text, |line| accept(line) || is_refusal(line))
        })?;
        match Reply::parse(&reply) {
            Some(Reply::Refused(refusal)) => Err(LinkError::Refused { command: text, refusal }),
            _ => Ok(reply),
        }
    }

    /// The value of a parameter, as text.
    pub fn query(&mut self, parameter: Parameter) -> Result<String, LinkError> {
        self.ask(Command::Query(parameter), |line| parameter.can_be(line))
    }

    /// The value of a switch.
    pub fn query_switch(&mut self, parameter: Parameter) -> Result<bool, LinkError> {
        Ok(switch(&self.query(parameter)?) == Some(true))
    }

    /// The value of a counter.
    pub fn query_count(&mut self, parameter: Parameter) -> Result<u64, LinkError> {
        Ok(count_of(&self.query(parameter)?).unwrap_or_default())
    }

    /// The count of triggers, and between which moments the unit read it.
    pub fn read_triggers(&mut self) -> Result<Reading, LinkError> {
        let count = self.query_count(Parameter::TriggerCount)?;
        Ok(Reading { asked: self.dialogue.last_sent(), answered: self.now(), count })
    }

    /// Sends a command once and checks its `ok`. It is not repeated: a repeated start would fire
    /// twice.
    pub fn command(&mut self, command: Command) -> Result<(), LinkError> {
        self.get_in_step()?;
        self.command_in_any_step(command)
    }

    /// As [`Self::command`], without getting in step first: for orders that must not wait.
    pub fn command_in_any_step(&mut self, command: Command) -> Result<(), LinkError> {
        let text = command.to_string();
        let reply = self.dialogue.ask(&text, |line| Reply::parse(line).is_some())?;
        match Reply::parse(&reply) {
            Some(Reply::Refused(refusal)) => Err(LinkError::Refused { command: text, refusal }),
            _ => Ok(()),
        }
    }

    /// Sets a parameter and reads it back. A write that is not answered is not repeated blindly:
    /// the read-back says whether it was taken.
    pub fn set(&mut self, parameter: Parameter, value: Value) -> Result<(), LinkError> {
        self.write(parameter, value)?;
        match self.verify(parameter, value) {
            Err(LinkError::Differs { .. }) => {
                self.write(parameter, value)?;
                self.verify(parameter, value)
            }
            verified => verified,
        }
    }

    /// Sets a parameter unless it reads back right already.
    pub fn ensure(&mut self, parameter: Parameter, value: Value) -> Result<(), LinkError> {
        match self.verify(parameter, value) {
            Err(LinkError::Differs { .. }) => self.set(parameter, value),
            verified => verified,
        }
    }

    /// Compares what the unit holds with what it should.
    pub fn verify(&mut self, parameter: Parameter, value: Value) -> Result<(), LinkError> {
        let reply = self.query(parameter)?;
        match value.agrees(&reply) {
            true => Ok(()),
            false => {
                let command = Command::Set(parameter, value).to_string();
                Err(LinkError::Differs { command, reply })
            }
        }
    }

    fn write(&mut self, parameter: Parameter, value: Value) -> Result<(), LinkError> {
        match self.command(Command::Set(parameter, value)) {
            Err(LinkError::Line(LineError::Silent { command, .. })) => {
                tracing::warn!(command, "a write was not answered; it is read back");
                Ok(())
            }
            written => written,
        }
    }

    fn get_in_step(&mut self) -> Result<(), LineError> {
        if self.dialogue.is_out_of_step() {
            self.dialogue.get_in_step(&Command::Identify.to_string(), is_identity)?;
        }
        Ok(())
    }
}

fn is_refusal(line: &str) -> bool {
    matches!(Reply::parse(line), Some(Reply::Refused(_)))
}

/// Asks again while the line is silent.
fn repeated(mut ask: impl FnMut() -> Result<String, LineError>) -> Result<String, LinkError> {
    for _ in 1..ATTEMPTS {
        match ask() {
            Err(LineError::Silent { command, .. }) => {
                tracing::warn!(command, "no reply; asking again");
            }
            answered => return Ok(answered?),
        }
    }
    Ok(ask()?)
}
