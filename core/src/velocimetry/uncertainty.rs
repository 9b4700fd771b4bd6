//! Uncertainty of a displacement, from the light that contributes to its correlation peak.
//!
//! The correlation of a perfectly reconstructed and deformed pair is symmetric about its peak, voxel by voxel:
//! a(x) b(x + e) = a(x + e) b(x). The contribution of each part of the window to the asymmetry is therefore a
//! sample of the error, and the scatter of the contributions gives the variance of their sum (Wieneke,
//! "PIV uncertainty quantification from correlation statistics",
//! Meas. Sci. Technol. 26, 074002, 2015, extended to three dimensions). The peak position of the
//! three-point Gaussian fit follows from the asymmetry to first order.
//!
//! The scatter does not contain errors that a window's particles have in common. Errors of the solver extend over
//! several particles ([`SOLVER_ERROR_FACTOR`]). The window corrects only a part of a residual displacement that
//! varies within it, so [`UNCORRECTED_SHARE`] of the residual is added.

mod cells;

use super::{peak::log_curvature, raster::Image};
pub use cells::Cutouts;
use cells::{COMMON, Cells};

/// Share of the last pass's residual displacement that counts as uncorrected (docs/decisions.md, "Fitted
/// constants"). The response of a window of length L to a wave of length 4 L is sin(π/4)/(π/4) = 0.90 along one
/// axis, 0.81 along two.
const UNCORRECTED_SHARE: f32 = 0.19;

/// Ratio of a vector's error to the value from the scatter of its particles, due to errors of the solver. Without
/// it, intervals contain 46 to 49 % and 73 to 79 % of the errors instead of 68 % and 95 %, from 0.3 to 1 ppm,
/// with noise and with a dim camera (docs/decisions.md, "Fitted constants").
const SOLVER_ERROR_FACTOR: f32 = 1.6;

/// With fewer particles the scatter is unreliable, and the variance is at least that of a uniform distribution one
/// voxel wide, 1/12 (GUM 4.3.7).
const FEW_PARTICLES: f32 = 4.0;
const VOXEL_VARIANCE: f32 = 1.0 / 12.0;

/// Numerical error of single precision and the three-point fit, in voxels.
const NUMERICAL_FLOOR_VOX: f32 = 1e-3;

/// With fewer particles there is no scatter to estimate.
const LEAST_PARTICLES: f32 = 2.0;

/// Statistics of a window's correlation peak.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PeakStatistics {
    /// Variance of the peak position along x, y, z, in voxel².
    pub variance_vox2: [f32; 3],
    /// Effective number of particles: participation ratio of their contributions to the peak.
    pub particles: f32,
    /// Correlation coefficient of the two frames at the peak, −1 to 1.
    pub coefficient: f32,
}

impl PeakStatistics {
    /// Standard uncertainty of a displacement along x, y, z, in voxels, if the last pass added `residual_vox`;
    /// `None` with too few particles.
    ///
    /// The variance from n particles is that of Student's distribution with n − 1 degrees of freedom: (n − 1)/(n − 3)
    /// times the sample variance (JCGM 101, 6.4.9.2), which is n/(n − 1) times the mean square.
    pub fn uncertainty_vox(&self, residual_vox: [f32; 3]) -> Option<[f32; 3]> {
        if self.particles < LEAST_PARTICLES {
            return None;
        }
        let few = self.particles < FEW_PARTICLES;
        let n = self.particles.max(FEW_PARTICLES);
        Some(std::array::from_fn(|axis| {
            let random = SOLVER_ERROR_FACTOR * SOLVER_ERROR_FACTOR * self.variance_vox2[axis] * n
                / (n - 3.0);
            let random = if few { random.max(VOXEL_VARIANCE) } else { random };
            (random + (UNCORRECTED_SHARE * residual_vox[axis]).powi(2))
                .sqrt()
                .max(NUMERICAL_FLOOR_VOX)
        }))
    }

    /// [`Self::uncertainty_vox`], where the frames correlate to at least `least_coefficient`.
    pub fn trusted_vox(&self, residual_vox: [f32; 3], least_coefficient: f64) -> Option<[f32; 3]> {
        let agree = f64::from(self.coefficient) >= least_coefficient;
        agree.then(|| self.uncertainty_vox(residual_vox))?
    }

    /// Statistics of a window of edge `window` at `corner`, whose correlation a(x) b(x + s) peaks
    /// near `lag`. `None` if there is no peak.
    pub fn of(
        frames: [Image; 2],
        corner: [i64; 3],
        window: usize,
        lag: [i64; 3],
        cutouts: &mut Cutouts,
    ) -> Option<Self> {
        let cells = Cells::of(frames, corner, window, lag, cutouts);
        let total = |n: usize| cells.sums.iter().map(|cell| f64::from(cell[n])).sum::<f64>();
        let common = total(COMMON);
        let mut influence = vec![[0.0f32; 4]; cells.sums.len()];
        for axis in 0..3 {
            // C(1) and C(-1), with as many pairs of voxels as C(0).
            let weight = cells.pairs[0] / cells.pairs[1 + axis].max(1.0);
            let Influence { mean, scale } =
                Influence::along(total(axis), total(3 + axis), common, weight)?;
            for (influence, cell) in influence.iter_mut().zip(&cells.sums) {
                let excess = f64::from(cell[axis]) - mean * f64::from(cell[3 + axis]);
                influence[axis] = (excess * scale) as f32;
            }
        }
        for (influence, cell) in influence.iter_mut().zip(&cells.sums) {
            influence[3] = (f64::from(cell[COMMON]) / common) as f32;
        }
        let spread = clustered_squares(&influence, cells.counts);
        // Share of the window within reach of a cell: by chance that share of the other particles counts as the
        // same one. The variance of contributions that sum to zero is reduced by the same share.
        let chance = share_within_reach(cells.counts);
        Some(Self {
            variance_vox2: std::array::from_fn(|axis| spread[axis] / (1.0 - chance).max(0.1)),
            particles: 1.0 / (spread[3] - chance).max(1.0 / MOST_PARTICLES),
            coefficient: coefficient(common, cells.energy),
        })
    }
}

/// Influence of a part of a window on the peak position along an axis: an asymmetry A with a symmetric part Y
/// shifts it by (A − mean · Y) · scale.
pub struct Influence {
    /// Ratio of the whole window's asymmetry to its symmetric part.
    pub mean: f64,
    /// In voxels.
    pub scale: f64,
}

impl Influence {
    /// From the whole window's asymmetry C(1) − C(−1), symmetric part C(1) + C(−1), both times `weight`,
    /// and C(0). `None` if these have no peak.
    ///
    /// The shift is (ln C(1) − ln C(−1)) / (2 curvature), to first order the asymmetry divided by the symmetric
    /// part and the curvature.
    pub fn along(asymmetry: f64, symmetric: f64, common: f64, weight: f64) -> Option<Self> {
        let [above, below] =
            [symmetric + asymmetry, symmetric - asymmetry].map(|sum| weight * sum / 2.0);
        let curvature = log_curvature(below, common, above)?;
        Some(Self { mean: asymmetry / symmetric, scale: 1.0 / (symmetric * curvature) })
    }
}

/// Correlation coefficient of two frames: Σ a b over the root of Σ a² Σ b².
pub fn coefficient(common: f64, [energy_a, energy_b]: [f64; 2]) -> f32 {
    (common / (energy_a * energy_b).sqrt()) as f32
}

/// Upper limit of the effective number of particles.
pub const MOST_PARTICLES: f32 = 1000.0;

/// Variance of the sum of correlated contributions: the sum of each times itself and its neighbours, beyond which
/// they are independent. At least that of independent contributions.
fn clustered_squares(values: &[[f32; 4]], counts: [usize; 3]) -> [f32; 4] {
    let mut around = values.to_vec();
    for (axis, stride) in [1, counts[0], counts[0] * counts[1]].into_iter().enumerate() {
        let from = around.clone();
        for (index, sum) in around.iter_mut().enumerate() {
            let place = index / stride % counts[axis];
            let below = if place > 0 { from[index - stride] } else { [0.0; 4] };
            let above = if place + 1 < counts[axis] { from[index + stride] } else { [0.0; 4] };
            for ((sum, below), above) in sum.iter_mut().zip(below).zip(above) {
                *sum += below + above;
            }
        }
    }
    std::array::from_fn(|n| {
        let (mut correlated, mut independent) = (0.0f64, 0.0f64);
        for (value, sum) in values.iter().zip(&around) {
            correlated += f64::from(value[n] * sum[n]);
            independent += f64::from(value[n] * value[n]);
        }
        correlated.max(independent) as f32
    })
}

/// Mean share of all cells that [`clustered_squares`] joins to one.
fn share_within_reach(counts: [usize; 3]) -> f32 {
    counts.map(|n| (3.0 - 2.0 / n as f32).min(n as f32) / n as f32).iter().product()
}

#[cfg(test)]
mod tests;
