//! What a run on several machines tells its workers and its user.

use std::path::Path;

use super::{
    output::{count, print},
    run_processor::conditions_of,
};
use crate::{
    acquisition::journal::{RecordedRun, RecordedShot},
    archive::ShotResult,
    cluster::{Assignment, Attempt, Delivery, Reference, Shot, Tally, model_sha256},
    config::Config,
};

/// What workers are told of a run, with the shot that they must measure alike, and its result. `wants_light`: somebody
/// looks at the light of its shots.
///
/// # Errors
/// A record or a background image cannot be read.
pub(super) fn assignment(
    recorded: &RecordedRun,
    config: &Config,
    (shot, result): (&RecordedShot, &ShotResult),
    wants_light: bool,
) -> anyhow::Result<Assignment> {
    let shot = Shot::of(recorded, shot)?;
    let measured = Delivery {
        shot: shot.number,
        attempt: Attempt { issue: 0, delivery: 0 },
        worker: String::new(),
        model_sha256: model_sha256(&result.measured.model),
        result: result.clone(),
    };
    Ok(Assignment {
        conditions: conditions_of(recorded, shot.sha256(), config)?,
        configuration: recorded.description().configuration.clone(),
        reference: Reference {
            result_sha256: measured.result_sha256(),
            model_sha256: measured.model_sha256,
            shot,
        },
        wants_light,
    })
}

/// The name of a run's folder, under which workers look for it in a shared one.
pub(super) fn run_name(folder: &Path) -> String {
    let whole = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    whole.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// Prints who has measured how much.
///
/// # Errors
/// Standard output cannot be written.
pub(super) fn print_workers(tally: &Tally, refused: usize) -> anyhow::Result<()> {
    for (worker, shots) in tally.by_worker() {
        print(&format!("{worker}: {}", count(shots, "shot")))?;
    }
    print(&format!(
        "{} started, {} lost with their workers, {} refused",
        count(tally.attempts(), "measurement"),
        tally.lost(),
        count(refused, "result")
    ))
}
