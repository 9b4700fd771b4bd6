//! Endpoints used by the bench page: its files, heartbeat, settings, timing and image statistics.

use std::{path::Path, sync::Arc, time::Duration};

use lfpiv::{
    acquisition::Ledger,
    config::ConfigFile,
    server::{BenchSettings, VolumeViews},
};
use lfpiv_core::{
    lightfield::ImagePair,
    model::{VolumeGrid, VolumeMask},
};
use lfpiv_hw::{Optics, RawImage};
use lfpiv_sim::Scene;
use tokio::{
    io::{AsyncReadExt, AsyncWriteExt},
    net::TcpStream,
};

use crate::{
    bench::configuration,
    client::Ask,
    previews::lit_board,
    server::{Server, settings},
};

fn bench() -> BenchSettings {
    let file = configuration(std::path::Path::new("unused"));
    BenchSettings {
        configuration: file.text,
        optics: file.config.optics,
        timing: file.config.timing,
        mask: None,
        views: VolumeViews::default(),
    }
}

async fn configured_server() -> Server {
    let mut ledger = Ledger::new(2);
    ledger.enter(7).unwrap();
    let board = lit_board([4, 3, 2]);
    let images = [image(&bench().optics, 300.0), image(&bench().optics, 150.0)];
    board.gallery().show_frames(7, &ImagePair { cameras: vec![images.clone(), images] });
    Server::with(ledger, board, &settings(), |state| state.with_bench(bench())).await
}

/// Round micro-images, every second one bright, on a black level of 64.
fn image(optics: &Optics, light: f64) -> RawImage {
    let (sensor, pitch) = (&optics.sensor, optics.micro_image_pitch_mm());
    let radius_mm = 0.42 * pitch;
    let count = |row: usize, column: usize| {
        let [x, y] = [sensor.column_centre_mm(column), sensor.row_centre_mm(row)];
        let [i, j] = [x, y].map(|place| (place / pitch).round());
        let is_lit = (x - i * pitch).hypot(y - j * pitch) < radius_mm;
        let share = if (i + j).rem_euclid(2.0) < 0.5 { 1.0 } else { 0.4 };
        64 + if is_lit { (share * light) as u16 } else { 0 }
    };
    let counts =
        (0..sensor.rows).flat_map(|row| (0..sensor.columns).map(move |column| (row, column)));
    let counts = counts.map(|(row, column)| count(row, column)).collect();
    RawImage::new(sensor.columns, sensor.rows, counts).unwrap()
}

#[tokio::test]
async fn the_page_is_at_the_root_and_runs_only_its_own_scripts() {
    let server = Server::empty(&settings()).await;
    let page = server.get("/").await;
    assert_eq!((page.status, page.media_type.as_str()), (200, "text/html; charset=utf-8"));
    let policy = page.header("content-security-policy").unwrap();
    for part in ["default-src 'none'", "script-src 'self'", "frame-ancestors 'none'"] {
        assert!(policy.split("; ").any(|own| own == part), "{policy}");
    }
    assert!(!policy.contains("unsafe"), "{policy}");
    let text = String::from_utf8(page.body).unwrap();
    for path in ["/bench/bench.js", "/bench/bench.css", "/bench/icon.svg"] {
        assert!(text.contains(&format!("\"{path}\"")), "{path}");
        assert_eq!(server.get(path).await.status, 200, "{path}");
    }
    assert!(!text.contains("<style") && !text.contains("style=") && !text.contains(" on"));
}

#[tokio::test]
async fn a_stream_sends_the_heartbeat_of_the_run() {
    let server = Server::empty(&settings()).await;
    let mut stream = TcpStream::connect(server.address).await.unwrap();
    stream.write_all(&Ask::get("/api/v1/events").bytes(server.address)).await.unwrap();
    let mut received = String::new();
    let beats = async {
        while received.matches(": heartbeat").count() < 3 {
            let mut piece = [0; 1024];
            let length = stream.read(&mut piece).await.unwrap();
            received += &String::from_utf8_lossy(&piece[..length]);
        }
    };
    tokio::time::timeout(Duration::from_secs(60), beats).await.expect("no heartbeat");
}

#[tokio::test]
async fn settings_and_timing_are_returned_and_nothing_is_changed() {
    let server = configured_server().await;
    let told = server.get("/api/v1/configuration").await.json();
    assert!(told["text"].as_str().unwrap().contains("[optics.microlens]"));
    let timing = server.get("/api/v1/control/timing").await.json();
    assert_eq!(timing["dt_us"], 100.0);
    let [q1, q2] = [0, 1].map(|n| timing["q_switch_us"][n].as_f64().unwrap());
    assert!((q2 - q1 - 100.0).abs() < 1e-9);
    let other = server.get("/api/v1/control/timing?dt_us=50").await.json();
    assert_eq!(other["dt_us"], 50.0);
    let refused = server.get("/api/v1/control/timing?dt_us=90000").await.error(409);
    assert!(refused.contains("exposure 2"), "{refused}");
    assert!(server.get("/api/v1/control/timing?dt_us=x").await.error(400).contains("dt_us"));
    let empty = Server::empty(&settings()).await;
    for path in ["/api/v1/configuration", "/api/v1/control/timing"] {
        assert!(empty.get(path).await.error(404).contains("no configuration of a bench"));
    }
}

/// Of simulated images, whose scene says how many particles there are.
#[tokio::test]
async fn the_seeding_of_an_image_is_returned() {
    let small = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/small.toml");
    let config = ConfigFile::load(&small).unwrap().config;
    for ppm in [0.3, 1.5] {
        let scene = Scene { ppm, ..config.simulation.clone().unwrap() };
        let shot = scene.shot(&config.bench_geometry(), 1, 7);
        let mut ledger = Ledger::new(2);
        ledger.enter(7).unwrap();
        let board = lit_board([4, 3, 2]);
        board.gallery().show_frames(7, &ImagePair { cameras: shot.images });
        let (optics, views) = (config.optics.clone(), VolumeViews::new(&config));
        let bench = BenchSettings { optics, views, ..bench() };
        let server =
            Server::with(ledger, board, &settings(), |state| state.with_bench(bench)).await;
        // The volume is 20 voxels high and 16 deep: from above there are as many particles in fewer microlenses.
        for (camera, ppm) in [(1, ppm), (2, 20.0 / 16.0 * ppm)] {
            let path = format!("/api/v1/shots/7/frames/{camera}/statistics");
            for frame in server.get(&path).await.json()["frames"].as_array().unwrap() {
                let found = frame["seeding_ppm"].as_f64().unwrap();
                assert!((found / ppm - 1.0).abs() < 0.3, "{found} instead of {ppm}");
            }
        }
    }
}

#[tokio::test]
async fn image_statistics_are_returned() {
    let server = configured_server().await;
    let told = server.get("/api/v1/shots/latest/frames/1/statistics").await.json();
    assert_eq!((&told["shot"], &told["camera"]), (&7.into(), &"cam1".into()));
    assert_eq!(told["configured"]["sensor_px"], serde_json::json!([92, 92]));
    let ratio = told["a_over_b"].as_f64().unwrap();
    assert!((ratio - 2.0).abs() < 0.1, "{ratio}");
    for frame in told["frames"].as_array().unwrap() {
        let pixels: u64 =
            frame["histogram"].as_array().unwrap().iter().filter_map(|n| n.as_u64()).sum();
        assert_eq!(pixels, 92 * 92);
        assert_eq!(frame["least_counts"], 64);
        let micro_image = &frame["micro_image"];
        let diameter = micro_image["diameter_pitches"].as_f64().unwrap();
        assert!((diameter - 0.84).abs() < 0.06, "{diameter}");
        assert!(micro_image["f_number"].as_f64().unwrap() > 4.2);
        assert!(micro_image["corner_share"].as_f64().unwrap() < 0.05);
        let cells = micro_image["cells"].as_u64().unwrap();
        assert_eq!(micro_image["light"].as_array().unwrap().len() as u64, cells * cells);
    }
    assert!(
        server.get("/api/v1/shots/6/frames/1/statistics").await.error(404).contains("no shot 6")
    );
    assert!(server.get("/api/v1/shots/7/frames/9/statistics").await.error(404).contains("cam9"));
}

#[tokio::test]
async fn the_mask_is_told_voxel_by_voxel() {
    let grid = VolumeGrid { voxels: [4, 3, 2], voxel_mm: 0.1, centre_mm: [0.0; 3] };
    let flow = (0..24).map(|n| n % 5 != 0).collect();
    let mask = Some(Arc::new(VolumeMask { grid, flow }));
    let masked = BenchSettings { mask, ..bench() };
    let (ledger, board) = (Ledger::new(2), lit_board([4, 3, 2]));
    let server = Server::with(ledger, board, &settings(), |state| state.with_bench(masked)).await;
    let told = server.get("/api/v1/mask").await;
    assert_eq!((told.status, told.body.len()), (200, 83));
    assert_eq!(&told.body[..8], b"LFPIVMK1");
    let bit = |n: usize| told.body[80 + n / 8] >> (n % 8) & 1 == 1;
    assert!((0..24).all(|n| bit(n) == (n % 5 != 0)));
    let all = configured_server().await;
    assert!(all.get("/api/v1/mask").await.error(404).contains("all of it is flow"));
}
