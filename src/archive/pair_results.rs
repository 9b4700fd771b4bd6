//! The files that `lfpiv process` writes for image pairs: a folder for each.

use std::{
    fs,
    path::{Path, PathBuf},
};

use super::ArchiveError;

/// The velocity of a pair, in the folder of its results.
const VELOCITY: &str = "velocity.nc";

/// The velocity files of the pairs whose results are in `folder`: a pair's own folder, or the one that has
/// those of several.
pub(super) fn pair_results(folder: &Path) -> Result<Vec<PathBuf>, ArchiveError> {
    let own = folder.join(VELOCITY);
    if own.is_file() {
        return Ok(vec![own]);
    }
    let entries = fs::read_dir(folder).map_err(ArchiveError::io("list the folder", folder))?;
    let mut files = Vec::new();
    for entry in entries {
        let entry = entry.map_err(ArchiveError::io("list the folder", folder))?;
        files.push(entry.path().join(VELOCITY));
    }
    files.retain(|path| path.is_file());
    files.sort();
    Ok(files)
}
