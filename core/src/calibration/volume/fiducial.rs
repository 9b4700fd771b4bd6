//! Which of the places that a periodic card fits is the true one: the lenses that see the fiducial, or
//! where it would be, tell.

use lfpiv_hw::card::Card;
use nalgebra::{Matrix2, Point3, Vector2};

use super::{camera_model::CameraModel, card_light::CardLight};

/// A fiducial that is seen less clearly than this, in standard errors, does not tell one place from
/// another ([`Rival::clarity`]).
pub(super) const LEAST_CLARITY: f64 = 3.0;

/// Farthest rival, in mark spacings: shifted by one spacing, a checkerboard is its negative.
const FARTHEST: i32 = 2;

/// A card at one position, as a camera should see it.
pub(super) struct CardPlace<'a> {
    pub light: &'a CardLight<'a>,
    pub model: &'a CameraModel,
    pub card: &'a Card,
    pub origin_mm: &'a Point3<f64>,
}

impl CardPlace<'_> {
    /// Coordinates along the card of what a microlens sees through the pupil's middle, in mm.
    pub fn met_mm(&self, lens: [f64; 2]) -> Option<[f64; 2]> {
        let card = self.card;
        let face_mm = card.place_mm(self.origin_mm, [0.0; 2], &self.model.axis());
        let place_mm = self.light.place_mm(lens);
        let met_mm = self.model.meets(place_mm, [0.0; 2], &face_mm, &card.normal())?;
        let along_mm = met_mm - face_mm;
        Some([along_mm.dot(&card.right), along_mm.dot(&card.up)])
    }

    /// Microlenses along columns and rows from the middle of the array to what is a spacing away along
    /// `right` and along `up`.
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

/// What one microlens sees: light, and coordinates along the card in mm.
struct Seen {
    light: f64,
    along_mm: [f64; 2],
}

/// One image, relative to the contrast of its marks.
struct SeenCard {
    lenses: Vec<Seen>,
    /// Mean light of the lenses that should see bright and dark.
    bright: f64,
    dark: f64,
}

impl SeenCard {
    /// `None` if the card has no contrast where it should be.
    fn new(place: &CardPlace<'_>, shift: [i64; 2]) -> Option<Self> {
        let columns = place.light.microlenses()[0];
        let lenses: Vec<Seen> = place
            .light
            .middle_view()
            .into_iter()
            .enumerate()
            .filter_map(|(n, light)| {
                let lens = [n % columns, n / columns];
                let from = [0, 1].map(|axis| lens[axis] as f64 - shift[axis] as f64);
                let along_mm = light.is_finite().then(|| place.met_mm(from))??;
                Some(Seen { light: f64::from(light), along_mm })
            })
            .collect();
        let mean = |is_bright: bool| {
            let (sum, count) = lenses
                .iter()
                .filter(|seen| place.card.is_bright(seen.along_mm) == is_bright)
                .fold((0.0, 0u32), |(sum, count), seen| (sum + seen.light, count + 1));
            sum / f64::from(count)
        };
        let (bright, dark) = (mean(true), mean(false));
        (bright > dark).then_some(Self { lenses, bright, dark })
    }

    /// For every lens that tells the card from itself shifted by `rival` spacings: 1 if it sees as much
    /// light as it should, -1 if it sees what the rival predicts, and between for light between.
    fn agreement(&self, card: &Card, rival: [i32; 2]) -> impl Iterator<Item = f64> {
        let (middle, half) = ((self.bright + self.dark) / 2.0, (self.bright - self.dark) / 2.0);
        let shift_mm = rival.map(|spacings| f64::from(spacings) * card.spacing_mm);
        self.lenses.iter().filter_map(move |seen| {
            let is_bright = card.is_bright(seen.along_mm);
            let beside_mm = [0, 1].map(|axis| seen.along_mm[axis] + shift_mm[axis]);
            let agrees = ((seen.light - middle) / half).clamp(-1.0, 1.0);
            (is_bright != card.is_bright(beside_mm)).then_some(if is_bright {
                agrees
            } else {
                -agrees
            })
        })
    }
}

/// Another place that a periodic card fits.
#[derive(Debug, Clone, Copy)]
struct Rival {
    /// How far it is, in spacings along `right` and `up`.
    spacings: [i32; 2],
    /// How clearly the images speak against it: mean agreement of the lenses that tell both apart, in its
    /// standard errors. 0 if there are none, because the fiducial is not in view; negative if the rival
    /// predicts the light better.
    clarity: f64,
}

/// The shift of the images, in microlenses, with the fiducial where it is seen best, and the clarity of
/// that against the strongest rival. Starts from a shift that is right but for whole spacings.
pub(super) fn by_the_fiducial(
    positions: &[(&CardLight<'_>, Point3<f64>)],
    model: &CameraModel,
    card: &Card,
    shift: [i64; 2],
) -> ([i64; 2], f64) {
    let places: Vec<CardPlace<'_>> = positions
        .iter()
        .map(|(light, origin_mm)| CardPlace { light, model, card, origin_mm })
        .collect();
    let Some(first) = strongest_rival(&places, card, shift) else { return (shift, 0.0) };
    if first.clarity >= 0.0 {
        return (shift, first.clarity);
    }
    let steps = places.iter().find_map(CardPlace::lenses_per_spacing);
    let moved = steps.map(|lenses_per_spacing| {
        let lenses = lenses_per_spacing * Vector2::from(first.spacings.map(f64::from));
        [0, 1].map(|axis| shift[axis] - lenses[axis].round() as i64)
    });
    // The rival may in turn be worse than a third place; then nothing is certain.
    match moved.and_then(|moved| Some((moved, strongest_rival(&places, card, moved)?.clarity))) {
        Some((moved, clarity)) if clarity > first.clarity => (moved, clarity),
        _ => (shift, first.clarity),
    }
}

/// The place that is hardest to tell from the one with this shift; `None` if the card is not seen.
fn strongest_rival(places: &[CardPlace<'_>], card: &Card, shift: [i64; 2]) -> Option<Rival> {
    let seen: Vec<SeenCard> = places.iter().filter_map(|at| SeenCard::new(at, shift)).collect();
    let rival = |spacings: [i32; 2]| {
        let agreement = seen.iter().flat_map(|image| image.agreement(card, spacings));
        Rival { spacings, clarity: in_standard_errors(agreement) }
    };
    let steps = || -FARTHEST..=FARTHEST;
    steps()
        .flat_map(|u| steps().map(move |v| [u, v]))
        .filter(|&spacings| spacings != [0, 0])
        .map(rival)
        .filter(|_| !seen.is_empty())
        .min_by(|a, b| a.clarity.total_cmp(&b.clarity))
}

/// The mean of some numbers divided by its standard error; 0 for fewer than two.
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
