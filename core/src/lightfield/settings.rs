//! The `[image]` table of the configuration.

use std::path::PathBuf;

use garde::Validate;
use serde::{Deserialize, Serialize};

/// Known properties of the raw images; absent ones are estimated from each image.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct ImageSettings {
    /// Black level of the sensor, in counts.
    #[garde(inner(range(min = 0.0, max = 65_535.0)))]
    pub offset_counts: Option<f64>,
    /// Standard deviation of a dark pixel, in counts.
    #[garde(inner(range(min = 0.0, max = 65_535.0)))]
    pub read_noise_counts: Option<f64>,
    /// Count from which a pixel is saturated.
    #[garde(inner(range(min = 1, max = 65_535)))]
    pub saturation_counts: Option<u16>,
    /// How stationary light is removed.
    #[garde(skip)]
    pub background: Background,
    /// Folder with one background image per camera and frame, named like the pair
    /// (`cam1_a.tif`, ...); used when `background = "images"`.
    #[garde(skip)]
    pub background_dir: Option<PathBuf>,
}

/// How stationary light (background, reflections) is removed before decoding.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Background {
    /// A constant level per image, estimated from its darkest lit pixels.
    #[default]
    Constant,
    /// The pixelwise minimum over the pairs of the run.
    Minimum,
    /// The pixelwise mean over the pairs of the run.
    Mean,
    /// Images from `background_dir`.
    Images,
}
