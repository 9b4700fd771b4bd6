//! The displacements that are tried.

/// Lags −reach to reach along each axis, x fastest.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Lags {
    /// Largest lag along an axis, in cells: 1 to [`Lags::FARTHEST`].
    pub reach: usize,
}

impl Lags {
    /// The most that the kernel is made for.
    pub const FARTHEST: usize = 6;

    /// Lags along one axis.
    pub fn edge(self) -> usize {
        2 * self.reach + 1
    }

    /// Number of lags.
    pub fn count(self) -> usize {
        self.edge().pow(3)
    }

    /// The components of lag number `index`.
    pub fn components(self, index: usize) -> [i64; 3] {
        let n = self.edge();
        [index % n, index / n % n, index / (n * n)].map(|c| c as i64 - self.reach as i64)
    }

    /// Cells that the frames must reach beyond the windows.
    pub fn border(self) -> usize {
        self.reach.div_ceil(2)
    }
}
