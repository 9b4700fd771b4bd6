//! Reads the results of a finished run as they were measured.

use std::{collections::BTreeMap, path::Path, sync::Arc};

use lfpiv_core::{
    model::ModelChoice,
    reconstruction::{CameraFit, FitVerdict, ModelFit},
    velocimetry::{PairResult, StageSeconds, VelocityField},
};

use super::{
    ArchiveError, RawLevel, ShotResult, ShotTime,
    netcdf_file::FILL_F64,
    netcdf_open::open,
    stored::missing,
    stored_particles::particles_of,
    stored_record::{RecordPlace, StoredRecord, places_in_segments},
};

/// Index of a run's stored results.
#[derive(Debug, Clone, Default)]
pub struct RunResults {
    places: BTreeMap<u64, RecordPlace>,
    voxel_mm: f64,
}

impl RunResults {
    /// Indexes the sealed segments in a run's folder; `voxel_mm` is the voxel size of the run.
    ///
    /// # Errors
    /// The folder or a segment cannot be read.
    pub fn find(folder: &Path, voxel_mm: f64) -> Result<Self, ArchiveError> {
        let places = places_in_segments(folder)?;
        Ok(Self { places, voxel_mm })
    }

    /// Number of shots with a result.
    pub fn len(&self) -> usize {
        self.places.len()
    }

    /// Whether no shot has a result.
    pub fn is_empty(&self) -> bool {
        self.places.is_empty()
    }

    /// The shots with a result, in ascending order.
    pub fn shots(&self) -> impl DoubleEndedIterator<Item = u64> {
        self.places.keys().copied()
    }

    /// Reads the result of a shot; `None` if it has none. Warnings and the causes of a poor fit are
    /// not stored, so they are empty. Particles that cannot be read are reported, and absent.
    ///
    /// # Errors
    /// The segment cannot be read.
    pub fn read(&self, shot: u64) -> Result<Option<ShotResult>, ArchiveError> {
        let Some((mut result, path)) = self.read_vectors(shot)? else { return Ok(None) };
        result.measured.particles = particles_of(path, shot, &result.measured.field)
            .unwrap_or_else(|error| {
                tracing::error!(shot, "{error}");
                None
            });
        Ok(Some(result))
    }

    /// As [`Self::read`], but not without its particles.
    ///
    /// # Errors
    /// The segment or the particles beside it cannot be read.
    pub fn read_whole(&self, shot: u64) -> Result<Option<ShotResult>, ArchiveError> {
        let Some((mut result, path)) = self.read_vectors(shot)? else { return Ok(None) };
        result.measured.particles = particles_of(path, shot, &result.measured.field)?;
        Ok(Some(result))
    }

    /// The result without its particles, and the segment that it is in.
    fn read_vectors(&self, shot: u64) -> Result<Option<(ShotResult, &Path)>, ArchiveError> {
        let Some(RecordPlace { path, record }) = self.places.get(&shot) else { return Ok(None) };
        let read =
            || result_of(StoredRecord { file: &open(path)?, record: *record }, self.voxel_mm);
        let result = read().map_err(ArchiveError::unreadable_results(path))?;
        Ok(Some((result, path)))
    }
}

fn result_of(record: StoredRecord<'_>, voxel_mm: f64) -> netcdf::Result<ShotResult> {
    let seconds = |name: &str| -> netcdf::Result<f64> { Ok(record.number(name)?.unwrap_or(0.0)) };
    let measured = PairResult {
        field: field_of(record, voxel_mm)?,
        seconds: StageSeconds {
            decode_s: seconds("decode_seconds")?,
            reconstruct_s: seconds("reconstruct_seconds")?,
            correlate_s: seconds("correlate_seconds")?,
            judge_s: seconds("judge_seconds")?,
        },
        warnings: Vec::new(),
        model: Arc::new(model_of(record)?),
        fit: fit_of(record)?,
        light: None,
        particles: None,
    };
    Ok(ShotResult { measured, time: time_of(record)?, raw: raw_level_of(record)? })
}

fn field_of(record: StoredRecord<'_>, voxel_mm: f64) -> netcdf::Result<VelocityField> {
    let dt_s = record.number("dt")?.ok_or_else(|| missing("dt"))?;
    let voxels_per_m_s = dt_s / (voxel_mm * 1e-3);
    let triples = |names: [&str; 3], factor: f64| -> netcdf::Result<Vec<[f32; 3]>> {
        let stored = record.triples(names)?.into_iter();
        Ok(stored.map(|triple| triple.map(|value| scaled(value, factor))).collect())
    };
    let divergence = record.vectors("divergence")?;
    Ok(VelocityField {
        grid: record.grid()?,
        displacement_vox: triples(["u", "v", "w"], voxels_per_m_s)?,
        uncertainty_vox: triples(
            ["u_uncertainty", "v_uncertainty", "w_uncertainty"],
            voxels_per_m_s,
        )?,
        status: record.status()?,
        peak_ratio: record.vectors("peak_ratio")?,
        has_gradient: divergence.iter().map(|d| !d.is_nan()).collect(),
        vorticity: triples(["vorticity_x", "vorticity_y", "vorticity_z"], dt_s)?,
        divergence: divergence.into_iter().map(|d| scaled(d, dt_s)).collect(),
        voxel_mm,
        dt_s,
    })
}

/// The stored model; the default if an early version stored none or the text cannot be parsed.
fn model_of(record: StoredRecord<'_>) -> netcdf::Result<ModelChoice> {
    let Some(choice) = record.file.attribute("model_choice") else {
        return Ok(ModelChoice::default());
    };
    let text = String::try_from(choice.value()?)?;
    Ok(serde_json::from_str(&text).unwrap_or_default())
}

fn fit_of(record: StoredRecord<'_>) -> netcdf::Result<Option<ModelFit>> {
    let Some(verdict) = record.number("model_fit")? else { return Ok(None) };
    let known = |number: Option<f64>| number.filter(|number| !number.is_nan());
    let per_camera = |name: &str| -> netcdf::Result<Vec<f64>> {
        let variable = record.file.variable(name).ok_or_else(|| missing(name))?;
        variable.get_values((record.record, ..))
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
        camera_agreement: known(record.number("camera_agreement")?),
        camera_disparity_mm: known(record.number("camera_disparity")?),
        valid_share: record.number("valid_share")?.unwrap_or(0.0),
        causes: Vec::new(),
    }))
}

fn time_of(record: StoredRecord<'_>) -> netcdf::Result<Option<ShotTime>> {
    let known = |number: Option<f64>| number.filter(|number| *number < FILL_F64);
    let Some(utc_s) = known(record.number("time")?) else { return Ok(None) };
    let uncertainty_s = known(record.number("time_uncertainty")?).unwrap_or(0.0);
    let clock_synchronised = record.number("time_clock")? == Some(1.0);
    Ok(Some(ShotTime {
        utc_ns: (utc_s * 1e9).round() as i64,
        uncertainty_ns: (uncertainty_s * 1e9).round() as u64,
        clock_synchronised,
    }))
}

fn raw_level_of(record: StoredRecord<'_>) -> netcdf::Result<RawLevel> {
    Ok(match record.number("raw_level")?.map(|level| level as i64) {
        Some(1) => RawLevel::Lost,
        Some(2) => RawLevel::Acquired,
        Some(3) => RawLevel::Written,
        Some(4) => RawLevel::Synced,
        _ => RawLevel::NotKept,
    })
}

/// A value times a factor; a missing value becomes zero, as in fields in memory.
fn scaled(value: f32, factor: f64) -> f32 {
    if value.is_nan() { 0.0 } else { (f64::from(value) * factor) as f32 }
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
                if status.has_value() {
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
