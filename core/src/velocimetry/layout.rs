//! How the nodes of a lattice lie in memory.

/// A lattice's nodes in memory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Layout {
    /// Nodes along x, y, z; stored z, y, x.
    pub nodes: [usize; 3],
}

impl Layout {
    /// Nodes in all.
    pub fn len(self) -> usize {
        self.nodes.iter().product()
    }

    /// Place of node `n` along x, y, z.
    pub fn place(self, n: usize) -> [usize; 3] {
        let [nx, ny, _] = self.nodes;
        [n % nx, n / nx % ny, n / (nx * ny)]
    }

    /// Number of the node at a place: the inverse of [`Self::place`].
    pub fn number(self, [x, y, z]: [usize; 3]) -> usize {
        (z * self.nodes[1] + y) * self.nodes[0] + x
    }

    /// Nodes in memory from one to the next along `axis`.
    pub fn stride(self, axis: usize) -> usize {
        self.nodes[..axis].iter().product()
    }
}
