//! The light collected by a sensor.

use lfpiv_hw::Optics;

/// Collected light in photo-electrons; row-major, row 0 at the top.
#[derive(Debug, Clone, PartialEq)]
pub struct ElectronImage {
    columns: usize,
    rows: usize,
    electrons: Vec<f32>,
}

impl ElectronImage {
    /// A dark image of the sensor's size.
    pub fn dark(optics: &Optics) -> Self {
        Self::uniform(optics.sensor.columns, optics.sensor.rows, 0.0)
    }

    /// An image with equal light on every pixel.
    pub fn uniform(columns: usize, rows: usize, electrons: f32) -> Self {
        Self { columns, rows, electrons: vec![electrons; columns * rows] }
    }

    /// Number of pixel columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Number of pixel rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Mean photo-electrons per pixel, row-major, length `columns × rows`.
    pub fn electrons(&self) -> &[f32] {
        &self.electrons
    }

    /// Mutable access to [`Self::electrons`].
    pub(super) fn electrons_mut(&mut self) -> &mut [f32] {
        &mut self.electrons
    }

    /// Adds the light of another exposure of the same sensor.
    pub fn add(&mut self, other: &Self) {
        for (mine, others) in self.electrons.iter_mut().zip(&other.electrons) {
            *mine += others;
        }
    }

    /// Sum over all pixels.
    pub fn total(&self) -> f64 {
        self.electrons.iter().map(|&electrons| f64::from(electrons)).sum()
    }
}
