//! The optics of an unfocused light-field camera: main lens, microlens array, sensor.
//!
//! Thin lenses throughout. Conventions: docs/theory.md, section 2, and Table 1 of the paper (Zhu, Xu,
//! Hossain and Khoo, Physics of Fluids 35, 2023).

use garde::Validate;
use serde::{Deserialize, Serialize};

use crate::check::finite;

/// One light-field camera's optics. Both cameras of a bench share them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct Optics {
    /// Focal length F of the main lens, in mm.
    #[garde(custom(finite), range(min = 1.0, max = 2000.0))]
    pub focal_length_mm: f64,
    /// Main lens f-number: focal length over pupil diameter.
    #[garde(custom(finite), range(min = 0.5, max = 64.0))]
    pub f_number: f64,
    /// Distance from the main lens to the plane in focus, in mm; must exceed the focal length.
    #[garde(custom(finite), range(min = 1.0, max = 10_000.0), custom(beyond(self.focal_length_mm)))]
    pub object_distance_mm: f64,
    /// The microlens array.
    #[garde(dive)]
    pub microlens: MicrolensArray,
    /// The image sensor.
    #[garde(dive)]
    pub sensor: Sensor,
}

/// A square grid of square microlenses, centred on the optical axis.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct MicrolensArray {
    /// Centre-to-centre distance p_m, in mm.
    #[garde(custom(finite), range(min = 0.005, max = 5.0))]
    pub pitch_mm: f64,
    /// Microlens focal length f_m, in mm: the sensor stands this far behind the array.
    #[garde(custom(finite), range(min = 0.01, max = 50.0))]
    pub focal_length_mm: f64,
    /// Microlenses along the sensor's columns (n_x).
    #[garde(range(min = 1, max = 2000))]
    pub columns: usize,
    /// Microlenses along the sensor's rows (n_y).
    #[garde(range(min = 1, max = 2000))]
    pub rows: usize,
}

/// The pixel grid, centred on the optical axis.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct Sensor {
    /// Pixel columns (N_x).
    #[garde(range(min = 1, max = 20_000))]
    pub columns: usize,
    /// Pixel rows (N_y).
    #[garde(range(min = 1, max = 20_000))]
    pub rows: usize,
    /// Pixel pitch p, in µm.
    #[garde(custom(finite), range(min = 0.5, max = 100.0))]
    pub pixel_pitch_um: f64,
}

fn beyond(focal_length_mm: f64) -> impl FnOnce(&f64, &()) -> garde::Result {
    move |object_distance_mm, _| {
        if *object_distance_mm > focal_length_mm {
            Ok(())
        } else {
            Err(garde::Error::new(format!(
                "allowed: more than the focal length, {focal_length_mm} mm"
            )))
        }
    }
}

impl Optics {
    /// Distance s_i from the main lens to the microlens plane, in mm (thin-lens equation).
    pub fn image_distance_mm(&self) -> f64 {
        self.conjugate_distance_mm(self.object_distance_mm)
    }

    /// Distance s' = F s / (s − F) behind the lens at which a point at distance s is in focus, in mm.
    pub fn conjugate_distance_mm(&self, object_distance_mm: f64) -> f64 {
        self.focal_length_mm * object_distance_mm / (object_distance_mm - self.focal_length_mm)
    }

    /// Diameter of the main lens pupil, in mm.
    pub fn pupil_diameter_mm(&self) -> f64 {
        self.focal_length_mm / self.f_number
    }

    /// Pixel pitch in mm.
    pub fn pixel_pitch_mm(&self) -> f64 {
        self.sensor.pixel_pitch_um * 1e-3
    }

    /// 1 + f_m / s_i: ratio of the micro-image pitch to the microlens pitch.
    pub fn micro_image_magnification(&self) -> f64 {
        1.0 + self.microlens.focal_length_mm / self.image_distance_mm()
    }

    /// Centre-to-centre distance of the micro-images on the sensor, in mm.
    pub fn micro_image_pitch_mm(&self) -> f64 {
        self.microlens.pitch_mm * self.micro_image_magnification()
    }

    /// Microlens pitch imaged into the plane in focus, in mm.
    pub fn object_pitch_mm(&self) -> f64 {
        self.microlens.pitch_mm * self.object_distance_mm / self.image_distance_mm()
    }

    /// Width of the pupil that one pixel sees through its microlens, p s_i / f_m, in mm.
    pub fn pupil_cell_mm(&self) -> f64 {
        self.pixel_pitch_mm() * self.image_distance_mm() / self.microlens.focal_length_mm
    }
}

impl MicrolensArray {
    /// Centre of microlens column `i` along `right`, in mm.
    pub fn column_centre_mm(&self, i: usize) -> f64 {
        (i as f64 - (self.columns as f64 - 1.0) / 2.0) * self.pitch_mm
    }

    /// Centre of microlens row `j` along `up`, in mm. Microlens rows count upwards.
    pub fn row_centre_mm(&self, j: usize) -> f64 {
        (j as f64 - (self.rows as f64 - 1.0) / 2.0) * self.pitch_mm
    }
}

impl Sensor {
    /// Centre of pixel column `c` along `right`, in mm.
    pub fn column_centre_mm(&self, c: usize) -> f64 {
        (c as f64 - (self.columns as f64 - 1.0) / 2.0) * self.pixel_pitch_um * 1e-3
    }

    /// Centre of pixel row `r` along `up`, in mm. Pixel rows count downwards.
    pub fn row_centre_mm(&self, r: usize) -> f64 {
        ((self.rows as f64 - 1.0) / 2.0 - r as f64) * self.pixel_pitch_um * 1e-3
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The bench of docs/theory.md, section 1.
    pub(crate) fn bench() -> Optics {
        Optics {
            focal_length_mm: 100.0,
            f_number: 4.0,
            object_distance_mm: 200.0,
            microlens: MicrolensArray {
                pitch_mm: 0.1,
                focal_length_mm: 0.8,
                columns: 129,
                rows: 97,
            },
            sensor: Sensor { columns: 2352, rows: 1768, pixel_pitch_um: 5.5 },
        }
    }

    #[test]
    fn derived_lengths_of_the_bench() {
        let optics = bench();
        assert_eq!(optics.image_distance_mm(), 200.0);
        assert_eq!(optics.pupil_diameter_mm(), 25.0);
        assert!((optics.micro_image_pitch_mm() - 0.1004).abs() < 1e-12);
        assert!((optics.pupil_cell_mm() - 1.375).abs() < 1e-12);
    }

    #[test]
    fn grids_are_centred_on_the_axis() {
        let optics = bench();
        assert_eq!(optics.microlens.column_centre_mm(64), 0.0);
        assert!((optics.sensor.row_centre_mm(0) - 1767.0 / 2.0 * 0.0055).abs() < 1e-12);
        assert!((optics.sensor.column_centre_mm(0) + 2351.0 / 2.0 * 0.0055).abs() < 1e-12);
    }

    #[test]
    fn a_length_that_is_no_number_is_refused() {
        let mut optics = bench();
        optics.microlens.pitch_mm = f64::NAN;
        assert!(optics.validate().unwrap_err().to_string().contains("microlens.pitch_mm"));
    }

    #[test]
    fn focus_inside_the_focal_length_is_refused() {
        let mut optics = bench();
        optics.object_distance_mm = 90.0;
        assert!(optics.validate().unwrap_err().to_string().contains("focal length"));
    }
}
