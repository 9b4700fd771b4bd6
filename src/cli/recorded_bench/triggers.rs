//! Assigns the frames of a record to triggers, including lost frames.
//!
//! For shots, the record names the frames. For triggers that were not paired, frames are found by
//! their numbers: a camera gives two frames to each trigger that it sees, and every shot gives the
//! numbers at its trigger.

use std::{
    collections::{BTreeMap, BTreeSet, HashMap},
    sync::Arc,
};

use lfpiv_hw::{PulseSchedule, device::FrameStatus};
use lfpiv_rawlog::Position;

use crate::acquisition::{
    Outcome,
    journal::{Entry, FrameKey, LocatedEntry, RecordedRun},
};

/// What one camera delivered for a trigger.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Delivered {
    /// Positions of its frames; `None` for a lost or damaged frame.
    Frames([Option<Position>; 2]),
    /// The camera missed the trigger.
    Missed,
}

/// One trigger of the record.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct RecordedTrigger {
    /// One part per camera.
    pub cameras: Vec<Delivered>,
    /// The schedule of the trigger.
    pub schedule: Arc<PulseSchedule>,
}

/// All triggers of a record, by number.
#[derive(Debug, Clone, Default)]
pub(super) struct RecordedTriggers(Vec<RecordedTrigger>);

impl RecordedTriggers {
    /// Reads the entries of a record, without images, skipping damaged ones.
    pub fn read(recorded: &RecordedRun) -> Self {
        let mut seen = Seen::default();
        recorded.entries().flatten().for_each(|placed| seen.take(placed));
        seen.triggers(recorded.description().cameras)
    }

    pub fn len(&self) -> usize {
        self.0.len()
    }

    pub fn get(&self, trigger: u64) -> Option<&RecordedTrigger> {
        self.0.get(usize::try_from(trigger).ok()?)
    }
}

/// Information collected from the entries.
#[derive(Default)]
struct Seen {
    programmed: Option<Arc<PulseSchedule>>,
    schedules: BTreeMap<u64, Arc<PulseSchedule>>,
    /// Positions of complete frames, by camera. Of a frame that was received twice, the first is
    /// used.
    frames: HashMap<(usize, FrameKey), Position>,
    /// Keys of the frames, by camera and number.
    numbers: HashMap<(usize, u64), FrameKey>,
    shots: BTreeMap<u64, Vec<[FrameKey; 2]>>,
    missed: BTreeSet<(usize, u64)>,
    /// Number of triggers known to have been given.
    given: u64,
}

impl Seen {
    fn take(&mut self, LocatedEntry { position, entry }: LocatedEntry) {
        match entry {
            Entry::Programmed { schedule, .. } => self.programmed = Some(Arc::new(schedule)),
            Entry::Fired { first, shots, .. } => {
                for trigger in first..first.saturating_add(shots) {
                    self.schedules.extend(self.programmed.clone().map(|plan| (trigger, plan)));
                }
            }
            Entry::Frame { camera, frame, .. } if frame.status == FrameStatus::Complete => {
                self.frames.entry((camera, frame.key())).or_insert(position);
                self.numbers.entry((camera, frame.frame_id)).or_insert(frame.key());
            }
            Entry::Shot { trigger, frames, .. } => {
                self.given = self.given.max(trigger + 1);
                self.shots.insert(trigger, frames);
            }
            // A shot that was shed because the run ended: nothing is known about it.
            Entry::Settled { outcome: Outcome::Shed, .. } => {}
            // Treated as missed by the camera. At the end of a record it is left out.
            Entry::Settled { trigger, camera, outcome: Outcome::NotFired } => {
                self.missed.insert((camera, trigger));
            }
            Entry::Settled { trigger, camera, outcome } => {
                self.given = self.given.max(trigger + 1);
                if outcome == Outcome::MissedTrigger {
                    self.missed.insert((camera, trigger));
                }
            }
            _ => {}
        }
    }

    fn triggers(&self, cameras: usize) -> RecordedTriggers {
        let parts: Vec<Vec<Delivered>> = (0..cameras).map(|camera| self.parts(camera)).collect();
        let trigger = |number: u64| {
            // If the start of its burst is damaged, the schedule of the burst before is used.
            let before = self.schedules.range(..=number).next_back().map(|(_, schedule)| schedule);
            let schedule = before.or_else(|| self.schedules.values().next())?.clone();
            let cameras = parts.iter().map(|parts| parts[number as usize]).collect();
            Some(RecordedTrigger { cameras, schedule })
        };
        RecordedTriggers((0..self.given).map_while(trigger).collect())
    }

    /// The parts of one camera for all triggers.
    fn parts(&self, camera: usize) -> Vec<Delivered> {
        let mut next = self.first_number(camera);
        let part = |trigger: u64| {
            if let Some(keys) = self.shots.get(&trigger).and_then(|shot| shot.get(camera)) {
                next = keys[0].frame_id + 2;
                return Delivered::Frames(keys.map(|key| self.frames.get(&(camera, key)).copied()));
            }
            if self.missed.contains(&(camera, trigger)) {
                return Delivered::Missed;
            }
            let numbers = [next, next + 1];
            next += 2;
            Delivered::Frames(numbers.map(|number| {
                let key = self.numbers.get(&(camera, number))?;
                self.frames.get(&(camera, *key)).copied()
            }))
        };
        (0..self.given).map(part).collect()
    }

    /// Number of the first frame of the first trigger that the camera saw.
    fn first_number(&self, camera: usize) -> u64 {
        let Some((trigger, keys)) = self.shots.first_key_value() else { return 0 };
        let unseen = (0..*trigger).filter(|t| self.missed.contains(&(camera, *t))).count() as u64;
        let number = keys.get(camera).map_or(0, |keys| keys[0].frame_id);
        number.saturating_sub(2 * (trigger - unseen))
    }
}

#[cfg(test)]
mod tests {
    use lfpiv_hw::{TimingSettings, device::StreamStatistics};

    use super::*;
    use crate::acquisition::journal::FrameHead;

    /// Entries of two cameras, with the position of each frame.
    struct Rig(Seen);

    fn key(frame_id: u64) -> FrameKey {
        FrameKey { frame_id, device_timestamp_ns: 1000 * frame_id }
    }

    fn place(camera: usize, frame_id: u64) -> Position {
        Position { segment: camera as u32, offset: frame_id }
    }

    impl Rig {
        fn fired(first: u64, shots: u64) -> Self {
            let mut rig = Self(Seen::default());
            let schedule = PulseSchedule::plan(&TimingSettings::default(), 100.0, 10.0).unwrap();
            rig.entry(Entry::Programmed { at_ns: 0, identity: String::new(), schedule });
            rig.entry(Entry::Fired { at_ns: 0, first, shots });
            rig
        }

        fn entry(&mut self, entry: Entry) {
            self.0.take(LocatedEntry { position: place(0, 0), entry });
        }

        fn frame(&mut self, camera: usize, frame_id: u64, status: FrameStatus) {
            let FrameKey { device_timestamp_ns, .. } = key(frame_id);
            let frame = FrameHead { frame_id, device_timestamp_ns, host_timestamp_ns: 0, status };
            let statistics = StreamStatistics::default();
            let entry = Entry::Frame { at_ns: 0, camera, frame, statistics };
            self.0.take(LocatedEntry { position: place(camera, frame_id), entry });
        }

        fn shot(&mut self, trigger: u64, first_ids: [u64; 2]) {
            for (camera, id) in first_ids.into_iter().enumerate() {
                self.frame(camera, id, FrameStatus::Complete);
                self.frame(camera, id + 1, FrameStatus::Complete);
            }
            self.entry(Entry::Shot {
                trigger,
                frames: first_ids.map(|id| [key(id), key(id + 1)]).to_vec(),
                residuals_ns: vec![0; 2],
                suspect: Vec::new(),
                dt_us: 100.0,
            });
        }

        fn settled(&mut self, trigger: u64, outcomes: [Outcome; 2]) {
            for (camera, outcome) in outcomes.into_iter().enumerate() {
                self.entry(Entry::Settled { trigger, camera, outcome });
            }
        }

        fn parts(&self) -> Vec<Vec<Delivered>> {
            self.0.triggers(2).0.into_iter().map(|trigger| trigger.cameras).collect()
        }
    }

    fn whole(camera: usize, first_id: u64) -> Delivered {
        Delivered::Frames([first_id, first_id + 1].map(|id| Some(place(camera, id))))
    }

    #[test]
    fn lost_damaged_and_missed_frames_do_not_shift_the_others() {
        let mut rig = Rig::fired(0, 6);
        rig.shot(0, [0, 0]);
        // Camera 0: frame b lost; camera 1: complete.
        rig.frame(0, 2, FrameStatus::Complete);
        rig.frame(1, 2, FrameStatus::Complete);
        rig.frame(1, 3, FrameStatus::Complete);
        rig.settled(1, [Outcome::MissingPackets, Outcome::Unpaired]);
        // Camera 0: complete; camera 1: missed the trigger.
        rig.frame(0, 4, FrameStatus::Complete);
        rig.frame(0, 5, FrameStatus::Complete);
        rig.settled(2, [Outcome::Unpaired, Outcome::MissedTrigger]);
        // Camera 0: frame a damaged; camera 1: both lost.
        rig.frame(0, 6, FrameStatus::MissingPackets);
        rig.frame(0, 7, FrameStatus::Complete);
        rig.settled(3, [Outcome::MissingPackets; 2]);
        rig.shot(4, [8, 6]);
        // The run ended before this trigger was complete.
        rig.settled(5, [Outcome::Shed; 2]);
        let b_lost = Delivered::Frames([Some(place(0, 2)), None]);
        let a_damaged = Delivered::Frames([None, Some(place(0, 7))]);
        let wanted = [
            vec![whole(0, 0), whole(1, 0)],
            vec![b_lost, whole(1, 2)],
            vec![whole(0, 4), Delivered::Missed],
            vec![a_damaged, Delivered::Frames([None; 2])],
            vec![whole(0, 8), whole(1, 6)],
        ];
        assert_eq!(rig.parts(), wanted);
    }

    #[test]
    fn frames_before_the_first_shot_are_assigned_backwards() {
        let mut rig = Rig::fired(0, 3);
        rig.settled(0, [Outcome::MissedTrigger, Outcome::Unpaired]);
        rig.frame(1, 10, FrameStatus::Complete);
        rig.frame(1, 11, FrameStatus::Complete);
        rig.settled(1, [Outcome::MissingPackets, Outcome::Unpaired]);
        rig.frame(0, 1, FrameStatus::Complete);
        rig.frame(1, 12, FrameStatus::Complete);
        rig.frame(1, 13, FrameStatus::Complete);
        rig.shot(2, [2, 14]);
        let wanted = [
            vec![Delivered::Missed, whole(1, 10)],
            vec![Delivered::Frames([None, Some(place(0, 1))]), whole(1, 12)],
            vec![whole(0, 2), whole(1, 14)],
        ];
        assert_eq!(rig.parts(), wanted);
    }

    #[test]
    fn a_trigger_that_no_camera_saw_takes_no_frames_from_the_next() {
        let mut rig = Rig::fired(0, 3);
        rig.shot(0, [0, 0]);
        rig.settled(1, [Outcome::NotFired; 2]);
        rig.frame(0, 2, FrameStatus::Complete);
        rig.frame(0, 3, FrameStatus::Complete);
        rig.settled(2, [Outcome::Unpaired, Outcome::MissedTrigger]);
        let wanted = [
            vec![whole(0, 0), whole(1, 0)],
            vec![Delivered::Missed; 2],
            vec![whole(0, 2), Delivered::Missed],
        ];
        assert_eq!(rig.parts(), wanted);
    }

    #[test]
    fn a_withdrawn_trigger_is_given_again_with_its_new_schedule() {
        let mut rig = Rig::fired(0, 2);
        rig.shot(0, [0, 0]);
        rig.entry(Entry::Withdrawn { trigger: 1 });
        let schedule = PulseSchedule::plan(&TimingSettings::default(), 50.0, 10.0).unwrap();
        rig.entry(Entry::Programmed { at_ns: 0, identity: String::new(), schedule });
        rig.entry(Entry::Fired { at_ns: 0, first: 1, shots: 1 });
        rig.shot(1, [2, 2]);
        let triggers = rig.0.triggers(2);
        let dt_us = |trigger| triggers.get(trigger).map(|found| found.schedule.dt_us);
        assert_eq!([dt_us(0), dt_us(1), dt_us(2)], [Some(100.0), Some(50.0), None]);
    }
}
