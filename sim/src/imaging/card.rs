//! Images of a calibration card, by rays traced from pixels back to the card.
//!
//! A card fills thousands of micro-images, so light is traced backwards, as in a white image: from
//! every microlens through the whole stop. To find where such a ray leaves the card, points of the
//! card are traced forwards to the microlens plane and the inverse relation is fitted by
//! polynomials.

use lfpiv_hw::card::Card;
use nalgebra::{DMatrix, Matrix5, Point3, Vector3};

use super::{
    ElectronImage, RayTracer,
    main_lens::RayBundle,
    wall::{KNOTS, knots},
};

/// Light of bright and dark areas, as integers; no area is black.
const BRIGHT: u32 = 20;
const DARK: u32 = 1;

/// Degree of the polynomials on the microlens plane; the error on the card is below 1e-5 mm.
const DEGREE: usize = 7;

/// Points traced along each axis of the card.
const POINTS: usize = 14;

/// A card at one position, with its deviation from a plane.
#[derive(Debug, Clone)]
pub struct PlacedCard<'a> {
    /// The card's pattern.
    pub card: &'a Card,
    /// Position of mark (0, 0), in mm.
    pub origin_mm: Point3<f64>,
    /// Root-mean-square deviations of the face from its plane, in mm, for three shapes of second
    /// degree: bent along the marks' first index, twisted, bent along the second index.
    pub bend_mm: [f64; 3],
}

impl PlacedCard<'_> {
    /// World position of a point on the face that is turned towards `axis`, in mm.
    fn place_mm(&self, along_mm: [f64; 2], axis: &Vector3<f64>) -> Point3<f64> {
        let half_mm = self.half_mm();
        let [a, b] = [along_mm[0] / half_mm[0], along_mm[1] / half_mm[1]];
        // Over the square, (a² − 1/3)² is 4/45 and (a b)² is 1/9 on average.
        let bend = |a: f64| (a * a - 1.0 / 3.0) * (45.0f64 / 4.0).sqrt();
        let shapes = [bend(a), 3.0 * a * b, bend(b)];
        let off_mm: f64 = shapes.iter().zip(self.bend_mm).map(|(shape, mm)| shape * mm).sum();
        self.card.place_mm(&self.origin_mm, along_mm, axis) + self.card.normal() * off_mm
    }

    /// Half the card's edges, which are one spacing beyond the outermost marks.
    fn half_mm(&self) -> [f64; 2] {
        self.card.marks.map(|count| (count as f64 + 1.0) / 2.0 * self.card.spacing_mm)
    }
}

/// Relation between rays and card points: for every knot of the stop, polynomials of the position
/// on the microlens plane for both coordinates on the card.
struct FaceSeen {
    /// Scale of positions on the microlens plane, in mm.
    scale_mm: f64,
    /// Coefficients for both coordinates, by knot along u and knot along v.
    terms: Vec<DMatrix<f64>>,
    to_coefficients: Matrix5<f64>,
    per_stop_radius: f64,
}

/// The rays of one microlens: polynomials of the position on the stop, with derivatives along x and
/// y.
struct LensRays {
    centre_mm: [f64; 2],
    per_stop_radius: f64,
    /// For both coordinates on the card: value, derivative along x, derivative along y.
    terms: [[Matrix5<f64>; 3]; 2],
}

impl RayTracer<'_> {
    /// The image of an illuminated card, exposed so that the brightest pixel collects
    /// `brightest_electrons`; other arguments as in [`Self::trace_white`]. `None` if the camera
    /// cannot see the whole card because it touches the wall or the lens.
    pub fn trace_card(
        &self,
        placed: &PlacedCard<'_>,
        rays: usize,
        brightest_electrons: f64,
        stream: &[u64],
    ) -> Option<ElectronImage> {
        let seen = self.face_seen(placed)?;
        let card = placed.card;
        let light_on = |lens: [usize; 2]| {
            let centre_mm = self.detector.microlenses().place_mm(lens.map(|n| n as f64));
            let rays = seen.at_lens(centre_mm);
            move |plane_mm: [f64; 2], stop_mm: [f64; 2]| {
                if card.is_bright(rays.along_mm(plane_mm, stop_mm)) { BRIGHT } else { DARK }
            }
        };
        Some(self.trace_lit(rays, brightest_electrons, stream, light_on))
    }

    fn face_seen(&self, placed: &PlacedCard<'_>) -> Option<FaceSeen> {
        let [knots_mm, relative] = knots(self.lens.stop_radius_mm);
        let half_mm = placed.half_mm();
        let node = |n: usize| ((n as f64 + 0.5) / POINTS as f64 * std::f64::consts::PI).cos();
        let along_mm: Vec<[f64; 2]> = (0..POINTS * POINTS)
            .map(|n| [node(n % POINTS) * half_mm[0], node(n / POINTS) * half_mm[1]])
            .collect();
        let bundles = along_mm
            .iter()
            .map(|&along| self.bundle(placed.place_mm(along, &self.pose.axis).coords.into()))
            .collect::<Option<Vec<_>>>()?;
        let met: Vec<Vec<[f64; 2]>> = (0..KNOTS * KNOTS)
            .map(|knot| {
                let stop_mm = [knots_mm[knot / KNOTS], knots_mm[knot % KNOTS]];
                bundles.iter().map(|bundle| bundle.on_microlenses_mm(stop_mm)).collect()
            })
            .collect();
        let scale_mm = met.iter().flatten().flatten().fold(1e-6, |most: f64, x| most.max(x.abs()));
        let places = DMatrix::from_fn(along_mm.len(), 2, |row, axis| along_mm[row][axis]);
        let fitted = |met: &Vec<[f64; 2]>| {
            let rows: Vec<Vec<f64>> =
                met.iter().map(|place| monomials(place.map(|x| x / scale_mm))).collect();
            let matrix = DMatrix::from_fn(rows.len(), rows[0].len(), |row, term| rows[row][term]);
            let qr = matrix.qr();
            qr.r().solve_upper_triangular(&qr.q().tr_mul(&places))
        };
        Some(FaceSeen {
            scale_mm,
            terms: met.iter().map(fitted).collect::<Option<_>>()?,
            to_coefficients: Matrix5::from_fn(|knot, power| relative[knot].powi(power as i32))
                .try_inverse()?,
            per_stop_radius: 1.0 / self.lens.stop_radius_mm,
        })
    }
}

/// x^i y^j with i + j up to [`DEGREE`].
fn monomials([x, y]: [f64; 2]) -> Vec<f64> {
    exponents().map(|[i, j]| x.powi(i) * y.powi(j)).collect()
}

fn exponents() -> impl Iterator<Item = [i32; 2]> {
    (0..=DEGREE as i32).flat_map(|i| (0..=DEGREE as i32 - i).map(move |j| [i, j]))
}

impl FaceSeen {
    fn at_lens(&self, centre_mm: [f64; 2]) -> LensRays {
        let [x, y] = centre_mm.map(|place_mm| place_mm / self.scale_mm);
        let value = monomials([x, y]);
        let power = |base: f64, exponent: i32| {
            if exponent > 0 { f64::from(exponent) * base.powi(exponent - 1) } else { 0.0 }
        };
        let by_x: Vec<f64> =
            exponents().map(|[i, j]| power(x, i) * y.powi(j) / self.scale_mm).collect();
        let by_y: Vec<f64> =
            exponents().map(|[i, j]| x.powi(i) * power(y, j) / self.scale_mm).collect();
        let terms = std::array::from_fn(|coordinate| {
            [&value, &by_x, &by_y].map(|powers| {
                let at_knots = Matrix5::from_fn(|u, v| {
                    let terms = self.terms[u * KNOTS + v].column(coordinate);
                    terms.iter().zip(powers).map(|(term, power)| term * power).sum::<f64>()
                });
                self.to_coefficients * at_knots * self.to_coefficients.transpose()
            })
        });
        LensRays { centre_mm, per_stop_radius: self.per_stop_radius, terms }
    }
}

impl LensRays {
    /// Point of the card, in mm along its `right` and `up`, of the ray through given positions on
    /// the microlens plane and the stop. Within a microlens it depends linearly on the position.
    #[inline]
    fn along_mm(&self, plane_mm: [f64; 2], stop_mm: [f64; 2]) -> [f64; 2] {
        let [u, v] = stop_mm.map(|place_mm| place_mm * self.per_stop_radius);
        let [x, y] = [plane_mm[0] - self.centre_mm[0], plane_mm[1] - self.centre_mm[1]];
        std::array::from_fn(|coordinate| {
            let [value, by_x, by_y] = &self.terms[coordinate];
            // Refraction has no terms above the fourth total degree.
            (0..KNOTS).rev().fold(0.0, |sum, i| {
                let inner = (0..KNOTS - i).rev().fold(0.0, |inner, j| {
                    inner * v + value[(i, j)] + x * by_x[(i, j)] + y * by_y[(i, j)]
                });
                sum * u + inner
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use lfpiv_hw::card::Pattern;

    use super::*;
    use crate::{
        imaging::{CameraFlaws, Distortion, RaySettings, WallSettings},
        test_bench::{optics, poses},
    };

    fn card() -> Card {
        let half = 0.5f64.sqrt();
        Card {
            pattern: Pattern::Dots,
            spacing_mm: 1.0,
            dot_diameter_mm: 0.5,
            fiducial_diameter_mm: 0.7,
            marks: [11, 11],
            right: Vector3::x(),
            up: Vector3::new(0.0, half, -half),
            two_sided_mm: None,
        }
    }

    /// A ray traced forwards from the card is traced back to its origin.
    #[test]
    fn rays_are_traced_back_to_their_origin() {
        let (optics, card) = (optics(), card());
        let flaws = CameraFlaws {
            turn_deg: [0.3, -0.2, 0.4],
            array_rotation_deg: 0.5,
            distortion: Distortion { radial: 0.005, tangential: [3e-4, -2e-4] },
            exit_pupil_mm: 30.0,
            wall: Some(WallSettings { tilt_deg: [5.0, 0.0], ..WallSettings::default() }),
            ..CameraFlaws::default()
        };
        let settings = RaySettings { rays_per_particle: 1, diffraction_nm: None };
        let placed = PlacedCard {
            card: &card,
            origin_mm: Point3::new(0.2, 1.5, 1.4),
            bend_mm: [0.005, -0.003, 0.002],
        };
        for pose in poses() {
            let tracer = RayTracer::imperfect(&optics, &pose, [0.1, -0.1, 0.2], &flaws, &settings);
            let seen = tracer.face_seen(&placed).unwrap();
            let mut worst_mm = 0.0f64;
            for n in 0..625 {
                let on = |n: usize, most: f64| (n as f64 / 2.0 - 1.0) * most;
                let along_mm = [on(n % 5, 5.0), on(n / 5 % 5, 5.0)];
                let stop_mm = [on(n / 25 % 5, 7.0), on(n / 125, 7.0)];
                let point_mm = placed.place_mm(along_mm, &pose.axis);
                let plane_mm = tracer.on_microlenses_mm(point_mm.into(), stop_mm).unwrap();
                let back_mm = seen
                    .at_lens([plane_mm[0] - 0.04, plane_mm[1] + 0.03])
                    .along_mm(plane_mm, stop_mm);
                for axis in 0..2 {
                    worst_mm = worst_mm.max((back_mm[axis] - along_mm[axis]).abs());
                }
            }
            assert!(worst_mm < 1e-4, "{worst_mm}");
        }
    }

    #[test]
    fn a_card_beyond_the_wall_is_not_seen() {
        let (optics, card) = (optics(), card());
        let flaws = CameraFlaws { wall: Some(WallSettings::default()), ..CameraFlaws::default() };
        let settings = RaySettings { rays_per_particle: 1, diffraction_nm: None };
        let tracer = RayTracer::imperfect(&optics, &poses()[0], [0.0; 3], &flaws, &settings);
        let placed =
            PlacedCard { card: &card, origin_mm: Point3::new(0.0, 0.0, 28.0), bend_mm: [0.0; 3] };
        assert!(tracer.trace_card(&placed, 1, 100.0, &[1]).is_none());
    }
}
