//! Light levels of a raw image.

/// Light levels of a raw image, estimated or configured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightLevels {
    /// Black level, in counts.
    pub offset_counts: f64,
    /// Uniform light above the black level, in counts; 0 if below the noise.
    pub background_counts: f64,
    /// Standard deviation of a dark pixel, in counts.
    pub noise_counts: f64,
    /// Count from which pixels are saturated, if any are.
    pub saturation_counts: Option<u16>,
    /// Share of saturated pixels, 0 to 1.
    pub saturated_share: f64,
    /// Mean of the lit pixels above black level and background, in counts.
    pub mean_signal_counts: f64,
    /// Share of lit pixels that are brighter than noise explains, 0 to 1. They contain light of particles.
    pub bright_share: f64,
}
