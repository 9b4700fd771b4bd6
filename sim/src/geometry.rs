//! The bench that is simulated, as plain data: this crate does not know the daemon's settings.

use std::{fmt, sync::Arc};

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
    /// Where there are no particles.
    pub empty: Option<EmptySpace>,
}

/// Space without particles, such as the inside of a body. The flow goes on in it, and light passes it: a body
/// only has no particles.
#[derive(Clone)]
pub struct EmptySpace(Arc<dyn Fn([f64; 3]) -> bool + Send + Sync>);

impl EmptySpace {
    /// The places (mm) for which `is_empty`.
    pub fn new(is_empty: impl Fn([f64; 3]) -> bool + Send + Sync + 'static) -> Self {
        Self(Arc::new(is_empty))
    }

    /// Whether there are no particles at a place (mm).
    pub fn contains(&self, at_mm: [f64; 3]) -> bool {
        (self.0)(at_mm)
    }
}

impl fmt::Debug for EmptySpace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("EmptySpace")
    }
}

impl PartialEq for EmptySpace {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
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
