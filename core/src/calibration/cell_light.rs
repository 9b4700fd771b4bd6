//! Mean light of every micro-image, to find dark lenses and the light that neighbours add to each other.

use super::WhiteImage;
use crate::lightfield::MicroImageGrid;

/// Quantile of the pixels that replaces an unmeasured black level.
const DARKEST_SHARE: f64 = 0.01;

/// Mean light of each lens' cell above the darkest pixels of the image.
#[derive(Debug, Clone)]
pub(super) struct CellLight {
    microlenses: [usize; 2],
    /// Mean light; NaN if less than half of the cell is on the image.
    mean: Vec<f64>,
    /// 90th percentile of the lit lenses.
    bright: f64,
}

impl CellLight {
    pub fn of_image(image: &WhiteImage, grid: &MicroImageGrid) -> Self {
        let [nx, ny] = grid.microlenses;
        let mut sums = vec![[0.0; 2]; nx * ny];
        for row in 0..image.rows() {
            for column in 0..image.columns() {
                let lens = grid.lens_at(column as f64, row as f64).map(f64::round);
                if lens[0] >= 0.0
                    && lens[1] >= 0.0
                    && (lens[0] as usize) < nx
                    && (lens[1] as usize) < ny
                {
                    let sum = &mut sums[lens[1] as usize * nx + lens[0] as usize];
                    *sum = [sum[0] + image.at(column, row), sum[1] + 1.0];
                }
            }
        }
        let mut sorted: Vec<f32> = image.light().iter().copied().step_by(7).collect();
        let n = (sorted.len() as f64 * DARKEST_SHARE) as usize;
        let darkest = f64::from(*sorted.select_nth_unstable_by(n, f32::total_cmp).1);
        let [a, b] = [grid.column_px, grid.row_px];
        let area = (a[1] * b[2] - a[2] * b[1]).abs();
        let mean =
            sums.iter().map(
                |[light, pixels]| {
                    if *pixels < 0.5 * area { f64::NAN } else { light / pixels - darkest }
                },
            );
        let mean: Vec<f64> = mean.collect();
        let mut lit: Vec<f64> = mean.iter().copied().filter(|light| *light > 0.0).collect();
        lit.sort_by(f64::total_cmp);
        let bright = lit.get(lit.len() * 9 / 10).copied().unwrap_or(0.0);
        Self { microlenses: grid.microlenses, mean, bright }
    }

    /// Mean light of a lens, if it is on the image and lit.
    pub fn of(&self, [i, j]: [usize; 2]) -> Option<f64> {
        let light = self.mean[j * self.microlenses[0] + i];
        (light > 0.0).then_some(light)
    }

    /// Mean light of a lens of which at least half is on the image.
    pub fn on_image(&self, [i, j]: [usize; 2]) -> Option<f64> {
        let light = self.mean[j * self.microlenses[0] + i];
        (!light.is_nan()).then_some(light)
    }

    /// Light of bright lenses: the 90th percentile of the lit ones.
    pub fn bright(&self) -> f64 {
        self.bright
    }

    /// The lens as an unsigned index, if it is in the array.
    pub fn in_array(&self, lens: [i64; 2]) -> Option<[usize; 2]> {
        let [i, j] = lens.map(|index| usize::try_from(index).ok());
        let lens = [i?, j?];
        (lens[0] < self.microlenses[0] && lens[1] < self.microlenses[1]).then_some(lens)
    }

    /// Mean light of a lens' neighbour, at least 0. `None` outside the image.
    pub fn of_neighbour(&self, lens: [usize; 2], step: [i64; 2]) -> Option<f64> {
        let neighbour = self.in_array([0, 1].map(|axis| lens[axis] as i64 + step[axis]))?;
        self.on_image(neighbour).map(|light| light.max(0.0))
    }
}
