//! Damped Gauss–Newton for many particles at once: block-diagonal, every particle steps against the common
//! residual images.

use rayon::prelude::*;

use super::{
    image::ParticleImage,
    normal::{LightPrior, Normal, Particle, StepRule},
};
use crate::model::{PointCamera, PointFootprint};

/// Least diameter of a point's light on the microlens array, in pitches, at which the derivatives of its image
/// say how well its place is known (docs/decisions.md).
const LEAST_SPREAD_PITCHES: f64 = 0.9;

/// Images and particles of one frame.
#[derive(Debug, Clone)]
pub struct FrameFit {
    /// Per camera.
    pub images: Vec<ParticleImage>,
    /// The particles; the images' model is theirs.
    pub particles: Vec<Particle>,
    /// Length of each particle's last step, in mm.
    pub steps_mm: Vec<f64>,
}

impl FrameFit {
    /// A frame without particles.
    pub fn new(images: Vec<ParticleImage>) -> Self {
        Self { images, particles: Vec::new(), steps_mm: Vec::new() }
    }

    /// Adds particles; the model does not hold them before [`Self::render`].
    pub fn extend(&mut self, particles: impl IntoIterator<Item = Particle>) {
        self.particles.extend(particles);
        self.steps_mm.resize(self.particles.len(), f64::INFINITY);
    }

    /// Sets the relative error of the model, which bounds the weight of bright pixels.
    pub fn set_model_error(&mut self, misfit: f32) {
        self.images.iter_mut().for_each(|image| image.noise.misfit = misfit);
    }

    /// Renders the model of all particles from scratch.
    pub fn render(&mut self, cameras: &[PointCamera]) {
        let particles = &self.particles;
        self.images.par_iter_mut().zip(cameras).enumerate().for_each(|(c, (image, camera))| {
            image.clear();
            let mut footprint = PointFootprint::default();
            for particle in particles {
                camera.image(particle.at_mm, &mut footprint);
                image.add(camera, &footprint, particle.light[c] as f32);
            }
        });
    }

    /// The normal equations of the numbered particles.
    pub fn equations(&self, cameras: &[PointCamera], of: &[usize]) -> Vec<Normal> {
        of.par_iter()
            .with_min_len(64)
            .map_init(PointFootprint::default, |footprint, &n| {
                let particle = &self.particles[n];
                let mut normal = Normal::default();
                for (c, camera) in cameras.iter().enumerate() {
                    camera.image_and_derivatives(particle.at_mm, footprint);
                    let equations = self.images[c].equations(camera, footprint);
                    normal.add(&equations, &footprint.by_place, particle.light[c], c);
                }
                normal
            })
            .collect()
    }

    /// What the images say of the lights of all particles alone.
    fn light_equations(&self, cameras: &[PointCamera]) -> Vec<Normal> {
        let light = |footprint: &mut PointFootprint, particle: &Particle| {
            let mut normal = Normal::default();
            for (c, camera) in cameras.iter().enumerate() {
                camera.image(particle.at_mm, footprint);
                let [pull, weight] = self.images[c].light_equation(camera, footprint);
                normal.add_light(c, pull, weight);
            }
            normal
        };
        self.particles
            .par_iter()
            .with_min_len(64)
            .map_init(PointFootprint::default, light)
            .collect()
    }

    /// Steps the lights of all particles, whose places stay.
    pub fn step_lights(&mut self, cameras: &[PointCamera], prior: &LightPrior, rule: &StepRule) {
        let normals = self.light_equations(cameras);
        for (particle, normal) in self.particles.iter_mut().zip(&normals) {
            *particle = normal.stepped(particle, cameras.len(), prior, rule).0;
        }
        self.render(cameras);
    }

    /// Covariances of the places of the numbered particles, in mm², from the cameras that see them across
    /// several microlenses.
    ///
    /// Near a camera's focal plane all light of a particle is behind one microlens, and its image changes only
    /// where it crosses to the next. The linear covariance does not hold there: that camera is left out.
    pub fn covariances_mm2(
        &self,
        cameras: &[PointCamera],
        of: &[usize],
        (prior, voxel_mm): (&LightPrior, f64),
    ) -> Vec<[[f64; 3]; 3]> {
        let covariance = |footprint: &mut PointFootprint, &n: &usize| {
            let particle = &self.particles[n];
            let (mut normal, mut gradient) = (Normal::default(), Normal::default());
            for (c, camera) in cameras.iter().enumerate() {
                if camera.spread_pitches(particle.at_mm) < LEAST_SPREAD_PITCHES {
                    continue;
                }
                camera.image_and_derivatives(particle.at_mm, footprint);
                let light = particle.light[c];
                let equations = self.images[c].equations(camera, footprint);
                normal.add(&equations, &footprint.by_place, light, c);
                let equations = self.images[c].gradient_covariance(camera, footprint);
                gradient.add(&equations, &footprint.by_place, light, c);
            }
            normal.covariance_mm2(&gradient, particle, (cameras.len(), prior, voxel_mm))
        };
        of.par_iter().with_min_len(64).map_init(PointFootprint::default, covariance).collect()
    }

    /// The normal equations of a particle that is not in the model.
    pub fn equations_of_new(
        &self,
        cameras: &[PointCamera],
        particle: &Particle,
        footprint: &mut PointFootprint,
    ) -> Normal {
        let mut normal = Normal::default();
        for (c, camera) in cameras.iter().enumerate() {
            camera.image_and_derivatives(particle.at_mm, footprint);
            let mut equations = self.images[c].equations(camera, footprint);
            // Its own light is not in the model yet.
            let light = particle.light[c];
            for (n, right) in equations.right.iter_mut().enumerate() {
                *right -= light * equations.matrix[n];
            }
            normal.add(&equations, &footprint.by_place, light, c);
        }
        normal
    }

    /// One step of the numbered particles.
    pub fn step(
        &mut self,
        cameras: &[PointCamera],
        of: &[usize],
        prior: &LightPrior,
        rule: &StepRule,
    ) {
        let normals = self.equations(cameras, of);
        let moved: Vec<(Particle, f64)> = of
            .iter()
            .zip(&normals)
            .map(|(&n, normal)| normal.stepped(&self.particles[n], cameras.len(), prior, rule))
            .collect();
        if 2 * of.len() > self.particles.len() {
            self.take(of, &moved);
            self.render(cameras);
        } else {
            let before: Vec<Particle> = of.iter().map(|&n| self.particles[n]).collect();
            self.take(of, &moved);
            self.exchange(cameras, &before, of);
        }
    }

    fn take(&mut self, of: &[usize], moved: &[(Particle, f64)]) {
        for (&n, &(particle, step_mm)) in of.iter().zip(moved) {
            self.particles[n] = particle;
            self.steps_mm[n] = step_mm;
        }
    }

    /// Replaces the image of the numbered particles, as they were `before`, by their present one.
    fn exchange(&mut self, cameras: &[PointCamera], before: &[Particle], of: &[usize]) {
        let particles = &self.particles;
        self.images.par_iter_mut().zip(cameras).enumerate().for_each(|(c, (image, camera))| {
            let mut footprint = PointFootprint::default();
            for (old, &n) in before.iter().zip(of) {
                camera.image(old.at_mm, &mut footprint);
                image.add(camera, &footprint, -old.light[c] as f32);
                camera.image(particles[n].at_mm, &mut footprint);
                image.add(camera, &footprint, particles[n].light[c] as f32);
            }
        });
    }
}
