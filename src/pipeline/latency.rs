//! Latency of the last shots, from trigger to stored velocity.

use std::{collections::VecDeque, time::Duration};

use serde::Serialize;

/// Shots over which quantiles are computed.
const REMEMBERED: usize = 1000;

/// Quantiles of the latency, in s, over the last thousand shots.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LatencyQuantiles {
    /// Number of shots.
    pub shots: usize,
    /// Median.
    pub p50_s: f64,
    /// 95th percentile.
    pub p95_s: f64,
    /// 99th percentile.
    pub p99_s: f64,
}

/// See the module.
#[derive(Debug, Default)]
pub(super) struct Latencies(VecDeque<Duration>);

impl Latencies {
    pub fn add(&mut self, latency: Duration) {
        self.0.push_back(latency);
        if self.0.len() > REMEMBERED {
            self.0.pop_front();
        }
    }

    /// `None` before the first shot.
    pub fn quantiles(&self) -> Option<LatencyQuantiles> {
        let mut sorted: Vec<Duration> = self.0.iter().copied().collect();
        sorted.sort_unstable();
        let last = sorted.len().checked_sub(1)?;
        let at = |share: f64| sorted[(share * last as f64).round() as usize].as_secs_f64();
        Some(LatencyQuantiles {
            shots: sorted.len(),
            p50_s: at(0.5),
            p95_s: at(0.95),
            p99_s: at(0.99),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_of_the_last_shots() {
        let mut latencies = Latencies::default();
        assert_eq!(latencies.quantiles(), None);
        latencies.add(Duration::from_secs(1000));
        (0..=1000).for_each(|ms| latencies.add(Duration::from_millis(ms)));
        let found = latencies.quantiles().unwrap();
        assert_eq!(found.shots, REMEMBERED);
        for (quantile, expected) in [(found.p50_s, 0.5), (found.p95_s, 0.95), (found.p99_s, 0.99)] {
            assert!((quantile - expected).abs() < 0.002, "{quantile} {expected}");
        }
    }
}
