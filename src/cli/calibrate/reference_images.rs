//! Reads input images, with hashes to identify them later.

use std::path::{Path, PathBuf};

use anyhow::Context;
use lfpiv_hw::RawImage;
use serde::{Deserialize, Serialize};

use crate::archive::{ImageSize, read_grey_tiff, read_grey_tiff_of_any_size, sha256};

/// A file that a calibration was made from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct InputFile {
    /// The path as given.
    pub file: PathBuf,
    /// SHA-256 of the content.
    pub sha256: String,
}

impl InputFile {
    /// Describes a file with the given content.
    pub fn of_bytes(file: &Path, content: &[u8]) -> Self {
        Self { file: file.into(), sha256: sha256(content) }
    }
}

/// Reads images; they must have the given size, if any.
pub fn read_images(
    paths: &[PathBuf],
    size: Option<ImageSize>,
) -> anyhow::Result<(Vec<RawImage>, Vec<InputFile>)> {
    let mut images = Vec::new();
    let mut files = Vec::new();
    for path in paths {
        images.push(match size {
            Some(size) => read_grey_tiff(path, size)?,
            None => read_grey_tiff_of_any_size(path)?,
        });
        let content =
            std::fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
        files.push(InputFile::of_bytes(path, &content));
    }
    Ok((images, files))
}
