//! Single particles, followed from frame to frame: what correlation leaves unsaid.
//!
//! A correlation peak is the mean of a window, in which light that reconstruction has put in the
//! wrong place counts as any other. Once it is known to a fraction of a voxel where the light goes,
//! most particles of one frame can be told in the other, and each is a measurement of its own, at its
//! own place. The field that follows most of them (`fit`) resolves more than a window and is not drawn
//! aside by the few that are wrong.

mod fit;
mod pairs;
mod particles;
mod samples;
mod spline;
mod variance;

pub use self::particles::{Particle, particles};
use self::{
    fit::Fit,
    pairs::{FARTHEST_VOX, pairs},
    samples::Samples,
    spline::Spline,
};
use super::{cloud::PointCloud, lattice::Lattice};

/// Particles are at last looked for so near to where the field expects them, in voxels: some standard
/// deviations of a reconstructed particle's place, and less than the distance to its neighbours.
const NEAREST_VOX: f32 = 0.6;

/// Most rounds in which particles are looked for far from where the field of the round before expects
/// them.
const FAR_ROUNDS: usize = 5;

/// The field is settled when no more than a twentieth of its components move further than this, in
/// voxels: its uncertainty on the bench.
const SETTLED_VOX: f32 = 0.015;

/// Coarsest voxels, in those of the configuration, whose light tells where in them a particle is: it is
/// drawn from two or more along each axis.
const COARSEST_GRAIN_VOX: f32 = 0.5;

/// Whether the light of `cloud` is fine enough for single particles to be followed.
pub fn is_fine(cloud: &PointCloud) -> bool {
    cloud.grain_vox <= COARSEST_GRAIN_VOX
}

/// A displacement field after particles were followed, and its standard uncertainty, in voxels.
#[derive(Debug, Clone, PartialEq)]
pub struct Refined {
    /// The vectors.
    pub field: Lattice,
    /// Along x, y, z, for every node; greater than zero. `None` where neither a vector nor a particle
    /// says anything.
    pub uncertainty_vox: Vec<Option<[f32; 3]>>,
    /// Nodes about which particles by themselves measure the vector.
    pub by_particles: Vec<bool>,
}

/// The field that the particles of both frames follow, near the correlation's `field`, whose
/// standard uncertainty is `uncertainty_vox`, `None` where it has measured nothing. At least three nodes
/// along every axis.
pub fn follow(
    field: &Lattice,
    uncertainty_vox: &[Option<[f32; 3]>],
    frames: [&PointCloud; 2],
) -> Refined {
    let [a, b] = frames;
    let (a, b) = rayon::join(|| particles(a), || particles(b));
    let mut spline = Spline::through(field);
    let mut fit = Fit::new(field, uncertainty_vox, spline.layout);
    for _ in 0..FAR_ROUNDS {
        let before = spline.on_nodes(field);
        let pairs = pairs(&spline, [&a, &b], FARTHEST_VOX);
        let samples = Samples::new(field.nodes, &spline, &pairs);
        fit.adjust(&mut spline, &samples);
        if has_settled(&before, &spline.on_nodes(field)) {
            break;
        }
    }
    let pairs = pairs(&spline, [&a, &b], NEAREST_VOX);
    let samples = Samples::new(field.nodes, &spline, &pairs);
    fit.adjust(&mut spline, &samples);
    Refined {
        field: spline.on_nodes(field),
        uncertainty_vox: fit.uncertainty_vox(),
        by_particles: samples.agree(&spline, NEAREST_VOX),
    }
}

/// Whether a field is that of the round before but for what is left to its uncertainty.
fn has_settled(before: &Lattice, now: &Lattice) -> bool {
    let [before, now] = [before, now].map(|field| field.values.as_flattened());
    let moved = before.iter().zip(now).filter(|(a, b)| (**a - **b).abs() > SETTLED_VOX).count();
    20 * moved <= now.len()
}

#[cfg(test)]
mod tests;
