//! The chosen parts of the forward model, with reasons, for log, status and results.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::{ModelMode, ModelParts};

/// A part of the forward model that a scene may not need.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Part {
    /// See [`ModelParts::pupil_blur`].
    PupilBlur,
    /// See [`ModelParts::aperture_coverage`].
    ApertureCoverage,
    /// See [`ModelParts::diffraction_nm`].
    Diffraction,
    /// See [`ModelParts::noise_weighting`].
    NoiseWeighting,
    /// Voxels finer than the volume's own.
    FineVoxels,
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::PupilBlur => "pupil blur",
            Self::ApertureCoverage => "aperture coverage",
            Self::Diffraction => "diffraction",
            Self::NoiseWeighting => "noise weighting",
            Self::FineVoxels => "fine voxels",
        })
    }
}

/// Properties of the scene, estimated from the first usable pair. Widths and displacements are converted to the
/// volume.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SceneMeasure {
    /// Particles per microlens, mean over the cameras.
    pub seeding_ppm: f64,
    /// Particles per mm³.
    pub particles_per_mm3: f64,
    /// Edge of a final interrogation window, in voxels.
    pub window_vox: f64,
    /// Particles in a final interrogation window.
    pub particles_per_window: f64,
    /// Light of a particle in an open view, in counts; the lowest of the cameras.
    pub particle_counts: f64,
    /// Noise of a dark pixel divided by the light of a particle; the highest of the cameras.
    pub noise_per_particle: f64,
    /// Share of the lit pixels that are saturated, 0 to 1; the highest of the cameras.
    pub saturated_share: f64,
    /// Lowest and highest depth of the volume along any camera's axis, in mm.
    pub depth_mm: [f64; 2],
    /// Microlens pitch in object space, in voxels.
    pub pitch_vox: f64,
    /// Parallax of a point between opposite edges of the aperture, rms over the volume's depth, in voxels.
    pub parallax_vox: f64,
    /// Width of a point's shadow due to the pupil interval of a pixel, rms over the volume's depth, in voxels.
    pub pupil_blur_vox: f64,
    /// Width due to diffraction, rms over the volume's depth, in voxels; `None` without a wavelength.
    pub diffraction_vox: Option<f64>,
    /// Share of the light in partly open views, 0 to 1.
    pub partly_open_light: f64,
    /// Share of the views that are partly open, 0 to 1.
    pub partly_open_views: f64,
}

/// Decision on one part of the model.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PartChoice {
    /// The part.
    pub part: Part,
    /// Whether the model includes it.
    pub on: bool,
    /// Whether the configuration forced it.
    pub forced: bool,
    /// Displacement error of the model without it, in voxels; `None` if not measured.
    pub error_without_vox: Option<f64>,
    /// Estimated time of a reconstruction with it divided by that without it; `None` if not measured.
    pub cost: Option<f64>,
    /// Reason in one sentence, with numbers.
    pub reason: String,
}

/// The forward model of a run, with reasons.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct ModelChoice {
    /// Basis of the decision.
    pub mode: ModelMode,
    /// The parts of the model.
    pub model: ModelParts,
    /// Voxels along the edge of a voxel of the volume on the finest grid.
    pub refinement: usize,
    /// Decision on each part.
    pub parts: Vec<PartChoice>,
    /// Estimated error of the correlation alone, in voxels; `None` if not measured.
    pub correlation_error_vox: Option<f64>,
    /// Estimated error due to the parts that are left out, in voxels; `None` if not measured.
    pub model_error_vox: Option<f64>,
    /// Properties of the scene on which the choice is based; `None` if not measured.
    pub scene: Option<SceneMeasure>,
}

impl ModelChoice {
    /// The whole choice as JSON, for files that keep text.
    pub fn to_json(&self) -> String {
        // Numbers, strings and lists cannot fail to serialise.
        serde_json::to_string(self).unwrap_or_default()
    }
}

impl fmt::Display for ModelChoice {
    /// One line with the included and the excluded parts.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = |on: bool| -> String {
            let parts = self.parts.iter().filter(|part| part.on == on);
            let names: Vec<String> = parts.map(|part| part.part.to_string()).collect();
            if names.is_empty() { "nothing".to_owned() } else { names.join(", ") }
        };
        write!(
            f,
            "with {}; without {}; voxels split by {}",
            names(true),
            names(false),
            self.refinement
        )
    }
}
