//! One frame of all cameras, cut into views.

use std::borrow::Cow;

use lfpiv_hw::{CameraName, RawImage};

use crate::{
    lightfield::{
        ImagePair, ImageSettings, LightLevels, PhotometricZones, StationaryLight, ViewLayout,
        ViewStack,
    },
    reconstruction::ViewLevels,
};

/// Share of lit pixels above noise up to which a camera's image counts as dark: less than one particle on the bench's
/// sensor, or the hot pixels of a good one.
const DARK_BRIGHT_SHARE: f64 = 5e-5;

/// Share of saturated pixels above which an image without bright pixels counts as overexposed, not dark.
const OVEREXPOSED_SHARE: f64 = 0.5;

/// Share of saturated pixels above which there is a warning.
const SATURATED_SHARE: f64 = 1e-3;

/// Corrections of raw images.
pub(super) struct Correction<'a> {
    pub image: &'a ImageSettings,
    /// Per camera.
    pub zones: &'a [PhotometricZones],
    /// Per camera and frame; empty without stationary light.
    pub stationary: &'a [[StationaryLight; 2]],
}

impl Correction<'_> {
    /// The image of a camera in frame 0 (a) or 1 (b) without stationary light, and its light levels.
    pub fn levels<'a>(
        &self,
        pair: &'a ImagePair,
        camera: usize,
        frame: usize,
    ) -> (Cow<'a, RawImage>, LightLevels) {
        let raw: &RawImage = &pair.cameras[camera][frame];
        let mut settings = self.image.clone();
        let image = match self.stationary.get(camera) {
            None => Cow::Borrowed(raw),
            Some(lights) => {
                settings.offset_counts = None;
                Cow::Owned(lights[frame].remove_from(raw))
            }
        };
        let levels = self.zones[camera].levels(&image, &settings);
        (image, levels)
    }
}

/// One frame of all cameras, cut into views.
pub(super) struct Frame {
    pub views: Vec<ViewStack>,
    pub levels: Vec<ViewLevels>,
    pub warnings: Vec<String>,
    /// Whether every camera sees light.
    pub lit: bool,
    /// The largest share of saturated pixels of any camera.
    pub saturated_share: f64,
}

impl Frame {
    /// Cuts frame 0 (a) or 1 (b) of a pair into the views of `layouts`.
    pub fn decode(
        pair: &ImagePair,
        frame: usize,
        layouts: &[ViewLayout],
        correction: &Correction<'_>,
    ) -> Self {
        let (views, levels, warnings) = (Vec::new(), Vec::new(), Vec::new());
        let mut decoded = Self { views, levels, warnings, lit: true, saturated_share: 0.0 };
        for (camera, layout) in layouts.iter().enumerate() {
            let (image, levels) = correction.levels(pair, camera, frame);
            let views = layout.decode_above_black(&image, &levels);
            let name = format!("{}, frame {}", CameraName(camera), ['a', 'b'][frame]);
            decoded.judge(&name, &levels);
            decoded.levels.push(ViewLevels::of(&views, levels.noise_counts));
            decoded.views.push(views);
        }
        decoded
    }

    /// Notes what the light levels of an image say about its use.
    fn judge(&mut self, name: &str, levels: &LightLevels) {
        self.saturated_share = self.saturated_share.max(levels.saturated_share);
        let dark = levels.bright_share <= DARK_BRIGHT_SHARE;
        self.lit &= !dark;
        if dark && levels.saturated_share > OVEREXPOSED_SHARE {
            self.warnings.push(format!(
                "{name}: {:.0} % of the lit pixels are saturated at {} counts and no particle \
                 stands out; every vector is marked invalid. Reduce gain or laser energy",
                100.0 * levels.saturated_share,
                levels.saturation_counts.unwrap_or(u16::MAX)
            ));
        } else if dark {
            self.warnings.push(format!(
                "{name}: no particle above the noise; every vector is marked invalid. Check laser, \
                 seeding and lens cap"
            ));
        } else if levels.saturated_share > SATURATED_SHARE {
            self.warnings.push(format!(
                "{name}: {:.1} % of the lit pixels are saturated at {} counts; reduce gain or \
                 laser energy",
                100.0 * levels.saturated_share,
                levels.saturation_counts.unwrap_or(u16::MAX)
            ));
        }
    }
}
