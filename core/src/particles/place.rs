//! Sequence of the fit: from candidates in both frames to pairs of particles that agree with the flow.

use rayon::prelude::*;

use super::{
    blur::fitted_blur,
    disagreement::{ParticleEquations, variance_factor},
    fit::FrameFit,
    flow::{Flow, MovedParticle},
    image::ParticleImage,
    neighbours::Neighbours,
    normal::{CAMERAS, LightPrior, Particle, StepRule},
    pair::ParticlePair,
    partners::{Partners, exchange},
    select::Candidate,
};
use crate::{
    model::{PointBlur, PointCamera, PointFootprint},
    statistics::median,
};

/// A frame before its particles are fitted.
pub struct FrameStart {
    /// Per camera.
    pub images: Vec<ParticleImage>,
    /// From the light of its volume.
    pub candidates: Vec<Candidate>,
}

/// The particles of a pair of frames.
#[derive(Debug, Clone, PartialEq)]
pub struct PlacedParticles {
    /// Particles in both frames.
    pub pairs: Vec<ParticlePair>,
    /// Particles in one frame only.
    pub unpaired: [Vec<Particle>; 2],
    /// Width of a point's image in each camera.
    pub blurs: Vec<PointBlur>,
    /// Typical light of a particle in each frame and camera, in counts.
    pub typical: [[f64; CAMERAS]; 2],
}

/// Least light of a particle in a camera that sees it, over that in the brighter camera. Both are relative to typical
/// lights.
const LEAST_SEEN_LIGHT: f64 = 0.1;

impl PlacedParticles {
    /// Whether every camera sees the particle in both frames.
    pub fn is_seen_by_all(&self, pair: &ParticlePair) -> bool {
        pair.light.iter().zip(&self.typical).all(|(light, typical)| {
            let cameras = self.blurs.len();
            let relative: [f64; CAMERAS] = std::array::from_fn(|c| light[c] / typical[c]);
            let brightest = relative[..cameras].iter().copied().fold(0.0, f64::max);
            relative[..cameras].iter().all(|light| *light >= LEAST_SEEN_LIGHT * brightest)
        })
    }
}

/// Largest number of steps before and after the first removal of faint and duplicate particles.
const FIRST_STEPS: [usize; 2] = [4, 2];
/// The same after an exchange between the frames.
const EXCHANGE_STEPS: [usize; 2] = [4, 2];
/// Largest number of steps of the last fit.
const LAST_STEPS: usize = 3;

/// Number of exchanges between the frames.
const EXCHANGES: usize = 4;

/// Number of exchanges before which the blur is estimated again.
const BLUR_ROUNDS: usize = 2;

/// Relative error of the model while particles are missing, by exchange.
const MODEL_ERRORS: [f32; EXCHANGES + 1] = [0.3, 0.3, 0.2, 0.15, 0.15];

/// Least relative error of the model in the last fit: the error of the footprint.
const LEAST_MODEL_ERROR: f32 = 0.02;

/// Least light of a particle, relative to the typical light.
const LEAST_PARTICLE_LIGHT: f64 = 0.25;

/// Particles within this distance are merged, in voxels.
const MERGE_DISTANCE_VOX: f64 = 0.35;

/// A particle whose step is shorter has converged, in voxels.
const CONVERGED_VOX: f64 = 0.01;

/// Distance of partners below which they are not restarted, in voxels: [`AGREE_DEVIATIONS`] times the typical
/// distance, within these bounds.
const AGREE_VOX: [f64; 2] = [0.15, 0.5];
const AGREE_DEVIATIONS: f64 = 3.0;

/// Largest distance of partners from which the flow is corrected, in voxels.
const MAX_CORRECTION_DISTANCE_VOX: f64 = 1.0;

/// The flow is corrected again while pairs that disagree with it, but not with each other, are this share of the others
/// or more ...
const LEAST_FAR_SHARE: f64 = 0.005;
/// ... but not more often than this.
const MOST_CORRECTIONS: usize = 5;

/// A proposal this near to a particle without a partner competes with it, in voxels.
const RIVAL_VOX: f64 = 1.0;

/// Largest distance of partners in the result, in voxels.
const MAX_PAIR_DISTANCE_VOX: f64 = 0.5;

/// Restart positions relative to a particle, along each axis, in voxels.
const STARTS_VOX: [f64; 2] = [-0.6, 0.6];

/// Proposals of the other frame within this distance of a particle are restart positions as well, in voxels.
const STARTS_REACH_VOX: f64 = 1.5;

/// Relaxation factor of steps, except in exchanges.
const RELAXATION: f64 = 1.0;
/// The same in exchanges: batches step one after the other, so a factor above 1 is successive over-relaxation (Young,
/// Trans. Am. Math. Soc. 76, 1954).
const EXCHANGE_RELAXATION: f64 = 1.3;

/// Levenberg–Marquardt damping of a step, relative to the diagonal.
const DAMPING: f64 = 0.01;

/// Largest step, in voxels.
const MAX_STEP_VOX: f64 = 0.2;

/// Places particles in the images of both frames.
///
/// `flow` is an estimate of the displacement with an error of less than a voxel; it is corrected by the particles.
/// `voxel_mm` is the unit of all lengths above: about the microlens pitch in the volume.
pub fn place_pairs(
    cameras: &[PointCamera],
    voxel_mm: f64,
    starts: [FrameStart; 2],
    flow: &mut dyn Flow,
) -> PlacedParticles {
    let mut placement = Placement {
        cameras: cameras.to_vec(),
        voxel_mm,
        priors: starts.each_ref().map(|start| LightPrior::of_candidates(&start.candidates)),
    };
    let mut fits = starts.map(|start| {
        let mut fit = FrameFit::new(start.images);
        fit.propose(&start.candidates);
        fit
    });
    placement.begin(&mut fits);
    for round in 0..EXCHANGES {
        placement.support(&mut fits, flow, round);
    }
    placement.finish(&mut fits, flow)
}

/// State of the fit.
struct Placement {
    cameras: Vec<PointCamera>,
    voxel_mm: f64,
    priors: [LightPrior; 2],
}

impl Placement {
    fn rule(&self, relaxation: f64) -> StepRule {
        StepRule { relaxation, damping: DAMPING, longest_mm: MAX_STEP_VOX * self.voxel_mm }
    }

    /// First steps of all candidates, and removal of faint ones.
    fn begin(&self, fits: &mut [FrameFit; 2]) {
        let converged_mm = CONVERGED_VOX * self.voxel_mm;
        let rule = self.rule(RELAXATION);
        self.each(fits, |fit, prior| {
            fit.set_model_error(MODEL_ERRORS[0]);
            fit.render(&self.cameras);
            let [before, after] = FIRST_STEPS;
            fit.iterate(&self.cameras, prior, &rule, (converged_mm, before));
            fit.prune(
                &self.cameras,
                prior,
                (LEAST_PARTICLE_LIGHT, MERGE_DISTANCE_VOX * self.voxel_mm),
            );
            fit.reactivate();
            fit.iterate(&self.cameras, prior, &rule, (converged_mm, after));
        });
    }

    /// Exchanges particles between the frames, fits them, and restarts those without a partner.
    fn support(&mut self, fits: &mut [FrameFit; 2], flow: &mut dyn Flow, round: usize) {
        let agree_vox = self.correct(fits, flow);
        let partners = self.partners(fits, flow, agree_vox);
        self.learn(fits, &partners, round);
        exchange(fits, &partners, flow, (&self.cameras, &self.priors), (RIVAL_VOX, self.voxel_mm));
        let converged_mm = CONVERGED_VOX * self.voxel_mm;
        let (misfit, rule) = (MODEL_ERRORS[round + 1], self.rule(EXCHANGE_RELAXATION));
        self.each(fits, |fit, prior| {
            fit.set_model_error(misfit);
            fit.reactivate();
            fit.render(&self.cameras);
            let [before, after] = EXCHANGE_STEPS;
            fit.iterate(&self.cameras, prior, &rule, (converged_mm, before));
            fit.prune(
                &self.cameras,
                prior,
                (LEAST_PARTICLE_LIGHT, MERGE_DISTANCE_VOX * self.voxel_mm),
            );
            fit.iterate(&self.cameras, prior, &rule, (converged_mm, after));
        });
        self.restart(fits, flow, agree_vox);
    }

    /// Estimates the prior of the light, and the blur, from pairs.
    fn learn(&mut self, fits: &[FrameFit; 2], partners: &Partners, round: usize) {
        let pairs: Vec<[usize; 2]> = partners.pairs().collect();
        for (frame, fit) in fits.iter().enumerate() {
            let agreed: Vec<Particle> =
                pairs.iter().map(|pair| fit.particles[pair[frame]]).collect();
            self.priors[frame] = self.priors[frame].of_particles(&agreed, self.cameras.len());
        }
        if round < BLUR_ROUNDS {
            let of: Vec<usize> = pairs.iter().map(|pair| pair[0]).collect();
            let blurs: Vec<PointBlur> = (0..self.cameras.len())
                .into_par_iter()
                .map(|c| fitted_blur(&fits[0], &self.cameras, c, &of))
                .collect();
            for (camera, blur) in self.cameras.iter_mut().zip(blurs) {
                camera.blur = blur;
            }
        }
    }

    /// Restarts particles without a partner.
    fn restart(&self, fits: &mut [FrameFit; 2], flow: &dyn Flow, agree_vox: f64) {
        let partners = self.partners(fits, flow, agree_vox);
        let proposals = [0, 1].map(|frame: usize| -> Vec<[f64; 3]> {
            let other = 1 - frame;
            (0..fits[other].particles.len())
                .filter(|&n| partners.partners[other][n].is_none())
                .map(|n| partners.place_in(frame, n, flow, self.voxel_mm))
                .collect()
        });
        let reach = STARTS_REACH_VOX * self.voxel_mm;
        let rule = self.rule(RELAXATION);
        let restart = |frame: usize, fit: &mut FrameFit| {
            let places: Vec<[f32; 3]> =
                proposals[frame].iter().map(|at| at.map(|mm| mm as f32)).collect();
            let near = Neighbours::new(&places, reach as f32);
            let mut footprint = PointFootprint::default();
            for n in 0..fit.particles.len() {
                if partners.partners[frame][n].is_some() {
                    continue;
                }
                let own = fit.particles[n].at_mm;
                let mut starts = Vec::new();
                near.visit(own.map(|mm| mm as f32), |place, _| {
                    starts.push(proposals[frame][place]);
                });
                for (axis, vox) in (0..3).flat_map(|axis| STARTS_VOX.map(|vox| (axis, vox))) {
                    let mut start = own;
                    start[axis] += vox * self.voxel_mm;
                    starts.push(start);
                }
                let how = (&self.priors[frame], &rule);
                fit.restart(&self.cameras, n, &starts, how, &mut footprint);
            }
        };
        let [a, b] = fits;
        rayon::join(|| restart(0, a), || restart(1, b));
    }

    /// Last steps, with pixels weighted by their estimated noise, and the result.
    fn finish(&self, fits: &mut [FrameFit; 2], flow: &mut dyn Flow) -> PlacedParticles {
        let converged_mm = CONVERGED_VOX * self.voxel_mm / 10.0;
        let rule = self.rule(RELAXATION);
        self.each(fits, |fit, prior| {
            for image in &mut fit.images {
                image.noise = image.noise_of_residual();
                image.noise.misfit = image.noise.misfit.max(LEAST_MODEL_ERROR);
            }
            fit.reactivate();
            fit.iterate(&self.cameras, prior, &rule, (converged_mm, LAST_STEPS));
        });
        self.correct(fits, flow);
        let partners = self.partners(fits, flow, MAX_PAIR_DISTANCE_VOX);
        let partners = self.widened(partners, fits);
        let pairs: Vec<[usize; 2]> = partners.pairs().collect();
        let equations = [0, 1].map(|frame: usize| {
            let of: Vec<usize> = pairs.iter().map(|pair| pair[frame]).collect();
            fits[frame].equations_by_camera(&self.cameras, &of)
        });
        let factor = variance_factor(&equations);
        let covariances = |n: usize, particles: &[Particle; 2]| {
            [0, 1].map(|frame| {
                let mut sum = ParticleEquations::default();
                equations[frame].iter().for_each(|camera| sum += &camera[n]);
                let known = (self.cameras.len(), &self.priors[frame], self.voxel_mm);
                let covariance = sum.normal.covariance_mm2(&sum.gradient, &particles[frame], known);
                covariance.map(|row| row.map(|entry| factor * entry))
            })
        };
        let unpaired = [0, 1].map(|frame: usize| {
            let alone = partners.partners[frame].iter().zip(&fits[frame].particles);
            alone.filter(|(partner, _)| partner.is_none()).map(|(_, particle)| *particle).collect()
        });
        let pair = |(n, &[a, b]): (usize, &[usize; 2])| {
            let particles = [fits[0].particles[a], fits[1].particles[b]];
            ParticlePair {
                places_mm: particles.map(|particle| particle.at_mm),
                covariances_mm2: covariances(n, &particles),
                light: particles.map(|particle| particle.light),
            }
        };
        PlacedParticles {
            pairs: pairs.iter().enumerate().map(pair).collect(),
            unpaired,
            blurs: self.cameras.iter().map(|camera| camera.blur).collect(),
            typical: self.priors.map(|prior| prior.typical),
        }
    }

    /// Corrects the flow by mutual nearest neighbours, and where it is wrong by pairs that agree with each other; again
    /// while there are many of the latter. Returns the largest distance of partners that agree, in voxels.
    fn correct(&self, fits: &[FrameFit; 2], flow: &mut dyn Flow) -> f64 {
        let moved = |pair: [usize; 2]| {
            MovedParticle::between([0, 1].map(|f| fits[f].particles[pair[f]].at_mm))
        };
        let mut near: Vec<MovedParticle> = Vec::new();
        for _ in 0..MOST_CORRECTIONS {
            let partners = self.partners(fits, flow, MAX_CORRECTION_DISTANCE_VOX);
            let far: Vec<MovedParticle> = partners.by_consensus().into_iter().map(moved).collect();
            near = self.widened(partners, fits).pairs().map(moved).collect();
            flow.correct(&near, &far);
            if (far.len() as f64) < LEAST_FAR_SHARE * near.len() as f64 {
                break;
            }
        }
        (AGREE_DEVIATIONS * self.typical_distance_vox(&near, flow))
            .clamp(AGREE_VOX[0], AGREE_VOX[1])
    }

    /// Median distance of particles in frame b from where the flow leads, in voxels.
    fn typical_distance_vox(&self, moved: &[MovedParticle], flow: &dyn Flow) -> f64 {
        let distance_mm = |particle: &MovedParticle| {
            let known = flow.displacement_mm(particle.middle_mm);
            (0..3).map(|axis| (particle.moved_mm[axis] - known[axis]).powi(2)).sum::<f64>().sqrt()
        };
        median(moved.iter().map(distance_mm)).unwrap_or_default() / self.voxel_mm
    }

    fn partners(&self, fits: &[FrameFit; 2], flow: &dyn Flow, reach_vox: f64) -> Partners {
        let frames = [&fits[0].particles[..], &fits[1].particles[..]];
        Partners::new(frames, flow, reach_vox, self.voxel_mm)
    }

    /// `partners`, and more. For remaining particles that are bright enough in every camera, the search radius is
    /// larger.
    fn widened(&self, partners: Partners, fits: &[FrameFit; 2]) -> Partners {
        let is_bright = |frame: usize, n: usize| {
            let light = fits[frame].particles[n].light.iter().zip(&self.priors[frame].typical);
            light
                .take(self.cameras.len())
                .all(|(light, typical)| *light >= LEAST_PARTICLE_LIGHT * typical)
        };
        partners.widened(is_bright)
    }

    /// Applies `act` to both frames in parallel.
    fn each(&self, fits: &mut [FrameFit; 2], act: impl Fn(&mut FrameFit, &LightPrior) + Sync) {
        let [a, b] = fits;
        rayon::join(|| act(a, &self.priors[0]), || act(b, &self.priors[1]));
    }
}
