//! `lfpiv scale`: how many shots a second machines on a network would measure.
//!
//! Everything that the forecast is made of is measured here, by one command. Predictions of what this machine can show
//! are made first, then measured, and both are printed. All beyond that is extrapolation, and is called so.

mod checks;
mod costs;
mod model;
mod picture;
mod proxy;
mod report;
mod trial;

use std::{fs, path::PathBuf, sync::Arc};

use anyhow::{Context, bail};
use lfpiv_core::model::ModelMode;

use self::{
    checks::{Check, TOLERANCE, checks, cores},
    costs::{Measured, ShotCost},
    report::{costs_text, forecast_json, forecast_text},
    trial::{Rig, Trial},
};
use super::{
    broker_args::BrokerArgs, output::print, recorded_shots::shot_result,
    run_processor::run_processor,
};
use crate::{
    acquisition::journal::{RecordedRun, RecordedShot},
    archive::ShotResult,
    cluster::{Attempt, Delivery, model_sha256},
    config::Config,
};

/// Workers that keep a coordinator busy, and shots of each.
const CROWD: usize = 8;
const CROWD_SHOTS: usize = 20;
/// Shots of the worker that is alone.
const ALONE_SHOTS: usize = 40;

/// Arguments of `lfpiv scale`.
#[derive(Debug, clap::Args)]
pub struct ScaleArgs {
    /// Folder of a recorded run, whose shots are measured. Nothing in it is changed.
    #[arg(value_name = "RUN")]
    pub run: PathBuf,
    /// Address of a NATS server, as nats://host:4222: that of the cluster, or one on this machine.
    #[arg(long, value_name = "URL")]
    pub url: String,
    /// Folder for the forecast: scale.json and scale.svg.
    #[arg(long, value_name = "OUT")]
    pub out: PathBuf,
    /// Cores of each machine of the forecast; default: those of this one.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub cores: Option<u16>,
    /// Shots at a time on each machine of the forecast.
    #[arg(long, value_name = "N", default_value_t = 2, value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub slots: u16,
    #[command(flatten)]
    pub broker: BrokerArgs,
}

/// Measures, predicts, compares, and forecasts.
///
/// # Errors
/// The run cannot be read, the broker does not answer, or a prediction was wrong by more than 15 %.
pub fn scale(args: &ScaleArgs) -> anyhow::Result<()> {
    let recorded = RecordedRun::open(&args.run)?;
    let text = recorded.description().configuration.clone();
    let config = Config::parse("the run's configuration", &text)?;
    let processor = run_processor(&config)?;
    let shots: Vec<RecordedShot> = recorded.index().shots.into_values().collect();
    let is_chosen = config.model.mode != ModelMode::Explicit;
    let mut reference = None;
    for shot in &shots {
        let measured = processor.process(recorded.pair(shot)?)?;
        let decides = !is_chosen || measured.model.scene.is_some();
        if decides {
            let result = shot_result(measured, shot.dt_us, &shot.suspect, shot.time);
            reference = Some((shot.clone(), result));
            break;
        }
    }
    let Some(reference) = reference else {
        bail!("no shot of {} shows particles: none decides the forward model", args.run.display())
    };
    let shot = ShotCost::measure(&recorded, &processor, &shots, &delivery(&reference))?;
    fs::create_dir_all(&args.out)
        .with_context(|| format!("cannot create {}", args.out.display()))?;
    let rig = Rig {
        recorded,
        config,
        reference,
        processor,
        broker: args.broker.broker(&args.url),
        scratch: args.out.join("trial"),
    };
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .enable_all()
        .build()
        .context("cannot start the runtime")?;
    let (measured, checks) = runtime.block_on(timed(&Arc::new(rig), shot))?;
    conclude(args, &measured, &checks)
}

/// Costs first, then predictions, then what comes of them.
async fn timed(rig: &Arc<Rig>, shot: ShotCost) -> anyhow::Result<(Measured, Vec<Check>)> {
    let idle =
        |workers, shots| Trial { workers, shots, shot_s: 0.0, measures: false, bytes_per_s: None };
    let alone = rig.time(idle(1, ALONE_SHOTS)).await?;
    let crowd = rig.time(idle(CROWD, CROWD_SHOTS)).await?;
    let measured = Measured { shot, alone, crowd };
    print(&costs_text(&measured))?;
    let mut checks = checks(&measured);
    print(&format!("{:<44}{:>12}{:>12}", "workers, shots a second", "predicted", "measured"))?;
    for check in &mut checks {
        // The prediction is out before the trial begins.
        print(&format!("{:<44}{:>12.3}", check.what, check.predicted_per_s))?;
        check.measured_per_s = Some(rig.time(check.trial).await?.shots_per_s);
        let (measured, difference) = (check.measured_per_s, check.difference());
        print(&format!(
            "{:<56}{:>12.3}  {:+.1} %",
            "",
            measured.unwrap_or(0.0),
            100.0 * difference.unwrap_or(0.0)
        ))?;
    }
    Ok((measured, checks))
}

fn conclude(args: &ScaleArgs, measured: &Measured, checks: &[Check]) -> anyhow::Result<()> {
    let machine = report::Machine {
        cores: args.cores.map_or_else(cores, usize::from),
        slots: usize::from(args.slots),
    };
    print(&forecast_text(measured, machine))?;
    let files = [
        ("scale.json", forecast_json(measured, machine, checks)?),
        ("scale.svg", picture::picture(measured, machine, checks)),
    ];
    for (name, content) in files {
        let path = args.out.join(name);
        fs::write(&path, content).with_context(|| format!("cannot write {}", path.display()))?;
        print(&format!("written: {}", path.display()))?;
    }
    let wrong = checks.iter().filter(|check| !check.holds()).count();
    if wrong > 0 {
        bail!(
            "{wrong} of {} predictions were wrong by more than {:.0} %: this machine was busy with other things, or the \
             model does not hold here",
            checks.len(),
            100.0 * TOLERANCE
        )
    }
    Ok(())
}

fn delivery((shot, result): &(RecordedShot, ShotResult)) -> Delivery {
    Delivery {
        shot: shot.trigger,
        attempt: Attempt { issue: 1, delivery: 1 },
        worker: "scale".into(),
        model_sha256: model_sha256(&result.measured.model),
        result: result.clone(),
    }
}
