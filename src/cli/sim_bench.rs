//! `lfpiv sim-bench`: simulated instruments on real wires, for an unmodified daemon.

#[cfg(feature = "aravis")]
mod sent_record;
#[cfg(feature = "aravis")]
mod served;

use std::{num::NonZeroU64, path::PathBuf};

/// Arguments of `lfpiv sim-bench`.
#[derive(Debug, clap::Args)]
pub struct SimBenchArgs {
    /// Configuration file (TOML) with the table [wire], and [simulation] for the images.
    #[arg(long, value_name = "FILE")]
    pub config: PathBuf,
    /// Show the frames of this recorded run instead of a simulated scene: trigger n shows the
    /// frames of trigger n, and lost frames are lost again. Triggers after the end of the record,
    /// and light that differs from the record, give dark images.
    #[arg(long, value_name = "RUN", conflicts_with = "drive")]
    pub replay: Option<PathBuf>,
    /// One image per camera, sent while the camera is free-running; 8- or 16-bit grey TIFF. The default is
    /// dark images.
    #[arg(long, value_name = "FILE", num_args = 1.., conflicts_with = "drive")]
    pub show: Vec<PathBuf>,
    /// File of fault settings (TOML) to disturb frames and serial line.
    #[arg(long, value_name = "FILE", conflicts_with = "drive")]
    pub faults: Option<PathBuf>,
    /// File in which every sent frame is listed with a checksum of its pixels.
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,
    /// Take this many shots with this program's own drivers instead of waiting for a daemon, and
    /// print the speed as JSON.
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
pub use served::sim_bench;
