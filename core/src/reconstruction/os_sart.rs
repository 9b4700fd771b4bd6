//! The additive update of SART, OS-SART and PR-SART (paper, Eq. 2) on active voxels.
//!
//! E_j ← max(0, E_j + μ Σ_{i∈N_β} w_ji (I_i − p_i)/(r_i + β_i/ē) / Σ_{i∈N_β} w_ji)
//!
//! with p_i = Σ_m w_mi E_m and the row sums r_i = Σ_m w_mi over active voxels m only: with sums over the whole
//! volume, most of a correction would go to dark voxels. β_i is the noise of a dark pixel and ē the light of a
//! particle in a voxel that it fills. A pixel with so small a row sum that the voxels' light would be within
//! the noise has little weight. Without noise weighting β is 0 and this is Eq. 2.

use super::{pass::Update, sart::MIN_SUM};

/// Light of an active voxel after a correction to zero, in counts, so that later views can increase it. Below any
/// measured light, and not denormal.
pub const DARK: f32 = 1e-20;

/// Parameters of the additive update.
#[derive(Debug, Clone, PartialEq)]
pub struct OsSart {
    /// Relaxation factor μ, between 0 and 2.
    pub relaxation: f32,
    /// β/ē of each camera.
    pub noise_share: Vec<f32>,
}

impl Update for OsSart {
    const NEEDS_SUMS: bool = true;

    fn correction(&self, camera: usize) -> impl Fn(f32, f32, f32) -> f32 {
        let noise_share = self.noise_share[camera];
        move |measured, projected, row_sum| {
            if row_sum >= MIN_SUM { (measured - projected) / (row_sum + noise_share) } else { 0.0 }
        }
    }

    fn update(&self, light: f32, back_projected: f32, column_sum: f32, _: usize) -> f32 {
        let step = if column_sum >= MIN_SUM { self.relaxation / column_sum } else { 0.0 };
        (light + step * back_projected).max(DARK)
    }
}

#[cfg(test)]
mod tests;
