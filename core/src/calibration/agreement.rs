//! Distance between the grids of the two estimators.

use serde::{Deserialize, Serialize};

use crate::lightfield::MicroImageGrid;

/// Largest 95th percentile and largest maximum of the distance between grids that agree, in pixels.
const AGREED_PX: [f64; 2] = [0.1, 0.2];

/// Distance between the grids of two estimators that share only their initial values. Residuals show how regular
/// the centres are; this distance shows how much they depend on the method.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Agreement {
    /// 95th percentile of the distance, in pixels.
    pub at_95_percent_px: f64,
    /// The largest distance, in pixels.
    pub worst_px: f64,
}

impl Agreement {
    /// Compares two grids with the same numbering at these lenses.
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
