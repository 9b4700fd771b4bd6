//! How well the configured bench explains the images: data that goes to result, status and log.

use std::fmt;

use serde::{Deserialize, Serialize};

/// What the fit is worth.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FitVerdict {
    /// The configured bench explains the images.
    #[default]
    Good,
    /// Something is off: vectors may be wrong by more than their uncertainties say.
    Doubtful,
    /// The images are not of the configured bench, or the frames not of one flow: no vector is valid.
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

/// How one camera's images compare with the model of the bench.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct CameraFit {
    /// Residual of the reconstruction over the standard deviation of the light, both without noise:
    /// 0 when everything is explained, 1 when nothing is. The lower quartile over tiles of the field, in
    /// the worse of both frames.
    pub unexplained: f64,
    /// Largest distance of a micro-image from its configured place, in pixels; absent where the
    /// micro-images do not stand out.
    pub micro_image_offset_px: Option<f64>,
}

/// How well the configured bench explains the images of a pair.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct ModelFit {
    /// What the numbers amount to.
    pub verdict: FitVerdict,
    /// Every camera by itself, in the order of the configuration.
    pub cameras: Vec<CameraFit>,
    /// Correlation of the cameras' light along the direction that both see, -1 to 1: the lower of both
    /// frames. Absent with one camera, or where both look the same way.
    pub camera_agreement: Option<f64>,
    /// How far apart the two cameras put the same particles, root mean square over the volume, in
    /// mm. Absent likewise, and where too few particles were found.
    pub camera_disparity_mm: Option<f64>,
    /// Share of the windows with particles whose vectors are valid before the verdict, 0 to 1.
    pub valid_share: f64,
    /// What may be wrong, the likeliest first; empty for a good fit.
    pub causes: Vec<String>,
}

impl ModelFit {
    /// What a reader of the log should know. Nothing for a good fit, and nothing for dark images, which
    /// have warnings of their own. `pitch_mm` is the microlens pitch seen in the volume, to which
    /// distances are compared.
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

    /// The numbers behind the verdict, in words; `pitch_mm` as in [`Self::warning`].
    pub fn numbers(&self, pitch_mm: f64) -> String {
        let per_camera = |number: &dyn Fn(&CameraFit) -> Option<String>| -> String {
            let numbers =
                self.cameras.iter().map(|camera| number(camera).unwrap_or("?".to_owned()));
            numbers.collect::<Vec<_>>().join(" and ")
        };
        let mut parts = vec![
            format!(
                "Unexplained light {} of its standard deviation",
                per_camera(&|camera| Some(format!("{:.2}", camera.unexplained)))
            ),
            format!(
                "micro-images {} pixels off",
                per_camera(&|camera| camera.micro_image_offset_px.map(|px| format!("{px:.1}")))
            ),
        ];
        parts.extend(self.camera_agreement.map(|r| format!("correlation of the cameras {r:.2}")));
        parts.extend(self.camera_disparity_mm.map(|mm| {
            format!("the cameras put particles {:.2} microlens pitches apart", mm / pitch_mm)
        }));
        parts
            .push(format!("{:.0} % of the windows with particles valid", 100.0 * self.valid_share));
        parts.join(", ")
    }

    /// The fit as JSON, for files that keep text.
    pub fn to_json(&self) -> String {
        // Numbers, words and lists: nothing that JSON cannot hold.
        serde_json::to_string(self).unwrap_or_default()
    }
}
