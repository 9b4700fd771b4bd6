//! Counting for 256 voxels at a time.

/// Voxels that are counted together: what a vector of AVX2 holds.
pub(super) const LINE_VOXELS: usize = 256;

/// One bit per voxel.
pub(super) type Line = [u64; LINE_VOXELS / 64];

/// Counters of dark views for many voxels, as bit planes that start so high that the carry out of
/// the last plane says "one more than forgiven".
pub(super) struct DarkCounts {
    planes: usize,
    /// For each line its planes, one after the other.
    bits: Vec<Line>,
    exceeded: Vec<Line>,
}

impl DarkCounts {
    /// Counters for `lines` lines, where `forgiven` dark views are allowed.
    pub fn new(lines: usize, forgiven: usize) -> Self {
        let planes = (usize::BITS - forgiven.leading_zeros()) as usize;
        let start = (1usize << planes) - 1 - forgiven;
        let plane = |n: usize| if start >> (n % planes) & 1 == 1 { u64::MAX } else { 0 };
        let bits = (0..lines * planes).map(|n| [plane(n); LINE_VOXELS / 64]).collect();
        Self { planes, bits, exceeded: vec![Line::default(); lines] }
    }

    /// Counts the voxels of a line whose bit is set in `dark`.
    #[inline(always)]
    pub fn count(&mut self, line: usize, dark: Line) {
        let exceeded = &mut self.exceeded[line];
        let mut carry = dark;
        for word in 0..carry.len() {
            carry[word] &= !exceeded[word];
        }
        // Most voxels are soon beyond counting, and the others are lit in nearly every view.
        if carry.iter().fold(0, |any, word| any | word) == 0 {
            return;
        }
        for plane in &mut self.bits[line * self.planes..][..self.planes] {
            for word in 0..carry.len() {
                let sum = plane[word] ^ carry[word];
                carry[word] &= plane[word];
                plane[word] = sum;
            }
        }
        for word in 0..carry.len() {
            exceeded[word] |= carry[word];
        }
    }

    /// The voxels with no more dark views than forgiven.
    pub fn within(&self) -> Vec<Line> {
        self.exceeded.iter().map(|line| line.map(|word| !word)).collect()
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn counts_as_a_number_per_voxel(
            forgiven in 0usize..20,
            dark in prop::collection::vec((0usize..3, any::<[u64; 4]>()), 0..60),
        ) {
            let mut counts = DarkCounts::new(3, forgiven);
            let mut naive = vec![0; 3 * LINE_VOXELS];
            for (line, bits) in dark {
                counts.count(line, bits);
                for (voxel, count) in naive[line * LINE_VOXELS..][..LINE_VOXELS].iter_mut().enumerate() {
                    *count += (bits[voxel / 64] >> (voxel % 64) & 1) as usize;
                }
            }
            let within = counts.within();
            for (voxel, count) in naive.into_iter().enumerate() {
                let bit = within[voxel / LINE_VOXELS][voxel % LINE_VOXELS / 64] >> (voxel % 64) & 1;
                prop_assert_eq!(bit == 1, count <= forgiven);
            }
        }
    }
}
