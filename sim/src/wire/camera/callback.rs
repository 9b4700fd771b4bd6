//! The callback by which Aravis requests the pixels of a frame to send.

use std::{ffi::c_void, sync::Arc};

use aravis::{GvFakeCamera, glib::translate::ToGlibPtr};
use aravis_sys::{ArvBuffer, ArvPixelFormat};

use super::{feed::Feed, pixels::Region};
use lfpiv_hw::gige::PixelFormat;

/// A running fake camera.
pub(super) struct PoweredCamera {
    /// Dropped before the data that its thread reads: fields are dropped in this order.
    device: GvFakeCamera,
    feed: Arc<Feed>,
}

impl PoweredCamera {
    /// Lets `feed` fill the device's frames; `None` if the device has no internal camera.
    pub(super) fn new(device: GvFakeCamera, feed: Feed) -> Option<Self> {
        let feed = Arc::new(feed);
        connect(&device, &feed)?;
        Some(Self { device, feed })
    }

    pub(super) fn feed(&self) -> &Arc<Feed> {
        &self.feed
    }

    pub(super) fn set_lost_packet_ratio(&self, ratio: f64) {
        self.device.set_gvsp_lost_ratio(ratio);
    }
}

/// Registers the callback with a pointer to `feed`.
#[allow(unsafe_code)]
fn connect(device: &GvFakeCamera, feed: &Arc<Feed>) -> Option<()> {
    let camera = device.fake_camera()?;
    let feed = Arc::as_ptr(feed).cast_mut().cast::<c_void>();
    // SAFETY: the callback runs only on the thread that `device` owns. Only the caller's
    // `PoweredCamera` holds a reference to `device`, so dropping it ends and joins that thread; the
    // feed behind the pointer is dropped later. `camera`, which the feed keeps alive longer, calls
    // nothing without that thread.
    unsafe {
        aravis_sys::arv_fake_camera_set_fill_pattern(camera.to_glib_none().0, Some(fill), feed);
    }
    Some(())
}

/// Fills one frame.
///
/// # Safety
/// `feed` points to a [`Feed`] that lives as long as the calling thread; `buffer` is the frame
/// that this thread is about to send.
#[allow(unsafe_code)]
unsafe extern "C" fn fill(
    buffer: *mut ArvBuffer,
    feed: *mut c_void,
    _exposure_us: u32,
    _gain: u32,
    format: ArvPixelFormat,
) {
    // SAFETY: the caller guarantees both pointers. The fake has checked that the buffer holds a
    // whole image of the size and format that it has just written into it, so `length` bytes exist
    // (`arv_buffer_get_data` would report the received size, which is zero). Nobody else accesses
    // the buffer during the call.
    unsafe {
        let feed = &*feed.cast_const().cast::<Feed>();
        let part = |get: unsafe extern "C" fn(*mut ArvBuffer) -> i32| {
            usize::try_from(get(buffer)).unwrap_or(0)
        };
        let region = Region {
            x: part(aravis_sys::arv_buffer_get_image_x),
            y: part(aravis_sys::arv_buffer_get_image_y),
            columns: part(aravis_sys::arv_buffer_get_image_width),
            rows: part(aravis_sys::arv_buffer_get_image_height),
        };
        let mut reported = 0;
        let data = aravis_sys::arv_buffer_get_data(buffer, &mut reported);
        let length = payload_bytes(format, region);
        if data.is_null() || length == 0 {
            return;
        }
        let bytes = std::slice::from_raw_parts_mut(data, length);
        let label = feed.fill(format, region, bytes);
        aravis_sys::arv_buffer_set_frame_id(buffer, u64::from(label.frame_id));
        if let Some(timestamp_ns) = label.device_timestamp_ns {
            aravis_sys::arv_buffer_set_timestamp(buffer, timestamp_ns);
        }
    }
}

/// As computed by the fake: whole bytes, rounded down; 0 for an unknown format.
fn payload_bytes(format: u32, region: Region) -> usize {
    let bits = (format >> 16 & 0xff) as usize;
    let known = PixelFormat::from_code(format).is_some();
    if known { region.columns * region.rows * bits / 8 } else { 0 }
}
