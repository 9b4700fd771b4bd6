//! The reconstructed volumes of one pair as NetCDF-4/CF.

use std::path::Path;

use super::{
    ArchiveError,
    netcdf_file::{Described, NetCdfFile},
};
use crate::reconstruction::DenseVolume;

const NAMES: [Described; 2] = [
    Described { name: "a", units: "1", long_name: "light intensity per voxel, frame a" },
    Described { name: "b", units: "1", long_name: "light intensity per voxel, frame b" },
];

/// Writes frames a and b as variables `a` and `b` over `z, y, x` with coordinates in mm.
///
/// Compressed losslessly: most voxels are empty. Both frames must share their grid.
pub fn write_volumes(
    path: &Path,
    configuration: &str,
    volumes: &[DenseVolume; 2],
) -> Result<(), ArchiveError> {
    let grid = &volumes[0].grid;
    let axes_mm = [0, 1, 2]
        .map(|axis| (0..grid.voxels[axis]).map(|i| grid.coordinate_mm(axis, i as f64)).collect());
    let mut file = NetCdfFile::create(path, "Reconstructed volumes", configuration)?;
    file.add_axes(axes_mm)?;
    for (described, volume) in NAMES.iter().zip(volumes) {
        file.add::<f32>(described, &["z", "y", "x"])?;
        file.compress(described.name)?;
        file.put(described.name, &volume.intensity)?;
    }
    file.seal().map(|_| ())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::VolumeGrid;

    #[test]
    fn frames_keep_their_voxels() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("volumes.nc");
        let grid = VolumeGrid { voxels: [4, 3, 2], voxel_mm: 0.1, centre_mm: [1.0, 0.0, 0.0] };
        let volumes = [1.0, -1.0].map(|sign| DenseVolume {
            grid: grid.clone(),
            intensity: (0..24).map(|i| sign * i as f32).collect(),
        });
        write_volumes(&path, "", &volumes).unwrap();
        let file = netcdf::open(&path).unwrap();
        for (name, volume) in ["a", "b"].into_iter().zip(&volumes) {
            let variable = file.variable(name).unwrap();
            assert_eq!(variable.get_values::<f32, _>(..).unwrap(), volume.intensity);
            let at = variable.get_value::<f32, _>([1, 2, 3]).unwrap();
            assert_eq!(at, volume.intensity[grid.linear([3, 2, 1])]);
        }
        let x_mm = file.variable("x").unwrap().get_values::<f64, _>(..).unwrap();
        assert!((x_mm[0] - 0.85).abs() < 1e-12);
    }
}
