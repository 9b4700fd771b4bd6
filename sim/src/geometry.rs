//! The bench that is simulated, as plain data: this crate does not know the daemon's settings.

use lfpiv_hw::{Optics, Pose};
use serde::{Deserialize, Serialize};

/// Cameras, measurement volume and pulse separation.
#[derive(Debug, Clone, PartialEq)]
pub struct BenchGeometry {
    /// The optics, shared by all cameras.
    pub optics: Optics,
    /// One pose per camera.
    pub poses: Vec<Pose>,
    /// The measurement volume.
    pub volume: Volume,
    /// Time between the two laser pulses, in s.
    pub dt_s: f64,
}

impl BenchGeometry {
    /// Microlens pitch projected to the plane in focus, p_m / |magnification|, in mm.
    pub fn object_pitch_mm(&self) -> f64 {
        let magnification = self.optics.image_distance_mm() / self.optics.object_distance_mm;
        self.optics.microlens.pitch_mm / magnification
    }
}

/// The measurement volume as plain data.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Volume {
    /// Voxels along x, y and z.
    pub voxels: [usize; 3],
    /// Voxel edge, in mm.
    pub voxel_mm: f64,
    /// World position of the volume's centre, in mm.
    pub centre_mm: [f64; 3],
}

impl Volume {
    /// Edge lengths (x, y, z), in mm.
    pub fn extents_mm(&self) -> [f64; 3] {
        self.voxels.map(|count| count as f64 * self.voxel_mm)
    }
}
