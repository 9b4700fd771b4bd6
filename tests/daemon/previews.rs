//! Volumes, projections, raw frames, and caching of responses that never change.

use lfpiv::{acquisition::Ledger, archive::ShotResult, pipeline::Board};
use lfpiv_core::{
    lightfield::ImagePair,
    model::VolumeGrid,
    reconstruction::{FrameLight, SparseVolume},
};
use lfpiv_hw::RawImage;

use crate::{
    bench::quick_result,
    client::{Answer, Ask},
    http::busy_server,
    server::Server,
};

/// A board with the result of shot 7, its frames, and a volume with three lit voxels.
pub fn lit_board(voxels: [usize; 3]) -> Board {
    let grid = VolumeGrid { voxels, voxel_mm: 0.1, centre_mm: [1.0, 0.0, 0.0] };
    let light = |scale: f32| {
        let [nx, ny, nz] = voxels;
        let lit = [[0, 0, 0], [nx - 1, 0, 0], [0, ny - 1, nz - 1]].map(|at| grid.linear(at) as u32);
        let mut volume = SparseVolume {
            grid: grid.clone(),
            voxels: lit.to_vec(),
            intensity: vec![scale, 2.0 * scale, 4.0 * scale],
        };
        volume.voxels.sort_unstable();
        FrameLight::new(&volume, &grid)
    };
    let image = |brightness: usize| {
        let counts = (0..40 * 20).map(|n| (n / 40 * brightness) as u16).collect();
        RawImage::new(40, 20, counts).unwrap()
    };
    let pair = ImagePair { cameras: vec![[image(1), image(2)], [image(3), image(4)]] };
    let board = Board::new();
    board.processing(7);
    board.gallery().show_frames(7, &pair);
    board.gallery().show_light(7, [light(1.0), light(10.0)]);
    board.done(7, ShotResult::from(quick_result(&pair)).into());
    board
}

async fn lit_server() -> Server {
    let mut ledger = Ledger::new(2);
    ledger.enter(7).unwrap();
    ledger.enter(8).unwrap();
    ledger.mark_queued(7, &[]);
    Server::start(ledger, lit_board([4, 3, 2])).await
}

fn pixels(answer: &Answer) -> image::GrayImage {
    assert_eq!((answer.status, answer.media_type.as_str()), (200, "image/png"), "{answer:?}");
    image::load_from_memory(&answer.body).unwrap().into_luma8()
}

#[tokio::test]
async fn a_volume_has_the_documented_layout() {
    let server = lit_server().await;
    let answer = server.get("/api/v1/results/7/volumes/b").await;
    assert_eq!((answer.status, answer.media_type.as_str()), (200, "application/octet-stream"));
    let bytes = answer.body;
    let u32_at = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap());
    let f64_at = |at: usize| f64::from_le_bytes(bytes[at..at + 8].try_into().unwrap());
    assert_eq!(&bytes[..8], b"LFPIVVO1");
    assert_eq!(u64::from_le_bytes(bytes[8..16].try_into().unwrap()), 7);
    assert_eq!([16, 20, 24, 28, 64].map(u32_at), [4, 3, 2, 80, 1]);
    for (at, expected) in [(32, 0.85), (40, -0.1), (48, -0.05), (56, 0.1)] {
        assert!((f64_at(at) - expected).abs() < 1e-12, "{at}: {}", f64_at(at));
    }
    let voxels =
        bytes[80..].chunks_exact(4).map(|four| f32::from_le_bytes(four.try_into().unwrap()));
    let voxels: Vec<f32> = voxels.collect();
    let mut expected = vec![0.0; 24];
    (expected[0], expected[3], expected[12 + 8]) = (10.0, 20.0, 40.0);
    assert_eq!(voxels, expected);
    let latest = server.get("/api/v1/results/latest/volumes/b").await;
    assert_eq!(latest.body, bytes);
}

#[tokio::test]
async fn projections_show_the_brightest_voxel_with_the_second_axis_upwards() {
    let server = lit_server().await;
    let projection = |name: &str| format!("/api/v1/results/7/projections/a/{name}.png");
    let answer = server.get(&projection("xy")).await;
    assert_eq!(answer.header("lfpiv-white"), Some("4"));
    let xy = pixels(&answer);
    assert_eq!(xy.dimensions(), (4, 3));
    let lit = |image: &image::GrayImage| {
        let lit = image.enumerate_pixels().filter(|(.., pixel)| pixel.0[0] > 0);
        lit.map(|(x, y, pixel)| (x, y, pixel.0[0])).collect::<Vec<_>>()
    };
    assert_eq!(lit(&xy), [(0, 0, 255), (0, 2, 64), (3, 2, 128)]);
    let xz = pixels(&server.get(&projection("xz")).await);
    assert_eq!((xz.dimensions(), lit(&xz)), ((4, 2), vec![(0, 0, 255), (0, 1, 64), (3, 1, 128)]));
    let yz = pixels(&server.get(&projection("yz")).await);
    assert_eq!((yz.dimensions(), lit(&yz)), ((3, 2), vec![(2, 0, 255), (0, 1, 128)]));
}

#[tokio::test]
async fn raw_frames_are_returned_at_the_requested_width() {
    let server = lit_server().await;
    let frame = |camera: u32, name: &str| format!("/api/v1/shots/7/frames/{camera}/{name}.png");
    let whole = server.get(&frame(2, "b")).await;
    assert_eq!(whole.header("lfpiv-white"), Some("76"));
    let whole = pixels(&whole);
    assert_eq!(whole.dimensions(), (40, 20));
    assert_eq!((whole.get_pixel(0, 0).0[0], whole.get_pixel(39, 19).0[0]), (0, 255));
    let half = pixels(&server.get(&format!("{}?width=20", frame(1, "a"))).await);
    assert_eq!(half.dimensions(), (20, 10));
    let latest = server.get("/api/v1/shots/latest/frames/2/b.png").await;
    assert_eq!(pixels(&latest), whole);
    server.assert_error(&format!("{}?width=3", frame(1, "a")), 400, "allowed 16 to 8192").await;
    server.assert_error(&format!("{}?width=x", frame(1, "a")), 400, "width").await;
    server.assert_error(&format!("{}?depth=3", frame(1, "a")), 400, "depth").await;
    server.assert_error(&frame(3, "a"), 404, "no cam3; the cameras are cam1 to cam2").await;
    server.assert_error(&frame(0, "a"), 400, "'0' is not a camera").await;
    server.assert_error(&frame(1, "c"), 400, "give a or b").await;
    server.assert_error("/api/v1/shots/8/frames/1/a.png", 410, "not available").await;
    server.assert_error("/api/v1/shots/9/frames/1/a.png", 404, "no shot 9").await;
}

#[tokio::test]
async fn light_that_is_no_longer_in_memory_is_reported_as_gone() {
    let (server, done) = busy_server().await;
    let volume = |shot: u64| format!("/api/v1/results/{shot}/volumes/a");
    server.assert_error(&volume(done - 1), 410, "64 MB").await;
    server.assert_error("/api/v1/results/0/projections/a/xy.png", 410, "32 MB").await;
    server.assert_error(&volume(done), 404, "camera 2 is dark").await;
    server.assert_error(&volume(999), 404, "no shot 999").await;
    server.assert_error("/api/v1/results/1/volumes/c", 400, "give a or b").await;
    server.assert_error("/api/v1/results/1/projections/a/zz.png", 400, "not a plane").await;
}

#[tokio::test]
async fn a_cached_response_is_not_sent_again() {
    let server = lit_server().await;
    let mut tags = Vec::new();
    for path in [
        "/api/v1/results/7",
        "/api/v1/results/7?format=binary",
        "/api/v1/results/7/volumes/a",
        "/api/v1/results/7/volumes/b",
        "/api/v1/results/7/projections/a/xy.png",
        "/api/v1/shots/7/frames/1/a.png",
        "/api/v1/shots/7/frames/1/a.png?width=20",
    ] {
        let first = server.get(path).await;
        assert_eq!(first.status, 200, "{first:?}");
        let tag = first.header("etag").unwrap().to_owned();
        assert!(tag.starts_with('"'), "a strong tag: {tag}");
        assert_eq!(first.header("cache-control"), Some("private, no-cache"));
        let again = Ask::get(path).with("If-None-Match", &tag).of(server.address).await;
        assert_eq!((again.status, again.body.len()), (304, 0), "{path}");
        assert_eq!(again.header("etag"), Some(tag.as_str()));
        let other = Ask::get(path).with("If-None-Match", "\"other\"").of(server.address).await;
        assert_eq!((other.status, &other.body), (200, &first.body), "{path}");
        tags.push(tag);
    }
    let all = tags.len();
    tags.sort();
    tags.dedup();
    assert_eq!(tags.len(), all, "every answer has its own tag");
    let (earlier, later) = (lit_server().await, lit_server().await);
    let of = |answer: Answer| answer.header("etag").unwrap().to_owned();
    let path = "/api/v1/results/7";
    assert_ne!(of(earlier.get(path).await), of(later.get(path).await), "runs are told apart");
}

#[tokio::test]
async fn a_part_of_a_large_response_can_be_fetched() {
    let server = lit_server().await;
    let path = "/api/v1/results/7/volumes/a";
    let whole = server.get(path).await;
    assert_eq!(whole.header("accept-ranges"), Some("bytes"));
    let part = |range: &str| Ask::get(path).with("Range", range);
    let answer = part("bytes=80-87").of(server.address).await;
    assert_eq!((answer.status, &answer.body[..]), (206, &whole.body[80..88]));
    assert_eq!(answer.header("content-range"), Some("bytes 80-87/176"));
    assert_eq!(answer.header("content-length"), Some("8"));
    let tail = part("bytes=-4").of(server.address).await;
    assert_eq!((tail.status, &tail.body[..]), (206, &whole.body[172..]));
    let outside = part("bytes=176-").of(server.address).await;
    assert!(outside.error(416).contains("176 bytes"));
    assert_eq!(outside.header("content-range"), Some("bytes */176"));
    let tag = whole.header("etag").unwrap();
    let same = part("bytes=0-7").with("If-Range", tag).of(server.address).await;
    assert_eq!((same.status, &same.body[..]), (206, b"LFPIVVO1".as_slice()));
    let changed = part("bytes=0-7").with("If-Range", "\"old\"").of(server.address).await;
    assert_eq!((changed.status, changed.body.len()), (200, 176));
    let head = Ask::new("HEAD", path).of(server.address).await;
    assert_eq!(
        (head.status, head.header("content-length"), head.body.len()),
        (200, Some("176"), 0)
    );
}
