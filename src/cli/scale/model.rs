//! How many shots a second a number of machines measures.
//!
//! A closed queueing network. Each slot of a worker is a customer. A shot costs a time `Z` in which slots do not
//! disturb each other (measuring, waiting for the broker), and demands `D_k` of stations that all slots share: the
//! coordinator's network, and the coordinator itself. Exact mean value analysis (Reiser and Lavenberg 1980) gives
//! the throughput `X` of `n` slots from that of `n - 1`:
//!
//! ```text
//! R_k(n) = D_k (1 + Q_k(n - 1)),   X(n) = n / (Z + sum R_k(n)),   Q_k(n) = X(n) R_k(n)
//! ```
//!
//! It holds for any distribution of the times where stations share their capacity evenly, as a link does (Baskett,
//! Chandy, Muntz and Palacios 1975). It tends to `n / (Z + sum D_k)` for few slots and to `1 / max D_k` for many.

/// What a shot costs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Costs {
    /// Time in which slots do not disturb each other, in s.
    pub apart_s: f64,
    /// Time of the coordinator's network, in s.
    pub network_s: f64,
    /// Time of the coordinator, in s.
    pub coordinator_s: f64,
}

/// What the throughput tends to with ever more machines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Limit {
    Network,
    Coordinator,
}

impl Costs {
    /// Shots a second of one slot, of two, and so on.
    fn rates(&self) -> impl Iterator<Item = f64> {
        let Self { apart_s, network_s, coordinator_s } = *self;
        // Rounding may pass it by a hair.
        let most = self.most_shots_per_s();
        (1u32..).scan([0.0; 2], move |queues, slots| {
            let demands = [network_s, coordinator_s];
            let times: [f64; 2] = std::array::from_fn(|k| demands[k] * (1.0 + queues[k]));
            let rate = f64::from(slots) / (apart_s + times[0] + times[1]);
            *queues = times.map(|time| rate * time);
            Some(rate.min(most))
        })
    }

    /// Shots a second of `slots` slots.
    pub fn shots_per_s(&self, slots: usize) -> f64 {
        self.rates().take(slots).last().unwrap_or(0.0)
    }

    /// Shots a second that no number of machines exceeds.
    pub fn most_shots_per_s(&self) -> f64 {
        1.0 / self.network_s.max(self.coordinator_s)
    }

    /// What sets that limit.
    pub fn limit(&self) -> Limit {
        match self.network_s > self.coordinator_s {
            true => Limit::Network,
            false => Limit::Coordinator,
        }
    }

    /// Number of slots at which the straight line of few slots meets the limit: where the throughput saturates.
    pub fn knee(&self) -> f64 {
        self.most_shots_per_s() * (self.apart_s + self.network_s + self.coordinator_s)
    }

    /// The least number of slots that reach a rate; `None` if none of at most `most` does.
    pub fn slots_for(&self, shots_per_s: f64, most: usize) -> Option<usize> {
        self.rates().take(most).position(|rate| rate >= shots_per_s).map(|before| before + 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const COSTS: Costs = Costs { apart_s: 1.0, network_s: 0.02, coordinator_s: 0.005 };

    #[test]
    fn few_slots_do_not_meet_and_many_meet_the_limit() {
        assert_eq!(COSTS.shots_per_s(0), 0.0);
        assert!((COSTS.shots_per_s(1) - 1.0 / 1.025).abs() < 1e-12);
        assert!((COSTS.shots_per_s(500) - 50.0).abs() < 0.01);
        assert_eq!((COSTS.most_shots_per_s(), COSTS.limit()), (50.0, Limit::Network));
        assert!((COSTS.knee() - 51.25).abs() < 1e-9);
        // Between both bounds everywhere, and never falling.
        let mut before = 0.0;
        for slots in 1..200 {
            let rate = COSTS.shots_per_s(slots);
            let most = 50.0_f64.min(slots as f64 / 1.025) + 1e-9;
            assert!(rate > before - 1e-9 && rate <= most, "{slots}");
            before = rate;
        }
    }

    /// Two slots and one station, by the balance of states: with rate `1/Z` a slot leaves its own work, with rate
    /// `1/D` the station serves. The station is idle with probability `1 / (1 + 2r + 2r²)`, `r = D/Z`.
    #[test]
    fn two_slots_at_one_station_as_by_the_balance_of_states() {
        for r in [0.1, 1.0, 7.0] {
            let costs = Costs { apart_s: 1.0, network_s: r, coordinator_s: 0.0 };
            let idle = 1.0 / (1.0 + 2.0 * r + 2.0 * r * r);
            assert!((costs.shots_per_s(2) - (1.0 - idle) / r).abs() < 1e-12, "{r}");
        }
    }

    #[test]
    fn the_least_number_of_slots_for_a_rate() {
        assert_eq!(COSTS.slots_for(0.9, 64), Some(1));
        let slots = COSTS.slots_for(20.0, 64).unwrap();
        assert!(COSTS.shots_per_s(slots) >= 20.0 && COSTS.shots_per_s(slots - 1) < 20.0);
        assert_eq!(COSTS.slots_for(51.0, 1000), None);
    }
}
