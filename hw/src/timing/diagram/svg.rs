//! The timing diagram as SVG.

use std::fmt::Write;

use super::{Kind, PulseSchedule, Track, Window, microseconds, tick_label};

const WIDTH: f64 = 960.0;
/// Left edge of the tracks.
const LEFT: f64 = 130.0;
const RIGHT: f64 = 930.0;

const STYLE: &str = "\
svg { font: 13px system-ui, sans-serif; background: #fff; }
text { fill: #1f2933; } .small { font-size: 11px; fill: #52606d; }
.title { font-size: 17px; font-weight: 600; } .panel { font-weight: 600; }
.grid { stroke: #e4e7eb; } .base { stroke: #9aa5b1; } .guide { stroke: #2f9e44; stroke-dasharray: 4 4; }
.zoom { fill: #f1f3f5; stroke: #ced4da; }
.lamp { fill: #f59f00; } .q { fill: #2f9e44; } .trigger { fill: #495057; }
.exposure { fill: #74c0fc; } .readout { fill: #d0bfff; }";

/// One of the two panels.
struct Panel {
    title: &'static str,
    window: Window,
    top: f64,
    row_height: f64,
    /// Whether intervals are labelled with their times.
    labelled: bool,
}

impl Panel {
    fn x(&self, time_us: f64) -> f64 {
        let fraction = (time_us - self.window.start_us) / self.window.length_us();
        LEFT + fraction * (RIGHT - LEFT)
    }

    fn rows_top(&self) -> f64 {
        self.top + 16.0
    }

    fn base(&self, row: usize) -> f64 {
        self.rows_top() + (row + 1) as f64 * self.row_height
    }
}

pub(super) fn draw(schedule: &PulseSchedule) -> String {
    let tracks = schedule.tracks();
    let window = schedule.around_the_pulses();
    let near =
        Panel { title: "around the pulses", window, top: 70.0, row_height: 34.0, labelled: true };
    let far = Panel {
        title: "whole period",
        window: schedule.whole_period(),
        top: near.base(tracks.len()) + 30.0,
        row_height: 22.0,
        labelled: false,
    };
    let height = far.base(tracks.len()) + 20.0;
    let title = schedule.title();
    let mut body = format!("<text class=\"title\" x=\"20\" y=\"32\">Timing: {title}</text>\n");
    guides(&mut body, &near, schedule, tracks.len());
    panel(&mut body, &near, &tracks);
    zoomed_part(&mut body, &far, window, tracks.len());
    panel(&mut body, &far, &tracks);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height:.0}\" \
         width=\"{WIDTH}\" height=\"{height:.0}\" role=\"img\" aria-label=\"Timing: {title}\">\n\
         <style>{STYLE}</style>\n\
         <rect width=\"{WIDTH}\" height=\"{height:.0}\" fill=\"#fff\"/>\n{body}</svg>\n"
    )
}

fn panel(body: &mut String, panel: &Panel, tracks: &[Track]) {
    // Writing to a String does not fail, here and below.
    let _ = writeln!(
        body,
        "<text class=\"panel\" x=\"20\" y=\"{:.1}\">{}</text>",
        panel.top, panel.title
    );
    axis(body, panel, tracks.len());
    for (row, track) in tracks.iter().enumerate() {
        track_line(body, panel, row, track);
    }
}

fn axis(body: &mut String, panel: &Panel, rows: usize) {
    let (top, bottom) = (panel.rows_top(), panel.base(rows - 1));
    for tick_us in panel.window.ticks_us(9) {
        let x = panel.x(tick_us);
        let label = tick_label(tick_us, panel.window);
        let _ = writeln!(
            body,
            "<line class=\"grid\" x1=\"{x:.1}\" y1=\"{top:.1}\" x2=\"{x:.1}\" y2=\"{bottom:.1}\"/>\
             <text class=\"small\" text-anchor=\"middle\" x=\"{x:.1}\" y=\"{:.1}\">{label}</text>",
            bottom + 15.0
        );
    }
}

fn track_line(body: &mut String, panel: &Panel, row: usize, track: &Track) {
    let base = panel.base(row);
    let height = 0.62 * panel.row_height;
    let _ = writeln!(
        body,
        "<text text-anchor=\"end\" x=\"{:.1}\" y=\"{:.1}\">{}</text>\
         <line class=\"base\" x1=\"{LEFT}\" y1=\"{base:.1}\" x2=\"{RIGHT}\" y2=\"{base:.1}\"/>",
        LEFT - 12.0,
        base - 5.0,
        track.label
    );
    for interval_us in &track.intervals_us {
        let Some([start_us, end_us]) = panel.window.clip(*interval_us) else {
            continue;
        };
        let x = panel.x(start_us);
        // Even the shortest pulse stays visible.
        let width = (panel.x(end_us) - x).max(1.5);
        let times =
            format!("{} to {} us", microseconds(interval_us[0]), microseconds(interval_us[1]));
        let _ = writeln!(
            body,
            "<rect class=\"{}\" x=\"{x:.1}\" y=\"{:.1}\" width=\"{width:.1}\" \
             height=\"{height:.1}\"><title>{}: {times}</title></rect>",
            class(track.kind),
            base - height,
            track.label
        );
        if panel.labelled {
            times_beside(body, &times, [x, x + width], base - 0.2 * panel.row_height);
        }
    }
}

/// To the right of the bar; to its left or on it if there is no space.
fn times_beside(body: &mut String, times: &str, [start, end]: [f64; 2], y: f64) {
    let room = 7.0 * times.len() as f64;
    let (anchor, x) = if end + room < RIGHT {
        ("start", end + 6.0)
    } else if end - start > room + 12.0 {
        ("start", start + 6.0)
    } else {
        ("end", start - 6.0)
    };
    let _ = writeln!(
        body,
        "<text class=\"small\" text-anchor=\"{anchor}\" x=\"{x:.1}\" y=\"{y:.1}\">{times}</text>"
    );
}

/// Vertical lines from the light pulses to the exposures.
fn guides(body: &mut String, panel: &Panel, schedule: &PulseSchedule, rows: usize) {
    for q_switch_us in schedule.q_switch_us {
        let x = panel.x(q_switch_us);
        let _ = writeln!(
            body,
            "<line class=\"guide\" x1=\"{x:.1}\" y1=\"{:.1}\" x2=\"{x:.1}\" y2=\"{:.1}\"/>",
            panel.rows_top(),
            panel.base(rows - 1)
        );
    }
}

/// Marks the first panel's window within the period.
fn zoomed_part(body: &mut String, panel: &Panel, window: Window, rows: usize) {
    let (x, end) = (panel.x(window.start_us), panel.x(window.end_us));
    let _ = writeln!(
        body,
        "<rect class=\"zoom\" x=\"{x:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"{:.1}\"/>",
        panel.rows_top(),
        (end - x).max(2.0),
        panel.base(rows - 1) - panel.rows_top()
    );
}

fn class(kind: Kind) -> &'static str {
    match kind {
        Kind::Lamp => "lamp",
        Kind::QSwitch => "q",
        Kind::CameraTrigger => "trigger",
        Kind::Exposure => "exposure",
        Kind::Readout => "readout",
    }
}
