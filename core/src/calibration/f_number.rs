//! Match of the f-numbers of main lens and microlenses.

use std::fmt;

use serde::{Deserialize, Serialize};

/// Largest relative difference between diameter and pitch of matching f-numbers.
const MATCHED_WITHIN: f64 = 0.01;

/// Size of the micro-images relative to their pitch. A micro-image is an image of the main lens' stop, so its
/// diameter is inversely proportional to the f-number.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct FNumberMatch {
    /// Diameter of the micro-images divided by their pitch.
    pub diameter_over_pitch: f64,
    /// Number of stops to close the main lens; negative: to open it.
    pub close_by_stops: f64,
}

impl FNumberMatch {
    pub(super) fn of(radius_px: f64, pitch_px: f64) -> Self {
        let diameter_over_pitch = 2.0 * radius_px / pitch_px;
        // One stop is a factor of √2 in diameter.
        Self { diameter_over_pitch, close_by_stops: 2.0 * diameter_over_pitch.log2() }
    }
}

impl fmt::Display for FNumberMatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = 100.0 * (self.diameter_over_pitch - 1.0);
        let stops = self.close_by_stops.abs();
        if percent.abs() <= 100.0 * MATCHED_WITHIN {
            write!(f, "micro-images fill their pitch: the f-number matches")
        } else if percent > 0.0 {
            write!(
                f,
                "micro-images are {percent:.1} % larger than their pitch: close the main lens by \
                 {stops:.2} stops"
            )
        } else {
            write!(
                f,
                "micro-images are {:.1} % smaller than their pitch: open the main lens by {stops:.2} \
                 stops",
                -percent
            )
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_words_say_which_way_to_turn_the_ring() {
        let wide = FNumberMatch::of(10.0 * 2f64.sqrt(), 20.0);
        assert!((wide.close_by_stops - 1.0).abs() < 1e-12);
        assert!(wide.to_string().ends_with("close the main lens by 1.00 stops"), "{wide}");
        let narrow = FNumberMatch::of(9.0, 20.0).to_string();
        assert!(narrow.contains("10.0 % smaller") && narrow.contains("open the main"), "{narrow}");
        assert!(FNumberMatch::of(10.05, 20.0).to_string().contains("matches"));
    }
}
