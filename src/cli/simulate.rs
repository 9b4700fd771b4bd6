//! `lfpiv simulate`: image pairs of a known flow, and images for calibration (white, dark, and of a
//! card), each with the true values.

mod card;
mod references;

use std::{
    fs,
    io::{self, Write},
    path::{Path, PathBuf},
};

use anyhow::{Context, bail};
use lfpiv_core::lightfield::ImagePair;
use lfpiv_sim::{Scene, Truth};

use super::{
    card_file::read_card,
    output::{count, print, progress_bar},
};
use crate::{
    archive::{FileDepth, write_pair, write_replacing},
    config::{ConfigFile, Purpose},
};

/// Arguments of `lfpiv simulate`.
#[derive(Debug, clap::Args)]
pub struct SimulateArgs {
    /// Configuration file (TOML) with a [simulation] table.
    #[arg(long, value_name = "FILE")]
    pub config: PathBuf,
    /// Folder for the pair folders shot_0000, shot_0001, ...
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Number of shots.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub shots: u64,
    /// White images of each camera, of a diffuser that fills its pupil: white/camK_NN.tif, with the
    /// true grid in white/camK_grid_true.json.
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub white: u64,
    /// Dark images of each camera: dark/camK_NN.tif.
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub dark: u64,
    /// Images of a calibration card at its positions: card/pNN_camK.tif. card/card.toml names them
    /// and the white and dark images. FILE describes the card and its positions (config/card.toml).
    #[arg(long, value_name = "FILE")]
    pub card: Option<PathBuf>,
    /// Seed of the random numbers; default: that of the configuration.
    #[arg(long, value_name = "S")]
    pub seed: Option<u64>,
}

/// Writes pair folders with 8- or 16-bit images, depending on the sensor, each with `truth.json`:
/// particle positions at both pulses in mm, their brightness, the flow and dt. Also writes the
/// requested white, dark and card images.
pub fn simulate(args: &SimulateArgs) -> anyhow::Result<()> {
    let file = ConfigFile::load_for(Purpose::Optics, &args.config)?;
    let Some(scene) = &file.config.simulation else {
        bail!(
            "{} has no [simulation] table: add one; config/sim.toml is an example",
            args.config.display()
        );
    };
    let card = args.card.as_deref().map(read_card).transpose()?;
    let folders = new_folders(args)?;
    let bench = file.config.bench_geometry();
    scene.check(&bench)?;
    let seed = args.seed.unwrap_or(scene.seed);
    fs::create_dir_all(&args.out)
        .with_context(|| format!("cannot create {}", args.out.display()))?;
    write_replacing(&args.out.join("configuration.toml"), |writer| {
        writer.write_all(file.text.as_bytes())
    })?;
    let bar = progress_bar(folders.len(), "shots");
    for (shot, folder) in (0..).zip(&folders) {
        let simulated = scene.shot(&bench, seed, shot);
        let pair = ImagePair { cameras: simulated.images };
        write_pair(folder, &pair, depth_of(scene))?;
        write_truth(&folder.join("truth.json"), &simulated.truth)?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    let references = [args.white, args.dark];
    references::write(scene, &bench, seed, &args.out, references)?;
    if let Some(card) = &card {
        card::write(scene, &bench, seed, &args.out, card, references)?;
    }
    print(&format!("{} with seed {seed} in {}", written(args), args.out.display()))
}

/// "3 shots", or "3 shots, 5 white images and 1 dark image of each camera, a card".
fn written(args: &SimulateArgs) -> String {
    let shots = count(args.shots as usize, "shot");
    let [white, dark] = [(args.white, "white image"), (args.dark, "dark image")]
        .map(|(images, what)| (images > 0).then(|| count(images as usize, what)));
    let images = match (white, dark) {
        (None, None) => shots,
        (Some(one), None) | (None, Some(one)) => format!("{shots}, {one} of each camera"),
        (Some(white), Some(dark)) => format!("{shots}, {white} and {dark} of each camera"),
    };
    if args.card.is_some() { format!("{images}, a card") } else { images }
}

/// The shots' folders. Fails if one of them, or the folder of other requested images, exists, so
/// that no image is overwritten.
fn new_folders(args: &SimulateArgs) -> anyhow::Result<Vec<PathBuf>> {
    let folders: Vec<PathBuf> =
        (0..args.shots).map(|shot| args.out.join(format!("shot_{shot:04}"))).collect();
    let [white, dark] = references::folders(&args.out);
    let card = card::folder(&args.out);
    let cards = u64::from(args.card.is_some());
    let references = [(args.white, &white), (args.dark, &dark), (cards, &card)];
    let references = references.iter().filter(|(images, _)| *images > 0).map(|(_, folder)| *folder);
    if let Some(existing) = folders.iter().chain(references).find(|folder| folder.exists()) {
        bail!("{} exists already: choose another --out or remove it", existing.display());
    }
    Ok(folders)
}

fn depth_of(scene: &Scene) -> FileDepth {
    FileDepth::for_sensor_bits(scene.sensor.bits)
}

fn write_truth(path: &Path, truth: &Truth) -> anyhow::Result<()> {
    write_replacing(path, |writer| serde_json::to_writer(writer, truth).map_err(io::Error::from))?;
    Ok(())
}
