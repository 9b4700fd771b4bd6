//! From raw images to views.

mod settings;

pub use settings::ImageSettings;
