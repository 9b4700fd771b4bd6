//! The forward model of a run: the configured one, or the one that its first pair asks for.

use std::sync::{Arc, OnceLock};

use super::{
    Measurement,
    choose::{Allowed, choose, configured},
    frame::{Correction, Frame},
    scene::measure_scene,
};
use crate::{
    Clock,
    lightfield::ImagePair,
    model::{ModelChoice, ModelError, ModelMode},
    reconstruction::{Footprint, ReconstructionSettings, Reconstructor},
};

/// A model, its tables and why it is this one.
pub(super) struct Fitted {
    pub reconstructor: Arc<Reconstructor>,
    pub choice: Arc<ModelChoice>,
}

/// The models of a run.
pub(super) struct Models {
    configured: Fitted,
    /// Set by the first pair that shows particles, where the scene decides.
    chosen: OnceLock<Fitted>,
    /// Voxels around the volume that are reconstructed, too.
    margin: usize,
    /// Times the solvers' passes.
    clock: Clock,
}

impl Models {
    /// Builds the configured model. Errors when a camera does not see the volume.
    pub fn new(measurement: &Measurement, margin: usize, clock: Clock) -> Result<Self, ModelError> {
        let choice = configured(&allowed(measurement));
        let reconstructor = reconstructor(measurement, margin, &choice, clock)?;
        let configured =
            Fitted { reconstructor: Arc::new(reconstructor), choice: Arc::new(choice) };
        Ok(Self { configured, chosen: OnceLock::new(), margin, clock })
    }

    /// The model before a look at the scene.
    pub fn configured(&self) -> &Fitted {
        &self.configured
    }

    /// The model for a pair. Where the scene decides and has not yet been seen, this pair is it.
    pub fn fitted(
        &self,
        measurement: &Measurement,
        pair: &ImagePair,
        correction: &Correction<'_>,
    ) -> &Fitted {
        if measurement.model.mode == ModelMode::Explicit {
            return &self.configured;
        }
        if let Some(chosen) = self.chosen.get() {
            return chosen;
        }
        // Not under the lock of `get_or_init`: what is built here may be built on threads that
        // would come for the lock again. A second worker at most does it in vain.
        match self.fit(measurement, pair, correction) {
            Some(fitted) => self.chosen.get_or_init(|| fitted),
            None => &self.configured,
        }
    }

    /// Chooses and builds; `None` when the pair shows no particles.
    fn fit(
        &self,
        measurement: &Measurement,
        pair: &ImagePair,
        correction: &Correction<'_>,
    ) -> Option<Fitted> {
        let layouts = self.configured.reconstructor.layouts();
        let frame = Frame::decode(pair, 0, layouts, correction);
        let scene = measure_scene(measurement, layouts, &frame).filter(|_| frame.lit)?;
        let choice = choose(&scene, &allowed(measurement));
        let same = choice.model == self.configured.choice.model
            && choice.refinement == self.configured.choice.refinement;
        let reconstructor = if same {
            self.configured.reconstructor.clone()
        } else {
            match reconstructor(measurement, self.margin, &choice, self.clock) {
                Ok(reconstructor) => Arc::new(reconstructor),
                Err(error) => {
                    tracing::warn!(%error, "the chosen model cannot be built; the configured one stays");
                    return Some(Fitted {
                        reconstructor: self.configured.reconstructor.clone(),
                        choice: self.configured.choice.clone(),
                    });
                }
            }
        };
        log(&choice);
        Some(Fitted { reconstructor, choice: Arc::new(choice) })
    }
}

/// What the configuration leaves open. Only solvers on active voxels have grids other than the volume's, and points
/// on voxel centres need none.
fn allowed(measurement: &Measurement) -> Allowed<'_> {
    let ReconstructionSettings { footprint, refinement, .. } = measurement.reconstruction;
    let fine = measurement.model.mode == ModelMode::Explicit
        || (measurement.reconstruction.on_active_voxels() && footprint != Footprint::Point);
    Allowed { settings: &measurement.model, finest: if fine { refinement } else { 1 } }
}

fn reconstructor(
    measurement: &Measurement,
    margin: usize,
    choice: &ModelChoice,
    clock: Clock,
) -> Result<Reconstructor, ModelError> {
    let Measurement { optics, cameras, calibrations, volume, reconstruction, .. } = measurement;
    let settings =
        ReconstructionSettings { refinement: choice.refinement, ..reconstruction.clone() };
    let volume = volume.padded(margin);
    let reconstructor =
        Reconstructor::with_parts(optics, cameras, calibrations, &volume, &settings, choice.model)?;
    Ok(reconstructor.timed_by(clock))
}

fn log(choice: &ModelChoice) {
    if let Some(scene) = &choice.scene {
        tracing::info!(
            seeding_ppm = format!("{:.2}", scene.seeding_ppm),
            particles_per_window = format!("{:.0}", scene.particles_per_window),
            noise_per_particle = format!("{:.3}", scene.noise_per_particle),
            correlation_error_vox = choice.correlation_error_vox.map(|e| format!("{e:.4}")),
            model_error_vox = choice.model_error_vox.map(|e| format!("{e:.4}")),
            "model chosen: {choice}"
        );
    }
    for part in &choice.parts {
        tracing::info!("{}: {}", part.part, part.reason);
    }
}
