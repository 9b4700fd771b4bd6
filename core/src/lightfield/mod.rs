//! Decoding of raw light-field images into views.

mod background;
mod grid_sampling;
mod layout;
mod levels;
mod mean_micro_image;
mod micro_image_grid;
mod micro_images;
mod pair;
mod photometry;
mod sampling;
mod seeding;
mod settings;

pub use background::{Condensation, StationaryLight};
pub use grid_sampling::{GridSampling, NearestPixel, TIE_PX};
pub use layout::{Aperture, ApertureEdge, MicrolensWindow, View, ViewLayout, ViewStack};
pub use levels::LightLevels;
pub use mean_micro_image::MeanMicroImage;
pub use micro_image_grid::MicroImageGrid;
pub use micro_images::MicroImages;
pub use pair::ImagePair;
pub use photometry::PhotometricZones;
pub use sampling::{AxisSampling, Sample};
pub use seeding::Seeding;
pub use settings::{Background, ImageSettings};
