//! Compares the light of the exposures with that of the record.

use lfpiv_hw::PulseSchedule;
use lfpiv_sim::{LightPulse, wire::exposure::LaserFacts};

/// Largest time difference of a pulse, in s. A unit sets times in steps of a quarter of a nanosecond.
const TIME_TOLERANCE_S: f64 = 1e-9;
/// Largest energy difference of a pulse, relative to the full energy.
const ENERGY_TOLERANCE: f64 = 0.01;

/// Whether each exposure contains exactly the pulse that it had under `schedule`. A pulse in the wrong
/// exposure, a lamp at the wrong time or another pulse separation do not give the recorded images.
pub(super) fn is_as_recorded(
    light: &[Vec<LightPulse>; 2],
    schedule: &PulseSchedule,
    laser: &LaserFacts,
) -> bool {
    let half_s = schedule.dt_us * 1e-6 / 2.0;
    light.iter().zip([-half_s, half_s]).enumerate().all(|(head, (pulses, at_s))| {
        let delay_us = schedule.q_switch_us[head] - schedule.lamp_us[head];
        let energy = laser.energy(head, delay_us);
        let [pulse] = pulses.as_slice() else { return false };
        (pulse.at_s - at_s).abs() <= TIME_TOLERANCE_S
            && (pulse.energy - energy).abs() <= ENERGY_TOLERANCE
    })
}

#[cfg(test)]
mod tests {
    use lfpiv_hw::TimingSettings;

    use super::*;

    fn pulse(at_us: f64, energy: f64) -> LightPulse {
        LightPulse { at_s: at_us * 1e-6, energy }
    }

    #[test]
    fn only_the_recorded_light_matches() {
        let schedule = PulseSchedule::plan(&TimingSettings::default(), 100.0, 10.0).unwrap();
        let (first, second) = (pulse(-50.0, 1.0), pulse(50.0, 1.0));
        let shows =
            |light: [Vec<LightPulse>; 2]| is_as_recorded(&light, &schedule, &LaserFacts::default());
        assert!(shows([vec![first], vec![second]]));
        assert!(shows([vec![pulse(-50.000_2, 1.0)], vec![pulse(50.000_2, 0.995)]]));
        for wrong in [
            [vec![first, second], vec![]],
            [vec![], vec![second]],
            [vec![second], vec![first]],
            [vec![pulse(-50.01, 1.0)], vec![pulse(50.01, 1.0)]],
            [vec![pulse(-50.0, 0.8)], vec![second]],
            [vec![], vec![]],
        ] {
            assert!(!shows(wrong.clone()), "{wrong:?}");
        }
    }
}
