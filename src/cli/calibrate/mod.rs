//! `lfpiv calibrate`: calibrates cameras from images.

mod focus;
mod grid;
mod grid_file;
mod live;
mod overlay;
mod page;
mod reference_images;
mod volume;
mod volume_file;
mod volume_page;

use clap::Subcommand;

pub use focus::FocusArgs;
pub use grid::GridArgs;
pub use volume::VolumeArgs;

/// Arguments of `lfpiv calibrate`.
#[derive(Debug, clap::Args)]
pub struct CalibrateArgs {
    #[command(subcommand)]
    what: What,
}

#[derive(Debug, Subcommand)]
enum What {
    /// Find the micro-images of one camera in its white images.
    Grid(GridArgs),
    /// Find the plane in focus, and check whether f-numbers match.
    Focus(FocusArgs),
    /// Calibrate the cameras in the volume from images of a card.
    Volume(VolumeArgs),
}

/// Runs the chosen calibration.
pub fn calibrate(args: &CalibrateArgs) -> anyhow::Result<()> {
    match &args.what {
        What::Grid(args) => grid::grid(args),
        What::Focus(args) => focus::focus(args),
        What::Volume(args) => volume::volume(args),
    }
}
