//! From raw images to views.

mod background;
mod layout;
mod pair;
mod photometry;
mod sampling;
mod settings;

pub use background::{Condensation, StationaryLight};
pub use layout::{MicrolensWindow, View, ViewLayout, ViewStack};
pub use pair::ImagePair;
pub use photometry::{LightLevels, PhotometricZones};
pub use sampling::{AxisSampling, Sample};
pub use settings::{Background, ImageSettings};
