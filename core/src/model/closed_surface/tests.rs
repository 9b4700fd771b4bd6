use proptest::prelude::*;

use super::*;

type Corners = [[f64; 3]; 3];

/// A box between two corners: 12 triangles, oriented outwards.
fn cuboid(low: [f64; 3], high: [f64; 3]) -> Vec<Corners> {
    let corner = |bits: usize| {
        std::array::from_fn(|axis| if bits >> axis & 1 == 0 { low[axis] } else { high[axis] })
    };
    let faces =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    faces
        .iter()
        .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]])
        .map(|triangle| triangle.map(corner))
        .collect()
}

/// A star-shaped body around `centre_mm` with the given `radius` in each direction.
fn star(centre_mm: [f64; 3], rings: usize, radius: impl Fn(usize, usize) -> f64) -> Vec<Corners> {
    let around = 2 * rings;
    let at = |ring: usize, n: usize| -> [f64; 3] {
        let n = if ring == 0 || ring == rings { 0 } else { n % around };
        let polar = std::f64::consts::PI * ring as f64 / rings as f64;
        let angle = std::f64::consts::TAU * n as f64 / around as f64;
        let direction = [polar.sin() * angle.cos(), polar.sin() * angle.sin(), polar.cos()];
        std::array::from_fn(|c| centre_mm[c] + radius(ring, n) * direction[c])
    };
    let mut triangles = Vec::new();
    for ring in 0..rings {
        for n in 0..around {
            let [a, b] = [at(ring, n), at(ring, n + 1)];
            let [c, d] = [at(ring + 1, n), at(ring + 1, n + 1)];
            if ring > 0 {
                triangles.push([a, d, b]);
            }
            if ring + 1 < rings {
                triangles.push([a, c, d]);
            }
        }
    }
    triangles
}

/// Winding number from the sum of the triangles' solid angles (Van Oosterom and Strackee, IEEE Trans. Biomed.
/// Eng. 30, 1983), in floating point.
fn winding(triangles: &[Corners], at: [f64; 3]) -> f64 {
    let dot = |u: [f64; 3], v: [f64; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    let angles = triangles.iter().map(|corners| {
        let [a, b, c] = corners.map(|corner| std::array::from_fn(|n| corner[n] - at[n]));
        let cross =
            [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
        let [la, lb, lc] = [a, b, c].map(|v| dot(v, v).sqrt());
        let below = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
        2.0 * dot(a, cross).atan2(below)
    });
    angles.sum::<f64>() / (4.0 * std::f64::consts::PI)
}

fn grid() -> VolumeGrid {
    VolumeGrid { voxels: [17, 14, 12], voxel_mm: 0.25, centre_mm: [0.1, 0.0, -0.2] }
}

/// Number of voxels that differ from the definition by winding numbers. Voxels closer to the surface than the
/// rounding of coordinates are ignored.
fn wrong_voxels(triangles: &[Corners]) -> usize {
    let grid = grid();
    let surface = ClosedSurface::new(triangles).unwrap();
    let inside = surface.voxels_inside(&grid);
    let wrong = (0..grid.len()).filter(|&n| {
        let at: [f64; 3] = grid.centre_of(grid.indices(n as u32)).into();
        assert_eq!(inside[n], surface.contains(at), "{at:?}");
        let is_inside = |at| winding(triangles, at).round() != 0.0;
        inside[n] != is_inside(at) && {
            let beside = (0..6).map(|side| {
                let mut beside = at;
                beside[side / 2] += if side % 2 == 0 { 2.0 } else { -2.0 } * GRAIN_MM;
                beside
            });
            beside.into_iter().all(|beside| is_inside(beside) == is_inside(at))
        }
    });
    wrong.count()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn voxels_are_inside_where_the_surface_winds_around_them(
        centre in prop::array::uniform3(-0.5..0.5),
        rings in 2..7usize,
        radii in prop::collection::vec(0.3..2.0, 1..40),
    ) {
        let radius = |ring: usize, n: usize| radii[(7 * ring + n) % radii.len()];
        prop_assert_eq!(wrong_voxels(&star(centre, rings, radius)), 0);
    }

    /// Corners at the centres of voxels, so that rays meet edges and corners.
    #[test]
    fn round_numbers_leave_no_hole_and_no_ray(
        low in prop::array::uniform3(0..6usize),
        size in prop::array::uniform3(1..6usize),
    ) {
        let grid = grid();
        let at = |index: [usize; 3]| -> [f64; 3] { grid.centre_of(index).into() };
        let high = std::array::from_fn(|axis| low[axis] + size[axis]);
        let surface = ClosedSurface::new(&cuboid(at(low), at(high))).unwrap();
        let inside = surface.voxels_inside(&grid);
        for (n, inside) in (0u32..).zip(inside) {
            let ijk = grid.indices(n);
            let within = (0..3).all(|axis| (low[axis]..=high[axis]).contains(&ijk[axis]));
            let well_within = (0..3).all(|axis| low[axis] < ijk[axis] && ijk[axis] < high[axis]);
            // The result for a centre on a face is arbitrary.
            prop_assert!(if inside { within } else { !well_within }, "{:?}", ijk);
        }
    }
}

#[test]
fn bodies_that_overlap_or_are_turned_inwards_are_filled() {
    let mut both = cuboid([-1.0; 3], [0.37; 3]);
    both.extend(cuboid([-0.31; 3], [1.0; 3]));
    assert_eq!(wrong_voxels(&both), 0);
    let inwards: Vec<Corners> =
        cuboid([-1.01; 3], [0.37; 3]).into_iter().map(|[a, b, c]| [a, c, b]).collect();
    let surface = ClosedSurface::new(&inwards).unwrap();
    assert!(surface.contains([0.0; 3]) && !surface.contains([0.9; 3]));
    assert_eq!(surface.bounds_mm().map(|at| at[0].round()), [-1.0, 0.0]);
    assert!(!surface.contains([f64::NAN, 0.0, 0.0]) && !surface.contains([1e30, 0.0, 0.0]));
}

#[test]
fn a_cavity_in_a_body_is_outside() {
    let mut shell = cuboid([-1.0; 3], [1.0; 3]);
    shell.extend(cuboid([-0.4; 3], [0.4; 3]).into_iter().map(|[a, b, c]| [a, c, b]));
    let surface = ClosedSurface::new(&shell).unwrap();
    assert!(surface.contains([0.7, 0.0, 0.0]) && !surface.contains([0.1, 0.0, 0.0]));
}

#[test]
fn what_encloses_nothing_is_refused() {
    let whole = cuboid([-1.0; 3], [1.0; 3]);
    let error = ClosedSurface::new(&whole[1..]).unwrap_err();
    assert!(matches!(error, SurfaceError::Open { edges: 3, .. }), "{error}");
    assert!(error.to_string().contains("3 edges have no second triangle"), "{error}");
    let mut turned = whole.clone();
    turned[4].swap(0, 1);
    let error = ClosedSurface::new(&turned).unwrap_err();
    assert!(matches!(error, SurfaceError::Turned { edges: 3, .. }), "{error}");
    let flat = [[[0.0; 3], [0.0; 3], [1.0, 0.0, 0.0]]];
    assert_eq!(ClosedSurface::new(&flat), Err(SurfaceError::Empty));
    let mut far = whole;
    far[2][1][0] = f64::NAN;
    let error = ClosedSurface::new(&far).unwrap_err();
    assert!(matches!(error, SurfaceError::TooFar { triangle: 3, .. }), "{error}");
}

/// Corners with single-precision rounding errors, as written by other programs.
#[test]
fn corners_that_rounding_moved_apart_are_one() {
    let mut random = 1u64;
    let mut noise = || {
        random = random.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (random >> 40) as f64 / (1u64 << 24) as f64 * 2e-6 - 1e-6
    };
    // Not halfway between two multiples of the unit, where rounding could separate them.
    let rough: Vec<Corners> = cuboid([-1.0; 3], [1.0; 3])
        .into_iter()
        .map(|corners| corners.map(|corner| corner.map(|mm| mm + noise())))
        .collect();
    assert!(ClosedSurface::new(&rough).is_ok());
}
