//! The decision rules of the state machine.

use std::{ops::Range, time::Duration};

use lfpiv_hw::{CameraName, device::Frame};

use super::{Decision, OpenTrigger, Outcome, Pairing, Shot, Slot};

/// Why a shot is suspect whose frames came while the laser was being switched off.
const MAY_BE_DARK: &str = "the laser was being switched off and may not have lit both exposures";

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

    /// The camera has delivered a frame of `trigger`: its missing frames of earlier ones are
    /// probably lost.
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
        decisions: &mut Vec<Decision>,
    ) {
        let triggers: Vec<u64> = self.open.range(triggers).map(|(trigger, _)| *trigger).collect();
        for trigger in triggers {
            if let Some(open) = self.open.get_mut(&trigger) {
                open.slots[camera].missed = true;
            }
            self.close_unpaired(trigger, decisions);
            self.close_slots(trigger, |slot| slot.missed && slot.is_empty(), decisions);
        }
    }

    /// A frame was added: pairs the shot when it was the last one.
    pub(super) fn try_pair(&mut self, trigger: u64, decisions: &mut Vec<Decision>) {
        let Some(open) = self.open.get(&trigger) else { return };
        if open.given_up {
            return self.settle_full_slots(trigger, decisions);
        }
        if !open.slots.iter().all(Slot::is_full) {
            return;
        }
        if let Some((camera, missed)) = self.find_camera_behind(open) {
            return self.reassign_frames(camera, missed, decisions);
        }
        if let Some(open) = self.open.remove(&trigger) {
            self.pair(trigger, open, decisions);
        }
    }

    /// The camera whose frames lag the others' by whole periods, given the clock differences, and the
    /// number of periods.
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

    /// The camera missed the burst's first `missed` triggers: reassigns its frames to later ones.
    fn reassign_frames(&mut self, camera: usize, missed: u64, decisions: &mut Vec<Decision>) {
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
        self.mark_missed(camera, burst.first..(burst.first + missed).min(burst.end), decisions);
        for trigger in triggers {
            self.try_pair(trigger, decisions);
        }
    }

    fn take_frames(&mut self, camera: usize, trigger: u64) -> [Option<Frame>; 2] {
        match self.open.get_mut(&trigger) {
            Some(open) => std::mem::take(&mut open.slots[camera].frames),
            None => [None, None],
        }
    }

    /// Every camera has delivered: makes a shot, unless a frame is damaged.
    fn pair(&mut self, trigger: u64, mut open: OpenTrigger, decisions: &mut Vec<Decision>) {
        if open.slots.iter().any(Slot::is_damaged) {
            for (camera, slot) in open.slots.iter().enumerate() {
                let outcome = slot.outcome_without_partner();
                decisions.push(Decision::Settled { trigger, camera, outcome });
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
        suspect.extend(open.may_be_dark.then(|| MAY_BE_DARK.to_owned()));
        let cameras: Vec<[Frame; 2]> =
            open.slots.into_iter().filter_map(|slot| both(slot.frames)).collect();
        suspect.extend(self.check_intervals(&cameras));
        self.counters.paired += 2 * cameras.len() as u64;
        let residuals_ns = compared.residuals_ns;
        let dt_us = self.settings.dt_us;
        // Pairing has no clock: the caller adds the time.
        let (time, due) = (None, open.due);
        let shot = Shot { trigger, cameras, time, due, dt_us, suspect, residuals_ns };
        decisions.push(Decision::Paired(shot));
    }

    /// Checks that frame b follows frame a after the scheduled interval.
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

    /// Ends the wait for overdue frames.
    pub(super) fn expire_overdue(
        &mut self,
        trigger: u64,
        now: Duration,
        decisions: &mut Vec<Decision>,
    ) {
        let patience = self.settings.patience;
        let Some(open) = self.open.get_mut(&trigger) else { return };
        if trigger >= self.given && open.has_no_evidence() {
            return;
        }
        let mut any_overdue = false;
        for (slot, last_arrival) in open.slots.iter_mut().zip(&self.last_arrival) {
            // A camera that still delivers is slow, not silent: count from its last frame.
            let due = open.due.max(*last_arrival);
            if !slot.settled && !slot.is_full() && slot.is_overdue(due, now, patience) {
                // The deadline itself, not the time of this check.
                slot.overdue_at.get_or_insert(slot.deadline(due, patience));
                any_overdue = true;
            }
        }
        if any_overdue {
            self.close_unpaired(trigger, decisions);
        }
        let over = |slot: &Slot| slot.overdue_at.is_some_and(|since| now > since + patience);
        self.close_slots(trigger, over, decisions);
    }

    /// The shot cannot be paired: settles the complete slots.
    pub(super) fn close_unpaired(&mut self, trigger: u64, decisions: &mut Vec<Decision>) {
        if let Some(open) = self.open.get_mut(&trigger) {
            open.given_up = true;
        }
        self.settle_full_slots(trigger, decisions);
    }

    fn settle_full_slots(&mut self, trigger: u64, decisions: &mut Vec<Decision>) {
        let Some(open) = self.open.get_mut(&trigger) else { return };
        for (camera, slot) in open.slots.iter_mut().enumerate() {
            if !slot.settled && slot.is_full() {
                let outcome = slot.outcome_without_partner();
                decisions.push(Decision::Settled { trigger, camera, outcome });
                self.counters.unpaired += slot.settle();
            }
        }
        self.drop_when_settled(trigger);
    }

    /// Settles the incomplete slots that `choose` selects.
    pub(super) fn close_slots(
        &mut self,
        trigger: u64,
        choose: impl Fn(&Slot) -> bool,
        decisions: &mut Vec<Decision>,
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
                // Neither a frame nor a later one whose id would prove that this one was sent.
                Outcome::MissedTrigger
            } else {
                Outcome::MissingPackets
            };
            decisions.push(Decision::Settled { trigger, camera, outcome });
            self.counters.unpaired += slot.settle();
        }
        self.drop_when_settled(trigger);
    }

    /// Sheds the rest at the end of the run: there is no evidence of a loss.
    pub(super) fn shed_incomplete(&mut self, trigger: u64, decisions: &mut Vec<Decision>) {
        let Some(open) = self.open.get_mut(&trigger) else { return };
        for (camera, slot) in open.slots.iter_mut().enumerate() {
            let lost = slot.missed || slot.passed_at.is_some() || slot.overdue_at.is_some();
            if !slot.settled && !lost {
                decisions.push(Decision::Settled { trigger, camera, outcome: Outcome::Shed });
                self.counters.unpaired += slot.settle();
            }
        }
        self.drop_when_settled(trigger);
    }

    /// Closes a trigger at the end of the run without evidence that it was given.
    pub(super) fn close_unseen(&mut self, trigger: u64, decisions: &mut Vec<Decision>) {
        let Some(open) = self.open.remove(&trigger) else { return };
        if open.due > self.now {
            decisions.push(Decision::Withdrawn { trigger });
            return;
        }
        decisions.push(Decision::Given { trigger });
        self.announced_given = trigger + 1;
        let cameras = 0..open.slots.len();
        let outcome = Outcome::NotFired;
        decisions.extend(cameras.map(|camera| Decision::Settled { trigger, camera, outcome }));
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
