//! Resolves the ambiguity of a periodic card by whole mark spacings. The lenses that image the fiducial, or its
//! location in an alternative alignment, decide.

use lfpiv_hw::card::Card;
use nalgebra::{Matrix2, Point3, Vector2};

use super::{camera_model::CameraModel, card_light::CardLight};

/// Least [`Alternative::significance`] for an unambiguous alignment.
pub(super) const LEAST_SIGNIFICANCE: f64 = 3.0;

/// Largest shift of an alternative along each axis, in mark spacings. A checkerboard has a period of two spacings.
const MOST_SPACINGS: i32 = 2;

/// An image of the card at one position, with the camera model that predicts it.
pub(super) struct CardPlace<'a> {
    pub light: &'a CardLight<'a>,
    pub model: &'a CameraModel,
    pub card: &'a Card,
    pub origin_mm: &'a Point3<f64>,
}

impl CardPlace<'_> {
    /// Point on the card that a microlens images through the middle of the pupil, in mm along the card.
    pub fn met_mm(&self, lens: [f64; 2]) -> Option<[f64; 2]> {
        let card = self.card;
        let face_mm = card.place_mm(self.origin_mm, [0.0; 2], &self.model.axis());
        let place_mm = self.light.place_mm(lens);
        let met_mm = self.model.intersection_mm(place_mm, [0.0; 2], &face_mm, &card.normal())?;
        let along_mm = met_mm - face_mm;
        Some([along_mm.dot(&card.right), along_mm.dot(&card.up)])
    }

    /// Shift of the image in microlenses, along columns and rows, per mark spacing along `right` and along `up`, in
    /// the middle of the array.
    fn lenses_per_spacing(&self) -> Option<Matrix2<f64>> {
        let middle = self.light.microlenses().map(|count| (count as f64 - 1.0) / 2.0);
        let here = Vector2::from(self.met_mm(middle)?);
        let next = |beside: [f64; 2]| -> Option<Vector2<f64>> {
            let met_mm = self.met_mm([middle[0] + beside[0], middle[1] + beside[1]])?;
            Some(Vector2::from(met_mm) - here)
        };
        let mm_per_lens = Matrix2::from_columns(&[next([1.0, 0.0])?, next([0.0, 1.0])?]);
        Some(mm_per_lens.try_inverse()? * self.card.spacing_mm)
    }
}

/// Light of one microlens, and the point on the card that it images, in mm along the card.
struct LensLight {
    light: f64,
    along_mm: [f64; 2],
}

/// One image with an assumed shift.
struct CardImage {
    lenses: Vec<LensLight>,
    /// Mean light of the lenses that should image bright parts.
    bright: f64,
    /// Mean light of the lenses that should image dark parts.
    dark: f64,
}

impl CardImage {
    /// The image shifted by `shift` microlenses. `None` if the card has no contrast with this shift.
    fn new(place: &CardPlace<'_>, shift: [i64; 2]) -> Option<Self> {
        let columns = place.light.microlenses()[0];
        let lenses: Vec<LensLight> = place
            .light
            .middle_view()
            .into_iter()
            .enumerate()
            .filter_map(|(n, light)| {
                let lens = [n % columns, n / columns];
                let from = [0, 1].map(|axis| lens[axis] as f64 - shift[axis] as f64);
                let along_mm = light.is_finite().then(|| place.met_mm(from))??;
                Some(LensLight { light: f64::from(light), along_mm })
            })
            .collect();
        let mean = |is_bright: bool| {
            let (sum, count) = lenses
                .iter()
                .filter(|lens| place.card.is_bright(lens.along_mm) == is_bright)
                .fold((0.0, 0u32), |(sum, count), lens| (sum + lens.light, count + 1));
            sum / f64::from(count)
        };
        let (bright, dark) = (mean(true), mean(false));
        (bright > dark).then_some(Self { lenses, bright, dark })
    }

    /// Agreement of every lens that distinguishes this alignment from one shifted by `alternative` spacings: 1
    /// if its light agrees with this alignment, -1 if it agrees with the alternative, with intermediate values
    /// between.
    fn agreement(&self, card: &Card, alternative: [i32; 2]) -> impl Iterator<Item = f64> {
        let (middle, half) = ((self.bright + self.dark) / 2.0, (self.bright - self.dark) / 2.0);
        let shift_mm = alternative.map(|spacings| f64::from(spacings) * card.spacing_mm);
        self.lenses.iter().filter_map(move |lens| {
            let is_bright = card.is_bright(lens.along_mm);
            let shifted_mm = [0, 1].map(|axis| lens.along_mm[axis] + shift_mm[axis]);
            let agrees = ((lens.light - middle) / half).clamp(-1.0, 1.0);
            (is_bright != card.is_bright(shifted_mm)).then_some(if is_bright {
                agrees
            } else {
                -agrees
            })
        })
    }
}

/// Another alignment of the periodic card.
#[derive(Debug, Clone, Copy)]
struct Alternative {
    /// Shift in spacings along `right` and `up`.
    spacings: [i32; 2],
    /// Mean agreement of the distinguishing lenses divided by its standard error. 0 without such lenses, if the
    /// fiducial is not in view; negative if the alternative predicts the light better.
    significance: f64,
}

/// The shift of the images in microlenses that agrees best with the fiducial, and its significance against the
/// strongest alternative. The initial `shift` is correct up to whole spacings.
pub(super) fn resolved_by_fiducial(
    positions: &[(&CardLight<'_>, Point3<f64>)],
    model: &CameraModel,
    card: &Card,
    shift: [i64; 2],
) -> ([i64; 2], f64) {
    let places: Vec<CardPlace<'_>> = positions
        .iter()
        .map(|(light, origin_mm)| CardPlace { light, model, card, origin_mm })
        .collect();
    let Some(first) = strongest_alternative(&places, card, shift) else { return (shift, 0.0) };
    if first.significance >= 0.0 {
        return (shift, first.significance);
    }
    let steps = places.iter().find_map(CardPlace::lenses_per_spacing);
    let moved = steps.map(|lenses_per_spacing| {
        let lenses = lenses_per_spacing * Vector2::from(first.spacings.map(f64::from));
        [0, 1].map(|axis| shift[axis] - lenses[axis].round() as i64)
    });
    // The alternative is rejected if it is itself less significant.
    match moved
        .and_then(|moved| Some((moved, strongest_alternative(&places, card, moved)?.significance)))
    {
        Some((moved, significance)) if significance > first.significance => (moved, significance),
        _ => (shift, first.significance),
    }
}

/// The alternative with the least significance. `None` if the card is in no image.
fn strongest_alternative(
    places: &[CardPlace<'_>],
    card: &Card,
    shift: [i64; 2],
) -> Option<Alternative> {
    let images: Vec<CardImage> = places.iter().filter_map(|at| CardImage::new(at, shift)).collect();
    let alternative = |spacings: [i32; 2]| {
        let agreement = images.iter().flat_map(|image| image.agreement(card, spacings));
        Alternative { spacings, significance: in_standard_errors(agreement) }
    };
    let steps = || -MOST_SPACINGS..=MOST_SPACINGS;
    steps()
        .flat_map(|u| steps().map(move |v| [u, v]))
        .filter(|&spacings| spacings != [0, 0])
        .map(alternative)
        .filter(|_| !images.is_empty())
        .min_by(|a, b| a.significance.total_cmp(&b.significance))
}

/// The mean divided by its standard error; 0 for fewer than two numbers.
fn in_standard_errors(numbers: impl Iterator<Item = f64>) -> f64 {
    let (count, sum, squares) = numbers.fold((0.0, 0.0, 0.0), |(count, sum, squares), number| {
        (count + 1.0, sum + number, squares + number * number)
    });
    if count < 2.0 {
        return 0.0;
    }
    let mean = sum / count;
    let variance = (squares - count * mean * mean).max(0.0) / (count - 1.0);
    mean / (variance / count).sqrt().max(f64::MIN_POSITIVE)
}
