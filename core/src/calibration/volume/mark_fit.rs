//! Where a mark is seen: the rendered mark is moved until it meets the pixels of all micro-images that
//! show it.

use lfpiv_hw::card::Card;
use nalgebra::{Matrix6, Point3, Vector6};

use super::{
    camera_model::CameraModel,
    card_light::{CardLight, LitPixel},
    mark_map::MarkMap,
};

/// Rays through each pixel: to places spread over the microlens and over the pixel.
const RAYS: usize = 32;

/// Half a step of the difference quotients, in microlenses: small against a mark's edge, wide against
/// the distance of rays.
const STEP: f64 = 0.1;

/// Steps of Gauss and Newton; four suffice from within half a microlens.
const MOST_STEPS: usize = 8;

/// A step below this share of a microlens is the last.
const LAST_STEP: f64 = 5e-4;

/// Share of the spacing about a mark that its pixels show.
const REGION: f64 = 0.5;

/// Least share of a mean view's edges that a view sees to say where the mark is.
const LEAST_OF_A_VIEW: f64 = 0.5;

/// Least share of the pixels of a whole mark.
const LEAST_SEEN: f64 = 0.9;

/// A mark as one camera sees it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SeenMark {
    /// Its number on the card.
    pub(super) number: [i32; 2],
    /// Where its rays through the middle of the pupil meet the microlens plane, in mm.
    pub(super) place_mm: [f64; 2],
    /// Its derivative by the position on the nominal pupil.
    pub(super) slopes: [f64; 2],
    /// Standard deviation of the light about the rendered mark, relative to its contrast.
    pub(super) misfit: f64,
    /// Root mean square of where single views see it besides, in mm; both axes together.
    pub(super) views_rms_mm: f64,
}

/// What a fit needs.
#[derive(Debug, Clone, Copy)]
pub(super) struct MarkSearch<'a> {
    pub(super) light: &'a CardLight<'a>,
    pub(super) model: &'a CameraModel,
    pub(super) card: &'a Card,
    pub(super) origin_mm: &'a Point3<f64>,
    /// Where the image lies beside the model, in mm on the microlens plane.
    pub(super) shift_mm: [f64; 2],
    /// Most pixels that are compared for one mark.
    pub(super) most_pixels: usize,
}

/// A pixel's light, and where its rays meet the card, in mm along the marks.
struct Sampled {
    share: f64,
    view: [i32; 2],
    /// The middle of the pupil interval that it sees.
    pupil_mm: [f64; 2],
    /// No ray meets the card farther from the middle one, in mm.
    reach_mm: f64,
    middle_mm: [f64; 2],
    /// All x, then all y.
    rays_mm: [[f64; RAYS]; 2],
    /// How far these places move per mm on the microlens plane along x and along y. Within a mark that is
    /// the same to a few thousandths.
    per_mm: [[f64; 2]; 2],
}

impl Sampled {
    /// How far the card moves under the pixel's rays if the image of it moves by `beside_mm`, and by
    /// `slopes` per mm on the pupil.
    fn moved_mm(&self, beside_mm: [f64; 2], slopes: [f64; 2]) -> [f64; 2] {
        let [x, y] = [0, 1].map(|axis| beside_mm[axis] + slopes[axis] * self.pupil_mm[axis]);
        [0, 1].map(|along| -x * self.per_mm[0][along] - y * self.per_mm[1][along])
    }
}

/// What a mark's light depends on.
#[derive(Debug, Clone, Copy)]
struct State {
    /// Beside where the search began.
    beside_mm: [f64; 2],
    slopes: [f64; 2],
    ground: f64,
    contrast: f64,
}

impl MarkSearch<'_> {
    /// Fits one mark; `None` where the camera does not see all of it, or does not see it clearly.
    pub(super) fn fit(&self, number: [i32; 2]) -> Option<SeenMark> {
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
        Some(SeenMark {
            number,
            place_mm: std::array::from_fn(|axis| at_mm[axis] + state.beside_mm[axis]),
            slopes: std::array::from_fn(|axis| slopes[axis] + state.slopes[axis]),
            misfit,
            views_rms_mm,
        })
    }

    /// The pixels that see the card about a mark; `None` where too many are beyond the array or the pupil.
    fn pixels(
        &self,
        map: &MarkMap,
        at_mm: [f64; 2],
        half_mm: f64,
        along_mm: [f64; 2],
        spread_mm: f64,
    ) -> Option<Vec<Sampled>> {
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
        let region_mm = REGION * self.card.spacing_mm;
        let shows = |pixel: &LitPixel| {
            let place_mm = self.light.place_mm(pixel.lens);
            let from_mm = std::array::from_fn(|axis| place_mm[axis] - self.shift_mm[axis]);
            let met_mm = map.along_mm(from_mm, self.light.pupil_mm([0.0; 2], pixel.beside_mm));
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

    /// How far from its middle ray a pixel sees the card, in mm: half a microlens' diagonal and what the
    /// pupil interval adds out of focus, on a card that leans; with room for the step of the difference
    /// quotients.
    fn reach_mm(&self, spread_mm: f64) -> f64 {
        let optics = self.light.optics();
        let leaning = self.card.normal().dot(&self.model.axis()).abs();
        let slope = spread_mm / (optics.pupil_diameter_mm() / 2.0);
        let blur = slope * optics.pupil_cell_mm() / optics.microlens.pitch_mm;
        (1.0 + blur + 2.0 * STEP) * std::f64::consts::FRAC_1_SQRT_2 * optics.object_pitch_mm()
            / leaning
    }

    /// Pixels that show the region of one mark, if all do: its microlenses times the pixels of each.
    fn pixels_of_a_mark(&self) -> f64 {
        // The card may lean against the sensor.
        let leaning = self.card.normal().dot(&self.model.axis()).abs();
        let across = 2.0 * REGION * self.card.spacing_mm / self.light.optics().object_pitch_mm();
        across * across * leaning * self.light.pixels_per_lens()
    }

    fn sampled(&self, map: &MarkMap, pixel: &LitPixel, reach_mm: f64) -> Sampled {
        let optics = self.light.optics();
        let (pixel_mm, pitch_mm) = (optics.pixel_pitch_mm(), optics.microlens.pitch_mm);
        let centre_mm = self.light.place_mm(pixel.lens);
        let start = fractions_of(pixel.number);
        let from_mm = |place_mm: [f64; 2]| [0, 1].map(|axis| place_mm[axis] - self.shift_mm[axis]);
        let met_mm: [[f64; 2]; RAYS] = std::array::from_fn(|ray| {
            let [x, y, right, up] = rank_one(start, ray);
            let place_mm = self.light.place_mm([pixel.lens[0] + x, pixel.lens[1] + y]);
            let off_mm = std::array::from_fn(|axis| place_mm[axis] - centre_mm[axis]);
            let beside_mm =
                [pixel.beside_mm[0] + right * pixel_mm, pixel.beside_mm[1] + up * pixel_mm];
            map.along_mm(from_mm(place_mm), self.light.pupil_mm(off_mm, beside_mm))
        });
        let pupil_mm = self.light.pupil_mm([0.0; 2], pixel.beside_mm);
        let per_mm = [0, 1].map(|axis| {
            let [below, above] = [-0.5, 0.5].map(|pitches| {
                let mut place_mm = from_mm(centre_mm);
                place_mm[axis] += pitches * pitch_mm;
                map.along_mm(place_mm, pupil_mm)
            });
            [0, 1].map(|along| (above[along] - below[along]) / pitch_mm)
        });
        Sampled {
            share: f64::from(pixel.share),
            view: pixel.beside_mm.map(|mm| (mm / pixel_mm).round() as i32),
            pupil_mm,
            reach_mm,
            middle_mm: map.along_mm(from_mm(centre_mm), pupil_mm),
            rays_mm: [0, 1].map(|along| met_mm.map(|met_mm| met_mm[along])),
            per_mm,
        }
    }

    /// Share of a pixel's rays that meet something bright, with the card moved.
    fn bright(&self, pixel: &Sampled, beside_mm: [f64; 2], slopes: [f64; 2]) -> f64 {
        let moved_mm = pixel.moved_mm(beside_mm, slopes);
        let middle_mm = [0, 1].map(|along| pixel.middle_mm[along] + moved_mm[along]);
        if self.card.edge_distance_mm(middle_mm) > pixel.reach_mm {
            return f64::from(u8::from(self.card.is_bright(middle_mm)));
        }
        self.card.count_bright(&pixel.rays_mm, moved_mm) as f64 / RAYS as f64
    }

    /// Light and its change with the mark's place along both axes, per mm.
    fn rendered(&self, pixel: &Sampled, state: &State, step_mm: f64) -> [f64; 3] {
        let at = |axis: usize, sign: f64| {
            let mut beside_mm = state.beside_mm;
            beside_mm[axis] += sign * step_mm;
            self.bright(pixel, beside_mm, state.slopes)
        };
        let [low_x, high_x, low_y, high_y] = [at(0, -1.0), at(0, 1.0), at(1, -1.0), at(1, 1.0)];
        let here = self.bright(pixel, state.beside_mm, state.slopes);
        [here, (high_x - low_x) / (2.0 * step_mm), (high_y - low_y) / (2.0 * step_mm)]
    }

    /// Gauss and Newton: place, slopes, ground and contrast that leave the least squares.
    fn adjusted(
        &self,
        pixels: &[Sampled],
        pitch_mm: f64,
        pupil_mm: f64,
    ) -> Option<(State, f64, f64)> {
        let mut state = State { beside_mm: [0.0; 2], slopes: [0.0; 2], ground: 0.0, contrast: 1.0 };
        for step in 0..MOST_STEPS {
            let rendered: Vec<[f64; 3]> =
                pixels.iter().map(|pixel| self.rendered(pixel, &state, STEP * pitch_mm)).collect();
            if step == 0 {
                [state.ground, state.contrast] = line_through(&rendered, pixels)?;
            }
            let (mut normal, mut right) = (Matrix6::zeros(), Vector6::zeros());
            let mut squares = 0.0;
            for ([light, by_x, by_y], pixel) in rendered.iter().zip(pixels) {
                let [x, y] = [by_x * state.contrast, by_y * state.contrast];
                let [u, v] = pixel.pupil_mm.map(|place| place / pupil_mm);
                let change = Vector6::new(x, y, x * u, y * v, 1.0, *light);
                let missed = pixel.share - state.ground - state.contrast * light;
                normal += change * change.transpose();
                right += change * missed;
                squares += missed * missed;
            }
            let solved = normal.cholesky()?.solve(&right);
            if !solved.iter().all(|value| value.is_finite())
                || solved[0].hypot(solved[1]) > 3.0 * pitch_mm
            {
                return None;
            }
            state.beside_mm = [state.beside_mm[0] + solved[0], state.beside_mm[1] + solved[1]];
            state.slopes =
                [state.slopes[0] + solved[2] / pupil_mm, state.slopes[1] + solved[3] / pupil_mm];
            state.ground += solved[4];
            state.contrast += solved[5];
            let largest = (0..4).map(|n| solved[n].abs()).fold(0.0, f64::max);
            if largest < LAST_STEP * pitch_mm || step + 1 == MOST_STEPS {
                let misfit = (squares / pixels.len() as f64).sqrt() / state.contrast.abs();
                return Some((state, misfit, views_rms_mm(&rendered, pixels, &state)));
            }
        }
        None
    }
}

/// Where single views see the mark beside all together: each view's least squares along both axes.
fn views_rms_mm(rendered: &[[f64; 3]], pixels: &[Sampled], state: &State) -> f64 {
    let mut views = std::collections::BTreeMap::<[i32; 2], [f64; 5]>::new();
    for ([light, by_x, by_y], pixel) in rendered.iter().zip(pixels) {
        let [x, y] = [by_x * state.contrast, by_y * state.contrast];
        let missed = pixel.share - state.ground - state.contrast * light;
        let sums = views.entry(pixel.view).or_default();
        for (sum, term) in sums.iter_mut().zip([x * x, x * y, y * y, x * missed, y * missed]) {
            *sum += term;
        }
    }
    // A view that sees little of the mark's edge, or edges along one axis only, says nothing.
    let mean =
        |n: usize| views.values().map(|sums| sums[n]).sum::<f64>() / views.len().max(1) as f64;
    let least = [mean(0), mean(2)].map(|mean| LEAST_OF_A_VIEW * mean);
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

/// Ground and contrast of the light as a line through what is rendered; `None` without any contrast.
fn line_through(rendered: &[[f64; 3]], pixels: &[Sampled]) -> Option<[f64; 2]> {
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

/// Four fractions that differ from pixel to pixel (splitmix64 of its number), so that what rays leave
/// out averages over pixels.
fn fractions_of(pixel: usize) -> [f64; 4] {
    let mut state = (pixel as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    std::array::from_fn(|_| {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (mixed ^ (mixed >> 31)) as f64 / u64::MAX as f64
    })
}

/// Point `ray` of the additive sequence in four dimensions whose steps are powers of 1/φ, with
/// φ⁵ = φ + 1 (Roberts 2018), from `start`, each coordinate in [−1/2, 1/2).
fn rank_one(start: [f64; 4], ray: usize) -> [f64; 4] {
    const STEPS: [f64; 4] = [
        0.856_674_883_854_502_9,
        0.733_891_856_627_126_1,
        0.628_706_721_038_087_1,
        0.538_597_257_170_151,
    ];
    std::array::from_fn(|axis| (start[axis] + ray as f64 * STEPS[axis]).fract() - 0.5)
}
