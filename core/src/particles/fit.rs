//! The particles of one frame, and the model of its images that consists of them.

use rayon::prelude::*;

use super::{
    disagreement::ParticleEquations,
    image::ParticleImage,
    normal::{Normal, Particle},
    order::image_order,
};
use crate::model::{PointCamera, PointFootprint};

/// Least diameter of a point's light on the microlens array, in pitches, for which the derivatives of its image give
/// the uncertainty of its position (docs/decisions.md).
const LEAST_SPREAD_PITCHES: f64 = 0.9;

/// Images and particles of one frame.
#[derive(Debug, Clone)]
pub struct FrameFit {
    /// Per camera.
    pub images: Vec<ParticleImage>,
    /// The particles of the images' model.
    pub particles: Vec<Particle>,
    /// Length of each particle's last step, in mm.
    pub steps_mm: Vec<f64>,
    /// Per camera, the particles of the model in the order of their images.
    pub(super) orders: Vec<Vec<u32>>,
}

impl FrameFit {
    /// A frame without particles.
    pub fn new(images: Vec<ParticleImage>) -> Self {
        Self { images, particles: Vec::new(), steps_mm: Vec::new(), orders: Vec::new() }
    }

    /// Adds particles; the model does not hold them before [`Self::render`].
    pub fn extend(&mut self, particles: impl IntoIterator<Item = Particle>) {
        self.particles.extend(particles);
        self.steps_mm.resize(self.particles.len(), f64::INFINITY);
    }

    /// Removes particles; the model holds them until [`Self::render`].
    pub fn remove(&mut self, gone: &[bool]) {
        fn retain<T>(all: &mut Vec<T>, gone: &[bool]) {
            let mut gone = gone.iter();
            all.retain(|_| gone.next().is_none_or(|gone| !gone));
        }
        retain(&mut self.particles, gone);
        retain(&mut self.steps_mm, gone);
    }

    /// Sets the relative error of the model, which bounds the weight of bright pixels.
    pub fn set_model_error(&mut self, misfit: f32) {
        self.images.iter_mut().for_each(|image| image.noise.misfit = misfit);
    }

    /// Renders the model of all particles from scratch.
    pub fn render(&mut self, cameras: &[PointCamera]) {
        let order = |camera| image_order(camera, &self.particles);
        self.orders = cameras.par_iter().map(order).collect();
        let mut images = std::mem::take(&mut self.images);
        let each = images.par_iter_mut().zip(cameras).enumerate();
        each.for_each(|(c, (image, camera))| self.render_in(image, camera, c));
        self.images = images;
    }

    /// Makes `image` the model of all particles as `camera`, which is number `c`, images them. They are taken in the
    /// order of their images.
    pub fn render_in(&self, image: &mut ParticleImage, camera: &PointCamera, c: usize) {
        image.clear();
        let mut footprint = PointFootprint::default();
        for &n in &self.orders[c] {
            let particle = &self.particles[n as usize];
            camera.image(particle.at_mm, &mut footprint);
            image.add(camera, &footprint, particle.light[c] as f32);
        }
    }

    /// What `act` makes of the numbered particles in camera number `c`, in their order. They are taken in the
    /// order of their images.
    fn in_camera<T: Send + Clone + Default>(
        &self,
        c: usize,
        of: &[usize],
        act: impl Fn(&mut PointFootprint, &Particle) -> T + Sync,
    ) -> Vec<T> {
        let places = places_in(of, self.particles.len());
        let order: Vec<usize> = self.orders[c].iter().filter_map(|&n| places[n as usize]).collect();
        let made: Vec<T> = order
            .par_iter()
            .with_min_len(64)
            .map_init(PointFootprint::default, |footprint, &k| {
                act(footprint, &self.particles[of[k]])
            })
            .collect();
        let mut in_order = vec![T::default(); of.len()];
        order.into_iter().zip(made).for_each(|(k, made)| in_order[k] = made);
        in_order
    }

    /// Per camera, the equations of the numbered particles that it sees across several microlenses, for covariances.
    ///
    /// Near a camera's focal plane all light of a particle is behind one microlens, and its image changes only
    /// where it crosses to the next. The linear covariance does not hold there: that camera is left out.
    pub fn equations_by_camera(
        &self,
        cameras: &[PointCamera],
        of: &[usize],
    ) -> Vec<Vec<ParticleEquations>> {
        let by_camera = |(c, camera): (usize, &PointCamera)| {
            self.in_camera(c, of, |footprint, particle| {
                let mut both = ParticleEquations::default();
                if camera.spread_pitches(particle.at_mm) >= LEAST_SPREAD_PITCHES {
                    camera.image_and_derivatives(particle.at_mm, footprint);
                    let (image, light) = (&self.images[c], particle.light[c]);
                    let equations = image.equations(camera, footprint);
                    let gradient = image.gradient_covariance(camera, footprint);
                    both.normal.add(&equations, &footprint.by_place, light, c);
                    both.gradient.add(&gradient, &footprint.by_place, light, c);
                }
                both
            })
        };
        cameras.iter().enumerate().map(by_camera).collect()
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
}

/// Where each of `count` particles is in the list `of` of their numbers.
fn places_in(of: &[usize], count: usize) -> Vec<Option<usize>> {
    let mut places = vec![None; count];
    of.iter().enumerate().for_each(|(place, &n)| places[n] = Some(place));
    places
}
