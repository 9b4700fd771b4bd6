//! A velocity field as bytes, little-endian throughout.
//!
//! | offset | type | content |
//! |---|---|---|
//! | 0 | 8 bytes | magic `LFPIVVF1` |
//! | 8 | u64 | shot number |
//! | 16 | 3 × u32 | vector counts nx, ny, nz |
//! | 28 | u32 | offset of the arrays: 80 |
//! | 32 | 3 × f64 | position of vector (0, 0, 0), in mm |
//! | 56 | f64 | distance between neighbouring vectors, in mm |
//! | 64 | f64 | edge of a voxel, in mm |
//! | 72 | f64 | time between the frames, in s |
//! | 80 | 3n × f32 | displacement x, y, z per vector, in voxels |
//! | 80 + 12n | n × f32 | peak ratio |
//! | 80 + 16n | n × u8 | 0 valid, 1 replaced, 2 invalid |
//! | 80 + 17n, rounded up to a multiple of 4 | 3n × f32 | standard uncertainty x, y, z, in voxels |
//!
//! n = nx·ny·nz; vectors are ordered z, y, x (x fastest). Velocity in m/s is displacement times
//! voxel edge / 1000 / time between the frames.

use crate::velocimetry::{VectorStatus, VelocityField};

/// The media type to ask for.
pub const MEDIA_TYPE: &str = "application/octet-stream";
/// The first bytes; the last of them is the version of the layout.
pub const MAGIC: &[u8; 8] = b"LFPIVVF1";
/// Where the arrays begin.
pub const HEADER_BYTES: u32 = 80;

/// Bytes per vector in the arrays.
const VECTOR_BYTES: usize = 29;

/// The bytes of a field; see the module.
pub fn encode(shot: u64, field: &VelocityField) -> Vec<u8> {
    let grid = &field.grid;
    let mut bytes = Vec::with_capacity(HEADER_BYTES as usize + VECTOR_BYTES * grid.len());
    bytes.extend_from_slice(MAGIC);
    bytes.extend_from_slice(&shot.to_le_bytes());
    for count in grid.vectors {
        bytes.extend_from_slice(&(count as u32).to_le_bytes());
    }
    bytes.extend_from_slice(&HEADER_BYTES.to_le_bytes());
    for number in grid.first_mm.into_iter().chain([grid.spacing_mm, field.voxel_mm, field.dt_s]) {
        bytes.extend_from_slice(&number.to_le_bytes());
    }
    for number in field.displacement_vox.iter().flatten().chain(&field.peak_ratio) {
        bytes.extend_from_slice(&number.to_le_bytes());
    }
    bytes.extend(field.status.iter().map(|status| match status {
        VectorStatus::Valid => 0,
        VectorStatus::Replaced => 1,
        VectorStatus::Invalid => 2,
    }));
    bytes.resize(bytes.len().next_multiple_of(4), 0);
    for number in field.uncertainty_vox.iter().flatten() {
        bytes.extend_from_slice(&number.to_le_bytes());
    }
    bytes
}
