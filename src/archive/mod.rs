//! Files on disk: image pairs as input, results as output.
//!
//! - [`read_pair`], [`find_pair_folders`], [`write_pair`]: folders of grey TIFF images
//!   (`cam1_a.tif cam1_b.tif cam2_a.tif cam2_b.tif`).
//! - [`ResultStore`]: stores the results of a run shot by shot (NetCDF segments, ParaView files);
//!   [`merge_segments`] merges segments into few files.
//! - [`RunResults`]: reads results of a finished run as they were measured, with their particles.
//! - [`StoredShots`]: reads the vectors of a run shot by shot; [`write_csv`], [`write_tecplot`],
//!   [`Hdf5File`] write them in the formats of other programs.
//! - [`write_velocity`], [`write_particles`], [`write_volumes`]: write the files of one processed pair; [`read_volumes`]
//!   reads volumes, which may come from other programs.
//! - [`sha256`], [`stated_and_true_hash`]: JSON files that contain their own hash.
//!
//! NetCDF files get their final name only when they are complete. They are built in memory, because
//! the library does not survive a failed write, then written as `NAME.part`, fsynced and renamed. A
//! `.part` file is left only by a killed process.

mod durable;
mod error;
mod exported;
mod fit_variables;
mod grey_tiff;
mod json_hash;
mod merge;
mod netcdf_file;
mod netcdf_open;
mod pair_folder;
mod pair_results;
mod paraview;
mod particle_file;
mod run_results;
mod shot_result;
mod shot_time;
mod statistics_file;
mod store;
mod stored;
mod stored_particles;
mod stored_record;
mod stored_shots;
#[cfg(test)]
mod test_data;
mod velocity_file;
mod volume_file;

pub use durable::replace as write_replacing;
pub use error::ArchiveError;
pub use exported::{Hdf5File, write_csv, write_tecplot};
pub use grey_tiff::{
    FileDepth, ImageSize, read_grey_tiff, read_grey_tiff_of_any_size, write_grey_tiff,
};
pub use json_hash::{sha256, stated_and_true_hash};
pub use merge::merge_segments;
pub use pair_folder::{find_pair_folders, image_names, read_pair, write_pair};
pub use paraview::{FileSeries, VtiSource, write_vti, write_vtp};
pub use particle_file::write_particles;
pub use run_results::RunResults;
pub use shot_result::{RawLevel, ShotResult};
pub use shot_time::ShotTime;
pub use statistics_file::write_statistics;
pub use store::ResultStore;
pub use stored::{SealedFile, StoredResults, stored_configuration, stored_vectors};
pub use stored_particles::stored_particles;
pub use stored_shots::{StoredShot, StoredShots};
pub use velocity_file::write_velocity;
pub use volume_file::{read_volumes, write_volumes};
