//! Complete calibration with ray-traced images of a card, on a small sensor.

use lfpiv_hw::{
    Optics, RawImage,
    card::{CalibrationCard, CardPosition},
};
use lfpiv_sim::{SensorSettings, imaging::PlacedCard};

use super::*;
use crate::{
    calibration::{
        CardLight, VolumeCalibration, VolumeError, VolumeInput, WhiteImage, calibrate_volume,
    },
    lightfield::MicroImageGrid,
};

/// Rays of each microlens.
const RAYS: usize = 1 << 12;

/// A third of the bench's sensor along each axis.
pub(super) fn small_optics() -> Optics {
    let mut optics = test_bench::optics();
    (optics.microlens.columns, optics.microlens.rows) = (65, 49);
    (optics.sensor.columns, optics.sensor.rows) = (1188, 896);
    optics
}

/// Deviations of cameras and card.
#[derive(Clone)]
struct Trial {
    flaws: CameraFlaws,
    shifts_mm: [[f64; 3]; 2],
    card: Card,
    /// Distance of the card from its stated positions.
    stage_mm: f64,
    /// Number of its positions, 3 mm from the first to the last.
    positions: usize,
}

impl Trial {
    /// Cameras displaced by two voxels and rotated by half a degree, behind tilted walls; a card at 45 degrees.
    fn typical() -> Self {
        Self {
            flaws: CameraFlaws {
                turn_deg: [0.4, -0.3, 0.5],
                array_rotation_deg: 0.5,
                array_shift_mm: [0.02, -0.03],
                array_pitch_scale: [1.003, 1.003],
                gain: 0.8,
                ..flaws()
            },
            shifts_mm: [[0.0; 3], [0.2, 0.1, -0.15]],
            card: Card {
                spacing_mm: 0.8,
                dot_diameter_mm: 0.42,
                fiducial_diameter_mm: 0.58,
                ..card()
            },
            stage_mm: 0.0,
            positions: 3,
        }
    }

    fn tracer<'a>(&self, optics: &'a Optics, camera: usize) -> RayTracer<'a> {
        let settings = RaySettings { rays_per_particle: 1, diffraction_nm: None };
        let pose = &test_bench::poses()[camera];
        RayTracer::imperfect(optics, pose, self.shifts_mm[camera], &self.flaws, &settings)
    }

    fn positions(&self) -> Vec<CardPosition> {
        let along = self.card.normal();
        let steps = (self.positions - 1) as f64;
        let at = |n: usize| CardPosition {
            origin_mm: (along * (3.0 * n as f64 / steps - 1.5)).into(),
            images: Vec::new(),
        };
        (0..self.positions).map(at).collect()
    }

    fn calibrated(
        &self,
        walls: &[Wall],
        stage_deviation_mm: f64,
    ) -> Result<VolumeCalibration, VolumeError> {
        let (optics, poses) = (small_optics(), test_bench::poses());
        let sensor = SensorSettings {
            gain_counts_per_electron: self.flaws.gain,
            ..SensorSettings::default()
        };
        let grids: Vec<MicroImageGrid> = (0..2)
            .map(|camera| {
                let grid = self.tracer(&optics, camera).micro_image_grid();
                MicroImageGrid {
                    microlenses: grid.microlenses,
                    column_px: grid.column_px,
                    row_px: grid.row_px,
                }
            })
            .collect();
        let dark = RawImage::new(
            optics.sensor.columns,
            optics.sensor.rows,
            vec![64; optics.sensor.columns * optics.sensor.rows],
        )
        .unwrap();
        let light =
            |image: RawImage| WhiteImage::average(&[image], std::slice::from_ref(&dark)).unwrap();
        let whites: Vec<WhiteImage> = (0..2)
            .map(|camera| {
                let traced =
                    self.tracer(&optics, camera).trace_white(RAYS, 3000.0, &[camera as u64]);
                light(sensor.expose(&traced, &[1, camera as u64]))
            })
            .collect();
        let lights: Vec<Vec<CardLight<'_>>> = self
            .positions()
            .iter()
            .enumerate()
            .map(|(n, position)| {
                // The stage's error has another direction at each position.
                let off_mm =
                    Vector3::new((n as f64).cos(), (2.3 * n as f64).sin(), (4.0 * n as f64).cos());
                let placed = PlacedCard {
                    card: &self.card,
                    origin_mm: Point3::from(position.origin_mm) + off_mm * self.stage_mm,
                    bend_mm: [0.0; 3],
                };
                (0..2)
                    .map(|camera| {
                        let key = [n as u64, camera as u64];
                        let traced = self
                            .tracer(&optics, camera)
                            .trace_card(&placed, RAYS, 3000.0, &key)
                            .unwrap();
                        let image = light(sensor.expose(&traced, &[2, key[0], key[1]]));
                        CardLight::new(&optics, &grids[camera], &whites[camera], &image)
                    })
                    .collect()
            })
            .collect();
        let card = CalibrationCard {
            card: self.card.clone(),
            wall: walls.to_vec(),
            reference: Vec::new(),
            position: self.positions(),
        };
        let input = VolumeInput {
            optics: &optics,
            poses: &poses,
            card: &card,
            light: &lights,
            stage_deviation_mm,
            box_mm: [[0.0; 3], [2.0, 1.5, 1.5]],
        };
        let mut steps = 0;
        let found = calibrate_volume(&input, || steps += 1);
        assert!(found.is_err() || steps == input.steps(), "{steps} of {}", input.steps());
        found
    }

    /// Errors of the maps relative to traced rays.
    fn errors(&self, found: &VolumeCalibration) -> Errors {
        let optics = small_optics();
        let mut errors = Errors::default();
        for (camera, of_camera) in found.cameras.iter().enumerate() {
            let tracer = self.tracer(&optics, camera);
            let off = |place_mm: [f64; 3]| {
                let point_mm = Point3::from(place_mm);
                let [place_mm, slopes] = place_and_slopes(&tracer, &point_mm);
                let traced = EquivalentPoint::of_rays(&optics, place_mm, slopes);
                let seen = of_camera.map.at(&point_mm);
                [
                    seen.lateral_mm[0] - traced.lateral_mm[0],
                    seen.lateral_mm[1] - traced.lateral_mm[1],
                    seen.depth_mm[0] - traced.depth_mm[0],
                    seen.depth_mm[1] - traced.depth_mm[1],
                ]
            };
            let middle = off([0.0; 3]);
            let larger = |most: f64, value: &f64| most.max(value.abs());
            errors.middle_mm = middle[..2].iter().fold(errors.middle_mm, larger);
            errors.middle_depth_mm = middle[2..].iter().fold(errors.middle_depth_mm, larger);
            for axis in 0..3 {
                let [mut low, mut high] = [[0.0; 3]; 2];
                (low[axis], high[axis]) = (-1.5, 1.5);
                let (low, high) = (off(low), off(high));
                for n in 0..2 {
                    errors.scale = errors.scale.max((high[n] - low[n]).abs() / 3.0);
                }
                errors.worst_mm = low[..2].iter().chain(&high[..2]).fold(errors.worst_mm, larger);
            }
        }
        errors
    }
}

#[derive(Debug, Default)]
struct Errors {
    /// Lateral error in the middle.
    middle_mm: f64,
    /// Depth error in the middle.
    middle_depth_mm: f64,
    /// Largest lateral error at the tested points.
    worst_mm: f64,
    /// Largest relative error of a scale.
    scale: f64,
}

#[test]
fn cameras_are_found_behind_tilted_walls() {
    let trial = Trial::typical();
    let found = trial.calibrated(&walls(), 0.0).unwrap();
    let errors = trial.errors(&found);
    println!("{:?} {:?} {errors:?} {:?}", found.held_out, found.condition_number, found.warnings);
    assert!(found.held_out.mean_microlenses <= 0.02, "{:?}", found.held_out);
    // 0.02 voxel of 0.1 mm, and 0.1 %.
    assert!(errors.middle_mm <= 0.002 && errors.worst_mm <= 0.002, "{errors:?}");
    assert!(errors.scale <= 1e-3, "{errors:?}");
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
}

/// Each camera sees one side of the card, and the stage has errors of five micrometres. Held-out residuals must not
/// contain the error of the stage.
#[test]
fn a_card_is_seen_from_both_sides_on_an_uncertain_stage() {
    const STAGE_MM: f64 = 0.005;
    // Of the stage's errors their mean remains, which is about half as large for five positions as for one.
    let mut trial = Trial { stage_mm: STAGE_MM, positions: 5, ..Trial::typical() };
    let half = 0.5f64.sqrt();
    trial.card.up = Vector3::new(0.0, half, half);
    trial.card.two_sided_mm = Some(1.5);

    let found = trial.calibrated(&walls(), STAGE_MM).unwrap();
    let errors = trial.errors(&found);
    println!("{:?} {errors:?} {:?} {:?}", found.held_out, found.stage_mm, found.warnings);
    assert!(found.held_out.mean_microlenses <= 0.02, "{:?}", found.held_out);
    // The mean of the stage's errors remains.
    assert!(errors.middle_mm <= 0.002 && errors.worst_mm <= 0.002, "{errors:?}");
    assert!(errors.scale <= 1e-3, "{errors:?}");
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
}
