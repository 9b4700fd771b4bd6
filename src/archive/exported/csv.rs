//! Comma-separated values: one line per vector.

use std::{io::Write, path::Path};

use super::{QUANTITIES, numbers};
use crate::archive::{ArchiveError, StoredShot, durable::replace};

const POSITION_COLUMNS: &str = "shot,time_s,dt_s,x_mm,y_mm,z_mm";
const NAMES: [&str; QUANTITIES] = [
    "u_m_s",
    "v_m_s",
    "w_m_s",
    "u_uncertainty_m_s",
    "v_uncertainty_m_s",
    "w_uncertainty_m_s",
    "valid",
    "replaced",
    "masked",
    "peak_ratio",
    "vorticity_x_per_s",
    "vorticity_y_per_s",
    "vorticity_z_per_s",
    "divergence_per_s",
];

/// Writes the vectors of one shot, replacing an older file. The first line names the columns with
/// their units. A missing number is an empty field. `time_s` is UTC in seconds since 1970.
pub fn write_csv(path: &Path, shot: &StoredShot) -> Result<(), ArchiveError> {
    replace(path, |writer| {
        writeln!(writer, "{POSITION_COLUMNS},{}", NAMES.join(","))?;
        let time = shot.time_s.map_or(String::new(), |time_s| format!("{time_s:.6}"));
        for index in 0..shot.grid.len() {
            // Rounds away the meaningless digits of summed spacings.
            let [x, y, z] = shot.grid.position_mm(index).map(|mm| (mm * 1e6).round() / 1e6);
            write!(writer, "{},{time},{:e},{x},{y},{z}", shot.shot, shot.dt_s)?;
            for number in numbers(shot, index) {
                match number.is_nan() {
                    true => write!(writer, ",")?,
                    false => write!(writer, ",{number}")?,
                }
            }
            writeln!(writer)?;
        }
        Ok(())
    })
}
