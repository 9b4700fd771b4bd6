//! From raw images to views.

mod background;
mod layout;
mod micro_images;
mod pair;
mod photometry;
mod sampling;
mod seeding;
mod settings;
mod shot_time;

pub use background::{Condensation, StationaryLight};
pub use layout::{ApertureEdge, MicrolensWindow, View, ViewLayout, ViewStack};
pub use micro_images::MicroImages;
pub use pair::{ImagePair, RawLevel};
pub use photometry::{LightLevels, PhotometricZones};
pub use sampling::{AxisSampling, Sample};
pub use seeding::Seeding;
pub use settings::{Background, ImageSettings};
pub use shot_time::ShotTime;
