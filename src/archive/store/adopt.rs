//! Results that were made elsewhere, taken into a run's folder.

use std::{
    fs::{self, File},
    io::copy,
    path::{Path, PathBuf},
};

use super::{ArchiveError, ResultStore, vti_name};
use crate::archive::{
    durable::{part_path, replace, seal},
    particle_file::particles_beside,
    stored::{StoredResults, segments, shots_in},
};

impl ResultStore {
    /// Copies the sealed results in `folders` into this run's folder, with their particles and files for ParaView. These
    /// must be results of this run, by its forward model. What is here already, after a copy that was cut
    /// off, is not copied again. The lowest shot counts as the first stored.
    ///
    /// # Errors
    /// A file cannot be read or written; what was copied before is whole.
    pub fn adopt(&mut self, folders: &[PathBuf]) -> Result<(), ArchiveError> {
        let here = StoredResults::find(&self.folder)?.shots;
        let mut sealed: Vec<(u64, PathBuf)> = Vec::new();
        for folder in folders {
            for path in segments(folder, ".nc")? {
                let shots = shots_in(&path)?;
                if let Some(lowest) =
                    shots.iter().min().filter(|_| !shots.iter().all(|shot| here.contains(shot)))
                {
                    sealed.push((*lowest, path));
                }
            }
        }
        // The oldest file names the shot that was stored first.
        sealed.sort();
        for (lowest, path) in &sealed {
            let to = self.unused_name(*lowest);
            let particles = particles_beside(path);
            if particles.exists() {
                copy_sealed(&particles, &particles_beside(&to))?;
            }
            copy_sealed(path, &to)?;
        }
        folders.iter().try_for_each(|folder| self.adopt_for_paraview(folder))?;
        self.write_series()
    }

    fn adopt_for_paraview(&mut self, folder: &Path) -> Result<(), ArchiveError> {
        let Some(series) = &mut self.series else { return Ok(()) };
        let stored = StoredResults::find(folder)?;
        for shot in &stored.shots {
            let name = vti_name(*shot);
            copy_file(&folder.join(&name), &self.folder.join(&name))?;
            series.push(*shot, stored.times_s.get(shot).copied());
        }
        Ok(())
    }
}

/// Copies a file so that it survives a power cut once it is there.
fn copy_sealed(from: &Path, to: &Path) -> Result<(), ArchiveError> {
    fs::copy(from, part_path(to)).map_err(ArchiveError::unwritten(to, None))?;
    seal(to)
}

/// Copies a file that can be made again; it appears whole.
fn copy_file(from: &Path, to: &Path) -> Result<(), ArchiveError> {
    let mut source = File::open(from).map_err(ArchiveError::io("open", from))?;
    replace(to, |writer| copy(&mut source, writer).map(|_| ()))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::archive::{RunResults, merge_segments, stored_vectors, test_data::with_particles};

    fn folder_with(root: &Path, name: &str, shots: &[u64]) -> PathBuf {
        let folder = root.join(name);
        let mut store = ResultStore::create(&folder, "").unwrap();
        for shot in shots {
            store.append(*shot, &with_particles(*shot, 2)).unwrap();
        }
        store.close().unwrap();
        folder
    }

    #[test]
    fn results_of_folders_become_those_of_one_run() {
        let root = tempfile::tempdir().unwrap();
        // Made in another order than that of their shots.
        let parts = [&[1, 4][..], &[0, 3], &[2]]
            .map(|shots| folder_with(root.path(), &format!("part{}", shots[0]), shots));
        let whole = folder_with(root.path(), "whole", &[0, 1, 2, 3, 4]);
        let run = folder_with(root.path(), "run", &[]);
        // The second time is that after a copy that was cut off.
        for _ in 0..2 {
            let (mut store, _) = ResultStore::reopen(&run, "").unwrap();
            store.adopt(&parts).unwrap();
            store.close().unwrap();
        }
        merge_segments(&run, || true).unwrap();
        let [whole_stored, stored] =
            [&whole, &run].map(|folder| StoredResults::find(folder).unwrap());
        assert_eq!(stored, whole_stored);
        assert_eq!(stored.first, Some(0));
        assert_eq!(stored_vectors(&run).unwrap(), stored_vectors(&whole).unwrap());
        let particles = |folder: &Path, shot| {
            let results = RunResults::find(folder, 0.1).unwrap();
            results.read(shot).unwrap().unwrap().measured.particles
        };
        for shot in 0..5 {
            assert_eq!(particles(&run, shot), particles(&whole, shot));
            assert_eq!(particles(&run, shot).unwrap().len(), 2);
        }
        let names = |folder: &Path| -> BTreeSet<_> {
            std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name()).collect()
        };
        assert_eq!(names(&run), names(&whole));
        for name in names(&run).iter().filter(|name| !name.to_string_lossy().ends_with(".nc")) {
            let [a, b] = [&run, &whole].map(|folder| std::fs::read(folder.join(name)).unwrap());
            assert!(a == b, "{name:?}");
        }
    }
}
