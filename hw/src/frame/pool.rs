//! A pool of image memory. Without it, the kernel would map, clear and unmap every 4-megapixel frame.

use std::sync::{Arc, Mutex, PoisonError, Weak};

use super::RawImage;

/// Memory for images of one size. Dropped images return to the pool, from any thread; images that
/// outlive the pool are freed.
#[derive(Debug)]
pub struct ImagePool {
    columns: usize,
    rows: usize,
    idle: Arc<IdleBuffers>,
}

#[derive(Debug)]
struct IdleBuffers {
    /// Upper bound of idle buffers.
    max_idle: usize,
    buffers: Mutex<Vec<Vec<u16>>>,
}

impl ImagePool {
    /// A pool that keeps up to `max_idle` idle buffers.
    pub fn new(columns: usize, rows: usize, max_idle: usize) -> Self {
        let idle = IdleBuffers { max_idle, buffers: Mutex::new(Vec::new()) };
        Self { columns, rows, idle: Arc::new(idle) }
    }

    /// An image filled by `fill`. The buffer initially holds an earlier image or zeros.
    pub fn image(&self, fill: impl FnOnce(&mut [u16])) -> RawImage {
        let pixels = self.columns * self.rows;
        let mut values = self.idle.take().unwrap_or_else(|| vec![0; pixels]);
        fill(&mut values);
        let counts = Counts { values, home: Arc::downgrade(&self.idle) };
        RawImage { columns: self.columns, rows: self.rows, counts: Arc::new(counts) }
    }
}

impl IdleBuffers {
    fn take(&self) -> Option<Vec<u16>> {
        self.buffers.lock().unwrap_or_else(PoisonError::into_inner).pop()
    }

    fn put(&self, buffer: Vec<u16>) {
        let mut buffers = self.buffers.lock().unwrap_or_else(PoisonError::into_inner);
        if buffers.len() < self.max_idle {
            buffers.push(buffer);
        }
    }
}

/// The counts of an image, and the pool to which their memory returns.
#[derive(Debug)]
pub(super) struct Counts {
    values: Vec<u16>,
    home: Weak<IdleBuffers>,
}

impl Counts {
    pub(super) fn values(&self) -> &[u16] {
        &self.values
    }
}

impl From<Vec<u16>> for Counts {
    fn from(values: Vec<u16>) -> Self {
        Self { values, home: Weak::new() }
    }
}

impl PartialEq for Counts {
    fn eq(&self, other: &Self) -> bool {
        self.values == other.values
    }
}

impl Eq for Counts {}

impl Drop for Counts {
    fn drop(&mut self) {
        if let Some(home) = self.home.upgrade() {
            home.put(std::mem::take(&mut self.values));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn address(image: &RawImage) -> *const u16 {
        image.counts().as_ptr()
    }

    #[test]
    fn a_dropped_image_lends_its_memory_to_the_next() {
        let pool = ImagePool::new(3, 2, 4);
        let first = pool.image(|counts| counts.fill(7));
        assert_eq!((first.columns(), first.rows()), (3, 2));
        let copy = first.clone();
        let place = address(&first);
        assert_eq!(address(&copy), place);
        drop(first);
        let other = pool.image(|_| {});
        assert_ne!(address(&other), place, "a clone still holds the memory");
        drop(copy);
        let second = pool.image(|counts| counts[0] = 9);
        assert_eq!(address(&second), place);
        assert_eq!(second.counts(), [9, 7, 7, 7, 7, 7]);
        let third = pool.image(|_| {});
        assert_ne!(address(&third), place, "the memory is still in use");
    }

    #[test]
    fn no_more_is_kept_than_allowed_and_images_outlive_their_pool() {
        let pool = ImagePool::new(2, 2, 1);
        let images: Vec<RawImage> = (0..3).map(|n| pool.image(|counts| counts.fill(n))).collect();
        let survivor = images[2].clone();
        drop(images);
        assert_eq!(pool.idle.buffers.lock().unwrap().len(), 1);
        let last = pool.image(|counts| counts.fill(5));
        drop(pool);
        assert_eq!(last.counts(), [5; 4]);
        assert_eq!(survivor.counts(), [2; 4]);
    }
}
