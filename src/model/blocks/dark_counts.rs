//! Counting for 64 voxels at a time.

/// Counters of dark views for many voxels, as bit planes that start so high that the carry out of
/// the last plane says "one more than forgiven".
pub(super) struct DarkCounts {
    words: usize,
    planes: usize,
    /// For each line its planes, one after the other.
    bits: Vec<u64>,
    exceeded: Vec<u64>,
}

impl DarkCounts {
    /// Counters for `lines` lines of `words` words, where `forgiven` dark views are allowed.
    pub fn new(lines: usize, words: usize, forgiven: usize) -> Self {
        let planes = (usize::BITS - forgiven.leading_zeros()) as usize;
        let start = (1usize << planes) - 1 - forgiven;
        let bits = (0..lines * planes)
            .flat_map(|n| {
                let set = start >> (n % planes) & 1 == 1;
                std::iter::repeat_n(if set { u64::MAX } else { 0 }, words)
            })
            .collect();
        Self { words, planes, bits, exceeded: vec![0; lines * words] }
    }

    /// Counts the voxels of a line whose bit is set in `dark`, which is used up.
    pub fn count(&mut self, line: usize, dark: &mut [u64]) {
        let size = self.planes * self.words;
        for plane in self.bits[line * size..][..size].chunks_exact_mut(self.words) {
            for (plane, carry) in plane.iter_mut().zip(dark.iter_mut()) {
                let sum = *plane ^ *carry;
                *carry &= *plane;
                *plane = sum;
            }
        }
        let exceeded = &mut self.exceeded[line * self.words..][..self.words];
        for (exceeded, carry) in exceeded.iter_mut().zip(dark) {
            *exceeded |= *carry;
        }
    }

    /// The voxels with no more dark views than forgiven.
    pub fn within(&self) -> Vec<u64> {
        self.exceeded.iter().map(|exceeded| !exceeded).collect()
    }
}
