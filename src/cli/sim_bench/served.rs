//! Runs simulated instruments until they are stopped.

use std::{
    collections::BTreeMap,
    fmt::Debug,
    path::{Path, PathBuf},
    sync::Arc,
    time::Duration,
};

use anyhow::{Context, bail};
use lfpiv_hw::{CameraName, RawImage, gige::ImageSize};
use lfpiv_sim::{
    faults::Injected,
    wire::{
        Pictures, ScenePictures, WireSettings,
        bench::{WireBench, WireOptions, WireReport},
    },
};

use super::{
    super::{
        drive::drive,
        losses::Losses,
        output::{count, print},
        recorded_bench::{RecordedBench, RecordedPictures, Shown},
        recording::refuse_running,
        replay::read_faults,
        stop::stop_on_signals,
    },
    SimBenchArgs,
    sent_record::SentRecord,
};
use crate::{
    acquisition::SynchroniserThread,
    archive::read_grey_tiff,
    config::{Config, ConfigFile, Purpose},
};

/// Interval at which sent frames are listed.
const LISTING: Duration = Duration::from_millis(100);

/// Serves simulated instruments until Ctrl-C or SIGTERM.
pub fn sim_bench(args: &SimBenchArgs) -> anyhow::Result<()> {
    let config = ConfigFile::load_for(Purpose::Optics, &args.config)?.config;
    let path = args.config.display();
    if let Some(shots) = args.drive {
        let streamed = drive(&config, shots).with_context(|| path.to_string())?;
        return print(&serde_json::to_string(&streamed)?);
    }
    let wire = wire(&config).with_context(|| path.to_string())?;
    let shown = images_to_show(&args.show, &config)?;
    let faults = args.faults.as_deref().map(read_faults).transpose()?.unwrap_or_default();
    match &args.replay {
        Some(run) => {
            refuse_running(run)?;
            let mut recorded = RecordedBench::open(run, &config)?;
            let losses = std::mem::take(&mut recorded.losses);
            print(&format!(
                "shows:        {} of {}",
                count(recorded.triggers(), "trigger"),
                run.display()
            ))?;
            let count_bits = recorded.count_bits;
            let pictures = Arc::new(recorded.pictures(&config)?);
            // The images must be sent with all bits to give the same vectors.
            let options = WireOptions { faults, exact: true };
            let bench = switch_on(&config, &wire, count_bits, pictures.clone(), &options)?;
            show(&bench, shown)?;
            serve(bench, &wire, args.record.as_deref())?;
            conclude_replay(&pictures, losses)
        }
        None => {
            let Some(scene) = config.simulation.clone() else {
                bail!("{path} has no [simulation] table: add one, or replay a run with --replay");
            };
            let (seed, geometry) = (scene.seed, config.bench_geometry());
            let count_bits = scene.sensor.bits.into();
            let pictures = Arc::new(ScenePictures { scene, geometry, seed });
            let options = WireOptions { faults, exact: false };
            let bench = switch_on(&config, &wire, count_bits, pictures, &options)?;
            show(&bench, shown)?;
            serve(bench, &wire, args.record.as_deref())
        }
    }
}

fn wire(config: &Config) -> anyhow::Result<WireSettings> {
    let wire = config.wire.clone();
    let wire = wire.context("no [wire] table: config/loopback-bench.toml is an example")?;
    let (ips, poses) = (wire.camera_ips.len(), config.camera.len());
    if ips != poses {
        bail!("{ips} wire.camera_ips for {poses} [[camera]] tables: give one for each");
    }
    Ok(wire)
}

fn switch_on(
    config: &Config,
    wire: &WireSettings,
    count_bits: u32,
    pictures: Arc<dyn Pictures>,
    options: &WireOptions,
) -> anyhow::Result<WireBench> {
    let size = ImageSize::from(&config.optics.sensor);
    Ok(WireBench::start_with(wire, size, count_bits, pictures, options)?)
}

fn images_to_show(paths: &[PathBuf], config: &Config) -> anyhow::Result<Vec<RawImage>> {
    let cameras = config.camera.len();
    if ![0, cameras].contains(&paths.len()) {
        bail!(
            "--show: {} given: give one for each of {}",
            count(paths.len(), "image"),
            count(cameras, "camera")
        );
    }
    let size = (&config.optics.sensor).into();
    paths.iter().map(|path| Ok(read_grey_tiff(path, size)?)).collect()
}

fn show(bench: &WireBench, images: Vec<RawImage>) -> anyhow::Result<()> {
    for (camera, image) in images.into_iter().enumerate() {
        bench.camera(camera).show(Arc::new(image))?;
    }
    Ok(())
}

/// Runs the bench until a signal arrives.
fn serve(bench: WireBench, wire: &WireSettings, record: Option<&Path>) -> anyhow::Result<()> {
    let record = record.map(SentRecord::create).transpose()?;
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .build()
        .context("cannot start the runtime")?;
    print(&format!("synchroniser: {}", wire.port.display()))?;
    for ip in &wire.camera_ips {
        print(&format!("camera:       {ip}"))?;
    }
    runtime.block_on(list_sent_frames(&bench, record))?;
    print(&summary(&bench.report()))
}

async fn list_sent_frames(bench: &WireBench, mut record: Option<SentRecord>) -> anyhow::Result<()> {
    let stop = stop_on_signals(&SynchroniserThread::default(), "data on the wires is lost")?;
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
    let cameras = report.frames.iter().zip(&report.frame_faults).enumerate();
    let frames = cameras.map(|(index, (frames, faults))| {
        format!(
            "\n{}: {} exposures, {} frames sent, {} lost, {} ignored{}",
            CameraName(index),
            frames.exposures,
            frames.sent,
            frames.lost,
            frames.ignored,
            counted(faults)
        )
    });
    let line = counted(&report.line_faults);
    let line = if line.is_empty() { line } else { format!("\nserial line{line}") };
    format!(
        "{} periods, Q-switch pulses {first} and {second}{}{line}",
        report.periods,
        frames.collect::<String>()
    )
}

/// Faults by kind, as `; faults: 2 Dropped, 1 MissedTrigger`; empty without faults.
fn counted<F: Debug>(faults: &[Injected<F>]) -> String {
    let mut kinds: BTreeMap<String, u64> = BTreeMap::new();
    for injected in faults {
        *kinds.entry(format!("{:?}", injected.fault)).or_default() += 1;
    }
    let listed: Vec<_> = kinds.iter().map(|(kind, number)| format!("{number} {kind}")).collect();
    if listed.is_empty() { String::new() } else { format!("; faults: {}", listed.join(", ")) }
}

fn conclude_replay(pictures: &RecordedPictures, mut losses: Losses) -> anyhow::Result<()> {
    let Shown { recorded, other_light, beyond, damaged, failure } = pictures.shown();
    print(&format!(
        "{recorded} triggers as recorded; dark: {other_light} with other light, {beyond} after the \
         end of the record"
    ))?;
    if failure.is_some() {
        bail!("the record was not shown correctly, see above");
    }
    for (trigger, why) in damaged {
        losses.add(trigger, why);
    }
    losses.conclude()
}
