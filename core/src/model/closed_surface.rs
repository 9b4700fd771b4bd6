//! Closed triangulated surfaces, and whether points are inside.
//!
//! A point is inside if its winding number is positive: a ray from the point crosses more triangles outwards than
//! inwards. Overlapping bodies are therefore united.
//!
//! Rays along the axes often meet edges and vertices exactly, because coordinates of bodies and voxels are
//! round numbers. Coordinates are therefore rounded to multiples of [`GRAIN_MM`], signs of determinants are
//! exact, and a ray that meets an edge is displaced infinitesimally (simulation of simplicity: Edelsbrunner and
//! Mücke, ACM Trans. Graph. 9, 1990). Each ray then crosses exactly one of two neighbouring triangles.

use std::collections::HashMap;

use rayon::prelude::*;
use thiserror::Error;

use super::VolumeGrid;

/// Unit of rounded coordinates, 0.06 µm. Corners that differ by rounding errors of single precision then coincide.
const GRAIN_MM: f64 = 1.0 / 16384.0;

/// Largest coordinate of a corner, in mm, for which determinants do not overflow 128 bits.
const FARTHEST_MM: f64 = 1e6;

/// A position in multiples of [`GRAIN_MM`].
type Grains = [i64; 3];

/// Reasons for which triangles do not form a closed surface.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SurfaceError {
    /// No triangle, or none with an area.
    #[error("it has no triangle with an area")]
    Empty,
    /// A coordinate is not finite or too large.
    #[error(
        "triangle {triangle} has a corner at {coordinate_mm} mm, allowed: finite numbers up to \
         {FARTHEST_MM} mm"
    )]
    TooFar {
        /// Number of the triangle in the file, from 1.
        triangle: usize,
        /// The coordinate.
        coordinate_mm: f64,
    },
    /// Edges with a triangle on one side only.
    #[error(
        "it is not closed: {edges} edges have no second triangle, the first of them at ({}) mm; \
         close the holes in the program that made it, and export it again",
        place(at_mm)
    )]
    Open {
        /// How many.
        edges: usize,
        /// The middle of one of them.
        at_mm: [f64; 3],
    },
    /// Neighbouring triangles with opposite orientations.
    #[error(
        "{edges} pairs of neighbouring triangles are turned against each other, the first of them \
         at ({}) mm; let the program that made it unify the normals, and export it again",
        place(at_mm)
    )]
    Turned {
        /// How many.
        edges: usize,
        /// The middle of one of their edges.
        at_mm: [f64; 3],
    },
}

fn place(at_mm: &[f64; 3]) -> String {
    at_mm.map(|mm| format!("{mm:.3}")).join(", ")
}

/// The surface of a body, or of several.
#[derive(Debug, Clone, PartialEq)]
pub struct ClosedSurface {
    triangles: Vec<[Grains; 3]>,
}

impl ClosedSurface {
    /// The surface of `triangles` with corners in mm, oriented all outwards or all inwards.
    ///
    /// # Errors
    /// [`SurfaceError`]: the triangles are not closed, or their orientations are inconsistent.
    pub fn new(triangles: &[[[f64; 3]; 3]]) -> Result<Self, SurfaceError> {
        let mut kept = Vec::with_capacity(triangles.len());
        for (number, corners) in (1..).zip(triangles) {
            for &coordinate_mm in corners.as_flattened() {
                if coordinate_mm.is_nan() || coordinate_mm.abs() > FARTHEST_MM {
                    return Err(SurfaceError::TooFar { triangle: number, coordinate_mm });
                }
            }
            let [a, b, c] = corners.map(grains);
            // Triangles that rounding makes degenerate do not contribute.
            if a != b && b != c && c != a {
                kept.push([a, b, c]);
            }
        }
        if kept.is_empty() {
            return Err(SurfaceError::Empty);
        }
        check_edges(&kept)?;
        Ok(Self { triangles: kept })
    }

    /// Number of triangles.
    pub fn len(&self) -> usize {
        self.triangles.len()
    }

    /// Whether there is no triangle; always `false`.
    pub fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    /// Lowest and highest corner of the box around it, in mm.
    pub fn bounds_mm(&self) -> [[f64; 3]; 2] {
        let corners = || self.triangles.as_flattened().iter();
        let along = |axis: usize| corners().map(move |corner| corner[axis]);
        let low = std::array::from_fn(|axis| along(axis).min().unwrap_or_default());
        let high = std::array::from_fn(|axis| along(axis).max().unwrap_or_default());
        [low, high].map(in_mm)
    }

    /// Whether a position (mm) is inside. The result on the surface itself is arbitrary.
    pub fn contains(&self, at_mm: [f64; 3]) -> bool {
        if at_mm.iter().any(|mm| mm.is_nan() || mm.abs() > FARTHEST_MM) {
            return false;
        }
        let at = grains(at_mm);
        let winding: i64 = self
            .triangles
            .iter()
            .filter_map(|triangle| {
                let orientation = orientation_about(triangle, [at[1], at[2]])?;
                is_ahead(triangle, at).then_some(orientation)
            })
            .sum();
        winding != 0
    }

    /// Whether the centre of each voxel of `grid` is inside, in the order z, y, x.
    pub fn voxels_inside(&self, grid: &VolumeGrid) -> Vec<bool> {
        let [nx, ny, nz] = grid.voxels;
        let centres: [Vec<i64>; 3] = std::array::from_fn(|axis| {
            (0..grid.voxels[axis]).map(|n| grain(grid.coordinate_mm(axis, n as f64))).collect()
        });
        let [xs, ys, zs] = &centres;
        let mut inside = vec![false; nx * ny * nz];
        inside.par_chunks_mut((nx * ny).max(1)).zip(zs).for_each(|(layer, &z)| {
            // Changes of the winding number along each row of voxels.
            let mut changes = vec![0i64; (nx + 1) * ny];
            for triangle in self.triangles.iter().filter(|triangle| spans(triangle, 2, z)) {
                for (row, &y) in changes.chunks_mut(nx + 1).zip(ys) {
                    if let Some(orientation) = orientation_about(triangle, [y, z]) {
                        let ahead = xs.partition_point(|&x| is_ahead(triangle, [x, y, z]));
                        row[ahead] += orientation;
                    }
                }
            }
            for (row, changes) in layer.chunks_mut(nx.max(1)).zip(changes.chunks(nx + 1)) {
                let mut winding = changes[nx];
                for (voxel, change) in row.iter_mut().zip(changes).rev() {
                    *voxel = winding != 0;
                    winding += change;
                }
            }
        });
        inside
    }
}

fn grain(mm: f64) -> i64 {
    (mm / GRAIN_MM).round() as i64
}

fn grains(at_mm: [f64; 3]) -> Grains {
    at_mm.map(grain)
}

fn in_mm(at: Grains) -> [f64; 3] {
    at.map(|grains| grains as f64 * GRAIN_MM)
}

/// Checks that every edge occurs equally often in both directions.
fn check_edges(triangles: &[[Grains; 3]]) -> Result<(), SurfaceError> {
    let mut passed: HashMap<[Grains; 2], i64> = HashMap::new();
    for corners in triangles {
        for n in 0..3 {
            let (from, to) = (corners[n], corners[(n + 1) % 3]);
            let (edge, direction) = if from < to { ([from, to], 1) } else { ([to, from], -1) };
            *passed.entry(edge).or_default() += direction;
        }
    }
    passed.retain(|_, sum| *sum != 0);
    let middle_mm = |[from, to]: [Grains; 2]| {
        let [from, to] = [from, to].map(in_mm);
        std::array::from_fn(|axis| (from[axis] + to[axis]) / 2.0)
    };
    let which = |odd: bool| {
        let edges = passed.iter().filter(move |(_, sum)| (*sum % 2 != 0) == odd);
        edges.map(|(edge, _)| *edge)
    };
    if let Some(first) = which(true).min() {
        return Err(SurfaceError::Open { edges: which(true).count(), at_mm: middle_mm(first) });
    }
    match which(false).min() {
        Some(first) => {
            Err(SurfaceError::Turned { edges: which(false).count(), at_mm: middle_mm(first) })
        }
        None => Ok(()),
    }
}

/// Whether the range of a triangle along an axis contains `at`.
fn spans(triangle: &[Grains; 3], axis: usize, at: i64) -> bool {
    let along = triangle.map(|corner| corner[axis]);
    let low = along[0].min(along[1]).min(along[2]);
    let high = along[0].max(along[1]).max(along[2]);
    (low..=high).contains(&at)
}

/// Orientation, 1 or −1, of the triangle's projection along x if it covers the position (y, z); otherwise `None`.
fn orientation_about(triangle: &[Grains; 3], at: [i64; 2]) -> Option<i64> {
    if !spans(triangle, 1, at[0]) || !spans(triangle, 2, at[1]) {
        return None;
    }
    let corners = triangle.map(|[_, y, z]| [y, z]);
    let turns = [0, 1, 2].map(|n| orientation(corners[n], corners[(n + 1) % 3], at));
    (turns[0] != 0 && turns[0] == turns[1] && turns[1] == turns[2]).then_some(turns[0])
}

/// Sign of the determinant of `a`, `b` and a position infinitesimally beyond `at`, along the first axis more than
/// along the second; 0 if `a` equals `b`. It is antisymmetric in `a` and `b`.
fn orientation(a: [i64; 2], b: [i64; 2], at: [i64; 2]) -> i64 {
    let [along, up] = [0, 1].map(|axis| i128::from(b[axis] - a[axis]));
    let area = along * i128::from(at[1] - a[1]) - up * i128::from(at[0] - a[0]);
    let sign = if area != 0 {
        area.signum()
    } else if up != 0 {
        -up.signum()
    } else {
        along.signum()
    };
    sign as i64
}

/// Whether a position is before the plane of a triangle along x. The triangle covers its y and z.
fn is_ahead(triangle: &[Grains; 3], at: Grains) -> bool {
    let [a, b, c] = *triangle;
    let from_a = |to: Grains| -> [i128; 3] { std::array::from_fn(|n| i128::from(to[n] - a[n])) };
    let (b, c, at) = (from_a(b), from_a(c), from_a(at));
    let normal = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
    let above: i128 = normal.iter().zip(at).map(|(normal, at)| normal * at).sum();
    above.signum() * normal[0].signum() < 0
}

#[cfg(test)]
mod tests;
