//! `lfpiv export`: writes a run's images, vectors or particles in the formats of other programs.

mod images;
mod paraview;
mod vectors;

use std::{ops::RangeInclusive, path::PathBuf};

use clap::ValueEnum;

use super::shot_range::shot_range;

/// Arguments of `lfpiv export`.
#[derive(Debug, clap::Args)]
pub struct ExportArgs {
    /// Folder of the run. Vectors can also be exported from an output folder of `lfpiv process`.
    #[arg(value_name = "RUN")]
    pub run: PathBuf,
    /// Folder for the files.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// What to write.
    #[arg(long, value_enum, default_value_t = Format::Tiff)]
    pub format: Format,
    /// Only these shots: a number, or first and last as A..B.
    #[arg(long, value_name = "A..B", value_parser = shot_range)]
    pub shots: Option<RangeInclusive<u64>>,
}

/// The output format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// The recorded images: a folder of TIFF files for each shot, as read by `lfpiv process`.
    Tiff,
    /// The vectors: a file for each shot, a line for each vector; missing values are empty.
    Csv,
    /// The vectors in Tecplot's ASCII format: a file for each shot, SI units.
    Tecplot,
    /// The vectors as plain arrays over shot, z, y, x; missing values are NaN.
    Hdf5,
    /// Vectors and placed particles for ParaView: .vti and .vtp files for each shot, and lists that open
    /// them as animations.
    Paraview,
}

/// Exports in the chosen format.
pub fn export(args: &ExportArgs) -> anyhow::Result<()> {
    match args.format {
        Format::Tiff => images::export(args),
        Format::Paraview => paraview::export(args),
        _ => vectors::export(args),
    }
}

impl ExportArgs {
    fn includes(&self, shot: u64) -> bool {
        self.shots.as_ref().is_none_or(|range| range.contains(&shot))
    }
}
