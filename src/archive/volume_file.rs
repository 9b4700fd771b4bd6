//! Reads and writes the volumes of one pair as NetCDF-4/CF.

use std::path::Path;

use lfpiv_core::{model::VolumeGrid, reconstruction::DenseVolume};
use netcdf::{AttributeValue, Variable};

use super::{
    ArchiveError,
    netcdf_file::{Described, FILL_F32, NetCdfFile},
    netcdf_open::open,
};

const NAMES: [Described; 2] = [
    Described { name: "a", units: "1", long_name: "light intensity per voxel, frame a" },
    Described { name: "b", units: "1", long_name: "light intensity per voxel, frame b" },
];

/// Writes frames a and b as variables `a` and `b` over `z, y, x`, with coordinates in mm.
///
/// Compressed losslessly, because most voxels are empty. Both frames must have the same grid.
pub fn write_volumes(
    path: &Path,
    configuration: &str,
    volumes: &[DenseVolume; 2],
) -> Result<(), ArchiveError> {
    let grid = &volumes[0].grid;
    let axes_mm = [0, 1, 2]
        .map(|axis| (0..grid.voxels[axis]).map(|i| grid.coordinate_mm(axis, i as f64)).collect());
    // Upper bound: the size without compression.
    let bytes = (volumes.len() * grid.len() * size_of::<f32>() + (1 << 20)) as u64;
    let mut file = NetCdfFile::create(path, bytes, "Reconstructed volumes", configuration)?;
    file.add_axes(axes_mm)?;
    for (described, volume) in NAMES.iter().zip(volumes) {
        file.add::<f32>(described, &["z", "y", "x"])?;
        file.compress(described.name)?;
        file.put(described.name, &volume.intensity)?;
    }
    file.store()
}

/// Reads frames a and b from variables `a` and `b` over `z, y, x`. Coordinates in mm, if present,
/// must be those of `grid`.
///
/// A foreign file may crash the HDF5 library: read it in a separate process.
///
/// # Errors
/// [`ArchiveError::UnreadableVolumes`]: the file or a variable is missing, dimensions or voxels
/// differ from the grid's, values are packed or missing, or light is negative or not finite.
pub fn read_volumes(path: &Path, grid: &VolumeGrid) -> Result<[DenseVolume; 2], ArchiveError> {
    read(path, grid).map_err(|reason| ArchiveError::UnreadableVolumes { path: path.into(), reason })
}

fn read(path: &Path, grid: &VolumeGrid) -> Result<[DenseVolume; 2], String> {
    let file = open(path).map_err(words)?;
    // Check all sizes before reading values: a file may claim any size.
    for name in FRAMES {
        check_shape(&variable(&file, name)?, grid)?;
    }
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        if let Some(coordinates) = file.variable(name) {
            check_axis(&coordinates, grid, axis)?;
        }
    }
    let [a, b] = FRAMES.map(|name| {
        let intensity = light(&variable(&file, name)?)?;
        Ok::<_, String>(DenseVolume { grid: grid.clone(), intensity })
    });
    Ok([a?, b?])
}

const FRAMES: [&str; 2] = ["a", "b"];

fn words(error: netcdf::Error) -> String {
    error.to_string()
}

fn variable<'f>(file: &'f netcdf::File, name: &str) -> Result<Variable<'f>, String> {
    file.variable(name).ok_or_else(|| format!("the file has no {name}"))
}

/// Checks that the frame is over z, y, x: in a cube other orders have the same size.
fn check_shape(frame: &Variable<'_>, grid: &VolumeGrid) -> Result<(), String> {
    let name = frame.name();
    let dimensions = frame.dimensions();
    let names: Vec<String> = dimensions.iter().map(|d| d.name()).collect();
    if names != ["z", "y", "x"] {
        return Err(format!("{name} is over ({}), not over (z, y, x)", names.join(", ")));
    }
    let found: Vec<usize> = dimensions.iter().map(|d| d.len()).collect();
    let [nx, ny, nz] = grid.voxels;
    if found != [nz, ny, nx] {
        return Err(format!("{name} has {found:?} voxels, not {:?}", [nz, ny, nx]));
    }
    for (attribute, neutral) in [("scale_factor", 1.0), ("add_offset", 0.0)] {
        let Some(packed) = frame.attribute(attribute) else { continue };
        if number_of(&packed.value().map_err(words)?) != Some(neutral) {
            return Err(format!("{name} is packed ({attribute}): store it unpacked"));
        }
    }
    Ok(())
}

fn number_of(value: &AttributeValue) -> Option<f64> {
    f64::try_from(value.clone()).ok()
}

/// Checks that coordinates are those of the grid's voxels.
fn check_axis(coordinates: &Variable<'_>, grid: &VolumeGrid, axis: usize) -> Result<(), String> {
    let name = coordinates.name();
    let other = || format!("the voxels along {name} are not the configured ones");
    let lengths: Vec<usize> = coordinates.dimensions().iter().map(|d| d.len()).collect();
    if lengths != [grid.voxels[axis]] {
        return Err(other());
    }
    let found_mm: Vec<f64> = coordinates.get_values(..).map_err(words)?;
    let own_mm = (0..grid.voxels[axis]).map(|i| grid.coordinate_mm(axis, i as f64));
    let near = |(own, found): (f64, &f64)| (own - found).abs() < 0.01 * grid.voxel_mm;
    if own_mm.zip(&found_mm).all(near) { Ok(()) } else { Err(other()) }
}

/// The light of a frame; fails if a value is missing.
fn light(frame: &Variable<'_>) -> Result<Vec<f32>, String> {
    let name = frame.name();
    let intensity: Vec<f32> = frame.get_values(..).map_err(words)?;
    let fills: Vec<f32> = ["_FillValue", "missing_value"]
        .iter()
        .filter_map(|attribute| number_of(&frame.attribute(attribute)?.value().ok()?))
        .map(|fill| fill as f32)
        .chain([FILL_F32])
        .collect();
    match intensity.iter().position(|light| fills.contains(light)) {
        Some(0) if intensity.iter().all(|light| fills.contains(light)) => {
            return Err(format!("{name} was never written: all its voxels are fill values"));
        }
        Some(voxel) => return Err(format!("{name} is missing (a fill value) in voxel {voxel}")),
        None => {}
    }
    match intensity.iter().position(|light| !light.is_finite() || *light < 0.0) {
        Some(n) => Err(format!("{name} is {} in voxel {n}", intensity[n])),
        None => Ok(intensity),
    }
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
    fn volumes_are_read_on_their_own_grid_only() {
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
        says(&path, &longer, "a has [2, 3, 4] voxels, not [3, 3, 4]");
        says(&folder.path().join("none.nc"), &grid, "cannot read volumes from");
        for bad in [-1.0, f32::NAN] {
            write_volumes(&path, "", &[volume(1.0), volume(bad)]).unwrap();
            says(&path, &grid, "b is ");
        }
    }

    /// A file with variables as other programs may write them.
    fn foreign(
        path: &Path,
        dimensions: [&str; 3],
        describe: impl Fn(&mut netcdf::VariableMut<'_>),
        values: Option<[f32; 8]>,
    ) {
        let mut file = netcdf::create(path).unwrap();
        for name in ["x", "y", "z"] {
            file.add_dimension(name, 2).unwrap();
        }
        for name in FRAMES {
            let mut frame = file.add_variable::<f32>(name, &dimensions).unwrap();
            describe(&mut frame);
            if let Some(values) = values {
                frame.put_values(&values, ..).unwrap();
            }
        }
        file.close().unwrap();
    }

    #[test]
    fn volumes_of_other_programs_are_read_correctly_or_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("volumes.nc");
        let grid = VolumeGrid { voxels: [2, 2, 2], voxel_mm: 0.1, centre_mm: [0.0; 3] };
        let (usual, light) = (["z", "y", "x"], Some([1.0; 8]));
        let says = |what: &str| {
            let error = read_volumes(&path, &grid).unwrap_err().to_string();
            assert!(error.contains(what), "{error}");
        };
        foreign(&path, usual, |_| {}, light);
        assert_eq!(read_volumes(&path, &grid).unwrap()[1].intensity, [1.0; 8]);
        foreign(&path, ["x", "y", "z"], |_| {}, light);
        says("a is over (x, y, z), not over (z, y, x)");
        let packed = |frame: &mut netcdf::VariableMut<'_>| {
            frame.put_attribute("scale_factor", 0.5).unwrap();
        };
        foreign(&path, usual, packed, light);
        says("a is packed (scale_factor)");
        foreign(&path, usual, |_| {}, None);
        says("a was never written");
        let missing = |frame: &mut netcdf::VariableMut<'_>| {
            frame.put_attribute("missing_value", 7.0f32).unwrap();
        };
        foreign(&path, usual, missing, Some([1.0, 1.0, 7.0, 1.0, 1.0, 1.0, 1.0, 1.0]));
        says("a is missing (a fill value) in voxel 2");
    }

    #[test]
    fn a_claimed_size_is_not_allocated() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("volumes.nc");
        let mut file = netcdf::create(&path).unwrap();
        file.add_dimension("x", 1 << 31).unwrap();
        file.add_variable::<f64>("x", &["x"]).unwrap();
        for (name, length) in [("y", 2), ("z", 2)] {
            file.add_dimension(name, length).unwrap();
        }
        for name in FRAMES {
            file.add_variable::<f32>(name, &["z", "y", "x"]).unwrap();
        }
        file.close().unwrap();
        let grid = VolumeGrid { voxels: [2, 2, 2], voxel_mm: 0.1, centre_mm: [0.0; 3] };
        let error = read_volumes(&path, &grid).unwrap_err().to_string();
        assert!(error.contains("a has [2, 2, 2147483648] voxels"), "{error}");
    }
}
