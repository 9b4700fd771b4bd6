//! Particles as NetCDF-4/CF, discrete sampling geometry: points over `particle`, shot after shot.
//!
//! `shot` and `time` of a particle are those of its pair. A shot whose particles were placed has a record:
//! `record_shot` is its number, `row_size` the number of its particles, which may be 0.
//!
//! A run keeps particles beside its vectors: those of the shots in `velocity_000000.nc` are in
//! `particles_000000.nc`. In one file they would be in the way of readers that concatenate vectors along `shot`.
//! Particles are stored first, so vectors are never without them. A file of particles without its file of vectors
//! is of a store that was cut off: it does not count.

use std::path::{Path, PathBuf};

use lfpiv_core::{particles::CAMERAS, velocimetry::MeasuredParticle};

use super::{
    ArchiveError, ShotResult,
    netcdf_file::{Described, FILL_F64, NetCdfFile},
    velocity_file::add_utc,
};

/// The dimension of particles, that of shots, and their variables.
pub(super) const PARTICLE: &str = "particle";
pub(super) const RECORD: &str = "record";
pub(super) const RECORD_SHOT: Described =
    described("record_shot", "1", "number of a shot whose particles were placed");
pub(super) const ROW_SIZE: Described =
    described("row_size", "1", "number of particles of record_shot, which follow those before");

/// Size at which the particles of a segment are enough for a file.
const FULL_BYTES: usize = 32 << 20;
/// Upper bound of a particle's bytes in a file, without compression.
const PARTICLE_BYTES: usize = 128;

/// A quantity of each particle, from the particle, the speed of a voxel per pair in m/s, and the length of a
/// voxel in mm.
type PerParticle = fn(&MeasuredParticle, f64, f64) -> f64;

const fn described<'a>(name: &'a str, units: &'a str, long_name: &'a str) -> Described<'a> {
    Described { name, units, long_name }
}

const PLACES: [Described; 3] = [
    described("x", "mm", "x in the world frame, middle of the pair"),
    described("y", "mm", "y in the world frame, middle of the pair"),
    described("z", "mm", "z in the world frame, middle of the pair"),
];

const QUANTITIES: [(Described, PerParticle); 9] = [
    (described("u", "m s-1", "velocity along x"), |p, speed, _| velocity(p, 0) * speed),
    (described("v", "m s-1", "velocity along y"), |p, speed, _| velocity(p, 1) * speed),
    (described("w", "m s-1", "velocity along z"), |p, speed, _| velocity(p, 2) * speed),
    (described("x_uncertainty", "mm", "standard uncertainty of x"), |p, _, mm| {
        place_uncertainty(p, 0) * mm
    }),
    (described("y_uncertainty", "mm", "standard uncertainty of y"), |p, _, mm| {
        place_uncertainty(p, 1) * mm
    }),
    (described("z_uncertainty", "mm", "standard uncertainty of z"), |p, _, mm| {
        place_uncertainty(p, 2) * mm
    }),
    (described("u_uncertainty", "m s-1", "standard uncertainty of u"), |p, speed, _| {
        uncertainty(p, 0) * speed
    }),
    (described("v_uncertainty", "m s-1", "standard uncertainty of v"), |p, speed, _| {
        uncertainty(p, 1) * speed
    }),
    (described("w_uncertainty", "m s-1", "standard uncertainty of w"), |p, speed, _| {
        uncertainty(p, 2) * speed
    }),
];

const SHOT: Described = described("shot", "1", "shot number within the run");
const LIGHT: Described = described(
    "light",
    "1",
    "light in each camera, mean of both frames, in counts of an open pixel that gets all of it",
);
const VALID: Described =
    described("valid", "1", "seen in both frames and agrees with the particles about it");

fn velocity(particle: &MeasuredParticle, component: usize) -> f64 {
    f64::from(particle.displacement_vox[component])
}

fn place_uncertainty(particle: &MeasuredParticle, component: usize) -> f64 {
    f64::from(particle.place_uncertainty_vox[component])
}

fn uncertainty(particle: &MeasuredParticle, component: usize) -> f64 {
    f64::from(particle.uncertainty_vox[component])
}

/// The particles that belong to a file of vectors: `velocity_000000.nc` -> `particles_000000.nc`.
pub(super) fn particles_beside(velocity: &Path) -> PathBuf {
    let name = velocity.file_name().unwrap_or_default().to_string_lossy();
    velocity.with_file_name(name.replacen("velocity", "particles", 1))
}

/// Writes the particles of a result as a file of one shot, replacing an older one. Where none were placed there
/// is no file.
pub fn write_particles(
    path: &Path,
    configuration: &str,
    shot: u64,
    result: &ShotResult,
) -> Result<(), ArchiveError> {
    let mut particles = GatheredParticles::default();
    particles.add(shot, result);
    particles.store(path, configuration)
}

/// The particles of a shot, and what makes numbers with units of them.
struct ShotParticles {
    shot: u64,
    utc_s: Option<f64>,
    /// Speed of a voxel per pair, in m/s.
    speed: f64,
    voxel_mm: f64,
    cameras: usize,
    particles: Vec<MeasuredParticle>,
}

/// The particles of shots, in memory until they are stored together.
#[derive(Default)]
pub(super) struct GatheredParticles(Vec<ShotParticles>);

impl GatheredParticles {
    /// Adds those of a shot, if they were placed.
    pub fn add(&mut self, shot: u64, result: &ShotResult) {
        let measured = &result.measured;
        let Some(particles) = &measured.particles else { return };
        self.0.push(ShotParticles {
            shot,
            utc_s: result.time.map(|time| time.utc_s()),
            speed: measured.field.metres_per_second_per_voxel(),
            voxel_mm: measured.field.voxel_mm,
            cameras: result.cameras(),
            particles: particles.clone(),
        });
    }

    /// Whether they are enough for a file.
    pub fn is_full(&self) -> bool {
        self.len() * size_of::<MeasuredParticle>() >= FULL_BYTES
    }

    /// Number of particles.
    fn len(&self) -> usize {
        self.0.iter().map(|shot| shot.particles.len()).sum()
    }

    /// Writes the file; without any shot there is none. A failed call leaves nothing behind and can be repeated.
    pub fn store(&self, path: &Path, configuration: &str) -> Result<(), ArchiveError> {
        if self.0.is_empty() {
            return Ok(());
        }
        let bytes = (self.len() * PARTICLE_BYTES + (1 << 20)) as u64;
        let mut file =
            NetCdfFile::create(path, bytes, "Particles placed in the images", configuration)?;
        self.put_records(&mut file)?;
        file.add_attribute("featureType", "point")?;
        file.add_dimension(PARTICLE, self.len())?;
        // CF readers treat data with an unknown auxiliary coordinate as missing.
        let is_timed = self.0.iter().all(|shot| shot.utc_s.is_some());
        let coordinates = if is_timed { "time x y z" } else { "x y z" };
        self.put_places(&mut file)?;
        self.put_quantities(&mut file, coordinates)?;
        self.put_light(&mut file, coordinates)?;
        file.store()
    }

    fn put_records(&self, file: &mut NetCdfFile) -> Result<(), ArchiveError> {
        file.add_dimension(RECORD, self.0.len())?;
        let shots: Vec<i64> = self.0.iter().map(|shot| shot.shot as i64).collect();
        let sizes: Vec<i64> = self.0.iter().map(|shot| shot.particles.len() as i64).collect();
        for (described, values) in [(&RECORD_SHOT, shots), (&ROW_SIZE, sizes)] {
            file.add::<i64>(described, &[RECORD])?;
            file.put(described.name, &values)?;
        }
        Ok(())
    }

    /// A value for each particle, from its shot and itself.
    fn each<T>(&self, value: impl Fn(&ShotParticles, &MeasuredParticle) -> T) -> Vec<T> {
        let of_shot = |shot: &ShotParticles| -> Vec<T> {
            shot.particles.iter().map(|particle| value(shot, particle)).collect()
        };
        self.0.iter().flat_map(of_shot).collect()
    }

    /// Shot, time and place.
    fn put_places(&self, file: &mut NetCdfFile) -> Result<(), ArchiveError> {
        file.add::<i64>(&SHOT, &[PARTICLE])?;
        put(file, SHOT.name, &self.each(|shot, _| shot.shot as i64))?;
        let time = add_utc(file, PARTICLE)?;
        put(file, time, &self.each(|shot, _| shot.utc_s.unwrap_or(FILL_F64)))?;
        for (axis, described) in PLACES.iter().enumerate() {
            file.add::<f64>(described, &[PARTICLE])?;
            put(file, described.name, &self.each(|_, particle| particle.at_mm[axis]))?;
        }
        Ok(())
    }

    fn put_quantities(&self, file: &mut NetCdfFile, coordinates: &str) -> Result<(), ArchiveError> {
        for (described, quantity) in &QUANTITIES {
            file.add::<f32>(described, &[PARTICLE])?;
            let values =
                self.each(|shot, particle| quantity(particle, shot.speed, shot.voxel_mm) as f32);
            put(file, described.name, &values)?;
            file.put_text(described.name, "coordinates", coordinates)?;
        }
        for name in ["x", "y", "z", "u", "v", "w"] {
            file.put_text(name, "ancillary_variables", &format!("{name}_uncertainty"))?;
        }
        file.add_flag(&VALID, &[PARTICLE], "rejected valid")?;
        put(file, VALID.name, &self.each(|_, particle| i8::from(particle.agrees)))
    }

    fn put_light(&self, file: &mut NetCdfFile, coordinates: &str) -> Result<(), ArchiveError> {
        let cameras = self.0.iter().map(|shot| shot.cameras).min().unwrap_or(CAMERAS);
        file.add_dimension("camera", cameras)?;
        file.add::<f32>(&LIGHT, &[PARTICLE, "camera"])?;
        let light = self.each(|_, particle| particle.light[..cameras].to_vec()).concat();
        put(file, LIGHT.name, &light)?;
        file.put_text(LIGHT.name, "coordinates", coordinates)
    }
}

/// Compresses a variable and writes its values.
fn put<T: netcdf::NcTypeDescriptor>(
    file: &mut NetCdfFile,
    name: &str,
    values: &[T],
) -> Result<(), ArchiveError> {
    file.compress(name)?;
    // Without particles the dimension is one that may grow: nothing can be written along all of it.
    if values.is_empty() { Ok(()) } else { file.put(name, values) }
}
