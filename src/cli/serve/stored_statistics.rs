//! The statistics of a finished run, gathered while it is shown.

use std::path::Path;

use anyhow::bail;
use lfpiv_core::ensemble::Snapshot;
use tokio_util::sync::CancellationToken;

use crate::{
    archive::{StoredShot, StoredShots},
    pipeline::Board,
};

/// Reads the shots of the run in `folder`, one after the other, into the statistics of `board`, until `stop` is cancelled.
/// Blocks. A file that cannot be read is logged: the statistics are of the shots before it.
pub(super) fn gather(folder: &Path, board: &Board, stop: &CancellationToken) {
    let gathered = StoredShots::find(folder).map_err(anyhow::Error::from).and_then(|stored| {
        stored.for_each(|shot| {
            if stop.is_cancelled() {
                bail!("it was told to stop");
            }
            let StoredShot { shot: number, grid, velocity_m_s, uncertainty_m_s, status, .. } = shot;
            let snapshot = Snapshot::new(number, &velocity_m_s, &uncertainty_m_s, &status);
            board.statistics().add(&grid, &snapshot);
            Ok(())
        })
    });
    if let Err(error) = gathered
        && !stop.is_cancelled()
    {
        tracing::warn!("the statistics are not of all shots: {error:#}");
    }
}
