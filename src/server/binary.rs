//! Byte layout of velocity fields, particles, volumes and masks, little-endian throughout.
//!
//! A velocity field:
//!
//! | offset | type | content |
//! |---|---|---|
//! | 0 | 8 bytes | magic `LFPIVVF2` |
//! | 8 | u64 | shot number |
//! | 16 | 3 × u32 | vector counts nx, ny, nz |
//! | 28 | u32 | offset of the arrays: 80 |
//! | 32 | 3 × f64 | position of vector (0, 0, 0), in mm |
//! | 56 | f64 | distance between neighbouring vectors, in mm |
//! | 64 | f64 | edge of a voxel, in mm |
//! | 72 | f64 | time between the frames, in s |
//! | 80 | 3n × f32 | displacement x, y, z per vector, in voxels |
//! | 80 + 12n | n × f32 | peak ratio |
//! | 80 + 16n | n × u8 | 0 valid, 1 replaced, 2 invalid, 3 masked |
//! | 80 + 17n, rounded up to a multiple of 4 | 3n × f32 | standard uncertainty x, y, z, in voxels |
//!
//! n = nx·ny·nz; vectors are ordered z, y, x (x fastest). Displacement and uncertainty of an
//! invalid or masked vector are NaN (in version 1: zero and the largest expected value). Velocity in m/s is
//! displacement times voxel edge / 1000 / time between the frames.
//!
//! Particles:
//!
//! | offset | type | content |
//! |---|---|---|
//! | 0 | 8 bytes | magic `LFPIVPA1` |
//! | 8 | u64 | shot number |
//! | 16 | u32 | number of particles n |
//! | 20 | u32 | number of cameras c |
//! | 24 | u32 | zero |
//! | 28 | u32 | offset of the arrays: 80 |
//! | 32 | f64 | edge of a voxel, in mm |
//! | 40 | f64 | time between the frames, in s |
//! | 48 | 32 bytes | zero |
//! | 80 | 3n × f32 | place x, y, z per particle in the middle of the pair, in mm |
//! | 80 + 12n | 3n × f32 | displacement x, y, z between the frames, in voxels |
//! | 80 + 24n | 3n × f32 | standard uncertainty of the displacement x, y, z, in voxels |
//! | 80 + 36n | c·n × f32 | light in each camera per particle |
//! | 80 + (36 + 4c)n | n × u8 | 1 valid: it agrees with the particles about it; 0 rejected |
//! | | up to 3 bytes | zero, to a multiple of 4 |
//! | | 3n × f32 | standard uncertainty of the place x, y, z, in voxels |
//!
//! A volume:
//!
//! | offset | type | content |
//! |---|---|---|
//! | 0 | 8 bytes | magic `LFPIVVO1` |
//! | 8 | u64 | shot number |
//! | 16 | 3 × u32 | voxel counts nx, ny, nz |
//! | 28 | u32 | offset of the array: 80 |
//! | 32 | 3 × f64 | position of the centre of voxel (0, 0, 0), in mm |
//! | 56 | f64 | edge of a voxel, in mm |
//! | 64 | u32 | frame: 0 is a, 1 is b |
//! | 68 | 12 bytes | zero |
//! | 80 | nx·ny·nz × f32 | light intensity per voxel, ordered z, y, x (x fastest) |
//!
//! A mask:
//!
//! | offset | type | content |
//! |---|---|---|
//! | 0 | 8 bytes | magic `LFPIVMK1` |
//! | 8 | 8 bytes | zero |
//! | 16 | 3 × u32 | voxel counts nx, ny, nz |
//! | 28 | u32 | offset of the bits: 80 |
//! | 32 | 3 × f64 | position of the centre of voxel (0, 0, 0), in mm |
//! | 56 | f64 | edge of a voxel, in mm |
//! | 64 | 16 bytes | zero |
//! | 80 | nx·ny·nz bits, rounded up to bytes | 1 where a voxel is flow, ordered z, y, x (x fastest); the first eight voxels are the bits of the first byte, from the lowest |

use lfpiv_core::{
    model::VolumeMask,
    reconstruction::SparseVolume,
    velocimetry::{MeasuredParticle, VectorStatus, VelocityField},
};

use crate::archive::ShotResult;

/// Media type of binary responses.
pub const MEDIA_TYPE: &str = "application/octet-stream";
/// First bytes of a field; the last byte is the version of the layout.
pub const MAGIC: &[u8; 8] = b"LFPIVVF2";
/// First bytes of particles; the last byte is the version of the layout.
pub const PARTICLE_MAGIC: &[u8; 8] = b"LFPIVPA1";
/// First bytes of a volume; the last byte is the version of the layout.
pub const VOLUME_MAGIC: &[u8; 8] = b"LFPIVVO1";
/// First bytes of a mask; the last byte is the version of the layout.
pub const MASK_MAGIC: &[u8; 8] = b"LFPIVMK1";
/// Offset of the arrays.
pub const HEADER_BYTES: u32 = 80;

/// Bytes per vector in the arrays.
const VECTOR_BYTES: usize = 29;

/// Size of an encoded field in bytes.
pub fn field_bytes(field: &VelocityField) -> usize {
    HEADER_BYTES as usize + VECTOR_BYTES * field.grid.len()
}

/// Encodes a field as described in the module documentation.
pub fn encode(shot: u64, field: &VelocityField) -> Vec<u8> {
    let grid = &field.grid;
    let mut bytes = Vec::with_capacity(field_bytes(field) + 3);
    bytes.extend_from_slice(MAGIC);
    bytes.extend_from_slice(&shot.to_le_bytes());
    for count in grid.vectors {
        bytes.extend_from_slice(&(count as u32).to_le_bytes());
    }
    bytes.extend_from_slice(&HEADER_BYTES.to_le_bytes());
    for number in grid.first_mm.into_iter().chain([grid.spacing_mm, field.voxel_mm, field.dt_s]) {
        bytes.extend_from_slice(&number.to_le_bytes());
    }
    let with_value = |vectors: &[[f32; 3]], bytes: &mut Vec<u8>| {
        for vector in field.or_nan(vectors) {
            bytes.extend(vector.into_iter().flat_map(f32::to_le_bytes));
        }
    };
    with_value(&field.displacement_vox, &mut bytes);
    bytes.extend(field.peak_ratio.iter().flat_map(|ratio| ratio.to_le_bytes()));
    bytes.extend(field.status.iter().map(|status| match status {
        VectorStatus::Valid => 0,
        VectorStatus::Replaced => 1,
        VectorStatus::Invalid => 2,
        VectorStatus::Masked => 3,
    }));
    bytes.resize(bytes.len().next_multiple_of(4), 0);
    with_value(&field.uncertainty_vox, &mut bytes);
    bytes
}

/// Size of so many encoded particles, seen by so many cameras, in bytes.
pub fn particle_bytes(particles: usize, cameras: usize) -> usize {
    let with_flags = HEADER_BYTES as usize + (37 + 4 * cameras) * particles;
    with_flags.next_multiple_of(4) + 12 * particles
}

/// Encodes the particles of a result, none where none were placed, as described in the module documentation.
pub fn encode_particles(shot: u64, result: &ShotResult) -> Vec<u8> {
    let (field, cameras) = (&result.measured.field, result.cameras());
    let particles = result.measured.particles.as_deref().unwrap_or_default();
    let mut bytes = Vec::with_capacity(particle_bytes(particles.len(), cameras));
    bytes.extend_from_slice(PARTICLE_MAGIC);
    bytes.extend_from_slice(&shot.to_le_bytes());
    for number in [particles.len() as u32, cameras as u32, 0, HEADER_BYTES] {
        bytes.extend_from_slice(&number.to_le_bytes());
    }
    for number in [field.voxel_mm, field.dt_s] {
        bytes.extend_from_slice(&number.to_le_bytes());
    }
    bytes.resize(HEADER_BYTES as usize, 0);
    type Numbers = fn(&MeasuredParticle) -> [f32; 3];
    let triples: [Numbers; 3] =
        [|p| p.at_mm.map(|mm| mm as f32), |p| p.displacement_vox, |p| p.uncertainty_vox];
    for numbers in triples {
        bytes.extend(particles.iter().flat_map(numbers).flat_map(f32::to_le_bytes));
    }
    for particle in particles {
        bytes.extend(particle.light[..cameras].iter().flat_map(|light| light.to_le_bytes()));
    }
    bytes.extend(particles.iter().map(|particle| u8::from(particle.agrees)));
    bytes.resize(bytes.len().next_multiple_of(4), 0);
    let places = particles.iter().flat_map(|particle| particle.place_uncertainty_vox);
    bytes.extend(places.flat_map(f32::to_le_bytes));
    bytes
}

/// Size of an encoded volume in bytes.
pub fn volume_bytes(volume: &SparseVolume) -> usize {
    HEADER_BYTES as usize + volume.grid.len() * size_of::<f32>()
}

/// Encodes the volume of frame a (0) or b (1), including dark voxels, as described in the module
/// documentation.
pub fn encode_volume(shot: u64, frame: usize, volume: &SparseVolume) -> Vec<u8> {
    let grid = &volume.grid;
    let start = HEADER_BYTES as usize;
    let mut bytes = Vec::with_capacity(volume_bytes(volume));
    bytes.extend_from_slice(VOLUME_MAGIC);
    bytes.extend_from_slice(&shot.to_le_bytes());
    for count in grid.voxels {
        bytes.extend_from_slice(&(count as u32).to_le_bytes());
    }
    bytes.extend_from_slice(&HEADER_BYTES.to_le_bytes());
    for number in grid.centre_of([0; 3]).iter().chain([&grid.voxel_mm]) {
        bytes.extend_from_slice(&number.to_le_bytes());
    }
    bytes.extend_from_slice(&(frame as u32).to_le_bytes());
    bytes.resize(volume_bytes(volume), 0);
    for (&voxel, light) in volume.voxels.iter().zip(&volume.intensity) {
        let at = start + voxel as usize * size_of::<f32>();
        bytes[at..at + size_of::<f32>()].copy_from_slice(&light.to_le_bytes());
    }
    bytes
}

/// Size of an encoded mask in bytes.
pub fn mask_bytes(mask: &VolumeMask) -> usize {
    HEADER_BYTES as usize + mask.flow.len().div_ceil(8)
}

/// Encodes a mask as described in the module documentation.
pub fn encode_mask(mask: &VolumeMask) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(mask_bytes(mask));
    bytes.extend_from_slice(MASK_MAGIC);
    bytes.extend_from_slice(&[0; 8]);
    for count in mask.grid.voxels {
        bytes.extend_from_slice(&(count as u32).to_le_bytes());
    }
    bytes.extend_from_slice(&HEADER_BYTES.to_le_bytes());
    for number in mask.grid.centre_of([0; 3]).iter().chain([&mask.grid.voxel_mm]) {
        bytes.extend_from_slice(&number.to_le_bytes());
    }
    bytes.resize(HEADER_BYTES as usize, 0);
    let bits = |eight: &[bool]| {
        eight.iter().enumerate().fold(0, |byte, (n, flow)| byte | u8::from(*flow) << n)
    };
    bytes.extend(mask.flow.chunks(8).map(bits));
    bytes
}

#[cfg(test)]
mod tests {
    use lfpiv_core::model::VolumeGrid;

    use super::*;

    #[test]
    fn a_mask_has_a_bit_for_each_voxel() {
        let grid = VolumeGrid { voxels: [3, 3, 1], voxel_mm: 0.5, centre_mm: [1.0, 0.0, 0.0] };
        let flow = vec![true, false, false, true, true, false, false, false, true];
        let bytes = encode_mask(&VolumeMask { grid, flow });
        assert_eq!(bytes.len(), 82);
        assert_eq!(bytes[80..], [0b0001_1001, 1]);
        assert_eq!(bytes[..8], *MASK_MAGIC);
        assert_eq!(f64::from_le_bytes(bytes[32..40].try_into().unwrap()), 0.5);
    }
}
