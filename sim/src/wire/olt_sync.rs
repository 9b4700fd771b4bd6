//! A simulated oltSync: accepts a sequence of edges, start and stop; no read-back.

use std::collections::VecDeque;

use super::{
    OutputPulse, PeriodOutputs,
    pty::{SerialUnit, Step},
};

/// A simulated oltSync.
#[derive(Debug, Clone)]
pub struct OltSyncUnit {
    id: String,
    frame_us: u64,
    /// Edges of each pin, in µs: on, off, on, off, …
    pins: Vec<Vec<u64>>,
    next_t0_ns: Option<u64>,
    partial: Vec<u8>,
    replies: VecDeque<Vec<u8>>,
    pulses: Vec<u64>,
    silent: bool,
}

impl OltSyncUnit {
    /// A unit with this identity, switched on now.
    pub fn new(id: impl Into<String>) -> Self {
        Self {
            id: id.into(),
            frame_us: 0,
            pins: Vec::new(),
            next_t0_ns: None,
            partial: Vec::new(),
            replies: VecDeque::new(),
            pulses: vec![0; 8],
            silent: false,
        }
    }

    /// Whether it ignores commands and sends no replies; a running sequence continues.
    pub fn set_silent(&mut self, silent: bool) {
        self.silent = silent;
    }

    /// Whether the sequence is running.
    pub fn is_running(&self) -> bool {
        self.next_t0_ns.is_some()
    }

    /// Pulses of a pin (1 is the first) since it was switched on.
    pub fn pulses(&self, pin: u8) -> u64 {
        let index = usize::from(pin).checked_sub(1);
        index.and_then(|index| self.pulses.get(index)).copied().unwrap_or_default()
    }

    /// The reply to a line; `None` if it is not addressed to this unit.
    fn answer(&mut self, line: &str, now_ns: u64) -> Option<String> {
        if line == "WhoAreYou?" {
            return Some(format!("oltSync:{}", self.id));
        }
        let order = line.strip_prefix(&format!("TALKINGTO:{}:", self.id))?;
        match order {
            "start" => {
                self.next_t0_ns = Some(now_ns);
                Some("Laser:enable".into())
            }
            "stop" => {
                self.next_t0_ns = None;
                Some("Laser:disable".into())
            }
            _ => {
                let taken = order.strip_prefix("sequence:").and_then(parse_sequence);
                let Some((frame_us, pins)) = taken else {
                    return Some("Sequence:Error".into());
                };
                (self.frame_us, self.pins) = (frame_us, pins);
                Some("Sequence:OK".into())
            }
        }
    }

    fn period(&mut self, t0_ns: u64) -> PeriodOutputs {
        let mut outputs = Vec::new();
        for (index, edges) in self.pins.iter().enumerate() {
            for pulse in edges.chunks_exact(2) {
                if let Some(count) = self.pulses.get_mut(index) {
                    *count += 1;
                }
                outputs.push(OutputPulse {
                    channel: index as u8 + 1,
                    start_us: pulse[0] as f64,
                    width_us: (pulse[1] - pulse[0]) as f64,
                });
            }
        }
        PeriodOutputs { t0_ns, pulses: outputs }
    }
}

/// Parses `<frame_us>:<mode>,0:<edges>:<edges>:…`; `None` if the firmware would refuse it.
fn parse_sequence(text: &str) -> Option<(u64, Vec<Vec<u64>>)> {
    let mut parts = text.split(':');
    let frame_us: u64 = parts.next()?.parse().ok().filter(|frame_us| *frame_us > 0)?;
    let (mode, _) = parts.next()?.split_once(',')?;
    if !["0", "1", "2"].contains(&mode) {
        return None;
    }
    let pins: Option<Vec<Vec<u64>>> = parts.map(|pin| parse_pin(pin, frame_us)).collect();
    pins.filter(|pins| pins.iter().any(|edges| !edges.is_empty())).map(|pins| (frame_us, pins))
}

/// Checks that edges strictly increase within the frame and that every pulse ends.
fn parse_pin(pin: &str, frame_us: u64) -> Option<Vec<u64>> {
    if pin.is_empty() {
        return Some(Vec::new());
    }
    let edges: Vec<u64> = pin.split(',').map(|edge| edge.parse().ok()).collect::<Option<_>>()?;
    let increase = edges.windows(2).all(|pair| pair[0] < pair[1]);
    let inside = edges.iter().all(|edge| *edge <= frame_us);
    (edges.len().is_multiple_of(2) && increase && inside).then_some(edges)
}

impl SerialUnit for OltSyncUnit {
    fn baud_rate(&self) -> u32 {
        9600
    }

    fn receive(&mut self, bytes: &[u8], now_ns: u64) {
        for byte in bytes {
            match byte {
                b'\r' => {}
                b'\n' => {
                    let line = std::mem::take(&mut self.partial);
                    let line = String::from_utf8_lossy(&line).trim().to_owned();
                    if !self.silent
                        && let Some(answer) = self.answer(&line, now_ns)
                    {
                        self.replies.push_back(format!("{answer}\r\n").into_bytes());
                    }
                }
                byte => self.partial.push(*byte),
            }
        }
    }

    fn advance(&mut self, now_ns: u64) -> Step {
        let mut periods = Vec::new();
        while let Some(t0_ns) = self.next_t0_ns.filter(|t0_ns| *t0_ns <= now_ns) {
            periods.push(self.period(t0_ns));
            self.next_t0_ns = Some(t0_ns + self.frame_us.max(1) * 1000);
        }
        let bytes = self.replies.drain(..).flatten().collect();
        Step { bytes, periods, wake_ns: self.next_t0_ns }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ask(unit: &mut OltSyncUnit, line: &str, now_ns: u64) -> String {
        unit.receive(format!("{line}\r\n").as_bytes(), now_ns);
        String::from_utf8(unit.advance(now_ns).bytes).unwrap().trim().to_owned()
    }

    #[test]
    fn it_runs_a_sequence_until_stopped() {
        let mut unit = OltSyncUnit::new("S1");
        assert_eq!(ask(&mut unit, "WhoAreYou?", 0), "oltSync:S1");
        assert_eq!(
            ask(&mut unit, "TALKINGTO:S1:sequence:1000:0,0:100,150::200,300", 0),
            "Sequence:OK"
        );
        unit.receive(b"TALKINGTO:S1:start\r\n", 0);
        let step = unit.advance(2_500_000);
        assert_eq!(step.bytes, b"Laser:enable\r\n");
        assert_eq!(step.periods.len(), 3);
        let pulse = step.periods[1].pulses[1];
        assert_eq!((pulse.channel, pulse.start_us, pulse.width_us), (3, 200.0, 100.0));
        assert_eq!(ask(&mut unit, "TALKINGTO:S1:stop", 2_600_000), "Laser:disable");
        assert!(unit.advance(9_000_000).periods.is_empty());
        assert_eq!([1, 2, 3].map(|pin| unit.pulses(pin)), [3, 0, 3]);
        assert_eq!(ask(&mut unit, "TALKINGTO:S2:stop", 0), "");
    }

    #[test]
    fn it_refuses_what_its_firmware_refuses() {
        for wrong in
            ["0:0,0:1,2", "1000:0,0:", "1000:0,0:1", "1000:0,0:5,5", "1000:0,0:1,1001", "x"]
        {
            let mut unit = OltSyncUnit::new("S1");
            let order = format!("TALKINGTO:S1:sequence:{wrong}");
            assert_eq!(ask(&mut unit, &order, 0), "Sequence:Error", "{wrong}");
        }
    }
}
