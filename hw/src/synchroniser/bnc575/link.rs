//! Typed commands over the line, with every reply checked and every value read back.

use std::time::Instant;

use thiserror::Error;

use super::{
    command::{Command, Parameter, Value, count_of, switch},
    reply::{Refusal, Reply},
    unit::is_identity,
};
use crate::{
    device::DeviceError,
    synchroniser::{
        USE_INTERLOCK,
        line::{Dialogue, LineError},
    },
};

/// Attempts per query.
const ATTEMPTS: usize = 3;

/// A trigger count. The unit read it at some time between query and reply.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Reading {
    pub asked: Instant,
    pub answered: Instant,
    pub count: u64,
}

/// Why a command failed.
#[derive(Debug, Error)]
pub enum LinkError {
    /// The line is lost or silent.
    #[error(transparent)]
    Line(#[from] LineError),
    /// The unit answered with an error code.
    #[error("{command:?} was answered {refusal}")]
    Refused { command: String, refusal: Refusal },
    /// The unit holds another value than the one sent.
    #[error("{command:?} was sent, but the unit reads back {reply:?}")]
    Differs { command: String, reply: String },
}

impl LinkError {
    /// The error for the device trait; a line without replies counts as lost.
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

/// A connection to the unit.
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

    /// Queries the identity. Its reply is unambiguous, so this resynchronises the dialogue.
    pub fn identify(&mut self) -> Result<String, LinkError> {
        let text = Command::Identify.to_string();
        repeated(|| self.dialogue.resynchronise(&text, is_identity))
    }

    /// A query whose reply `accept` recognises. Queries may be repeated.
    pub fn ask(
        &mut self,
        command: Command,
        accept: impl Fn(&str) -> bool,
    ) -> Result<String, LinkError> {
        let text = command.to_string();
        let reply = repeated(|| {
            self.resynchronise()?;
            self.dialogue.ask(&text, |line| accept(line) || is_refusal(line))
        })?;
        match Reply::parse(&reply) {
            Some(Reply::Refused(refusal)) => Err(LinkError::Refused { command: text, refusal }),
            _ => Ok(reply),
        }
    }

    /// Queries a parameter, as text.
    pub fn query(&mut self, parameter: Parameter) -> Result<String, LinkError> {
        self.ask(Command::Query(parameter), |line| parameter.can_be(line))
    }

    /// Queries a boolean.
    pub fn query_switch(&mut self, parameter: Parameter) -> Result<bool, LinkError> {
        Ok(switch(&self.query(parameter)?) == Some(true))
    }

    /// Queries a counter.
    pub fn query_count(&mut self, parameter: Parameter) -> Result<u64, LinkError> {
        Ok(count_of(&self.query(parameter)?).unwrap_or_default())
    }

    /// The trigger count, with the time interval in which the unit read it.
    pub fn read_triggers(&mut self) -> Result<Reading, LinkError> {
        let count = self.query_count(Parameter::TriggerCount)?;
        Ok(Reading { asked: self.dialogue.last_sent(), answered: self.now(), count })
    }

    /// Sends a command once and checks for `ok`. It is never repeated, because a repeated start
    /// would fire twice.
    pub fn command(&mut self, command: Command) -> Result<(), LinkError> {
        self.resynchronise()?;
        self.command_without_resync(command)
    }

    /// As [`Self::command`], without resynchronising first: for urgent commands.
    pub fn command_without_resync(&mut self, command: Command) -> Result<(), LinkError> {
        let text = command.to_string();
        let reply = self.dialogue.ask(&text, |line| Reply::parse(line).is_some())?;
        match Reply::parse(&reply) {
            Some(Reply::Refused(refusal)) => Err(LinkError::Refused { command: text, refusal }),
            _ => Ok(()),
        }
    }

    /// Sets a parameter and reads it back. An unanswered write is not repeated blindly: the
    /// read-back shows whether it took effect.
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

    /// Sets a parameter unless it already has the value.
    pub fn ensure(&mut self, parameter: Parameter, value: Value) -> Result<(), LinkError> {
        match self.verify(parameter, value) {
            Err(LinkError::Differs { .. }) => self.set(parameter, value),
            verified => verified,
        }
    }

    /// Compares a parameter of the unit with its expected value.
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

    fn resynchronise(&mut self) -> Result<(), LineError> {
        if self.dialogue.is_out_of_step() {
            self.dialogue.resynchronise(&Command::Identify.to_string(), is_identity)?;
        }
        Ok(())
    }
}

fn is_refusal(line: &str) -> bool {
    matches!(Reply::parse(line), Some(Reply::Refused(_)))
}

/// Repeats a query while the line is silent.
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
