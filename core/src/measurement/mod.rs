//! From the images of a pair to vectors: what is measured with which model, and how well it fits.

mod choose;
mod combination;
mod fitted;
mod forecast;
mod frame;
mod model_fit;
mod part_errors;
mod placed;
mod plan;
mod processor;
mod scene;
mod setup;

pub use forecast::{Forecast, ForecastError, ForecastPlace, SceneConditions, bound, forecast};
pub use plan::Plan;
pub use processor::{ProcessError, Processor};
pub use setup::{Measurement, SetupError};
