//! Vectors in the formats of other programs: [`write_csv`], [`write_tecplot`], [`Hdf5File`].
//!
//! CSV and Tecplot files contain one shot each. CSV columns state their units. Tecplot files are in
//! SI units, because their variable names cannot state units.

mod csv;
mod hdf5;
mod tecplot;

pub use csv::write_csv;
pub use hdf5::Hdf5File;
pub use tecplot::write_tecplot;

use super::StoredShot;
use lfpiv_core::velocimetry::VectorStatus;

/// Numbers of a vector besides its position.
const QUANTITIES: usize = 14;

/// The numbers of a vector: velocity, its standard uncertainty, whether it is measured, whether it
/// is interpolated, whether it is not in the flow, peak ratio, vorticity, divergence. A missing number is NaN.
fn numbers(shot: &StoredShot, index: usize) -> [f32; QUANTITIES] {
    let is = |wanted: VectorStatus| f32::from(u8::from(shot.status[index] == wanted));
    let [u, v, w] = shot.velocity_m_s[index];
    let [su, sv, sw] = shot.uncertainty_m_s[index];
    let [ox, oy, oz] = shot.vorticity_per_s[index];
    [
        u,
        v,
        w,
        su,
        sv,
        sw,
        is(VectorStatus::Valid),
        is(VectorStatus::Replaced),
        is(VectorStatus::Masked),
        shot.peak_ratio[index],
        ox,
        oy,
        oz,
        shot.divergence_per_s[index],
    ]
}
