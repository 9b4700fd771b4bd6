//! What every delivered result of a run must be.

use std::sync::Arc;

use lfpiv_core::{
    model::ModelChoice,
    reconstruction::FrameLight,
    velocimetry::{VectorGrid, VelocityField},
};

use super::{ClusterError, Delivery};
use crate::acquisition::journal::RecordedShot;

/// As the reference has it.
pub(super) struct Expected {
    pub model: Arc<ModelChoice>,
    pub model_sha256: String,
    pub grid: VectorGrid,
    /// Voxels along x, y, z, where the light is shown; `None` where it is not.
    pub light: Option<[usize; 3]>,
}

impl Expected {
    /// Reads a delivered result.
    ///
    /// # Errors
    /// [`ClusterError::Refused`]: its bytes have changed, or it was made with another model.
    pub fn decode(&self, bytes: &[u8]) -> Result<Delivery, ClusterError> {
        Delivery::decode(bytes, &self.model, &self.model_sha256)
    }

    /// The result, if it is one of the recorded shot.
    ///
    /// # Errors
    /// [`ClusterError::Refused`], with what is wrong.
    pub fn check(
        &self,
        delivery: Delivery,
        recorded: &RecordedShot,
    ) -> Result<Delivery, ClusterError> {
        let (shot, field) = (delivery.shot, &delivery.result.measured.field);
        let refused = |what: &str| ClusterError::Refused(format!("shot {shot}: {what}"));
        if delivery.result.time != recorded.time || field.dt_s != recorded.dt_us * 1e-6 {
            return Err(refused("its times are not those of the record"));
        }
        if field.grid != self.grid {
            return Err(refused("its vectors are elsewhere than the reference's"));
        }
        if let Some(light) = &delivery.result.measured.light
            && !self.light.is_some_and(|voxels| is_seen(light, voxels))
        {
            return Err(refused("its light is not that of the run's volume"));
        }
        match is_finite(field) {
            true => Ok(delivery),
            false => Err(refused("it has numbers that are not finite")),
        }
    }
}

/// Whether these are projections of so many voxels, and all of their numbers finite.
fn is_seen(light: &[FrameLight; 2], [nx, ny, nz]: [usize; 3]) -> bool {
    light.iter().all(|frame| {
        let sizes = frame.projections.each_ref().map(|plane| plane.size);
        let mut numbers = frame.projections.iter().flat_map(|plane| &plane.intensity);
        sizes == [[nx, ny], [nx, nz], [ny, nz]] && numbers.all(|light| light.is_finite())
    })
}

/// Whether all numbers of a field are.
fn is_finite(field: &VelocityField) -> bool {
    let triples = [&field.displacement_vox, &field.uncertainty_vox, &field.vorticity];
    let numbers = [&field.peak_ratio, &field.divergence];
    triples.iter().all(|triples| triples.iter().flatten().all(|number| number.is_finite()))
        && numbers.iter().all(|numbers| numbers.iter().all(|number| number.is_finite()))
}
