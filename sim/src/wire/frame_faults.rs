//! Applies [`FaultyCamera`] to a camera's exposures before they reach the network, so that a seed
//! disturbs the same frames over the wires as in process.

use std::{sync::mpsc, time::Duration};

use lfpiv_hw::{
    RawImage,
    device::{Camera, DeviceError, Frame, FrameStatus, StreamStatistics},
};
use thiserror::Error;

use crate::faults::{FaultRecord, FaultSettings, FaultyCamera, FrameFault};

/// Faults that cannot be produced on the wires.
#[derive(Debug, Error, PartialEq, Eq)]
#[error(
    "these faults cannot be produced on the wires, where a camera sends every frame once, in order and \
     as it is: {}; set them to 0, or make them in the process with `lfpiv replay --faults` (for \
     packets that get lost at random there is wire.lost_packets)", .0.join(", ")
)]
pub struct UnsupportedFaults(Vec<String>);

/// Refuses faults that the wires cannot produce.
pub(super) fn check(settings: &FaultSettings) -> Result<(), UnsupportedFaults> {
    let shares = &settings.camera.shares;
    let impossible: Vec<String> = [
        ("late", shares.late),
        ("reordered", shares.reordered),
        ("duplicated", shares.duplicated),
        ("truncated", shares.truncated),
        ("cropped", shares.cropped),
    ]
    .into_iter()
    .filter(|(_, share)| *share > 0.0)
    .map(|(name, share)| format!("camera.shares.{name} = {share}"))
    .collect();
    if impossible.is_empty() { Ok(()) } else { Err(UnsupportedFaults(impossible)) }
}

/// How an exposure is sent.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Outgoing {
    /// This many frames are counted and lost, then this one is sent.
    Frame { lost_before: u64, image: RawImage, device_timestamp_ns: u64 },
    /// Nothing is sent now; losses become known with the next frame.
    Nothing,
    /// The connection is lost from here on.
    Unplugged,
}

/// The faults of one camera.
pub(super) struct FrameFaults {
    camera: FaultyCamera<SensorCamera>,
    inlet: mpsc::Sender<Frame>,
    /// Exposures counted by the camera.
    counted: u64,
    /// Frames sent or lost so far.
    sent_or_lost: u64,
}

impl FrameFaults {
    /// Faults of camera `index` (from 0) according to `settings`.
    pub(super) fn new(index: usize, settings: &FaultSettings) -> Self {
        let (inlet, frames) = mpsc::channel();
        let camera = FaultyCamera::new(SensorCamera(frames), index, settings);
        Self { camera, inlet, counted: 0, sent_or_lost: 0 }
    }

    /// The injected faults so far.
    pub(super) fn record(&self) -> FaultRecord<FrameFault> {
        self.camera.record()
    }

    /// Processes one exposure; without an image its frame is always lost.
    pub(super) fn disturb(
        &mut self,
        image: Option<RawImage>,
        device_timestamp_ns: u64,
    ) -> Outgoing {
        let frame_id = self.counted;
        self.counted += 1;
        let Some(image) = image else { return Outgoing::Nothing };
        let status = FrameStatus::Complete;
        let frame = Frame { image, frame_id, device_timestamp_ns, host_timestamp_ns: 0, status };
        // The receiver is part of this struct, so this cannot fail.
        let _ = self.inlet.send(frame);
        match self.camera.next_frame(Duration::ZERO) {
            Ok(Some(Frame { image, frame_id, device_timestamp_ns, .. })) => {
                let lost_before = frame_id.saturating_sub(self.sent_or_lost);
                self.sent_or_lost = frame_id + 1;
                Outgoing::Frame { lost_before, image, device_timestamp_ns }
            }
            Ok(None) => Outgoing::Nothing,
            Err(_) => Outgoing::Unplugged,
        }
    }
}

/// The sensor, as a camera.
struct SensorCamera(mpsc::Receiver<Frame>);

impl Camera for SensorCamera {
    fn name(&self) -> &str {
        "sensor"
    }

    fn start(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }

    fn next_frame(&mut self, _: Duration) -> Result<Option<Frame>, DeviceError> {
        Ok(self.0.try_recv().ok())
    }

    fn stop(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }

    fn statistics(&self) -> StreamStatistics {
        StreamStatistics::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn image() -> RawImage {
        RawImage::new(2, 1, vec![1, 2]).unwrap()
    }

    /// Numbers of the arriving frames for `shots` triggers; `None` where nothing arrives.
    fn arriving(settings: &FaultSettings, shots: u64) -> (Vec<Option<u64>>, FrameFaults) {
        let mut faults = FrameFaults::new(0, settings);
        let mut counter = 0;
        let arrived = (0..2 * shots).map(|number| match faults.disturb(Some(image()), number) {
            Outgoing::Frame { lost_before, .. } => {
                counter += lost_before + 1;
                Some(counter - 1)
            }
            Outgoing::Nothing => None,
            Outgoing::Unplugged => panic!("no disconnection was configured"),
        });
        (arrived.collect(), faults)
    }

    #[test]
    fn without_faults_every_frame_is_sent_unchanged() {
        let (arrived, _) = arriving(&FaultSettings::default(), 20);
        assert_eq!(arrived, (0..40).map(Some).collect::<Vec<_>>());
    }

    #[test]
    fn a_dropped_frame_is_counted_and_a_missed_trigger_is_not() {
        let mut settings = FaultSettings { seed: 5, ..FaultSettings::default() };
        settings.camera.shares.dropped = 0.1;
        settings.camera.shares.missed_trigger = 0.1;
        let (arrived, faults) = arriving(&settings, 200);
        let record = faults.record();
        let missed: Vec<u64> = record
            .faults()
            .into_iter()
            .filter(|injected| injected.fault == FrameFault::MissedTrigger)
            .map(|injected| injected.number)
            .collect();
        let dropped = record.count(|fault| *fault == FrameFault::Dropped);
        assert!(dropped > 10 && missed.len() > 20, "{dropped} {}", missed.len());
        let nothing = arrived.iter().filter(|frame| frame.is_none()).count();
        assert_eq!(nothing as u64, dropped + missed.len() as u64);
        for (number, shown) in arrived.into_iter().enumerate() {
            let uncounted = missed.iter().filter(|at| **at < number as u64).count();
            assert!(shown.is_none_or(|shown| shown == (number - uncounted) as u64));
        }
    }

    #[test]
    fn a_frame_that_is_lost_in_any_case_leaves_a_gap() {
        let mut faults = FrameFaults::new(0, &FaultSettings::default());
        assert_eq!(faults.disturb(None, 1), Outgoing::Nothing);
        let out = faults.disturb(Some(image()), 2);
        let wanted = Outgoing::Frame { lost_before: 1, image: image(), device_timestamp_ns: 2 };
        assert_eq!(out, wanted);
    }

    #[test]
    fn a_lost_connection_unplugs() {
        let mut settings = FaultSettings::default();
        settings.camera.disconnect_after = Some(1);
        let mut faults = FrameFaults::new(0, &settings);
        assert!(matches!(faults.disturb(Some(image()), 1), Outgoing::Frame { .. }));
        assert_eq!(faults.disturb(Some(image()), 2), Outgoing::Unplugged);
        assert_eq!(faults.disturb(Some(image()), 3), Outgoing::Unplugged);
    }

    #[test]
    fn faults_that_the_wires_do_not_support_are_refused_by_name() {
        let mut settings = FaultSettings::default();
        settings.camera.shares.dropped = 0.1;
        settings.camera.shares.corrupted = 0.1;
        settings.line.shares.garbled = 0.1;
        assert_eq!(check(&settings), Ok(()));
        settings.camera.shares.late = 0.1;
        settings.camera.shares.truncated = 0.2;
        let words = check(&settings).unwrap_err().to_string();
        assert!(words.contains("camera.shares.late = 0.1"), "{words}");
        assert!(words.contains("camera.shares.truncated = 0.2"), "{words}");
    }
}
