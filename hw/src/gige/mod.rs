//! GigE Vision cameras: settings, pixel formats, frame numbers, and the Aravis driver.
//!
//! ```no_run
//! use std::time::Duration;
//! use lfpiv_hw::gige::{CameraSettings, ImageSize, open};
//!
//! let settings = CameraSettings { ip: "192.168.10.11".parse().ok(), ..CameraSettings::default() };
//! let mut camera = open("cam1", &settings, ImageSize { columns: 2352, rows: 1768 })?;
//! camera.start()?;
//! while let Some(frame) = camera.next_frame(Duration::from_secs(1))? {
//!     println!("frame {}: {:?}", frame.frame_id, frame.status);
//! }
//! # Ok::<(), lfpiv_hw::device::DeviceError>(())
//! ```
//!
//! The driver needs the cargo feature `aravis` and the system library of that name. Without them this
//! module still compiles, and opening a camera returns an error that says what is missing.

#[cfg(feature = "aravis")]
mod driver;
mod frame_ids;
mod pixel;
mod settings;

use crate::device::{Camera, DeviceError};

pub use frame_ids::FrameIds;
pub use pixel::PixelFormat;
pub use settings::{CameraSettings, ImageSize, TriggerActivation};

/// Real-time priority (1 to 99) of receiving threads. Any value precedes all normal threads; the
/// kernel's interrupt threads have 50.
pub const RECEIVING_REALTIME_PRIORITY: i32 = 10;
/// Nice level of receiving threads if real-time scheduling is not permitted.
pub const RECEIVING_NICE: i32 = -10;

/// A camera on the network.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FoundCamera {
    /// Manufacturer.
    pub vendor: String,
    /// Model.
    pub model: String,
    /// Serial number.
    pub serial: String,
    /// IP address.
    pub address: String,
    /// Whether it can be used now.
    pub access: Access,
    /// Its sensor in pixels, where it could be asked.
    pub sensor: Option<ImageSize>,
}

/// Whether a camera that answered discovery can be used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Access {
    /// It can be controlled.
    Free,
    /// Another program controls it.
    InUse,
    /// It answers discovery but cannot be opened, for example because it is on another subnet.
    Unreachable(String),
}

/// Finds a camera, takes control of it, applies its settings and reads each one back.
///
/// The image has `size`. `name` is used in messages.
///
/// # Errors
/// The camera is not found, is controlled by another program for longer than the settings'
/// patience, or does not take a setting; or this build has no driver.
#[cfg(feature = "aravis")]
pub fn open(
    name: &str,
    settings: &CameraSettings,
    size: ImageSize,
) -> Result<Box<dyn Camera>, DeviceError> {
    Ok(Box::new(driver::GigeCamera::open(name, settings, size)?))
}

/// Always an error: this build has no driver.
///
/// # Errors
/// Says what is missing.
#[cfg(not(feature = "aravis"))]
pub fn open(
    name: &str,
    _settings: &CameraSettings,
    _size: ImageSize,
) -> Result<Box<dyn Camera>, DeviceError> {
    Err(not_built(name))
}

/// As [`open`], but the camera exposes frame after frame without a trigger, and is given back as it was
/// found when it is dropped: region, pixel format, exposure, gain, packets and trigger modes.
///
/// For a look at what it sees while nothing is measured. `features`, `ptp`, trigger line and frames per
/// trigger of the settings are not written.
///
/// # Errors
/// As [`open`].
#[cfg(feature = "aravis")]
pub fn open_free_running(
    name: &str,
    settings: &CameraSettings,
    size: ImageSize,
) -> Result<Box<dyn Camera>, DeviceError> {
    Ok(Box::new(driver::GigeCamera::borrow(name, settings, size)?))
}

/// Always an error: this build has no driver.
///
/// # Errors
/// Says what is missing.
#[cfg(not(feature = "aravis"))]
pub fn open_free_running(
    name: &str,
    _settings: &CameraSettings,
    _size: ImageSize,
) -> Result<Box<dyn Camera>, DeviceError> {
    Err(not_built(name))
}

/// The cameras that answer discovery on all network interfaces. Takes about a second, and briefly
/// controls each free camera to check that it answers.
///
/// # Errors
/// This build has no driver.
#[cfg(feature = "aravis")]
pub fn list_devices() -> Result<Vec<FoundCamera>, DeviceError> {
    driver::list_devices()
}

/// Always an error: this build has no driver.
///
/// # Errors
/// Says what is missing.
#[cfg(not(feature = "aravis"))]
pub fn list_devices() -> Result<Vec<FoundCamera>, DeviceError> {
    Err(not_built("cameras"))
}

#[cfg(not(feature = "aravis"))]
fn not_built(device: &str) -> DeviceError {
    DeviceError::NotBuilt {
        device: device.to_owned(),
        detail: "built without Aravis: install libaravis-dev and libusb-1.0-0-dev, and build with \
                 default features"
            .to_owned(),
    }
}

#[cfg(all(test, not(feature = "aravis")))]
mod tests {
    use super::*;

    #[test]
    fn a_missing_driver_is_reported() {
        let size = ImageSize { columns: 8, rows: 8 };
        let Err(error) = open("cam1", &CameraSettings::default(), size) else {
            panic!("a camera without a driver");
        };
        for words in ["cam1", "without Aravis", "libaravis-dev", "default features"] {
            assert!(error.to_string().contains(words), "{error}");
        }
        assert!(list_devices().is_err());
    }
}
