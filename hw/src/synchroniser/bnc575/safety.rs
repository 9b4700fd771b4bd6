//! The safe state: most dangerous outputs first, verified by read-back.

use super::{
    Bnc575,
    command::{Channel, ChannelParameter, Command, Parameter, Value},
    link::LinkError,
};
use crate::{
    device::DeviceError,
    synchroniser::{USE_INTERLOCK, line::LineError},
};

/// Attempts before the unit counts as out of control.
const ROUNDS: usize = 2;

impl Bnc575 {
    /// Switches off Q-switches, lamps, T0, cameras and all other channels, in this order, and reads
    /// each one back. T0 precedes the cameras, so that every T0 counted by the unit has triggered
    /// them. Can be called at any time: late replies are skipped.
    pub(super) fn reach_safe_state(&mut self) -> Result<(), DeviceError> {
        self.forget();
        let outputs = self.most_dangerous_first();
        let mut trouble = String::new();
        for _ in 0..ROUNDS {
            let reached = self.switch_off(&outputs).and_then(|()| self.confirm_off(&outputs));
            match reached {
                Ok(()) => return Ok(()),
                Err(error @ LinkError::Line(LineError::Lost { .. })) => {
                    return Err(self.failed(error));
                }
                Err(error) => {
                    tracing::warn!(unit = self.name, %error, "the safe state is not confirmed");
                    trouble = error.to_string();
                }
            }
        }
        let detail = format!("the safe state is not confirmed: {trouble}; {USE_INTERLOCK}");
        Err(DeviceError::Lost { device: self.name.clone(), detail })
    }

    fn most_dangerous_first(&self) -> Vec<Parameter> {
        let state = |number| Parameter::Of(Channel(number), ChannelParameter::State);
        let lasers = self.channels.q_switches().into_iter().chain(self.channels.lamps());
        let lasers: Vec<u8> = lasers.map(|name| name.number()).collect();
        let cameras: Vec<u8> = self.channels.cameras.iter().map(|name| name.number()).collect();
        let is_other = |number: &u8| !lasers.contains(number) && !cameras.contains(number);
        let others = (1..=self.unit.channels).filter(is_other);
        let after_t0 = cameras.iter().copied().chain(others).map(state);
        lasers.iter().copied().map(state).chain([Parameter::Running]).chain(after_t0).collect()
    }

    /// Sends all commands, whatever happens to each. Once the unit is silent they are sent without
    /// waiting for replies: it may receive without being able to reply, and time matters.
    fn switch_off(&mut self, outputs: &[Parameter]) -> Result<(), LinkError> {
        let mut silent = false;
        for output in outputs {
            let order = Command::Set(*output, Value::Switch(false));
            if silent {
                self.link.dialogue().send(&order.to_string())?;
                continue;
            }
            match self.link.command_without_resync(order) {
                Ok(()) => {}
                Err(error @ LinkError::Line(LineError::Lost { .. })) => return Err(error),
                Err(error) => {
                    silent = matches!(error, LinkError::Line(_));
                    tracing::warn!(unit = self.name, %error, "a command of the safe state failed");
                }
            }
        }
        Ok(())
    }

    fn confirm_off(&mut self, outputs: &[Parameter]) -> Result<(), LinkError> {
        // A late "0" must not be taken for a reply.
        self.link.identify()?;
        for output in outputs {
            self.link.verify(*output, Value::Switch(false))?;
        }
        Ok(())
    }
}
