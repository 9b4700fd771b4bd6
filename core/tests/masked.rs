//! A body in the flow: what is measured beside it, and that nothing is measured in it.
//!
//! Figures are printed: `cargo test --package lfpiv-core --test capabilities masked -- --nocapture`.

use std::sync::Arc;

use lfpiv_core::{
    lightfield::ImagePair,
    measurement::{Measurement, Processor},
    model::{ClosedSurface, FlowRegions, Region},
    velocimetry::{VectorStatus, VelocityField},
};
use lfpiv_sim::{EmptySpace, Flow};

use crate::support::{Bench, errors_vox};

/// Axis of the cylinder, which is along z, and its radius, in mm.
const AXIS_MM: [f64; 2] = [0.5, -0.3];
const RADIUS_MM: f64 = 0.9;

/// The bench in small: 6.4 x 4.8 x 4.8 mm, with the bench's density of particles.
fn bench() -> Bench {
    let mut bench = Bench::shipped("bench");
    bench.volume.voxels = [64, 48, 48];
    let scene = bench.simulation.as_mut().unwrap();
    scene.ppm = 12.5 * 4.8 * 0.01;
    bench
}

fn cylinder() -> FlowRegions {
    let sides = 48;
    let at = |n: usize, z: f64| {
        let angle = std::f64::consts::TAU * (n % sides) as f64 / sides as f64;
        [AXIS_MM[0] + RADIUS_MM * angle.cos(), AXIS_MM[1] + RADIUS_MM * angle.sin(), z]
    };
    let (low, high) = (-4.0, 4.0);
    let [bottom, top] = [low, high].map(|z| [AXIS_MM[0], AXIS_MM[1], z]);
    let triangles: Vec<[[f64; 3]; 3]> = (0..sides)
        .flat_map(|n| {
            let [a, b, c, d] = [at(n, low), at(n + 1, low), at(n + 1, high), at(n, high)];
            [[a, b, c], [a, c, d], [bottom, b, a], [top, d, c]]
        })
        .collect();
    let surface = Arc::new(ClosedSurface::new(&triangles).unwrap());
    FlowRegions { keep: Vec::new(), leave_out: vec![Region::Body(surface)] }
}

/// Distance of a place from the cylinder's surface, in mm; negative inside.
fn beside_mm(at_mm: [f64; 3]) -> f64 {
    (at_mm[0] - AXIS_MM[0]).hypot(at_mm[1] - AXIS_MM[1]) - RADIUS_MM
}

/// The field of a shot with or without particles in the body, measured with or without the mask.
fn measured(has_body: bool, is_masked: bool) -> (VelocityField, Flow) {
    let bench = bench();
    let (regions, mut geometry) = (cylinder(), bench.geometry());
    let mask = regions.mask(&bench.volume);
    if has_body {
        geometry.empty = Some(EmptySpace::new(move |at| !regions.is_flow(at)));
    }
    let shot = bench.simulation.as_ref().unwrap().shot(&geometry, 5, 0);
    let mask = is_masked.then(|| Arc::new(mask));
    let measurement = Measurement { mask, ..bench.measurement() };
    let processor = Processor::new(measurement).unwrap();
    let result = processor.process(ImagePair { cameras: shot.images }).unwrap();
    (result.field, shot.truth.flow)
}

/// Mean |component of the error| of the valid vectors in a range of distances from the body, in voxels, and the
/// share that is valid.
fn beside(field: &VelocityField, flow: &Flow, mm: std::ops::Range<f64>) -> (f64, f64) {
    let errors = errors_vox(field, flow);
    let here: Vec<usize> =
        (0..errors.len()).filter(|&n| mm.contains(&beside_mm(field.grid.position_mm(n)))).collect();
    let valid: Vec<usize> =
        here.iter().copied().filter(|&n| field.status[n] == VectorStatus::Valid).collect();
    let sum: f64 = valid.iter().flat_map(|&n| errors[n]).map(f64::abs).sum();
    (sum / (3 * valid.len()) as f64, valid.len() as f64 / here.len() as f64)
}

#[test]
fn a_body_has_no_vectors_and_costs_those_about_it_little() {
    let (whole, flow) = measured(false, false);
    let (masked, _) = measured(true, true);
    for n in 0..masked.grid.len() {
        let beside_mm = beside_mm(masked.grid.position_mm(n));
        // A voxel on the surface may be either.
        assert!(masked.status[n] != VectorStatus::Masked || beside_mm < 0.1, "{beside_mm}");
        assert!(masked.status[n] == VectorStatus::Masked || beside_mm > -0.1, "{beside_mm}");
    }
    // A window is 1.6 mm: those that begin beyond 0.8 mm do not reach the body.
    let [next, apart] = [0.0..0.8, 0.8..9.0].map(|mm| {
        let [with, without] = [&masked, &whole].map(|field| beside(field, &flow, mm.clone()));
        println!("{mm:?} mm from the body: mean |error| and valid share {with:?}, without a body {without:?}");
        (with, without)
    });
    let ((error, valid), (error_without, _)) = apart;
    assert!(error < 1.3 * error_without + 0.001 && valid > 0.97, "{apart:?}");
    let ((error, valid), (error_without, _)) = next;
    assert!(error < 2.5 * error_without + 0.002 && valid > 0.9, "{next:?}");
    assert!(masked.valid_share() > 0.95, "{}", masked.valid_share());
}

/// What is masked costs the rest nothing where there are particles all over.
#[test]
fn vectors_beside_a_masked_region_are_those_of_the_whole_volume() {
    let (whole, _) = measured(false, false);
    let (masked, _) = measured(false, true);
    let (mut within, mut count) = (0, 0);
    for n in 0..whole.grid.len() {
        let valid = [&whole, &masked].iter().all(|f| f.status[n] == VectorStatus::Valid);
        if !valid {
            continue;
        }
        for c in 0..3 {
            let apart = masked.displacement_vox[n][c] - whole.displacement_vox[n][c];
            let stated = masked.uncertainty_vox[n][c].hypot(whole.uncertainty_vox[n][c]);
            within += u32::from(apart.abs() <= 2.0 * stated);
            count += 1;
        }
    }
    let share = f64::from(within) / f64::from(count);
    println!(
        "{:.1} % of {count} components agree within twice their stated uncertainty",
        100.0 * share
    );
    assert!(share > 0.95, "{share}");
}
