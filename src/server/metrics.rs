//! `/metrics`: counters and gauges in OpenMetrics text. They are read from ledger and board on
//! request, so that they always agree with `/api/v1/status`.

use std::fmt;

use axum::{
    extract::State,
    http::header,
    response::{IntoResponse, Response},
};
use lfpiv_hw::device::StreamStatistics;
use prometheus_client::{
    collector::Collector,
    encoding::{DescriptorEncoder, EncodeMetric, text::encode},
    metrics::{MetricType, counter::ConstCounter, gauge::ConstGauge},
    registry::Registry,
};

use super::{ApiError, ApiState, brief::ShotCounts, cluster_metrics, status::RawLogView};
use crate::acquisition::Outcome;

const MEDIA_TYPE: &str = "application/openmetrics-text; version=1.0.0; charset=utf-8";

/// Counters and gauges in OpenMetrics text, for Prometheus.
#[utoipa::path(get, path = "/metrics", tag = "live",
    responses((status = 200, content_type = "application/openmetrics-text", body = String)))]
pub(super) async fn metrics(State(state): State<ApiState>) -> Response {
    let mut registry = Registry::with_prefix("lfpiv");
    registry.register_collector(Box::new(Reader(state)));
    written(&registry)
}

/// An answer with all metrics of a registry.
pub(super) fn written(registry: &Registry) -> Response {
    let mut text = String::new();
    match encode(&mut text, registry) {
        Ok(()) => ([(header::CONTENT_TYPE, MEDIA_TYPE)], text).into_response(),
        Err(error) => {
            ApiError::internal(format!("metrics cannot be written: {error}")).into_response()
        }
    }
}

struct Reader(ApiState);

impl fmt::Debug for Reader {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("Reader")
    }
}

impl Collector for Reader {
    fn encode(&self, mut encoder: DescriptorEncoder) -> Result<(), fmt::Error> {
        self.encode_shots(&mut encoder)?;
        self.encode_raw(&mut encoder)?;
        self.encode_ledger(&mut encoder)?;
        self.encode_latency(&mut encoder)?;
        self.encode_bench(&mut encoder)?;
        if let Some(cluster) = &self.0.cluster {
            cluster_metrics::encode(&cluster.view(), &mut encoder)?;
        }
        let uptime = ConstGauge::new(self.0.began.elapsed().as_secs_f64());
        let metric = encoder.encode_descriptor(
            "uptime_seconds",
            "Time since the daemon started",
            None,
            uptime.metric_type(),
        )?;
        uptime.encode(metric)
    }
}

impl Reader {
    fn encode_shots(&self, encoder: &mut DescriptorEncoder) -> Result<(), fmt::Error> {
        let counts = ShotCounts::of(&self.0);
        let help = "Shots by state";
        let mut family = encoder.encode_descriptor("shots", help, None, MetricType::Gauge)?;
        for (state, count) in [
            ("awaiting_frames", counts.awaiting_frames),
            ("queued", counts.queued),
            ("processing", counts.processing),
            ("done", counts.done),
            ("failed", counts.failed),
            ("write_failed", counts.write_failed),
            ("shed", counts.shed),
            ("not_fired", counts.not_fired),
            ("lost", counts.lost),
        ] {
            let labels = [("state", state)];
            let metric = family.encode_family(&labels)?;
            ConstGauge::new(count as i64).encode(metric)?;
        }
        Ok(())
    }

    /// Absent if the run has no synchroniser.
    fn encode_bench(&self, encoder: &mut DescriptorEncoder) -> Result<(), fmt::Error> {
        if self.0.control().is_none() {
            return Ok(());
        }
        let answers = ConstGauge::new(i64::from(!self.0.bench_is_lost()));
        let help = "1 while the synchroniser answers, 0 while it is lost";
        let metric =
            encoder.encode_descriptor("synchroniser_up", help, None, answers.metric_type())?;
        answers.encode(metric)
    }

    /// Latency from trigger to stored velocity.
    fn encode_latency(&self, encoder: &mut DescriptorEncoder) -> Result<(), fmt::Error> {
        let Some(latency) = self.0.board.latency() else { return Ok(()) };
        let help = "From trigger to stored velocity, over the last thousand shots";
        let mut family =
            encoder.encode_descriptor("latency_seconds", help, None, MetricType::Gauge)?;
        let quantiles = [("0.5", latency.p50_s), ("0.95", latency.p95_s), ("0.99", latency.p99_s)];
        for (quantile, seconds) in quantiles {
            let labels = [("quantile", quantile)];
            let metric = family.encode_family(&labels)?;
            ConstGauge::new(seconds).encode(metric)?;
        }
        Ok(())
    }

    /// Watermarks of the raw data.
    fn encode_raw(&self, encoder: &mut DescriptorEncoder) -> Result<(), fmt::Error> {
        let Some(marks) = self.0.watermarks() else { return Ok(()) };
        let help = "Shots whose data has reached this level";
        let mut family =
            encoder.encode_descriptor("watermark_shots", help, None, MetricType::Counter)?;
        for (level, count) in [
            ("acquired", marks.acquired),
            ("paired", marks.paired),
            ("written", marks.written),
            ("fsynced", marks.fsynced),
            ("processed", marks.processed),
        ] {
            let labels = [("level", level)];
            let metric = family.encode_family(&labels)?;
            ConstCounter::new(count).encode(metric)?;
        }
        let Some(log) = RawLogView::of(&self.0) else { return Ok(()) };
        let help = "Bytes of raw data, in memory and as stored";
        let mut family = encoder.encode_descriptor("raw_bytes", help, None, MetricType::Counter)?;
        for (form, count) in [("in", log.bytes_in), ("stored", log.bytes_written)] {
            let labels = [("form", form)];
            let metric = family.encode_family(&labels)?;
            ConstCounter::new(count).encode(metric)?;
        }
        Ok(())
    }

    fn encode_ledger(&self, encoder: &mut DescriptorEncoder) -> Result<(), fmt::Error> {
        let names = &self.0.info.configuration.cameras;
        let accounts = self.0.ledger.lock().accounts().to_vec();
        let help = "Triggers entered in the ledger";
        let mut family = encoder.encode_descriptor("triggers", help, None, MetricType::Counter)?;
        for (name, account) in names.iter().zip(&accounts) {
            let labels = [("camera", name.as_str())];
            let metric = family.encode_family(&labels)?;
            ConstCounter::new(account.triggers).encode(metric)?;
        }
        let help = "Triggers by outcome; together with the open ones they sum to the triggers";
        let mut family =
            encoder.encode_descriptor("trigger_outcomes", help, None, MetricType::Counter)?;
        for (name, account) in names.iter().zip(&accounts) {
            for outcome in Outcome::ALL {
                let labels = [("camera", name.as_str()), ("outcome", outcome.name())];
                let metric = family.encode_family(&labels)?;
                ConstCounter::new(account.outcomes.of(outcome)).encode(metric)?;
            }
        }
        self.encode_streams(encoder)?;
        let help = "Triggers not settled yet";
        let mut family =
            encoder.encode_descriptor("triggers_open", help, None, MetricType::Gauge)?;
        for (name, account) in names.iter().zip(&accounts) {
            let labels = [("camera", name.as_str())];
            let metric = family.encode_family(&labels)?;
            ConstGauge::new(account.open as i64).encode(metric)?;
        }
        Ok(())
    }

    /// Counters of the cameras' drivers.
    fn encode_streams(&self, encoder: &mut DescriptorEncoder) -> Result<(), fmt::Error> {
        type Counter = (&'static str, &'static str, fn(&StreamStatistics) -> u64);
        const COUNTERS: [Counter; 6] = [
            ("stream_frames_completed", "Frames received completely", |s| s.completed),
            ("stream_frames_failed", "Frames received damaged", |s| s.failed),
            ("stream_frames_underrun", "Frames lost because no buffer was free", |s| s.underruns),
            ("stream_packets_resent", "Packets received after a resend request", |s| s.resent),
            ("stream_packets_missing", "Packets never received", |s| s.missing),
            ("stream_reconnects", "Reconnections of the camera", |s| s.reconnects),
        ];
        let names = &self.0.info.configuration.cameras;
        let streams = self.0.ledger.lock().streams().to_vec();
        for (counter, help, count) in COUNTERS {
            let mut family = encoder.encode_descriptor(counter, help, None, MetricType::Counter)?;
            for (name, statistics) in names.iter().zip(&streams) {
                let labels = [("camera", name.as_str())];
                let metric = family.encode_family(&labels)?;
                ConstCounter::new(count(statistics)).encode(metric)?;
            }
        }
        Ok(())
    }
}
