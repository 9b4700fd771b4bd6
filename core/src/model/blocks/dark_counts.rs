//! Counting of dark views for a whole line of voxels at once.

/// One bit per voxel of a line of 64·`W`.
pub(super) type Line<const W: usize> = [u64; W];

/// Counters of dark views for many voxels, as bit planes. Their initial value is such that the carry out of the
/// last plane indicates more dark views than tolerated.
pub(super) struct DarkCounts<const W: usize> {
    planes: usize,
    /// The planes of each line, consecutively.
    bits: Vec<Line<W>>,
    exceeded: Vec<Line<W>>,
}

/// Numbers of planes with unrolled loops, so that a line is counted in registers.
const PLANES: [usize; 4] = [3, 4, 8, 16];

/// Upper bound of the number of views.
const MAX_TOLERATED: usize = (1 << 16) - 1;

impl<const W: usize> DarkCounts<W> {
    /// Counters for `lines` lines, with `tolerated` dark views allowed. Only the voxels of
    /// `inside` are counted; the others exceed the limit from the start.
    pub fn new(lines: usize, inside: Line<W>, tolerated: usize) -> Self {
        let tolerated = tolerated.min(MAX_TOLERATED);
        let fits = |planes: &usize| tolerated >> planes == 0;
        let planes = PLANES.into_iter().find(fits).unwrap_or(PLANES[PLANES.len() - 1]);
        let start = (1usize << planes) - 1 - tolerated;
        let plane = |n: usize| if start >> (n % planes) & 1 == 1 { u64::MAX } else { 0 };
        let bits = (0..lines * planes).map(|n| [plane(n); W]).collect();
        Self { planes, bits, exceeded: vec![inside.map(|word| !word); lines] }
    }

    /// Whether any voxel of the line has no more dark views than tolerated.
    #[inline(always)]
    pub fn is_open(&self, line: usize) -> bool {
        self.exceeded[line] != [u64::MAX; W]
    }

    /// Counts the voxels of a line whose bit is set, for each view.
    #[inline(always)]
    pub fn count(&mut self, line: usize, dark: &[Line<W>]) {
        let exceeded = &mut self.exceeded[line];
        let planes = &mut self.bits[line * self.planes..][..self.planes];
        match self.planes {
            3 => count_in::<W, 3>(planes, exceeded, dark),
            4 => count_in::<W, 4>(planes, exceeded, dark),
            8 => count_in::<W, 8>(planes, exceeded, dark),
            _ => count_in::<W, 16>(planes, exceeded, dark),
        }
    }

    /// The voxels with no more dark views than tolerated.
    pub fn within(&self) -> Vec<Line<W>> {
        self.exceeded.iter().map(|line| line.map(|word| !word)).collect()
    }
}

#[inline(always)]
fn count_in<const W: usize, const P: usize>(
    planes: &mut [Line<W>],
    exceeded: &mut Line<W>,
    dark: &[Line<W>],
) {
    let Some(planes) = planes.first_chunk_mut::<P>() else { return };
    let (mut bits, mut beyond) = (*planes, *exceeded);
    for dark in dark {
        let mut carry = *dark;
        for plane in &mut bits {
            for word in 0..W {
                let sum = plane[word] ^ carry[word];
                carry[word] &= plane[word];
                plane[word] = sum;
            }
        }
        for word in 0..W {
            beyond[word] |= carry[word];
        }
    }
    (*planes, *exceeded) = (bits, beyond);
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn counts_as_a_number_per_voxel(
            tolerated in prop_oneof![0usize..20, Just(300)],
            inside in any::<[u64; 2]>(),
            dark in prop::collection::vec(
                (0usize..3, prop::collection::vec(any::<[u64; 2]>(), 0..9)), 0..12,
            ),
        ) {
            let mut counts = DarkCounts::new(3, inside, tolerated);
            let mut naive = vec![0; 3 * 128];
            for (line, views) in dark {
                counts.count(line, &views);
                for bits in views {
                    for (voxel, count) in naive[line * 128..][..128].iter_mut().enumerate() {
                        *count += (bits[voxel / 64] >> (voxel % 64) & 1) as usize;
                    }
                }
            }
            let within = counts.within();
            for (n, count) in naive.into_iter().enumerate() {
                let (line, word, bit) = (n / 128, n % 128 / 64, n % 64);
                let expected = inside[word] >> bit & 1 == 1 && count <= tolerated;
                prop_assert_eq!(within[line][word] >> bit & 1 == 1, expected);
                prop_assert!(!expected || counts.is_open(line));
            }
        }
    }
}
