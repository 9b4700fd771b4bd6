//! A row of the report: one method on one case with one seed.

use serde::{Deserialize, Serialize};

use super::{Stamp, particle_score::ParticleScore};

/// What was measured, what came out, and where. Absent figures were not part of the measurement.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// Set of the case.
    pub set: String,
    /// Case.
    pub case: String,
    /// What was measured.
    pub measure: String,
    /// Method by name; `configured` for the configuration's own settings.
    pub method: String,
    /// Other program that made the row; ours when absent.
    pub peer: Option<String>,
    /// Flow.
    pub flow: String,
    /// Particles per microlens.
    pub ppm: f64,
    /// `on-grid` or `off-grid`.
    pub placement: String,
    /// Noise of the images.
    pub noise: String,
    /// Number of cameras.
    pub cameras: usize,
    /// Voxel counts of the volume.
    pub voxels: String,
    /// Edge of a voxel, in mm.
    pub voxel_mm: f64,
    /// Seed of the random numbers.
    pub seed: u64,
    /// Where a single particle is, as a depth from camera 1's focal plane in mm.
    pub depth_mm: Option<f64>,
    /// Single particles that the figures are means over.
    pub positions: Option<usize>,
    /// Passes over all views.
    pub iterations: Option<usize>,
    /// Wall-clock time, in s.
    pub seconds: Option<f64>,
    /// What the seconds are of.
    pub seconds_of: String,
    /// Processor time of all threads, in s.
    pub cpu_s: Option<f64>,
    /// Seconds over those of the reference kernel.
    pub kernel_ratio: Option<f64>,
    /// Time to assemble a matrix, in s, not part of `seconds`.
    pub assembly_s: Option<f64>,
    /// Images to views, in s.
    pub decode_s: Option<f64>,
    /// Views to volumes, in s.
    pub reconstruct_s: Option<f64>,
    /// Volumes to vectors, in s.
    pub correlate_s: Option<f64>,
    pub judge_s: Option<f64>,
    /// Peak resident memory, in MB (10⁶ bytes).
    pub peak_mb: Option<f64>,
    /// Quality factor (paper, Eq. 5).
    pub q: Option<f64>,
    /// Reconstruction error (paper, Eq. 3) over that of a dark volume.
    pub relative_error: Option<f64>,
    /// Vectors of the field.
    pub vectors: Option<usize>,
    /// Share of the vectors that are valid.
    pub valid_share: Option<f64>,
    /// Mean |error| of the displacement along x, in voxels (paper, Eq. 6).
    pub error_x_vox: Option<f64>,
    /// Along y.
    pub error_y_vox: Option<f64>,
    /// Along z.
    pub error_z_vox: Option<f64>,
    /// The same at random places between the vectors, by cubic convolution.
    pub unseen_x_vox: Option<f64>,
    /// Along y.
    pub unseen_y_vox: Option<f64>,
    /// Along z.
    pub unseen_z_vox: Option<f64>,
    /// Length of the plane wave that the flow is.
    pub wavelength_vox: Option<f64>,
    /// Amplitude of its displacement.
    pub amplitude_vox: Option<f64>,
    /// What of that is measured: least squares over the vectors 12 voxels or more inside the volume.
    pub gain: Option<f64>,
    /// True particles, windows only: mean |error| along x when the true particles are correlated by
    /// the same windows and passes, and single ones are not followed. Measured images can be below it
    /// where single particles are followed in them.
    pub true_windows_x_vox: Option<f64>,
    /// Along y.
    pub true_windows_y_vox: Option<f64>,
    /// Along z.
    pub true_windows_z_vox: Option<f64>,
    /// True particles, followed: mean |error| along x when single ones are followed after the windows,
    /// as in the images. What is above it comes from images and reconstruction. Absent where the
    /// configuration follows none.
    pub true_followed_x_vox: Option<f64>,
    /// Along y.
    pub true_followed_y_vox: Option<f64>,
    /// Along z.
    pub true_followed_z_vox: Option<f64>,
    /// Share of the x components within 0.3 voxels; those of invalid vectors count as misses.
    pub within_x: Option<f64>,
    /// Of the y components.
    pub within_y: Option<f64>,
    /// Of the z components.
    pub within_z: Option<f64>,
    /// Share of the valid vectors' components within one stated standard uncertainty of the truth;
    /// 68 % where uncertainties are right.
    pub covered_68: Option<f64>,
    /// Within 1.96; 95 % where they are right.
    pub covered_95: Option<f64>,
    /// Share of the particles lit in both frames that were placed within 0.2 voxel.
    pub particles_found: Option<f64>,
    /// Of those further than 0.8 mm from every camera's focal plane.
    pub particles_found_far: Option<f64>,
    /// Of those nearer to one.
    pub particles_found_near: Option<f64>,
    /// Share of the placed particles without a true one within 0.5 voxel.
    pub particles_false: Option<f64>,
    /// Median |error| of the components of placed particles' displacements, in voxels.
    pub particles_median_error_vox: Option<f64>,
    /// Mean.
    pub particles_mean_error_vox: Option<f64>,
    /// Full width at half maximum along z, in mm.
    pub fwhm_mm: Option<f64>,
    /// Mean |error| of the intensity-weighted centroid along z, in mm.
    pub centroid_error_mm: Option<f64>,
    /// Explicit weight matrix of all views, in MB.
    pub matrix_mb: Option<f64>,
    /// Largest matrix of an ordered subset, in MB.
    pub subset_matrix_mb: Option<f64>,
    /// Shots per second that were asked for of a bench at the ends of wires.
    pub rate_hz: Option<f64>,
    /// Share of its shots whose frames all arrived whole.
    pub whole_share: Option<f64>,
    /// Frames per second and camera.
    pub frames_per_s: Option<f64>,
    /// Pixel data per second and camera, in MB.
    pub mb_per_s: Option<f64>,
    /// Copies of a frame's pixels after the network's own.
    pub copies_per_frame: Option<usize>,
    /// Threads.
    pub threads: usize,
    /// Processor model.
    pub machine: String,
    /// Logical processors.
    pub cores: usize,
    /// Code version: ours, or the peer's.
    pub version: String,
    /// Day and time of the run's start.
    pub date: String,
}

impl Row {
    /// Notes where the row was made, and relates its seconds to the reference kernel's.
    pub fn stamp(&mut self, stamp: &Stamp, kernel_seconds: f64) {
        self.threads = stamp.threads;
        self.machine = stamp.machine.clone();
        self.cores = stamp.cores;
        self.version = stamp.version.clone();
        self.date = stamp.date.clone();
        self.kernel_ratio = self.seconds.map(|seconds| seconds / kernel_seconds);
    }

    /// Mean |error| along x, y, z, in voxels.
    pub fn error_vox(&self) -> Option<[f64; 3]> {
        Some([self.error_x_vox?, self.error_y_vox?, self.error_z_vox?])
    }

    /// Mean |error| between the vectors along x, y, z, in voxels.
    pub fn unseen_vox(&self) -> Option<[f64; 3]> {
        Some([self.unseen_x_vox?, self.unseen_y_vox?, self.unseen_z_vox?])
    }

    /// True particles, windows only, along x, y, z, in voxels.
    pub fn true_windows_vox(&self) -> Option<[f64; 3]> {
        Some([self.true_windows_x_vox?, self.true_windows_y_vox?, self.true_windows_z_vox?])
    }

    /// True particles, followed, along x, y, z, in voxels.
    pub fn true_followed_vox(&self) -> Option<[f64; 3]> {
        Some([self.true_followed_x_vox?, self.true_followed_y_vox?, self.true_followed_z_vox?])
    }

    /// Shares within 0.3 voxels along x, y, z.
    pub fn within(&self) -> Option<[f64; 3]> {
        Some([self.within_x?, self.within_y?, self.within_z?])
    }

    pub(super) fn set_particles(&mut self, score: &ParticleScore) {
        let [all, far, near] = score.found;
        self.particles_found = all;
        (self.particles_found_far, self.particles_found_near) = (far, near);
        self.particles_false = Some(score.wrong);
        let [median, mean] = score.error_vox.map(Some);
        (self.particles_median_error_vox, self.particles_mean_error_vox) = (median, mean);
        (self.covered_68, self.covered_95) = (Some(score.covered[0]), Some(score.covered[1]));
    }

    pub(super) fn set_error(&mut self, [x, y, z]: [f64; 3]) {
        (self.error_x_vox, self.error_y_vox, self.error_z_vox) = (Some(x), Some(y), Some(z));
    }

    pub(super) fn set_unseen(&mut self, errors_vox: [f64; 3]) {
        let [x, y, z] = errors_vox.map(Some);
        (self.unseen_x_vox, self.unseen_y_vox, self.unseen_z_vox) = (x, y, z);
    }

    pub(super) fn set_true_windows(&mut self, errors_vox: [f64; 3]) {
        let [x, y, z] = errors_vox.map(Some);
        (self.true_windows_x_vox, self.true_windows_y_vox, self.true_windows_z_vox) = (x, y, z);
    }

    pub(super) fn set_true_followed(&mut self, errors_vox: [f64; 3]) {
        let [x, y, z] = errors_vox.map(Some);
        (self.true_followed_x_vox, self.true_followed_y_vox, self.true_followed_z_vox) = (x, y, z);
    }

    pub(super) fn set_within(&mut self, [x, y, z]: [f64; 3]) {
        (self.within_x, self.within_y, self.within_z) = (Some(x), Some(y), Some(z));
    }
}
