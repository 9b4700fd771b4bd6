//! Access to GenICam features with read-back.

use std::fmt::Display;

use aravis::{glib, prelude::*};

use crate::device::DeviceError;

/// The features of one camera.
/// The features of one camera.
///
/// Twelve methods of `aravis::Camera` mistake a returned `false` for an error and panic in debug builds
/// (`is_feature_implemented`, `gv_auto_packet_size`, …): do not use methods that answer a question with
/// `Result<()>`.
pub(super) struct Features<'a> {
    pub(super) device: &'a str,
    pub(super) camera: &'a aravis::Camera,
}

impl Features<'_> {
    /// Converts an Aravis error, adding the operation.
    pub(super) fn check<T>(&self, what: &str, result: Result<T, glib::Error>) -> Answer<T> {
        result.map_err(|error| self.refusal(format!("{what}: {}", error.message())))
    }

    pub(super) fn refusal(&self, detail: String) -> DeviceError {
        DeviceError::Refused { device: self.device.to_owned(), detail }
    }

    /// Stops the acquisition.
    pub(super) fn stop(&self) -> Answer<()> {
        self.check("AcquisitionStop", self.camera.stop_acquisition())
    }

    pub(super) fn has(&self, feature: &str) -> Answer<bool> {
        self.check(feature, self.camera.is_feature_available(feature))
    }

    /// Sets an enumeration or string feature.
    pub(super) fn set_text(&self, feature: &str, value: &str) -> Answer<()> {
        self.check(&format!("{feature} = {value}"), self.camera.set_string(feature, value))?;
        let found = self.check(feature, self.camera.string(feature))?;
        self.agree(feature, value, found.as_str(), found == value)
    }

    pub(super) fn set_integer(&self, feature: &str, value: i64) -> Answer<()> {
        self.check(&format!("{feature} = {value}"), self.camera.set_integer(feature, value))?;
        let found = self.check(feature, self.camera.integer(feature))?;
        self.agree(feature, value, found, found == value)
    }

    pub(super) fn set_boolean(&self, feature: &str, value: bool) -> Answer<()> {
        self.check(&format!("{feature} = {value}"), self.camera.set_boolean(feature, value))?;
        let found = self.check(feature, self.camera.boolean(feature))?;
        self.agree(feature, value, found, found == value)
    }

    /// An error unless the read-back matches what was written.
    pub(super) fn agree<T: Display, U: Display>(
        &self,
        what: &str,
        written: T,
        found: U,
        equal: bool,
    ) -> Answer<()> {
        if equal {
            return Ok(());
        }
        Err(self.refusal(format!("{what} was set to {written} and reads back {found}")))
    }
}

pub(super) type Answer<T> = Result<T, DeviceError>;
