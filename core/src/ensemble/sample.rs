//! Samples of one shot: velocities with uncertainties.

use crate::velocimetry::{VectorStatus, VelocityField};

/// One measured velocity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Velocity along x, y, z, in m/s.
    pub velocity_m_s: [f64; 3],
    /// Its standard uncertainty, in m/s.
    pub uncertainty_m_s: [f64; 3],
}

impl Sample {
    /// Whether all numbers are finite; other samples are not used.
    pub fn is_finite(&self) -> bool {
        self.velocity_m_s.iter().chain(&self.uncertainty_m_s).all(|number| number.is_finite())
    }
}

/// The samples of a shot on the nodes of a lattice, in the order z, y, x.
#[derive(Debug, Clone, PartialEq)]
pub struct Snapshot {
    /// Shot number.
    pub shot: u64,
    /// The sample at each node; `None` without a valid measurement.
    pub samples: Vec<Option<Sample>>,
}

impl Snapshot {
    /// A shot with vectors `velocity` and `uncertainty`, in m/s. Only valid vectors are used: interpolated ones
    /// contain no additional information.
    pub fn new(
        shot: u64,
        velocity: &[[f32; 3]],
        uncertainty: &[[f32; 3]],
        status: &[VectorStatus],
    ) -> Self {
        let samples = velocity.iter().zip(uncertainty).zip(status).map(|((v, u), status)| {
            let sample =
                Sample { velocity_m_s: v.map(f64::from), uncertainty_m_s: u.map(f64::from) };
            (*status == VectorStatus::Valid && sample.is_finite()).then_some(sample)
        });
        Self { shot, samples: samples.collect() }
    }

    /// The valid vectors of a field.
    pub fn of_field(shot: u64, field: &VelocityField) -> Self {
        let speed = field.metres_per_second_per_voxel();
        let in_m_s = |vectors: &[[f32; 3]]| -> Vec<[f32; 3]> {
            vectors.iter().map(|v| v.map(|vox| (f64::from(vox) * speed) as f32)).collect()
        };
        let (velocity, uncertainty) =
            (in_m_s(&field.displacement_vox), in_m_s(&field.uncertainty_vox));
        Self::new(shot, &velocity, &uncertainty, &field.status)
    }
}
