//! Unwraps a camera's 16-bit frame counter to 64 bits.
//!
//! A GigE Vision camera counts frames 1, 2, …, 65,535, 1, …: zero is skipped. The counter starts at an
//! arbitrary value. Cameras with extended ids count in 64 bits.

/// Number of values of the 16-bit counter.
const CYCLE: i64 = 65_535;

/// Numbers the frames of a stream, starting at a given number.
#[derive(Debug, Clone)]
pub struct FrameIds {
    /// Number of the first frame.
    first: u64,
    /// Highest counter value seen, and its number.
    last: Option<(u64, u64)>,
    extended: bool,
}

impl FrameIds {
    /// The first frame will have the number `first`.
    pub fn starting_at(first: u64) -> Self {
        Self { first, last: None, extended: false }
    }

    /// The number of the frame with this counter value. Frames may be missing (fewer than half a cycle,
    /// 32,767), duplicated or out of order.
    ///
    /// `None` for the value 0, which no frame has, and for frames before the first one.
    pub fn number(&mut self, counter: u64) -> Option<u64> {
        if counter == 0 {
            return None;
        }
        let Some((last_counter, last_number)) = self.last else {
            self.last = Some((counter, self.first));
            return Some(self.first);
        };
        // A 16-bit counter never exceeds 65,535.
        self.extended |= counter > CYCLE as u64;
        let ahead = counter.wrapping_sub(last_counter) as i64;
        let ahead = if self.extended { ahead } else { nearest(ahead) };
        let number = last_number.checked_add_signed(ahead).filter(|n| *n >= self.first)?;
        if ahead > 0 {
            self.last = Some((counter, number));
        }
        Some(number)
    }

    /// The number after the highest one assigned.
    pub fn next(&self) -> u64 {
        self.last.map_or(self.first, |(_, number)| number + 1)
    }

    /// The camera's counter has restarted (it was away): the next frame is the first of the next
    /// trigger, with `frames_per_trigger` frames each.
    pub fn resume(&mut self, frames_per_trigger: u64) {
        *self = Self::starting_at(self.next().next_multiple_of(frames_per_trigger.max(1)));
    }
}

/// A counter difference, modulo the cycle, of smallest magnitude.
fn nearest(ahead: i64) -> i64 {
    let forward = ahead.rem_euclid(CYCLE);
    if forward > CYCLE / 2 { forward - CYCLE } else { forward }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// The counter after `frames` frames, counted one by one.
    fn counters(start: u64, frames: usize) -> Vec<u64> {
        let mut counter = start;
        (0..frames)
            .map(|_| {
                let shown = counter;
                counter = if counter == 65_535 { 1 } else { counter + 1 };
                shown
            })
            .collect()
    }

    #[test]
    fn numbers_run_through_two_wraps() {
        let mut ids = FrameIds::starting_at(0);
        for (number, counter) in counters(65_400, 200_000).into_iter().enumerate() {
            assert_eq!(ids.number(counter), Some(number as u64));
        }
        assert_eq!(ids.next(), 200_000);
    }

    #[test]
    fn after_a_reconnection_the_next_frame_begins_a_trigger() {
        let mut ids = FrameIds::starting_at(0);
        for counter in counters(65_534, 5) {
            ids.number(counter);
        }
        ids.resume(2);
        assert_eq!(ids.number(65_401), Some(6));
        assert_eq!(ids.number(65_402), Some(7));
        assert_eq!(ids.number(65_400), None, "before the first");
        ids.resume(2);
        assert_eq!(ids.number(9), Some(8));
    }

    #[test]
    fn zero_is_no_frame_and_extended_ids_do_not_wrap() {
        let mut ids = FrameIds::starting_at(0);
        assert_eq!(ids.number(0), None);
        assert_eq!(ids.number(65_535), Some(0));
        assert_eq!(ids.number(65_536), Some(1));
        assert_eq!(ids.number(165_536), Some(100_001));
    }

    proptest! {
        /// Frames may be lost, duplicated or overtaken by a few places; each frame still gets its
        /// own number.
        #[test]
        fn numbers_survive_gaps_duplicates_and_reordering(
            start in prop_oneof![1..=65_535_u64, 65_300..=65_535_u64],
            kept in proptest::collection::vec(
                (prop_oneof![9 => 1..4_usize, 1 => 4..6000_usize], 0..4_usize, any::<bool>()),
                1..200,
            ),
        ) {
            let total: usize = kept.iter().map(|(step, ..)| step).sum();
            let sent = counters(start, total + 1);
            let mut arrivals = Vec::new();
            let mut at = 0;
            for (position, (step, delay, twice)) in kept.iter().enumerate() {
                at += step;
                arrivals.push((position + delay, at));
                if *twice {
                    arrivals.push((position + delay + 1, at));
                }
            }
            // Five places of up to 6000 frames each: always less than half a cycle late.
            arrivals.sort_by_key(|(place, _)| *place);
            let mut ids = FrameIds::starting_at(0);
            prop_assert_eq!(ids.number(sent[0]), Some(0));
            for (_, at) in arrivals {
                prop_assert_eq!(ids.number(sent[at]), Some(at as u64));
            }
        }
    }
}
