//! The camera driver against fake GigE Vision cameras, over real GVCP and GVSP on the loopback.
#![cfg(feature = "aravis")]
#![allow(clippy::unwrap_used)]

#[path = "gige/bench.rs"]
mod bench;
#[path = "gige/network.rs"]
mod network;

use bench::*;
use lfpiv_hw::{device::FrameStatus, gige::PixelFormat};
use lfpiv_sim::wire::camera::Exposed;
use network::in_private_network;

#[test]
fn every_pixel_format_arrives_as_it_was_sent() {
    in_private_network("every_pixel_format_arrives_as_it_was_sent", || {
        let fake = fake(FIRST, "LF1", SIZE);
        for format in PixelFormat::ALL {
            let t = std::time::Instant::now();
            let mut camera = connect(&settings(FIRST, format), SIZE);
            eprintln!("open {:?}", t.elapsed());
            let t = std::time::Instant::now();
            camera.start().unwrap();
            eprintln!("start {:?}", t.elapsed());
            let t = std::time::Instant::now();
            for number in 0..3 {
                let image = picture(SIZE, number);
                let timestamp_ns = 1_000_000_007 * (number + 1);
                assert_eq!(fake.expose(image.clone(), timestamp_ns).unwrap(), Exposed::Yes);
                let frame = frame(camera.as_mut());
                assert_eq!(frame.status, FrameStatus::Complete, "{format:?}");
                assert_eq!(frame.image.counts(), as_sent(&image, format), "{format:?}");
                assert_eq!(frame.frame_id, number);
                assert_eq!(frame.device_timestamp_ns, timestamp_ns);
            }
            eprintln!("frames {:?}", t.elapsed());
            camera.stop().unwrap();
            let t = std::time::Instant::now();
            drop(camera);
            eprintln!("drop {:?}", t.elapsed());
        }
        assert_eq!(fake.counts().sent, 15);
        assert_eq!(fake.counts().dark, 0);
    });
}
