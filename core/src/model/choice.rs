//! What was chosen to be modelled, and why: data that goes to log, status and results.

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

/// What the first usable pair says about the scene. Widths and places are those of the model's
/// parts seen in the volume, so that a choice needs nothing else.
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
    /// Light of a particle in an open view, in counts; that of the dimmest camera.
    pub particle_counts: f64,
    /// Noise of a dark pixel over the light of a particle; that of the worst camera.
    pub noise_per_particle: f64,
    /// Share of the lit pixels that are saturated, 0 to 1; that of the worst camera.
    pub saturated_share: f64,
    /// Lowest and highest depth of the volume along any camera's axis, in mm.
    pub depth_mm: [f64; 2],
    /// Microlens pitch seen in the volume, in voxels.
    pub pitch_vox: f64,
    /// How far a point moves between opposite edges of the aperture, root mean square over the
    /// volume's depth, in voxels.
    pub parallax_vox: f64,
    /// Width of a point's shadow by the pupil interval of a pixel, root mean square over the
    /// volume's depth, in voxels.
    pub pupil_blur_vox: f64,
    /// Width by diffraction, likewise; absent without a wavelength.
    pub diffraction_vox: Option<f64>,
    /// Share of the light that partly open views carry, 0 to 1.
    pub partly_open_light: f64,
    /// Share of the views that are partly open, 0 to 1.
    pub partly_open_views: f64,
}

/// Whether the model has one part, and why.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PartChoice {
    /// The part.
    pub part: Part,
    /// Whether the model has it.
    pub on: bool,
    /// Whether the configuration forced it.
    pub forced: bool,
    /// Error of the displacement that the model would add without it, in voxels; absent where
    /// nothing was measured.
    pub error_without_vox: Option<f64>,
    /// Time of a reconstruction with it over one without it, estimated; absent likewise.
    pub cost: Option<f64>,
    /// One sentence with the numbers.
    pub reason: String,
}

/// The forward model of a run, and why it is this one.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct ModelChoice {
    /// Who decided.
    pub mode: ModelMode,
    /// What is modelled.
    pub model: ModelParts,
    /// Voxels along the edge of a voxel of the volume on the finest grid.
    pub refinement: usize,
    /// Each part and why.
    pub parts: Vec<PartChoice>,
    /// Error of the correlation alone, estimated, in voxels; absent where nothing was measured.
    pub correlation_error_vox: Option<f64>,
    /// Error that the parts left out add, estimated, in voxels; absent likewise.
    pub model_error_vox: Option<f64>,
    /// What the choice was made from; absent likewise.
    pub scene: Option<SceneMeasure>,
}

impl ModelChoice {
    /// The whole choice as JSON, for files that keep text.
    pub fn to_json(&self) -> String {
        // Numbers, words and lists: nothing that JSON cannot hold.
        serde_json::to_string(self).unwrap_or_default()
    }
}

impl fmt::Display for ModelChoice {
    /// One line: the parts that the model has and those that it has not.
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
