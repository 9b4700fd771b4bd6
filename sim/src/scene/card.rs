//! Images of a calibration card at its positions.

use garde::Validate;
use lfpiv_hw::{RawImage, card::CalibrationCard, check::finite};
use nalgebra::Point3;
use rand::RngExt;
use rand_distr::{Distribution, StandardNormal, UnitSphere};
use serde::{Deserialize, Serialize};

use super::Scene;
use crate::{
    geometry::BenchGeometry,
    imaging::PlacedCard,
    stream::{Purpose, random_stream},
};

/// Deviations of a card from its file: the `[simulation.card]` table.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct CardErrors {
    /// Standard deviation of the card's true positions from the stated ones, along each world axis,
    /// in µm.
    #[garde(custom(finite), range(min = 0.0, max = 1000.0))]
    pub stage_um: f64,
    /// Root-mean-square deviation of its face from a plane, in µm.
    #[garde(custom(finite), range(min = 0.0, max = 1000.0))]
    pub flatness_um: f64,
}

impl Scene {
    /// The image of the evenly illuminated card at position number `position`; the exposure is that
    /// of a white image. `seed` selects noise and the card's errors; the result does not depend on
    /// the number of threads.
    ///
    /// `None` for a camera or position that does not exist, and for a card that touches a wall.
    pub fn card_image(
        &self,
        bench: &BenchGeometry,
        camera: usize,
        card: &CalibrationCard,
        position: usize,
        seed: u64,
    ) -> Option<RawImage> {
        let placed = self.placed_card(card, position, seed)?;
        let key = [camera as u64, position as u64];
        let (rays, electrons) = self.white_exposure(camera);
        let light = self.tracer(bench, camera)?.trace_card(&placed, rays, electrons, &key)?;
        let key = [seed, position as u64, camera as u64, super::white::Exposure::Card as u64];
        Some(self.sensor_of(camera).expose(&light, &key))
    }

    fn placed_card<'a>(
        &self,
        card: &'a CalibrationCard,
        position: usize,
        seed: u64,
    ) -> Option<PlacedCard<'a>> {
        let stated_mm = Point3::from(card.position.get(position)?.origin_mm);
        let mut stage = random_stream(Purpose::Card, &[seed, position as u64]);
        let off_mm: [f64; 3] = std::array::from_fn(|_| {
            let deviation: f64 = stage.sample(StandardNormal);
            deviation * self.card.stage_um * 1e-3
        });
        // One random bend for all positions, because it is one card.
        let bend: [f64; 3] = UnitSphere.sample(&mut random_stream(Purpose::Card, &[seed]));
        Some(PlacedCard {
            card: &card.card,
            origin_mm: stated_mm + nalgebra::Vector3::from(off_mm),
            bend_mm: bend.map(|share| share * self.card.flatness_um * 1e-3),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_of_a_card_have_the_configured_size() {
        let text = "[card]\npattern = 'dots'\nspacing_mm = 1\ndot_diameter_mm = 0.5\n\
                    fiducial_diameter_mm = 0.7\nmarks = [9, 9]\nright = [1, 0, 0]\nup = [0, 1, 0]\n";
        let positions = "[[position]]\norigin_mm = [0, 0, 1]\n".repeat(400);
        let card: CalibrationCard = toml::from_str(&format!("{text}{positions}")).unwrap();
        let scene =
            Scene { card: CardErrors { stage_um: 5.0, flatness_um: 3.0 }, ..Scene::default() };
        let placed = |position| scene.placed_card(&card, position, 7);
        assert!(placed(400).is_none());
        let squares: f64 = (0..400)
            .flat_map(|n| {
                let off_mm = placed(n).unwrap().origin_mm - Point3::new(0.0, 0.0, 1.0);
                <[f64; 3]>::from(off_mm)
            })
            .map(|mm| mm * mm)
            .sum();
        assert!(((squares / 1200.0).sqrt() - 0.005).abs() < 3e-4);
        let bend = placed(3).unwrap().bend_mm;
        assert_eq!(bend, placed(8).unwrap().bend_mm);
        assert!((bend.iter().map(|mm| mm * mm).sum::<f64>().sqrt() - 0.003).abs() < 1e-12);
    }
}
