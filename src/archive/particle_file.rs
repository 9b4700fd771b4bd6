//! The particles of a pair as NetCDF-4/CF, discrete sampling geometry: points over `particle`.

use std::path::Path;

use lfpiv_core::velocimetry::{MeasuredParticle, VelocityField};

use super::{
    ArchiveError,
    netcdf_file::{Described, NetCdfFile},
};

/// A quantity of each particle, from the particle and the speed of a voxel per pair, in m/s, and the length of a
/// voxel, in mm.
type PerParticle = fn(&MeasuredParticle, f64, f64) -> f64;

const fn described<'a>(name: &'a str, units: &'a str, long_name: &'a str) -> Described<'a> {
    Described { name, units, long_name }
}

const QUANTITIES: [(Described, PerParticle); 12] = [
    (described("x", "mm", "x in the world frame, middle of the pair"), |p, _, _| p.at_mm[0]),
    (described("y", "mm", "y in the world frame, middle of the pair"), |p, _, _| p.at_mm[1]),
    (described("z", "mm", "z in the world frame, middle of the pair"), |p, _, _| p.at_mm[2]),
    (described("u", "m s-1", "velocity along x"), |p, speed, _| velocity(p, 0) * speed),
    (described("v", "m s-1", "velocity along y"), |p, speed, _| velocity(p, 1) * speed),
    (described("w", "m s-1", "velocity along z"), |p, speed, _| velocity(p, 2) * speed),
    (described("x_uncertainty", "mm", "standard uncertainty of x"), |p, _, mm| {
        uncertainty(p, 0) * mm / 2.0
    }),
    (described("y_uncertainty", "mm", "standard uncertainty of y"), |p, _, mm| {
        uncertainty(p, 1) * mm / 2.0
    }),
    (described("z_uncertainty", "mm", "standard uncertainty of z"), |p, _, mm| {
        uncertainty(p, 2) * mm / 2.0
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

fn uncertainty(particle: &MeasuredParticle, component: usize) -> f64 {
    f64::from(particle.uncertainty_vox[component])
}

/// Writes the `particles` of shot `shot`, whose vectors are `field`, as seen by so many `cameras`.
pub fn write_particles(
    path: &Path,
    configuration: &str,
    shot: u64,
    field: &VelocityField,
    (particles, cameras): (&[MeasuredParticle], usize),
) -> Result<(), ArchiveError> {
    // Upper bound: 12 quantities, light, shot and flag, without compression.
    let bytes = (particles.len() * (14 + cameras) * size_of::<f64>() + (1 << 20)) as u64;
    let mut file =
        NetCdfFile::create(path, bytes, "Particles placed in the images", configuration)?;
    file.add_attribute("featureType", "point")?;
    file.add_dimension("particle", particles.len())?;
    file.add_dimension("camera", cameras)?;
    let speed = field.metres_per_second_per_voxel();
    for (described, quantity) in &QUANTITIES {
        let values: Vec<f64> =
            particles.iter().map(|p| quantity(p, speed, field.voxel_mm)).collect();
        file.add::<f64>(described, &["particle"])?;
        file.compress(described.name)?;
        file.put(described.name, &values)?;
        if !matches!(described.name, "x" | "y" | "z") {
            file.put_text(described.name, "coordinates", "x y z")?;
        }
    }
    for name in ["x", "y", "z", "u", "v", "w"] {
        file.put_text(name, "ancillary_variables", &format!("{name}_uncertainty"))?;
    }
    file.add::<i64>(&SHOT, &["particle"])?;
    file.put(SHOT.name, &vec![shot as i64; particles.len()])?;
    file.add::<f32>(&LIGHT, &["particle", "camera"])?;
    let light: Vec<f32> = particles.iter().flat_map(|p| p.light[..cameras].to_vec()).collect();
    file.put(LIGHT.name, &light)?;
    file.put_text(LIGHT.name, "coordinates", "x y z")?;
    file.add_flag(&VALID, &["particle"], "rejected valid")?;
    let valid: Vec<i8> = particles.iter().map(|p| i8::from(p.agrees)).collect();
    file.put(VALID.name, &valid)?;
    file.store()
}
