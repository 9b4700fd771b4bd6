//! Steps of particles towards the images: Gauss–Newton for the unknowns of each, Gauss–Seidel between them.
//!
//! Particles whose images overlap depend on each other. Batches of particles step one after the other, each
//! against the residual that the steps before it left. The particles of a batch step at once, on several threads.
//! Their images hardly overlap, because the batch takes every [`STRIDE`]-th particle in the order of their images.
//! With neighbours in one batch, fewer particles are found (docs/decisions.md).

use rayon::prelude::*;

use super::{
    fit::FrameFit,
    normal::{LightPrior, Normal, Particle, StepRule},
};
use crate::model::{PointCamera, PointFootprint};

/// Number of particles that step at once.
const BATCH: usize = 64;

/// Distance of a batch's particles in the order of their images. A batch extends over `BATCH * STRIDE` particles,
/// whose part of an image remains in the processor's cache.
const STRIDE: usize = 16;

/// Number of a batch's particles that one thread takes at once.
const PER_TASK: usize = 8;

/// A particle after a step, and the length of the step in mm.
type Stepped = (Particle, f64);

impl FrameFit {
    /// One step of each of the numbered particles.
    pub fn step(
        &mut self,
        cameras: &[PointCamera],
        of: &[usize],
        prior: &LightPrior,
        rule: &StepRule,
    ) {
        let mut steps = vec![false; self.particles.len()];
        of.iter().for_each(|&n| steps[n] = true);
        let in_order = self.orders.first().into_iter().flatten().map(|&n| n as usize);
        let in_order: Vec<usize> = in_order.filter(|&n| steps[n]).collect();
        // The images of a batch's particles in each camera, kept until they are taken out of the model.
        let mut footprints = vec![vec![PointFootprint::default(); cameras.len()]; BATCH];
        for batch in batches(&in_order) {
            let stepped = self.stepped(cameras, &batch, (prior, rule), &mut footprints);
            self.exchange(cameras, &batch, &stepped, &footprints);
            for (n, (particle, step_mm)) in batch.into_iter().zip(stepped) {
                self.particles[n] = particle;
                self.steps_mm[n] = step_mm;
            }
        }
    }

    /// Steps of a batch's particles against the residual; `footprints` are set to their images before.
    fn stepped(
        &self,
        cameras: &[PointCamera],
        batch: &[usize],
        rules: (&LightPrior, &StepRule),
        footprints: &mut [Vec<PointFootprint>],
    ) -> Vec<Stepped> {
        let particles = batch.par_chunks(PER_TASK).zip(footprints.par_chunks_mut(PER_TASK));
        let stepped = particles.map(|(numbers, footprints)| {
            // While a particle's equations are summed up, the pixels of the next one are loaded.
            let image = |k: usize, footprints: &mut [Vec<PointFootprint>]| {
                if let Some(&n) = numbers.get(k) {
                    self.image_and_prefetch(cameras, n, &mut footprints[k]);
                }
            };
            image(0, footprints);
            let step = |(k, &n): (usize, &usize)| {
                image(k + 1, footprints);
                self.stepped_one(cameras, n, rules, &footprints[k])
            };
            numbers.iter().enumerate().map(step).collect::<Vec<Stepped>>()
        });
        stepped.collect::<Vec<_>>().concat()
    }

    /// Sets `footprints` to the images of particle `n`, and asks for their pixels.
    fn image_and_prefetch(
        &self,
        cameras: &[PointCamera],
        n: usize,
        footprints: &mut [PointFootprint],
    ) {
        for ((camera, footprint), image) in cameras.iter().zip(footprints).zip(&self.images) {
            camera.image_and_derivatives(self.particles[n].at_mm, footprint);
            image.prefetch(camera, footprint);
        }
    }

    /// Step of particle `n`, which has these images.
    fn stepped_one(
        &self,
        cameras: &[PointCamera],
        n: usize,
        (prior, rule): (&LightPrior, &StepRule),
        footprints: &[PointFootprint],
    ) -> Stepped {
        let particle = &self.particles[n];
        let mut normal = Normal::default();
        for (c, (camera, footprint)) in cameras.iter().zip(footprints).enumerate() {
            let equations = self.images[c].equations(camera, footprint);
            normal.add(&equations, &footprint.by_place, particle.light[c], c);
        }
        normal.stepped(particle, cameras.len(), prior, rule)
    }

    /// Replaces the images of a batch's particles in the model by those after their steps.
    fn exchange(
        &mut self,
        cameras: &[PointCamera],
        batch: &[usize],
        stepped: &[Stepped],
        footprints: &[Vec<PointFootprint>],
    ) {
        let particles = &self.particles;
        let images = self.images.par_iter_mut().zip(cameras).enumerate();
        images.for_each_init(PointFootprint::default, |footprint, (c, (image, camera))| {
            for (k, (&n, (after, _))) in batch.iter().zip(stepped).enumerate() {
                if let Some(next) = footprints[..batch.len()].get(k + 1) {
                    image.prefetch_model(camera, &next[c]);
                }
                image.add(camera, &footprints[k][c], -particles[n].light[c] as f32);
                camera.image(after.at_mm, footprint);
                image.add(camera, footprint, after.light[c] as f32);
            }
        });
    }
}

/// Batches of particles, given in the order of their images.
fn batches(in_order: &[usize]) -> impl Iterator<Item = Vec<usize>> {
    in_order.chunks(BATCH * STRIDE).flat_map(|part| {
        (0..STRIDE.min(part.len()))
            .map(|first| part.iter().skip(first).step_by(STRIDE).copied().collect())
    })
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;
    use rayon::ThreadPoolBuilder;

    use super::*;
    use crate::particles::{
        normal::{CAMERAS, LightPrior},
        test_data::{LIGHT, PARTICLES, VOXEL_MM, cameras, image, particles},
    };

    const RULE: StepRule = StepRule { relaxation: 1.0, damping: 0.01, longest_mm: 0.02 };
    const PRIOR: LightPrior = LightPrior { typical: [LIGHT; CAMERAS], spread: 0.1 };

    /// Particles some tenths of a voxel from their true places, in the images of those.
    fn misplaced(cameras: &[PointCamera]) -> (FrameFit, Vec<Particle>) {
        let mut random = Pcg64Mcg::seed_from_u64(8);
        let truth = particles(&mut random);
        let images = cameras.iter().enumerate().map(|(c, camera)| image(camera, c, &truth));
        let mut fit = FrameFit::new(images.collect());
        let mut off = |mm: f64| mm + VOXEL_MM * random.random_range(-0.2..0.2);
        fit.extend(truth.iter().map(|p| Particle { at_mm: p.at_mm.map(&mut off), ..*p }));
        fit.render(cameras);
        (fit, truth)
    }

    fn stepped(cameras: &[PointCamera], steps: usize) -> (FrameFit, Vec<Particle>) {
        let (mut fit, truth) = misplaced(cameras);
        let all: Vec<usize> = (0..PARTICLES).collect();
        (0..steps).for_each(|_| fit.step(cameras, &all, &PRIOR, &RULE));
        (fit, truth)
    }

    #[test]
    fn batches_hold_every_particle_once_and_no_neighbours() {
        for count in [0, 1, 15, 16, 17, 1000, 1024, 1025, 3000] {
            let in_order: Vec<usize> = (0..count).collect();
            let batches: Vec<Vec<usize>> = batches(&in_order).collect();
            assert!(batches.iter().all(|batch| (1..=BATCH).contains(&batch.len())), "{count}");
            let apart = |batch: &Vec<usize>| batch.windows(2).all(|two| two[1] - two[0] == STRIDE);
            assert!(batches.iter().all(apart), "{count}");
            let mut all: Vec<usize> = batches.into_iter().flatten().collect();
            all.sort_unstable();
            assert_eq!(all, in_order);
        }
    }

    /// Most of these images overlap with many others.
    #[test]
    fn particles_find_their_places() {
        let cameras = cameras();
        let off_vox = |(fit, truth): (FrameFit, Vec<Particle>)| {
            let off = fit.particles.iter().zip(&truth).map(|(found, truth)| {
                let square = |n: usize| (found.at_mm[n] - truth.at_mm[n]).powi(2);
                (0..3).map(square).sum::<f64>().sqrt() / VOXEL_MM
            });
            crate::statistics::median(off).unwrap()
        };
        let [before, after] = [0, 6].map(|steps| off_vox(stepped(&cameras, steps)));
        assert!(before > 0.15 && after < 0.01, "{before} {after}");
    }

    /// What removed and added images leave in the model is far below the noise.
    fn assert_model_is_that_of_the_particles(fit: &FrameFit, cameras: &[PointCamera]) {
        let mut rendered = fit.clone();
        rendered.render(cameras);
        let all: Vec<usize> = (0..fit.particles.len()).collect();
        let of = |fit: &FrameFit| fit.equations_by_camera(cameras, &all);
        for (one, other) in of(fit).iter().flatten().zip(of(&rendered).iter().flatten()) {
            let (one, other) = (&one.normal, &other.normal);
            for n in 0..3 + CAMERAS {
                let scale = other.matrix[(n, n)].sqrt();
                assert!((one.right[n] - other.right[n]).abs() <= 1e-2 * scale, "{one:?} {other:?}");
            }
        }
    }

    #[test]
    fn the_model_is_that_of_the_particles() {
        let cameras = cameras();
        let (mut fit, _) = stepped(&cameras, 3);
        assert_model_is_that_of_the_particles(&fit, &cameras);
        fit.particles[3].light = [0.1 * LIGHT; CAMERAS];
        fit.particles[7].at_mm = fit.particles[8].at_mm.map(|mm| mm + 0.02);
        fit.render(&cameras);
        fit.prune(&cameras, &PRIOR, (0.25, 0.04));
        assert!(fit.particles.len() <= PARTICLES - 2);
        assert_model_is_that_of_the_particles(&fit, &cameras);
    }

    #[test]
    fn threads_do_not_change_a_step() {
        let cameras = cameras();
        let with = |threads: usize| {
            let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| stepped(&cameras, 2).0.particles)
        };
        assert_eq!(with(1), with(3));
    }
}
