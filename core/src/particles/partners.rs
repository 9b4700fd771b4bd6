//! Both frames support each other: where the flow takes the particles of one, those of the other should be.

use super::{
    fit::FrameFit,
    flow::{Flow, middle},
    neighbours::Neighbours,
    normal::{CAMERAS, LightPrior, Particle},
};

/// Share of its partner's light that a proposed particle starts with where the frame has none of its own.
/// The fit increases the light of a true one.
const STARTING_SHARE: f64 = 0.3;

/// The particles of both frames at mid-pair, and which of them belong together.
pub struct Partners {
    /// In voxels.
    pub middles: [Vec<[f32; 3]>; 2],
    /// For each of frame a its partner in frame b, and the other way round.
    pub partners: [Vec<Option<usize>>; 2],
}

impl Partners {
    /// Mutual nearest neighbours at mid-pair, no further apart than `reach_vox`.
    pub fn new(frames: [&[Particle]; 2], flow: Flow<'_>, reach_vox: f64, voxel_mm: f64) -> Self {
        let middles = [0, 1].map(|frame| {
            let sign = [1.0, -1.0][frame];
            let in_voxels =
                |p: &Particle| middle(p.at_mm, flow, sign).map(|mm| (mm / voxel_mm) as f32);
            frames[frame].iter().map(in_voxels).collect::<Vec<_>>()
        });
        let partners = mutual(&middles, reach_vox as f32);
        Self { middles, partners }
    }

    /// Pairs, by their numbers in frame a and in frame b.
    pub fn pairs(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        self.partners[0].iter().enumerate().filter_map(|(a, b)| Some([a, (*b)?]))
    }

    /// Where a particle of the other frame would be in frame `frame`, in mm.
    pub fn place_in(&self, frame: usize, n: usize, flow: Flow<'_>, voxel_mm: f64) -> [f64; 3] {
        let middle_mm = self.middles[1 - frame][n].map(|vox| f64::from(vox) * voxel_mm);
        let moved = flow(middle_mm);
        let sign = [-0.5, 0.5][frame];
        std::array::from_fn(|axis| middle_mm[axis] + sign * moved[axis])
    }
}

/// For each point of both lists the one of the other that is its nearest and whose nearest it is.
fn mutual(middles: &[Vec<[f32; 3]>; 2], reach: f32) -> [Vec<Option<usize>>; 2] {
    let nearest = |from: usize| -> Vec<Option<usize>> {
        let near = Neighbours::new(&middles[1 - from], reach);
        middles[from].iter().map(|&at| near.nearest(at, reach)).collect()
    };
    let (a, b) = (nearest(0), nearest(1));
    let both = |one: &[Option<usize>], other: &[Option<usize>]| -> Vec<Option<usize>> {
        let partner = |(n, partner): (usize, &Option<usize>)| {
            partner.filter(|&partner| other[partner] == Some(n))
        };
        one.iter().enumerate().map(partner).collect()
    };
    [both(&a, &b), both(&b, &a)]
}

/// Proposes particles without a partner to the other frame. A particle without a partner near a proposal
/// shares its light with it: the fit decides which of the two remains.
pub fn exchange(
    fits: &mut [FrameFit; 2],
    partners: &Partners,
    flow: Flow<'_>,
    priors: &[LightPrior; 2],
    (near_vox, voxel_mm): (f64, f64),
) {
    let found = [0, 1].map(|frame: usize| fits[frame].particles.clone());
    for frame in 0..2 {
        let other = 1 - frame;
        let alone: Vec<usize> =
            (0..found[frame].len()).filter(|&n| partners.partners[frame][n].is_none()).collect();
        let places: Vec<[f32; 3]> = alone.iter().map(|&n| partners.middles[frame][n]).collect();
        let near = Neighbours::new(&places, near_vox as f32);
        for (n, particle) in found[other].iter().enumerate() {
            if partners.partners[other][n].is_some() {
                continue;
            }
            let rival = near.nearest(partners.middles[other][n], near_vox as f32);
            let share = match rival {
                Some(own) => {
                    let light = &mut fits[frame].particles[alone[own]].light;
                    light.iter_mut().for_each(|light| *light /= 2.0);
                    0.5
                }
                None => STARTING_SHARE,
            };
            let relative = |c: usize| particle.light[c] / priors[other].typical[c];
            let light: [f64; CAMERAS] =
                std::array::from_fn(|c| share * relative(c) * priors[frame].typical[c]);
            let at_mm = partners.place_in(frame, n, flow, voxel_mm);
            fits[frame].extend([Particle { at_mm, light }]);
        }
    }
}
