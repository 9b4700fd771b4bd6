//! A measured field against the flow, and what the true particles give.

use lfpiv_core::{
    model::VolumeGrid,
    velocimetry::{Interrogation, PointCloud, VectorStatus, VelocimetrySettings, VelocityField},
};
use lfpiv_sim::{Flow, FrameOfPair, Truth};

/// Difference of every vector from the flow at its place, in voxels along x, y, z.
pub fn errors_vox(field: &VelocityField, flow: &Flow) -> Vec<[f64; 3]> {
    let error = |(n, measured): (usize, &[f32; 3])| {
        let moved_mm = flow.displacement_mm(field.grid.position_mm(n), field.dt_s);
        std::array::from_fn(|axis| f64::from(measured[axis]) - moved_mm[axis] / field.voxel_mm)
    };
    field.displacement_vox.iter().enumerate().map(error).collect()
}

/// Mean |error| of each component over all vectors, valid or not, in voxels.
pub fn mean_error_vox(field: &VelocityField, flow: &Flow) -> [f64; 3] {
    let errors = errors_vox(field, flow);
    std::array::from_fn(|axis| {
        errors.iter().map(|error| error[axis].abs()).sum::<f64>() / errors.len() as f64
    })
}

/// The fields that the true particles give: what images and reconstruction add to.
pub struct TrueParticles {
    /// By the configured windows alone.
    pub by_windows: VelocityField,
    /// As configured, where single particles are followed.
    pub followed: VelocityField,
}

/// The true particles measured without images.
pub fn true_particles(
    volume: &VolumeGrid,
    settings: &VelocimetrySettings,
    truth: &Truth,
) -> TrueParticles {
    let interrogation = Interrogation::new(volume, settings.margin_vox(), settings);
    let grid = interrogation.cloud_grid();
    let cloud = |frame| {
        let lit = truth.particles.iter().filter_map(|p| Some((p.lit_mm(frame)?, p.intensity)));
        PointCloud::from_particles(&lit.collect::<Vec<_>>(), &grid)
    };
    let [a, b] = [FrameOfPair::A, FrameOfPair::B].map(cloud);
    TrueParticles {
        by_windows: interrogation.measure_by_windows(&a, &b, truth.dt_s),
        followed: interrogation.measure(&a, &b, truth.dt_s),
    }
}

/// How far a field is from the truth.
pub struct Deviation {
    /// Mean |error| along x, y, z over all vectors, in voxels.
    pub mean_vox: [f64; 3],
    /// Share of all components within 0.3 voxels; those of vectors that are not valid are misses.
    pub within: f64,
}

impl Deviation {
    /// Compares every vector with the flow.
    pub fn of(field: &VelocityField, flow: &Flow) -> Self {
        let errors = errors_vox(field, flow);
        let hits = errors.iter().zip(&field.status).map(|(error, status)| {
            let valid = *status == VectorStatus::Valid;
            error.iter().filter(|e| valid && e.abs() <= 0.3).count()
        });
        let within = hits.sum::<usize>() as f64 / (3 * errors.len()) as f64;
        Self { mean_vox: mean_error_vox(field, flow), within }
    }

    /// On one line.
    pub fn print(&self, name: &str) {
        let ([x, y, z], within) = (self.mean_vox, 100.0 * self.within);
        println!("{name}: mean |error| {x:.4} {y:.4} {z:.4} voxels, {within:.1} % within 0.3");
    }
}
