//! The mask of the volume: read from the regions and the files that `[volume.mask]` names, and kept in the
//! configuration's text.
//!
//! A run stores its configuration with the mask as it was, voxel by voxel: it can be measured again and looked
//! at without the files, and two runs whose files differ have configurations that differ.

use std::{
    path::{Path, PathBuf},
    sync::Arc,
};

use lfpiv_core::model::{ClosedSurface, FlowRegions, Region, VolumeGrid, VolumeMask};
use lfpiv_rawlog::regular_file::read_regular;
use serde::{Deserialize, Serialize};

use super::{
    VolumeTable,
    consistency::Inconsistency,
    stl,
    volume::{MaskTable, RegionTable},
};
use crate::archive::sha256;

/// Largest STL file that is read: 1.3 million triangles in the binary format.
const MOST_BYTES: u64 = 64 << 20;

/// The `[mask]` table of a stored configuration: which voxels are flow, and the files that say so. It is
/// written by the program, not by hand.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "MaskText", into = "MaskText")]
pub struct StoredMask {
    /// The voxels.
    pub mask: Arc<VolumeMask>,
    /// The files of bodies.
    pub files: Vec<MaskFile>,
    /// The regions themselves, where they have just been read.
    regions: Option<Arc<FlowRegions>>,
}

/// A file that a mask was made from.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MaskFile {
    /// As the configuration names it.
    pub file: PathBuf,
    /// The file's SHA-256 hash.
    pub sha256: String,
    /// How many triangles its surface has.
    pub triangles: usize,
}

/// A mask as it is written.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct MaskText {
    voxels: [usize; 3],
    voxel_mm: f64,
    centre_mm: [f64; 3],
    /// Every voxel in the order z, y, x, compared with the one below it along z, and those of the lowest layer
    /// with flow: how many are alike, how many differ, how many are alike, and so on.
    alike_and_different: String,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    file: Vec<MaskFile>,
}

impl StoredMask {
    /// Whether a place (mm) is in the flow: as the regions have it where they are known, otherwise as the voxels
    /// have it.
    pub fn is_flow(&self, at_mm: [f64; 3]) -> bool {
        match &self.regions {
            Some(regions) => regions.is_flow(at_mm),
            None => self.mask.is_flow(at_mm),
        }
    }
}

impl From<StoredMask> for MaskText {
    fn from(StoredMask { mask, files, .. }: StoredMask) -> Self {
        let VolumeGrid { voxels, voxel_mm, centre_mm } = mask.grid;
        let alike_and_different = run_lengths(&compared(&mask.flow, layer(voxels)));
        Self { voxels, voxel_mm, centre_mm, alike_and_different, file: files }
    }
}

impl TryFrom<MaskText> for StoredMask {
    type Error = String;

    fn try_from(text: MaskText) -> Result<Self, String> {
        let MaskText { voxels, voxel_mm, centre_mm, alike_and_different, file: files } = text;
        let count = voxels.iter().try_fold(1usize, |all, &n| all.checked_mul(n));
        let differs = count.and_then(|count| from_run_lengths(&alike_and_different, count));
        let Some(differs) = differs else {
            return Err(
                "the runs of alike_and_different are not those of the mask's voxels; this \
                        table is written by the program: use it as it was"
                    .into(),
            );
        };
        let flow = followed(differs, layer(voxels));
        let grid = VolumeGrid { voxels, voxel_mm, centre_mm };
        Ok(Self { mask: Arc::new(VolumeMask { grid, flow }), files, regions: None })
    }
}

fn layer(voxels: [usize; 3]) -> usize {
    voxels[0] * voxels[1]
}

/// Whether each voxel differs from the one `layer` before it, or is not flow where there is none.
fn compared(flow: &[bool], layer: usize) -> Vec<bool> {
    let below = |n: usize| n.checked_sub(layer).is_none_or(|below| flow[below]);
    flow.iter().enumerate().map(|(n, flow)| *flow != below(n)).collect()
}

/// The inverse of [`compared`].
fn followed(mut differs: Vec<bool>, layer: usize) -> Vec<bool> {
    for n in 0..differs.len() {
        let below = n.checked_sub(layer).is_none_or(|below| differs[below]);
        differs[n] = differs[n] != below;
    }
    differs
}

/// How many values are `false`, then `true`, then `false`, and so on.
fn run_lengths(values: &[bool]) -> String {
    let mut lengths: Vec<String> = Vec::new();
    let (mut rest, mut wanted) = (values, false);
    while !rest.is_empty() {
        let length = rest.iter().take_while(|value| **value == wanted).count();
        lengths.push(length.to_string());
        (rest, wanted) = (&rest[length..], !wanted);
    }
    lengths.join(" ")
}

/// `count` values from [`run_lengths`]; `None` if they are more or fewer.
fn from_run_lengths(text: &str, count: usize) -> Option<Vec<bool>> {
    let (mut values, mut value) = (Vec::new(), false);
    for length in text.split_whitespace() {
        let length: usize = length.parse().ok()?;
        if length > count - values.len() {
            return None;
        }
        values.resize(values.len() + length, value);
        value = !value;
    }
    (values.len() == count).then_some(values)
}

/// The mask must be that of the volume.
pub(super) fn fits(volume: &VolumeTable) -> impl FnOnce(&Option<StoredMask>, &()) -> garde::Result {
    move |stored, _| match stored {
        Some(stored) if stored.mask.grid != volume.grid() => Err(garde::Error::new(
            "this mask was made for another [volume]: remove the table, so that it is made again \
             from [volume.mask]",
        )),
        _ => Ok(()),
    }
}

/// The mask of the volume, with the files of its bodies read relative to `folder`. Nothing without a
/// `[volume.mask]`.
pub(super) fn load(
    volume: &VolumeTable,
    folder: &Path,
) -> Result<Option<StoredMask>, Vec<Inconsistency>> {
    let Some(MaskTable { keep, leave_out }) = &volume.mask else { return Ok(None) };
    let mut files = Vec::new();
    let mut problems = Vec::new();
    let mut read = |list: &str, tables: &[RegionTable]| -> Vec<Region> {
        let numbered = tables.iter().enumerate();
        numbered
            .filter_map(|(n, table)| {
                let problem = |message| {
                    let key = if table.stl.is_some() { ".stl" } else { "" };
                    Inconsistency::new(format!("volume.mask.{list}[{n}]{key}"), message)
                };
                let region = region(table, folder, &mut files);
                let region = region.and_then(|region| covers(&region, volume).map(|()| region));
                region.map_err(|message| problems.push(problem(message))).ok()
            })
            .collect()
    };
    let regions = FlowRegions { keep: read("keep", keep), leave_out: read("leave_out", leave_out) };
    if !problems.is_empty() {
        return Err(problems);
    }
    let mask = regions.mask(&volume.grid());
    if !mask.flow.contains(&true) {
        let message = "it leaves nothing: no voxel of the volume is flow; allowed: regions that \
                       leave some (is a body turned into the flow around it, or a box too large?)";
        return Err(vec![Inconsistency::new("volume.mask", message.into())]);
    }
    Ok(Some(StoredMask { mask: Arc::new(mask), files, regions: Some(Arc::new(regions)) }))
}

fn region(table: &RegionTable, folder: &Path, files: &mut Vec<MaskFile>) -> Result<Region, String> {
    if let (Some(low_mm), Some(high_mm)) = (table.low_mm, table.high_mm) {
        return Ok(Region::Cuboid { low_mm, high_mm });
    }
    let file = table.stl.clone().unwrap_or_default();
    let bytes = read_regular(&folder.join(&file), MOST_BYTES)
        .map_err(|error| format!("it cannot be read: {error}"))?;
    let surface =
        ClosedSurface::new(&stl::triangles(&bytes)?).map_err(|error| error.to_string())?;
    files.push(MaskFile { file, sha256: sha256(&bytes), triangles: surface.len() });
    Ok(Region::Body(Arc::new(surface)))
}

/// A region must contain the centre of a voxel.
fn covers(region: &Region, volume: &VolumeTable) -> Result<(), String> {
    let ([low, high], [volume_low, volume_high]) = (region.bounds_mm(), volume.bounds_mm());
    let range = |low: [f64; 3], high: [f64; 3]| {
        let along = |axis: usize| {
            format!("{} {:.2} to {:.2}", ["x", "y", "z"][axis], low[axis], high[axis])
        };
        [0, 1, 2].map(along).join(", ")
    };
    if (0..3).any(|axis| high[axis] < volume_low[axis] || low[axis] > volume_high[axis]) {
        return Err(format!(
            "it lies outside the volume: it reaches over {} mm, and the volume over {} mm; \
             positions are in mm, in the coordinates of the volume",
            range(low, high),
            range(volume_low, volume_high)
        ));
    }
    if !region.voxels_inside(&volume.grid()).contains(&true) {
        return Err(format!(
            "it contains the centre of no voxel, over {} mm; allowed: regions thicker than \
             a voxel, {} mm",
            range(low, high),
            volume.voxel_mm
        ));
    }
    Ok(())
}

/// The text that is appended to the configuration's text before it is stored.
pub(super) fn stored_text(mask: &StoredMask) -> Result<String, toml::ser::Error> {
    #[derive(Serialize)]
    struct Table<'a> {
        mask: &'a StoredMask,
    }
    let table = toml::to_string(&Table { mask })?;
    Ok(format!("\n# The voxels that [volume.mask] leaves as flow:\n{table}"))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn stored(flow: Vec<bool>, voxels: [usize; 3]) -> StoredMask {
        let grid = VolumeGrid { voxels, voxel_mm: 0.1, centre_mm: [0.5, 0.0, -0.25] };
        let files = vec![MaskFile { file: "a.stl".into(), sha256: "00".into(), triangles: 12 }];
        StoredMask { mask: Arc::new(VolumeMask { grid, flow }), files, regions: None }
    }

    proptest! {
        #[test]
        fn a_mask_is_read_as_it_was_written(flow in prop::collection::vec(any::<bool>(), 60)) {
            let mask = stored(flow, [5, 4, 3]);
            let text = stored_text(&mask).unwrap();
            let mut table: toml::Table = text.parse().unwrap();
            prop_assert_eq!(table.remove("mask").unwrap().try_into::<StoredMask>().unwrap(), mask);
        }
    }

    #[test]
    fn a_body_along_z_takes_the_room_of_one_layer() {
        let voxels = [50, 40, 60];
        let inside = |n: usize| {
            let [x, y] = [n % 50, n / 50 % 40].map(|n| n as f64);
            (x - 25.0).hypot(y - 20.0) < 8.0
        };
        let mask = stored((0..120_000).map(|n| !inside(n)).collect(), voxels);
        let text = stored_text(&mask).unwrap();
        assert!(text.len() < 500, "{} bytes", text.len());
    }

    #[test]
    fn a_mask_that_was_changed_by_hand_is_refused() {
        for text in ["60 1", "59", "3 x 2", "", "18446744073709551615 60", "-1 61"] {
            assert_eq!(from_run_lengths(text, 60), None, "{text}");
        }
        assert_eq!(from_run_lengths("0 2 1", 3), Some(vec![true, true, false]));
    }
}
