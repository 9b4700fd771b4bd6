//! Measurement of a mark: the rendered mark is fitted to the pixels of all micro-images that show it.

use lfpiv_hw::card::Card;
use nalgebra::{Matrix6, Point3, Vector6};

use super::{
    camera_model::CameraModel,
    card_light::{CardLight, LitPixel},
    mark_map::MarkMap,
};

/// Rays of each pixel, distributed over the area of the microlens and of the pixel.
const RAYS: usize = 32;

/// Half step of the central differences, in microlenses: smaller than a mark, larger than the distance between
/// rays.
const STEP: f64 = 0.1;

/// Largest number of Gauss-Newton steps; four suffice from within half a microlens.
const MOST_STEPS: usize = 8;

/// Step at convergence, in microlenses.
const LAST_STEP: f64 = 5e-4;

/// Half width of the region of a mark, in spacings.
const REGION_HALF_WIDTH: f64 = 0.5;

/// Least information of a view about the mark's location, relative to the mean view.
const LEAST_VIEW_INFORMATION: f64 = 0.5;

/// Least share of a mark's pixels that must be in the image.
const LEAST_SEEN: f64 = 0.9;

/// Measurement of a mark by one camera.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ObservedMark {
    /// Indices of the mark on the card.
    pub(super) number: [i32; 2],
    /// Place of its rays through the middle of the pupil on the microlens plane, in mm.
    pub(super) place_mm: [f64; 2],
    /// Derivative of the place with respect to the position on the nominal pupil, along each axis.
    pub(super) slopes: [f64; 2],
    /// Root-mean-square residual of the light, relative to the mark's contrast.
    pub(super) misfit: f64,
    /// Root-mean-square deviation of single views from this place, in mm, per coordinate.
    pub(super) views_rms_mm: f64,
}

/// Input of the fits of marks in one image.
#[derive(Debug, Clone, Copy)]
pub(super) struct MarkSearch<'a> {
    pub(super) light: &'a CardLight<'a>,
    pub(super) model: &'a CameraModel,
    pub(super) card: &'a Card,
    pub(super) origin_mm: &'a Point3<f64>,
    /// Shift of the image from its prediction, in mm on the microlens plane.
    pub(super) shift_mm: [f64; 2],
    /// Largest number of pixels for one mark.
    pub(super) most_pixels: usize,
}

/// A pixel's light, and the intersections of its rays with the card, in mm along the card.
struct SampledPixel {
    /// Light relative to the white image.
    share: f64,
    /// Indices of the pixel in its micro-image.
    view: [i32; 2],
    /// Centre of the pixel's pupil interval.
    pupil_mm: [f64; 2],
    /// Upper limit of the distance of rays from the central ray on the card, in mm.
    reach_mm: f64,
    /// Intersection of the central ray.
    middle_mm: [f64; 2],
    /// Intersections of all rays: x, then y.
    rays_mm: [[f64; RAYS]; 2],
    /// Derivatives of the intersections with respect to x and y on the microlens plane. They vary by a few
    /// thousandths within a mark.
    card_per_place: [[f64; 2]; 2],
}

impl SampledPixel {
    /// Shift of the intersections on the card, in mm, if the image moves by `offset_mm` and by `slopes` per mm
    /// on the pupil.
    fn moved_mm(&self, offset_mm: [f64; 2], slopes: [f64; 2]) -> [f64; 2] {
        let [x, y] = [0, 1].map(|axis| offset_mm[axis] + slopes[axis] * self.pupil_mm[axis]);
        [0, 1].map(|along| -x * self.card_per_place[0][along] - y * self.card_per_place[1][along])
    }
}

/// Parameters of a mark's light.
#[derive(Debug, Clone, Copy)]
struct State {
    /// Place relative to the initial place.
    offset_mm: [f64; 2],
    slopes: [f64; 2],
    background: f64,
    contrast: f64,
}

impl MarkSearch<'_> {
    /// Fits one mark. `None` if it is not completely in the image, or if the fit fails.
    pub(super) fn fit(&self, number: [i32; 2]) -> Option<ObservedMark> {
        let optics = self.light.optics();
        let pitch_mm = optics.microlens.pitch_mm;
        let along_mm = number.map(|n| f64::from(n) * self.card.spacing_mm);
        let point_mm = self.card.place_mm(self.origin_mm, along_mm, &self.model.axis());
        let [place_mm, slopes] = self.model.place_and_slope(&point_mm)?;
        let pupil_mm = optics.pupil_diameter_mm() / 2.0;
        let spread_mm = slopes.iter().fold(0.0f64, |most, slope| most.max(slope.abs())) * pupil_mm;
        let half_mm = self.card.spacing_mm / optics.object_pitch_mm() * pitch_mm * 0.75
            + spread_mm
            + pitch_mm;
        let map = MarkMap::new(self.model, self.card, self.origin_mm, place_mm, half_mm, pupil_mm)?;
        let at_mm = std::array::from_fn(|axis| place_mm[axis] + self.shift_mm[axis]);
        let pixels = self.pixels(&map, at_mm, half_mm, along_mm, spread_mm)?;
        let (state, misfit, views_rms_mm) = self.adjusted(&pixels, pitch_mm, pupil_mm)?;
        Some(ObservedMark {
            number,
            place_mm: std::array::from_fn(|axis| at_mm[axis] + state.offset_mm[axis]),
            slopes: std::array::from_fn(|axis| slopes[axis] + state.slopes[axis]),
            misfit,
            views_rms_mm,
        })
    }

    /// The pixels whose central rays meet the region of a mark. `None` if too many are missing.
    fn pixels(
        &self,
        map: &MarkMap,
        at_mm: [f64; 2],
        half_mm: f64,
        along_mm: [f64; 2],
        spread_mm: f64,
    ) -> Option<Vec<SampledPixel>> {
        let pitch_mm = self.light.optics().microlens.pitch_mm;
        let reach = (half_mm / pitch_mm).ceil();
        let middle = self.light.lens_at(at_mm);
        let [columns, rows] = self.light.microlenses();
        let line = |at: f64, count: usize| {
            let (first, end) = ((at - reach).floor().max(0.0), (at + reach).ceil() + 1.0);
            let end = end.min(count as f64);
            (first < end).then_some(first as usize..end as usize)
        };
        let (along_i, along_j) = (line(middle[0], columns)?, line(middle[1], rows)?);
        let region_mm = REGION_HALF_WIDTH * self.card.spacing_mm;
        let shows = |pixel: &LitPixel| {
            let place_mm = self.light.place_mm(pixel.lens);
            let from_mm = std::array::from_fn(|axis| place_mm[axis] - self.shift_mm[axis]);
            let met_mm = map.along_mm(from_mm, self.light.pupil_mm([0.0; 2], pixel.offset_mm));
            (0..2).all(|axis| (met_mm[axis] - along_mm[axis]).abs() < region_mm)
        };
        let found: Vec<LitPixel> = along_j
            .flat_map(|j| along_i.clone().map(move |i| (i, j)))
            .flat_map(|(i, j)| self.light.lit_pixels(i, j).filter(shows).collect::<Vec<_>>())
            .collect();
        let reach_mm = self.reach_mm(spread_mm);
        if (found.len() as f64) < LEAST_SEEN * self.pixels_of_a_mark() {
            return None;
        }
        let stride = found.len().div_ceil(self.most_pixels.max(1));
        Some(found.iter().step_by(stride).map(|pixel| self.sampled(map, pixel, reach_mm)).collect())
    }

    /// Upper limit of the distance of a pixel's rays from its central ray on the card, in mm: half the diagonal
    /// of a microlens plus the defocus over the pupil interval, on an inclined card, with a margin for the
    /// differences.
    fn reach_mm(&self, spread_mm: f64) -> f64 {
        let optics = self.light.optics();
        let cosine = self.card.normal().dot(&self.model.axis()).abs();
        let slope = spread_mm / (optics.pupil_diameter_mm() / 2.0);
        let blur = slope * optics.pupil_cell_mm() / optics.microlens.pitch_mm;
        (1.0 + blur + 2.0 * STEP) * std::f64::consts::FRAC_1_SQRT_2 * optics.object_pitch_mm()
            / cosine
    }

    /// Number of pixels of a complete region of a mark: its microlenses times the pixels of each.
    fn pixels_of_a_mark(&self) -> f64 {
        let cosine = self.card.normal().dot(&self.model.axis()).abs();
        let across =
            2.0 * REGION_HALF_WIDTH * self.card.spacing_mm / self.light.optics().object_pitch_mm();
        across * across * cosine * self.light.pixels_per_lens()
    }

    fn sampled(&self, map: &MarkMap, pixel: &LitPixel, reach_mm: f64) -> SampledPixel {
        let optics = self.light.optics();
        let (pixel_mm, pitch_mm) = (optics.pixel_pitch_mm(), optics.microlens.pitch_mm);
        let centre_mm = self.light.place_mm(pixel.lens);
        let start = random_fractions(pixel.number);
        let from_mm = |place_mm: [f64; 2]| [0, 1].map(|axis| place_mm[axis] - self.shift_mm[axis]);
        let met_mm: [[f64; 2]; RAYS] = std::array::from_fn(|ray| {
            let [x, y, right, up] = additive_recurrence(start, ray);
            let place_mm = self.light.place_mm([pixel.lens[0] + x, pixel.lens[1] + y]);
            let lens_offset_mm = std::array::from_fn(|axis| place_mm[axis] - centre_mm[axis]);
            let pixel_offset_mm =
                [pixel.offset_mm[0] + right * pixel_mm, pixel.offset_mm[1] + up * pixel_mm];
            map.along_mm(from_mm(place_mm), self.light.pupil_mm(lens_offset_mm, pixel_offset_mm))
        });
        let pupil_mm = self.light.pupil_mm([0.0; 2], pixel.offset_mm);
        let card_per_place = [0, 1].map(|axis| {
            let [below, above] = [-0.5, 0.5].map(|pitches| {
                let mut place_mm = from_mm(centre_mm);
                place_mm[axis] += pitches * pitch_mm;
                map.along_mm(place_mm, pupil_mm)
            });
            [0, 1].map(|along| (above[along] - below[along]) / pitch_mm)
        });
        SampledPixel {
            share: f64::from(pixel.share),
            view: pixel.offset_mm.map(|mm| (mm / pixel_mm).round() as i32),
            pupil_mm,
            reach_mm,
            middle_mm: map.along_mm(from_mm(centre_mm), pupil_mm),
            rays_mm: [0, 1].map(|along| met_mm.map(|met_mm| met_mm[along])),
            card_per_place,
        }
    }

    /// Share of a pixel's rays that meet bright parts of the card, with the rays' intersections moved.
    fn bright(&self, pixel: &SampledPixel, moved_mm: [f64; 2]) -> f64 {
        self.card.count_bright(&pixel.rays_mm, moved_mm) as f64 / RAYS as f64
    }

    /// Rendered light and its derivatives with respect to the mark's place along both axes, per mm.
    fn rendered(&self, pixel: &SampledPixel, state: &State, step_mm: f64) -> [f64; 3] {
        let moved_mm = pixel.moved_mm(state.offset_mm, state.slopes);
        let middle_mm = [0, 1].map(|along| pixel.middle_mm[along] + moved_mm[along]);
        // No edge is within reach of any ray, neither here nor a step away.
        if self.card.edge_distance_mm(middle_mm) > pixel.reach_mm {
            return [f64::from(u8::from(self.card.is_bright(middle_mm))), 0.0, 0.0];
        }
        let at = |axis: usize, sign: f64| {
            let mut offset_mm = state.offset_mm;
            offset_mm[axis] += sign * step_mm;
            self.bright(pixel, pixel.moved_mm(offset_mm, state.slopes))
        };
        let [low_x, high_x, low_y, high_y] = [at(0, -1.0), at(0, 1.0), at(1, -1.0), at(1, 1.0)];
        let here = self.bright(pixel, moved_mm);
        [here, (high_x - low_x) / (2.0 * step_mm), (high_y - low_y) / (2.0 * step_mm)]
    }

    /// Gauss-Newton fit of place, slopes, background and contrast. Also returns misfit and deviation of single
    /// views.
    fn adjusted(
        &self,
        pixels: &[SampledPixel],
        pitch_mm: f64,
        pupil_mm: f64,
    ) -> Option<(State, f64, f64)> {
        let mut state =
            State { offset_mm: [0.0; 2], slopes: [0.0; 2], background: 0.0, contrast: 1.0 };
        for iteration in 0..MOST_STEPS {
            let rendered: Vec<[f64; 3]> =
                pixels.iter().map(|pixel| self.rendered(pixel, &state, STEP * pitch_mm)).collect();
            if iteration == 0 {
                [state.background, state.contrast] = regression(&rendered, pixels)?;
            }
            let (mut normal, mut right) = (Matrix6::zeros(), Vector6::zeros());
            let mut squares = 0.0;
            for ([light, by_x, by_y], pixel) in rendered.iter().zip(pixels) {
                let [x, y] = [by_x * state.contrast, by_y * state.contrast];
                let [u, v] = pixel.pupil_mm.map(|place| place / pupil_mm);
                let derivatives = Vector6::new(x, y, x * u, y * v, 1.0, *light);
                let residual = pixel.share - state.background - state.contrast * light;
                normal += derivatives * derivatives.transpose();
                right += derivatives * residual;
                squares += residual * residual;
            }
            let step = normal.cholesky()?.solve(&right);
            if !step.iter().all(|value| value.is_finite())
                || step[0].hypot(step[1]) > 3.0 * pitch_mm
            {
                return None;
            }
            state.offset_mm = [state.offset_mm[0] + step[0], state.offset_mm[1] + step[1]];
            state.slopes =
                [state.slopes[0] + step[2] / pupil_mm, state.slopes[1] + step[3] / pupil_mm];
            state.background += step[4];
            state.contrast += step[5];
            let largest = (0..4).map(|n| step[n].abs()).fold(0.0, f64::max);
            if largest < LAST_STEP * pitch_mm || iteration + 1 == MOST_STEPS {
                let misfit = (squares / pixels.len() as f64).sqrt() / state.contrast.abs();
                return Some((state, misfit, views_rms_mm(&rendered, pixels, &state)));
            }
        }
        None
    }
}

/// Root-mean-square deviation of the mark's place in single views, in mm, by linear least squares in each view.
fn views_rms_mm(rendered: &[[f64; 3]], pixels: &[SampledPixel], state: &State) -> f64 {
    let mut views = std::collections::BTreeMap::<[i32; 2], [f64; 5]>::new();
    for ([light, by_x, by_y], pixel) in rendered.iter().zip(pixels) {
        let [x, y] = [by_x * state.contrast, by_y * state.contrast];
        let residual = pixel.share - state.background - state.contrast * light;
        let sums = views.entry(pixel.view).or_default();
        for (sum, term) in sums.iter_mut().zip([x * x, x * y, y * y, x * residual, y * residual]) {
            *sum += term;
        }
    }
    // Views that show too little of the mark's edge, or edges along one axis only, are left out.
    let mean =
        |n: usize| views.values().map(|sums| sums[n]).sum::<f64>() / views.len().max(1) as f64;
    let least = [mean(0), mean(2)].map(|mean| LEAST_VIEW_INFORMATION * mean);
    let (mut squares, mut count) = (0.0, 0.0);
    for [xx, xy, yy, x, y] in views.into_values() {
        let determinant = xx * yy - xy * xy;
        if xx > least[0] && yy > least[1] && determinant > 0.5 * xx * yy {
            let off = [(yy * x - xy * y) / determinant, (xx * y - xy * x) / determinant];
            squares += off[0] * off[0] + off[1] * off[1];
            count += 2.0;
        }
    }
    if count > 0.0 { (squares / count).sqrt() } else { 0.0 }
}

/// Background and contrast by linear regression of the light on the rendered light. `None` without contrast.
fn regression(rendered: &[[f64; 3]], pixels: &[SampledPixel]) -> Option<[f64; 2]> {
    let n = rendered.len() as f64;
    let pairs = || rendered.iter().zip(pixels).map(|([light, ..], pixel)| [*light, pixel.share]);
    let mean = pairs().fold([0.0; 2], |sum, [a, b]| [sum[0] + a / n, sum[1] + b / n]);
    let (square, product) = pairs().fold((0.0, 0.0), |(square, product), [a, b]| {
        let off = a - mean[0];
        (square + off * off, product + off * (b - mean[1]))
    });
    let contrast = product / square;
    (contrast.is_finite() && contrast != 0.0).then(|| [mean[1] - contrast * mean[0], contrast])
}

/// Four pseudo-random fractions for each pixel (splitmix64 of its index), so that sampling errors average out over
/// pixels.
fn random_fractions(pixel: usize) -> [f64; 4] {
    let mut state = (pixel as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    std::array::from_fn(|_| {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (mixed ^ (mixed >> 31)) as f64 / u64::MAX as f64
    })
}

/// Point `ray` of the four-dimensional additive recurrence from `start` whose steps are powers of 1/φ, with
/// φ⁵ = φ + 1 (Roberts 2018). Coordinates are in [−1/2, 1/2).
fn additive_recurrence(start: [f64; 4], ray: usize) -> [f64; 4] {
    const STEPS: [f64; 4] = [
        0.856_674_883_854_502_9,
        0.733_891_856_627_126_1,
        0.628_706_721_038_087_1,
        0.538_597_257_170_151,
    ];
    std::array::from_fn(|axis| (start[axis] + ray as f64 * STEPS[axis]).fract() - 0.5)
}
