//! What the latest shots looked like: raw frames, volumes and projections, within a fixed amount
//! of memory.

use std::{collections::BTreeMap, sync::Arc};

use lfpiv_core::{
    lightfield::ImagePair,
    reconstruction::{FrameLight, MaximumProjection, SparseVolume},
};
use parking_lot::Mutex;

/// Bytes that the volumes of the last shots may take. Eight bytes per lit voxel: 64 MB hold some
/// ten shots of 100³ voxels at 1 ppm.
pub const VOLUME_MEMORY_BYTES: usize = 64 << 20;
/// Bytes that the projections of the last shots may take: 130 shots of 100³ voxels.
pub const PROJECTION_MEMORY_BYTES: usize = 32 << 20;

/// Shots whose volumes and projections are kept at most, however little room they take.
pub const SHOTS_SHOWN: usize = 200;

/// See the module.
#[derive(Debug)]
pub struct Gallery {
    shelves: Mutex<Shelves>,
}

#[derive(Debug)]
struct Shelves {
    /// Of the shot that came to a worker last: its images are in memory anyway.
    frames: Option<(u64, Vec<[lfpiv_hw::RawImage; 2]>)>,
    volumes: Shelf<Arc<[SparseVolume; 2]>>,
    projections: Shelf<Arc<[[MaximumProjection; 3]; 2]>>,
}

impl Default for Gallery {
    fn default() -> Self {
        let shelves = Shelves {
            frames: None,
            volumes: Shelf::new(VOLUME_MEMORY_BYTES),
            projections: Shelf::new(PROJECTION_MEMORY_BYTES),
        };
        Self { shelves: Mutex::new(shelves) }
    }
}

impl Gallery {
    /// Shows the raw frames of a shot; they share their memory with the pair.
    pub fn show_frames(&self, shot: u64, pair: &ImagePair) {
        self.shelves.lock().frames = Some((shot, pair.cameras.clone()));
    }

    /// Shows the light of frames a and b of a shot.
    pub fn show_light(&self, shot: u64, light: [FrameLight; 2]) {
        let volume_bytes = light.iter().map(FrameLight::volume_bytes).sum();
        let projection_bytes = light.iter().map(FrameLight::projection_bytes).sum();
        let [a, b] = light;
        let mut shelves = self.shelves.lock();
        shelves.volumes.put(shot, volume_bytes, Arc::new([a.volume, b.volume]));
        shelves.projections.put(shot, projection_bytes, Arc::new([a.projections, b.projections]));
    }

    /// The shot whose frames are shown.
    pub fn latest_frames(&self) -> Option<u64> {
        self.shelves.lock().frames.as_ref().map(|(shot, _)| *shot)
    }

    /// Frame a (0) or b (1) of a camera, from 0, while the shot is the latest.
    pub fn frame(&self, shot: u64, camera: usize, half: usize) -> Option<lfpiv_hw::RawImage> {
        let shelves = self.shelves.lock();
        let (latest, cameras) = shelves.frames.as_ref()?;
        (*latest == shot).then(|| cameras.get(camera)?.get(half).cloned())?
    }

    /// The volumes of frames a and b.
    pub fn volumes(&self, shot: u64) -> Option<Arc<[SparseVolume; 2]>> {
        self.shelves.lock().volumes.get(shot)
    }

    /// The projections of frames a and b.
    pub fn projections(&self, shot: u64) -> Option<Arc<[[MaximumProjection; 3]; 2]>> {
        self.shelves.lock().projections.get(shot)
    }
}

/// Things of the latest shots, as many as a number of bytes allows.
#[derive(Debug)]
struct Shelf<T> {
    most_bytes: usize,
    bytes: usize,
    things: BTreeMap<u64, (usize, T)>,
}

impl<T: Clone> Shelf<T> {
    fn new(most_bytes: usize) -> Self {
        Self { most_bytes, bytes: 0, things: BTreeMap::new() }
    }

    /// Makes room by dropping the oldest. What is too large by itself is not kept.
    fn put(&mut self, shot: u64, bytes: usize, thing: T) {
        if let Some((earlier, _)) = self.things.insert(shot, (bytes, thing)) {
            self.bytes -= earlier;
        }
        self.bytes += bytes;
        while self.bytes > self.most_bytes || self.things.len() > SHOTS_SHOWN {
            let Some((_, (freed, _))) = self.things.pop_first() else { break };
            self.bytes -= freed;
        }
    }

    fn get(&self, shot: u64) -> Option<T> {
        self.things.get(&shot).map(|(_, thing)| thing.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lfpiv_core::model::VolumeGrid;

    #[test]
    fn the_oldest_makes_room_and_the_sum_is_kept() {
        let mut shelf = Shelf::new(100);
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
        let mut shelf = Shelf::new(usize::MAX);
        let shots = 3 * SHOTS_SHOWN as u64;
        for shot in 0..shots {
            shelf.put(shot, 1, shot);
        }
        assert_eq!((shelf.bytes, shelf.things.len()), (SHOTS_SHOWN, SHOTS_SHOWN));
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
    }
}
