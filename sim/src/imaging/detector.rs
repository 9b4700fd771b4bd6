//! Maps rays on the microlens plane to pixels.

use lfpiv_hw::Optics;
use rand::RngExt;
use rand_distr::StandardNormal;
use rand_pcg::Pcg64Mcg;

use super::{cells::Cells, flaws::CameraFlaws, main_lens::MainLens, microlenses::Microlenses};

/// Microlens array and sensor.
#[derive(Debug, Clone)]
pub(super) struct Detector {
    microlenses: Microlenses,
    /// f_m / (s_i − d), where d is the distance of the stop behind the main lens.
    slope: f64,
    pixel_columns: Cells,
    pixel_rows: Cells,
    columns: u32,
    diffraction: Option<DiffractionBlur>,
}

/// Standard deviations of the diffraction blur, in mm.
#[derive(Debug, Clone)]
struct DiffractionBlur {
    on_microlenses_mm: f64,
    on_sensor_mm: f64,
}

impl DiffractionBlur {
    /// Gaussians with the core of the Airy pattern, σ = 0.42 λ N (Zhang, Zerubia and Olivo-Marin
    /// 2007), at the working f-numbers of the main lens and of a microlens.
    fn new(optics: &Optics, wavelength_nm: f64) -> Self {
        let sigma_mm = |f_number: f64| 0.42 * wavelength_nm * 1e-6 * f_number;
        let lens = &optics.microlens;
        Self {
            on_microlenses_mm: sigma_mm(optics.image_distance_mm() / optics.pupil_diameter_mm()),
            on_sensor_mm: sigma_mm(lens.focal_length_mm / lens.pitch_mm),
        }
    }
}

impl Detector {
    pub(super) fn new(
        optics: &Optics,
        lens: &MainLens,
        flaws: &CameraFlaws,
        diffraction_nm: Option<f64>,
    ) -> Self {
        let (microlens, sensor) = (&optics.microlens, &optics.sensor);
        let pixel_pitch_mm = optics.pixel_pitch_mm();
        Self {
            microlenses: Microlenses::new(microlens, flaws),
            slope: microlens.focal_length_mm / lens.stop_to_microlenses_mm(),
            pixel_columns: Cells::new(pixel_pitch_mm, sensor.columns),
            pixel_rows: Cells::new(pixel_pitch_mm, sensor.rows),
            columns: sensor.columns as u32,
            diffraction: diffraction_nm.map(|nm| DiffractionBlur::new(optics, nm)),
        }
    }

    /// Index of the pixel hit by the ray that passes the microlens plane at `plane_mm` and the stop
    /// at `stop_mm`. The microlens with the nearest centre X_c sends it to X_c + f_m (x − u)/(s_i −
    /// d). `None` outside the array or the sensor, or for an opaque microlens.
    #[inline]
    pub(super) fn pixel(
        &self,
        mut plane_mm: [f64; 2],
        stop_mm: [f64; 2],
        rng: &mut Pcg64Mcg,
    ) -> Option<u32> {
        if let Some(blur) = &self.diffraction {
            spread(&mut plane_mm, blur.on_microlenses_mm, rng);
        }
        let centre_mm = self.microlenses.nearest_centre_mm(plane_mm)?;
        let mut sensor_mm: [f64; 2] = std::array::from_fn(|axis| {
            centre_mm[axis] + self.slope * (plane_mm[axis] - stop_mm[axis])
        });
        if let Some(blur) = &self.diffraction {
            spread(&mut sensor_mm, blur.on_sensor_mm, rng);
        }
        let column = self.pixel_columns.nearest(sensor_mm[0])?;
        // Rows count downwards, against `up`.
        let row = self.pixel_rows.nearest(-sensor_mm[1])?;
        Some(row * self.columns + column)
    }

    /// Column and row, counted from 0 at the centre of the first pixel, of the ray through the
    /// centres of the stop and of a microlens: X_c (1 + f_m/(s_i − d)).
    pub(super) fn micro_image_centre_px(&self, lens: [f64; 2]) -> [f64; 2] {
        let [x_mm, y_mm] =
            self.microlenses.place_mm(lens).map(|place_mm| place_mm * (1.0 + self.slope));
        [self.pixel_columns.place(x_mm), self.pixel_rows.place(-y_mm)]
    }

    /// The microlens array.
    pub(super) fn microlenses(&self) -> &Microlenses {
        &self.microlenses
    }
}

fn spread(position_mm: &mut [f64; 2], sigma_mm: f64, rng: &mut Pcg64Mcg) {
    for coordinate in position_mm {
        let deviation: f64 = rng.sample(StandardNormal);
        *coordinate += sigma_mm * deviation;
    }
}
