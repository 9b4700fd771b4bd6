//! The separable thin-lens model: tables per axis, no stored matrix.

use std::ops::Range;

use lfpiv_hw::{Optics, Pose};
use nalgebra::Vector3;

use super::{
    ForwardModel, ModelError, Projector, SUPPORT_SHARE, ViewId, VolumeGrid,
    footprint::RayMap,
    tables::{AxisGeometry, AxisTable, Nodes, Tap},
};
use crate::lightfield::{AxisSampling, MicrolensWindow, ViewLayout};

/// The widest footprint that tables are compiled for, in microlenses.
const MOST_TAPS: usize = 5;

/// Cameras that do not look along a grid axis are tabulated on nodes this many times finer than
/// the voxels, and each voxel uses the nearest one: at most an eighth of a voxel beside its place.
const OBLIQUE_NODES_PER_VOXEL: f64 = 4.0;

/// Builds the thin-lens model of a bench with the narrowest tables that hold its footprints.
///
/// Errors when a camera does not see the volume or the voxels are too wide for the tables.
pub fn thin_lens_model(
    optics: &Optics,
    poses: &[Pose],
    grid: &VolumeGrid,
    footprint_mm: f64,
) -> Result<Box<dyn ForwardModel>, ModelError> {
    let views = poses
        .iter()
        .enumerate()
        .map(|(camera, pose)| CameraView::new(optics, pose, grid, camera))
        .collect::<Result<Vec<_>, _>>()?;
    let columns = AxisSampling::columns(optics);
    let rows = AxisSampling::rows(optics);
    let mut widest: f64 = 0.0;
    for view in &views {
        for axis in view.geometries(optics, &columns, &rows, footprint_mm) {
            widest = widest.max(axis.widest_pitches());
        }
    }
    // A footprint of width w covers at most floor(w) + 2 microlenses, wherever it lies.
    Ok(match widest.floor() as usize + 2 {
        ..=2 => Box::new(ThinLensModel::<2>::new(optics, views, grid, footprint_mm)),
        3 => Box::new(ThinLensModel::<3>::new(optics, views, grid, footprint_mm)),
        4..=MOST_TAPS => {
            Box::new(ThinLensModel::<MOST_TAPS>::new(optics, views, grid, footprint_mm))
        }
        _ => {
            let (camera, most) = (1, MOST_TAPS - 2);
            let voxel_mm = footprint_mm;
            return Err(ModelError::FootprintTooWide { camera, voxel_mm, pitches: widest, most });
        }
    })
}

/// How one camera sees the grid.
#[derive(Debug, Clone)]
struct CameraView {
    window: MicrolensWindow,
    xi: CameraAxis,
    eta: CameraAxis,
    depth: CameraAxis,
}

/// One camera coordinate of the voxels: `at_origin + Σ per_index[a]·index[a]`, and its table nodes.
#[derive(Debug, Clone)]
struct CameraAxis {
    at_origin_mm: f64,
    per_index_mm: [f64; 3],
    nodes: Nodes,
}

impl CameraAxis {
    fn new(direction: &Vector3<f64>, pose: &Pose, grid: &VolumeGrid) -> Self {
        let first = grid.centre_of([0, 0, 0]).coords - pose.origin_mm;
        let at_origin_mm = first.dot(direction);
        let per_index_mm: [f64; 3] = std::array::from_fn(|a| direction[a] * grid.voxel_mm);
        let along = (0..3).find(|&a| (direction[a].abs() - 1.0).abs() < 1e-9);
        let nodes = match along {
            Some(a) => {
                Nodes { first_mm: at_origin_mm, step_mm: per_index_mm[a], count: grid.voxels[a] }
            }
            None => {
                let reach = |sign: f64| -> f64 {
                    (0..3)
                        .map(|a| (sign * per_index_mm[a]).max(0.0) * (grid.voxels[a] - 1) as f64)
                        .sum()
                };
                let step_mm = grid.voxel_mm / OBLIQUE_NODES_PER_VOXEL;
                let count = ((reach(1.0) + reach(-1.0)) / step_mm).ceil() as usize + 1;
                Nodes { first_mm: at_origin_mm - reach(-1.0), step_mm, count }
            }
        };
        Self { at_origin_mm, per_index_mm, nodes }
    }

    fn range_mm(&self) -> (f64, f64) {
        let (a, b) = (self.nodes.at(0), self.nodes.at(self.nodes.count - 1));
        (a.min(b), a.max(b))
    }

    fn node_of(&self, ijk: [usize; 3]) -> usize {
        let coordinate: f64 = (0..3).map(|a| self.per_index_mm[a] * ijk[a] as f64).sum();
        self.nodes.nearest(self.at_origin_mm + coordinate)
    }
}

impl CameraView {
    fn new(
        optics: &Optics,
        pose: &Pose,
        grid: &VolumeGrid,
        camera: usize,
    ) -> Result<Self, ModelError> {
        let axis = |direction| CameraAxis::new(direction, pose, grid);
        let (xi, eta, depth) = (axis(&pose.right), axis(&pose.up), axis(&pose.axis));
        let camera = camera + 1;
        let (_, nearest_mm) = depth.range_mm();
        let limit_mm = optics.object_distance_mm - optics.focal_length_mm;
        if nearest_mm >= limit_mm {
            return Err(ModelError::TooDeep { camera, depth_mm: nearest_mm, limit_mm });
        }
        let columns = seen_microlenses(optics, &xi, &depth, grid, optics.microlens.columns);
        let rows = seen_microlenses(optics, &eta, &depth, grid, optics.microlens.rows);
        match (columns, rows) {
            (Some(columns), Some(rows)) => {
                Ok(Self { window: MicrolensWindow { columns, rows }, xi, eta, depth })
            }
            _ => Err(ModelError::VolumeOutOfView { camera }),
        }
    }

    fn geometries<'a>(
        &self,
        optics: &'a Optics,
        columns: &'a AxisSampling,
        rows: &'a AxisSampling,
        voxel_mm: f64,
    ) -> [AxisGeometry<'a>; 2] {
        let depths = self.depth.nodes;
        let window = self.window.clone();
        [
            AxisGeometry {
                optics,
                sampling: columns,
                window: window.columns,
                positions: self.xi.nodes,
                depths,
                voxel_mm,
            },
            AxisGeometry {
                optics,
                sampling: rows,
                window: window.rows,
                positions: self.eta.nodes,
                depths,
                voxel_mm,
            },
        ]
    }
}

/// The microlenses that light from the grid can reach along one axis.
fn seen_microlenses(
    optics: &Optics,
    lateral: &CameraAxis,
    depth: &CameraAxis,
    grid: &VolumeGrid,
    microlenses: usize,
) -> Option<Range<usize>> {
    let (low, high) = lateral.range_mm();
    let (far, near) = depth.range_mm();
    let half_voxel = grid.voxel_mm / 2.0;
    let radius = optics.pupil_diameter_mm() / 2.0;
    let (mut first, mut last) = (f64::INFINITY, f64::NEG_INFINITY);
    for d in [far - half_voxel, near + half_voxel] {
        let map = RayMap::at_depth(optics, d);
        let blur = map.pupil.abs() * radius;
        for position in [low - half_voxel, high + half_voxel] {
            let x = map.position * position;
            first = first.min(x - blur);
            last = last.max(x + blur);
        }
    }
    let index = |x: f64| (x / optics.microlens.pitch_mm + (microlenses as f64 - 1.0) / 2.0).round();
    let (first, last) = (index(first), index(last));
    if last < 0.0 || first >= microlenses as f64 {
        return None;
    }
    Some(first.max(0.0) as usize..(last as usize + 1).min(microlenses))
}

/// The separable footprint of every voxel in every view, from tables with `W` taps per axis.
#[derive(Debug)]
pub struct ThinLensModel<const W: usize> {
    grid: VolumeGrid,
    layouts: Vec<ViewLayout>,
    cameras: Vec<CameraTables<W>>,
}

#[derive(Debug)]
struct CameraTables<const W: usize> {
    view: CameraView,
    columns: AxisTable<W>,
    rows: AxisTable<W>,
    /// Values per row of a projected image, wide enough for every tap.
    width: usize,
}

impl<const W: usize> ThinLensModel<W> {
    fn new(optics: &Optics, views: Vec<CameraView>, grid: &VolumeGrid, footprint_mm: f64) -> Self {
        let layouts: Vec<_> =
            views.iter().map(|view| ViewLayout::new(optics, view.window.clone())).collect();
        let cameras = views
            .into_iter()
            .zip(&layouts)
            .map(|(view, layout)| {
                let [columns, rows] =
                    view.geometries(optics, &layout.columns, &layout.rows, footprint_mm);
                let (columns, rows) =
                    rayon::join(|| AxisTable::new(&columns), || AxisTable::new(&rows));
                let width = view.window.columns.len();
                CameraTables { view, columns, rows, width }
            })
            .collect();
        Self { grid: grid.clone(), layouts, cameras }
    }
}

impl<const W: usize> ForwardModel for ThinLensModel<W> {
    fn grid(&self) -> &VolumeGrid {
        &self.grid
    }

    fn layouts(&self) -> &[ViewLayout] {
        &self.layouts
    }

    fn projector(&self, voxels: &[u32]) -> Box<dyn Projector + '_> {
        let [nx, ny, _] = self.grid.voxels;
        let places = self
            .cameras
            .iter()
            .map(|camera| {
                let place = |&voxel: &u32| {
                    let n = voxel as usize;
                    camera.place([n % nx, n / nx % ny, n / (nx * ny)])
                };
                voxels.iter().map(place).collect()
            })
            .collect();
        Box::new(ThinLensProjector { model: self, places })
    }

    fn memory_bytes(&self) -> usize {
        let tables: usize =
            self.cameras.iter().map(|c| c.columns.memory_bytes() + c.rows.memory_bytes()).sum();
        let coverage: usize = self
            .layouts
            .iter()
            .flat_map(|layout| &layout.views)
            .map(|view| view.coverage.as_ref().map_or(0, |c| c.len() * size_of::<f32>()))
            .sum();
        tables + coverage
    }
}

/// Where in a camera's two tables a voxel's taps are.
#[derive(Debug, Clone, Copy)]
struct Place {
    column: u32,
    row: u32,
}

impl<const W: usize> CameraTables<W> {
    fn place(&self, ijk: [usize; 3]) -> Place {
        let depth = self.view.depth.node_of(ijk);
        Place {
            column: (depth * self.columns.positions() + self.view.xi.node_of(ijk)) as u32,
            row: (depth * self.rows.positions() + self.view.eta.node_of(ijk)) as u32,
        }
    }
}

struct ThinLensProjector<'a, const W: usize> {
    model: &'a ThinLensModel<W>,
    /// Per camera, per active voxel.
    places: Vec<Vec<Place>>,
}

impl<const W: usize> ThinLensProjector<'_, W> {
    /// The tables of a view: taps along columns, taps along rows, image width, coverage.
    fn tables(&self, id: ViewId) -> (&[Tap<W>], &[Tap<W>], usize, Option<&[f32]>) {
        let camera = &self.model.cameras[id.camera];
        let view = &self.model.layouts[id.camera].views[id.view];
        let columns = camera.columns.of_view(view.k);
        let rows = camera.rows.of_view(view.l);
        (columns, rows, camera.width, view.coverage.as_deref())
    }
}

impl<const W: usize> Projector for ThinLensProjector<'_, W> {
    fn project(&self, view: ViewId, intensity: &[f32], image: &mut [f32]) {
        let (columns, rows, width, coverage) = self.tables(view);
        image.fill(0.0);
        for (place, &intensity) in self.places[view.camera].iter().zip(intensity) {
            let column = &columns[place.column as usize];
            let row = &rows[place.row as usize];
            let scaled = column.weights.map(|w| w * intensity);
            let mut at = row.first as usize * width + column.first as usize;
            for weight in row.weights {
                if let Some(line) = image.get_mut(at..at + W) {
                    for (pixel, scaled) in line.iter_mut().zip(scaled) {
                        *pixel += weight * scaled;
                    }
                }
                at += width;
            }
        }
        if let Some(coverage) = coverage {
            for (pixel, &share) in image.iter_mut().zip(coverage) {
                *pixel *= share;
            }
        }
    }

    fn back_project(&self, view: ViewId, image: &[f32], range: Range<usize>, out: &mut [f32]) {
        let (columns, rows, width, coverage) = self.tables(view);
        let open: Vec<f32>;
        let image = match coverage {
            None => image,
            Some(coverage) => {
                open = image.iter().zip(coverage).map(|(&i, &c)| i * c).collect();
                &open
            }
        };
        for (place, out) in self.places[view.camera][range].iter().zip(out) {
            let column = &columns[place.column as usize];
            let row = &rows[place.row as usize];
            let mut at = row.first as usize * width + column.first as usize;
            let mut sum = 0.0;
            for weight in row.weights {
                if let Some(line) = image.get(at..at + W) {
                    let line: f32 = line.iter().zip(column.weights).map(|(&i, w)| i * w).sum();
                    sum += weight * line;
                }
                at += width;
            }
            *out += sum;
        }
    }

    fn brightest(&self, view: ViewId, image: &[f32], range: Range<usize>, out: &mut [f32]) {
        let (columns, rows, width, coverage) = self.tables(view);
        let judged: Vec<f32>;
        let image = match coverage {
            None => image,
            Some(coverage) => {
                let judge = |(&i, &c): (&f32, &f32)| if c > 0.5 { i / c } else { f32::INFINITY };
                judged = image.iter().zip(coverage).map(judge).collect();
                &judged
            }
        };
        for (place, out) in self.places[view.camera][range].iter().zip(out) {
            let column = &columns[place.column as usize];
            let row = &rows[place.row as usize];
            let mut at = row.first as usize * width + column.first as usize;
            let mut most: Option<f32> = None;
            for weight in row.weights {
                if weight > SUPPORT_SHARE
                    && let Some(line) = image.get(at..at + W)
                {
                    for (&pixel, share) in line.iter().zip(column.weights) {
                        if share > SUPPORT_SHARE {
                            most = Some(most.unwrap_or(0.0).max(pixel));
                        }
                    }
                }
                at += width;
            }
            *out = most.unwrap_or(f32::INFINITY);
        }
    }

    fn retain(&mut self, keep: &[bool]) {
        for places in &mut self.places {
            let mut flags = keep.iter();
            places.retain(|_| flags.next().copied().unwrap_or(false));
        }
    }
}
