//! Tecplot's ASCII format: one ordered zone, the numbers in blocks.
//!
//! The format has no sign for a missing number: what a vector does not have is zero, and `valid` and
//! `replaced` say which vectors have a value; blank by them.

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
    "peak_ratio",
    "vorticity_x",
    "vorticity_y",
    "vorticity_z",
    "divergence",
];
/// A reader may have a limit of some hundred characters.
const NUMBERS_IN_A_LINE: usize = 8;

/// Writes the vectors of one shot, replacing an older file, in SI units: places in m, velocities in m/s,
/// derivatives in 1/s. All shots of a run are one strand, with the shot's time as the solution time (UTC in
/// seconds since 1970), or its number where the time is not known.
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
            let places = (0..count).map(|index| shot.grid.position_mm(index)[axis] * 1e-3);
            write_block(writer, places)?;
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
        // Nine digits are all that a number of 32 bit has.
        write!(writer, "{number:.8e}")?;
        column = (column + 1) % NUMBERS_IN_A_LINE;
        writer.write_all(if column == 0 { b"\n" } else { b" " })?;
    }
    if column != 0 { writeln!(writer) } else { Ok(()) }
}
