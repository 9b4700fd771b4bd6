//! What the images of all cameras say of one particle.

use lfpiv_hw::{Optics, Pose};
use nalgebra::{Matrix3, Matrix4, Vector3, Vector4};
use rand::RngExt;

use super::{SceneConditions, generator};
use crate::{
    lightfield::{MicrolensWindow, ViewLayout},
    measurement::Measurement,
    model::{ModelError, ModelParts, PointImager, VolumeGrid},
};

/// Particles over the volume from which the mean light of a pixel is found.
const SAMPLES: usize = 64;

/// All cameras, before the same particles.
pub(super) struct Cameras<'a> {
    optics: &'a Optics,
    poses: &'a [Pose],
    volume: &'a VolumeGrid,
    layout: ViewLayout,
    /// Photo-electrons of the mean particle in a view that is fully open.
    in_view: f64,
    /// Variance of a pixel of each camera, without the particle in question: light, sensor, other particles.
    variance: Vec<f64>,
}

impl<'a> Cameras<'a> {
    pub fn new(
        measurement: &'a Measurement,
        conditions: &SceneConditions,
        per_mm3: f64,
    ) -> Result<Self, ModelError> {
        let Measurement { optics, cameras, volume, .. } = measurement;
        let layout = ViewLayout::new(optics, MicrolensWindow::whole(optics));
        let pupil_mm2 = std::f64::consts::PI * (optics.pupil_diameter_mm() / 2.0).powi(2);
        let in_view = conditions.photoelectrons * optics.pupil_cell_mm().powi(2) / pupil_mm2;
        let mut all =
            Self { optics, poses: cameras, volume, layout, in_view, variance: Vec::new() };
        for camera in 0..cameras.len() {
            let variance = all.variance(camera, conditions, per_mm3)?;
            all.variance.push(variance);
        }
        Ok(all)
    }

    /// How each camera images points.
    ///
    /// # Errors
    /// One does not see the volume.
    pub fn imagers(&self) -> Result<Vec<PointImager<'_>>, ModelError> {
        (0..self.poses.len()).map(|camera| self.imager(camera)).collect()
    }

    fn imager(&self, camera: usize) -> Result<PointImager<'_>, ModelError> {
        let parts = ModelParts::default();
        let pose = &self.poses[camera];
        PointImager::new(self.optics, pose, camera, self.volume, &self.layout, 0.0, &parts)
    }

    /// The variance of a camera's pixel in which all particles may have light: Campbell's theorem for the mean
    /// and the variance of light that comes from places at random.
    fn variance(
        &self,
        camera: usize,
        conditions: &SceneConditions,
        per_mm3: f64,
    ) -> Result<f64, ModelError> {
        let (imager, pose) = (self.imager(camera)?, &self.poses[camera]);
        let size_mm = self.volume.voxels.map(|voxels| voxels as f64 * self.volume.voxel_mm);
        let mut random = generator(camera as u64);
        let (mut light, mut squares) = (0.0, 0.0);
        for _ in 0..SAMPLES {
            let place: Vector3<f64> = Vector3::from_fn(|axis, _| {
                self.volume.centre_mm[axis] + size_mm[axis] * (random.random::<f64>() - 0.5)
            });
            let image = imager.image(&pose.to_camera(&place.into()));
            for view in 0..self.layout.views.len() {
                image.pixels(view, |pixel| {
                    light += pixel.weight;
                    squares += pixel.weight.powi(2);
                });
            }
        }
        let per_particle = 1.0 / SAMPLES as f64;
        // Microlenses before the volume: each has a pixel of every view.
        let across = |direction: &Vector3<f64>| -> f64 {
            (0..3).map(|axis| direction[axis].abs() * size_mm[axis]).sum()
        };
        let face_mm2 = across(&pose.right) * across(&pose.up);
        let pixels =
            face_mm2 / self.optics.object_pitch_mm().powi(2) * self.layout.views.len() as f64;
        let particles = per_mm3 * size_mm.iter().product::<f64>();
        let per_pixel = particles * per_particle / pixels.max(1.0);
        let mean = per_pixel * light * self.in_view;
        let brightness = 1.0 + conditions.intensity_spread.powi(2) / 3.0;
        let others = per_pixel * squares * self.in_view.powi(2) * brightness;
        // Rounding adds the noise of a uniform distribution.
        let rounding = (12.0 * conditions.counts_per_electron.powi(2)).recip();
        let sensor = conditions.background_electrons + conditions.read_noise_electrons.powi(2);
        Ok(mean + others + sensor + rounding)
    }

    /// Fisher's information on the position of a particle at `place_mm`, in 1/mm², whatever its brightness.
    pub fn information(
        &self,
        imagers: &[PointImager<'_>],
        place_mm: &Vector3<f64>,
    ) -> Matrix3<f64> {
        let mut information = Matrix4::zeros();
        for ((imager, pose), variance) in imagers.iter().zip(self.poses).zip(&self.variance) {
            let image = imager.image(&pose.to_camera(&(*place_mm).into()));
            for view in 0..self.layout.views.len() {
                image.pixels(view, |pixel| {
                    let [right, up, axis] = pixel.gradient.map(|slope| slope * self.in_view);
                    let slope = pose.right * right + pose.up * up + pose.axis * axis;
                    // By position, and by relative brightness.
                    let light = pixel.weight * self.in_view;
                    let slopes = Vector4::new(slope.x, slope.y, slope.z, light);
                    information += slopes * slopes.transpose() / (variance + light.max(0.0));
                });
            }
        }
        marginal(&information)
    }
}

/// The information on the first three, where the fourth is unknown (Schur's complement).
fn marginal(information: &Matrix4<f64>) -> Matrix3<f64> {
    let position = information.fixed_view::<3, 3>(0, 0).into_owned();
    let both = information.fixed_view::<3, 1>(0, 3).into_owned();
    let brightness = information[(3, 3)];
    if brightness > 0.0 { position - both * both.transpose() / brightness } else { position }
}
