//! Arbitrarily oriented cameras, compared with the definition of a share pixel by pixel, with
//! aligned cameras, and with a voxelwise hull.

use std::collections::BTreeSet;

use nalgebra::{Rotation3, Unit, Vector3};
use proptest::prelude::*;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::*;
use crate::{
    lightfield::MicroImageGrid,
    model::{
        BlockLight, EquivalentPoint, SUPPORT_SHARE, ViewId, VolumeMap, child_voxel,
        tables::MIN_VISIBLE_SHARE,
    },
    test_bench,
};

/// A camera pose rotated about a world axis, in degrees.
fn turned(pose: &Pose, axis: [f64; 3], degrees: f64) -> Pose {
    let axis = Unit::new_normalize(Vector3::from(axis));
    let turn = Rotation3::from_axis_angle(&axis, degrees.to_radians());
    Pose {
        right: turn * pose.right,
        up: turn * pose.up,
        axis: turn * pose.axis,
        origin_mm: pose.origin_mm,
    }
}

/// A calibration with a rotated, shifted and stretched array.
fn turned_array(degrees: f64) -> CameraCalibration {
    let nominal = MicroImageGrid::nominal(&test_bench::optics());
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let pitch = nominal.column_px[1] * 1.002;
    let (column_px, row_px) = ([pitch * cosine, -pitch * sine], [-pitch * sine, -pitch * cosine]);
    let first = |middle: f64, [by_i, by_j]: [f64; 2]| middle - 64.0 * by_i - 48.0 * by_j;
    let grid = MicroImageGrid {
        column_px: [first(1178.3, column_px), column_px[0], column_px[1]],
        row_px: [first(880.1, row_px), row_px[0], row_px[1]],
        ..nominal
    };
    CameraCalibration { grid: Some(grid), map: None }
}

/// A map of a lens with slight distortion and different depths for columns and rows.
fn bent_map(pose: &Pose) -> VolumeMap {
    let equivalent = |world: [f64; 3]| {
        let point = pose.to_camera(&world.into());
        let square = point.xi_mm * point.xi_mm + point.eta_mm * point.eta_mm;
        let stretched = 1.0 + 1e-4 * square;
        Some(EquivalentPoint {
            lateral_mm: [point.xi_mm * stretched, point.eta_mm * stretched],
            depth_mm: [0.76 * point.depth_mm, 0.74 * point.depth_mm],
        })
    };
    VolumeMap::fit([3.0, -2.0, 2.5], [2.0; 3], 3, equivalent).unwrap().0
}

fn grid() -> VolumeGrid {
    VolumeGrid { voxels: [26, 23, 21], voxel_mm: 0.025, centre_mm: [3.1, -2.0, 2.6] }
}

struct Case {
    name: &'static str,
    pose: Pose,
    calibration: CameraCalibration,
    /// Largest L1 distance from the definition, relative to a voxel's light, averaged over views.
    most_apart: f64,
}

fn cases() -> Vec<Case> {
    let [first, above] = <[Pose; 2]>::try_from(test_bench::poses()).unwrap();
    let uncalibrated = CameraCalibration::default;
    let case = |name, pose, calibration, most_apart| Case { name, pose, calibration, most_apart };
    let deviation = CameraCalibration { grid: None, map: Some(bent_map(&first)) };
    vec![
        case("as configured", first.clone(), uncalibrated(), 0.06),
        case("turned about x", turned(&above, [1.0, 0.0, 0.0], 0.5), uncalibrated(), 0.06),
        case("at 60 degrees", turned(&above, [1.0, 0.0, 0.0], -30.0), uncalibrated(), 0.06),
        case("beside 90 degrees", turned(&above, [0.0, 0.0, 1.0], 25.0), uncalibrated(), 0.06),
        case("rolled", turned(&above, [0.0, 1.0, 0.0], 40.0), uncalibrated(), 0.06),
        case("deviation", first.clone(), deviation, 0.06),
        // Neighbouring rows have different phases, which separable weights cannot represent.
        case("array turned", first.clone(), turned_array(0.5), 0.12),
        case("array turned back", first, turned_array(-1.0), 0.16),
    ]
}

fn setup_of<'a>(
    case: &Case,
    grid: &'a VolumeGrid,
    footprint_mm: f64,
    parts: &'a ModelParts,
) -> Setup<'a> {
    let calibrations = [case.calibration.clone()];
    let poses = [case.pose.clone()];
    let optics = test_bench::optics();
    Setup::new(&optics, &poses, &calibrations, grid, footprint_mm, parts, &[]).unwrap()
}

fn model_of(case: &Case, grid: &VolumeGrid, footprint_mm: f64) -> Box<dyn BlockModel> {
    setup_of(case, grid, footprint_mm, &ModelParts::default()).narrowest().unwrap()
}

/// The naive reference: the share of a voxel on every microlens, with its own phase along both axes.
struct Definition {
    optics: MappedOptics,
    geometries: [FootprintGeometry; 2],
}

impl Definition {
    fn new(case: &Case, grid: &VolumeGrid, footprint_mm: f64) -> Self {
        let parts = ModelParts::default();
        let mut setup = setup_of(case, grid, footprint_mm, &parts);
        let geometries = setup.geometries(&setup.mapped[0], &setup.arrangements[0]);
        Self { optics: setup.mapped.swap_remove(0), geometries }
    }

    /// Adds a voxel's light to a view.
    fn project(&self, view: &View, world_mm: &Point3<f64>, image: &mut [f64]) {
        let projected = self.optics.project(world_mm);
        let cells = self.optics.lenses_per_cell();
        let window = &self.optics.window;
        let width = window.columns.len();
        let slope = |n: usize| {
            let [by_right, by_up] = cells[n];
            let pupil = by_right * f64::from(view.k) + by_up * f64::from(view.l);
            (pupil + projected.place[n] - self.optics.on_axis()[n]).abs()
                * self.geometries[n].pitch_mm
        };
        let maps = [0, 1].map(|n| RayMap::at_depth(&self.optics.optics, projected.depth_mm[n]));
        let shadows = [0, 1].map(|n| self.geometries[n].shadow(maps[n], slope(n)));
        for j in window.rows.clone() {
            for i in window.columns.clone() {
                let phase = self.optics.sampling.phase(i, j);
                let share = |n: usize, lens: usize| {
                    let [by_right, by_up] = cells[n];
                    let (k, l) = (f64::from(view.k) + phase[0], f64::from(view.l) + phase[1]);
                    let place =
                        projected.place[n] + projected.parallax[n] * (by_right * k + by_up * l);
                    self.geometries[n].share(maps[n], &shadows[n], 0.0, place - lens as f64, 0)
                };
                let at = (j - window.rows.start) * width + i - window.columns.start;
                let open = view.coverage.as_ref().map_or(1.0, |c| f64::from(c[at]));
                let along_i = share(0, i - window.columns.start);
                if along_i > 0.0 {
                    image[at] += along_i * share(1, j - window.rows.start) * open;
                }
            }
        }
    }
}

#[test]
fn blocks_are_imaged_as_their_voxels_by_definition() {
    let mut wrong = false;
    for case in cases() {
        for (grid, footprint_mm) in
            [(grid(), 0.025), (VolumeGrid { voxels: [7, 8, 9], voxel_mm: 0.1, ..grid() }, 0.1)]
        {
            let model = model_of(&case, &grid, footprint_mm);
            let definition = Definition::new(&case, &grid, footprint_mm);
            let mut random = Pcg64Mcg::seed_from_u64(3);
            let blocks: Vec<u32> = (0..40)
                .map(|_| {
                    random.random_range(
                        0..super::super::blocks_along(&grid).iter().product::<usize>(),
                    ) as u32
                })
                .collect();
            let projector = model.projector(&blocks);
            let layout = &model.layouts()[0];
            let (mut apart, mut total) = (0.0, 0.0);
            for view in (0..layout.views.len()).step_by(23) {
                for (n, &block) in blocks.iter().enumerate() {
                    let child = n % 8;
                    let Some(voxel) = child_voxel(&grid, block, child) else { continue };
                    let mut light = vec![[0.0f32; 8]; blocks.len()];
                    light[n][child] = 1.0;
                    let mut image = vec![0.0; model.image_len(0)];
                    projector.project(ViewId { camera: 0, view }, &light, &mut image);
                    let mut expected = vec![0.0; layout.window.len()];
                    let world = grid.centre_of(grid.indices(voxel));
                    definition.project(&layout.views[view], &world, &mut expected);
                    let distance = |(a, b): (&f32, &f64)| (f64::from(*a) - b).abs();
                    apart += image.iter().zip(&expected).map(distance).sum::<f64>();
                    total += expected.iter().sum::<f64>();
                }
            }
            let share = apart / total;
            println!("{} {}: {:.2} %", case.name, grid.voxel_mm, 100.0 * share);
            wrong |= share > case.most_apart;
        }
    }
    assert!(!wrong);
}

#[test]
fn back_projection_is_the_adjoint_of_projection() {
    let mut random = Pcg64Mcg::seed_from_u64(6);
    for case in cases() {
        let model = model_of(&case, &grid(), 0.025);
        let blocks: Vec<u32> = (0..super::super::blocks_along(&grid()).iter().product::<usize>()
            as u32)
            .step_by(3)
            .collect();
        let mut projector = model.projector(&blocks);
        let keep: Vec<bool> = (0..blocks.len()).map(|n| n % 4 != 1).collect();
        projector.retain(&keep);
        let kept = keep.iter().filter(|&&keep| keep).count();
        let light: Vec<BlockLight> =
            (0..kept).map(|_| std::array::from_fn(|_| random.random())).collect();
        let id = ViewId { camera: 0, view: model.layouts()[0].views.len() / 3 };
        let pixels = model.layouts()[0].window.len();
        let mut weights = vec![0.0f32; model.image_len(0)];
        weights[..pixels].fill_with(|| random.random::<f32>());
        let mut image = vec![0.0; model.image_len(0)];
        projector.project(id, &light, &mut image);
        let mut spread = vec![[0.0; 8]; kept];
        let mut prepared = weights.clone();
        projector.prepare(id, &mut prepared);
        let (low, high) = spread.split_at_mut(kept / 2);
        projector.back_project(id, &prepared, 0..kept / 2, low);
        projector.back_project(id, &prepared, kept / 2..kept, high);
        let dot =
            |a: &[f32], b: &[f32]| -> f64 { a.iter().zip(b).map(|(a, b)| f64::from(a * b)).sum() };
        let (there, back) =
            (dot(&image, &weights), dot(light.as_flattened(), spread.as_flattened()));
        assert!((there - back).abs() < 1e-5 * there.abs(), "{}: {there} {back}", case.name);
    }
}

/// A volume cut by the array's edge, compared with the same voxels in a larger window.
#[test]
fn light_beyond_the_window_is_lost_and_nothing_else() {
    let case = Case { calibration: turned_array(0.5), ..cases().swap_remove(0) };
    let grid = VolumeGrid { voxels: [40, 20, 20], voxel_mm: 0.1, centre_mm: [6.2, -4.4, 1.0] };
    let model = model_of(&case, &grid, 0.1);
    let definition = Definition::new(&case, &grid, 0.1);
    let all = super::super::blocks_along(&grid).iter().product::<usize>() as u32;
    let blocks: Vec<u32> = (0..all).step_by(7).collect();
    let light = vec![[1.0; 8]; blocks.len()];
    let projector = model.projector(&blocks);
    let layout = &model.layouts()[0];
    for view in (0..layout.views.len()).step_by(60) {
        let mut image = vec![0.0; model.image_len(0)];
        projector.project(ViewId { camera: 0, view }, &light, &mut image);
        let mut expected = vec![0.0; layout.window.len()];
        for &block in &blocks {
            for voxel in (0..8).filter_map(|child| child_voxel(&grid, block, child)) {
                let world = grid.centre_of(grid.indices(voxel));
                definition.project(&layout.views[view], &world, &mut expected);
            }
        }
        let total: f64 = expected.iter().sum();
        let apart: f64 = image.iter().zip(&expected).map(|(a, b)| (f64::from(*a) - b).abs()).sum();
        assert!(apart < 0.02 * total, "view {view}: {apart} of {total}");
        assert!(image[layout.window.len()..].iter().all(|&value| value == 0.0));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// The voxel of a particle is never dark, for any position and camera orientation.
    #[test]
    fn a_lit_voxel_is_in_the_hull(seed in 0u64..1_000_000, number in 0usize..8) {
        let case = cases().swap_remove(number);
        let grid = VolumeGrid { voxels: [64, 50, 40], voxel_mm: 0.05, centre_mm: [1.7, -1.6, 1.8] };
        let model = model_of(&case, &grid, 0.05);
        let definition = Definition::new(&case, &grid, 0.02);
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let particles: Vec<[f64; 3]> = (0..12)
            .map(|_| grid.voxels.map(|n| random.random_range(0.0..n as f64 - 1.0)))
            .collect();
        let layout = &model.layouts()[0];
        let stack: Vec<f32> = layout
            .views
            .iter()
            .flat_map(|view| {
                let mut image = vec![0.0; layout.window.len()];
                for place in &particles {
                    let world: [f64; 3] =
                        std::array::from_fn(|axis| grid.coordinate_mm(axis, place[axis]));
                    definition.project(view, &world.into(), &mut image);
                }
                image.into_iter().map(|value| 100.0 * value as f32)
            })
            .collect();
        let views = [ViewStack::new(layout.window.len(), stack)];
        let selected: Vec<usize> = (0..layout.views.len()).step_by(2).collect();
        // A particle at the corner of four microlenses gives a quarter of its light to each.
        let criteria = HullCriteria {
            selected: vec![selected],
            dark_below: vec![6.0],
            tolerated: vec![3],
            displacement: vec![0.25],
        };
        let lit = model.lit(&views, &criteria);
        let found = voxels_of(&lit, &grid);
        for place in &particles {
            let voxel = place.map(|index| index.round() as usize);
            prop_assert!(found.contains(&(grid.linear(voxel) as u32)), "{}: {place:?}", case.name);
        }
        let share = found.len() as f64 / grid.len() as f64;
        prop_assert!(share < 0.2, "{}: {share} of the volume", case.name);
    }
}

/// The voxels of blocks.
fn voxels_of(lit: &LitBlocks, grid: &VolumeGrid) -> BTreeSet<u32> {
    let children = |(&block, &children): (&u32, &u8)| {
        (0..8)
            .filter(move |child| children >> child & 1 == 1)
            .filter_map(move |child| child_voxel(grid, block, child))
    };
    lit.blocks.iter().zip(&lit.children).flat_map(children).collect()
}

impl Definition {
    /// Whether a voxel is dark in a view, by the criterion of [`BlockModel::lit`]. `None` if the view contains
    /// too little of its light.
    fn is_dark(&self, view: &View, world_mm: &Point3<f64>, lit: &[bool]) -> Option<bool> {
        let projected = self.optics.project(world_mm);
        let cells = self.optics.lenses_per_cell();
        let window = &self.optics.window;
        let (columns, rows) = (window.columns.len() as i64, window.rows.len() as i64);
        let maps = [0, 1].map(|n| RayMap::at_depth(&self.optics.optics, projected.depth_mm[n]));
        let shares = |i: i64, j: i64| -> [f64; 2] {
            let (column, row) = (window.columns.start as i64 + i, window.rows.start as i64 + j);
            let phase = self.optics.sampling.phase(column as usize, row as usize);
            [0, 1].map(|n| {
                let geometry = &self.geometries[n];
                let shadow = geometry.shadow(maps[n], geometry.max_slope_mm / 2.0);
                let [by_right, by_up] = cells[n];
                let (k, l) = (f64::from(view.k) + phase[0], f64::from(view.l) + phase[1]);
                let place = projected.place[n] + projected.parallax[n] * (by_right * k + by_up * l);
                geometry.share(maps[n], &shadow, 0.0, place - [i, j][n] as f64, 0)
            })
        };
        let nominal = [0, 1].map(|n| {
            let [by_right, by_up] = cells[n];
            let pupil = by_right * f64::from(view.k) + by_up * f64::from(view.l);
            (projected.place[n] + projected.parallax[n] * pupil).round() as i64
        });
        let (mut visible_along, mut dark) = ([0.0; 2], true);
        for j in nominal[1] - 4..=nominal[1] + 4 {
            for i in nominal[0] - 4..=nominal[0] + 4 {
                let inside = (0..columns).contains(&i) && (0..rows).contains(&j);
                if !inside {
                    continue;
                }
                let [along_i, along_j] = shares(i, j);
                visible_along[0] += if j == nominal[1] { along_i } else { 0.0 };
                visible_along[1] += if i == nominal[0] { along_j } else { 0.0 };
                let share = f64::from(SUPPORT_SHARE);
                dark &= along_i <= share || along_j <= share || !lit[(j * columns + i) as usize];
            }
        }
        let least = f64::from(MIN_VISIBLE_SHARE);
        visible_along.iter().all(|&share| share >= least).then_some(dark)
    }
}

#[test]
fn the_hull_is_that_of_voxels_one_by_one() {
    let grid = VolumeGrid { voxels: [26, 18, 12], voxel_mm: 0.05, centre_mm: [2.4, -2.0, 2.6] };
    let mut random = Pcg64Mcg::seed_from_u64(9);
    let mut wrong = false;
    for case in cases() {
        let parts = ModelParts::default();
        let model = setup_of(&case, &grid, 0.05, &parts).model::<8>().unwrap();
        let definition = Definition::new(&case, &grid, 0.05);
        let layout = &model.layouts()[0];
        let len = layout.window.len();
        let value = |_| if random.random::<f32>() < 0.6 { 0.0 } else { 10.0 };
        let views = [ViewStack::new(len, (0..len * layout.views.len()).map(value).collect())];
        let selected: Vec<usize> = (0..layout.views.len()).step_by(7).collect();
        let lit: Vec<Vec<bool>> = selected
            .iter()
            .map(|&view| {
                let coverage = layout.views[view].coverage.as_deref();
                let is_lit = |(n, &value): (usize, &f32)| {
                    let open = coverage.map_or(1.0, |coverage| coverage[n]);
                    open <= 0.5 || value >= 5.0 * open
                };
                views[0].view(view).iter().enumerate().map(is_lit).collect()
            })
            .collect();
        let dark: Vec<usize> = (0..grid.len() as u32)
            .map(|voxel| {
                let world = grid.centre_of(grid.indices(voxel));
                let is_dark = |(&view, lit): (&usize, &Vec<bool>)| {
                    definition.is_dark(&layout.views[view], &world, lit) == Some(true)
                };
                selected.iter().zip(&lit).filter(|&view| is_dark(view)).count()
            })
            .collect();
        for tolerated in [7, 9, 12] {
            let [thin, layered, thick] = [0.0, 0.03, 0.25].map(|displacement| {
                let criteria = HullCriteria {
                    selected: vec![selected.clone()],
                    dark_below: vec![5.0],
                    tolerated: vec![tolerated],
                    displacement: vec![displacement],
                };
                voxels_of(&model.lit(&views, &criteria), &grid)
            });
            let expected = dark.iter().filter(|&&dark| dark <= tolerated).count();
            let [missing, missing_in_layers] =
                [&thick, &layered].map(|other| thin.difference(other).count());
            println!(
                "{}, {tolerated} tolerated: {} voxels of {expected}, {} and {} in tiles whose depths are \
                 displaced by up to 0.03 and 0.25 microlenses, {missing_in_layers} and {missing} missing there",
                case.name,
                thin.len(),
                layered.len(),
                thick.len()
            );
            let ratio = thin.len() as f64 / expected as f64;
            wrong |= expected < 100 || !(0.93..1.35).contains(&ratio);
            wrong |= missing.max(missing_in_layers) as f64 > 0.01 * thin.len() as f64;
            wrong |= layered.len() > thick.len();
        }
    }
    assert!(!wrong);
}

#[test]
fn a_hexagonal_array_is_refused_by_name() {
    let case = cases().swap_remove(0);
    let grid = MicroImageGrid {
        column_px: [7.5, 18.0, 9.0],
        row_px: [1700.0, 0.0, -15.6],
        ..MicroImageGrid::nominal(&test_bench::optics())
    };
    let calibration = [CameraCalibration { grid: Some(grid), map: None }];
    let (optics, parts) = (test_bench::optics(), ModelParts::default());
    let model =
        mapped_model(&optics, &[case.pose], &calibration, &self::grid(), 0.025, &parts, &[]);
    let Err(error) = model else { panic!("a hexagonal array is accepted") };
    assert!(error.to_string().contains("cam1") && error.to_string().contains("hexagonal"));
}
