//! Microlenses and pixels: from a ray on the microlens plane to the pixel it hits.

use lfpiv_hw::Optics;
use rand::RngExt;
use rand_distr::StandardNormal;
use rand_pcg::Pcg64Mcg;

/// A row of equal cells centred on the optical axis, laid out for fast lookup.
#[derive(Debug, Clone)]
struct Cells {
    per_mm: f64,
    count: f64,
}

impl Cells {
    fn new(pitch_mm: f64, count: usize) -> Self {
        Self { per_mm: 1.0 / pitch_mm, count: count as f64 }
    }

    /// Index of the cell whose centre is nearest, or `None` outside the row.
    #[inline]
    fn nearest(&self, position_mm: f64) -> Option<u32> {
        let from_edge = position_mm * self.per_mm + self.count / 2.0;
        // Casting cuts the fraction off; `floor` would be a call on processors without SSE 4.1.
        (from_edge >= 0.0 && from_edge < self.count).then_some(from_edge as u32)
    }
}

/// Microlens array and sensor.
#[derive(Debug, Clone)]
pub(super) struct Detector {
    microlens_columns: Cells,
    microlens_rows: Cells,
    microlens_pitch_mm: f64,
    /// Centre of microlens (0, 0), in mm.
    first_microlens_mm: [f64; 2],
    /// f_m / s_i.
    slope: f64,
    pixel_columns: Cells,
    pixel_rows: Cells,
    columns: u32,
    diffraction: Option<DiffractionBlur>,
}

/// Standard deviations of the blur by diffraction, in mm.
#[derive(Debug, Clone)]
struct DiffractionBlur {
    on_microlenses_mm: f64,
    on_sensor_mm: f64,
}

impl DiffractionBlur {
    /// The Gaussian with the core of the Airy pattern, σ = 0.42 λ N (Zhang, Zerubia and
    /// Olivo-Marin 2007), at the working f-numbers of the main lens and of a microlens.
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
    pub(super) fn new(optics: &Optics, diffraction_nm: Option<f64>) -> Self {
        let (lens, sensor) = (&optics.microlens, &optics.sensor);
        let pixel_pitch_mm = optics.pixel_pitch_mm();
        Self {
            microlens_columns: Cells::new(lens.pitch_mm, lens.columns),
            microlens_rows: Cells::new(lens.pitch_mm, lens.rows),
            microlens_pitch_mm: lens.pitch_mm,
            first_microlens_mm: [lens.column_centre_mm(0), lens.row_centre_mm(0)],
            slope: lens.focal_length_mm / optics.image_distance_mm(),
            pixel_columns: Cells::new(pixel_pitch_mm, sensor.columns),
            pixel_rows: Cells::new(pixel_pitch_mm, sensor.rows),
            columns: sensor.columns as u32,
            diffraction: diffraction_nm.map(|nm| DiffractionBlur::new(optics, nm)),
        }
    }

    /// Index of the pixel hit by the ray that meets the microlens plane at `plane_mm` and comes
    /// from `pupil_mm`: the microlens with the nearest centre X_c sends it to
    /// X_c + f_m (x − U)/s_i. `None` beyond the array or the sensor.
    #[inline]
    pub(super) fn pixel(
        &self,
        mut plane_mm: [f64; 2],
        pupil_mm: [f64; 2],
        rng: &mut Pcg64Mcg,
    ) -> Option<u32> {
        if let Some(blur) = &self.diffraction {
            spread(&mut plane_mm, blur.on_microlenses_mm, rng);
        }
        let lens = [
            self.microlens_columns.nearest(plane_mm[0])?,
            self.microlens_rows.nearest(plane_mm[1])?,
        ];
        let mut sensor_mm: [f64; 2] = std::array::from_fn(|axis| {
            self.first_microlens_mm[axis]
                + f64::from(lens[axis]) * self.microlens_pitch_mm
                + self.slope * (plane_mm[axis] - pupil_mm[axis])
        });
        if let Some(blur) = &self.diffraction {
            spread(&mut sensor_mm, blur.on_sensor_mm, rng);
        }
        let column = self.pixel_columns.nearest(sensor_mm[0])?;
        // Rows count downwards, against `up`.
        let row = self.pixel_rows.nearest(-sensor_mm[1])?;
        Some(row * self.columns + column)
    }
}

fn spread(position_mm: &mut [f64; 2], sigma_mm: f64, rng: &mut Pcg64Mcg) {
    for coordinate in position_mm {
        let deviation: f64 = rng.sample(StandardNormal);
        *coordinate += sigma_mm * deviation;
    }
}
