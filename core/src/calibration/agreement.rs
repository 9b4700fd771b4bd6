//! How far the two estimators' grids are apart.

use serde::{Deserialize, Serialize};

use crate::lightfield::MicroImageGrid;

/// Distances at 95 % of the lenses and at the worst one, in pixels, within which two grids agree.
const AGREED_PX: [f64; 2] = [0.1, 0.2];

/// Distance of the grids of two estimators that share only their start, over the valid lenses. A residual
/// says how regular centres are; this says how far they depend on the way they are found.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Agreement {
    /// Distance that 95 % of the lenses are within, in pixels.
    pub at_95_percent_px: f64,
    /// The largest distance, in pixels.
    pub worst_px: f64,
}

impl Agreement {
    /// Compares two grids, numbered alike, at these lenses.
    pub(super) fn of(
        first: &MicroImageGrid,
        other: &MicroImageGrid,
        lenses: &[[usize; 2]],
    ) -> Self {
        let mut distances: Vec<f64> = lenses
            .iter()
            .map(|lens| {
                let [i, j] = lens.map(|index| index as f64);
                let (a, b) = (first.centre_px(i, j), other.centre_px(i, j));
                (a[0] - b[0]).hypot(a[1] - b[1])
            })
            .collect();
        distances.sort_by(f64::total_cmp);
        let at = distances.len().saturating_sub(1) * 95 / 100;
        Self {
            at_95_percent_px: distances.get(at).copied().unwrap_or(f64::NAN),
            worst_px: distances.last().copied().unwrap_or(f64::NAN),
        }
    }

    /// Whether they agree within 0.1 px at 95 % of the lenses and within 0.2 px at all.
    pub fn is_good(&self) -> bool {
        self.at_95_percent_px <= AGREED_PX[0] && self.worst_px <= AGREED_PX[1]
    }
}
