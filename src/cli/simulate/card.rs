//! Writes images of a calibration card at its positions, and the card file.

use std::{
    fs,
    io::Write,
    path::{Path, PathBuf},
};

use anyhow::{Context, bail};
use lfpiv_hw::{
    CameraName,
    card::{CalibrationCard, ReferenceImages},
};
use lfpiv_sim::{BenchGeometry, Scene};

use super::references::image_name;
use crate::{
    archive::{FileDepth, write_grey_tiff, write_replacing},
    cli::output::progress_bar,
};

/// The folder of the card's images in `out`.
pub(super) fn folder(out: &Path) -> PathBuf {
    out.join("card")
}

/// Writes `card/pNN_camK.tif` and `card/card.toml` in `out`. The latter is the given card file with
/// the names of these images and of the `white` and `dark` images.
pub(super) fn write(
    scene: &Scene,
    bench: &BenchGeometry,
    seed: u64,
    out: &Path,
    card: &CalibrationCard,
    [white, dark]: [u64; 2],
) -> anyhow::Result<()> {
    let folder = folder(out);
    fs::create_dir_all(&folder).with_context(|| format!("cannot create {}", folder.display()))?;
    let depth = FileDepth::for_sensor_bits(scene.sensor.bits);
    let cameras = bench.poses.len();
    let mut written = card.clone();
    let bar = progress_bar(card.position.len() * cameras, "card images");
    for (position, place) in written.position.iter_mut().enumerate() {
        place.images.clear();
        for camera in 0..cameras {
            let Some(image) = scene.card_image(bench, camera, card, position, seed) else {
                bail!(
                    "the card at position {} touches the wall in front of {} or its lens: move it, \
                     or use a smaller card",
                    position + 1,
                    CameraName(camera)
                );
            };
            let name = format!("p{:02}_{}.tif", position + 1, CameraName(camera));
            write_grey_tiff(&folder.join(&name), &image, depth)?;
            place.images.push(name);
            bar.inc(1);
        }
    }
    bar.finish_and_clear();
    let names = |kind: &str, camera: usize, count: u64| {
        (0..count).map(|n| format!("../{kind}/{}", image_name(camera, n))).collect()
    };
    let reference = |camera| ReferenceImages {
        white: names("white", camera, white),
        dark: names("dark", camera, dark),
    };
    written.reference = if white > 0 { (0..cameras).map(reference).collect() } else { Vec::new() };
    let text = toml::to_string(&written).context("the card cannot be written as TOML")?;
    write_replacing(&folder.join("card.toml"), |writer| writer.write_all(text.as_bytes()))?;
    Ok(())
}
