//! The timing diagram of a pulse schedule, as text and as SVG.
//!
//! Pulses are microseconds apart while the readout takes tens of milliseconds, so both forms have two
//! panels: the time around the pulses, and the whole period.

mod svg;
mod text;

use super::PulseSchedule;

/// One line of the diagram.
#[derive(Debug, Clone, PartialEq)]
struct Track {
    label: &'static str,
    kind: Kind,
    /// Intervals in which the signal is high, in µs after T0.
    intervals_us: Vec<[f64; 2]>,
}

/// Kind of a line, for the SVG's colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Lamp,
    QSwitch,
    CameraTrigger,
    Exposure,
    Readout,
}

/// Time range of a panel, in µs after T0.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Window {
    start_us: f64,
    end_us: f64,
}

impl Window {
    fn length_us(self) -> f64 {
        self.end_us - self.start_us
    }

    /// The part of an interval inside the window, if any.
    fn clip(self, [start_us, end_us]: [f64; 2]) -> Option<[f64; 2]> {
        let clipped = [start_us.max(self.start_us), end_us.min(self.end_us)];
        (clipped[0] < clipped[1]).then_some(clipped)
    }

    /// At most `count` round times inside (steps of 1, 2 or 5 times a power of ten).
    fn ticks_us(self, count: usize) -> Vec<f64> {
        let least = self.length_us() / count.max(1) as f64;
        let decade = 10_f64.powf(least.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0]
            .into_iter()
            .map(|factor| factor * decade)
            .find(|step| *step >= least)
            .unwrap_or(10.0 * decade);
        let first = (self.start_us / step).ceil() as i64;
        let last = (self.end_us / step).floor() as i64;
        (first..=last).map(|index| index as f64 * step).collect()
    }
}

impl PulseSchedule {
    /// The timing diagram as text, about 100 columns wide, followed by the times in µs.
    pub fn diagram_text(&self) -> String {
        text::draw(self)
    }

    /// The timing diagram as an SVG file.
    pub fn diagram_svg(&self) -> String {
        svg::draw(self)
    }

    fn tracks(&self) -> Vec<Track> {
        let pulse = |start_us: f64| vec![[start_us, start_us + self.pulse_width_us]];
        let track = |label, kind, intervals_us| Track { label, kind, intervals_us };
        vec![
            track("lamp 1", Kind::Lamp, pulse(self.lamp_us[0])),
            track("Q-switch 1", Kind::QSwitch, pulse(self.q_switch_us[0])),
            track("lamp 2", Kind::Lamp, pulse(self.lamp_us[1])),
            track("Q-switch 2", Kind::QSwitch, pulse(self.q_switch_us[1])),
            track("camera trigger", Kind::CameraTrigger, pulse(self.camera_trigger_us)),
            track("exposure 1", Kind::Exposure, vec![self.exposure_1_us]),
            track("exposure 2", Kind::Exposure, vec![self.exposure_2_us]),
            track("readout 1", Kind::Readout, vec![self.exposure_2_us]),
            track("readout 2", Kind::Readout, vec![[self.exposure_2_us[1], self.camera_ready_us]]),
        ]
    }

    /// From T0 to the end of the last short event.
    fn around_the_pulses(&self) -> Window {
        let starts = self.signals().into_iter().map(|(_, start_us)| start_us + self.pulse_width_us);
        let last_us = starts.fold(self.exposure_2_us[0], f64::max);
        Window { start_us: 0.0, end_us: 1.08 * last_us }
    }

    fn whole_period(&self) -> Window {
        Window { start_us: 0.0, end_us: self.period_us }
    }

    fn title(&self) -> String {
        let clock = match &self.external_trigger {
            None => "internal clock".to_owned(),
            Some(source) => format!("external trigger of at most {} Hz", source.max_rate_hz),
        };
        format!(
            "dt {} us, {} shots/s, {clock}",
            microseconds(self.dt_us),
            microseconds(self.rate_hz())
        )
    }
}

/// A number with up to five decimals, without trailing zeros.
fn microseconds(value: f64) -> String {
    let text = format!("{value:.5}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// A time in a unit that suits the length of the panel.
fn tick_label(time_us: f64, window: Window) -> String {
    if window.length_us() >= 10_000.0 {
        format!("{} ms", microseconds(time_us / 1000.0))
    } else {
        format!("{} us", microseconds(time_us))
    }
}

#[cfg(test)]
mod tests;
