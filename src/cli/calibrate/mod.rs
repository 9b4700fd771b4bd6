//! `lfpiv calibrate`: what a camera is, from images made for it.

mod grid;
mod grid_file;
mod overlay;
mod page;
mod reference_images;

use clap::Subcommand;

pub use grid::GridArgs;

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
}

/// Does what the command line asks for.
pub fn calibrate(args: &CalibrateArgs) -> anyhow::Result<()> {
    match &args.what {
        What::Grid(args) => grid::grid(args),
    }
}
