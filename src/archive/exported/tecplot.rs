//! Tecplot's ASCII format: one ordered zone in block layout.
//!
//! The format cannot mark a missing number, so missing numbers are zero. `valid` and `replaced`
//! tell which vectors have a value; use them for blanking. `masked` tells what is not flow.

use std::{io::Write, path::Path};

use super::{QUANTITIES, numbers};
use crate::archive::{ArchiveError, StoredShot, durable::replace};

const NAMES: [&str; QUANTITIES] = [
    "u",
    "v",
    "w",
    "u_uncertainty",
    "v_uncertainty",
    "w_uncertainty",
    "valid",
    "replaced",
    "masked",
    "peak_ratio",
    "vorticity_x",
    "vorticity_y",
    "vorticity_z",
    "divergence",
];
/// Readers may limit lines to some hundred characters.
const NUMBERS_PER_LINE: usize = 8;

/// Writes the vectors of one shot, replacing an older file, in SI units: positions in m, velocities
/// in m/s, derivatives in 1/s. All shots of a run form one strand. The solution time is the shot's
/// time (UTC in seconds since 1970), or its number if the time is unknown.
pub fn write_tecplot(path: &Path, shot: &StoredShot) -> Result<(), ArchiveError> {
    let count = shot.grid.len();
    let vectors: Vec<[f32; QUANTITIES]> = (0..count).map(|index| numbers(shot, index)).collect();
    replace(path, |writer| {
        let [nx, ny, nz] = shot.grid.vectors;
        writeln!(writer, "TITLE = \"lfpiv, shot {}, SI units, dt {:e} s\"", shot.shot, shot.dt_s)?;
        let names = ["x", "y", "z"].into_iter().chain(NAMES);
        let quoted: Vec<String> = names.map(|name| format!("\"{name}\"")).collect();
        writeln!(writer, "VARIABLES = {}", quoted.join(", "))?;
        let time = shot.time_s.unwrap_or(shot.shot as f64);
        writeln!(
            writer,
            "ZONE T=\"shot {}\", I={nx}, J={ny}, K={nz}, DATAPACKING=BLOCK, STRANDID=1, \
             SOLUTIONTIME={time}",
            shot.shot
        )?;
        for axis in 0..3 {
            let positions = (0..count).map(|index| shot.grid.position_mm(index)[axis] * 1e-3);
            write_block(writer, positions)?;
        }
        for quantity in 0..QUANTITIES {
            let known = |number: f32| if number.is_nan() { 0.0 } else { f64::from(number) };
            write_block(writer, vectors.iter().map(|numbers| known(numbers[quantity])))?;
        }
        Ok(())
    })
}

fn write_block(writer: &mut impl Write, numbers: impl Iterator<Item = f64>) -> std::io::Result<()> {
    let mut column = 0;
    for number in numbers {
        // A 32-bit float has at most nine significant digits.
        write!(writer, "{number:.8e}")?;
        column = (column + 1) % NUMBERS_PER_LINE;
        writer.write_all(if column == 0 { b"\n" } else { b" " })?;
    }
    if column != 0 { writeln!(writer) } else { Ok(()) }
}
