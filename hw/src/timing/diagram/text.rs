//! The timing diagram as text.

use std::fmt::Write;

use super::{PulseSchedule, Track, Window, microseconds, tick_label};

/// Characters per track.
const COLUMNS: usize = 84;
/// Characters of the label before a track.
const LABEL: usize = 16;

pub(super) fn draw(schedule: &PulseSchedule) -> String {
    let tracks = schedule.tracks();
    let mut text = format!("{}\n", schedule.title());
    panel(&mut text, "around the pulses", &tracks, schedule.around_the_pulses());
    panel(&mut text, "whole period", &tracks, schedule.whole_period());
    table(&mut text, &tracks);
    text
}

fn panel(text: &mut String, title: &str, tracks: &[Track], window: Window) {
    let column_us = microseconds(window.length_us() / COLUMNS as f64);
    // Writing to a String does not fail, here and below.
    let _ = writeln!(text, "\n{title}, one column is {column_us} us");
    for track in tracks {
        let _ = writeln!(text, "{:<LABEL$}{}", track.label, line(track, window));
    }
    let _ = writeln!(text, "{:LABEL$}{}", "", axis(window));
}

/// `#` where the signal is high at any time in the column, so that no pulse is too short to show.
fn line(track: &Track, window: Window) -> String {
    let column_us = window.length_us() / COLUMNS as f64;
    let column_at = |time_us: f64| (time_us - window.start_us) / column_us;
    let mut line = vec!['_'; COLUMNS];
    for interval_us in &track.intervals_us {
        if let Some([start_us, end_us]) = window.clip(*interval_us) {
            let first = (column_at(start_us) as usize).min(COLUMNS - 1);
            let last = (column_at(end_us).ceil() as usize).clamp(first + 1, COLUMNS);
            line[first..last].fill('#');
        }
    }
    line.into_iter().collect()
}

fn axis(window: Window) -> String {
    let mut axis = String::new();
    for tick_us in window.ticks_us(6) {
        let column = ((tick_us - window.start_us) / window.length_us() * COLUMNS as f64) as usize;
        if column >= axis.len() {
            let _ = write!(axis, "{:1$}|{2}", "", column - axis.len(), tick_label(tick_us, window));
        }
    }
    axis
}

fn table(text: &mut String, tracks: &[Track]) {
    let _ = writeln!(text, "\n{:<LABEL$}{:>14}{:>14}", "us after T0", "from", "to");
    for track in tracks {
        for [start_us, end_us] in &track.intervals_us {
            let (start, end) = (microseconds(*start_us), microseconds(*end_us));
            let _ = writeln!(text, "{:<LABEL$}{start:>14}{end:>14}", track.label);
        }
    }
}
