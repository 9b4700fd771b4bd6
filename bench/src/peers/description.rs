//! `case.json`: what the arrays beside it are.

use std::{fs, path::Path};

use lfpiv_rawlog::regular_file::read_text;
use serde::{Serialize, de::DeserializeOwned};

use super::PeersError;

const FILE: &str = "case.json";

/// Writes the description of the case in `folder`.
pub fn write_description(folder: &Path, description: &impl Serialize) -> Result<(), PeersError> {
    let path = folder.join(FILE);
    let text = serde_json::to_string_pretty(description)
        .map_err(|reason| PeersError::WrongDescription { path: path.clone(), reason })?;
    fs::write(&path, text + "\n").map_err(PeersError::io("write", &path))
}

/// Reads the description of the case in `folder`.
pub fn read_description<T: DeserializeOwned>(folder: &Path) -> Result<T, PeersError> {
    let path = folder.join(FILE);
    let text = read_text(&path).map_err(PeersError::io("read", &path))?;
    serde_json::from_str(&text).map_err(|reason| PeersError::WrongDescription { path, reason })
}

/// A case is called as its folder.
pub fn case_name(folder: &Path) -> String {
    folder.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}
