//! Every endpoint through a real socket.

use lfpiv::{
    acquisition::{Ledger, Outcome},
    archive::{ShotResult, ShotTime},
    pipeline::{Board, RESULTS_IN_MEMORY},
    server::Phase,
};
use lfpiv_core::{lightfield::ImagePair, velocimetry::MeasuredParticle};
use serde_json::Value;

use crate::{bench::quick_result, client::Ask, server::Server};

/// Two particles, of which the second disagrees with those about it.
fn particles() -> Vec<MeasuredParticle> {
    let first = MeasuredParticle {
        at_mm: [0.5, -0.25, 1.5],
        place_uncertainty_vox: [0.5, 0.25, 2.0],
        displacement_vox: [1.0, -2.0, 0.5],
        uncertainty_vox: [0.25, 0.5, 0.125],
        light: [400.0, 300.0],
        agrees: true,
    };
    vec![first, MeasuredParticle { at_mm: [1.0, 2.0, 3.0], agrees: false, ..first }]
}

/// A server with more finished shots than fit in memory, the last with particles, then one shot each that is
/// failed, shed, lost, processing, queued, and waiting for frames.
pub async fn busy_server() -> (Server, u64) {
    let (mut ledger, board) = (Ledger::new(2), Board::new());
    let done = RESULTS_IN_MEMORY as u64 + 2;
    let pair = ImagePair { cameras: Vec::new() };
    for shot in 0..done + 6 {
        ledger.enter(shot).unwrap();
    }
    for shot in 0..done {
        ledger.mark_queued(shot, &[]);
        board.processing(shot);
        let mut result = quick_result(&pair);
        result.particles = (shot + 1 == done).then(particles);
        board.done(shot, ShotResult::from(result).into());
        ledger.settle_all(shot, Outcome::Complete).unwrap();
    }
    board.failed(done, "camera 2 is dark".to_owned());
    ledger.settle_all(done, Outcome::Complete).unwrap();
    ledger.settle_all(done + 1, Outcome::Shed).unwrap();
    ledger.settle(done + 2, 0, Outcome::Unpaired).unwrap();
    ledger.settle(done + 2, 1, Outcome::MissingPackets).unwrap();
    ledger.mark_queued(done + 3, &["camera 1: frame b came late".to_owned()]);
    board.processing(done + 3);
    ledger.mark_queued(done + 4, &[]);
    let utc_ns = 1_700_000_000_250_000_000;
    let time = ShotTime { utc_ns, uncertainty_ns: 1_500_000, clock_synchronised: true };
    ledger.set_time(done + 4, Some(time));
    (Server::start(ledger, board).await, done)
}

#[tokio::test]
async fn status_counts_every_shot_once() {
    let (server, done) = busy_server().await;
    let status = server.get("/api/v1/status").await.json();
    assert_eq!(status["state"], "running");
    assert_eq!(status["stage"], format!("processing shot {}", done + 3));
    assert_eq!(status["configuration"]["dt_us"], 100.0);
    assert!(status["uptime_s"].as_f64().unwrap() >= 0.0);
    let shots = &status["shots"];
    assert_eq!(shots["triggered"], done + 6);
    assert_eq!(shots["done"], done);
    for state in ["failed", "shed", "lost", "processing", "queued", "awaiting_frames"] {
        assert_eq!(shots[state], 1, "{state}: {shots}");
    }
    assert_eq!(status["model_choice"]["mode"], "explicit");
    assert_eq!(status["model_choice"]["scene"], Value::Null);
    assert_eq!(status["ledger"]["balanced"], true);
    let second = &status["ledger"]["cameras"][1];
    assert_eq!((&second["camera"], &second["open"]), (&"cam2".into(), &3.into()));
    assert_eq!(second["outcomes"]["missing_packets"], 1);
}

#[tokio::test]
async fn shots_are_listed_newest_first_and_found_by_number() {
    let (server, done) = busy_server().await;
    let list = server.get("/api/v1/shots?limit=7").await.json();
    let shots = list["shots"].as_array().unwrap();
    let states: Vec<&str> = shots.iter().map(|shot| shot["state"].as_str().unwrap()).collect();
    let expected = ["awaiting_frames", "queued", "processing", "lost", "shed", "failed", "done"];
    assert_eq!(states, expected);

    let shot = server.get(&format!("/api/v1/shots/{}", done - 1)).await.json();
    assert_eq!((&shot["vectors"], &shot["valid_share"]), (&2.into(), &0.5.into()));
    assert_eq!(shot["seconds"]["reconstruct_s"], 0.2);
    assert_eq!(shot["cameras"][0]["outcome"], "complete");
    let failed = server.get(&format!("/api/v1/shots/{done}")).await.json();
    assert_eq!(failed["message"], "camera 2 is dark");
    let suspect = server.get(&format!("/api/v1/shots/{}", done + 3)).await.json();
    assert_eq!(suspect["suspect"][0], "camera 1: frame b came late");
    assert_eq!(suspect["time"], Value::Null);
    let timed = server.get(&format!("/api/v1/shots/{}", done + 4)).await.json();
    let time = serde_json::json!({
        "utc": "2023-11-14T22:13:20.25Z", "uncertainty_s": 0.0015, "clock_synchronised": true
    });
    assert_eq!(timed["time"], time);
}

#[tokio::test]
async fn a_result_is_json_or_bytes() {
    let (server, done) = busy_server().await;
    let latest = server.get("/api/v1/results/latest").await.json();
    let last = done - 1;
    assert_eq!(latest["shot"], last);
    assert_eq!(latest["grid"]["vectors_xyz"], serde_json::json!([2, 1, 1]));
    // One voxel of 0.1 mm in 100 us is 1 m/s.
    assert_eq!(latest["velocity_m_s"][0], serde_json::json!([1.0, -2.0, 0.5]));
    assert_eq!(latest["uncertainty_vox"][0], serde_json::json!([0.25, 0.5, 0.125]));
    assert_eq!(latest["status"], serde_json::json!(["valid", "invalid"]));
    assert_eq!(latest["divergence_per_s"], serde_json::json!([200.0, null]));
    let none = serde_json::json!([null, null, null]);
    for name in ["velocity_m_s", "displacement_vox", "uncertainty_vox", "vorticity_per_s"] {
        assert_eq!(latest[name][1], none, "{name} of an invalid vector");
    }

    let path = format!("/api/v1/results/{last}");
    let by_query = server.get(&format!("{path}?format=binary")).await;
    let by_header = Ask::get(&path).with("Accept", "application/octet-stream");
    let by_header = by_header.of(server.address).await;
    assert_eq!(by_query.media_type, "application/octet-stream");
    assert_eq!(by_query.body, by_header.body);
    check_layout(&by_query.body, last);
    assert_eq!(server.get(&path).await.json(), latest);
}

#[tokio::test]
async fn particles_are_json_or_bytes() {
    let (server, done) = busy_server().await;
    let latest = server.get("/api/v1/results/latest/particles").await.json();
    let last = done - 1;
    assert_eq!((&latest["shot"], &latest["dt_s"]), (&last.into(), &1e-4.into()));
    let places = serde_json::json!([[0.5, -0.25, 1.5], [1.0, 2.0, 3.0]]);
    assert_eq!(latest["place_mm"], places);
    // One voxel of 0.1 mm in 100 us is 1 m/s.
    let near = |name: &str, expected: [f64; 3]| {
        for (axis, expected) in expected.into_iter().enumerate() {
            let found = latest[name][1][axis].as_f64().unwrap();
            assert!((found - expected).abs() < 1e-9, "{name}: {found}");
        }
    };
    near("velocity_m_s", [1.0, -2.0, 0.5]);
    near("velocity_uncertainty_m_s", [0.25, 0.5, 0.125]);
    near("place_uncertainty_mm", [0.05, 0.025, 0.2]);
    assert_eq!(latest["light"], serde_json::json!([[400.0, 300.0], [400.0, 300.0]]));
    assert_eq!(latest["valid"], serde_json::json!([true, false]));

    let path = format!("/api/v1/results/{last}/particles");
    let by_query = server.get(&format!("{path}?format=binary")).await;
    let by_header = Ask::get(&path).with("Accept", "application/octet-stream");
    let by_header = by_header.of(server.address).await;
    assert_eq!(by_query.media_type, "application/octet-stream");
    assert_eq!(by_query.body, by_header.body);
    check_particles(&by_query.body, last);
    let tag = by_query.header("etag").unwrap().to_owned();
    let again = Ask::get(&format!("{path}?format=binary")).with("If-None-Match", &tag);
    assert_eq!(again.of(server.address).await.status, 304);

    let none = format!("/api/v1/results/{}/particles", last - 1);
    let none = server.get(&none).await;
    assert_eq!((none.status, none.body.len()), (204, 0));
    server.assert_error(&format!("/api/v1/results/{done}/particles"), 404, "is dark").await;
    let gone = server.assert_error("/api/v1/results/0/particles", 410, "read it from disk").await;
    assert_eq!(gone["particle_files"], "/data/run-1/particles_*.nc");
}

/// Checks the bytes at the documented offsets.
fn check_particles(bytes: &[u8], shot: u64) {
    let u32_at = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    let f32_at = |at: usize| f32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    let f64_at = |at: usize| f64::from_le_bytes(bytes[at..at + 8].try_into().unwrap());
    assert_eq!(&bytes[..8], b"LFPIVPA1");
    assert_eq!(u64::from_le_bytes(bytes[8..16].try_into().unwrap()), shot);
    assert_eq!([16, 20, 24, 28].map(u32_at), [2, 2, 0, 80]);
    assert_eq!([32, 40].map(f64_at), [0.1, 1e-4]);
    assert_eq!([80, 84, 88, 92].map(f32_at), [0.5, -0.25, 1.5, 1.0]);
    assert_eq!([104, 108, 112].map(f32_at), [1.0, -2.0, 0.5]);
    assert_eq!([128, 132, 136].map(f32_at), [0.25, 0.5, 0.125]);
    assert_eq!([152, 156].map(f32_at), [400.0, 300.0]);
    assert_eq!(bytes[168..172], [1, 0, 0, 0]);
    assert_eq!([172, 176, 180].map(f32_at), [0.5, 0.25, 2.0]);
    assert_eq!(bytes.len(), 172 + 2 * 12);
}

#[tokio::test]
async fn statistics_include_the_shots_so_far() {
    let (server, done) = busy_server().await;
    let brief = server.get("/api/v1/statistics").await.json();
    assert_eq!((&brief["shots"], &brief["maps"]), (&done.into(), &serde_json::json!([])));
    // The second vector is invalid in every shot.
    assert_eq!(brief["samples"], serde_json::json!([done, 0]));
    let path = "/api/v1/statistics?quantities=v_mean,uv";
    let statistics = server.get(path).await.json();
    let [mean, stress] = [0, 1].map(|map| statistics["maps"][map].clone());
    assert_eq!((&mean["quantity"], &mean["unit"]), (&"v_mean".into(), &"m/s".into()));
    assert_eq!(mean["value"], serde_json::json!([-2.0, null]));
    let per_shot = mean["measurement_uncertainty"][0].as_f64().unwrap() * (done as f64).sqrt();
    assert!((per_shot - 0.5).abs() < 1e-4, "{per_shot}");
    assert_eq!((&stress["unit"], &stress["value"][0]), (&"m2/s2".into(), &0.0.into()));
    assert_eq!(statistics["convergence"].as_array().unwrap().last().unwrap()["shots"], done);
    let refused = server.get("/api/v1/statistics?quantities=u_mean,warp").await;
    assert!(refused.error(400).contains("'warp' is not a quantity"));
}

/// Checks the bytes at the documented offsets.
fn check_layout(bytes: &[u8], shot: u64) {
    let u32_at = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    let f32_at = |at: usize| f32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    let f64_at = |at: usize| f64::from_le_bytes(bytes[at..at + 8].try_into().unwrap());
    assert_eq!(&bytes[..8], b"LFPIVVF2");
    assert_eq!(u64::from_le_bytes(bytes[8..16].try_into().unwrap()), shot);
    assert_eq!([16, 20, 24, 28].map(u32_at), [2, 1, 1, 80]);
    assert_eq!([32, 40, 48, 56, 64, 72].map(f64_at), [0.1, 0.2, 0.3, 0.8, 0.1, 1e-4]);
    assert_eq!([80, 84, 88].map(f32_at), [1.0, -2.0, 0.5]);
    assert_eq!([104, 108].map(f32_at), [2.5, 0.0]);
    assert_eq!(bytes[112..116], [0, 2, 0, 0]);
    assert_eq!([116, 120, 124].map(f32_at), [0.25, 0.5, 0.125]);
    // The second vector is invalid.
    assert!([92, 96, 100, 128, 132, 136].map(f32_at).iter().all(|value| value.is_nan()));
    assert_eq!(bytes.len(), 116 + 6 * 4);
}

#[tokio::test]
async fn missing_resources_are_reported_with_the_reason() {
    let (server, done) = busy_server().await;
    let gone = server.assert_error("/api/v1/results/0", 410, "read it from disk").await;
    assert_eq!(gone["results_dir"], "/data/run-1");
    assert_eq!(gone["paraview_file"], "/data/run-1/shot_000000.vti");
    let result = |shot: u64| format!("/api/v1/results/{shot}");
    server.assert_error(&result(done), 404, "camera 2 is dark").await;
    server.assert_error(&result(done + 1), 404, "shed").await;
    server.assert_error(&result(done + 2), 404, "lost").await;
    server.assert_error(&result(done + 3), 404, "being processed").await;
    server.assert_error(&result(done + 4), 404, "is waiting for a worker").await;
    server.assert_error(&result(done + 5), 404, "frames").await;
    server.assert_error(&result(999), 404, "no shot 999").await;
    server.assert_error("/api/v1/shots/999", 404, "no shot 999").await;
    server.assert_error("/api/v1/nothing", 404, "no such endpoint").await;
}

#[tokio::test]
async fn an_invalid_number_is_a_bad_request() {
    let (server, _) = busy_server().await;
    server.assert_error("/api/v1/shots/first", 400, "'first' is not a shot number").await;
    server.assert_error("/api/v1/results/-1", 400, "'-1' is not a shot number").await;
    server.assert_error("/api/v1/results/1.5", 400, "not a shot number").await;
    server.assert_error("/api/v1/shots?limit=many", 400, "limit").await;
    server.assert_error("/api/v1/shots?limit=5000", 400, "0 to 1000").await;
    server.assert_error("/api/v1/results/latest?format=xml", 400, "`binary`").await;
}

#[tokio::test]
async fn without_results_latest_is_not_found() {
    let server = Server::start(Ledger::new(2), Board::new()).await;
    server.assert_error("/api/v1/results/latest", 404, "no shot has a result yet").await;
    let status = server.get("/api/v1/status").await.json();
    assert_eq!(status["stage"], "waiting for shots");
}

#[tokio::test]
async fn metrics_and_health_follow_the_run() {
    let (server, done) = busy_server().await;
    let metrics = server.get("/metrics").await;
    assert!(metrics.media_type.starts_with("application/openmetrics-text"));
    let text = String::from_utf8(metrics.body).unwrap();
    for line in [
        format!("lfpiv_shots{{state=\"done\"}} {done}"),
        "lfpiv_shots{state=\"queued\"} 1".to_owned(),
        format!("lfpiv_triggers_total{{camera=\"cam1\"}} {}", done + 6),
        "lfpiv_trigger_outcomes_total{camera=\"cam2\",outcome=\"missing_packets\"} 1".to_owned(),
        "lfpiv_triggers_open{camera=\"cam2\"} 3".to_owned(),
        "# EOF".to_owned(),
    ] {
        assert!(text.lines().any(|found| found == line), "{line} in\n{text}");
    }
    let health = server.get("/healthz").await;
    assert_eq!((health.status, health.body.as_slice()), (200, b"ok\n".as_slice()));
    server.state.set_phase(Phase::Failed("cam1: connection lost".to_owned()));
    let health = server.get("/healthz").await;
    assert_eq!(health.status, 503);
    assert_eq!(server.get("/api/v1/status").await.json()["error"], "cam1: connection lost");
}

#[tokio::test]
async fn the_server_ends_when_cancelled() {
    let server = Server::start(Ledger::new(1), Board::new()).await;
    assert_eq!(server.get("/healthz").await.status, 200);
    server.stop.cancel();
    server.task.await.unwrap();
    assert!(std::net::TcpStream::connect(server.address).is_err());
}
