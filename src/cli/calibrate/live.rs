//! The newest frame of a free-running camera.

use std::{
    panic::resume_unwind,
    path::Path,
    thread,
    time::{Duration, Instant},
};

use anyhow::{Context, bail};
use lfpiv_hw::{
    CameraName,
    device::{Camera, DeviceError, Frame, FrameStatus},
    gige::{self, CameraSettings, ImageSize},
};
use tokio::sync::watch;
use tokio_util::sync::CancellationToken;

use crate::{
    acquisition::SynchroniserThread,
    cli::{output::count, stop::stop_on_signals},
    config::Config,
    pipeline::run_after_acquisition,
};

/// Longest wait for a frame before signals are checked.
const FRAME_WAIT: Duration = Duration::from_millis(100);

/// Longest pause between frames, in addition to exposures, before a warning.
const SILENCE: Duration = Duration::from_secs(3);

/// A configured camera that can be observed.
pub(super) struct LiveCamera {
    name: CameraName,
    settings: CameraSettings,
    size: ImageSize,
}

impl LiveCamera {
    /// The camera of this number, from 1, of a configuration from `path`; with another exposure, if one is given.
    ///
    /// # Errors
    /// The configuration has no instruments, or no camera of this number.
    pub fn configured(
        path: &Path,
        config: &Config,
        number: u8,
        exposure_us: Option<f64>,
    ) -> anyhow::Result<Self> {
        let path = path.display();
        let Some(instruments) = &config.instruments else {
            bail!(
                "{path} has no [instruments] with the address of a camera (config/loopback.toml \
                 explains the keys); `--image FILE --watch` evaluates images of another program"
            );
        };
        let (index, cameras) = (usize::from(number) - 1, instruments.camera.len());
        let Some(settings) = instruments.camera.get(index) else {
            bail!("{path} has {}: give --camera 1 to {cameras}", count(cameras, "camera"));
        };
        let settings = CameraSettings {
            exposure_us: exposure_us.or(settings.exposure_us),
            // Whoever adjusts a camera should know at once that another program controls it.
            control_patience_s: 0.0,
            ..settings.clone()
        };
        Ok(Self { name: CameraName(index), settings, size: (&config.optics.sensor).into() })
    }

    /// Its name, as `cam1`.
    pub fn name(&self) -> CameraName {
        self.name
    }

    /// Starts the camera, and calls `look` with its newest intact frame until Ctrl-C, SIGTERM or `false` from
    /// `look`. Frames that arrive during a call are skipped.
    ///
    /// # Errors
    /// Another program controls the camera, it is lost, or `look` fails.
    pub fn watch(&self, look: impl FnMut(&Frame) -> anyhow::Result<bool>) -> anyhow::Result<()> {
        let runtime = tokio::runtime::Builder::new_multi_thread()
            .worker_threads(1)
            .enable_all()
            .build()
            .context("nothing can listen for Ctrl-C")?;
        let words = "the camera's settings are not restored";
        // There is no laser to wait for.
        let laser = SynchroniserThread::default();
        let listening = async { stop_on_signals(&laser, words) };
        let stop = runtime.block_on(listening)?;
        let name = self.name.to_string();
        let mut camera = gige::open_free_running(&name, &self.settings, self.size)
            .with_context(|| format!("{name} cannot be used"))?;
        let (newest, seen) = watch::channel(None);
        let exposure = Duration::from_secs_f64(self.settings.exposure_us.unwrap_or(0.0) / 1e6);
        let receiver = Receiver { patience: SILENCE + 2 * exposure, stop: stop.clone() };
        thread::scope(|scope| {
            let receiving = scope.spawn(|| receiver.receive(camera.as_mut(), newest));
            // Frames are received first, here and by other programs of this machine.
            run_after_acquisition();
            rayon::broadcast(|_| run_after_acquisition());
            let looked = runtime.block_on(each(seen, &stop, look));
            stop.cancel();
            let received = receiving.join().unwrap_or_else(|panic| resume_unwind(panic));
            looked?;
            Ok(received?)
        })
    }
}

/// Receives frames on a thread of its own, so that the newest one is always available.
struct Receiver {
    /// Longest pause between frames before a warning.
    patience: Duration,
    stop: CancellationToken,
}

impl Receiver {
    fn receive(
        &self,
        camera: &mut dyn Camera,
        newest: watch::Sender<Option<Frame>>,
    ) -> Result<(), DeviceError> {
        camera.start()?;
        let (mut heard, mut told) = (Instant::now(), false);
        while !self.stop.is_cancelled() {
            match camera.next_frame(FRAME_WAIT)? {
                Some(frame) if frame.status == FrameStatus::Complete => {
                    (heard, told) = (Instant::now(), false);
                    newest.send_replace(Some(frame));
                }
                Some(frame) => {
                    heard = Instant::now();
                    tracing::warn!(
                        camera = camera.name(),
                        "frame {} is damaged, packets were lost: `lfpiv doctor` checks the network",
                        frame.frame_id
                    );
                }
                None if !told && camera.is_connected() && heard.elapsed() > self.patience => {
                    told = true;
                    tracing::warn!(
                        camera = camera.name(),
                        "no frame for {:.0} s: if the camera is in a double-exposure mode that needs a trigger, \
                         set it to single exposures in its vendor's program",
                        heard.elapsed().as_secs_f64()
                    );
                }
                None => {}
            }
        }
        camera.stop()
    }
}

/// Calls `look` with the newest frame, repeatedly, until the frames end.
async fn each(
    mut seen: watch::Receiver<Option<Frame>>,
    stop: &CancellationToken,
    mut look: impl FnMut(&Frame) -> anyhow::Result<bool>,
) -> anyhow::Result<()> {
    loop {
        tokio::select! {
            biased;
            () = stop.cancelled() => return Ok(()),
            changed = seen.changed() => {
                if changed.is_err() {
                    return Ok(());
                }
            }
        }
        let frame = seen.borrow_and_update().clone();
        if let Some(frame) = frame
            && !look(&frame)?
        {
            return Ok(());
        }
    }
}
