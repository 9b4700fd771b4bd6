//! `lfpiv sim-bench`: simulated instruments at the ends of real wires, for a daemon that knows
//! nothing of it.

use std::{num::NonZeroU64, path::PathBuf};

/// Arguments of `lfpiv sim-bench`.
#[derive(Debug, clap::Args)]
pub struct SimBenchArgs {
    /// Configuration file (TOML) with the tables [simulation] and [wire].
    #[arg(long, value_name = "FILE")]
    pub config: PathBuf,
    /// List every frame that is sent in this file, with a checksum of its pixels.
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,
    /// Do not wait for a daemon: take so many shots with this program's own drivers, and print how
    /// fast they came, as JSON.
    #[arg(long, value_name = "SHOTS", conflicts_with = "record")]
    pub drive: Option<NonZeroU64>,
}

#[cfg(not(feature = "aravis"))]
pub fn sim_bench(_: &SimBenchArgs) -> anyhow::Result<()> {
    anyhow::bail!(
        "built without Aravis, which the simulated cameras need: install libaravis-dev and \
         libusb-1.0-0-dev, and build with default features"
    )
}

#[cfg(feature = "aravis")]
pub use with_aravis::sim_bench;

#[cfg(feature = "aravis")]
mod with_aravis {
    use std::{
        fs::File,
        io::{self, LineWriter, Write},
        path::Path,
        sync::Arc,
        time::Duration,
    };

    use anyhow::{Context, bail};
    use lfpiv_hw::gige::ImageSize;
    use lfpiv_sim::wire::{
        ScenePictures,
        bench::{WireBench, WireReport},
    };

    use super::{
        super::{drive::drive, output::print, stop::stop_on_signals},
        SimBenchArgs,
    };
    use crate::config::ConfigFile;

    /// How often frames that were sent are listed.
    const LISTING: Duration = Duration::from_millis(100);

    /// Serves simulated instruments until Ctrl-C or SIGTERM.
    pub fn sim_bench(args: &SimBenchArgs) -> anyhow::Result<()> {
        let config = ConfigFile::load(&args.config)?.config;
        let path = args.config.display();
        if let Some(shots) = args.drive {
            let streamed = drive(&config, shots).with_context(|| path.to_string())?;
            return print(&serde_json::to_string(&streamed)?);
        }
        let (Some(scene), Some(wire)) = (config.simulation.clone(), config.wire.clone()) else {
            bail!(
                "{path} has no [simulation] and [wire] tables: take config/loopback-bench.toml as \
                 a start"
            );
        };
        if wire.camera_ips.len() != config.camera.len() {
            let (ips, poses) = (wire.camera_ips.len(), config.camera.len());
            bail!("{path}: {ips} wire.camera_ips for {poses} [[camera]] tables; one for each");
        }
        let pictures = ScenePictures {
            seed: scene.seed,
            geometry: config.bench_geometry(),
            scene: scene.clone(),
        };
        let size = ImageSize::from(&config.optics.sensor);
        let bench = WireBench::start(&wire, size, scene.sensor.bits.into(), Arc::new(pictures))?;
        let record = args.record.as_deref().map(Record::create).transpose()?;
        let runtime = tokio::runtime::Builder::new_current_thread()
            .enable_all()
            .build()
            .context("the runtime does not start")?;
        print(&format!("synchroniser: {}", wire.port.display()))?;
        for ip in &wire.camera_ips {
            print(&format!("camera:       {ip}"))?;
        }
        runtime.block_on(serve(&bench, record))?;
        print(&summary(&bench.report()))
    }

    async fn serve(bench: &WireBench, mut record: Option<Record>) -> anyhow::Result<()> {
        let stop = stop_on_signals("what is on the wires is lost")?;
        while !stop.is_cancelled() {
            tokio::select! {
                () = stop.cancelled() => {}
                () = tokio::time::sleep(LISTING) => {}
            }
            let sent = bench.take_sent();
            if let Some(record) = &mut record {
                for frame in &sent {
                    record.list(frame).context("the record of sent frames cannot be written")?;
                }
            }
        }
        Ok(())
    }

    fn summary(report: &WireReport) -> String {
        let [first, second] = report.q_switches;
        let frames = report.frames.iter().enumerate().map(|(index, frames)| {
            format!(
                "\ncamera {}: {} exposures, {} frames sent, {} ignored",
                index + 1,
                frames.exposures,
                frames.sent,
                frames.ignored
            )
        });
        format!(
            "{} periods, Q-switch pulses {first} and {second}{}",
            report.periods,
            frames.collect::<String>()
        )
    }

    /// The list of frames that were sent, as comma-separated values.
    struct Record(LineWriter<File>);

    impl Record {
        fn create(path: &Path) -> anyhow::Result<Self> {
            let create = || {
                if let Some(folder) = path.parent() {
                    std::fs::create_dir_all(folder)?;
                }
                let mut file = LineWriter::new(File::create(path)?);
                writeln!(file, "camera,shot,exposure,device_timestamp_ns,crc32")?;
                Ok::<_, io::Error>(file)
            };
            let file = create().with_context(|| format!("cannot write {}", path.display()))?;
            Ok(Self(file))
        }

        fn list(&mut self, frame: &lfpiv_sim::wire::bench::SentFrame) -> io::Result<()> {
            let camera = frame.camera + 1;
            let (shot, exposure) = (frame.shot, frame.exposure);
            let (timestamp_ns, crc32) = (frame.device_timestamp_ns, frame.crc32);
            writeln!(self.0, "cam{camera},{shot},{exposure},{timestamp_ns},{crc32:08x}")
        }
    }
}
