use std::{collections::VecDeque, time::Duration};

use lfpiv_hw::{
    RawImage,
    device::{Camera, DeviceError, Frame, FrameStatus, StreamStatistics},
};
use proptest::prelude::*;

use crate::faults::{
    CameraFaults, Clock, ClockJump, FaultSettings, FaultyCamera, FrameFault, FrameShares,
    ManualClock,
};

/// Frame period of the prepared camera.
const PERIOD: Duration = Duration::from_millis(50);
const ROWS: usize = 12;

/// A camera with one frame every [`PERIOD`].
struct Prepared {
    frames: VecDeque<(Duration, Frame)>,
    clock: ManualClock,
}

fn frame(id: u64) -> Frame {
    let counts = (0..4 * ROWS as u64).map(|pixel| 100 + (id * 7 + pixel) as u16 % 900).collect();
    Frame {
        image: RawImage::new(4, ROWS, counts).unwrap(),
        frame_id: id,
        device_timestamp_ns: 5_000_000_000 + id * PERIOD.as_nanos() as u64,
        host_timestamp_ns: id,
        status: FrameStatus::Complete,
    }
}

fn prepared(frames: u64, clock: &ManualClock) -> Prepared {
    let frames = (0..frames).map(|id| (PERIOD * (id as u32 + 1), frame(id))).collect();
    Prepared { frames, clock: clock.clone() }
}

impl Camera for Prepared {
    fn name(&self) -> &str {
        "prepared"
    }

    fn start(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }

    fn next_frame(&mut self, timeout: Duration) -> Result<Option<Frame>, DeviceError> {
        let until_next = match self.frames.front() {
            Some((at, _)) => at.saturating_sub(self.clock.now()),
            None => Duration::MAX,
        };
        self.clock.sleep(until_next.min(timeout));
        let frame = (until_next <= timeout).then(|| self.frames.pop_front());
        Ok(frame.flatten().map(|(_, frame)| frame))
    }

    fn stop(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }

    fn statistics(&self) -> StreamStatistics {
        StreamStatistics { resent: 3, ..StreamStatistics::default() }
    }
}

/// Frames with the time of their delivery.
type Delivered = Vec<(Duration, Frame)>;

fn faulty(frames: u64, settings: &FaultSettings) -> (FaultyCamera<Prepared>, ManualClock) {
    let clock = ManualClock::default();
    let camera = FaultyCamera::timed_by(prepared(frames, &clock), 0, settings, clock.clone());
    (camera, clock)
}

/// Takes frames until none has come for a long time.
fn drain(camera: &mut FaultyCamera<Prepared>, clock: &ManualClock) -> Delivered {
    let mut delivered = Vec::new();
    let mut silent = 0;
    while silent < 200 {
        match camera.next_frame(Duration::from_millis(30)).unwrap() {
            Some(frame) => {
                silent = 0;
                delivered.push((clock.now(), frame));
            }
            None => silent += 1,
        }
    }
    delivered
}

fn with(seed: u64, camera: CameraFaults) -> FaultSettings {
    FaultSettings { seed, camera, ..FaultSettings::default() }
}

fn only(shares: FrameShares) -> FaultSettings {
    with(1, CameraFaults { shares, ..CameraFaults::default() })
}

fn ids(delivered: &Delivered) -> Vec<u64> {
    delivered.iter().map(|(_, frame)| frame.frame_id).collect()
}

fn any_shares() -> impl Strategy<Value = FrameShares> {
    prop::array::uniform8(0.0..0.124_f64).prop_map(|[a, b, c, d, e, f, g, h]| FrameShares {
        dropped: a,
        late: b,
        reordered: c,
        duplicated: d,
        truncated: e,
        cropped: f,
        corrupted: g,
        missed_trigger: h,
    })
}

fn any_faults() -> impl Strategy<Value = FaultSettings> {
    (any::<u64>(), any_shares(), 0_u64..300, 1_u64..5).prop_map(
        |(seed, shares, late_ms, reordered_by)| {
            with(seed, CameraFaults { shares, late_ms, reordered_by, ..CameraFaults::default() })
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn without_faults_nothing_happens(seed in any::<u64>()) {
        let (mut camera, clock) = faulty(40, &with(seed, CameraFaults::default()));
        let delivered = drain(&mut camera, &clock);
        prop_assert_eq!(delivered.len(), 40);
        for (id, (at, delivered)) in delivered.iter().enumerate() {
            prop_assert_eq!(*at, PERIOD * (id as u32 + 1));
            prop_assert_eq!(&delivered.image, &frame(id as u64).image);
            prop_assert_eq!(delivered.frame_id, id as u64);
            prop_assert_eq!(delivered.device_timestamp_ns, frame(id as u64).device_timestamp_ns);
            prop_assert_eq!(delivered.status, FrameStatus::Complete);
        }
        prop_assert!(camera.record().faults().is_empty());
    }

    #[test]
    fn output_and_recorded_faults_account_for_all_input(settings in any_faults()) {
        let (mut camera, clock) = faulty(80, &settings);
        let delivered = drain(&mut camera, &clock);
        let waiting = camera.held() as u64;
        let record = camera.record();
        let count = |fault: FrameFault| record.count(|found| *found == fault);
        let kept = record.taken() - count(FrameFault::Dropped) - count(FrameFault::MissedTrigger);
        prop_assert_eq!(record.taken(), 80);
        prop_assert_eq!(record.given(), kept - waiting + count(FrameFault::Duplicated));
        prop_assert_eq!(record.given(), delivered.len() as u64);
        camera.stop().unwrap();
        prop_assert_eq!(count(FrameFault::Undelivered), waiting);

        // Every frame that is not in the record is unchanged.
        let faults = record.faults();
        for id in 0..80 {
            let of_frame: Vec<FrameFault> =
                faults.iter().filter(|f| f.number == id).map(|f| f.fault).collect();
            let frames: Vec<&Frame> =
                delivered.iter().map(|(_, f)| f).filter(|f| f.host_timestamp_ns == id).collect();
            let missed_before =
                faults.iter().filter(|f| f.fault == FrameFault::MissedTrigger && f.number < id);
            let missed_before = missed_before.count() as u64;
            let expected = match of_frame.first() {
                Some(FrameFault::Dropped | FrameFault::MissedTrigger) => 0,
                Some(FrameFault::Duplicated) => 2,
                _ if of_frame.contains(&FrameFault::Undelivered) => 0,
                _ => 1,
            };
            prop_assert_eq!(frames.len(), expected, "frame {}: {:?}", id, of_frame);
            for found in frames {
                prop_assert_eq!(found.frame_id, id - missed_before);
                let truncated = of_frame.contains(&FrameFault::Truncated);
                prop_assert_eq!(found.status == FrameStatus::MissingPackets, truncated);
                let harmed = [FrameFault::Truncated, FrameFault::Cropped, FrameFault::Corrupted];
                let harmed = of_frame.iter().any(|fault| harmed.contains(fault));
                prop_assert_eq!(found.image != frame(id).image, harmed);
            }
        }
        let statistics = camera.statistics();
        prop_assert_eq!(statistics.completed + statistics.failed, record.given());
        prop_assert_eq!(statistics.failed, count(FrameFault::Truncated));
    }

    #[test]
    fn the_same_seed_gives_the_same_faults(settings in any_faults(), wait_ms in 1_u64..500) {
        let (mut first, clock) = faulty(60, &settings);
        let expected = drain(&mut first, &clock);
        let (mut second, _) = faulty(60, &settings);
        let mut delivered = Vec::new();
        // A call takes a frame, of which there may be two each, or waits for its whole time.
        for _ in 0..6000_u64.div_ceil(wait_ms) + 2 * 60 {
            delivered.extend(second.next_frame(Duration::from_millis(wait_ms)).unwrap());
        }
        // The pattern of calls does not change the faults.
        prop_assert_eq!(first.record().faults(), second.record().faults());
        let images = |frames: Vec<&Frame>| -> Vec<_> {
            frames.iter().map(|f| (f.frame_id, f.image.clone(), f.status)).collect()
        };
        let expected = images(expected.iter().map(|(_, frame)| frame).collect());
        prop_assert_eq!(expected, images(delivered.iter().collect()));
    }
}

#[test]
fn cameras_and_seeds_differ() {
    let shares = FrameShares { dropped: 0.5, ..FrameShares::default() };
    let faults = |seed, index| {
        let settings = with(seed, CameraFaults { shares: shares.clone(), ..Default::default() });
        let clock = ManualClock::default();
        let mut camera =
            FaultyCamera::timed_by(prepared(64, &clock), index, &settings, clock.clone());
        drain(&mut camera, &clock);
        camera.record().faults()
    };
    let first = faults(1, 0);
    assert!((16..48).contains(&first.len()), "{} of 64", first.len());
    assert_ne!(first, faults(1, 1));
    assert_ne!(first, faults(2, 0));
}

#[test]
fn late_frames_come_after_their_time_and_overtaken_ones_after_the_next() {
    let late = FrameShares { late: 1.0, ..FrameShares::default() };
    let settings = with(1, CameraFaults { shares: late, late_ms: 170, ..Default::default() });
    let (mut camera, clock) = faulty(5, &settings);
    let delivered = drain(&mut camera, &clock);
    assert_eq!(ids(&delivered), [0, 1, 2, 3, 4]);
    for (id, (at, _)) in delivered.iter().enumerate() {
        assert_eq!(*at, PERIOD * (id as u32 + 1) + Duration::from_millis(170));
    }

    let reordered = FrameShares { reordered: 0.3, ..FrameShares::default() };
    let (mut camera, clock) = faulty(40, &only(reordered));
    let order = ids(&drain(&mut camera, &clock));
    let faults = camera.record().faults();
    assert!(faults.len() > 5, "{faults:?}");
    for fault in faults {
        let place = order.iter().position(|id| *id == fault.number);
        let overtook = order.iter().position(|id| *id > fault.number);
        assert!(place.is_none() || place > overtook, "{order:?}: {fault:?}");
    }
}

#[test]
fn each_kind_of_damage_matches_its_name() {
    let shares = FrameShares { truncated: 1.0, ..FrameShares::default() };
    let (mut camera, clock) = faulty(20, &only(shares));
    for (id, (_, found)) in drain(&mut camera, &clock).into_iter().enumerate() {
        let whole = frame(id as u64).image;
        let rows = (0..ROWS).take_while(|row| found.image.row(*row) == whole.row(*row)).count();
        assert!(rows < ROWS && (rows..ROWS).all(|row| found.image.row(row) == [0; 4]), "{rows}");
    }
    let shares = FrameShares { cropped: 1.0, ..FrameShares::default() };
    let (mut camera, clock) = faulty(20, &only(shares));
    for (id, (_, found)) in drain(&mut camera, &clock).into_iter().enumerate() {
        assert!(found.image.rows() < ROWS && found.status == FrameStatus::Complete);
        assert!(frame(id as u64).image.counts().starts_with(found.image.counts()));
    }
    let shares = FrameShares { corrupted: 1.0, ..FrameShares::default() };
    let (mut camera, clock) = faulty(20, &only(shares));
    for (id, (_, found)) in drain(&mut camera, &clock).into_iter().enumerate() {
        let whole = frame(id as u64).image;
        let pixels = found.image.counts().iter().zip(whole.counts());
        let flipped: u32 = pixels.map(|(found, whole)| (found ^ whole).count_ones()).sum();
        assert_eq!(flipped, 16);
    }
}

#[test]
fn the_clock_drifts_and_jumps() {
    let jump = ClockJump { frame: 3, jump_ns: -7_000_000 };
    let faults =
        CameraFaults { clock_drift_ppm: 100.0, clock_jumps: vec![jump], ..Default::default() };
    let (mut camera, clock) = faulty(6, &with(1, faults));
    for (id, (_, found)) in drain(&mut camera, &clock).into_iter().enumerate() {
        let id = id as u64;
        // 50 ms at 100 ppm are 5 us.
        let expected = frame(id).device_timestamp_ns + id * 5000;
        let expected = expected - if id >= 3 { 7_000_000 } else { 0 };
        assert_eq!(found.device_timestamp_ns, expected);
    }
    let faults = camera.record().faults();
    assert_eq!(faults.len(), 1);
    assert_eq!((faults[0].number, faults[0].fault), (3, FrameFault::ClockJump(-7_000_000)));
}

#[test]
fn a_disconnected_camera_stays_lost_and_a_spared_one_is_left_alone() {
    let faults = CameraFaults { disconnect_after: Some(4), ..CameraFaults::default() };
    let (mut camera, _) = faulty(9, &with(1, faults.clone()));
    for id in 0..4 {
        assert_eq!(camera.next_frame(PERIOD).unwrap().unwrap().frame_id, id);
        assert!(camera.is_connected());
    }
    let lost = camera.next_frame(PERIOD);
    assert!(matches!(lost, Err(DeviceError::Lost { .. })), "{lost:?}");
    assert!(!camera.is_connected() && camera.next_frame(PERIOD).is_err());
    camera.stop().unwrap();
    assert!(camera.start().unwrap_err().to_string().contains("on purpose after 4 frames"));

    let spared = CameraFaults { only: Some(vec![lfpiv_hw::CameraName(1)]), ..faults };
    let (mut camera, clock) = faulty(9, &with(1, spared));
    assert_eq!(drain(&mut camera, &clock).len(), 9);
    assert_eq!(camera.statistics().resent, 3);
}
