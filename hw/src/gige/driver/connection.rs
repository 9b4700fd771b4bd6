//! Finds a camera and takes control of it.

use std::{
    net::Ipv4Addr,
    sync::{
        Arc, Mutex, MutexGuard, PoisonError,
        atomic::{AtomicBool, Ordering},
    },
    thread::sleep,
    time::{Duration, Instant},
};

use aravis::{glib::prelude::*, prelude::*};

use super::{Exposing, apply::apply};
use crate::{
    device::DeviceError,
    gige::{Access, CameraSettings, FoundCamera, ImageSize},
};

/// Time between attempts to take control.
const CONTROL_RETRY: Duration = Duration::from_millis(500);

/// Aravis has one device list per process, which discovery rewrites.
static DISCOVERY: Mutex<()> = Mutex::new(());

fn discovery() -> MutexGuard<'static, ()> {
    DISCOVERY.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A camera under control, with its settings applied. After a loss of control Aravis' objects never
/// recover and must be recreated.
pub(super) struct Connection {
    pub(super) camera: aravis::Camera,
    lost: Arc<AtomicBool>,
}

impl Connection {
    /// Takes control and applies the settings.
    pub(super) fn open(
        name: &str,
        settings: &CameraSettings,
        size: ImageSize,
        exposing: Exposing,
    ) -> Result<Self, DeviceError> {
        let connection = Self::control(name, settings)?;
        connection.apply(name, settings, size, exposing)?;
        Ok(connection)
    }

    /// Takes control, and changes nothing; waits while another program controls the camera, up to the
    /// configured patience.
    pub(super) fn control(name: &str, settings: &CameraSettings) -> Result<Self, DeviceError> {
        let asked = Instant::now();
        let patience = Duration::from_secs_f64(settings.control_patience_s);
        let mut waiting = false;
        loop {
            let address = address(name, settings)?;
            let Some((camera, lost)) = take_control(name, &address)? else {
                if asked.elapsed() >= patience {
                    return Err(in_use(name, &address, patience));
                }
                if !waiting {
                    tracing::warn!(
                        camera = name,
                        %address,
                        "another program controls it, or has crashed while controlling it: waiting up to {} s for \
                         its heartbeat to time out",
                        patience.as_secs_f64()
                    );
                    waiting = true;
                }
                sleep(CONTROL_RETRY);
                continue;
            };
            // Read-back must come from the camera, not from a cache; unsupported features are not written.
            camera.set_register_cache_policy(aravis::RegisterCachePolicy::Disable);
            camera.set_range_check_policy(aravis::RangeCheckPolicy::Enable);
            tracing::debug!(camera = name, %address, "controlled");
            return Ok(Self { camera, lost });
        }
    }

    /// Writes the settings and reads them back.
    pub(super) fn apply(
        &self,
        name: &str,
        settings: &CameraSettings,
        size: ImageSize,
        exposing: Exposing,
    ) -> Result<(), DeviceError> {
        apply(name, &self.camera, settings, size, exposing)?;
        tracing::info!(camera = name, "opened, settings applied and read back");
        Ok(())
    }

    /// Whether the camera no longer answers. This object stays lost.
    pub(super) fn is_lost(&self) -> bool {
        self.lost.load(Ordering::Acquire)
    }
}

fn in_use(name: &str, address: &Ipv4Addr, patience: Duration) -> DeviceError {
    let waited = match patience {
        Duration::ZERO => String::new(),
        _ => format!(" and did not release it within {} s", patience.as_secs_f64()),
    };
    DeviceError::Refused {
        device: name.to_owned(),
        detail: format!(
            "another program controls the camera at {address}{waited}: end it (a second lfpiv, a vendor's \
             viewer) and start again"
        ),
    }
}

/// Opens the camera; `None` if another program controls it. In that case `Camera::new` succeeds, but
/// writes are ignored or refused.
fn take_control(
    name: &str,
    address: &Ipv4Addr,
) -> Result<Option<(aravis::Camera, Arc<AtomicBool>)>, DeviceError> {
    let _one_at_a_time = discovery();
    let camera = aravis::Camera::new(Some(&address.to_string())).map_err(|error| {
        let detail = format!("nothing answers at {address}: {}", error.message());
        DeviceError::NotFound { device: name.to_owned(), detail }
    })?;
    let Some(device) = camera.device().and_then(|device| device.downcast().ok()) else {
        let detail = format!("the device at {address} is not a GigE Vision camera");
        return Err(DeviceError::Refused { device: name.to_owned(), detail });
    };
    let device: aravis::GvDevice = device;
    if !device.is_controller() {
        return Ok(None);
    }
    let lost = Arc::new(AtomicBool::new(false));
    let is_lost = Arc::clone(&lost);
    device.connect_control_lost(move |_| is_lost.store(true, Ordering::Release));
    Ok(Some((camera, lost)))
}

/// Address of the camera: configured, or found by discovery of its serial number.
fn address(name: &str, settings: &CameraSettings) -> Result<Ipv4Addr, DeviceError> {
    let not_found = |detail| DeviceError::NotFound { device: name.to_owned(), detail };
    let serial = match (settings.ip, &settings.serial) {
        (Some(ip), _) => return Ok(ip),
        (None, Some(serial)) => serial,
        (None, None) => return Err(not_found("neither ip nor serial is configured".to_owned())),
    };
    let cameras = discover();
    let found = cameras.iter().find(|camera| camera.serial == *serial);
    found.and_then(|camera| camera.address.parse().ok()).ok_or_else(|| {
        let others: Vec<&str> = cameras.iter().map(|camera| camera.serial.as_str()).collect();
        not_found(format!(
            "no camera with serial {serial} answers discovery; found: [{}]. Cameras on another \
             subnet are reached by ip only",
            others.join(", ")
        ))
    })
}

/// The cameras that answer discovery, not opened yet.
fn discover() -> Vec<FoundCamera> {
    let _one_at_a_time = discovery();
    let Some(network) = aravis::GvInterface::instance() else { return Vec::new() };
    network.update_device_list();
    let text = |value: Option<aravis::glib::GString>| value.map_or(String::new(), String::from);
    (0..network.n_devices())
        .map(|index| FoundCamera {
            vendor: text(network.device_vendor(index)),
            model: text(network.device_model(index)),
            serial: text(network.device_serial_nbr(index)),
            address: text(network.device_address(index)),
            access: Access::Free,
            sensor: None,
        })
        .collect()
}

/// All cameras on the network, with their accessibility.
pub(in crate::gige) fn list_devices() -> Result<Vec<FoundCamera>, DeviceError> {
    let mut cameras = discover();
    for camera in &mut cameras {
        let tried = camera.address.parse().map(|address| take_control(&camera.serial, &address));
        camera.access = match tried {
            Ok(Ok(Some((device, _)))) => {
                camera.sensor = sensor(&device);
                Access::Free
            }
            Ok(Ok(None)) => Access::InUse,
            Ok(Err(error)) => Access::Unreachable(error.to_string()),
            Err(_) => Access::Unreachable(format!("{:?} is not an address", camera.address)),
        };
    }
    Ok(cameras)
}

/// A sensor's size; none where the camera has no such feature.
fn sensor(camera: &aravis::Camera) -> Option<ImageSize> {
    let (columns, rows) = camera.sensor_size().ok()?;
    Some(ImageSize { columns: columns.try_into().ok()?, rows: rows.try_into().ok()? })
}
