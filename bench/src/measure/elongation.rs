//! Single particles: how wide they become along depth, and how far off (paper, Figs. 9 and 10).
//!
//! Each particle has a small volume of its own about it, of odd voxel counts. At given depths it
//! sits on the centre of the middle voxel; at random places anywhere in that voxel, whose grid is
//! the one that has a voxel centre at (0, 0, 0).

use lfpiv_core::reconstruction::{DenseVolume, quality::elongation_mm};
use lfpiv_sim::{Tracer, Truth};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::{Findings, Surroundings, volume::projected};
use crate::{
    BenchmarkError, Curve, Figure, Method, Projection,
    case::Setting,
    suite::RandomPlaces,
    truth::{Frame, reconstructor, true_volume},
};

/// A particle and the centre of the volume about it, in mm.
#[derive(Debug, Clone, Copy)]
struct Place {
    particle_mm: [f64; 3],
    centre_mm: [f64; 3],
}

/// What a single particle became.
struct Seen {
    fwhm_mm: f64,
    centroid_error_mm: f64,
    truth: DenseVolume,
    volume: DenseVolume,
}

/// Measures particles at the case's depths, one row each, and at random places, one row for all.
pub(super) fn measure(
    setting: &Setting,
    methods: &[Option<&Method>],
    surroundings: &mut Surroundings,
    findings: &mut Findings,
) -> Result<(), BenchmarkError> {
    for &method in methods {
        for &depth_mm in &setting.case.depths_mm {
            at_depth(setting, method, depth_mm, surroundings, findings)?;
        }
        if let Some(random) = &setting.case.random {
            for &seed in &setting.case.seeds {
                at_random(setting, method, random, seed, surroundings, findings)?;
            }
        }
    }
    Ok(())
}

fn at_depth(
    setting: &Setting,
    method: Option<&Method>,
    depth_mm: f64,
    surroundings: &mut Surroundings,
    findings: &mut Findings,
) -> Result<(), BenchmarkError> {
    let [x, y, z] = setting.config.volume.centre_mm;
    let centre_mm = [x, y, z + depth_mm];
    let seen = see(setting, method, Place { particle_mm: centre_mm, centre_mm }, 0)?;
    let mut row = setting.row(method, 0);
    row.depth_mm = Some(depth_mm);
    row.positions = Some(1);
    row.fwhm_mm = Some(seen.fwhm_mm);
    row.centroid_error_mm = Some(seen.centroid_error_mm);
    if depth_mm == 0.0 && setting.case.figures.contains(&Figure::Projection) {
        if findings.projections.iter().all(|p| p.case != row.case) {
            let truth = Projection { method: None, ..projected(&row, &seen.truth) };
            findings.projections.push(truth);
        }
        findings.projections.push(projected(&row, &seen.volume));
    }
    findings.add(row, surroundings);
    Ok(())
}

fn at_random(
    setting: &Setting,
    method: Option<&Method>,
    random: &RandomPlaces,
    seed: u64,
    surroundings: &mut Surroundings,
    findings: &mut Findings,
) -> Result<(), BenchmarkError> {
    let places = places(random, setting.config.volume.voxel_mm, seed);
    let mut widths = Vec::new();
    let (mut width_mm, mut error_mm) = (0.0, 0.0);
    for (place, number) in places.iter().zip(0..) {
        let seen = see(setting, method, *place, number)?;
        widths.push([place.particle_mm[2], seen.fwhm_mm]);
        width_mm += seen.fwhm_mm / places.len() as f64;
        error_mm += seen.centroid_error_mm / places.len() as f64;
    }
    let mut row = setting.row(method, seed);
    row.positions = Some(places.len());
    row.fwhm_mm = Some(width_mm);
    row.centroid_error_mm = Some(error_mm);
    findings.curves.push(Curve::of(&row, "fwhm_mm(depth_mm)", widths));
    findings.add(row, surroundings);
    Ok(())
}

/// Positions uniform in the box, each with the centre of the voxel that it is in.
fn places(random: &RandomPlaces, voxel_mm: f64, seed: u64) -> Vec<Place> {
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    (0..random.positions)
        .map(|_| {
            let particle_mm = random.within_mm.map(|edge| edge * (rng.random::<f64>() - 0.5));
            let centre_mm = particle_mm.map(|at| (at / voxel_mm).round() * voxel_mm);
            Place { particle_mm, centre_mm }
        })
        .collect()
}

/// Simulates one particle and reconstructs the volume about it.
fn see(
    setting: &Setting,
    method: Option<&Method>,
    place: Place,
    shot: u64,
) -> Result<Seen, BenchmarkError> {
    let mut config = setting.config_with(method);
    config.volume.centre_mm = place.centre_mm;
    let reconstructor = reconstructor(&config)?;
    let at = place.particle_mm;
    let particle =
        Tracer { a_mm: at, mid_mm: at, b_mm: at, intensity: 1.0, visible_a: true, visible_b: true };
    let truth = Truth {
        seed: 0,
        shot,
        dt_s: setting.bench.dt_s,
        flow: setting.scene.flow.clone(),
        particles: vec![particle],
    };
    let frame = Frame::simulate(setting, &truth, &reconstructor);
    let solved = reconstructor.reconstruct(&frame.views, &frame.levels);
    let volume = solved.volume.on_grid(&config.volume.grid());
    Ok(Seen {
        // A particle that was lost is as wide as the volume and as far off as its face.
        fwhm_mm: elongation_mm(&volume, 2)
            .unwrap_or(config.volume.voxels[2] as f64 * config.volume.voxel_mm),
        centroid_error_mm: centroid_mm(&volume, 2)
            .map_or(config.volume.voxels[2] as f64 * config.volume.voxel_mm / 2.0, |centroid| {
                (centroid - at[2]).abs()
            }),
        truth: true_volume(setting, &truth, &config.volume.grid()),
        volume,
    })
}

/// Intensity-weighted mean coordinate along an axis, in mm.
fn centroid_mm(volume: &DenseVolume, axis: usize) -> Option<f64> {
    let (mut light, mut moment) = (0.0, 0.0);
    for (voxel, &intensity) in (0..).zip(&volume.intensity) {
        let at = volume.grid.indices(voxel)[axis] as f64;
        light += f64::from(intensity);
        moment += f64::from(intensity) * volume.grid.coordinate_mm(axis, at);
    }
    (light > 0.0).then(|| moment / light)
}
