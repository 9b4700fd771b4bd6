//! What a borrowed camera was set to, to give it back as it was found.

use aravis::{GcFeatureNode, glib::prelude::*, prelude::*};

use super::features::Features;

/// What running freely changes, in an order in which it can be written back: automatic settings last.
/// Names of older standards are among them; what a camera lacks is passed over.
const CHANGED: [&str; 15] = [
    "PixelFormat",
    "Width",
    "Height",
    "OffsetX",
    "OffsetY",
    "ExposureTime",
    "ExposureTimeAbs",
    "ExposureTimeRaw",
    "ExposureAuto",
    "Gain",
    "GainRaw",
    "GainAuto",
    "GevSCPSPacketSize",
    "GevSCPD",
    "AcquisitionMode",
];

const SELECTOR: &str = "TriggerSelector";
const MODE: &str = "TriggerMode";

/// Texts of features.
#[derive(Debug)]
pub(super) struct AsFound {
    values: Vec<(&'static str, String)>,
    /// Each trigger and its mode, the selected one last.
    triggers: Vec<[String; 2]>,
}

impl AsFound {
    /// Reads what can be read.
    pub(super) fn read(features: &Features<'_>) -> Self {
        let text = |name: &'static str| Some((name, text(features, name)?));
        let mut values: Vec<_> = CHANGED.into_iter().filter_map(text).collect();
        let triggers = triggers(features);
        if triggers.is_empty() {
            values.extend(text(MODE));
        }
        Self { values, triggers }
    }

    /// Writes back what differs, and warns of what cannot be written.
    pub(super) fn give_back(&self, features: &Features<'_>) {
        let mut left = Vec::new();
        // An image that is not at the corner may leave no room for its former size.
        for (name, _) in self.values.iter().filter(|(name, _)| name.starts_with("Offset")) {
            set(features, name, "0");
        }
        for (name, value) in &self.values {
            if !set(features, name, value) {
                left.push(*name);
            }
        }
        for [trigger, mode] in &self.triggers {
            if !(set(features, SELECTOR, trigger) && set(features, MODE, mode)) {
                left.push(MODE);
            }
        }
        let camera = features.device;
        if left.is_empty() {
            tracing::info!(camera, "settings restored");
        } else {
            let left = left.join(", ");
            tracing::warn!(camera, "settings that cannot be restored: {left}");
        }
    }
}

/// The modes of all triggers. The camera is left with the one selected that was.
fn triggers(features: &Features<'_>) -> Vec<[String; 2]> {
    let Some(selected) = text(features, SELECTOR) else { return Vec::new() };
    let all = features.camera.dup_available_enumerations_as_strings(SELECTOR).unwrap_or_default();
    let others = all.iter().map(|name| name.as_str()).filter(|name| *name != selected);
    others
        .chain([selected.as_str()])
        .filter(|trigger| set(features, SELECTOR, trigger))
        .filter_map(|trigger| Some([trigger.to_owned(), text(features, MODE)?]))
        .collect()
}

fn node(features: &Features<'_>, name: &str) -> Option<GcFeatureNode> {
    if !features.has(name).ok()? {
        return None;
    }
    features.camera.device()?.feature(name)?.downcast().ok()
}

fn text(features: &Features<'_>, name: &str) -> Option<String> {
    Some(node(features, name)?.value_as_string().ok()?.into())
}

/// Whether the feature has the value in the end.
fn set(features: &Features<'_>, name: &str, value: &str) -> bool {
    let Some(node) = node(features, name) else { return false };
    let has_it = || node.value_as_string().is_ok_and(|found| found == value);
    has_it() || node.set_value_from_string(value).is_ok() && has_it()
}
