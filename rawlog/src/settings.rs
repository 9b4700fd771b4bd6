//! The `[raw_log]` table of the configuration.

use std::time::Duration;

use garde::Validate;
use serde::{Deserialize, Serialize};

use super::Codec;

const BYTES_PER_MB: u64 = 1_000_000;

/// Settings of recording.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct RawLogSettings {
    /// Whether raw data is recorded at all.
    #[garde(skip)]
    pub keep: bool,
    /// How images are stored.
    #[garde(skip)]
    pub codec: Codec,
    /// Size at which a segment is sealed and the next one created, in MB.
    #[garde(range(min = 1, max = 1_000_000))]
    pub segment_mb: u64,
    /// Longest time between a write and its sync, in ms, if the disk is fast enough.
    #[garde(range(min = 1, max = 60_000))]
    pub sync_ms: u64,
    /// Memory limit of queued images, in MB.
    #[garde(range(min = 1, max = 1_000_000))]
    pub queue_mb: u64,
    /// Disk space that must stay free when shots are armed, in MB; results need some of it.
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

    /// Longest time between a write and its sync.
    pub fn sync_interval(&self) -> Duration {
        Duration::from_millis(self.sync_ms)
    }

    /// Memory limit of queued images.
    pub fn queue_bytes(&self) -> u64 {
        self.queue_mb.saturating_mul(BYTES_PER_MB)
    }

    /// Disk space that must stay free when shots are armed.
    pub fn reserve_bytes(&self) -> u64 {
        self.reserve_mb.saturating_mul(BYTES_PER_MB)
    }
}

/// The limits in bytes: tests need segments of a few records.
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
