//! Frames over real wires.

use crate::{
    Row,
    report::{
        Report,
        section::{Compared, Section},
        text::number,
    },
};

/// What arrived at each rate. The paper's cameras wrote to disk; it names no rate.
pub fn streams(report: &Report) -> Option<Section> {
    let rows: Vec<Compared> = report.record.rows.iter().filter_map(line).collect();
    if rows.is_empty() {
        return None;
    }
    Some(Section {
        id: "loopback",
        title: "Frames over GigE Vision, triggered over serial",
        caption:
            "Simulated cameras and synchroniser at the ends of real wires (loopback interface, \
                  pseudo-terminal) to this program's drivers and pairing, Mono12Packed, two frames \
                  a shot. Rates are means over the run, in which the synchroniser is programmed, \
                  too; processors are those of simulated instruments and program together."
                .to_owned(),
        compared: rows,
        ..Section::default()
    })
}

fn line(row: &Row) -> Option<Compared> {
    let (rate, whole, cpu, seconds) = (row.rate_hz?, row.whole_share?, row.cpu_s?, row.seconds?);
    let what = format!("{} shots/s asked for, {} cameras", number(rate), row.cameras);
    let ours = format!(
        "{} % of the shots whole; {} frames/s and {} MB/s per camera; {} processors; {} copy per \
         frame",
        number(100.0 * whole),
        number(row.frames_per_s?),
        number(row.mb_per_s?),
        number(cpu / seconds),
        row.copies_per_frame?
    );
    Some(Compared::new(what, "", ours))
}
