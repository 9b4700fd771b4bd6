//! Model fit: agreement of the images with the configured bench, for results, status and log.

use std::fmt;

use serde::{Deserialize, Serialize};

/// Assessment of the fit.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FitVerdict {
    /// The configured bench explains the images.
    #[default]
    Good,
    /// Vectors may be wrong by more than their uncertainties.
    Doubtful,
    /// The images do not match the configured bench, or the frames have no common flow. No vector is valid.
    Poor,
}

impl fmt::Display for FitVerdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Good => "good",
            Self::Doubtful => "doubtful",
            Self::Poor => "poor",
        })
    }
}

/// Comparison of one camera's images with the model of the bench.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct CameraFit {
    /// Residual of the reconstruction relative to the standard deviation of the light, both without noise: 0 if
    /// all light is explained, 1 if none is. The lower quartile over tiles of the field, in the frame with the
    /// larger value.
    pub unexplained: f64,
    /// Largest distance of a micro-image from its configured position, in pixels; `None` if no micro-images are
    /// found.
    pub micro_image_offset_px: Option<f64>,
}

/// Model fit of a pair.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct ModelFit {
    /// Overall assessment.
    pub verdict: FitVerdict,
    /// Comparisons per camera, in the order of the configuration.
    pub cameras: Vec<CameraFit>,
    /// Correlation of the cameras' light along their common direction, -1 to 1: the lower of both frames.
    /// `None` with one camera, or if both have the same direction.
    pub camera_agreement: Option<f64>,
    /// Root-mean-square distance between the positions of the same particles in both cameras, in mm. `None` as
    /// above, and with too few particles.
    pub camera_disparity_mm: Option<f64>,
    /// Share of windows with particles whose vectors are valid before this assessment, 0 to 1.
    pub valid_share: f64,
    /// Possible causes, the most probable first; empty for a good fit.
    pub causes: Vec<String>,
}

impl ModelFit {
    /// Warning for the log. `None` for a good fit, and for dark images, which have separate
    /// warnings. `pitch_mm` is the microlens pitch in the volume, as a scale for distances.
    pub fn warning(&self, pitch_mm: f64) -> Option<String> {
        if self.verdict == FitVerdict::Good || self.causes.is_empty() {
            return None;
        }
        let causes: Vec<String> = self
            .causes
            .iter()
            .enumerate()
            .map(|(n, cause)| format!("({}) {cause}", n + 1))
            .collect();
        let consequence = match self.verdict {
            FitVerdict::Poor => "; every vector is marked invalid",
            _ => "; vectors may be off by more than their uncertainties",
        };
        Some(format!(
            "the model fit is {}{consequence}. {}. Likely causes: {}",
            self.verdict,
            self.numbers(pitch_mm),
            causes.join("; ")
        ))
    }

    /// The values of the assessment, as text; `pitch_mm` as in [`Self::warning`].
    pub fn numbers(&self, pitch_mm: f64) -> String {
        let unexplained = self.cameras.iter().map(|camera| format!("{:.2}", camera.unexplained));
        let mut parts = vec![format!(
            "Unexplained light {} of its standard deviation",
            unexplained.collect::<Vec<_>>().join(" and ")
        )];
        parts.extend(self.micro_images());
        parts.extend(self.camera_agreement.map(|r| format!("correlation of the cameras {r:.2}")));
        parts.extend(self.camera_disparity_mm.map(|mm| {
            format!("the cameras put particles {:.2} microlens pitches apart", mm / pitch_mm)
        }));
        parts
            .push(format!("{:.0} % of the windows with particles valid", 100.0 * self.valid_share));
        parts.join(", ")
    }

    /// Distances of micro-images from their configured positions, as text. `None` if they were not measured for any
    /// camera: the cameras are calibrated, or no micro-image is found.
    fn micro_images(&self) -> Option<String> {
        self.cameras.iter().find_map(|camera| camera.micro_image_offset_px)?;
        let offset = |camera: &CameraFit| match camera.micro_image_offset_px {
            Some(px) => format!("{px:.1}"),
            None => "(not visible)".to_owned(),
        };
        let offsets: Vec<String> = self.cameras.iter().map(offset).collect();
        Some(format!("micro-images {} pixels off", offsets.join(" and ")))
    }

    /// The fit as JSON, for files that keep text.
    pub fn to_json(&self) -> String {
        // Numbers, strings and lists cannot fail to serialise.
        serde_json::to_string(self).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fit(offsets_px: [Option<f64>; 2]) -> ModelFit {
        let camera = |micro_image_offset_px| CameraFit { unexplained: 0.2, micro_image_offset_px };
        ModelFit { cameras: offsets_px.map(camera).to_vec(), ..ModelFit::default() }
    }

    #[test]
    fn only_measured_micro_images_are_reported() {
        let text = |offsets_px| fit(offsets_px).numbers(0.1);
        assert!(text([Some(0.31), Some(2.0)]).contains("micro-images 0.3 and 2.0 pixels off"));
        assert!(text([Some(0.31), None]).contains("micro-images 0.3 and (not visible) pixels off"));
        assert!(!text([None, None]).contains("micro-images"));
    }
}
