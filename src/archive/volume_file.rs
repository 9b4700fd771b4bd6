//! The volumes of one pair as NetCDF-4/CF: reconstructed here, or by another program.

use std::path::Path;

use super::{
    ArchiveError,
    netcdf_file::{Described, NetCdfFile},
};
use crate::{model::VolumeGrid, reconstruction::DenseVolume};

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

/// Reads frames a and b on `grid` from variables `a` and `b` over `z, y, x`; coordinates in mm, where
/// the file has them, must be the grid's.
///
/// # Errors
/// [`ArchiveError::UnreadableVolumes`]: no such file or variables, other voxels than the grid's, or
/// light that is negative or no number.
pub fn read_volumes(path: &Path, grid: &VolumeGrid) -> Result<[DenseVolume; 2], ArchiveError> {
    let wrong = |reason: String| ArchiveError::UnreadableVolumes { path: path.into(), reason };
    let file = netcdf::open(path).map_err(|reason| wrong(reason.to_string()))?;
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let Some(coordinates) = file.variable(name) else { continue };
        let found_mm: Vec<f64> =
            coordinates.get_values(..).map_err(|reason| wrong(reason.to_string()))?;
        let own_mm = (0..grid.voxels[axis]).map(|i| grid.coordinate_mm(axis, i as f64));
        let near = |(own, found): (f64, &f64)| (own - found).abs() < 0.01 * grid.voxel_mm;
        if found_mm.len() != grid.voxels[axis] || !own_mm.zip(&found_mm).all(near) {
            return Err(wrong(format!("its voxels along {name} are not the configured ones")));
        }
    }
    let frame = |name: &str| {
        let variable = file.variable(name).ok_or_else(|| wrong(format!("it has no {name}")))?;
        let found: Vec<usize> = variable.dimensions().iter().map(|d| d.len()).collect();
        let [nx, ny, nz] = grid.voxels;
        if found != [nz, ny, nx] {
            return Err(wrong(format!("{name} has {found:?} voxels, not {:?}", [nz, ny, nx])));
        }
        let intensity: Vec<f32> =
            variable.get_values(..).map_err(|reason| wrong(reason.to_string()))?;
        match intensity.iter().position(|light| !light.is_finite() || *light < 0.0) {
            Some(n) => Err(wrong(format!("{name} is {} in voxel {n}", intensity[n]))),
            None => Ok(DenseVolume { grid: grid.clone(), intensity }),
        }
    };
    Ok([frame("a")?, frame("b")?])
}

#[cfg(test)]
mod tests {
    use super::*;

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

    #[test]
    fn volumes_read_back_on_their_own_voxels_only() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("volumes.nc");
        let grid = VolumeGrid { voxels: [4, 3, 2], voxel_mm: 0.1, centre_mm: [1.0, 0.0, 0.0] };
        let volume =
            |light: f32| DenseVolume { grid: grid.clone(), intensity: vec![light; grid.len()] };
        let volumes = [volume(1.0), volume(2.0)];
        write_volumes(&path, "", &volumes).unwrap();
        assert_eq!(read_volumes(&path, &grid).unwrap(), volumes);
        let says = |path: &Path, grid: &VolumeGrid, what: &str| {
            let error = read_volumes(path, grid).unwrap_err().to_string();
            assert!(error.contains(what), "{error}");
        };
        let moved = VolumeGrid { centre_mm: [1.1, 0.0, 0.0], ..grid.clone() };
        says(&path, &moved, "along x are not the configured ones");
        let longer = VolumeGrid { voxels: [4, 3, 3], ..grid.clone() };
        says(&path, &longer, "along z are not the configured ones");
        says(&folder.path().join("none.nc"), &grid, "cannot take volumes from");
        for bad in [-1.0, f32::NAN] {
            write_volumes(&path, "", &[volume(1.0), volume(bad)]).unwrap();
            says(&path, &grid, "b is ");
        }
    }
}
