//! Deviations of one camera from its nominal properties: a `[[simulation.camera]]` table.

use garde::Validate;
use lfpiv_hw::check::finite;
use serde::{Deserialize, Serialize};

/// Differences between a camera and the configured bench that the reconstruction assumes. By
/// default there are none.
///
/// Rays are traced through all of them; no map is fitted here. Directions are those of
/// docs/theory.md, section 2: `right` and `up` are the sensor's axes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct CameraFlaws {
    /// Rotation of the camera about the world's x, then y, then z axis, in degrees, around its
    /// point in focus on the optical axis. `camera_shift_mm` is applied afterwards.
    #[garde(inner(custom(finite), range(min = -45.0, max = 45.0)))]
    pub turn_deg: [f64; 3],
    /// Rotation of the microlens array on its sensor about the array's centre, in degrees, from
    /// `right` towards `up`.
    #[garde(custom(finite), range(min = -45.0, max = 45.0))]
    pub array_rotation_deg: f64,
    /// Position of the array's centre along `right` and `up` of the sensor, in mm.
    #[garde(inner(custom(finite), range(min = -10.0, max = 10.0)))]
    pub array_shift_mm: [f64; 2],
    /// True pitch along the array's two axes, relative to the optics' pitch.
    #[garde(inner(custom(finite), range(min = 0.5, max = 2.0)))]
    pub array_pitch_scale: [f64; 2],
    /// Distortion of the main lens.
    #[garde(dive)]
    pub distortion: Distortion,
    /// Distance of the aperture stop behind the thin lens, in mm; for a stop in front of the lens,
    /// the (negative) distance of its image. All rays pass the stop. Its size keeps the working
    /// f-number.
    #[garde(custom(finite), range(min = -5000.0, max = 5000.0))]
    pub exit_pupil_mm: f64,
    /// True f-number relative to the nominal one; below 1 the stop is wider.
    #[garde(custom(finite), range(min = 0.1, max = 10.0))]
    pub f_number_scale: f64,
    /// A second aperture, which cuts off rays towards the edge of the field.
    #[garde(dive)]
    pub vignetting: Option<SecondAperture>,
    /// A window between camera and particles, and the medium behind it.
    #[garde(dive)]
    pub wall: Option<WallSettings>,
    /// Specks on the sensor.
    #[garde(dive)]
    pub dust: Dust,
    /// Number of opaque microlenses.
    #[garde(range(max = 100_000))]
    pub dead_microlenses: usize,
    /// Seed of specks and opaque microlenses, which are the same in all images and runs.
    #[garde(skip)]
    pub blemish_seed: u64,
    /// Standard deviation of the blur on the sensor in addition to diffraction, in pixels:
    /// crosstalk.
    #[garde(custom(finite), range(min = 0.0, max = 10.0))]
    pub blur_px: f64,
    /// Counts per photo-electron relative to the sensor settings. (Light that differs between
    /// cameras and frames is set in the lighting table.)
    #[garde(custom(finite), range(min = 1e-3, max = 1e3))]
    pub gain: f64,
}

impl Default for CameraFlaws {
    fn default() -> Self {
        Self {
            turn_deg: [0.0; 3],
            array_rotation_deg: 0.0,
            array_shift_mm: [0.0; 2],
            array_pitch_scale: [1.0; 2],
            distortion: Distortion::default(),
            exit_pupil_mm: 0.0,
            f_number_scale: 1.0,
            vignetting: None,
            wall: None,
            dust: Dust::default(),
            dead_microlenses: 0,
            blemish_seed: 1,
            blur_px: 0.0,
            gain: 1.0,
        }
    }
}

/// Distortion after Brown and Conrady, relative to the sensor's half diagonal r_h. With x = X/r_h
/// and y = Y/r_h, where (X, Y) is the position of an object point's chief ray on the microlens
/// plane, all rays of the point are displaced by r_h (k x r² + 2 p₁ x y + p₂ (r² + 2 x²)) along
/// `right` and r_h (k y r² + p₁ (r² + 2 y²) + 2 p₂ x y) along `up`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct Distortion {
    /// k: relative displacement at the half diagonal; positive for pincushion distortion.
    #[garde(custom(finite), range(min = -0.5, max = 0.5))]
    pub radial: f64,
    /// p₁ and p₂.
    #[garde(inner(custom(finite), range(min = -0.5, max = 0.5)))]
    pub tangential: [f64; 2],
}

/// A circular aperture in addition to the stop, centred on the optical axis: mechanical vignetting.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct SecondAperture {
    /// Its radius, in mm.
    #[garde(custom(finite), range(min = 0.01, max = 1000.0))]
    pub radius_mm: f64,
    /// Distance behind the thin lens, in mm; negative in front of it.
    #[garde(custom(finite), range(min = -1000.0, max = 1000.0))]
    pub behind_lens_mm: f64,
}

/// A flat glass wall with particles in a medium behind it, and air on the camera's side.
///
/// Its position follows from the camera's nominal pose and does not change with `turn_deg` and
/// `camera_shift_mm`. The camera is set up through the wall: it keeps its direction, its optical
/// axis passes through the pose's origin, and the origin is in paraxial focus. For this, the mean
/// of the equivalent distances in air in the two principal planes (equal without tilt) is the
/// object distance.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct WallSettings {
    /// Distance from the pose's origin along the camera's axis to the wet face, in mm.
    #[garde(custom(finite), range(min = 0.0, max = 5000.0))]
    pub distance_mm: f64,
    /// Thickness of the glass, in mm.
    #[garde(custom(finite), range(min = 0.0, max = 1000.0))]
    pub thickness_mm: f64,
    /// Refractive index of the glass.
    #[garde(custom(finite), range(min = 1.0, max = 3.0))]
    pub glass_index: f64,
    /// Refractive index of the medium.
    #[garde(custom(finite), range(min = 1.0, max = 3.0))]
    pub medium_index: f64,
    /// Tilt of the wall about the camera's `right`, then about its `up`, in degrees, relative to a
    /// wall perpendicular to the optical axis.
    #[garde(inner(custom(finite), range(min = -45.0, max = 45.0)))]
    pub tilt_deg: [f64; 2],
}

impl Default for WallSettings {
    fn default() -> Self {
        Self {
            distance_mm: 30.0,
            thickness_mm: 5.0,
            glass_index: 1.5,
            medium_index: 1.333,
            tilt_deg: [0.0; 2],
        }
    }
}

/// Round specks at random positions on the sensor.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct Dust {
    /// Number of specks.
    #[garde(range(max = 100_000))]
    pub specks: usize,
    /// Radius, in mm.
    #[garde(custom(finite), range(min = 0.0, max = 1.0))]
    pub radius_mm: f64,
    /// Transmitted share of the light.
    #[garde(custom(finite), range(min = 0.0, max = 1.0))]
    pub transmission: f64,
}

impl Default for Dust {
    fn default() -> Self {
        Self { specks: 0, radius_mm: 0.02, transmission: 0.5 }
    }
}
