//! The `[raw_log]` table of the configuration.

use std::time::Duration;

use garde::Validate;
use serde::{Deserialize, Serialize};

use super::Codec;

const BYTES_PER_MB: u64 = 1_000_000;

/// How raw data is recorded.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct RawLogSettings {
    /// Whether raw data is kept at all.
    #[garde(skip)]
    pub keep: bool,
    /// How images are stored.
    #[garde(skip)]
    pub codec: Codec,
    /// Size at which a segment is sealed and the next one begun, in MB.
    #[garde(range(min = 1, max = 1_000_000))]
    pub segment_mb: u64,
    /// Longest time from written to safe on disk, in ms, while the disk keeps up.
    #[garde(range(min = 1, max = 60_000))]
    pub sync_ms: u64,
    /// Most memory of images that wait to be written, in MB.
    #[garde(range(min = 1, max = 1_000_000))]
    pub queue_mb: u64,
    /// Room on the disk that must stay free when shots are armed, in MB: results need some, too.
    #[garde(range(max = 1_000_000_000))]
    pub reserve_mb: u64,
}

impl Default for RawLogSettings {
    fn default() -> Self {
        Self {
            keep: true,
            codec: Codec::Auto,
            segment_mb: 1000,
            sync_ms: 200,
            queue_mb: 500,
            reserve_mb: 1000,
        }
    }
}

impl RawLogSettings {
    /// Size at which a segment is sealed.
    pub fn segment_bytes(&self) -> u64 {
        self.segment_mb.saturating_mul(BYTES_PER_MB)
    }

    /// Longest time from written to safe on disk, while the disk keeps up.
    pub fn sync_interval(&self) -> Duration {
        Duration::from_millis(self.sync_ms)
    }

    /// Most memory of images that wait to be written.
    pub fn queue_bytes(&self) -> u64 {
        self.queue_mb.saturating_mul(BYTES_PER_MB)
    }

    /// Room on the disk that must stay free when shots are armed.
    pub fn reserve_bytes(&self) -> u64 {
        self.reserve_mb.saturating_mul(BYTES_PER_MB)
    }
}

/// The same in bytes: tests need segments of a few records.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits {
    pub codec: Codec,
    pub segment_bytes: u64,
    pub sync_interval: Duration,
    pub queue_bytes: u64,
    pub reserve_bytes: u64,
}

impl From<&RawLogSettings> for Limits {
    fn from(settings: &RawLogSettings) -> Self {
        Self {
            codec: settings.codec,
            segment_bytes: settings.segment_bytes(),
            sync_interval: settings.sync_interval(),
            queue_bytes: settings.queue_bytes(),
            reserve_bytes: settings.reserve_bytes(),
        }
    }
}

/// Bytes in whole MB, rounded up.
pub(super) fn megabytes(bytes: u64) -> u64 {
    bytes.div_ceil(BYTES_PER_MB)
}
