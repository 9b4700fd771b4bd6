//! The multiplicative update.
//!
//! Every voxel's intensity is multiplied by the mean ratio of measured to projected light over the
//! pixels that it contributes to in one subset of views:
//!
//! E_j ← E_j (1 + μ/S Σ_v Σ_i w_ji ((I_i + β)/(p_i + β) − 1)),  p_i = Σ_m w_mi E_m
//!
//! with S views in the subset. The arithmetic mean of ratios is that of ordered-subset expectation maximisation
//! (Hudson and Larkin 1994); MART uses a product instead. In a product, a single dark pixel would remove a
//! voxel, and a particle that fills its voxel only partly has such pixels in many views. β is the noise of a
//! dark pixel: if measured and projected light are both within the noise, their ratio tends to 1.

use super::pass::Update;

/// Parameters of OS-MART.
#[derive(Debug, Clone, PartialEq)]
pub struct OsMart {
    /// Relaxation factor μ, at most 1 so that intensities stay positive.
    pub relaxation: f32,
    /// β of each camera, in counts.
    pub noise_counts: Vec<f32>,
}

impl Update for OsMart {
    const NEEDS_SUMS: bool = false;

    fn correction(&self, camera: usize) -> impl Fn(f32, f32, f32) -> f32 {
        let noise = self.noise_counts[camera];
        move |measured, projected, _| (measured.max(0.0) + noise) / (projected + noise) - 1.0
    }

    fn update(&self, light: f32, back_projected: f32, _: f32, views: usize) -> f32 {
        let step = self.relaxation / views as f32;
        light * (1.0 + step * back_projected).max(0.0)
    }
}
