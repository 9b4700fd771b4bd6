//! Particles as intensity peaks in a cloud of points.

use rayon::prelude::*;

use super::super::cloud::PointCloud;
use crate::{particles::Neighbours, statistics::median};

/// Light within this distance of an intensity peak's maximum belongs to it, in voxels. This and the two below:
/// docs/decisions.md, "Fitted constants".
const REACH_VOX: f32 = 0.8;

/// Standard deviation of the Gaussian kernel for the local brightness, in voxels: the width of a reconstructed
/// particle.
const WIDTH_VOX: f32 = 0.45;

/// Least light of a particle, relative to the median peak. Fainter peaks are artefacts of reconstruction.
const LEAST_PEAK_LIGHT: f32 = 0.1;

/// Rounds that assign points to their nearest peak and move peaks to the centres of their points.
const ROUNDS: usize = 3;

/// A particle: an intensity peak, in voxels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightPeak {
    /// Its centre.
    pub at_vox: [f32; 3],
    /// Variance of its light along x, y, z.
    pub spread_vox2: [f32; 3],
    /// Sum of its light, in the unit of the cloud.
    pub light: f32,
}

/// The particles in a cloud.
pub fn particles(cloud: &PointCloud) -> Vec<LightPeak> {
    let points = Neighbours::new(&cloud.position_vox, REACH_VOX);
    let brightness: Vec<f32> = cloud
        .position_vox
        .par_iter()
        .map(|&at| {
            let mut sum = 0.0;
            points.visit(at, |other, square| {
                sum += cloud.light[other] * (-square / (2.0 * WIDTH_VOX * WIDTH_VOX)).exp();
            });
            sum
        })
        .collect();
    let brightest: Vec<bool> = (0..brightness.len())
        .into_par_iter()
        .map(|n| {
            let mut brightest = brightness[n] > 0.0;
            points.visit(cloud.position_vox[n], |other, _| {
                let brighter = brightness[other] > brightness[n];
                let earlier = brightness[other] == brightness[n] && other < n;
                brightest &= !(brighter || earlier);
            });
            brightest
        })
        .collect();
    let mut peaks: Vec<[f32; 3]> =
        (0..brightest.len()).filter(|&n| brightest[n]).map(|n| cloud.position_vox[n]).collect();
    if peaks.is_empty() {
        return Vec::new();
    }
    for _ in 1..ROUNDS {
        peaks = gathered(cloud, &peaks).into_iter().map(|particle| particle.at_vox).collect();
    }
    let mut found = gathered(cloud, &peaks);
    let median = median(found.iter().map(|particle| particle.light)).unwrap_or_default();
    let least = LEAST_PEAK_LIGHT * median as f32;
    found.retain(|particle| particle.light > least);
    found
}

/// Moments of the light that is nearest to each peak. Peaks without light keep their position.
fn gathered(cloud: &PointCloud, peaks: &[[f32; 3]]) -> Vec<LightPeak> {
    let neighbours = Neighbours::new(peaks, REACH_VOX);
    let nearest: Vec<Option<usize>> =
        cloud.position_vox.par_iter().map(|&at| neighbours.nearest(at, REACH_VOX)).collect();
    let mut moments = vec![Moments::default(); peaks.len()];
    for (n, peak) in nearest.into_iter().enumerate() {
        let Some(peak) = peak else { continue };
        let at = cloud.position_vox[n];
        let from_peak = std::array::from_fn(|axis| f64::from(at[axis] - peaks[peak][axis]));
        moments[peak].add(from_peak, f64::from(cloud.light[n]));
    }
    moments.iter().zip(peaks).map(|(moments, &peak)| moments.particle(peak)).collect()
}

/// Sums over the light of a peak, with positions relative to its previous one.
#[derive(Debug, Clone, Copy, Default)]
struct Moments {
    light: f64,
    place: [f64; 3],
    square: [f64; 3],
    root: f64,
    place_by_root: [f64; 3],
}

impl Moments {
    fn add(&mut self, at: [f64; 3], light: f64) {
        let root = light.sqrt();
        self.light += light;
        self.root += root;
        for (axis, at) in at.into_iter().enumerate() {
            self.place[axis] += light * at;
            self.square[axis] += light * at * at;
            self.place_by_root[axis] += root * at;
        }
    }

    /// The particle with these moments.
    ///
    /// Its centre weights points by the root of their light, because a multiplicative solver overestimates the
    /// voxel nearest to a particle and underestimates its neighbours.
    fn particle(&self, peak: [f32; 3]) -> LightPeak {
        if self.light <= 0.0 {
            return LightPeak { at_vox: peak, spread_vox2: [0.0; 3], light: 0.0 };
        }
        let variance = |axis: usize| {
            let mean = self.place[axis] / self.light;
            (self.square[axis] / self.light - mean * mean).max(0.0) as f32
        };
        let centre = |axis: usize| peak[axis] + (self.place_by_root[axis] / self.root) as f32;
        LightPeak {
            at_vox: std::array::from_fn(centre),
            spread_vox2: std::array::from_fn(variance),
            light: self.light as f32,
        }
    }
}
