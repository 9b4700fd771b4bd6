//! How far a displacement can be trusted, from the light under its correlation peak.
//!
//! A perfectly reconstructed and deformed pair gives a correlation that is symmetric about its
//! peak, voxel by voxel: a(x) b(x + e) = a(x + e) b(x). What each part of the window contributes to
//! the asymmetry is therefore a sample of the error, and the spread of the contributions gives the
//! variance of their sum (Wieneke, "PIV uncertainty quantification from correlation statistics",
//! Meas. Sci. Technol. 26, 074002, 2015, carried over to three dimensions). The peak's place by the
//! three-point Gaussian fit follows to first order from the asymmetry.
//!
//! What all of a window's particles have in common is not in their spread: the solver's errors reach
//! over several particles ([`SOLVER_ERROR_FACTOR`]), and the window answers a residual displacement that varies
//! inside it only in part. [`UNCORRECTED_SHARE`] of the residual is added for it.

mod cells;

use super::{peak::log_curvature, raster::Image};
pub use cells::Cutouts;
use cells::{COMMON, Cells};

/// Share of the last pass's residual displacement that is taken for unanswered (docs/decisions.md,
/// "Fitted constants"). A window of length
/// L answers a wave of length 4 L along one axis to sin(π/4)/(π/4) = 0.90, along two to 0.81.
const UNCORRECTED_SHARE: f32 = 0.19;

/// A vector's error over the spread of its particles: intervals of that spread alone hold 46 to 49 %
/// and 73 to 79 % of reconstructed vectors instead of 68 % and 95 %, alike from 0.3 to 1 ppm, under
/// noise and with a dim camera (docs/decisions.md, "Fitted constants").
const SOLVER_ERROR_FACTOR: f32 = 1.6;

/// Below this many particles their spread says little, and a displacement counts as known to a
/// voxel at best: variance 1/12 (GUM 4.3.7).
const FEW_PARTICLES: f32 = 4.0;
const VOXEL_VARIANCE: f32 = 1.0 / 12.0;

/// What single precision and the three-point fit resolve, in voxels.
const NUMERICAL_FLOOR_VOX: f32 = 1e-3;

/// One particle cannot confirm itself: with fewer than two nothing is known.
const LEAST_PARTICLES: f32 = 2.0;

/// What the light in a window says about the place of its correlation peak.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PeakStatistics {
    /// Variance of the peak's place along x, y, z, in voxel².
    pub variance_vox2: [f32; 3],
    /// Equally bright particles that would share the peak's light as evenly (participation ratio).
    pub particles: f32,
    /// Correlation coefficient of the two frames at the peak, −1 to 1.
    pub coefficient: f32,
}

impl PeakStatistics {
    /// Standard uncertainty of a displacement along x, y, z, in voxels, when the last pass still
    /// had to add `residual_vox`; `None` when too few particles take part to tell.
    ///
    /// The variance from n particles is that of Student's distribution with n − 1 degrees of
    /// freedom, (n − 1)/(n − 3) times the sample's (JCGM 101, 6.4.9.2), which is itself n/(n − 1)
    /// times the mean square.
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
    /// near `lag`. `None` where the light has no peak there.
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
        // So much of the window lies within reach of a cell: by chance alone that share of the
        // other particles is taken for the same one. Contributions that sum to zero lose as much.
        let chance = share_within_reach(cells.counts);
        Some(Self {
            variance_vox2: std::array::from_fn(|axis| spread[axis] / (1.0 - chance).max(0.1)),
            particles: 1.0 / (spread[3] - chance).max(1.0 / MOST_PARTICLES),
            coefficient: coefficient(common, cells.energy),
        })
    }
}

/// How a part of a window moves the correlation peak along an axis: an asymmetry A beside a symmetric
/// part Y by (A − mean · Y) · scale.
pub struct Influence {
    /// Asymmetry of the whole window over its symmetric part.
    pub mean: f64,
    /// In voxels.
    pub scale: f64,
}

impl Influence {
    /// From the whole window's asymmetry C(1) − C(−1), symmetric part C(1) + C(−1), both times `weight`,
    /// and C(0). `None` where these make no peak.
    ///
    /// The shift is (ln C(1) − ln C(−1)) / 2 curvature, to first order the asymmetry over the symmetric
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

/// More particles than this are not told from infinitely many.
pub const MOST_PARTICLES: f32 = 1000.0;

/// Variance of the sum of correlated contributions: each times the sum of itself and its
/// neighbours, beyond which they are independent. Never less than if all were.
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
