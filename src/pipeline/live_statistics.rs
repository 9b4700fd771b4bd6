//! The statistics of the run so far, one shot after the other.

use std::sync::Arc;

use lfpiv_core::{
    ensemble::{Ensemble, Snapshot},
    velocimetry::{VectorGrid, VelocityField},
};
use parking_lot::Mutex;

/// See the module.
#[derive(Debug, Default)]
pub struct LiveStatistics(Mutex<Option<Arc<Ensemble>>>);

impl LiveStatistics {
    /// Adds the valid vectors of a shot; each shot once.
    pub fn add_field(&self, shot: u64, field: &VelocityField) {
        self.add(&field.grid, &Snapshot::of_field(shot, field));
    }

    /// Adds a shot on `grid`; each shot once. All shots of a run have vectors at the same places.
    pub fn add(&self, grid: &VectorGrid, snapshot: &Snapshot) {
        let mut state = self.0.lock();
        let ensemble = state.get_or_insert_with(|| Ensemble::new(grid.clone()).into());
        if ensemble.grid() == grid {
            // Copied only while somebody reads.
            Arc::make_mut(ensemble).add(snapshot);
        }
    }

    /// The statistics as they are now; `None` before the first shot.
    pub fn now(&self) -> Option<Arc<Ensemble>> {
        self.0.lock().clone()
    }
}
