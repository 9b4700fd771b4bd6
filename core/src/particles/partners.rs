//! Both frames support each other: where the flow takes the particles of one, those of the other should be.

use rayon::prelude::*;

use super::{
    fit::FrameFit,
    flow::{Flow, middle},
    neighbours::Neighbours,
    normal::{CAMERAS, LightPrior, Particle},
};
use crate::model::{PointCamera, PointFootprint};

/// Initial light of a proposed particle, relative to that of its partner, where the frame has no particle. The fit
/// increases the light of a true one.
const STARTING_SHARE: f64 = 0.3;

/// Least light of the residual at a proposed particle, relative to the typical light.
const LEAST_PROPOSAL_LIGHT: f64 = 0.1;

/// Mean number of particles of the other frame within the radius of the wider search by chance.
const CHANCE_PARTNERS: f32 = 0.01;

/// Largest radius of the wider search, in voxels.
const LONGEST_REACH_VOX: f32 = 3.0;

/// Volume of a sphere of radius 1.
pub const UNIT_SPHERE: f32 = 4.0 / 3.0 * std::f32::consts::PI;

/// The particles of both frames at mid-pair, and their pairs.
pub struct Partners {
    /// Mid-pair positions, in voxels.
    pub middles: [Vec<[f32; 3]>; 2],
    /// Partner in frame b of each particle of frame a, and vice versa.
    pub partners: [Vec<Option<usize>>; 2],
}

impl Partners {
    /// Mutual nearest neighbours at mid-pair, no further apart than `reach_vox`.
    pub fn new(frames: [&[Particle]; 2], flow: &dyn Flow, reach_vox: f64, voxel_mm: f64) -> Self {
        let middles = [0, 1].map(|frame| {
            let sign = [1.0, -1.0][frame];
            let in_voxels =
                |p: &Particle| middle(p.at_mm, flow, sign).map(|mm| (mm / voxel_mm) as f32);
            frames[frame].par_iter().map(in_voxels).collect::<Vec<_>>()
        });
        let partners = mutual(&middles, reach_vox as f32);
        Self { middles, partners }
    }

    /// Pairs the remaining particles within a larger radius, for regions where the flow is less accurate. The radius
    /// increases as their number decreases. `is_eligible` (frame, particle) selects the particles.
    pub fn widened(mut self, is_eligible: impl Fn(usize, usize) -> bool) -> Self {
        let alone = [0, 1].map(|frame| -> Vec<usize> {
            self.alone(frame).filter(|&n| is_eligible(frame, n)).collect()
        });
        let places =
            [0, 1].map(|f| alone[f].iter().map(|&n| self.middles[f][n]).collect::<Vec<_>>());
        let [a, _] = mutual(&places, self.longer_reach(&places));
        for (n, partner) in a.into_iter().enumerate() {
            if let Some(partner) = partner {
                let (a, b) = (alone[0][n], alone[1][partner]);
                self.partners[0][a] = Some(b);
                self.partners[1][b] = Some(a);
            }
        }
        self
    }

    /// The radius, in voxels, within which there are [`CHANCE_PARTNERS`] of these positions on average.
    fn longer_reach(&self, places: &[Vec<[f32; 3]>; 2]) -> f32 {
        let most = places.iter().map(Vec::len).max().unwrap_or_default().max(1) as f32;
        (CHANCE_PARTNERS * self.volume_vox3() / (most * UNIT_SPHERE)).cbrt().min(LONGEST_REACH_VOX)
    }

    /// Volume of the box around all particles.
    pub fn volume_vox3(&self) -> f32 {
        let all = || self.middles.iter().flatten();
        let span = |axis: usize| {
            let (low, high) = all().fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), at| {
                (low.min(at[axis]), high.max(at[axis]))
            });
            (high - low).max(1.0)
        };
        (0..3).map(span).product()
    }

    /// Pairs as indices in frames a and b.
    pub fn pairs(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        self.partners[0].iter().enumerate().filter_map(|(a, b)| Some([a, (*b)?]))
    }

    /// The particles of a frame without a partner.
    pub fn alone(&self, frame: usize) -> impl Iterator<Item = usize> + '_ {
        let partners = self.partners[frame].iter().enumerate();
        partners.filter(|(_, partner)| partner.is_none()).map(|(n, _)| n)
    }

    /// Predicted position in frame `frame` of a particle of the other frame, in mm.
    pub fn place_in(&self, frame: usize, n: usize, flow: &dyn Flow, voxel_mm: f64) -> [f64; 3] {
        let middle_mm = self.middles[1 - frame][n].map(|vox| f64::from(vox) * voxel_mm);
        let moved = flow.displacement_mm(middle_mm);
        let sign = [-0.5, 0.5][frame];
        std::array::from_fn(|axis| middle_mm[axis] + sign * moved[axis])
    }
}

/// Mutual nearest neighbours of two lists of points.
fn mutual(middles: &[Vec<[f32; 3]>; 2], reach: f32) -> [Vec<Option<usize>>; 2] {
    let nearest = |from: usize| -> Vec<Option<usize>> {
        let near = Neighbours::new(&middles[1 - from], reach);
        middles[from].iter().map(|&at| near.nearest(at, reach)).collect()
    };
    let (a, b) = rayon::join(|| nearest(0), || nearest(1));
    let both = |one: &[Option<usize>], other: &[Option<usize>]| -> Vec<Option<usize>> {
        let partner = |(n, partner): (usize, &Option<usize>)| {
            partner.filter(|&partner| other[partner] == Some(n))
        };
        one.iter().enumerate().map(partner).collect()
    };
    [both(&a, &b), both(&b, &a)]
}

/// A position that is proposed to a frame.
struct Proposal {
    /// The particle of the other frame.
    particle: Particle,
    at_mm: [f64; 3],
    /// A nearby particle of the frame without a partner.
    rival: Option<usize>,
}

/// Proposes particles without a partner to the other frame, where its residual contains enough light. A nearby
/// particle without a partner shares its light with the proposal; the fit determines which of the two remains.
pub fn exchange(
    fits: &mut [FrameFit; 2],
    partners: &Partners,
    flow: &dyn Flow,
    (cameras, priors): (&[PointCamera], &[LightPrior; 2]),
    (near_vox, voxel_mm): (f64, f64),
) {
    let proposals = [0, 1].map(|frame: usize| {
        let other = 1 - frame;
        let alone: Vec<usize> = partners.alone(frame).collect();
        let places: Vec<[f32; 3]> = alone.iter().map(|&n| partners.middles[frame][n]).collect();
        let near = Neighbours::new(&places, near_vox as f32);
        let proposal = |n: usize| Proposal {
            particle: fits[other].particles[n],
            at_mm: partners.place_in(frame, n, flow, voxel_mm),
            rival: near
                .nearest(partners.middles[other][n], near_vox as f32)
                .map(|rival| alone[rival]),
        };
        let has_light = |footprint: &mut PointFootprint, proposal: Proposal| {
            let (lit, _) = fits[frame].light_at(cameras, proposal.at_mm, footprint);
            let share = priors[frame].mean_relative(&lit, cameras.len());
            (proposal.rival.is_some() || share >= LEAST_PROPOSAL_LIGHT).then_some(proposal)
        };
        let numbers: Vec<usize> = partners.alone(other).collect();
        numbers
            .into_par_iter()
            .map(proposal)
            .map_init(PointFootprint::default, has_light)
            .flatten()
            .collect::<Vec<Proposal>>()
    });
    for (frame, proposals) in proposals.into_iter().enumerate() {
        for Proposal { particle, at_mm, rival } in proposals {
            let share = match rival {
                Some(rival) => {
                    let light = &mut fits[frame].particles[rival].light;
                    light.iter_mut().for_each(|light| *light /= 2.0);
                    0.5
                }
                None => STARTING_SHARE,
            };
            let relative = |c: usize| particle.light[c] / priors[1 - frame].typical[c];
            let light: [f64; CAMERAS] =
                std::array::from_fn(|c| share * relative(c) * priors[frame].typical[c]);
            fits[frame].extend([Particle { at_mm, light }]);
        }
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;
    use crate::particles::flow::MovedParticle;

    struct Still;

    impl Flow for Still {
        fn displacement_mm(&self, _: [f64; 3]) -> [f64; 3] {
            [0.0; 3]
        }

        fn correct(&mut self, _: &[MovedParticle], _: &[MovedParticle]) {}
    }

    fn particle(at_mm: [f64; 3]) -> Particle {
        Particle { at_mm, light: [1.0; CAMERAS] }
    }

    /// In a cube of 60 voxels: two in the middle that are 1.5 voxels apart, and `others` without a partner.
    fn apart(others: usize) -> [Vec<Particle>; 2] {
        let mut random = Pcg64Mcg::seed_from_u64(3);
        let mut place = |_| particle([0; 3].map(|_: i32| random.random_range(-30.0..30.0)));
        [0.0, 1.5].map(|x| {
            let mut particles = vec![particle([x, 0.0, 0.0])];
            particles.extend((0..others).map(&mut place));
            particles
        })
    }

    #[test]
    fn few_particles_that_are_alone_are_paired_over_a_longer_distance() {
        let frames = |others| {
            let [a, b] = apart(others);
            Partners::new([&a, &b], &Still, 0.5, 1.0)
        };
        assert_eq!(frames(40).partners[0][0], None);
        let widened = frames(40).widened(|_, _| true);
        assert_eq!((widened.partners[0][0], widened.partners[1][0]), (Some(0), Some(0)));
        assert!(widened.pairs().count() < 3, "hardly any others are paired by chance");
        assert_eq!(frames(40).widened(|frame, n| frame == 0 || n > 0).partners[0][0], None);
        assert_eq!(frames(4000).widened(|_, _| true).partners[0][0], None);
    }
}
