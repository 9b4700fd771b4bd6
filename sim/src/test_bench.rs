//! Benches that the tests of this crate share.

use lfpiv_hw::{MicrolensArray, Optics, Pose, Sensor};
use nalgebra::Vector3;

use crate::geometry::{BenchGeometry, Volume};

/// The optics of docs/theory.md, section 1.
pub(crate) fn optics() -> Optics {
    Optics {
        focal_length_mm: 100.0,
        f_number: 4.0,
        object_distance_mm: 200.0,
        microlens: MicrolensArray { pitch_mm: 0.1, focal_length_mm: 0.8, columns: 129, rows: 97 },
        sensor: Sensor { columns: 2352, rows: 1768, pixel_pitch_um: 5.5 },
    }
}

/// Cameras 1 and 2 of docs/theory.md, section 2.
pub(crate) fn poses() -> Vec<Pose> {
    let origin_mm = Vector3::zeros();
    vec![
        Pose { right: Vector3::x(), up: Vector3::y(), axis: Vector3::z(), origin_mm },
        Pose { right: Vector3::x(), up: -Vector3::z(), axis: Vector3::y(), origin_mm },
    ]
}

/// A bench of 21 × 17 microlenses, quick to image.
pub(crate) fn small() -> BenchGeometry {
    let mut optics = optics();
    optics.microlens.columns = 21;
    optics.microlens.rows = 17;
    optics.sensor.columns = 384;
    optics.sensor.rows = 312;
    BenchGeometry {
        optics,
        poses: poses(),
        volume: Volume { voxels: [12, 10, 10], voxel_mm: 0.1, centre_mm: [0.0; 3] },
        dt_s: 100e-6,
        empty: None,
    }
}
