//! Images of the latest shots (raw frames, volumes and projections), within a fixed memory budget.

use std::{collections::BTreeMap, sync::Arc};

use lfpiv_core::{
    lightfield::ImagePair,
    reconstruction::{FrameLight, MaximumProjection, SparseVolume},
};
use parking_lot::Mutex;

/// Memory budget for volumes. At eight bytes per lit voxel, 64 MB hold about ten shots of 100³ voxels
/// at 1 ppm.
pub const VOLUME_MEMORY_BYTES: usize = 64 << 20;
/// Memory budget for projections: 130 shots of 100³ voxels.
pub const PROJECTION_MEMORY_BYTES: usize = 32 << 20;

/// Largest number of shots whose volumes and projections are kept.
pub const MAX_SHOTS: usize = 200;

/// See the module.
#[derive(Debug)]
pub struct Gallery {
    stored: Mutex<Stored>,
}

#[derive(Debug)]
struct Stored {
    /// Frames of the shot that a worker took last: they are in memory anyway.
    frames: Option<(u64, Vec<[lfpiv_hw::RawImage; 2]>)>,
    volumes: BudgetedItems<Arc<[SparseVolume; 2]>>,
    projections: BudgetedItems<Arc<[[MaximumProjection; 3]; 2]>>,
}

impl Default for Gallery {
    fn default() -> Self {
        let stored = Stored {
            frames: None,
            volumes: BudgetedItems::new(VOLUME_MEMORY_BYTES),
            projections: BudgetedItems::new(PROJECTION_MEMORY_BYTES),
        };
        Self { stored: Mutex::new(stored) }
    }
}

impl Gallery {
    /// Stores the raw frames of a shot; they share memory with the pair.
    pub fn show_frames(&self, shot: u64, pair: &ImagePair) {
        self.stored.lock().frames = Some((shot, pair.cameras.clone()));
    }

    /// Stores the light of frames a and b of a shot.
    pub fn show_light(&self, shot: u64, light: [FrameLight; 2]) {
        let volume_bytes = light.iter().map(FrameLight::volume_bytes).sum();
        let projection_bytes = light.iter().map(FrameLight::projection_bytes).sum();
        let [a, b] = light;
        let mut stored = self.stored.lock();
        if let (Some(a), Some(b)) = (a.volume, b.volume) {
            stored.volumes.put(shot, volume_bytes, Arc::new([a, b]));
        }
        stored.projections.put(shot, projection_bytes, Arc::new([a.projections, b.projections]));
    }

    /// The shot whose frames are shown.
    pub fn latest_frames(&self) -> Option<u64> {
        self.stored.lock().frames.as_ref().map(|(shot, _)| *shot)
    }

    /// Frame a (0) or b (1) of a camera, from 0, while the shot is the latest.
    pub fn frame(&self, shot: u64, camera: usize, half: usize) -> Option<lfpiv_hw::RawImage> {
        let stored = self.stored.lock();
        let (latest, cameras) = stored.frames.as_ref()?;
        (*latest == shot).then(|| cameras.get(camera)?.get(half).cloned())?
    }

    /// The volumes of frames a and b.
    pub fn volumes(&self, shot: u64) -> Option<Arc<[SparseVolume; 2]>> {
        self.stored.lock().volumes.get(shot)
    }

    /// The projections of frames a and b.
    pub fn projections(&self, shot: u64) -> Option<Arc<[[MaximumProjection; 3]; 2]>> {
        self.stored.lock().projections.get(shot)
    }
}

/// Items of the latest shots within a memory budget.
#[derive(Debug)]
struct BudgetedItems<T> {
    max_bytes: usize,
    bytes: usize,
    things: BTreeMap<u64, (usize, T)>,
}

impl<T: Clone> BudgetedItems<T> {
    fn new(max_bytes: usize) -> Self {
        Self { max_bytes, bytes: 0, things: BTreeMap::new() }
    }

    /// Adds an item and drops the oldest ones as needed. An item above the budget is not kept.
    fn put(&mut self, shot: u64, bytes: usize, item: T) {
        if let Some((earlier, _)) = self.things.insert(shot, (bytes, item)) {
            self.bytes -= earlier;
        }
        self.bytes += bytes;
        while self.bytes > self.max_bytes || self.things.len() > MAX_SHOTS {
            let Some((_, (freed, _))) = self.things.pop_first() else { break };
            self.bytes -= freed;
        }
    }

    fn get(&self, shot: u64) -> Option<T> {
        self.things.get(&shot).map(|(_, item)| item.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lfpiv_core::model::VolumeGrid;

    #[test]
    fn the_oldest_makes_room_and_the_sum_is_kept() {
        let mut shelf = BudgetedItems::new(100);
        for shot in 0..4 {
            shelf.put(shot, 40, shot);
        }
        assert_eq!([0, 1, 2, 3].map(|shot| shelf.get(shot)), [None, None, Some(2), Some(3)]);
        shelf.put(3, 60, 33);
        assert_eq!((shelf.bytes, shelf.get(2), shelf.get(3)), (100, Some(2), Some(33)));
        shelf.put(4, 101, 4);
        assert_eq!((shelf.bytes, shelf.things.len()), (0, 0));
    }

    #[test]
    fn small_things_are_kept_of_so_many_shots_and_no_more() {
        let mut shelf = BudgetedItems::new(usize::MAX);
        let shots = 3 * MAX_SHOTS as u64;
        for shot in 0..shots {
            shelf.put(shot, 1, shot);
        }
        assert_eq!((shelf.bytes, shelf.things.len()), (MAX_SHOTS, MAX_SHOTS));
        assert_eq!(shelf.get(shots - 1), Some(shots - 1));
    }

    #[test]
    fn frames_are_those_of_the_latest_shot_and_share_their_memory() {
        let gallery = Gallery::default();
        let image = lfpiv_hw::RawImage::new(2, 1, vec![3, 4]).unwrap();
        let pair = ImagePair { cameras: vec![[image.clone(), image.clone()]] };
        assert_eq!(gallery.latest_frames(), None);
        gallery.show_frames(7, &pair);
        assert_eq!(gallery.latest_frames(), Some(7));
        let shown = gallery.frame(7, 0, 1).unwrap();
        assert!(std::ptr::eq(shown.counts(), image.counts()));
        assert_eq!(gallery.frame(6, 0, 1), None);
        assert_eq!((gallery.frame(7, 1, 0), gallery.frame(7, 0, 2)), (None, None));
    }

    #[test]
    fn light_is_found_by_shot() {
        let grid = VolumeGrid { voxels: [2, 1, 1], voxel_mm: 0.1, centre_mm: [0.0; 3] };
        let light = |light: f32| {
            let volume =
                SparseVolume { grid: grid.clone(), voxels: vec![1], intensity: vec![light] };
            FrameLight::new(&volume, &grid)
        };
        let gallery = Gallery::default();
        gallery.show_light(5, [light(1.0), light(2.0)]);
        assert_eq!(gallery.volumes(5).unwrap()[1].intensity, [2.0]);
        assert_eq!(gallery.projections(5).unwrap()[0][0].intensity, [0.0, 1.0]);
        assert!(gallery.volumes(4).is_none() && gallery.projections(4).is_none());
        // As another machine delivers it.
        let projected = [3.0, 4.0].map(|number| FrameLight { volume: None, ..light(number) });
        gallery.show_light(6, projected);
        assert_eq!(gallery.projections(6).unwrap()[1][0].intensity, [0.0, 4.0]);
        assert!(gallery.volumes(6).is_none() && gallery.volumes(5).is_some());
    }
}
