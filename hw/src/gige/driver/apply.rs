//! Applies settings to the camera and reads each one back.

use aravis::prelude::*;

use super::{
    Exposing,
    features::{Answer, Features},
};
use crate::gige::{CameraSettings, ImageSize};

/// Cameras set exposure and gain in steps: this relative deviation is accepted.
const TOLERATED_STEP: f64 = 0.02;

/// Writes all settings and reads them back.
pub(super) fn apply(
    device: &str,
    camera: &aravis::Camera,
    settings: &CameraSettings,
    size: ImageSize,
    exposing: Exposing,
) -> Answer<()> {
    let features = Features { device, camera };
    // A crashed program may have left it streaming, and nothing can be set meanwhile.
    features.stop()?;
    if exposing == Exposing::Triggered {
        set_own_features(&features, settings)?;
    }
    set_region(&features, settings, size)?;
    features.set_text("PixelFormat", settings.pixel_format.name())?;
    set_light(&features, settings)?;
    set_transport(&features, settings)?;
    set_continuous(&features)?;
    if exposing == Exposing::Triggered {
        set_trigger(&features, settings)?;
        set_clock(&features, settings)?;
    }
    check_payload(&features, settings, size)
}

/// Vendor-specific features, whose types Aravis determines. They cannot be read back as text.
fn set_own_features(features: &Features, settings: &CameraSettings) -> Answer<()> {
    let text = settings.features.as_str();
    match features.camera.device() {
        Some(device) if !text.is_empty() => {
            features.check(&format!("features = {text}"), device.set_features_from_string(text))
        }
        _ => Ok(()),
    }
}

fn set_region(features: &Features, settings: &CameraSettings, size: ImageSize) -> Answer<()> {
    let camera = features.camera;
    let (sensor_columns, sensor_rows) = features.check("sensor size", camera.sensor_size())?;
    let sensor = [sensor_columns, sensor_rows].map(i64::from);
    let [columns, rows] = [size.columns, size.rows].map(|pixels| pixels as i64);
    let [x, y] = settings.offset_px.unwrap_or_default().map(i64::from);
    let fits = match settings.offset_px {
        None => sensor == [columns, rows],
        Some(_) => x + columns <= sensor[0] && y + rows <= sensor[1],
    };
    if !fits {
        return Err(features.refusal(format!(
            "its sensor has {} x {} pixels, but the configuration expects an image of {columns} x {rows} \
             at ({x}, {y}): correct optics.sensor, or set offset_px for a part of the sensor",
            sensor[0], sensor[1]
        )));
    }
    let wanted = [x, y, columns, rows].map(|pixels| pixels as i32);
    let [x, y, columns, rows] = wanted;
    features.check("region", camera.set_region(x, y, columns, rows))?;
    let (x, y, columns, rows) = features.check("region", camera.region())?;
    let found = [x, y, columns, rows];
    features.agree("region", format!("{wanted:?}"), format!("{found:?}"), found == wanted)
}

fn set_light(features: &Features, settings: &CameraSettings) -> Answer<()> {
    let camera = features.camera;
    if let Some(exposure_us) = settings.exposure_us {
        if features.check("ExposureAuto", camera.is_exposure_auto_available())? {
            features.check("ExposureAuto", camera.set_exposure_time_auto(aravis::Auto::Off))?;
        }
        features.check("exposure", camera.set_exposure_time(exposure_us))?;
        let found = features.check("exposure", camera.exposure_time())?;
        let near = (found - exposure_us).abs() <= (exposure_us * TOLERATED_STEP).max(1.0);
        features.agree("exposure in us", exposure_us, found, near)?;
    }
    if let Some(gain_db) = settings.gain_db {
        if features.check("GainAuto", camera.is_gain_auto_available())? {
            features.check("GainAuto", camera.set_gain_auto(aravis::Auto::Off))?;
        }
        features.check("gain", camera.set_gain(gain_db))?;
        let found = features.check("gain", camera.gain())?;
        let near = (found - gain_db).abs() <= (gain_db.abs() * TOLERATED_STEP).max(0.1);
        features.agree("gain in dB", gain_db, found, near)?;
    }
    Ok(())
}

fn set_transport(features: &Features, settings: &CameraSettings) -> Answer<()> {
    let camera = features.camera;
    // Aravis must not change the configured packet size silently.
    camera.gv_set_packet_size_adjustment(aravis::GvPacketSizeAdjustment::Never);
    let wanted = settings.packet_size_bytes;
    features.check("packet size", camera.gv_set_packet_size(wanted as i32))?;
    let found = features.check("packet size", camera.gv_get_packet_size())?;
    features.agree("packet size in bytes", wanted, found, found == wanted)?;

    let wanted_ns = settings.inter_packet_delay_ns as i64;
    if wanted_ns == 0 && !features.has("GevSCPD")? {
        return Ok(());
    }
    features.check("packet delay", camera.gv_set_packet_delay(wanted_ns))?;
    let found_ns = features.check("packet delay", camera.gv_get_packet_delay())?;
    // The camera counts ticks of its own clock, of up to a microsecond.
    let near = (found_ns - wanted_ns).abs() <= 1000;
    features.agree("packet delay in ns", wanted_ns, found_ns, near)
}

/// Frame after frame, without any trigger.
fn set_continuous(features: &Features) -> Answer<()> {
    let camera = features.camera;
    let continuous = camera.set_acquisition_mode(aravis::AcquisitionMode::Continuous);
    features.check("AcquisitionMode = Continuous", continuous)?;
    features.check("TriggerMode = Off", camera.clear_triggers())
}

/// One trigger at the line starts one frame, or a burst of `frames_per_trigger`.
fn set_trigger(features: &Features, settings: &CameraSettings) -> Answer<()> {
    let burst = settings.frames_per_trigger > 1;
    let counted = features.has("AcquisitionBurstFrameCount")?;
    if burst && !counted && settings.features.is_empty() {
        return Err(features.refusal(format!(
            "it has no AcquisitionBurstFrameCount, so {} frames for one trigger must be set by a \
             feature of its own: name it in `features`, or set frames_per_trigger = 1",
            settings.frames_per_trigger
        )));
    }
    let selector = if burst && counted { "FrameBurstStart" } else { "FrameStart" };
    if features.has("TriggerSelector")? {
        features.set_text("TriggerSelector", selector)?;
    }
    if counted {
        let frames = i64::from(settings.frames_per_trigger);
        features.set_integer("AcquisitionBurstFrameCount", frames)?;
    }
    features.set_text("TriggerSource", &settings.trigger_line)?;
    if let Some(activation) = settings.trigger_activation {
        features.set_text("TriggerActivation", activation.name())?;
    }
    features.set_text("TriggerMode", "On")
}

/// The SFNC renamed this feature; older cameras have the GigE Vision name.
fn set_clock(features: &Features, settings: &CameraSettings) -> Answer<()> {
    for feature in ["PtpEnable", "GevIEEE1588"] {
        if features.has(feature)? {
            return features.set_boolean(feature, settings.ptp);
        }
    }
    if settings.ptp {
        return Err(features.refusal("ptp = true, but the camera has no PTP".to_owned()));
    }
    Ok(())
}

/// Checks that the camera's payload has the expected size; otherwise no frame would be complete.
fn check_payload(features: &Features, settings: &CameraSettings, size: ImageSize) -> Answer<()> {
    let wanted = settings.pixel_format.payload_bytes(size.pixels());
    let found = features.check("payload", features.camera.payload())? as usize;
    if found == wanted {
        return Ok(());
    }
    Err(features.refusal(format!(
        "it would send {found} bytes for {} x {} pixels of {}, not {wanted}: switch off its chunk \
         data and line padding",
        size.columns,
        size.rows,
        settings.pixel_format.name()
    )))
}
