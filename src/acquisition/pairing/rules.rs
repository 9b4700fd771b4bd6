//! The rules by which the state machine decides.

use std::{ops::Range, time::Duration};

use lfpiv_hw::{CameraName, device::Frame};

use super::{OpenTrigger, Outcome, Pairing, Ruling, Shot, Slot};

impl Pairing {
    /// Keeps a frame; `false` when it is a duplicate or belongs to no open trigger.
    pub(super) fn store(
        &mut self,
        camera: usize,
        trigger: u64,
        half: usize,
        frame: Frame,
        disagreement: Option<String>,
    ) -> bool {
        let Some(open) = self.open.get_mut(&trigger) else {
            self.counters.stray += 1;
            return false;
        };
        let slot = &mut open.slots[camera];
        if slot.settled {
            self.counters.stray += 1;
            return false;
        }
        if !slot.put(half, frame) {
            self.counters.duplicate += 1;
            return false;
        }
        slot.disagreement
            .extend(disagreement.map(|words| format!("{}: {words}", CameraName(camera))));
        true
    }

    /// The camera went on to `trigger`: whatever it still owes of earlier ones is probably lost.
    pub(super) fn mark_passed(&mut self, camera: usize, trigger: u64, now: Duration) {
        for (_, open) in self.open.range_mut(..trigger) {
            let slot = &mut open.slots[camera];
            if !slot.is_full() {
                slot.passed_at.get_or_insert(now);
            }
        }
    }

    /// The camera did not see these triggers, so they cannot be paired.
    pub(super) fn mark_missed(
        &mut self,
        camera: usize,
        triggers: Range<u64>,
        rulings: &mut Vec<Ruling>,
    ) {
        let triggers: Vec<u64> = self.open.range(triggers).map(|(trigger, _)| *trigger).collect();
        for trigger in triggers {
            if let Some(open) = self.open.get_mut(&trigger) {
                open.slots[camera].missed = true;
            }
            self.give_up(trigger, rulings);
            self.close_slots(trigger, |slot| slot.missed && slot.is_empty(), rulings);
        }
    }

    /// A frame was added: pair the shot when it was the last one.
    pub(super) fn examine(&mut self, trigger: u64, rulings: &mut Vec<Ruling>) {
        let Some(open) = self.open.get(&trigger) else { return };
        if open.given_up {
            return self.settle_full_slots(trigger, rulings);
        }
        if !open.slots.iter().all(Slot::is_full) {
            return;
        }
        if let Some((camera, missed)) = self.find_camera_behind(open) {
            return self.move_on(camera, missed, rulings);
        }
        if let Some(open) = self.open.remove(&trigger) {
            self.pair(trigger, open, rulings);
        }
    }

    /// The camera whose frames are whole periods after the others', given the differences between
    /// their clocks, and by how many periods.
    fn find_camera_behind(&self, open: &OpenTrigger) -> Option<(usize, u64)> {
        if open.slots.iter().any(|slot| !slot.disagreement.is_empty()) {
            return None;
        }
        let first_ns = open.slots[0].timestamp_ns()?;
        open.slots.iter().enumerate().find_map(|(camera, slot)| {
            let moved_ns = self.clocks.difference_ns(camera, first_ns, slot.timestamp_ns()?)?;
            let (steps, off_grid_ns) = self.grid.steps(moved_ns);
            let behind = if steps > 0 { camera } else { 0 };
            let clear = steps != 0 && off_grid_ns.abs() <= self.grid.tolerance_ns();
            clear.then(|| (behind, steps.unsigned_abs() as u64))
        })
    }

    /// The camera missed the burst's first `missed` triggers: its frames belong to later ones.
    fn move_on(&mut self, camera: usize, missed: u64, rulings: &mut Vec<Ruling>) {
        let track = &mut self.tracks[camera];
        track.missed += missed;
        if let Some((trigger, _)) = &mut track.clock {
            *trigger += missed;
        }
        let burst = self.burst;
        let triggers: Vec<u64> = self.open.range(burst.first..).map(|(t, _)| *t).collect();
        for trigger in triggers.iter().rev() {
            let frames = self.take_frames(camera, *trigger);
            for (half, frame) in frames.into_iter().enumerate() {
                if let Some(frame) = frame {
                    self.store(camera, trigger + missed, half, frame, None);
                }
            }
        }
        self.mark_missed(camera, burst.first..(burst.first + missed).min(burst.end), rulings);
        for trigger in triggers {
            self.examine(trigger, rulings);
        }
    }

    fn take_frames(&mut self, camera: usize, trigger: u64) -> [Option<Frame>; 2] {
        match self.open.get_mut(&trigger) {
            Some(open) => std::mem::take(&mut open.slots[camera].frames),
            None => [None, None],
        }
    }

    /// Every camera has delivered: a shot, unless a frame is damaged.
    fn pair(&mut self, trigger: u64, mut open: OpenTrigger, rulings: &mut Vec<Ruling>) {
        if open.slots.iter().any(Slot::is_damaged) {
            for (camera, slot) in open.slots.iter().enumerate() {
                let outcome = slot.outcome_without_partner();
                rulings.push(Ruling::Settled { trigger, camera, outcome });
                self.counters.unpaired += slot.frames_held();
            }
            return;
        }
        let mut suspect: Vec<String> =
            open.slots.iter_mut().flat_map(|slot| slot.disagreement.drain(..)).collect();
        let timestamps_ns: Vec<i128> = open.slots.iter().filter_map(Slot::timestamp_ns).collect();
        let place = (trigger, self.burst, self.grid);
        let compared = self.clocks.compare(place, &timestamps_ns, suspect.is_empty(), self.now);
        suspect.extend(compared.suspect);
        let cameras: Vec<[Frame; 2]> =
            open.slots.into_iter().filter_map(|slot| both(slot.frames)).collect();
        suspect.extend(self.check_intervals(&cameras));
        self.counters.paired += 2 * cameras.len() as u64;
        let residuals_ns = compared.residuals_ns;
        let dt_us = self.settings.dt_us;
        // Pairing is without clocks: whoever has them adds the time.
        let (time, due) = (None, open.due);
        let shot = Shot { trigger, cameras, time, due, dt_us, suspect, residuals_ns };
        rulings.push(Ruling::Paired(shot));
    }

    /// Frame b must follow frame a after the time the schedule sets.
    fn check_intervals(&self, cameras: &[[Frame; 2]]) -> Vec<String> {
        let expected = i128::from(self.settings.frame_interval_ns);
        let tolerance = i128::from(self.settings.frame_interval_tolerance_ns);
        let wrong = cameras.iter().enumerate().filter_map(|(camera, [a, b])| {
            let found = i128::from(b.device_timestamp_ns) - i128::from(a.device_timestamp_ns);
            ((found - expected).abs() > tolerance).then(|| {
                let name = CameraName(camera);
                format!("{name}: frame b came {found} ns after frame a, not {expected}")
            })
        });
        wrong.collect()
    }

    /// Looks for frames that will not come.
    pub(super) fn wait_or_give_up(
        &mut self,
        trigger: u64,
        now: Duration,
        rulings: &mut Vec<Ruling>,
    ) {
        let patience = self.settings.patience;
        let Some(open) = self.open.get_mut(&trigger) else { return };
        if trigger >= self.given && open.is_untouched() {
            return;
        }
        let mut any_overdue = false;
        for (slot, last_arrival) in open.slots.iter_mut().zip(&self.last_arrival) {
            // A camera that still delivers is slow, not silent: its clock runs from its last frame.
            let due = open.due.max(*last_arrival);
            if !slot.settled && !slot.is_full() && slot.is_overdue(due, now, patience) {
                // The moment when patience ended, not that at which somebody looked.
                slot.overdue_at.get_or_insert(slot.deadline(due, patience));
                any_overdue = true;
            }
        }
        if any_overdue {
            self.give_up(trigger, rulings);
        }
        let over = |slot: &Slot| slot.overdue_at.is_some_and(|since| now > since + patience);
        self.close_slots(trigger, over, rulings);
    }

    /// The shot will not be paired: what is there of it is settled.
    pub(super) fn give_up(&mut self, trigger: u64, rulings: &mut Vec<Ruling>) {
        if let Some(open) = self.open.get_mut(&trigger) {
            open.given_up = true;
        }
        self.settle_full_slots(trigger, rulings);
    }

    fn settle_full_slots(&mut self, trigger: u64, rulings: &mut Vec<Ruling>) {
        let Some(open) = self.open.get_mut(&trigger) else { return };
        for (camera, slot) in open.slots.iter_mut().enumerate() {
            if !slot.settled && slot.is_full() {
                let outcome = slot.outcome_without_partner();
                rulings.push(Ruling::Settled { trigger, camera, outcome });
                self.counters.unpaired += slot.settle();
            }
        }
        self.drop_when_settled(trigger);
    }

    /// Rules on the unfinished slots that `choose` picks.
    pub(super) fn close_slots(
        &mut self,
        trigger: u64,
        choose: impl Fn(&Slot) -> bool,
        rulings: &mut Vec<Ruling>,
    ) {
        let Some(open) = self.open.get_mut(&trigger) else { return };
        for (camera, slot) in open.slots.iter_mut().enumerate() {
            if slot.settled || slot.is_full() || !choose(slot) {
                continue;
            }
            let track = &mut self.tracks[camera];
            let outcome = if slot.missed && slot.is_empty() {
                Outcome::MissedTrigger
            } else if (0..slot.frames_missing()).filter(|_| track.charge_underrun()).count() > 0 {
                Outcome::Underrun
            } else if slot.is_empty() && slot.passed_at.is_none() {
                // No frame, and no later one whose id would show that this was sent.
                Outcome::MissedTrigger
            } else {
                Outcome::MissingPackets
            };
            rulings.push(Ruling::Settled { trigger, camera, outcome });
            self.counters.unpaired += slot.settle();
        }
        self.drop_when_settled(trigger);
    }

    /// The run ends before there was time for these: nothing says that anything is lost.
    pub(super) fn shed_unfinished(&mut self, trigger: u64, rulings: &mut Vec<Ruling>) {
        let Some(open) = self.open.get_mut(&trigger) else { return };
        for (camera, slot) in open.slots.iter_mut().enumerate() {
            let lost = slot.missed || slot.passed_at.is_some() || slot.overdue_at.is_some();
            if !slot.settled && !lost {
                rulings.push(Ruling::Settled { trigger, camera, outcome: Outcome::Shed });
                self.counters.unpaired += slot.settle();
            }
        }
        self.drop_when_settled(trigger);
    }

    /// The run ends, and nothing shows that the trigger was given.
    pub(super) fn close_unseen(&mut self, trigger: u64, rulings: &mut Vec<Ruling>) {
        let Some(open) = self.open.remove(&trigger) else { return };
        if open.due > self.now {
            rulings.push(Ruling::Withdrawn { trigger });
            return;
        }
        rulings.push(Ruling::Given { trigger });
        self.told_given = trigger + 1;
        let cameras = 0..open.slots.len();
        let outcome = Outcome::NotFired;
        rulings.extend(cameras.map(|camera| Ruling::Settled { trigger, camera, outcome }));
    }

    fn drop_when_settled(&mut self, trigger: u64) {
        if self.open.get(&trigger).is_some_and(|open| open.slots.iter().all(|slot| slot.settled)) {
            self.open.remove(&trigger);
        }
    }
}

fn both(frames: [Option<Frame>; 2]) -> Option<[Frame; 2]> {
    let [a, b] = frames;
    Some([a?, b?])
}
