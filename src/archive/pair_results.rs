//! The files that `lfpiv process` writes for image pairs, one folder per pair.

use std::{
    fs,
    path::{Path, PathBuf},
};

use super::ArchiveError;

/// Name of a pair's velocity file.
const VELOCITY: &str = "velocity.nc";

/// The velocity files in `folder`, which is the result folder of one pair or the parent of several.
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
