//! What is not as drawn in one camera: a `[[simulation.camera]]` table of the configuration.

use garde::Validate;
use lfpiv_hw::check::finite;
use serde::{Deserialize, Serialize};

/// How one camera differs from the bench that a reconstruction is told of. By default in nothing.
///
/// Rays are traced through all of it; no map is fitted here. Directions are those of docs/theory.md,
/// section 2: `right` and `up` are the sensor's axes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct CameraFlaws {
    /// How far the camera is turned about the world's x, then y, then z axis, in degrees. It turns
    /// about its point in focus on the optical axis; `camera_shift_mm` then moves it.
    #[garde(inner(custom(finite), range(min = -45.0, max = 45.0)))]
    pub turn_deg: [f64; 3],
    /// How far the microlens array is turned on its sensor about the array's centre, in degrees,
    /// from `right` towards `up`.
    #[garde(custom(finite), range(min = -45.0, max = 45.0))]
    pub array_rotation_deg: f64,
    /// Where the array's centre lies along `right` and `up` of the sensor, in mm.
    #[garde(inner(custom(finite), range(min = -10.0, max = 10.0)))]
    pub array_shift_mm: [f64; 2],
    /// True pitch along the array's two axes, relative to the optics' pitch.
    #[garde(inner(custom(finite), range(min = 0.5, max = 2.0)))]
    pub array_pitch_scale: [f64; 2],
    /// Where the main lens puts image points.
    #[garde(dive)]
    pub distortion: Distortion,
    /// How far the aperture stop, through which all rays go, stands behind the thin lens, in mm;
    /// negative in front of it, where it is the stop's image that counts. The stop has the size
    /// that keeps the working f-number.
    #[garde(custom(finite), range(min = -5000.0, max = 5000.0))]
    pub exit_pupil_mm: f64,
    /// True f-number, relative to the optics' f-number: the stop is wider below 1.
    #[garde(custom(finite), range(min = 0.1, max = 10.0))]
    pub f_number_scale: f64,
    /// A second aperture, which cuts rays to the edge of the field off.
    #[garde(dive)]
    pub vignetting: Option<SecondAperture>,
    /// A window between camera and particles, and what is behind it.
    #[garde(dive)]
    pub wall: Option<WallSettings>,
    /// Specks on the sensor.
    #[garde(dive)]
    pub dust: Dust,
    /// Microlenses that let no light through.
    #[garde(range(max = 100_000))]
    pub dead_microlenses: usize,
    /// Which specks and dead microlenses: the same in all images, whatever the run's seed.
    #[garde(skip)]
    pub blemish_seed: u64,
    /// Standard deviation of the blur on the sensor besides diffraction, in pixels: crosstalk.
    #[garde(custom(finite), range(min = 0.0, max = 10.0))]
    pub blur_px: f64,
    /// Counts per photo-electron, relative to those of the sensor. (Light that differs between
    /// cameras and frames is a matter of the lighting.)
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

/// Distortion after Brown and Conrady, relative to the sensor's half diagonal r_h: with
/// x = X/r_h, y = Y/r_h of where the chief ray of an object point meets the microlens plane, all
/// of the point's rays meet it further by
/// r_h (k x r² + 2 p₁ x y + p₂ (r² + 2 x²)) along `right` and
/// r_h (k y r² + p₁ (r² + 2 y²) + 2 p₂ x y) along `up`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct Distortion {
    /// k: relative displacement at the half diagonal; positive is a pincushion.
    #[garde(custom(finite), range(min = -0.5, max = 0.5))]
    pub radial: f64,
    /// p₁ and p₂.
    #[garde(inner(custom(finite), range(min = -0.5, max = 0.5)))]
    pub tangential: [f64; 2],
}

/// A circular aperture besides the stop, centred on the optical axis: mechanical vignetting.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct SecondAperture {
    /// Its radius, in mm.
    #[garde(custom(finite), range(min = 0.01, max = 1000.0))]
    pub radius_mm: f64,
    /// How far behind the thin lens it stands, in mm; negative in front of it.
    #[garde(custom(finite), range(min = -1000.0, max = 1000.0))]
    pub behind_lens_mm: f64,
}

/// A flat wall of glass with particles in a medium behind it, and air on the camera's side.
///
/// It stands where the camera's pose says that it should, whatever `turn_deg` and
/// `camera_shift_mm` do to the camera. The camera is set up through it: it keeps its direction, its
/// optical axis passes through the pose's origin, and that is in focus paraxially. To that end the
/// equivalent distances in air of the two principal planes (equal for a wall without tilt) are
/// on average the object distance.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct WallSettings {
    /// From the pose's origin along the camera's axis to the face that the medium wets, in mm.
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
    /// How far the wall is tilted about the camera's `right`, then about its `up`, in degrees,
    /// against a wall that the optical axis meets at right angles.
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

/// Round specks that lie on the sensor anywhere.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct Dust {
    /// How many there are.
    #[garde(range(max = 100_000))]
    pub specks: usize,
    /// Radius, in mm.
    #[garde(custom(finite), range(min = 0.0, max = 1.0))]
    pub radius_mm: f64,
    /// Share of the light that passes.
    #[garde(custom(finite), range(min = 0.0, max = 1.0))]
    pub transmission: f64,
}

impl Default for Dust {
    fn default() -> Self {
        Self { specks: 0, radius_mm: 0.02, transmission: 0.5 }
    }
}
