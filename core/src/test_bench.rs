//! The bench of docs/theory.md, section 1, for the tests of this crate.

use lfpiv_hw::{MicrolensArray, Optics, Pose, Sensor};
use nalgebra::Vector3;

/// 129 × 97 microlenses, 2352 × 1768 pixels of 5.5 µm.
pub fn optics() -> Optics {
    Optics {
        focal_length_mm: 100.0,
        f_number: 4.0,
        object_distance_mm: 200.0,
        microlens: MicrolensArray { pitch_mm: 0.1, focal_length_mm: 0.8, columns: 129, rows: 97 },
        sensor: Sensor { columns: 2352, rows: 1768, pixel_pitch_um: 5.5 },
    }
}

/// Both cameras of docs/theory.md, section 2: along z, and along y.
pub fn poses() -> Vec<Pose> {
    vec![
        Pose {
            right: Vector3::x(),
            up: Vector3::y(),
            axis: Vector3::z(),
            origin_mm: Vector3::zeros(),
        },
        Pose {
            right: Vector3::x(),
            up: -Vector3::z(),
            axis: Vector3::y(),
            origin_mm: Vector3::zeros(),
        },
    ]
}
