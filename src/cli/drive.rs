//! Drives a simulated bench over real wires with this program's drivers, as fast as requested.

use std::{num::NonZeroU64, sync::Arc, time::Duration, time::Instant};

use anyhow::{Context, bail};
use lfpiv_hw::{
    PulseSchedule, RawImage,
    gige::{CameraSettings, ImageSize, PixelFormat},
    synchroniser::{SynchroniserDriver, SynchroniserSettings},
};
use lfpiv_sim::{
    LightPulse,
    wire::{Delivery, Pictures, WireSettings, bench::WireBench},
};
use parking_lot::Mutex;
use tokio_util::sync::CancellationToken;

use super::{
    daemon_plan::frame_bytes, instruments::open, processor_time::processor_s, streamed::Streamed,
};
use crate::{
    acquisition::{
        AcquisitionLinks, AcquisitionSettings, AfterBenchLoss, Bench, Ledger, Outcome,
        OverloadPolicy, acquire, shot_queue,
    },
    config::{Config, InstrumentSettings},
};

/// Pixel format of the frames.
const PIXEL_FORMAT: PixelFormat = PixelFormat::Mono12Packed;

/// The driver copies each frame once: from Aravis' buffer, unpacked, into the stored image.
const COPIES_PER_FRAME: usize = 1;

/// Returns the same image for every exposure, because image generation is not measured.
struct Still(RawImage);

impl Pictures for Still {
    fn of(&self, _: u64, light: &[[Vec<LightPulse>; 2]], _: Option<f64>) -> Vec<Delivery> {
        light.iter().map(|_| [self.0.clone(), self.0.clone()].into()).collect()
    }
}

/// Takes `shots` shots over the wires described by `config` and discards them.
///
/// # Errors
/// There is no `[wire]` table, an instrument is not available, or the run fails.
pub fn drive(config: &Config, shots: NonZeroU64) -> anyhow::Result<Streamed> {
    let Some(wire) = &config.wire else { bail!("there is no [wire] table") };
    let size = ImageSize::from(&config.optics.sensor);
    let counts = (0..size.pixels()).map(|pixel| ((pixel * 2_654_435_761) >> 7 & 0xfff) as u16);
    let still = Still(RawImage::new(size.columns, size.rows, counts.collect())?);
    let _instruments = WireBench::start(wire, size, 12, Arc::new(still))?;
    let named = instruments(wire)?;
    let bench = open(config, &named)?;
    let settings = AcquisitionSettings {
        schedule: PulseSchedule::plan(&config.timing, config.shot.dt_us, config.shot.rate_hz)?,
        shots: Some(shots),
        overload: OverloadPolicy::Wait,
        patience: Duration::from_secs_f64(named.frame_patience_s),
        frame_bytes: frame_bytes(&config.optics.sensor),
    };
    let ledger = Arc::new(Mutex::new(Ledger::new(config.camera.len())));
    let runtime = tokio::runtime::Builder::new_multi_thread().enable_all().build()?;
    let (began, busy) = (Instant::now(), processor_s());
    runtime.block_on(take_all(bench, settings, &ledger))?;
    let seconds = began.elapsed().as_secs_f64();
    let ledger = ledger.lock();
    let frames: u64 = ledger.streams().iter().map(|stream| stream.completed).sum();
    let frames_per_s = frames as f64 / config.camera.len() as f64 / seconds;
    let frame_mb = PIXEL_FORMAT.payload_bytes(size.pixels()) as f64 / 1e6;
    Ok(Streamed {
        whole_shots: ledger.accounts()[0].outcomes.of(Outcome::Complete),
        seconds,
        processor_seconds: processor_s() - busy,
        frames_per_s,
        mb_per_s: frames_per_s * frame_mb,
        copies_per_frame: COPIES_PER_FRAME,
    })
}

/// Settings for the simulated instruments, as in a configuration for `lfpiv run`.
fn instruments(wire: &WireSettings) -> anyhow::Result<InstrumentSettings> {
    let port = wire.port.to_str().context("the port's path is not UTF-8")?;
    let camera = |&ip| CameraSettings {
        ip: Some(ip),
        pixel_format: PIXEL_FORMAT,
        packet_size_bytes: 16_000,
        socket_buffer_bytes: 4 << 20,
        frame_retention_us: 2_000_000,
        ..CameraSettings::default()
    };
    Ok(InstrumentSettings {
        camera: wire.camera_ips.iter().map(camera).collect(),
        synchroniser: SynchroniserSettings {
            pacing_ms: 0,
            ..SynchroniserSettings::at(SynchroniserDriver::Bnc575, port)
        },
        frame_patience_s: 10.0,
        after_bench_loss: AfterBenchLoss::End,
        frame_record: None,
    })
}

async fn take_all(
    bench: Bench,
    settings: AcquisitionSettings,
    ledger: &Arc<Mutex<Ledger>>,
) -> anyhow::Result<()> {
    let capacity = settings.max_burst() as usize;
    let (sender, mut receiver) = shot_queue(capacity);
    let stop = CancellationToken::new();
    let links = AcquisitionLinks::new(ledger.clone(), sender, stop);
    let acquiring = tokio::spawn(acquire(bench, settings, links));
    while let Some(shot) = receiver.recv().await {
        ledger.lock().settle_all(shot.trigger, Outcome::Complete)?;
    }
    acquiring.await??;
    Ok(())
}
