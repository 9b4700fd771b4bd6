//! Workers, their rates and the backlog in OpenMetrics text.

use std::fmt;

use prometheus_client::{
    encoding::{DescriptorEncoder, EncodeMetric},
    metrics::{MetricType, counter::ConstCounter, gauge::ConstGauge},
};

use crate::cluster::{ClusterView, ShotsView, WorkerState, WorkerView};

/// Writes what `view` shows.
pub(super) fn encode(view: &ClusterView, encoder: &mut DescriptorEncoder) -> fmt::Result {
    let up = ConstGauge::new(i64::from(view.connected));
    let help = "1 while the broker answers, 0 while it does not";
    let metric = encoder.encode_descriptor("cluster_broker_up", help, None, MetricType::Gauge)?;
    up.encode(metric)?;
    encode_shots(&view.shots, encoder)?;
    encode_workers(&view.workers, encoder)
}

fn encode_shots(shots: &ShotsView, encoder: &mut DescriptorEncoder) -> fmt::Result {
    let gauges = [
        ("cluster_backlog_shots", "Shots that are still to be measured", shots.backlog),
        ("cluster_in_hand_shots", "Shots that workers are measuring", shots.in_hand),
        ("cluster_given_up_shots", "Shots that were given up", shots.given_up),
    ];
    for (name, help, count) in gauges {
        let metric = encoder.encode_descriptor(name, help, None, MetricType::Gauge)?;
        ConstGauge::new(count as i64).encode(metric)?;
    }
    let counters = [
        ("cluster_attempts", "Measurements that workers have started", shots.attempts),
        ("cluster_lost_workers", "Measurements that workers did not end", shots.lost_workers),
        ("cluster_refused_results", "Results that were refused", shots.refused_results),
    ];
    for (name, help, count) in counters {
        let metric = encoder.encode_descriptor(name, help, None, MetricType::Counter)?;
        ConstCounter::new(count).encode(metric)?;
    }
    Ok(())
}

fn encode_workers(workers: &[WorkerView], encoder: &mut DescriptorEncoder) -> fmt::Result {
    type Counter = (&'static str, &'static str, fn(&WorkerView) -> u64);
    const COUNTERS: [Counter; 4] = [
        (
            "cluster_worker_shots",
            "Shots of which the worker was the first to deliver a result",
            |w| w.shots,
        ),
        ("cluster_worker_attempts", "Measurements that the worker has started", |w| w.attempts),
        ("cluster_worker_failures", "Those of which it has reported a failure", |w| w.failures),
        ("cluster_worker_not_ended", "Those that it did not end", |w| w.not_ended),
    ];
    for (name, help, value) in COUNTERS {
        let mut family = encoder.encode_descriptor(name, help, None, MetricType::Counter)?;
        for worker in workers {
            let labels = [("worker", worker.worker.as_str())];
            ConstCounter::new(value(worker)).encode(family.encode_family(&labels)?)?;
        }
    }
    type Gauge = (&'static str, &'static str, fn(&WorkerView) -> f64);
    const GAUGES: [Gauge; 4] = [
        ("cluster_worker_lost", "1 if the worker was silent for too long, otherwise 0", |w| {
            f64::from(u8::from(w.state == WorkerState::Lost))
        }),
        ("cluster_worker_shots_per_second", "First results a second, over the last minute", |w| {
            w.shots_per_s
        }),
        ("cluster_worker_in_hand_shots", "Shots begun and not ended", |w| w.in_hand as f64),
        ("cluster_worker_silent_seconds", "Time since the worker was last heard of", |w| {
            w.silent_s
        }),
    ];
    for (name, help, value) in GAUGES {
        let mut family = encoder.encode_descriptor(name, help, None, MetricType::Gauge)?;
        for worker in workers {
            let labels = [("worker", worker.worker.as_str())];
            ConstGauge::new(value(worker)).encode(family.encode_family(&labels)?)?;
        }
    }
    Ok(())
}
