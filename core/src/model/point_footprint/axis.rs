//! Shares of a point's light on the pixels behind one microlens, along one axis.
//!
//! A ray of a point meets the microlens plane at D + a U from the middle of a microlens, where D is the offset
//! of the ray through the pupil's middle (docs/theory.md, section 2). The microlens transmits rays with |D + a
//! U| below half its width, which is an interval of the pupil. A pixel edge at T for the ray through the
//! microlens' middle corresponds to U = (T + D)/(1 − a) (`footprint::RayMap::spread`). A pixel is therefore
//! another interval, and its share is the intersection of both. With G(P), the part of the microlens' interval
//! [A, B] beyond P,
//!
//! G(P) = r(B − P) − r(A − P), r(t) = max(t, 0),
//!
//! a pixel's share is the difference of G at its two edges. Blur makes the distance between the ends of both
//! intervals random: r is replaced by its mean over the density of the distance. An Epanechnikov density gives
//! a polynomial.

use super::LANES;

type Lanes = [f64; LANES];

/// Blur of a point's image, as standard deviations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointBlur {
    /// On the microlens plane, in mm: the particle's own size, diffraction and aberrations of the main lens.
    pub plane_mm: f64,
    /// On the sensor, in pixels: diffraction at the microlens, crosstalk of pixels.
    pub sensor_px: f64,
}

/// Index of each lane.
const LANE_NUMBERS: Lanes = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];

/// Half width of the Epanechnikov density divided by its standard deviation.
const HALF_WIDTH: f64 = 2.236_067_977_499_79;

/// Least |a|, to avoid a division by zero for points in focus: rays through the bench's pupil are then 0.1 µm
/// apart.
const LEAST_PARALLAX: f64 = 1e-5;

/// A point before one row of microlenses.
#[derive(Debug, Clone, Copy)]
pub struct AxisPoint {
    /// a of x = D + a U.
    pub parallax: f64,
    /// Half the width of a microlens, in mm.
    pub half_lens_mm: f64,
    /// Width of a pupil cell, in mm.
    pub cell_mm: f64,
    /// Blur of the image.
    pub blur: PointBlur,
}

/// Parameters common to a row of microlenses for one point.
#[derive(Debug, Clone, Copy)]
pub struct AxisShares {
    point: AxisPoint,
    /// a, not zero.
    parallax: f64,
    /// Half width of the density of the ends' distance, in mm on the pupil.
    half_mm: f64,
    /// Its derivative with respect to a.
    half_by_parallax: f64,
}

impl AxisShares {
    /// For a point with blur.
    pub fn new(point: AxisPoint) -> Self {
        let parallax = if point.parallax.abs() < LEAST_PARALLAX {
            LEAST_PARALLAX.copysign(point.parallax)
        } else {
            point.parallax
        };
        let plane_mm = HALF_WIDTH * point.blur.plane_mm / parallax;
        let sensor_mm = HALF_WIDTH * point.blur.sensor_px * point.cell_mm;
        let half_mm = plane_mm.hypot(sensor_mm).max(1e-6);
        let half_by_parallax = -plane_mm * plane_mm / (parallax * half_mm);
        Self { point, parallax, half_mm, half_by_parallax }
    }

    /// Width of a pixel's interval on the pupil, in mm.
    pub fn cell_mm(&self) -> f64 {
        self.point.cell_mm
    }

    /// The pupil interval of a microlens at `offset_mm` (D), widened by the blur.
    pub fn interval_mm(&self, offset_mm: f64) -> [f64; 2] {
        let [low, high] = self.ends_mm(offset_mm);
        [low - self.half_mm, high + self.half_mm]
    }

    fn ends_mm(&self, offset_mm: f64) -> [f64; 2] {
        let half = self.point.half_lens_mm.copysign(self.parallax);
        [(-half - offset_mm) / self.parallax, (half - offset_mm) / self.parallax]
    }

    /// T of the pixel edge that corresponds to the pupil coordinate `pupil_mm`.
    pub fn edge_at(&self, pupil_mm: f64, offset_mm: f64) -> f64 {
        pupil_mm * (1.0 - self.parallax) - offset_mm
    }

    /// [`Share`] at several pixel edges: values and, if requested, derivatives.
    #[inline(always)]
    fn beyond_edges<const DERIVED: bool>(&self, edges_mm: &Lanes, offset_mm: f64) -> [Lanes; 3] {
        let per_spread = 1.0 / (1.0 - self.parallax);
        let (per_half, per_parallax) = (1.0 / self.half_mm, 1.0 / self.parallax);
        let per_cell = 1.0 / self.point.cell_mm;
        let by_offset = (-per_parallax - per_spread) * per_cell;
        let pupil_mm = edges_mm.map(|edge_mm| (edge_mm + offset_mm) * per_spread);
        let mut shares = [[0.0; LANES]; 3];
        for (end, sign) in self.ends_mm(offset_mm).into_iter().zip([-1.0, 1.0]) {
            let by_parallax = -end * per_parallax;
            for n in 0..LANES {
                let ramp = Ramp::at((end - pupil_mm[n]) * per_half);
                shares[0][n] += sign * self.half_mm * per_cell * ramp.value;
                if DERIVED {
                    shares[1][n] += sign * by_offset * ramp.step;
                    let of_end = ramp.step * (by_parallax - pupil_mm[n] * per_spread);
                    let of_width = ramp.by_width * self.half_by_parallax;
                    shares[2][n] += sign * per_cell * (of_end + of_width);
                }
            }
        }
        shares
    }

    /// Appends the shares of the pixels between consecutive edges to `all`, padded with zeros to a multiple of
    /// [`LANES`]: values and, if requested, derivatives.
    #[inline(always)]
    pub fn add_shares<const DERIVED: bool>(&self, edges: &PixelEdges, all: &mut [Vec<f32>; 3]) {
        let kinds = if DERIVED { 3 } else { 1 };
        let start = all[0].len();
        let end = start + edges.pixels.next_multiple_of(LANES);
        // Complete vectors are written, the last one beyond the end.
        for all in &mut all[..kinds] {
            all.resize(end + LANES, 0.0);
        }
        // The part beyond an edge decreases with the pupil coordinate.
        let sign = -edges.step_mm.signum();
        // n edges enclose n - 1 pixels.
        for first in (0..edges.pixels).step_by(LANES - 1) {
            let at_mm = LANE_NUMBERS.map(|n| edges.first_mm + (first as f64 + n) * edges.step_mm);
            let beyond = self.beyond_edges::<DERIVED>(&at_mm, edges.offset_mm);
            for kind in 0..kinds {
                let shares = &mut all[kind][start + first..][..LANES];
                for n in 0..LANES - 1 {
                    shares[n] = (sign * (beyond[kind][n + 1] - beyond[kind][n])) as f32;
                }
            }
        }
        for all in &mut all[..kinds] {
            all.truncate(end);
            all[start + edges.pixels..].fill(0.0);
        }
    }
}

/// Edges of consecutive pixels behind one microlens.
#[derive(Debug, Clone, Copy)]
pub struct PixelEdges {
    /// T of the first edge.
    pub first_mm: f64,
    /// Step between edges; negative if the pupil coordinate decreases with the pixel index.
    pub step_mm: f64,
    /// Number of pixels, one less than that of edges.
    pub pixels: usize,
    /// D of the microlens.
    pub offset_mm: f64,
}

/// max(t, 0) averaged over the Epanechnikov density 3/4 (1 − s²) of half width 1. For the half width h it is
/// h `value`(t/h), with the derivatives `step` with respect to t and `by_width` with respect to h.
#[derive(Debug, Clone, Copy)]
struct Ramp {
    value: f64,
    step: f64,
    by_width: f64,
}

impl Ramp {
    #[inline(always)]
    fn at(s: f64) -> Self {
        let c = s.clamp(-1.0, 1.0);
        let square = c * c;
        let rest = 1.0 - square;
        Self {
            value: 0.1875 + c * 0.5 + square * (0.375 - 0.0625 * square) + (s - 1.0).max(0.0),
            step: 0.5 + c * (0.75 - 0.25 * square),
            by_width: 0.1875 * rest * rest,
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn shares(parallax: f64, blur: PointBlur) -> AxisShares {
        AxisShares::new(AxisPoint { parallax, half_lens_mm: 0.05, cell_mm: 1.375, blur })
    }

    /// A share and its derivatives, in pupil cells and pupil cells per mm.
    #[derive(Debug, Clone, Copy, Default, PartialEq)]
    pub struct Share {
        /// Share in pupil cells.
        pub value: f64,
        /// Derivative with respect to D, per mm.
        pub by_offset: f64,
        /// Derivative with respect to a.
        pub by_parallax: f64,
    }

    /// The share of the pixel from `edge_mm` on.
    fn pixel_share(axis: &AxisShares, edge_mm: f64, offset_mm: f64) -> Share {
        let [one, other] = [edge_mm, edge_mm + 1.375].map(|edge_mm| {
            let [value, by_offset, by_parallax] =
                axis.beyond_edges::<true>(&[edge_mm; LANES], offset_mm).map(|lanes| lanes[0]);
            Share { value, by_offset, by_parallax }
        });
        Share {
            value: one.value - other.value,
            by_offset: one.by_offset - other.by_offset,
            by_parallax: one.by_parallax - other.by_parallax,
        }
    }

    /// Reference: summation of single rays through the pupil, blurred on the microlens plane and on the sensor.
    fn traced(parallax: f64, offset_mm: f64, edges_mm: [f64; 2], blur: PointBlur) -> f64 {
        let steps = 24;
        let density = |n: i32| {
            let s = (f64::from(n) + 0.5) / f64::from(steps) * 2.0 - 1.0;
            (s, 0.75 * (1.0 - s * s) * 2.0 / f64::from(steps))
        };
        let shares = shares(parallax, blur);
        let rays = 20_000;
        let pupil_mm = |ray: i32| (f64::from(ray) + 0.5) / f64::from(rays) * 60.0 - 30.0;
        let mut sum = 0.0;
        for ray in 0..rays {
            let pupil_mm = pupil_mm(ray);
            for n in 0..steps {
                // The blur moves the ends of the microlens' interval, not those of the pixel's.
                let (shift, weight) = density(n);
                let moved_mm = pupil_mm - shift * shares.half_mm;
                let taken = (offset_mm + parallax * moved_mm).abs() < 0.05;
                let edge_mm = shares.edge_at(pupil_mm, offset_mm);
                if taken && edge_mm >= edges_mm[0] && edge_mm < edges_mm[1] {
                    sum += weight;
                }
            }
        }
        sum * 60.0 / f64::from(rays) / 1.375
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        #[test]
        fn a_share_is_what_traced_rays_leave(
            parallax in 0.003..0.03f64, negative: bool, offset in -0.2..0.2f64, edge in -8.0..8.0f64,
            plane in 0.0..0.005f64, sensor in 0.0..0.7f64,
        ) {
            let parallax = if negative { -parallax } else { parallax };
            let blur = PointBlur { plane_mm: plane, sensor_px: sensor };
            let axis = shares(parallax, blur);
            let value = pixel_share(&axis, edge, offset).value;
            let reference = traced(parallax, offset, [edge, edge + 1.375], blur);
            prop_assert!((value - reference).abs() < 4e-3, "{value} {reference}");
        }

        #[test]
        fn derivatives_are_those_of_small_steps(
            parallax in 1e-4..0.03f64, negative: bool, offset in -0.2..0.2f64, edge in -8.0..8.0f64,
            plane in 0.001..0.005f64, sensor in 0.1..0.7f64,
        ) {
            let parallax = if negative { -parallax } else { parallax };
            let blur = PointBlur { plane_mm: plane, sensor_px: sensor };
            let pixel = |parallax: f64, offset: f64| {
                pixel_share(&shares(parallax, blur), edge, offset)
            };
            let here = pixel(parallax, offset);
            let (by_d, by_a) = (1e-7, 1e-4 * parallax.abs());
            let offset_slope =
                (pixel(parallax, offset + by_d).value - pixel(parallax, offset - by_d).value) / (2.0 * by_d);
            let parallax_slope =
                (pixel(parallax + by_a, offset).value - pixel(parallax - by_a, offset).value) / (2.0 * by_a);
            let close = |a: f64, b: f64, unit: f64| (a - b).abs() < 1e-3 * (a.abs() + unit);
            prop_assert!(close(here.by_offset, offset_slope, 10.0), "{here:?} {offset_slope}");
            prop_assert!(close(here.by_parallax, parallax_slope, 100.0), "{here:?} {parallax_slope}");
        }
    }

    proptest! {
        /// Shares are the differences between values at the pixels' edges, for both signs of the step.
        #[test]
        fn shares_of_consecutive_pixels_are_those_of_each(
            parallax in 1e-4..0.03f64, offset in -0.2..0.2f64, first in -9.0..0.0f64, pixels in 1..20usize,
            downwards: bool,
        ) {
            let axis = shares(parallax, PointBlur { plane_mm: 2e-3, sensor_px: 0.4 });
            let step_mm = if downwards { -1.375 } else { 1.375 };
            let first_mm = if downwards { -first } else { first };
            let edges = PixelEdges { first_mm, step_mm, pixels, offset_mm: offset };
            let (mut all, mut values): ([Vec<f32>; 3], [Vec<f32>; 3]) = Default::default();
            axis.add_shares::<true>(&edges, &mut all);
            axis.add_shares::<false>(&edges, &mut values);
            prop_assert_eq!(&all[0], &values[0]);
            prop_assert_eq!(all[0].len(), pixels.next_multiple_of(LANES));
            for (n, value) in all[0].iter().enumerate() {
                let edge_mm = first_mm + n as f64 * step_mm;
                let low_mm = if downwards { edge_mm - 1.375 } else { edge_mm };
                let expected = pixel_share(&axis, low_mm, offset);
                let [by_offset, by_parallax] = [1, 2].map(|kind| all[kind][n]);
                if n < pixels {
                    prop_assert!((f64::from(*value) - expected.value).abs() < 1e-6);
                    let close = |a: f32, b: f64| (f64::from(a) - b).abs() < 1e-5 * (1.0 + b.abs());
                    prop_assert!(close(by_offset, expected.by_offset));
                    prop_assert!(close(by_parallax, expected.by_parallax));
                } else {
                    prop_assert_eq!([*value, by_offset, by_parallax], [0.0; 3]);
                }
            }
        }
    }

    #[test]
    fn a_point_in_focus_lights_its_microlens_alone() {
        let axis = shares(0.0, PointBlur { plane_mm: 1e-4, sensor_px: 0.1 });
        let pixel = |offset| pixel_share(&axis, 2.0, offset).value;
        // The least parallax causes an error of 1e-5. At the microlens' edge the blur extends over the pupil.
        assert!((pixel(0.0) - 1.0).abs() < 1e-4 && (pixel(0.049) - 1.0).abs() < 1e-4);
        assert!((pixel(0.05) - 0.5).abs() < 0.15 && pixel(0.051).abs() < 1e-6);
    }
}
