use super::*;
use crate::timing::TimingSettings;

fn schedule(dt_us: f64) -> PulseSchedule {
    PulseSchedule::plan(&TimingSettings::default(), dt_us, 10.0).unwrap()
}

/// First and last high column of a track in the panel with this title.
fn high(text: &str, panel: &str, label: &str) -> [usize; 2] {
    let panel = &text[text.find(panel).unwrap()..];
    let line = panel.lines().find(|line| line.starts_with(label)).unwrap();
    let line: Vec<char> = line.chars().skip(16).collect();
    let first = line.iter().position(|&c| c == '#').unwrap();
    [first, line.iter().rposition(|&c| c == '#').unwrap()]
}

#[test]
fn both_panels_show_every_signal_where_it_is() {
    let text = schedule(100.0).diagram_text();
    // The panel ends at 1.08 times the end of Q-switch 2, 430 us; a column is 5.53 us.
    assert_eq!(high(&text, "around", "lamp 1"), [18, 27]);
    assert_eq!(high(&text, "around", "Q-switch 2"), [68, 77]);
    assert_eq!(high(&text, "around", "exposure 1"), [23, 59]);
    assert_eq!(high(&text, "around", "exposure 2")[1], 83);
    // 40 ms of 100 ms; microseconds are one column of 1.2 ms.
    assert_eq!(high(&text, "whole", "readout 1"), [0, 33]);
    assert_eq!(high(&text, "whole", "readout 2"), [33, 67]);
    assert_eq!(high(&text, "whole", "Q-switch 1"), [0, 0]);
    let row = format!("{:<16}{:>14}{:>14}\n", "exposure 1", 129, 329);
    assert!(text.contains(&row), "{text}");
}

#[test]
fn ticks_are_below_the_columns_of_their_times() {
    let text = schedule(100.0).diagram_text();
    let panel = &text[text.find("whole").unwrap()..];
    let axis = panel.lines().find(|line| line.contains('|')).unwrap();
    // 84 columns after the labels for 100 ms.
    for (column, tick) in [(0, "|0 ms"), (16, "|20 ms"), (33, "|40 ms"), (50, "|60 ms")] {
        assert!(axis[16 + column..].starts_with(tick), "{axis}");
    }
}

#[test]
fn no_line_of_the_text_is_wider_than_a_terminal() {
    for dt_us in [4.0, 100.0, 1000.0, 20_000.0] {
        let text = schedule(dt_us).diagram_text();
        let widest = text.lines().map(|line| line.chars().count()).max().unwrap();
        assert!(widest <= 108, "dt {dt_us}: {widest} columns");
    }
}

#[test]
fn the_svg_has_a_bar_for_every_signal_in_both_panels() {
    let svg = schedule(100.0).diagram_svg();
    for times in ["lamp 1: 100 to 150", "Q-switch 2: 380 to 430", "camera trigger: 126 to 176"] {
        assert_eq!(svg.matches(times).count(), 2, "{times}");
    }
    // Beyond the near panel's end.
    assert_eq!(svg.matches("readout 2: 40331 to 80331").count(), 1);
    assert!(svg.starts_with("<svg xmlns") && svg.ends_with("</svg>\n"));
    for number in svg.split('"').filter_map(|piece| piece.parse::<f64>().ok()) {
        assert!((0.0..=1000.0).contains(&number), "{number} is outside the picture");
    }
}

#[test]
fn ticks_are_round_and_few() {
    let window = Window { start_us: 0.0, end_us: 464.4 };
    assert_eq!(window.ticks_us(6), [0.0, 100.0, 200.0, 300.0, 400.0]);
    let period = Window { start_us: 0.0, end_us: 100_000.0 };
    assert_eq!(period.ticks_us(6).len(), 6);
    assert_eq!(tick_label(20_000.0, period), "20 ms");
}
