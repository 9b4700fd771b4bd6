//! The `[model]` table of the configuration.

use std::fmt;

use garde::Validate;
use serde::{
    Deserialize, Deserializer, Serialize,
    de::{
        MapAccess, Visitor,
        value::{MapAccessDeserializer, StrDeserializer},
    },
};

/// Basis of the decision on the parts of the forward model.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ModelMode {
    /// The configuration; parts that are `auto` have their defaults.
    #[default]
    Explicit,
    /// The scene: the fastest model whose error is below that of the correlation.
    Auto,
}

/// Whether the model has a part.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Switch {
    /// If the scene requires it; with `mode = "explicit"` the default.
    #[default]
    Auto,
    /// Forced on.
    On,
    /// Forced off.
    Off,
}

impl Switch {
    /// The forced value, if there is one.
    pub fn forced(self) -> Option<bool> {
        match self {
            Self::Auto => None,
            Self::On => Some(true),
            Self::Off => Some(false),
        }
    }
}

/// Parts of the forward model, and the basis of the decision.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct ModelSettings {
    /// Basis of the decision.
    #[garde(skip)]
    pub mode: ModelMode,
    /// Wavelength of the light, in nm. Without it diffraction is not modelled.
    #[garde(inner(range(min = 100.0, max = 2000.0)))]
    pub wavelength_nm: Option<f64>,
    /// Width of shadows due to the pupil intervals of pixels.
    #[garde(skip)]
    pub pupil_blur: Switch,
    /// Views that are cut by the aperture's edge, with the open share of each pixel.
    #[garde(skip)]
    pub aperture_coverage: Switch,
    /// Diffraction at the main lens and at the microlenses.
    #[garde(custom(known_wavelength(self.wavelength_nm)))]
    pub diffraction: Switch,
    /// No corrections for light within the noise.
    #[garde(skip)]
    pub noise_weighting: Switch,
    /// Voxels refined by `reconstruction.refinement`; off: those of the volume.
    #[garde(skip)]
    pub fine_voxels: Switch,
}

fn known_wavelength(wavelength_nm: Option<f64>) -> impl FnOnce(&Switch, &()) -> garde::Result {
    move |diffraction, _| match (diffraction, wavelength_nm) {
        (Switch::On, None) => {
            Err(garde::Error::new("needs model.wavelength_nm, for example 532.0"))
        }
        _ => Ok(()),
    }
}

/// Reads `model = "auto"` as an abbreviation of `[model]` with `mode = "auto"`.
///
/// # Errors
/// The format's error for any value but a mode or a table.
pub fn mode_or_table<'de, D: Deserializer<'de>>(from: D) -> Result<ModelSettings, D::Error> {
    struct ModeOrTable;

    impl<'de> Visitor<'de> for ModeOrTable {
        type Value = ModelSettings;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("\"auto\", \"explicit\" or a table")
        }

        fn visit_str<E: serde::de::Error>(self, mode: &str) -> Result<ModelSettings, E> {
            let mode = ModelMode::deserialize(StrDeserializer::new(mode))?;
            Ok(ModelSettings { mode, ..ModelSettings::default() })
        }

        fn visit_map<A: MapAccess<'de>>(self, table: A) -> Result<ModelSettings, A::Error> {
            ModelSettings::deserialize(MapAccessDeserializer::new(table))
        }
    }

    from.deserialize_any(ModeOrTable)
}
