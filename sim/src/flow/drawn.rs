//! Random waves that are drawn from a flow's settings when they are first needed.

use std::sync::OnceLock;

/// The waves of a flow, drawn once.
#[derive(Debug, Clone)]
pub(super) struct DrawnWaves<W>(OnceLock<Vec<W>>);

impl<W> DrawnWaves<W> {
    /// The waves; `draw` makes them the first time.
    pub fn get_or_draw(&self, draw: impl FnOnce() -> Vec<W>) -> &[W] {
        self.0.get_or_init(draw)
    }
}

impl<W> Default for DrawnWaves<W> {
    fn default() -> Self {
        Self(OnceLock::new())
    }
}

/// Always equal, because waves follow from the settings, which are compared.
impl<W> PartialEq for DrawnWaves<W> {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}
