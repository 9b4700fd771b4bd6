//! What the bench is made of: the optics of a light-field camera, where each camera stands, the
//! traits through which cameras and synchroniser are driven, the pulse schedule, and the drivers.
//!
//! Beside descriptions and contracts there are the drivers: [`gige`] for cameras, [`synchroniser`]
//! for the unit that times them. The simulated devices live in `lfpiv-sim`; neither this crate nor
//! that one knows how a volume is reconstructed.

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
