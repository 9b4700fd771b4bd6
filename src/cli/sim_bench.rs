//! `lfpiv sim-bench`: simulated instruments at the ends of real wires, for a daemon that knows
//! nothing of it.

#[cfg(feature = "aravis")]
mod sent_record;
#[cfg(feature = "aravis")]
mod served;

use std::{num::NonZeroU64, path::PathBuf};

/// Arguments of `lfpiv sim-bench`.
#[derive(Debug, clap::Args)]
pub struct SimBenchArgs {
    /// Configuration file (TOML) with the table [wire], and [simulation] for the pictures.
    #[arg(long, value_name = "FILE")]
    pub config: PathBuf,
    /// Show the frames of this recorded run instead of a simulated scene: trigger n shows those of
    /// trigger n, and what was lost then is lost again. Triggers beyond the record, and light that
    /// is not that of the record, give dark images.
    #[arg(long, value_name = "RUN", conflicts_with = "drive")]
    pub replay: Option<PathBuf>,
    /// Images that the cameras show while they run freely, one of each, in their order: 8- or 16-bit grey
    /// TIFF. Without them such frames are dark.
    #[arg(long, value_name = "FILE", num_args = 1.., conflicts_with = "drive")]
    pub show: Vec<PathBuf>,
    /// Disturb frames and serial line: a file of fault settings (TOML).
    #[arg(long, value_name = "FILE", conflicts_with = "drive")]
    pub faults: Option<PathBuf>,
    /// List every frame that is sent in this file, with a checksum of its pixels.
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,
    /// Do not wait for a daemon: take so many shots with this program's own drivers, and print how
    /// fast they came, as JSON.
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
