//! A result for tests.

use lfpiv_core::velocimetry::{PairResult, StageSeconds, VectorGrid, VectorStatus, VelocityField};

/// One vector.
pub(super) fn result() -> PairResult {
    PairResult {
        field: VelocityField {
            grid: VectorGrid { vectors: [1, 1, 1], first_mm: [0.0; 3], spacing_mm: 0.8 },
            displacement_vox: vec![[1.0, 2.0, 3.0]],
            uncertainty_vox: vec![[0.1; 3]],
            status: vec![VectorStatus::Valid],
            peak_ratio: vec![2.0],
            vorticity: vec![[0.0; 3]],
            divergence: vec![0.0],
            has_gradient: vec![true],
            voxel_mm: 0.1,
            dt_s: 1e-4,
        },
        seconds: StageSeconds::default(),
        warnings: Vec::new(),
        model: Default::default(),
        fit: None,
        light: None,
        particles: None,
    }
}
