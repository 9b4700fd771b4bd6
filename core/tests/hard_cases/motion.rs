//! Motion that is none, sits between voxels, leaves the window, or differs inside it.

use lfpiv_sim::{
    Flow,
    flow::{Axis, LinearShear, SolidRotation},
};

use super::bench::{SEED, scene_of, simulated, uniform, usual, usual_rms};
use crate::support::Bench;

fn moving(flow: Flow, max_displacement_vox: f64) -> Bench {
    let mut config = usual();
    scene_of(&mut config).flow = flow;
    config.velocimetry.max_displacement_vox = max_displacement_vox;
    config
}

/// A displacement is as good between the voxels as on them: the mean error of all windows, some 15
/// independent ones, is within two standard errors of zero, 0.025 voxels, and another 0.025 for a
/// bias towards whole voxels (peak locking).
#[test]
fn no_displacement_is_preferred() {
    for shift in [0.0, 0.25, 0.5, 0.75] {
        let found = simulated(&moving(uniform([shift, -shift, shift]), 2.0), SEED);
        let bias = found.bias();
        found.print(&format!("{shift} voxels: bias {:.3} {:.3} {:.3}", bias[0], bias[1], bias[2]));
        assert!(bias.iter().all(|b| b.abs() <= 0.05), "{shift}: {bias:?}");
        assert!(found.rms() <= 1.5 * usual_rms(), "{}, usual {}", found.rms(), usual_rms());
        assert!(found.valid_share() >= 0.95);
        assert_eq!(found.false_share(), 0.0);
    }
}

/// A quarter of a window along each axis takes 0.58 of its particles out of a window that stays;
/// those that follow the flow lose none but at the volume's faces, where particles come and go.
#[test]
fn a_quarter_of_a_window_is_followed() {
    let found = simulated(&moving(uniform([3.0, -3.0, 3.0]), 4.0), SEED);
    found.print("a quarter of the window");
    assert!(found.rms() <= 2.0 * usual_rms(), "{}, usual {}", found.rms(), usual_rms());
    assert!(found.valid_share() >= 0.9, "{}", found.valid_share());
    assert_eq!(found.false_share(), 0.0);
}

/// Beyond what the configuration looks for no answer can be right: at most one window in twenty may
/// be fooled by chance.
#[test]
fn beyond_the_window_nothing_is_valid() {
    for shift in [[6.0, 0.0, 0.0], [0.0, -8.0, 8.0], [13.0, 0.0, 0.0]] {
        let found = simulated(&moving(uniform(shift), 2.0), SEED);
        found.print(&format!("{shift:?} voxels where 2 are expected"));
        assert!(found.valid_share() <= 0.05, "{shift:?}: {}", found.valid_share());
    }
}

/// Gradients in voxel per voxel, and the share of vectors that must be valid. Across a window of 12
/// voxels displacement differs by 2.4 at 0.2 and 4.8 at 0.4, more than the width of a particle image:
/// only deformation brings the peak together.
const GRADIENTS: [(f64, f64); 2] = [(0.2, 0.9), (0.4, 0.6)];
const DT_S: f64 = 1e-4;

fn check_gradient(name: &str, flow_of: impl Fn(f64) -> Flow) {
    for (gradient, least_valid) in GRADIENTS {
        let found = simulated(&moving(flow_of(gradient / DT_S), 6.0), SEED);
        found.print(&format!("{name} of {gradient}"));
        // The plain mean over 40 particles at random places scatters by g L/√12/√40; deformation
        // must take at least half of that away.
        let most = usual_rms().hypot(gradient * 12.0 / 12f64.sqrt() / 40f64.sqrt() / 2.0);
        assert!(found.rms() <= most, "{name} {gradient}: {}, allowed {most}", found.rms());
        assert!(found.valid_share() >= least_valid, "{name}: {}", found.valid_share());
        assert!(found.false_share() <= 0.03, "{name}: {}", found.false_share());
    }
}

#[test]
fn strong_shear_inside_a_window_is_resolved() {
    check_gradient("shear", |rate_per_s| {
        Flow::LinearShear(LinearShear { component: Axis::X, along: Axis::Z, rate_per_s })
    });
}

#[test]
fn strong_rotation_inside_a_window_is_resolved() {
    check_gradient("rotation", |rate_rad_s| Flow::SolidRotation(SolidRotation { rate_rad_s }));
}
