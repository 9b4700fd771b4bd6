//! What a worker is told: a shot, and by hash all that its result depends on.

use lfpiv_rawlog::Position;
use serde::{Deserialize, Serialize};

use super::Conditions;
use crate::{
    acquisition::journal::{RecordedRun, RecordedRunError, RecordedShot},
    archive::{ShotTime, sha256},
};

/// Version of jobs, of the interface to the coordinator and of delivered results. Both ends must have the same.
pub const PROTOCOL: u32 = 4;

/// A job of the work queue: one shot of a run. Some 500 bytes of JSON.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Job {
    /// [`PROTOCOL`] of the coordinator.
    pub protocol: u32,
    /// Identifies the run: the start of the hash of its shots.
    pub run: String,
    /// The run's folder, without the folders above it: where a worker looks for it in a shared one.
    pub run_name: String,
    /// The shot and its frames.
    pub shot: Shot,
    /// How often the coordinator has offered this shot, from 1: a broker that has lost its store counts anew.
    pub issue: u32,
    /// What the result depends on.
    pub conditions: Conditions,
    /// Hash of the forward model's choice with its numbers, which the run's first shot has decided.
    pub model_sha256: String,
    /// Where the coordinator is: `http://ADDRESS`.
    pub address: String,
    /// For this run, and as long as this coordinator lives.
    pub tokens: Tokens,
    /// Pause between heartbeats while the shot is measured, in ms.
    pub heartbeat_ms: u64,
    /// Time after which these signs stop, in ms, so that another worker gets the shot.
    pub deadline_ms: u64,
}

/// What the coordinator asks of its clients, by what they may do.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Tokens {
    /// Read the run's frames and configuration.
    pub read: String,
    /// Also deliver results, and report.
    pub work: String,
}

/// A recorded shot with the places of its frames.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Shot {
    /// Its number.
    pub number: u64,
    /// Frames a and b of each camera.
    pub frames: Vec<[Frame; 2]>,
    /// Bits of the time between the light pulses in µs: JSON rounds.
    dt_us_bits: u64,
    /// Evidence against the pairing.
    pub suspect: Vec<String>,
    /// When its trigger was given: UTC in ns, its standard uncertainty, whether the clock was synchronised.
    time: Option<(i64, u64, bool)>,
}

/// The place of a frame's record, and a checksum of its image.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Frame {
    /// Number of the segment.
    pub segment: u32,
    /// Offset of the record in the segment.
    pub offset: u64,
    /// CRC-32 of the counts, whatever the codec.
    pub crc32: u32,
}

impl Frame {
    /// Where the record is.
    pub fn position(&self) -> Position {
        Position { segment: self.segment, offset: self.offset }
    }
}

impl Shot {
    /// Describes a shot of `run`. Only headers are read.
    ///
    /// # Errors
    /// A record is damaged, or cannot be read.
    pub fn of(run: &RecordedRun, shot: &RecordedShot) -> Result<Self, RecordedRunError> {
        let frame = |position: Position| -> Result<Frame, RecordedRunError> {
            let Position { segment, offset } = position;
            Ok(Frame { segment, offset, crc32: run.image_crc32(position)? })
        };
        let frames = shot.frames.iter().map(|[a, b]| Ok([frame(*a)?, frame(*b)?]));
        Ok(Self {
            number: shot.trigger,
            frames: frames.collect::<Result<_, RecordedRunError>>()?,
            dt_us_bits: shot.dt_us.to_bits(),
            suspect: shot.suspect.clone(),
            time: shot.time.map(|time| (time.utc_ns, time.uncertainty_ns, time.clock_synchronised)),
        })
    }

    /// Hash of all of it: tells runs of one configuration apart, as their images differ.
    pub fn sha256(&self) -> String {
        // Numbers, texts and lists, whose serialisation cannot fail.
        sha256(&serde_json::to_vec(self).unwrap_or_default())
    }

    /// Time between the light pulses, in µs.
    pub fn dt_us(&self) -> f64 {
        f64::from_bits(self.dt_us_bits)
    }

    /// When its trigger was given.
    pub fn time(&self) -> Option<ShotTime> {
        let time = |(utc_ns, uncertainty_ns, clock_synchronised)| ShotTime {
            utc_ns,
            uncertainty_ns,
            clock_synchronised,
        };
        self.time.map(time)
    }
}

/// What a worker needs once for a run, before its first shot.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Assignment {
    /// What results depend on.
    pub conditions: Conditions,
    /// The configuration, TOML.
    pub configuration: String,
    /// The shot that a worker must measure alike.
    pub reference: Reference,
    /// Whether results are to have the projections of their light, to look at.
    pub wants_light: bool,
}

/// A shot that the coordinator has measured itself. It decides the forward model, and its result shows whether a
/// worker computes as the coordinator does.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Reference {
    pub shot: Shot,
    /// Hash of the result: [`super::Delivery::result_sha256`].
    pub result_sha256: String,
    /// Hash of the forward model's choice.
    pub model_sha256: String,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_job_is_small_and_read_as_it_was_written() {
        let frame = Frame { segment: 3, offset: 1 << 33, crc32: u32::MAX };
        let recorded = Shot {
            number: 12_345,
            frames: vec![[frame; 2]; 2],
            dt_us_bits: 0.1_f64.to_bits(),
            suspect: vec![],
            time: Some((1_795_297_055_035_645_600, 7_685_403, true)),
        };
        let sha256 = "0".repeat(64);
        let job = Job {
            protocol: PROTOCOL,
            run: "0".repeat(16),
            run_name: "run-20261121T090000Z".into(),
            shot: recorded,
            issue: 1,
            conditions: Conditions {
                code_version: "0.1.0".into(),
                configuration_sha256: sha256.clone(),
                shots_sha256: sha256.clone(),
                background_crc32: vec![1, 2, 3, 4],
            },
            model_sha256: sha256,
            address: "http://10.0.0.1:8700".into(),
            tokens: Tokens { read: "0".repeat(32), work: "1".repeat(32) },
            heartbeat_ms: 5000,
            deadline_ms: 600_000,
        };
        let text = serde_json::to_string(&job).unwrap();
        assert!(text.len() < 1100, "{} bytes", text.len());
        let read: Job = serde_json::from_str(&text).unwrap();
        assert_eq!(read, job);
        assert_eq!(read.shot.dt_us().to_bits(), 0.1_f64.to_bits());
    }
}
