//! How far a displacement can be trusted, from the light under its correlation peak.
//!
//! A perfectly reconstructed and deformed pair gives a correlation that is symmetric about its
//! peak, voxel by voxel: a(x) b(x + e) = a(x + e) b(x). What each part of the window contributes to
//! the asymmetry is therefore a sample of the error, and the spread of the contributions gives the
//! variance of their sum (Wieneke, "PIV uncertainty quantification from correlation statistics",
//! Meas. Sci. Technol. 26, 074002, 2015, carried over to three dimensions). The peak's place by the
//! three-point Gaussian fit follows to first order from the asymmetry.
//!
//! What all of a window's particles have in common is not in their spread: the window answers a
//! residual displacement that varies inside it only in part. [`UNANSWERED`] of the residual is
//! added for it.

use super::raster::Image;

/// Share of the last pass's residual displacement that is taken for unanswered. A window of length
/// L answers a wave of length 4 L along one axis to sin(π/4)/(π/4) = 0.90, along two to 0.81.
const UNANSWERED: f32 = 0.19;

/// Below this many particles their spread says little, and a displacement counts as known to a
/// voxel at best: variance 1/12 (GUM 4.3.7).
const FEW_PARTICLES: f32 = 4.0;
const VOXEL_VARIANCE: f32 = 1.0 / 12.0;

/// What single precision and the three-point fit resolve, in voxels.
const RESOLUTION_VOX: f32 = 1e-3;

/// One particle cannot confirm itself: with fewer than two nothing is known.
const LEAST_PARTICLES: f32 = 2.0;

/// Edge of the cells into which contributions are summed, in voxels. A particle's contributions
/// belong together: with the neighbouring cells a cell spans six voxels, a rendered particle four.
const CELL: i64 = 2;

/// What the light in a window says about the place of its correlation peak.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PeakStatistics {
    /// Variance of the peak's place along x, y, z, in voxel².
    pub variance_vox2: [f32; 3],
    /// Equally bright particles that would share the peak's light as evenly (participation ratio).
    pub particles: f32,
    /// Correlation coefficient of the two frames at the peak, −1 to 1.
    pub coefficient: f32,
}

/// Sums over one cell: asymmetry and symmetric part along x, y, z, and light common to both frames.
type Cell = [f32; 7];
const COMMON: usize = 6;

/// Cells of one window, stored z, y, x.
struct Cells {
    counts: [usize; 3],
    sums: Vec<Cell>,
    /// Σ a² and Σ b².
    energy: [f64; 2],
    /// Pairs of voxels at no distance, and at a distance of one along each axis.
    pairs: [f64; 4],
}

impl PeakStatistics {
    /// Standard uncertainty of a displacement along x, y, z, in voxels, when the last pass still
    /// had to add `residual_vox`; `None` when too few particles take part to tell.
    ///
    /// The variance from n particles is that of Student's distribution with n − 1 degrees of
    /// freedom, (n − 1)/(n − 3) times the sample's (JCGM 101, 6.4.9.2), which is itself n/(n − 1)
    /// times the mean square.
    pub fn uncertainty_vox(&self, residual_vox: [f32; 3]) -> Option<[f32; 3]> {
        if self.particles < LEAST_PARTICLES {
            return None;
        }
        let few = self.particles < FEW_PARTICLES;
        let n = self.particles.max(FEW_PARTICLES);
        Some(std::array::from_fn(|axis| {
            let random = self.variance_vox2[axis] * n / (n - 3.0);
            let random = if few { random.max(VOXEL_VARIANCE) } else { random };
            (random + (UNANSWERED * residual_vox[axis]).powi(2)).sqrt().max(RESOLUTION_VOX)
        }))
    }

    /// Statistics of a window of edge `window` at `corner`, whose correlation a(x) b(x + s) peaks
    /// near `lag`. `None` where the light has no peak there.
    pub fn of(a: Image, b: Image, corner: [i64; 3], window: usize, lag: [i64; 3]) -> Option<Self> {
        let cells = Cells::of(a, b, corner, window, lag);
        let total = |n: usize| cells.sums.iter().map(|cell| f64::from(cell[n])).sum::<f64>();
        let common = total(COMMON);
        let mut influence = vec![[0.0f32; 4]; cells.sums.len()];
        for axis in 0..3 {
            let (asymmetry, symmetric) = (total(axis), total(3 + axis));
            // C(1) and C(-1), with as many pairs of voxels as C(0).
            let weight = cells.pairs[0] / cells.pairs[1 + axis].max(1.0);
            let sides = [symmetric + asymmetry, symmetric - asymmetry].map(|s| weight * s / 2.0);
            let [above, below] = sides;
            if common.min(above).min(below).partial_cmp(&0.0)? != std::cmp::Ordering::Greater {
                return None;
            }
            let curvature = 2.0 * common.ln() - above.ln() - below.ln();
            if curvature <= LEAST_CURVATURE {
                return None;
            }
            // The shift is (ln C(1) - ln C(-1)) / 2 curvature, to first order the asymmetry over
            // the symmetric part and the curvature.
            let (mean, scale) = (asymmetry / symmetric, 1.0 / (symmetric * curvature));
            for (influence, cell) in influence.iter_mut().zip(&cells.sums) {
                let excess = f64::from(cell[axis]) - mean * f64::from(cell[3 + axis]);
                influence[axis] = (excess * scale) as f32;
            }
        }
        for (influence, cell) in influence.iter_mut().zip(&cells.sums) {
            influence[3] = (f64::from(cell[COMMON]) / common) as f32;
        }
        let spread = clustered_squares(&influence, cells.counts);
        // So much of the window lies within reach of a cell: by chance alone that share of the
        // other particles is taken for the same one. Contributions that sum to zero lose as much.
        let chance = share_within_reach(cells.counts);
        let [energy_a, energy_b] = cells.energy;
        Some(Self {
            variance_vox2: std::array::from_fn(|axis| spread[axis] / (1.0 - chance).max(0.1)),
            particles: 1.0 / (spread[3] - chance).max(1.0 / MOST_PARTICLES),
            coefficient: (common / (energy_a * energy_b).sqrt()) as f32,
        })
    }
}

/// More particles than this are not told from infinitely many.
const MOST_PARTICLES: f32 = 1000.0;

/// A correlation flatter than this about its peak has none.
const LEAST_CURVATURE: f64 = 1e-3;

impl Cells {
    fn of(a: Image, b: Image, corner: [i64; 3], window: usize, lag: [i64; 3]) -> Self {
        let in_a = a.inside(corner, window);
        let in_b = b.inside(std::array::from_fn(|c| corner[c] + lag[c]), window);
        // Voxels of frame a whose partners in frame b are inside, too.
        let both: [[i64; 2]; 3] = std::array::from_fn(|c| {
            let low = in_a[c][0].max(in_b[c][0] - lag[c]);
            [low, in_a[c][1].min(in_b[c][1] - lag[c]).max(low)]
        });
        let edges = both.map(|[low, high]| high - low);
        let counts = edges.map(|n| (n as usize).div_ceil(CELL as usize).max(1));
        let mut cells = Self {
            counts,
            sums: vec![[0.0; 7]; counts.iter().product()],
            energy: [0.0; 2],
            pairs: [0.0; 4],
        };
        let mean_a = mean_of(a, both);
        let mean_b = mean_of(b, std::array::from_fn(|c| both[c].map(|end| end + lag[c])));
        let [xs, ys, zs] = both;
        let length = edges[0] as usize;
        // Rows of both frames, less the mean, at y and z and one further along each axis.
        let mut rows = [[(); 2]; 3].map(|pair| pair.map(|()| vec![0.0f32; length]));
        let fetch = |rows: &mut [Vec<f32>; 2], y: i64, z: i64| {
            let shifted = xs.map(|end| end + lag[0]);
            for (to, from) in rows[0].iter_mut().zip(a.row(xs, y, z)) {
                *to = from - mean_a;
            }
            for (to, from) in rows[1].iter_mut().zip(b.row(shifted, y + lag[1], z + lag[2])) {
                *to = from - mean_b;
            }
        };
        for z in zs[0]..zs[1] {
            for y in ys[0]..ys[1] {
                fetch(&mut rows[0], y, z);
                let further = [true, y + 1 < ys[1], z + 1 < zs[1]];
                if further[1] {
                    fetch(&mut rows[1], y + 1, z);
                }
                if further[2] {
                    fetch(&mut rows[2], y, z + 1);
                }
                let place = [(y - ys[0]) / CELL, (z - zs[0]) / CELL].map(|c| c as usize);
                cells.add(&rows, further, place);
            }
        }
        cells
    }

    /// Adds what one row of voxels contributes to the row of cells at `y`, `z`. `rows` are the two
    /// frames at the row, one voxel further along y, and one further along z; `further` says which
    /// axes have a next voxel.
    fn add(&mut self, rows: &[[Vec<f32>; 2]; 3], further: [bool; 3], [y, z]: [usize; 2]) {
        let start = (z * self.counts[1] + y) * self.counts[0];
        let cells = &mut self.sums[start..start + self.counts[0]];
        let [a, b] = &rows[0];
        self.pairs[0] += a.len() as f64;
        for (cell, [a, b]) in cells.iter_mut().zip(parts(a, b)) {
            for (a, b) in a.iter().zip(b) {
                cell[COMMON] += a * b;
            }
        }
        for (energy, row) in self.energy.iter_mut().zip([a, b]) {
            *energy += f64::from(row.iter().map(|value| value * value).sum::<f32>());
        }
        for axis in (0..3).filter(|&axis| further[axis]) {
            let (next, skip) = if axis == 0 { (&rows[0], 1) } else { (&rows[axis], 0) };
            let [next_a, next_b] = next.each_ref().map(|row| row.get(skip..).unwrap_or(&[]));
            self.pairs[1 + axis] += next_a.len() as f64;
            let here_and_next = parts(a, b).zip(parts(next_a, next_b));
            for (cell, ([a, b], [next_a, next_b])) in cells.iter_mut().zip(here_and_next) {
                for ((a, b), (next_a, next_b)) in a.iter().zip(b).zip(next_a.iter().zip(next_b)) {
                    let (forward, backward) = (a * next_b, next_a * b);
                    cell[axis] += forward - backward;
                    cell[3 + axis] += forward + backward;
                }
            }
        }
    }
}

/// The parts of a row of both frames that fall into its cells.
fn parts<'a>(a: &'a [f32], b: &'a [f32]) -> impl Iterator<Item = [&'a [f32]; 2]> {
    let cell = CELL as usize;
    a.chunks(cell).zip(b.chunks(cell)).map(|(a, b)| [a, b])
}

fn mean_of(image: Image, [xs, ys, zs]: [[i64; 2]; 3]) -> f32 {
    let (mut sum, mut count) = (0.0f64, 0);
    for z in zs[0]..zs[1] {
        for y in ys[0]..ys[1] {
            let row = image.row(xs, y, z);
            sum += row.iter().map(|&v| f64::from(v)).sum::<f64>();
            count += row.len();
        }
    }
    (sum / count.max(1) as f64) as f32
}

/// Variance of the sum of correlated contributions: each times the sum of itself and its
/// neighbours, beyond which they are independent. Never less than if all were.
fn clustered_squares(values: &[[f32; 4]], counts: [usize; 3]) -> [f32; 4] {
    let mut around = values.to_vec();
    for (axis, stride) in [1, counts[0], counts[0] * counts[1]].into_iter().enumerate() {
        let from = around.clone();
        for (index, sum) in around.iter_mut().enumerate() {
            let place = index / stride % counts[axis];
            let below = if place > 0 { from[index - stride] } else { [0.0; 4] };
            let above = if place + 1 < counts[axis] { from[index + stride] } else { [0.0; 4] };
            for ((sum, below), above) in sum.iter_mut().zip(below).zip(above) {
                *sum += below + above;
            }
        }
    }
    std::array::from_fn(|n| {
        let (mut correlated, mut independent) = (0.0f64, 0.0f64);
        for (value, sum) in values.iter().zip(&around) {
            correlated += f64::from(value[n] * sum[n]);
            independent += f64::from(value[n] * value[n]);
        }
        correlated.max(independent) as f32
    })
}

/// Mean share of all cells that [`clustered_squares`] joins to one.
fn share_within_reach(counts: [usize; 3]) -> f32 {
    counts.map(|n| (3.0 - 2.0 / n as f32).min(n as f32) / n as f32).iter().product()
}

#[cfg(test)]
mod tests;
