//! Calibration of the field's uncertainty by cross-validation residuals.

use super::{
    super::{layout::Layout, nodes::Nodes},
    Sample,
    field::SplineField,
};

/// Least number of nodes on either side whose samples count for the local factor.
const LEAST_REACH: usize = 2;

/// Least average number of samples within reach of a node.
const LEAST_WITHIN_REACH: f32 = 15.0;

/// Weight of the global factor in each local estimate, as a number of samples.
const GLOBAL_WEIGHT: f32 = 10.0;

/// Residuals are clipped at this many standard deviations: larger ones may be outliers.
const CLIP_SIGMA: f32 = 2.5;

/// Mean square of normal residuals of standard deviation 1 that are clipped at [`CLIP_SIGMA`]:
/// erf(c/√2) − c √(2/π) exp(−c²/2) + c² (1 − erf(c/√2)) with c = 2.5 (Huber's proposal 2, Ann. Math. Stat. 35, 1964).
const CLIPPED_MEAN_SQUARE: f32 = 0.9776;

/// Least distance of a sample that counts from the faces of the box around all samples, in mean particle spacings. The
/// field at a left-out sample nearer to a face is extrapolated, and misses it by more than it misses the flow at the
/// vectors (docs/decisions.md).
const MARGIN: f32 = 0.7;

/// Largest such distance, relative to the box's edge: in a thin sheet of light most samples are near a face.
const LARGEST_MARGIN: f32 = 0.125;

/// Share of the samples' noise in the variance of the field. The rest is due to third differences that the penalty
/// allows; it is not an error where the flow has none. In three dimensions each is half:
/// ∫ω²(1 + ω⁶)⁻² dω over ∫ω²(1 + ω⁶)⁻¹ dω (spectrum of a smoothing spline: Wahba, J. R. Stat. Soc. B 45, 1983).
const NOISE_SHARE: f32 = 0.5;

/// Weight of the prior for the factors ([`NOISE_SHARE`] for the field, 1 for samples), in units of √n for n samples
/// (docs/decisions.md). Its influence decreases with n in proportion to the standard error of the estimate.
const PRIOR_WEIGHT_ROOTS: f32 = 4.0;

/// Limits of the factors on a variance.
const LIMITS: [f32; 2] = [0.01, 100.0];

/// Steps of Fisher scoring: global, and local.
const STEPS: [usize; 2] = [20, 6];

/// Cross-validation residual of a sample, and the variances that explain it.
struct Missed {
    node: usize,
    off: f32,
    own_variance: f32,
    field_variance: f32,
}

/// Factors on the variances of samples and field.
#[derive(Debug, Clone, Copy)]
struct Factors {
    own: f32,
    field: f32,
}

impl Missed {
    /// The field's share of the variance, and the clipped squared residual divided by its expected value, minus 1.
    /// For residuals that are not clipped, their product is the derivative of twice the log-likelihood with respect to
    /// the logarithm of the field's factor.
    fn share_and_surplus(&self, factors: Factors) -> (f32, f32) {
        let field = factors.field * self.field_variance;
        let variance = factors.own * self.own_variance + field;
        let square = (self.off * self.off / variance).min(CLIP_SIGMA * CLIP_SIGMA);
        (field / variance, square / CLIPPED_MEAN_SQUARE - 1.0)
    }
}

/// Factors on the field's variance at each coefficient's position, along x, y, z, from the cross-validation
/// residuals `missed`; `variance` is that of component c of sample n.
pub fn widening(
    nodes: &Nodes,
    field: &SplineField,
    samples: &[Sample],
    missed: &[[f32; 3]],
    variance: impl Fn(usize, usize) -> f32,
) -> Vec<[f32; 3]> {
    let mut factors = vec![[1.0; 3]; nodes.layout.len()];
    let inside = inside(samples);
    for c in 0..3 {
        let of = |&n: &usize| Missed {
            node: nodes.nearest(samples[n].middle_vox),
            off: missed[n][c].abs(),
            own_variance: variance(c, n),
            field_variance: field.uncertainty_vox(samples[n].middle_vox)[c].powi(2),
        };
        let missed: Vec<Missed> = inside.iter().map(of).collect();
        for (factors, factor) in factors.iter_mut().zip(of_component(nodes, &missed)) {
            factors[c] = factor;
        }
    }
    factors
}

/// Indices of the samples that are farther from the faces of the box around all than the margin.
fn inside(samples: &[Sample]) -> Vec<usize> {
    let [mut low, mut high] = [[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]];
    for sample in samples {
        for (axis, &at) in sample.middle_vox.iter().enumerate() {
            low[axis] = low[axis].min(at);
            high[axis] = high[axis].max(at);
        }
    }
    let edges: [f32; 3] = std::array::from_fn(|axis| high[axis] - low[axis]);
    let spacing = libm::cbrtf(edges.iter().product::<f32>() / samples.len() as f32);
    let margins = edges.map(|edge| (MARGIN * spacing).min(LARGEST_MARGIN * edge));
    let is_inside = |n: &usize| {
        let at = samples[*n].middle_vox;
        (0..3).all(|axis| {
            at[axis] - low[axis] >= margins[axis] && high[axis] - at[axis] >= margins[axis]
        })
    };
    (0..samples.len()).filter(is_inside).collect()
}

/// Nodes on either side whose samples count for the local factor, for this number of samples.
fn reach(nodes: &Nodes, samples: usize) -> usize {
    let edge = libm::cbrtf(LEAST_WITHIN_REACH * nodes.all_cells() as f32 / samples.max(1) as f32);
    ((edge / 2.0).round() as usize).max(LEAST_REACH)
}

/// Local factors of one component. A residual contains the errors of the sample and of the field. Where the field's
/// error is much smaller, residuals do not determine its factor, and the global one is used.
fn of_component(nodes: &Nodes, missed: &[Missed]) -> Vec<f32> {
    let shared = of_all(missed);
    let reach = reach(nodes, missed.len());
    let mut factors = vec![shared.field; nodes.layout.len()];
    for _ in 0..STEPS[1] {
        let mut gradient = vec![0.0; nodes.layout.len()];
        let mut information = vec![0.0; nodes.layout.len()];
        for one in missed {
            let here = Factors { field: factors[one.node], ..shared };
            let (share, surplus) = one.share_and_surplus(here);
            gradient[one.node] += share * surplus;
            information[one.node] += share * share;
        }
        sums_within(nodes.layout, reach, &mut gradient);
        sums_within(nodes.layout, reach, &mut information);
        for ((factor, gradient), information) in factors.iter_mut().zip(gradient).zip(information) {
            let gradient = gradient - GLOBAL_WEIGHT * libm::logf(*factor / shared.field);
            let step = gradient / (information + GLOBAL_WEIGHT);
            *factor = (*factor * bounded_factor(step)).clamp(LIMITS[0], LIMITS[1]);
        }
    }
    factors
}

/// Global factors by maximum likelihood: Fisher scoring of their logarithms.
fn of_all(missed: &[Missed]) -> Factors {
    let mut factors = Factors { own: 1.0, field: NOISE_SHARE };
    let prior = PRIOR_WEIGHT_ROOTS * (missed.len().max(1) as f32).sqrt();
    for _ in 0..STEPS[0] {
        // Gradient with respect to own and field; information matrix: own, mixed, field.
        let mut gradient = [factors.own, factors.field / NOISE_SHARE]
            .map(|factor| f64::from(-prior * libm::logf(factor)));
        let mut information = [f64::from(prior), 0.0, f64::from(prior)];
        for one in missed {
            let (share, surplus) = one.share_and_surplus(factors);
            let (share, surplus) = (f64::from(share), f64::from(surplus));
            gradient[0] += (1.0 - share) * surplus;
            gradient[1] += share * surplus;
            information[0] += (1.0 - share) * (1.0 - share);
            information[1] += share * (1.0 - share);
            information[2] += share * share;
        }
        let [own, both, field] = information;
        let determinant = own * field - both * both;
        let own_step = (field * gradient[0] - both * gradient[1]) / determinant;
        let field_step = (own * gradient[1] - both * gradient[0]) / determinant;
        factors.own *= bounded_factor(own_step as f32);
        factors.field *= bounded_factor(field_step as f32);
    }
    factors
}

/// The factor for a step of the logarithm, at most e.
fn bounded_factor(step: f32) -> f32 {
    libm::expf(step.clamp(-1.0, 1.0))
}

/// Replaces every value by the sum of those within `reach` nodes along each axis.
fn sums_within(layout: Layout, reach: usize, values: &mut [f32]) {
    for axis in 0..3 {
        let (s, count) = (layout.stride(axis), layout.nodes[axis]);
        let mut row = vec![0.0; count];
        for start in (0..values.len()).filter(|n| n / s % count == 0) {
            for (i, entry) in row.iter_mut().enumerate() {
                *entry = values[start + i * s];
            }
            for i in 0..count {
                let (low, high) = (i.saturating_sub(reach), (i + reach).min(count - 1));
                values[start + i * s] = row[low..=high].iter().sum();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_distr::{Distribution, StandardNormal};
    use rand_pcg::Pcg64Mcg;

    use super::*;

    const LARGEST_VOX: f32 = 40.0;

    fn nodes() -> Nodes {
        Nodes::covering([0.0; 3], [LARGEST_VOX; 3], 4.0)
    }

    /// Samples at random positions whose residuals have the variances with these factors.
    fn missed(
        nodes: &Nodes,
        own_variance: f32,
        field_variance: f32,
        factors: impl Fn([f32; 3]) -> Factors,
    ) -> Vec<Missed> {
        let mut random = Pcg64Mcg::seed_from_u64(7);
        let one = |_| {
            let place = std::array::from_fn(|_| random.random_range(0.0..LARGEST_VOX));
            let spread = random.random_range(-2.3..2.3f32).exp();
            let Factors { own, field } = factors(place);
            let (own_variance, field_variance) = (own_variance * spread, field_variance / spread);
            let deviation = (own * own_variance + field * field_variance).sqrt();
            let normal: f32 = StandardNormal.sample(&mut random);
            let off = (deviation * normal).abs();
            Missed { node: nodes.nearest(place), off, own_variance, field_variance }
        };
        (0..20_000).map(one).collect()
    }

    fn near(found: f32, expected: f32) -> bool {
        (found / expected).ln().abs() < 0.2
    }

    #[test]
    fn the_mean_square_is_that_of_clipped_normal_residuals() {
        let c = f64::from(CLIP_SIGMA);
        let within = libm::erf(c / 2f64.sqrt());
        let tail = c * (2.0 / std::f64::consts::PI).sqrt() * (-c * c / 2.0).exp();
        let expected = within - tail + c * c * (1.0 - within);
        assert!((f64::from(CLIPPED_MEAN_SQUARE) - expected).abs() < 1e-4, "{expected}");
    }

    #[test]
    fn extrapolated_samples_do_not_count() {
        let sample = |n: usize| {
            let middle_vox = [n % 10, n / 10 % 10, n / 100].map(|at| 4.0 * at as f32);
            Sample { middle_vox, displacement_vox: [0.0; 3], variance_vox2: [1.0; 3] }
        };
        let samples: Vec<Sample> = (0..1000).map(sample).collect();
        let counted = inside(&samples);
        assert_eq!(counted.len(), 8 * 8 * 8);
        let is_inner =
            |n: &usize| [n % 10, n / 10 % 10, n / 100].iter().all(|at| (1..9).contains(at));
        assert!(counted.iter().all(is_inner));
        // A sheet nine tenths of a voxel thick.
        let mut sheet = samples;
        sheet.iter_mut().for_each(|sample| sample.middle_vox[2] /= 40.0);
        assert_eq!(inside(&sheet).len(), 8 * 8 * 6);
        assert!(inside(&[]).is_empty());
    }

    #[test]
    fn factors_of_samples_and_field_are_told_apart() {
        let truth = Factors { own: 0.4, field: 3.0 };
        let found = of_all(&missed(&nodes(), 1e-4, 1e-4, |_| truth));
        assert!(near(found.own, truth.own) && near(found.field, truth.field), "{found:?}");
    }

    #[test]
    fn samples_that_err_more_than_the_field_say_nothing_about_it() {
        let truth = Factors { own: 2.0, field: NOISE_SHARE };
        let nodes = nodes();
        let missed = missed(&nodes, 1e-4, 1e-8, |_| truth);
        assert!(near(of_all(&missed).own, 2.0));
        let factors = of_component(&nodes, &missed);
        assert!(factors.iter().all(|factor| near(*factor, NOISE_SHARE)), "{factors:?}");
    }

    #[test]
    fn the_error_is_wide_where_samples_are_missed() {
        let nodes = nodes();
        let rough = |place: [f32; 3]| place[0] > LARGEST_VOX / 2.0;
        let truth = |place| Factors { own: 1.0, field: if rough(place) { 4.0 } else { 0.1 } };
        let factors = of_component(&nodes, &missed(&nodes, 1e-6, 1e-4, truth));
        // Beyond the reach of samples of the other half.
        let of = |from: f32, to: f32| {
            let inside = |n: &usize| (from..to).contains(&nodes.place_vox(*n)[0]);
            let found: Vec<f32> = (0..factors.len()).filter(inside).map(|n| factors[n]).collect();
            found.iter().map(|factor| factor.ln()).sum::<f32>() / found.len() as f32
        };
        let [smooth, rough] = [of(2.0, 10.0), of(30.0, 38.0)];
        assert!(smooth < 0.3f32.ln() && rough > 2.0f32.ln(), "{smooth} {rough}");
    }
}
