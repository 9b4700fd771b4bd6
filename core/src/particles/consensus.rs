//! Pairs of particles where the flow is wrong, found by the agreement of neighbours.
//!
//! Windows miss a thin jet or a small vortex by more than the distance in which partners are searched for, so no
//! particle there has a partner, although both frames contain it. Neighbours move alike (Baek and Lee, Experiments in
//! Fluids 22, 1996): what the flow misses at a true pair also leads most neighbours of the one particle to particles of
//! the other frame.

use rayon::prelude::*;

use super::{
    neighbours::Neighbours,
    partners::{Partners, UNIT_SPHERE},
};

/// Largest distance of a partner from where the flow leads, in voxels.
const FARTHEST_VOX: f32 = 5.0;

/// Number of neighbours that are asked.
const NEIGHBOURS: usize = 16;

/// Largest difference between what the flow misses at two particles that move alike, in voxels, and per voxel of their
/// distance.
const TOLERANCE_VOX: f32 = 0.5;
const TOLERANCE_PER_VOX: f32 = 0.15;

/// Least number of neighbours that move like a pair.
const LEAST_AGREEING: usize = 2;

/// Largest number of partners with as many agreeing neighbours by chance. Most of these are removed by
/// [`Alone::confirmed`] (docs/decisions.md).
const MOST_BY_CHANCE: f64 = 0.3;

/// Number of times that matches are compared with those of the neighbours.
const CONFIRMATIONS: usize = 2;

/// Radius within which the particles of the other frame are counted for their density, in voxels.
const DENSITY_RADIUS_VOX: f32 = 6.0;

/// A possible partner of a particle.
#[derive(Debug, Clone, Copy)]
struct Match {
    partner: usize,
    /// What the flow misses if they are partners.
    missed_vox: [f32; 3],
}

/// A neighbour of a particle, and how much what the flow misses may differ.
#[derive(Debug, Clone, Copy)]
struct Neighbour {
    number: usize,
    tolerance_vox: f32,
}

/// Particles without a partner.
struct Alone {
    /// Places at mid-pair in both frames, in voxels.
    places: [Vec<[f32; 3]>; 2],
    /// Of each particle of frame a: particles of frame b within reach.
    matches: Vec<Vec<Match>>,
    /// Of each particle of frame a: the nearest others of frame a.
    neighbours: Vec<Vec<Neighbour>>,
}

impl Partners {
    /// Pairs of particles without a partner that move like their neighbours without a partner.
    pub fn by_consensus(&self) -> Vec<[usize; 2]> {
        let numbers = [0, 1].map(|frame| self.alone(frame).collect::<Vec<usize>>());
        if numbers.iter().any(|alone| alone.len() <= LEAST_AGREEING) {
            return Vec::new();
        }
        let places =
            [0, 1].map(|f: usize| numbers[f].iter().map(|&n| self.middles[f][n]).collect());
        let found = Alone::new(places, self.volume_vox3()).confirmed();
        let pair = |(a, partner): (usize, Option<Match>)| {
            partner.map(|partner| [numbers[0][a], numbers[1][partner.partner]])
        };
        found.into_iter().enumerate().filter_map(pair).collect()
    }
}

impl Alone {
    fn new(places: [Vec<[f32; 3]>; 2], volume_vox3: f32) -> Self {
        let matches = matches(&places);
        let neighbours = neighbours(&places[0], volume_vox3);
        Self { places, matches, neighbours }
    }

    /// The likeliest match of each particle, if most of its neighbours that have one move like it.
    fn confirmed(&self) -> Vec<Option<Match>> {
        let all = 0..self.matches.len();
        let near_b = Neighbours::new(&self.places[1], DENSITY_RADIUS_VOX);
        let mut found: Vec<Option<Match>> =
            all.clone().into_par_iter().map(|n| self.likeliest(n, &near_b)).collect();
        for _ in 0..CONFIRMATIONS {
            let is_confirmed = |n: usize, own: &Match| {
                let others = || {
                    let of = |near: &Neighbour| found[near.number].map(|other| (*near, other));
                    self.neighbours[n].iter().filter_map(of)
                };
                let agreeing = others().filter(|(near, other)| near.allows(own, other)).count();
                agreeing >= LEAST_AGREEING && 2 * agreeing > others().count()
            };
            let kept = |n: usize| found[n].filter(|own| is_confirmed(n, own));
            found = all.clone().map(kept).collect();
        }
        found
    }

    /// The match of particle `n` that leads most of its neighbours to particles of frame b, if they are more than by
    /// chance.
    fn likeliest(&self, n: usize, near_b: &Neighbours) -> Option<Match> {
        let agreeing = |own: &Match| {
            let agrees = |near: &&Neighbour| {
                self.matches[near.number].iter().any(|other| near.allows(own, other))
            };
            self.neighbours[n].iter().filter(agrees).count()
        };
        let mut best: Option<(usize, Match)> = None;
        for own in &self.matches[n] {
            let count = agreeing(own);
            if best.is_none_or(|(most, _)| count > most) {
                best = Some((count, *own));
            }
        }
        let (count, own) = best.filter(|(count, _)| *count >= LEAST_AGREEING)?;
        let tries = self.matches[n].len() as f64;
        let chance = tries * probability_of(count, self.agreeing_by_chance(n, near_b));
        (chance < MOST_BY_CHANCE).then_some(own)
    }

    /// Expected number of neighbours of particle `n` that agree with a wrong match: those with a particle of frame b
    /// within their tolerance, at the density about the particle.
    fn agreeing_by_chance(&self, n: usize, near_b: &Neighbours) -> f64 {
        let mut about = 0.5;
        near_b.visit(self.places[0][n], |_, _| about += 1.0);
        // In particles per sphere of radius 1, as volumes are those of spheres.
        let density = about / DENSITY_RADIUS_VOX.powi(3);
        let by_chance =
            |near: &Neighbour| -libm::expm1(-f64::from(density * near.tolerance_vox.powi(3)));
        self.neighbours[n].iter().map(by_chance).sum()
    }
}

impl Neighbour {
    fn allows(&self, own: &Match, other: &Match) -> bool {
        let square: f32 =
            (0..3).map(|axis| (own.missed_vox[axis] - other.missed_vox[axis]).powi(2)).sum();
        square < self.tolerance_vox * self.tolerance_vox
    }
}

fn matches([a, b]: &[Vec<[f32; 3]>; 2]) -> Vec<Vec<Match>> {
    let near = Neighbours::new(b, FARTHEST_VOX);
    let of = |from: &[f32; 3]| {
        let mut found = Vec::new();
        near.visit(*from, |partner, _| {
            let missed_vox = std::array::from_fn(|axis| b[partner][axis] - from[axis]);
            found.push(Match { partner, missed_vox });
        });
        found
    };
    a.par_iter().map(of).collect()
}

/// The nearest others of each of `places`, which are in a box of this volume.
fn neighbours(places: &[[f32; 3]], volume_vox3: f32) -> Vec<Vec<Neighbour>> {
    // Twice as many as needed, on average: particles without a partner are in clusters.
    let reach =
        (2.0 * NEIGHBOURS as f32 * volume_vox3 / (UNIT_SPHERE * places.len() as f32)).cbrt();
    let near = Neighbours::new(places, reach);
    let of = |(n, at): (usize, &[f32; 3])| {
        let mut found = Vec::new();
        near.visit(*at, |other, square| {
            if other != n {
                found.push((square, other));
            }
        });
        found.sort_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(&other.1)));
        let neighbour = |&(square, number): &(f32, usize)| Neighbour {
            number,
            tolerance_vox: TOLERANCE_VOX + TOLERANCE_PER_VOX * square.sqrt(),
        };
        found.iter().take(NEIGHBOURS).map(neighbour).collect()
    };
    places.par_iter().enumerate().map(of).collect()
}

/// Probability of `least` or more independent events where `mean` are expected (Poisson).
fn probability_of(least: usize, mean: f64) -> f64 {
    let (mut fewer, mut exactly) = (0.0, libm::exp(-mean));
    for count in 0..least {
        fewer += exactly;
        exactly *= mean / (count + 1) as f64;
    }
    (1.0 - fewer).max(0.0)
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;
    use crate::particles::{
        flow::{Flow, MovedParticle},
        normal::{CAMERAS, Particle},
    };

    const EDGE_VOX: f64 = 50.0;

    struct Still;

    impl Flow for Still {
        fn displacement_mm(&self, _: [f64; 3]) -> [f64; 3] {
            [0.0; 3]
        }

        fn correct(&mut self, _: &[MovedParticle], _: &[MovedParticle]) {}
    }

    /// So many particles of frame a, and where `flow` takes them; as many of each frame have no partner.
    fn frames(
        (pairs, single): (usize, usize),
        flow: impl Fn([f64; 3]) -> [f64; 3],
    ) -> [Vec<Particle>; 2] {
        let mut random = Pcg64Mcg::seed_from_u64(7);
        let mut place = |_| [0; 3].map(|_: i32| random.random_range(0.0..EDGE_VOX));
        let [paired, a, b] = [pairs, single, single]
            .map(|count| (0..count).map(&mut place).collect::<Vec<[f64; 3]>>());
        let moved = paired.iter().map(|at: &[f64; 3]| {
            let moved = flow(*at);
            std::array::from_fn(|axis| at[axis] + moved[axis])
        });
        let particle = |at_mm| Particle { at_mm, light: [1.0; CAMERAS] };
        [
            paired.iter().copied().chain(a).map(particle).collect(),
            moved.chain(b).map(particle).collect(),
        ]
    }

    /// Numbers of right and wrong pairs: the first `pairs` particles of both frames belong together.
    fn found(frames: &[Vec<Particle>; 2], pairs: usize) -> [usize; 2] {
        let partners = Partners::new([&frames[0], &frames[1]], &Still, 0.5, 1.0);
        let found = partners.by_consensus();
        let right = found.iter().filter(|[a, b]| a == b && *a < pairs).count();
        [right, found.len() - right]
    }

    #[test]
    fn a_jet_that_the_flow_misses_is_found() {
        // Four voxels along z, over a width of some ten.
        let jet = |at: [f64; 3]| {
            let square = (at[0] - 25.0).powi(2) + (at[1] - 20.0).powi(2);
            [0.0, 0.0, 4.0 * (-square / 60.0).exp()]
        };
        let pairs = 1500;
        let frames = frames((pairs, 100), jet);
        let missed = (0..pairs).filter(|&n| jet(frames[0][n].at_mm)[2] > 1.0).count();
        let [right, wrong] = found(&frames, pairs);
        assert!(missed > 80 && 10 * right > 8 * missed, "{right} of {missed}");
        assert!(10 * wrong < right, "{right} {wrong}");
    }

    #[test]
    fn particles_at_random_are_hardly_ever_paired() {
        for single in [0, 1, 2, 30, 300, 1500] {
            let [_, wrong] = found(&frames((0, single), |_| [0.0; 3]), 0);
            assert!(20 * wrong <= single, "{wrong} of {single}");
        }
    }

    #[test]
    fn probabilities_are_those_of_poisson() {
        assert_eq!(probability_of(0, 0.7), 1.0);
        assert!((probability_of(1, 0.5) - (1.0 - (-0.5f64).exp())).abs() < 1e-12);
        assert!((probability_of(3, 2.0) - (1.0 - 5.0 * (-2.0f64).exp())).abs() < 1e-12);
        assert_eq!(probability_of(2, 0.0), 0.0);
    }
}
