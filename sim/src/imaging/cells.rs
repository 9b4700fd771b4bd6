//! Rows of microlenses and of pixels.

/// A row of equal cells centred on the optical axis, prepared for fast lookup.
#[derive(Debug, Clone)]
pub(super) struct Cells {
    per_mm: f64,
    count: f64,
}

impl Cells {
    pub(super) fn new(pitch_mm: f64, count: usize) -> Self {
        Self { per_mm: 1.0 / pitch_mm, count: count as f64 }
    }

    /// Index of the cell whose centre is nearest, or `None` outside the row.
    #[inline]
    pub(super) fn nearest(&self, position_mm: f64) -> Option<u32> {
        let from_edge = position_mm * self.per_mm + self.count / 2.0;
        // The cast truncates; `floor` would be a function call on processors without SSE 4.1.
        (from_edge >= 0.0 && from_edge < self.count).then_some(from_edge as u32)
    }

    /// Position in the row: 0 is the centre of the first cell.
    pub(super) fn place(&self, position_mm: f64) -> f64 {
        position_mm * self.per_mm + (self.count - 1.0) / 2.0
    }
}
