//! Results of a run, read over HTTP while it runs; no part is replaced.

use std::path::Path;

use lfpiv::{
    acquisition::{Bench, OverloadPolicy},
    archive::ShotResult,
    cli::daemon::{Daemon, DaemonPlan},
    config::ConfigFile,
    pipeline::ShotRecord,
};
use lfpiv_core::measurement::Processor;
use lfpiv_sim::{Pacing, connect};
use tokio_util::sync::CancellationToken;

use crate::{
    client::{Answer, get},
    events::Watch,
    server::settings,
};

fn small(results: &Path) -> ConfigFile {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/small.toml");
    let mut file = ConfigFile::load(&path).unwrap();
    file.config.output.dir = results.to_owned();
    file.config.server = settings();
    file
}

fn picture(answer: &Answer) -> image::GrayImage {
    assert_eq!((answer.status, answer.media_type.as_str()), (200, "image/png"), "{answer:?}");
    image::load_from_memory(&answer.body).unwrap().into_luma8()
}

#[tokio::test(flavor = "multi_thread")]
async fn the_light_of_a_shot_can_be_viewed_during_the_run() {
    let root = tempfile::tempdir().unwrap();
    let file = small(root.path());
    let (config, volume) = (file.config.clone(), file.config.volume.voxels);
    let scene = config.simulation.clone().unwrap();
    let seed = scene.seed;
    let simulated = connect(scene, config.bench_geometry(), seed, Pacing::AsFramesAreTaken);
    let bench = Bench::new(simulated.cameras, simulated.synchroniser);
    let plan = DaemonPlan::new(file, None, OverloadPolicy::Wait);
    let daemon = Daemon::prepare(plan).await.unwrap();
    let (address, stop) = (daemon.address(), CancellationToken::new());
    let measurement = config.measurement();
    let processor = move || {
        let processor = Processor::new(measurement)?;
        Ok(move |pair: &_| processor.process_with_light(pair))
    };
    let observer = Box::new(|_: &ShotRecord, _: Option<&ShotResult>| {});
    let run = tokio::spawn(daemon.run(bench, processor, observer, stop.clone()));

    let mut watch = Watch::open(address, None).await;
    let shot = loop {
        let event = watch.next().await.unwrap();
        if event.name == "result" {
            assert!(event.data["valid_share"].as_f64().unwrap() > 0.5, "{event:?}");
            break event.data["shot"].as_u64().unwrap();
        }
    };
    let result = format!("/api/v1/results/{shot}");
    for frame in ["a", "b"] {
        let bytes = get(address, &format!("{result}/volumes/{frame}")).await.body;
        let [nx, ny, nz] = volume;
        assert_eq!(bytes.len(), 80 + 4 * nx * ny * nz);
        let light = bytes[80..].chunks_exact(4).map(|b| f32::from_le_bytes(b.try_into().unwrap()));
        let light: Vec<f32> = light.collect();
        for (plane, [first, second]) in [("xy", [0, 1]), ("xz", [0, 2]), ("yz", [1, 2])] {
            let path = format!("{result}/projections/{frame}/{plane}.png");
            let shown = picture(&get(address, &path).await);
            assert_eq!(shown.dimensions(), (volume[first] as u32, volume[second] as u32));
            // Black where no voxel behind the pixel is lit, white at the brightest.
            let mut largest = vec![0.0f32; volume[first] * volume[second]];
            for (n, &voxel) in light.iter().enumerate() {
                let at = [n % nx, n / nx % ny, n / (nx * ny)];
                let pixel = &mut largest[at[second] * volume[first] + at[first]];
                *pixel = pixel.max(voxel);
            }
            let brightest = (0..largest.len()).max_by(|a, b| largest[*a].total_cmp(&largest[*b]));
            let brightest = brightest.unwrap();
            for (n, &voxel) in largest.iter().enumerate() {
                let (x, y) = (n % volume[first], volume[second] - 1 - n / volume[first]);
                let value = shown.get_pixel(x as u32, y as u32).0[0];
                assert!(voxel > 0.0 || value == 0, "{path} at {x}, {y}: {value}");
                assert!(n != brightest || value == 255, "{path} at {x}, {y}: {value}");
            }
        }
    }
    // The raw frames are those of the shot that a worker took last.
    let frame = get(address, "/api/v1/shots/latest/frames/2/b.png?width=64").await;
    let frame = picture(&frame);
    assert!(frame.width() == 64 && frame.as_raw().contains(&255));
    stop.cancel();
    run.await.unwrap().unwrap();
}
