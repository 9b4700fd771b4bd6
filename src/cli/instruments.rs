//! Opens the configured instruments.

use std::{fs, net::Ipv4Addr, path::Path, time::Duration};

use anyhow::{Context, bail};
use lfpiv_hw::{
    CameraName, RecordedCamera,
    device::Camera,
    gige::{self, CameraSettings, ImageSize},
    synchroniser::{self, line::Transcript},
};
use tokio::sync::mpsc;

use crate::{
    acquisition::{AfterBenchLoss, Bench, Reconnection},
    config::{Config, InstrumentSettings},
};

/// Opens the synchroniser and then the cameras. Opening the synchroniser disables its outputs, so
/// that settings left by an earlier run cannot fire the laser while the cameras are opened.
///
/// # Errors
/// The first instrument that cannot be opened.
pub(super) fn open(config: &Config, instruments: &InstrumentSettings) -> anyhow::Result<Bench> {
    let (bytes, transcript) = mpsc::unbounded_channel();
    // Without a record of the run there is no receiver.
    let listener = Transcript::to_listener(move |entry| drop(bytes.send(entry)));
    let (settings, timing) = (instruments.synchroniser.clone(), config.timing.clone());
    let patience = settings.reconnect_patience_s.map(Duration::from_secs_f64);
    let open = move || synchroniser::open(&settings, &timing, listener.clone());
    let synchroniser = open().context("the synchroniser cannot be used")?;
    let reconnection = match instruments.after_bench_loss {
        AfterBenchLoss::End => None,
        then => Some(Reconnection {
            open: Box::new(open),
            patience,
            waits_for_operator: then == AfterBenchLoss::WaitForArm,
        }),
    };
    check_serials(config, instruments)?;
    let size = ImageSize::from(&config.optics.sensor);
    let cameras = instruments.camera.iter().enumerate().map(|(index, settings)| {
        open_camera(index, settings, size, instruments.frame_record.as_deref())
    });
    let cameras = cameras.collect::<anyhow::Result<_>>()?;
    Ok(Bench { cameras, synchroniser, transcript: Some(transcript), reconnection })
}

/// Checks that cameras opened by address are those of their calibrations, if discovery reaches
/// them.
fn check_serials(config: &Config, instruments: &InstrumentSettings) -> anyhow::Result<()> {
    let expected: Vec<(usize, Ipv4Addr, &str)> = config
        .calibration
        .iter()
        .filter_map(|stored| {
            let index = stored.camera.checked_sub(1)?;
            Some((index, instruments.camera.get(index)?.ip?, stored.serial.as_deref()?))
        })
        .collect();
    if expected.is_empty() {
        return Ok(());
    }
    let found =
        gige::list_devices().context("the serial numbers of the cameras cannot be checked")?;
    for (index, ip, serial) in expected {
        let name = CameraName(index);
        match found.iter().find(|camera| camera.address == ip.to_string()) {
            Some(camera) if camera.serial == serial => {}
            Some(camera) => bail!(
                "{name}: the camera at {ip} has serial {}, but its calibration is for {serial}: \
                 calibrate this camera, or correct instruments.camera[{index}].ip",
                camera.serial
            ),
            None => tracing::warn!(
                "{name}: the camera at {ip} does not answer discovery, so it is unknown whether \
                 its calibration, for serial {serial}, is the right one"
            ),
        }
    }
    Ok(())
}

fn open_camera(
    index: usize,
    settings: &CameraSettings,
    size: ImageSize,
    record: Option<&Path>,
) -> anyhow::Result<Box<dyn Camera>> {
    let name = CameraName(index).to_string();
    let camera =
        gige::open(&name, settings, size).with_context(|| format!("{name} cannot be used"))?;
    let Some(folder) = record else { return Ok(camera) };
    let path = folder.join(format!("{name}.csv"));
    let recorded = fs::create_dir_all(folder).and_then(|()| RecordedCamera::new(camera, &path));
    let recorded = recorded
        .with_context(|| format!("instruments.frame_record: cannot write {}", path.display()))?;
    Ok(Box::new(recorded))
}
