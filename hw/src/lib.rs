//! What the bench is made of: the optics of a light-field camera, where each camera stands, the
//! traits through which cameras and synchroniser are driven, the pulse schedule, and the drivers.
//!
//! Everything here is a description, a contract or a driver of real hardware. The simulated devices
//! live in `lfpiv-sim`; neither this crate nor that one knows how a volume is reconstructed.

pub mod check;
pub mod device;
pub mod frame;
pub mod optics;
pub mod pose;
pub mod synchroniser;
pub mod timing;

pub use frame::RawImage;
pub use optics::{MicrolensArray, Optics, Sensor};
pub use pose::{CameraPoint, Pose};
pub use timing::{PulseSchedule, TimingError, TimingSettings};
