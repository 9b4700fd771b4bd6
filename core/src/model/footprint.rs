//! The shadow of a voxel on one row of microlenses, in closed form.
//!
//! Along one axis, the ray from position ξ at object distance s through pupil coordinate U meets
//! the microlens plane at x = a U + b ξ with a = 1 − s_i/s' and b = −s_i/s (docs/theory.md,
//! sections 2 and 4). Over a pixel's pupil interval of width ΔU and a voxel of width h, x is the sum of two
//! independent uniform variables of widths |a| ΔU and |b| h: a trapezoid. The share that falls on
//! one microlens is a difference of the trapezoid's cumulative distribution, which is piecewise
//! quadratic; with [`RayMap::spread`] it is exact for a source without depth. With square microlenses and pixels, a
//! pixel's weight is the product of the shares along both axes and of the open share of its pupil cell.

use lfpiv_hw::Optics;

/// Intersection of rays of one depth with the microlens plane: x = `pupil`·U + `position`·ξ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RayMap {
    /// a = 1 − s_i/s'.
    pub pupil: f64,
    /// b = −s_i/s.
    pub position: f64,
}

impl RayMap {
    /// The map for points at `depth_mm` along the camera's axis (positive is nearer).
    pub fn at_depth(optics: &Optics, depth_mm: f64) -> Self {
        let s = optics.object_distance_mm - depth_mm;
        let s_i = optics.image_distance_mm();
        Self { pupil: 1.0 - s_i / optics.conjugate_distance_mm(s), position: -s_i / s }
    }
}

impl RayMap {
    /// 1 − a: ratio of the effective width of a microlens for the rays of a pixel to its width.
    ///
    /// The ray of a pixel point at t = (x_s − X_c) s_i/f_m through x on the microlens has U = x − t, while the
    /// first order approximates U = X_c − t. With x = a U + b ξ, x − X_c = (a (X_c − t) + b ξ − X_c)/(1 − a):
    /// the first-order offset divided by 1 − a; and dU = dt/(1 − a). First-order shadows are therefore exact
    /// along one axis if the widths of microlenses are multiplied, and shares divided, by 1 − a.
    pub fn spread(&self) -> f64 {
        1.0 - self.pupil
    }
}

/// The sum of two independent uniform variables: a symmetric trapezoid around its centre.
#[derive(Debug, Clone, Copy)]
pub struct Trapezoid {
    half_sum: f64,
    half_difference: f64,
    /// 1/(2 · product of the widths), or 0 if the narrower width is negligible.
    scale: f64,
    wide: f64,
}

/// Least width of a sum, a picometre. A point in focus illuminates one microlens, and a point on the border of
/// two is split evenly instead of by rounding.
pub const STEP_WIDTH_MM: f64 = 1e-9;

/// Ratio of the narrower to the wider width below which the narrower one is negligible.
pub const POINT_WIDTH: f64 = 1e-7;

impl Trapezoid {
    /// The sum of uniform variables of these full widths, in mm; both may be 0.
    pub fn new(width_a_mm: f64, width_b_mm: f64) -> Self {
        let wide = width_a_mm.max(width_b_mm).max(STEP_WIDTH_MM);
        let narrow = width_a_mm.min(width_b_mm);
        let scale = if narrow > POINT_WIDTH * wide { 0.5 / (wide * narrow) } else { 0.0 };
        Self {
            half_sum: (wide + narrow) / 2.0,
            half_difference: (wide - narrow) / 2.0,
            scale,
            wide,
        }
    }

    /// Full width: the sum of the two, in mm.
    pub fn width(&self) -> f64 {
        2.0 * self.half_sum
    }

    /// Probability of a value below `t`, in mm.
    pub fn below(&self, t: f64) -> f64 {
        if self.scale == 0.0 {
            return (t / self.wide + 0.5).clamp(0.0, 1.0);
        }
        let square = |t: f64| if t > 0.0 { t * t } else { 0.0 };
        let (s, d) = (self.half_sum, self.half_difference);
        // Each half is computed from its own side, to avoid cancellation of large squares.
        if t <= 0.0 {
            (square(t + s) - square(t + d)) * self.scale
        } else {
            1.0 - (square(s - t) - square(d - t)) * self.scale
        }
        .clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Compared with the definition, by midpoint sums over both variables.
        #[test]
        fn the_trapezoid_is_the_convolution_of_two_boxes(
            a in 0.0..0.3f64, b in 0.01..0.3f64, t in -0.4..0.4f64,
        ) {
            let n = 400;
            let shares = (0..n)
                .map(|m| {
                    let u = ((m as f64 + 0.5) / f64::from(n) - 0.5) * a;
                    ((t - u) / b + 0.5).clamp(0.0, 1.0)
                })
                .sum::<f64>();
            let reference = shares / f64::from(n);
            prop_assert!((Trapezoid::new(a, b).below(t) - reference).abs() < 1e-4);
        }
    }

    #[test]
    fn a_point_in_focus_is_a_clean_step() {
        for width in [0.0, 1e-17, 1e-12] {
            let step = Trapezoid::new(width, 0.0);
            assert_eq!((step.below(-1e-6), step.below(1e-6)), (0.0, 1.0));
            // Different rounding at both sides of a border must not lose or double light.
            assert!((step.below(1e-17) - step.below(-1e-17)).abs() < 1e-6);
        }
    }

    #[test]
    fn focus_has_no_parallax_and_nearer_points_are_magnified() {
        let optics = crate::test_bench::optics();
        let focus = RayMap::at_depth(&optics, 0.0);
        assert!(focus.pupil.abs() < 1e-12 && (focus.position + 1.0).abs() < 1e-12);
        let near = RayMap::at_depth(&optics, 4.0);
        assert!((near.pupil - (1.0 - 200.0 / (100.0 * 196.0 / 96.0))).abs() < 1e-12);
        assert!(near.position < -1.0);
    }
}
