//! How many particles were placed, and how well.

use std::collections::HashMap;

use lfpiv_core::{statistics::median, velocimetry::MeasuredParticle};
use lfpiv_sim::{Tracer, Truth};
use nalgebra::Point3;

use crate::case::Setting;

/// A particle counts that has this share of the median brightness or more in both frames.
const LEAST_BRIGHTNESS: f64 = 0.3;

/// It is found when a valid particle is so near to it, in voxels ...
const FOUND_VOX: f64 = 0.2;

/// ... and a valid particle is false when none is so near. Displacements are compared up to it.
const MATCHED_VOX: f64 = 0.5;

/// A camera's image of a particle so near to its focal plane is flat, in mm.
const NEAR_FOCUS_MM: f64 = 0.8;

/// The valid particles of a shot against those that made its images, in the middle of the pair.
#[derive(Debug, Clone)]
pub struct ParticleScore {
    /// Share of the counted particles that were found: all, those further than 0.8 mm from every
    /// camera's focal plane, and those nearer to one; `None` where there are none.
    pub found: [Option<f64>; 3],
    /// Share of the valid particles that are false.
    pub wrong: f64,
    /// Median and mean |error| of the displacement's components, over matched particles, in voxels.
    pub error_vox: [f64; 2],
    /// Shares of these components within one and within 1.96 stated standard uncertainties.
    pub covered: [f64; 2],
}

impl ParticleScore {
    /// Of a setting's shot.
    pub fn of(measured: &[MeasuredParticle], truth: &Truth, setting: &Setting) -> Self {
        let volume = &setting.config.volume.grid();
        let voxel_mm = volume.voxel_mm;
        let inside = |at: &[f64; 3]| {
            (0..3).all(|axis| {
                let half = volume.voxels[axis] as f64 * voxel_mm / 2.0;
                (at[axis] - volume.centre_mm[axis]).abs() <= half
            })
        };
        let lit = lit_in_both(truth);
        let valid: Vec<&MeasuredParticle> =
            measured.iter().filter(|one| one.agrees && inside(&one.at_mm)).collect();
        let places: Vec<[f64; 3]> = lit.iter().map(|particle| middle_mm(particle)).collect();
        let found: Vec<[f64; 3]> = valid.iter().map(|one| one.at_mm).collect();
        let links = one_to_one(&found, &places, MATCHED_VOX * voxel_mm);
        let mut found_vox = vec![f64::INFINITY; lit.len()];
        for &(_, particle, apart_mm) in &links {
            found_vox[particle] = apart_mm / voxel_mm;
        }
        let near_focus = |at: &[f64; 3]| {
            let depth_mm = |pose: &lfpiv_hw::Pose| pose.to_camera(&Point3::from(*at)).depth_mm;
            setting.config.poses().iter().any(|pose| depth_mm(pose).abs() < NEAR_FOCUS_MM)
        };
        let counted: Vec<usize> = (0..lit.len()).filter(|&n| inside(&places[n])).collect();
        let share = |pick: &dyn Fn(usize) -> bool| {
            let of: Vec<usize> = counted.iter().copied().filter(|&n| pick(n)).collect();
            let found = of.iter().filter(|&&n| found_vox[n] <= FOUND_VOX).count();
            (!of.is_empty()).then(|| found as f64 / of.len() as f64)
        };
        let (mut errors, mut within) = (Vec::new(), [0usize; 2]);
        for &(one, particle, _) in &links {
            let MeasuredParticle { displacement_vox, uncertainty_vox, .. } = valid[one];
            for axis in 0..3 {
                let moved_vox = displacement_mm(lit[particle])[axis] / voxel_mm;
                let error = (f64::from(displacement_vox[axis]) - moved_vox).abs();
                errors.push(error);
                for (within, widths) in within.iter_mut().zip([1.0, 1.96]) {
                    *within += usize::from(error <= widths * f64::from(uncertainty_vox[axis]));
                }
            }
        }
        let count = errors.len().max(1) as f64;
        let median = median(errors.iter().copied()).unwrap_or_default();
        Self {
            found: [
                share(&|_| true),
                share(&|n| !near_focus(&places[n])),
                share(&|n| near_focus(&places[n])),
            ],
            wrong: (valid.len() - links.len()) as f64 / valid.len().max(1) as f64,
            error_vox: [median, errors.iter().sum::<f64>() / count],
            covered: within.map(|within| within as f64 / count),
        }
    }
}

/// The particles bright enough that the light sheet holds in both frames.
fn lit_in_both(truth: &Truth) -> Vec<&Tracer> {
    let usual = median(truth.particles.iter().map(|p| p.intensity)).unwrap_or(0.0);
    let least = LEAST_BRIGHTNESS * usual;
    let lit = |p: &&Tracer| p.visible_a && p.visible_b && p.intensity >= least;
    truth.particles.iter().filter(lit).collect()
}

fn middle_mm(particle: &Tracer) -> [f64; 3] {
    std::array::from_fn(|axis| (particle.a_mm[axis] + particle.b_mm[axis]) / 2.0)
}

fn displacement_mm(particle: &Tracer) -> [f64; 3] {
    std::array::from_fn(|axis| particle.b_mm[axis] - particle.a_mm[axis])
}

/// Links of points of both lists, the nearest first, each point in one link at most: their numbers
/// and how far they are apart.
fn one_to_one(a: &[[f64; 3]], b: &[[f64; 3]], reach: f64) -> Vec<(usize, usize, f64)> {
    let cell = |at: &[f64; 3]| at.map(|x| (x / reach).floor() as i64);
    let mut cells: HashMap<[i64; 3], Vec<usize>> = HashMap::new();
    for (n, at) in b.iter().enumerate() {
        cells.entry(cell(at)).or_default().push(n);
    }
    let mut links = Vec::new();
    for (n, at) in a.iter().enumerate() {
        let [x, y, z] = cell(at);
        for near in (0..27).map(|m| [x + m % 3 - 1, y + m / 3 % 3 - 1, z + m / 9 - 1]) {
            for &other in cells.get(&near).into_iter().flatten() {
                let square: f64 = (0..3).map(|axis| (at[axis] - b[other][axis]).powi(2)).sum();
                if square.sqrt() <= reach {
                    links.push((n, other, square.sqrt()));
                }
            }
        }
    }
    links.sort_by(|one, other| {
        one.2.total_cmp(&other.2).then((one.0, one.1).cmp(&(other.0, other.1)))
    });
    let (mut taken_a, mut taken_b) = (vec![false; a.len()], vec![false; b.len()]);
    links.retain(|&(n, other, _)| {
        let free = !taken_a[n] && !taken_b[other];
        taken_a[n] |= free;
        taken_b[other] |= free;
        free
    });
    links
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_linked_once_and_to_their_nearest() {
        let a = [[0.0, 0.0, 0.0], [0.3, 0.0, 0.0], [5.0, 0.0, 0.0]];
        let b = [[0.2, 0.0, 0.0], [-0.4, 0.0, 0.0]];
        let links = one_to_one(&a, &b, 0.5);
        let numbers: Vec<(usize, usize)> = links.iter().map(|link| (link.0, link.1)).collect();
        assert_eq!(numbers, [(1, 0), (0, 1)]);
    }
}
