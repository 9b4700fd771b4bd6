//! A calibration card: a flat pattern of marks that both cameras see at known places.

use garde::Validate;
use nalgebra::{Point3, Vector3};
use serde::{Deserialize, Serialize};

use crate::check::finite;

/// What a card file says: the card, the walls that the cameras look through, and where the card stood.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct CalibrationCard {
    /// The card itself.
    #[garde(dive)]
    pub card: Card,
    /// The wall in front of each camera, in the order of the cameras; none where the cameras and the
    /// volume are in air.
    #[serde(default)]
    #[garde(dive)]
    pub wall: Vec<Wall>,
    /// White and dark images of each camera, in the order of the cameras.
    #[serde(default)]
    #[garde(dive)]
    pub reference: Vec<ReferenceImages>,
    /// Where the card stood, and its images there.
    #[garde(length(min = 1), dive)]
    pub position: Vec<CardPosition>,
}

/// The pattern, and which way it faces.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct Card {
    /// What is printed on it.
    #[garde(skip)]
    pub pattern: Pattern,
    /// Distance of neighbouring marks, in mm.
    #[garde(custom(finite), range(min = 0.01, max = 100.0))]
    pub spacing_mm: f64,
    /// Diameter of a dot, in mm. A checkerboard has none.
    #[serde(default)]
    #[garde(custom(finite), range(min = 0.0, max = 100.0))]
    pub dot_diameter_mm: f64,
    /// Diameter of the three dots that tell origin and axes, in mm.
    #[garde(custom(finite), range(min = 0.01, max = 100.0))]
    pub fiducial_diameter_mm: f64,
    /// Marks along `right` and `up`; odd numbers. Mark (0, 0) is in the middle.
    #[garde(inner(range(min = 3, max = 999)))]
    pub marks: [usize; 2],
    /// Unit vector of the world along the marks' first number.
    #[garde(skip)]
    pub right: Vector3<f64>,
    /// Unit vector of the world along the marks' second number.
    #[garde(skip)]
    pub up: Vector3<f64>,
    /// Thickness of a card that has the same marks on its back, in mm: each back to back with its
    /// twin. Absent for a card that is printed on one face, which looks along `right` × `up`.
    #[serde(default)]
    #[garde(inner(custom(finite), range(min = 0.0, max = 100.0)))]
    pub two_sided_mm: Option<f64>,
}

/// What is printed on a card.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Pattern {
    /// Bright dots on a dark ground. The dots (0, 0), (2, 0) and (0, 1) are the fiducial.
    Dots,
    /// Squares, whose corners are the marks: bright from mark (0, 0) to (1, 1). The fiducial are dots of
    /// the other shade in the middle of the squares from marks (0, 0), (2, 0) and (0, 1) upwards.
    Checkerboard,
}

/// A flat wall that a camera should look through at right angles.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct Wall {
    /// From the camera's point in focus along its axis to the face that the fluid wets, in mm.
    #[garde(custom(finite), range(min = 0.0, max = 5000.0))]
    pub distance_mm: f64,
    /// Thickness of the glass, in mm.
    #[garde(custom(finite), range(min = 0.0, max = 1000.0))]
    pub thickness_mm: f64,
    /// Refractive index of the glass.
    #[garde(custom(finite), range(min = 1.0, max = 3.0))]
    pub glass_index: f64,
    /// Refractive index of the fluid.
    #[garde(custom(finite), range(min = 1.0, max = 3.0))]
    pub medium_index: f64,
}

/// White and dark images of one camera.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct ReferenceImages {
    /// Files of the diffuser, relative to the card file.
    #[garde(length(min = 1))]
    pub white: Vec<String>,
    /// Files with the cap on, relative to the card file.
    #[serde(default)]
    #[garde(skip)]
    pub dark: Vec<String>,
}

/// A place of the card.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct CardPosition {
    /// Where mark (0, 0) is in the world, in mm.
    #[garde(inner(custom(finite)))]
    pub origin_mm: [f64; 3],
    /// The image of each camera, relative to the card file, in the order of the cameras. A card that
    /// is still to be imaged has none.
    #[serde(default)]
    #[garde(skip)]
    pub images: Vec<String>,
}

impl Card {
    /// Unit vector that the printed face looks along.
    pub fn normal(&self) -> Vector3<f64> {
        self.right.cross(&self.up).normalize()
    }

    /// World place of a point on the card's face that `axis` (from the volume to a camera) shows, in mm.
    ///
    /// `along_mm` are coordinates along `right` and `up` from mark (0, 0), which is at `origin_mm`.
    pub fn place_mm(
        &self,
        origin_mm: &Point3<f64>,
        along_mm: [f64; 2],
        axis: &Vector3<f64>,
    ) -> Point3<f64> {
        let back = match self.two_sided_mm {
            Some(thickness_mm) if self.normal().dot(axis) < 0.0 => self.normal() * -thickness_mm,
            _ => Vector3::zeros(),
        };
        origin_mm + self.right * along_mm[0] + self.up * along_mm[1] + back
    }

    /// Numbers of all marks, in order.
    pub fn numbers(&self) -> impl Iterator<Item = [i32; 2]> + use<> {
        let [half_u, half_v] = self.marks.map(|count| (count.max(1) as i32 - 1) / 2);
        (-half_v..=half_v).flat_map(move |v| (-half_u..=half_u).map(move |u| [u, v]))
    }

    /// Middle of a fiducial dot along `right` and `up`, in mm, by its number (0, 1 or 2).
    #[inline]
    pub fn fiducials_mm(&self) -> [[f64; 2]; 3] {
        let shift = match self.pattern {
            Pattern::Dots => 0.0,
            Pattern::Checkerboard => 0.5,
        };
        [[0.0, 0.0], [2.0, 0.0], [0.0, 1.0]].map(|mark| mark.map(|n| (n + shift) * self.spacing_mm))
    }

    /// Whether a point of the face is bright; `along_mm` as in [`Self::place_mm`].
    #[inline]
    pub fn is_bright(&self, along_mm: [f64; 2]) -> bool {
        let within = |centre: [f64; 2], diameter_mm: f64| {
            let [x, y] = [along_mm[0] - centre[0], along_mm[1] - centre[1]];
            4.0 * (x * x + y * y) <= diameter_mm * diameter_mm
        };
        let fiducial =
            || self.fiducials_mm().iter().any(|&dot| within(dot, self.fiducial_diameter_mm));
        let [u, v] = along_mm.map(|place| place / self.spacing_mm);
        let half = self.marks.map(|count| (count as f64 - 1.0) / 2.0);
        match self.pattern {
            Pattern::Dots => {
                let nearest = [u, v].map(nearest_whole);
                let exists = nearest[0].abs() <= half[0] && nearest[1].abs() <= half[1];
                let centre = nearest.map(|n| n * self.spacing_mm);
                exists && within(centre, self.dot_diameter_mm) || fiducial()
            }
            Pattern::Checkerboard => {
                let inside = u.abs() <= half[0] + 1.0 && v.abs() <= half[1] + 1.0;
                let bright = (u.floor() + v.floor()).rem_euclid(2.0) == 0.0;
                inside && bright != fiducial()
            }
        }
    }

    /// How many of these points, moved by `moved_mm`, are bright: [`Self::is_bright`] for each, without branches,
    /// so that compilers turn the loop into vector instructions. All x come first, then all y.
    #[inline]
    pub fn count_bright<const N: usize>(
        &self,
        along_mm: &[[f64; N]; 2],
        moved_mm: [f64; 2],
    ) -> usize {
        let circle = |x: f64, y: f64, [a, b]: [f64; 2], diameter_mm: f64| {
            4.0 * ((x - a) * (x - a) + (y - b) * (y - b)) <= diameter_mm * diameter_mm
        };
        let fiducials = self.fiducials_mm();
        let fiducial = |x: f64, y: f64| {
            let within = |n: usize| circle(x, y, fiducials[n], self.fiducial_diameter_mm);
            within(0) | within(1) | within(2)
        };
        let per_mm = 1.0 / self.spacing_mm;
        let half = self.marks.map(|count| (count as f64 - 1.0) / 2.0);
        match self.pattern {
            Pattern::Dots => count_where(along_mm, moved_mm, |x, y| {
                let [u, v] = [x, y].map(|place| nearest_whole(place * per_mm));
                let exists = (u.abs() <= half[0]) & (v.abs() <= half[1]);
                let centre = [u, v].map(|n| n * self.spacing_mm);
                exists & circle(x, y, centre, self.dot_diameter_mm) | fiducial(x, y)
            }),
            Pattern::Checkerboard => count_where(along_mm, moved_mm, |x, y| {
                let [u, v] = [x, y].map(|place| place * per_mm);
                let inside = (u.abs() <= half[0] + 1.0) & (v.abs() <= half[1] + 1.0);
                let field = nearest_whole(u - 0.5) + nearest_whole(v - 0.5);
                let bright = 2.0 * nearest_whole(field / 2.0) == field;
                inside & (bright != fiducial(x, y))
            }),
        }
    }

    /// Distance of a point of the face from the nearest edge between bright and dark, in mm, or less;
    /// `along_mm` as in [`Self::place_mm`].
    pub fn edge_distance_mm(&self, along_mm: [f64; 2]) -> f64 {
        let from_circle = |centre: [f64; 2], diameter_mm: f64| {
            let [x, y] = [along_mm[0] - centre[0], along_mm[1] - centre[1]];
            ((x * x + y * y).sqrt() - diameter_mm / 2.0).abs()
        };
        let [u, v] = along_mm.map(|place| place / self.spacing_mm);
        let fiducials = self.fiducials_mm();
        let fiducial = fiducials.iter().map(|&dot| from_circle(dot, self.fiducial_diameter_mm));
        let mark = match self.pattern {
            Pattern::Dots => {
                let centre = [u, v].map(|place| nearest_whole(place) * self.spacing_mm);
                from_circle(centre, self.dot_diameter_mm)
            }
            Pattern::Checkerboard => {
                let off = [u, v].map(|place| (place - nearest_whole(place)).abs());
                off[0].min(off[1]) * self.spacing_mm
            }
        };
        fiducial.fold(mark, f64::min)
    }

    /// What is wrong with the card, in words for its owner; `None` if nothing is.
    pub fn fault(&self) -> Option<String> {
        let [right, up] = [self.right, self.up];
        if (right.norm() - 1.0).abs() > 1e-6 || (up.norm() - 1.0).abs() > 1e-6 {
            return Some("card.right and card.up: allowed: length 1 within 1e-6".into());
        }
        if right.dot(&up).abs() > 1e-6 {
            return Some("card.right and card.up: allowed: at right angles within 1e-6".into());
        }
        if self.marks.iter().any(|count| count % 2 == 0) {
            return Some(format!("card.marks = {:?}: allowed: odd numbers", self.marks));
        }
        if self.pattern == Pattern::Dots && self.dot_diameter_mm <= 0.0 {
            return Some("card.dot_diameter_mm is missing: dots have a diameter".into());
        }
        let largest = match self.pattern {
            Pattern::Dots => self.spacing_mm,
            Pattern::Checkerboard => 0.6 * self.spacing_mm,
        };
        let widest = self.dot_diameter_mm.max(self.fiducial_diameter_mm);
        (widest >= largest).then(|| {
            format!(
                "card: a dot of {widest} mm touches what is beside it: allowed: below {largest} mm"
            )
        })
    }
}

/// The number of points that satisfy `is_met` once they are moved by `moved_mm`.
#[inline(always)]
fn count_where<const N: usize>(
    [x, y]: &[[f64; N]; 2],
    moved_mm: [f64; 2],
    is_met: impl Fn(f64, f64) -> bool,
) -> usize {
    (0..N).map(|n| usize::from(is_met(x[n] + moved_mm[0], y[n] + moved_mm[1]))).sum()
}

/// The nearest whole number to one below 2⁵¹; half way between two of them, the even one. Adding
/// 1.5 · 2⁵² leaves no bits for a fraction. `f64::round` is a call into the mathematics library.
#[inline]
fn nearest_whole(number: f64) -> f64 {
    const NO_FRACTION: f64 = 1.5 * (1u64 << 52) as f64;
    number + NO_FRACTION - NO_FRACTION
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn card(pattern: Pattern) -> Card {
        Card {
            pattern,
            spacing_mm: 1.0,
            dot_diameter_mm: 0.5,
            fiducial_diameter_mm: 0.55,
            marks: [5, 3],
            right: Vector3::x(),
            up: Vector3::y(),
            two_sided_mm: Some(2.0),
        }
    }

    #[test]
    fn dots_and_fiducials_are_where_they_are_said() {
        let dots = card(Pattern::Dots);
        assert!(
            dots.is_bright([0.27, 0.0])
                && !dots.is_bright([1.27, 0.0])
                && dots.is_bright([2.27, 0.0])
        );
        assert!(!dots.is_bright([3.0, 0.0]) && dots.is_bright([-2.0, -1.0]));
        let squares = card(Pattern::Checkerboard);
        assert!(squares.is_bright([0.9, 0.9]) && !squares.is_bright([0.5, 0.5]));
        assert!(!squares.is_bright([-0.1, 0.5]) && squares.is_bright([-0.5, -0.5]));
        assert_eq!(dots.numbers().count(), 15);
    }

    /// Within the distance of the nearest edge nothing changes.
    #[test]
    fn edges_are_no_nearer_than_said() {
        for card in [card(Pattern::Dots), card(Pattern::Checkerboard)] {
            for n in 0..4000 {
                let place = [f64::from(n % 61) * 0.1 - 3.0, f64::from(n / 61) * 0.06 - 2.0];
                let distance = card.edge_distance_mm(place) * 0.999;
                for angle in (0..12).map(|n| f64::from(n) * 0.53) {
                    let near =
                        [place[0] + distance * angle.cos(), place[1] + distance * angle.sin()];
                    assert_eq!(card.is_bright(place), card.is_bright(near), "{place:?} {near:?}");
                }
            }
        }
    }

    #[test]
    fn the_back_of_a_two_sided_card_lies_its_thickness_behind() {
        let dots = card(Pattern::Dots);
        let seen_by = |axis| dots.place_mm(&Point3::origin(), [1.0, 0.0], &axis);
        assert_eq!(seen_by(Vector3::z()), Point3::new(1.0, 0.0, 0.0));
        assert_eq!(seen_by(-Vector3::z()), Point3::new(1.0, 0.0, -2.0));
    }

    #[test]
    fn faults_are_told() {
        assert_eq!(card(Pattern::Dots).fault(), None);
        let long = Card { right: Vector3::new(1.1, 0.0, 0.0), ..card(Pattern::Dots) };
        assert!(long.fault().unwrap().contains("length"));
        let even = Card { marks: [4, 3], ..card(Pattern::Dots) };
        assert!(even.fault().unwrap().contains("odd"));
        assert!(
            Card { spacing_mm: 0.5, ..card(Pattern::Dots) }.fault().unwrap().contains("touches")
        );
    }

    #[test]
    fn whole_numbers_are_the_nearest() {
        for n in -4000..4000 {
            let number = f64::from(n) * 0.013;
            assert_eq!(nearest_whole(number), number.round_ties_even(), "{number}");
        }
    }

    proptest! {
        #[test]
        fn bright_points_are_counted_as_one_by_one(
            x in prop::array::uniform16(-9.0..9.0), y in prop::array::uniform16(-9.0..9.0),
            right in -1.0..1.0f64, up in -1.0..1.0f64,
        ) {
            for pattern in [Pattern::Dots, Pattern::Checkerboard] {
                let card = card(pattern);
                let one_by_one = (0..16).filter(|&n| card.is_bright([x[n] + right, y[n] + up])).count();
                prop_assert_eq!(card.count_bright(&[x, y], [right, up]), one_by_one);
            }
        }
    }
}
