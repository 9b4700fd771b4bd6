//! The parts of the bench: optics of a light-field camera, camera poses, traits for cameras and
//! synchroniser, the pulse schedule, and the drivers.
//!
//! The drivers are [`gige`] for cameras and [`synchroniser`] for the unit that triggers them. Simulated
//! devices are in `lfpiv-sim`. Neither crate knows how a volume is reconstructed.

mod camera_name;
pub mod card;
pub mod check;
pub mod device;
pub mod frame;
pub mod gige;
pub mod optics;
pub mod pose;
pub mod synchroniser;
pub mod timing;

pub use camera_name::CameraName;
pub use frame::{ImagePool, RawImage, RecordedCamera};
pub use optics::{MicrolensArray, Optics, Sensor};
pub use pose::{CameraPoint, Pose};
pub use timing::{PulseSchedule, TimingError, TimingSettings};
