//! A synthetic result for the tests of this room.

use lfpiv_core::velocimetry::{
    MeasuredParticle, PairResult, StageSeconds, VectorGrid, VectorStatus, VelocityField,
};

use super::{RawLevel, ShotResult, ShotTime};

/// A result in which all numbers differ; voxels of 0.1 mm, dt 100 µs.
pub(super) fn result(vectors: [usize; 3]) -> ShotResult {
    let grid = VectorGrid { vectors, first_mm: [-1.0, -2.0, -3.0], spacing_mm: 0.8 };
    let numbers = |scale: f32| -> Vec<f32> {
        (0..grid.len()).map(|index| scale * (1.0 + index as f32)).collect()
    };
    let triples = |scale: f32| -> Vec<[f32; 3]> {
        numbers(scale).into_iter().map(|n| [n, 2.0 * n, -n]).collect()
    };
    let cycle = [VectorStatus::Valid, VectorStatus::Replaced, VectorStatus::Invalid];
    // The last of those without a value is no flow.
    let status = |index: usize| match cycle[index % 3] {
        VectorStatus::Invalid if index + 3 >= grid.len() => VectorStatus::Masked,
        status => status,
    };
    let measured = PairResult {
        field: VelocityField {
            displacement_vox: triples(0.01),
            uncertainty_vox: triples(0.0003).into_iter().map(|t| t.map(f32::abs)).collect(),
            status: (0..grid.len()).map(status).collect(),
            peak_ratio: numbers(0.5),
            vorticity: triples(0.001),
            divergence: numbers(0.002),
            has_gradient: (0..grid.len()).map(|index| index % 3 != 2).collect(),
            voxel_mm: 0.1,
            dt_s: 1e-4,
            grid,
        },
        seconds: StageSeconds { decode_s: 1.0, reconstruct_s: 2.0, correlate_s: 3.0, judge_s: 4.0 },
        warnings: Vec::new(),
        model: Default::default(),
        fit: None,
        light: None,
        particles: None,
    };
    let time = ShotTime {
        utc_ns: 1_700_000_000_250_000_000,
        uncertainty_ns: 1_500_000,
        clock_synchronised: true,
    };
    ShotResult { measured, time: Some(time), raw: RawLevel::NotKept }
}

/// The same with so many particles, all different, and different from those of other shots.
pub(super) fn with_particles(shot: u64, count: usize) -> ShotResult {
    let mut result = result([4, 3, 2]);
    let particle = |n: usize| {
        let number = shot as f32 + 0.01 * n as f32;
        MeasuredParticle {
            at_mm: [0.1, -0.2, 0.3].map(|mm| mm * f64::from(number)),
            place_uncertainty_vox: [0.02, 0.01, 0.04].map(|vox| vox * (2.0 + number)),
            displacement_vox: [number, 2.0, -number],
            uncertainty_vox: [0.01, 0.02, 0.03].map(|vox| vox * (1.0 + number)),
            light: [100.0 + number, 200.0 + number],
            agrees: n % 3 != 1,
        }
    };
    result.measured.particles = Some((0..count).map(particle).collect());
    result
}
