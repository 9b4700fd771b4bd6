use std::collections::HashSet;

use proptest::prelude::*;

use super::*;
use crate::flow::{Abc, Uniform};

fn cube() -> Volume {
    Volume { voxels: [100; 3], voxel_mm: 0.1, centre_mm: [0.0; 3] }
}

fn seeding(placement: Placement) -> Seeding {
    Seeding { ppm: 1.0, placement, intensity_spread: 0.2, sheet_mm: None, empty: None }
}

fn flow_along_x(velocity_m_s: f64) -> Flow {
    Flow::Uniform(Uniform { velocity_m_s: [velocity_m_s, 0.0, 0.0] })
}

#[test]
fn one_ppm_over_a_hundred_microlenses_squared_is_ten_thousand() {
    let still = Flow::default();
    for placement in [Placement::OffGrid, Placement::OnGrid] {
        let particles = seeding(placement).particles(&cube(), 0.1, &still, 1e-4, (1, 0));
        assert_eq!(particles.len(), 10_000);
        assert!(particles.iter().all(|p| p.visible_a && p.visible_b && p.a_mm == p.b_mm));
    }
}

#[test]
fn a_larger_sheet_keeps_the_density() {
    let wide = Seeding { sheet_mm: Some([12.0, 10.0, 20.0]), ..seeding(Placement::OffGrid) };
    assert_eq!(wide.particles(&cube(), 0.1, &Flow::default(), 1e-4, (1, 0)).len(), 24_000);
}

#[test]
fn seeds_and_shots_give_different_particles_and_repeat() {
    let draw =
        |key| seeding(Placement::OffGrid).particles(&cube(), 0.1, &flow_along_x(1.0), 1e-4, key);
    assert_eq!(draw((1, 2)), draw((1, 2)));
    assert_ne!(draw((1, 2)), draw((1, 3)));
    assert_ne!(draw((1, 2)), draw((2, 2)));
}

#[test]
fn particles_enter_and_leave_a_sharp_sheet() {
    // 2 mm per pair through a 10 mm sheet: 1 mm before and after the middle.
    let particles =
        seeding(Placement::OffGrid).particles(&cube(), 0.1, &flow_along_x(20.0), 1e-4, (1, 0));
    let shares = [
        particles.iter().filter(|p| p.visible_a).count(),
        particles.iter().filter(|p| p.visible_b).count(),
        particles.iter().filter(|p| p.visible_a && p.visible_b).count(),
    ];
    // Both frames are full (10,000 ± a few standard deviations), four fifths are in both.
    for (share, expected) in shares.into_iter().zip([10_000, 10_000, 8_000]) {
        assert!(share.abs_diff(expected) < 300, "{shares:?}");
    }
    for p in &particles {
        assert!((p.b_mm[0] - p.a_mm[0] - 2.0).abs() < 1e-9);
        assert_eq!(p.visible_a, p.a_mm[0].abs() <= 5.0);
        assert_eq!(p.lit_mm(FrameOfPair::B), (p.b_mm[0].abs() <= 5.0).then_some(p.b_mm));
    }
}

#[test]
fn on_grid_particles_sit_on_distinct_voxel_centres_in_mid_time() {
    let odd = Volume { voxels: [21, 20, 19], voxel_mm: 0.2, centre_mm: [1.0, 0.0, -1.0] };
    let abc = Flow::Abc(Abc { wavelength_mm: 10.0, amplitude_m_s: 1.0, coefficients: [1.0; 3] });
    let particles = seeding(Placement::OnGrid).particles(&odd, 0.1, &abc, 1e-4, (7, 0));
    let mut seen = HashSet::new();
    for p in &particles {
        let index: [f64; 3] = std::array::from_fn(|axis| {
            (p.mid_mm[axis] - odd.centre_mm[axis]) / 0.2 + (odd.voxels[axis] as f64 - 1.0) / 2.0
        });
        assert!(index.iter().all(|i| (i - i.round()).abs() < 1e-6), "{index:?}");
        assert!(seen.insert(index.map(|i| i.round() as i64)));
    }
    assert!(particles.len() > 1000);
}

#[test]
fn more_particles_than_voxels_fills_the_grid_once() {
    let tiny = Volume { voxels: [3, 3, 1], voxel_mm: 0.1, centre_mm: [0.0; 3] };
    let crowd = Seeding { ppm: 20.0, ..seeding(Placement::OnGrid) };
    assert_eq!(crowd.particles(&tiny, 0.1, &Flow::default(), 1e-4, (1, 0)).len(), 9);
}

#[test]
fn an_empty_volume_or_no_seeding_gives_no_particles() {
    let none = Seeding { ppm: 0.0, ..seeding(Placement::OffGrid) };
    assert!(none.particles(&cube(), 0.1, &Flow::default(), 1e-4, (1, 0)).is_empty());
    let empty = Volume { voxels: [0; 3], ..cube() };
    let some = seeding(Placement::OnGrid);
    assert!(some.particles(&empty, 0.1, &Flow::default(), 1e-4, (1, 0)).is_empty());
}

#[test]
fn an_absurd_velocity_does_not_seed_without_end() {
    let carried = flow_along_x(1000.0);
    let drawn = seeding(Placement::OffGrid).drawn(&cube(), 0.1, &carried, 1.0);
    assert_eq!(drawn.round(), 30_000.0);
    let still = seeding(Placement::OffGrid).drawn(&cube(), 0.1, &Flow::default(), 1.0);
    assert_eq!(still.round(), 10_000.0);
}

proptest! {
    #[test]
    fn brightness_stays_in_its_range(spread in 0.0..1.0_f64, seed in any::<u64>()) {
        let spread_seeding =
            Seeding { ppm: 0.02, intensity_spread: spread, ..seeding(Placement::OffGrid) };
        let particles = spread_seeding.particles(&cube(), 0.1, &Flow::default(), 1e-4, (seed, 0));
        prop_assert_eq!(particles.len(), 200);
        for p in particles {
            prop_assert!((p.intensity - 1.0).abs() <= spread + 1e-12);
        }
    }
}

/// A body of which nothing is seen, in either frame, though the flow carries particles through it.
#[test]
fn a_body_has_no_particles_in_either_frame() {
    let in_body = |at: [f64; 3]| at[0].hypot(at[2]) < 1.0;
    let body = Seeding { empty: Some(EmptySpace::new(in_body)), ..seeding(Placement::OffGrid) };
    let flow = flow_along_x(2.0);
    let [with, without] = [body, seeding(Placement::OffGrid)]
        .map(|seeding| seeding.particles(&cube(), 0.1, &flow, 1e-4, (3, 0)));
    let seen = |particles: &[Tracer], frame| -> Vec<[f64; 3]> {
        particles.iter().filter_map(|particle| particle.lit_mm(frame)).collect()
    };
    for frame in [FrameOfPair::A, FrameOfPair::B] {
        let outside: Vec<[f64; 3]> =
            seen(&without, frame).into_iter().filter(|at| !in_body(*at)).collect();
        assert!(outside.len() > 1000);
        assert_eq!(seen(&with, frame), outside);
    }
}
