//! Messages of the oltSync: pins and their edges in whole microseconds.
//!
//! Source: the unit's replies; the rules of a sequence are those that its firmware checks (even number
//! of edges per pin, strictly increasing, none beyond the frame time).

use crate::{PulseSchedule, synchroniser::ChannelMap};

/// Replies of the unit.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Answer {
    /// `oltSync:<id>`
    Identity(String),
    /// `Sequence:OK`
    SequenceTaken,
    /// `Sequence:Error`
    SequenceRefused,
    /// `Laser:enable`: outputs follow the sequence.
    Enabled,
    /// `Laser:disable`: outputs are off.
    Disabled,
}

impl Answer {
    /// Parses a line; `None` if it is not a reply.
    pub fn parse(line: &str) -> Option<Self> {
        if let Some((head, id)) = line.split_once(':')
            && head.eq_ignore_ascii_case("oltSync")
            && !id.is_empty()
        {
            return Some(Self::Identity(id.to_owned()));
        }
        [
            ("Sequence:OK", Self::SequenceTaken),
            ("Sequence:Error", Self::SequenceRefused),
            ("Laser:enable", Self::Enabled),
            ("Laser:disable", Self::Disabled),
        ]
        .into_iter()
        .find_map(|(text, answer)| line.eq_ignore_ascii_case(text).then_some(answer))
    }
}

/// Queries the identity.
pub const WHO_ARE_YOU: &str = "WhoAreYou?";

/// Starts the sequence.
pub fn start(id: &str) -> String {
    format!("TALKINGTO:{id}:start")
}

/// Switches all outputs off.
pub fn stop(id: &str) -> String {
    format!("TALKINGTO:{id}:stop")
}

/// Outputs driven by a sequence.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outputs {
    /// Lamps only, for warm-up.
    LampsOnly,
    /// Lamps, Q-switches and cameras.
    All,
}

/// One period: `TALKINGTO:<id>:sequence:<frame_us>:0,0:<on,off>:<on,off>:…`, pin 1 first. Mode 0
/// selects the unit's own clock. The schedule must be in whole microseconds.
pub fn sequence(
    id: &str,
    schedule: &PulseSchedule,
    channels: &ChannelMap,
    outputs: Outputs,
) -> String {
    let lamps = channels.lamps().into_iter().zip(schedule.lamp_us);
    let q_switches = channels.q_switches().into_iter().zip(schedule.q_switch_us);
    let cameras = channels.cameras.iter().map(|camera| (*camera, schedule.camera_trigger_us));
    let mut starts: Vec<_> = lamps.collect();
    if outputs == Outputs::All {
        starts.extend(q_switches.chain(cameras));
    }
    let last_pin = channels.all().into_iter().map(|name| name.number()).max().unwrap_or(0);
    let pins: Vec<String> = (1..=last_pin)
        .map(|pin| {
            let start = starts.iter().find(|(name, _)| name.number() == pin);
            start.map_or(String::new(), |(_, start_us)| {
                format!("{start_us:.0},{:.0}", start_us + schedule.pulse_width_us)
            })
        })
        .collect();
    format!("TALKINGTO:{id}:sequence:{:.0}:0,0:{}", schedule.period_us, pins.join(":"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TimingSettings;

    #[test]
    fn sequences_name_every_pin_up_to_the_last() {
        let schedule = PulseSchedule::plan(&TimingSettings::default(), 100.0, 10.0).unwrap();
        let channels = ChannelMap::default();
        assert_eq!(
            sequence("SYNC_1", &schedule, &channels, Outputs::All),
            "TALKINGTO:SYNC_1:sequence:100000:0,0:100,150:280,330:200,250:380,430:126,176"
        );
        assert_eq!(
            sequence("SYNC_1", &schedule, &channels, Outputs::LampsOnly),
            "TALKINGTO:SYNC_1:sequence:100000:0,0:100,150::200,250::"
        );
        assert_eq!(
            (start("X"), stop("X")),
            ("TALKINGTO:X:start".into(), "TALKINGTO:X:stop".into())
        );
    }

    #[test]
    fn replies_are_distinguished_from_other_lines() {
        assert_eq!(Answer::parse("oltSync:SYNC_1"), Some(Answer::Identity("SYNC_1".into())));
        assert_eq!(Answer::parse("laser:disable"), Some(Answer::Disabled));
        assert_eq!(Answer::parse("Sequence:Error"), Some(Answer::SequenceRefused));
        for stray in ["oltSync:", "Laser:", "ok", "WhoAreYou?", "TALKINGTO:X:stop", ""] {
            assert_eq!(Answer::parse(stray), None, "{stray}");
        }
    }
}
