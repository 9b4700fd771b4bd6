//! Opens the instruments that a configuration names.

use std::{fs, path::Path, time::Duration};

use anyhow::Context;
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

/// Opens synchroniser and cameras, in this order: opening the synchroniser disables its outputs,
/// and what an earlier run left behind must not fire while cameras are looked for.
///
/// # Errors
/// The first instrument that cannot be had.
pub(super) fn open(config: &Config, instruments: &InstrumentSettings) -> anyhow::Result<Bench> {
    let (bytes, transcript) = mpsc::unbounded_channel();
    // Nobody listens where no record of the run is kept.
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
    let size = ImageSize::from(&config.optics.sensor);
    let cameras = instruments.camera.iter().enumerate().map(|(index, settings)| {
        open_camera(index, settings, size, instruments.frame_record.as_deref())
    });
    let cameras = cameras.collect::<anyhow::Result<_>>()?;
    Ok(Bench { cameras, synchroniser, transcript: Some(transcript), reconnection })
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
