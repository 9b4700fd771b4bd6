//! The results of a run that is over, read back as they were measured.

use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
    sync::Arc,
};

use lfpiv_core::{
    model::ModelChoice,
    reconstruction::{CameraFit, FitVerdict, ModelFit},
    velocimetry::{PairResult, StageSeconds, VectorGrid, VectorStatus, VelocityField},
};

use super::{
    ArchiveError, RawLevel, ShotResult, ShotTime,
    netcdf_file::FILL_F64,
    netcdf_open::open,
    stored::{records_of, segments},
};

/// Where the results of a run are. A shot that is there twice, after a merge that was cut off, counts once.
#[derive(Debug, Clone, Default)]
pub struct RunResults {
    places: BTreeMap<u64, (PathBuf, usize)>,
    voxel_mm: f64,
}

impl RunResults {
    /// Looks through the folder of a run whose voxels have this edge. Only sealed segments count.
    ///
    /// # Errors
    /// The folder or a segment cannot be read.
    pub fn find(folder: &Path, voxel_mm: f64) -> Result<Self, ArchiveError> {
        let mut places = BTreeMap::new();
        for path in segments(folder, ".nc")? {
            for (record, shot) in records_of(&path)?.into_iter().enumerate() {
                let Ok(shot) = u64::try_from(shot) else { continue };
                places.entry(shot).or_insert_with(|| (path.clone(), record));
            }
        }
        Ok(Self { places, voxel_mm })
    }

    /// Number of shots with a result.
    pub fn len(&self) -> usize {
        self.places.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.places.is_empty()
    }

    /// Their numbers, in order.
    pub fn shots(&self) -> impl DoubleEndedIterator<Item = u64> {
        self.places.keys().copied()
    }

    /// The result of a shot; `None` where it has none. Warnings and the causes of a poor fit are not stored,
    /// and missing.
    ///
    /// # Errors
    /// Its segment cannot be read.
    pub fn read(&self, shot: u64) -> Result<Option<ShotResult>, ArchiveError> {
        let Some((path, record)) = self.places.get(&shot) else { return Ok(None) };
        let read = || Record { file: open(path)?, number: *record }.result(self.voxel_mm);
        read().map(Some).map_err(ArchiveError::unreadable_results(path))
    }
}

/// A record of a segment.
struct Record {
    file: netcdf::File,
    number: usize,
}

impl Record {
    fn result(&self, voxel_mm: f64) -> netcdf::Result<ShotResult> {
        let field = self.field(voxel_mm)?;
        let seconds =
            |name: &str| -> netcdf::Result<f64> { Ok(self.number_of(name)?.unwrap_or(0.0)) };
        let measured = PairResult {
            field,
            seconds: StageSeconds {
                decode_s: seconds("decode_seconds")?,
                reconstruct_s: seconds("reconstruct_seconds")?,
                correlate_s: seconds("correlate_seconds")?,
                judge_s: seconds("judge_seconds")?,
            },
            warnings: Vec::new(),
            model: Arc::new(self.model()?),
            fit: self.fit()?,
            light: None,
        };
        Ok(ShotResult { measured, time: self.time()?, raw: self.raw()? })
    }

    fn field(&self, voxel_mm: f64) -> netcdf::Result<VelocityField> {
        let dt_s = self.number_of("dt")?.ok_or_else(|| missing("dt"))?;
        let per_voxel = voxel_mm * 1e-3 / dt_s;
        let (valid, replaced) = (self.vectors("valid")?, self.vectors("replaced")?);
        let status = valid.iter().zip(&replaced).map(|flags| match flags {
            (1.0, _) => VectorStatus::Valid,
            (_, 1.0) => VectorStatus::Replaced,
            _ => VectorStatus::Invalid,
        });
        let divergence = self.vectors("divergence")?;
        let vorticity = self.triples(["vorticity_x", "vorticity_y", "vorticity_z"], dt_s)?;
        Ok(VelocityField {
            grid: self.grid()?,
            displacement_vox: self.triples(["u", "v", "w"], 1.0 / per_voxel)?,
            uncertainty_vox: self
                .triples(["u_uncertainty", "v_uncertainty", "w_uncertainty"], 1.0 / per_voxel)?,
            status: status.collect(),
            peak_ratio: self.vectors("peak_ratio")?,
            has_gradient: divergence.iter().map(|d| !d.is_nan()).collect(),
            vorticity,
            divergence: divergence.into_iter().map(|d| scaled(d, dt_s)).collect(),
            voxel_mm,
            dt_s,
        })
    }

    /// A number per vector.
    fn vectors(&self, name: &str) -> netcdf::Result<Vec<f32>> {
        let variable = self.file.variable(name).ok_or_else(|| missing(name))?;
        variable.get_values((self.number, .., .., ..))
    }

    /// Three numbers per vector, times a factor.
    fn triples(&self, names: [&str; 3], factor: f64) -> netcdf::Result<Vec<[f32; 3]>> {
        let [x, y, z] = names.map(|name| self.vectors(name));
        let (x, y, z) = (x?, y?, z?);
        let triples = x.into_iter().zip(y).zip(z);
        Ok(triples.map(|((x, y), z)| [x, y, z].map(|value| scaled(value, factor))).collect())
    }

    /// A number of the record, or, where it is the same for all of a segment, of that; `None` where it is not
    /// stored.
    fn number_of(&self, name: &str) -> netcdf::Result<Option<f64>> {
        let Some(variable) = self.file.variable(name) else { return Ok(None) };
        let numbers = variable.get_values::<f64, _>(..)?;
        Ok(numbers.get(if variable.dimensions().is_empty() { 0 } else { self.number }).copied())
    }

    fn grid(&self) -> netcdf::Result<VectorGrid> {
        let axis = |name: &str| -> netcdf::Result<Vec<f64>> {
            self.file.variable(name).ok_or_else(|| missing(name))?.get_values(..)
        };
        let axes = [axis("x")?, axis("y")?, axis("z")?];
        let spacing = axes.iter().find(|axis| axis.len() > 1).map(|axis| axis[1] - axis[0]);
        Ok(VectorGrid {
            vectors: axes.each_ref().map(Vec::len),
            first_mm: axes.each_ref().map(|axis| axis.first().copied().unwrap_or_default()),
            spacing_mm: spacing.unwrap_or(1.0),
        })
    }

    /// Early versions stored none, and what cannot be understood is none.
    fn model(&self) -> netcdf::Result<ModelChoice> {
        let Some(choice) = self.file.attribute("model_choice") else {
            return Ok(ModelChoice::default());
        };
        let text = String::try_from(choice.value()?)?;
        Ok(serde_json::from_str(&text).unwrap_or_default())
    }

    fn fit(&self) -> netcdf::Result<Option<ModelFit>> {
        let Some(verdict) = self.number_of("model_fit")? else { return Ok(None) };
        let known = |number: Option<f64>| number.filter(|number| !number.is_nan());
        let per_camera = |name: &str| -> netcdf::Result<Vec<f64>> {
            let variable = self.file.variable(name).ok_or_else(|| missing(name))?;
            variable.get_values((self.number, ..))
        };
        let cameras = per_camera("unexplained_light")?.into_iter();
        let cameras = cameras.zip(per_camera("micro_image_offset")?);
        let camera = |(unexplained, offset)| CameraFit {
            unexplained,
            micro_image_offset_px: known(Some(offset)),
        };
        Ok(Some(ModelFit {
            verdict: match verdict as i64 {
                0 => FitVerdict::Good,
                1 => FitVerdict::Doubtful,
                _ => FitVerdict::Poor,
            },
            cameras: cameras.map(camera).collect(),
            camera_agreement: known(self.number_of("camera_agreement")?),
            camera_disparity_mm: known(self.number_of("camera_disparity")?),
            valid_share: self.number_of("valid_share")?.unwrap_or(0.0),
            causes: Vec::new(),
        }))
    }

    fn time(&self) -> netcdf::Result<Option<ShotTime>> {
        let known = |number: Option<f64>| number.filter(|number| *number < FILL_F64);
        let Some(utc_s) = known(self.number_of("time")?) else { return Ok(None) };
        let uncertainty_s = known(self.number_of("time_uncertainty")?).unwrap_or(0.0);
        let clock_synchronised = self.number_of("time_clock")? == Some(1.0);
        Ok(Some(ShotTime {
            utc_ns: (utc_s * 1e9).round() as i64,
            uncertainty_ns: (uncertainty_s * 1e9).round() as u64,
            clock_synchronised,
        }))
    }

    fn raw(&self) -> netcdf::Result<RawLevel> {
        Ok(match self.number_of("raw_level")?.map(|level| level as i64) {
            Some(1) => RawLevel::Lost,
            Some(2) => RawLevel::Acquired,
            Some(3) => RawLevel::Written,
            Some(4) => RawLevel::Synced,
            _ => RawLevel::NotKept,
        })
    }
}

/// Times a factor; zero where there is no value, as fields have it in memory.
fn scaled(value: f32, factor: f64) -> f32 {
    if value.is_nan() { 0.0 } else { (f64::from(value) * factor) as f32 }
}

fn missing(variable: &str) -> netcdf::Error {
    netcdf::Error::NotFound(variable.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::archive::{ResultStore, test_data::result};

    #[test]
    fn results_are_read_back_as_they_were_measured() {
        let root = tempfile::tempdir().unwrap();
        let mut store = ResultStore::create(root.path(), "").unwrap();
        let mut measured = result([4, 3, 2]);
        let camera = CameraFit { unexplained: 0.25, micro_image_offset_px: None };
        measured.measured.fit = Some(ModelFit {
            verdict: FitVerdict::Doubtful,
            cameras: vec![camera],
            camera_agreement: None,
            camera_disparity_mm: Some(0.07),
            valid_share: 0.75,
            causes: Vec::new(),
        });
        for shot in [4, 3] {
            store.append(shot, &measured).unwrap();
        }
        store.close().unwrap();
        let voxel_mm = measured.measured.field.voxel_mm;
        let results = RunResults::find(root.path(), voxel_mm).unwrap();
        assert_eq!(results.shots().collect::<Vec<_>>(), [3, 4]);
        assert!(results.read(5).unwrap().is_none());
        let found = results.read(4).unwrap().unwrap();
        assert_eq!(found.measured.fit, measured.measured.fit);
        assert_eq!(found.measured.model, measured.measured.model);
        assert_eq!(found.raw, measured.raw);
        assert!(found.time.unwrap().utc_ns.abs_diff(measured.time.unwrap().utc_ns) < 1000);
        let (found, expected) = (found.measured.field, measured.measured.field);
        assert_eq!((&found.status, found.dt_s), (&expected.status, expected.dt_s));
        assert_eq!(found.grid.vectors, expected.grid.vectors);
        for (n, status) in expected.status.iter().enumerate() {
            for axis in 0..3 {
                let near = |a: f32, b: f32| (a - b).abs() <= 1e-5 * b.abs().max(1e-3);
                if *status != VectorStatus::Invalid {
                    let [a, b] = [&found, &expected].map(|field| field.displacement_vox[n][axis]);
                    assert!(near(a, b), "{n}: {a} {b}");
                    let [a, b] = [&found, &expected].map(|field| field.uncertainty_vox[n][axis]);
                    assert!(near(a, b), "{n}: {a} {b}");
                }
                if expected.has_gradient[n] {
                    let [a, b] = [&found, &expected].map(|field| field.vorticity[n][axis]);
                    assert!(near(a, b), "{n}: {a} {b}");
                }
            }
        }
        assert_eq!(found.has_gradient, expected.has_gradient);
    }
}
