//! `lfpiv validate` on a jet a third as large, in a small volume and with small sensors: planar PIV and both cameras
//! find the truth, one camera does not along its depth.

#![allow(clippy::unwrap_used, reason = "clippy takes the helpers of a test for more than tests")]
#[allow(dead_code)]
#[path = "../../tests/support/mod.rs"]
mod support;

use std::fs;

use lfpiv::config::Config;
use lfpiv_bench::validate::{Comparison, Difference, Instrument, Validation, write};
use lfpiv_sim::{PlanarScene, flow::RoundJet};
use serde_json::Value;

const SHOTS: u64 = 8;

/// The jet experiment in 4 × 3.2 × 4 mm.
fn small_config() -> Config {
    let text = [
        ("columns = 129", "columns = 55"),
        ("rows = 97", "rows = 47"),
        ("columns = 2352", "columns = 1004"),
        ("rows = 1768", "rows = 858"),
        ("voxels = [130, 100, 120]", "voxels = [40, 32, 40]"),
        ("window_mm = 1.6", "window_mm = 1.2"),
    ]
    .into_iter()
    .fold(support::shipped("jet"), |text, (old, new)| {
        assert_eq!(text.matches(old).count(), 1, "{old}");
        text.replace(old, new)
    });
    Config::parse("small jet", &text).unwrap()
}

fn small() -> Validation {
    let jet: RoundJet = toml::from_str(
        "diameter_mm = 6.0\noutlet_mm = [1.98, -9.88, 0.0]\nmomentum_thickness_mm = 0.13\n\
         wavelengths_mm = [2.5, 7.0]",
    )
    .unwrap();
    let mut planar = PlanarScene::default();
    planar.camera.pixels = [300, 260];
    planar.camera.pose.origin_mm = [0.0, 0.0, 0.0].into();
    Validation { jet, planar, first_window_px: 128, ..Validation::new(small_config(), 1) }
}

fn over_volume(instrument: &Instrument, component: &str) -> Difference {
    let all = instrument.volume.as_ref().unwrap();
    all.iter().find(|difference| difference.component == component).unwrap().clone()
}

/// The differences of the profile along x, and how many of its intervals hold the truth.
fn along_x(comparison: &Comparison, instrument: &Instrument) -> (Difference, [usize; 2]) {
    let (profile, range) = (instrument.profile("x").unwrap(), comparison.region.range_mm[0]);
    (profile.difference(range), profile.intervals_that_hold(range))
}

#[test]
fn both_cameras_and_planar_piv_find_the_jet_and_one_camera_not_along_its_depth() {
    let mut running = small().start().unwrap();
    (0..SHOTS).for_each(|_| running.next_shot().unwrap());
    let comparison = running.comparison();
    println!("{}", comparison.table());
    assert_eq!(comparison.shots, SHOTS);
    let [first, second, dual, planar] = &comparison.instruments[..] else { panic!() };

    let (difference, [held, all]) = along_x(&comparison, planar);
    assert!(all == 9 && held == all, "{held} of {all}");
    assert!(difference.mean_from_shots_m_s < 0.05, "{difference:?}");
    assert!(difference.rms_from_shots_m_s < 0.1, "{difference:?}");
    // Its windows are half as long as the shortest waves. Eight shots scatter, so the same shots' truth is the bar.
    let (difference, _) = along_x(&comparison, dual);
    assert!(difference.mean_from_shots_m_s < 0.2, "{difference:?}");

    // Along its depth, z for the first camera and x for the second, one camera errs more than both together. How much
    // the root mean square of eight shots errs by varies with the draw, so those of both cameras are added.
    let by_depth = [(first, "w"), (second, "u")]
        .map(|(single, depth)| [single, dual].map(|instrument| over_volume(instrument, depth)));
    for [one, both] in &by_depth {
        assert!(both.mean_from_shots_m_s < 0.15 && both.rms_from_shots_m_s < 0.3, "{both:?}");
        assert!(one.mean_from_shots_m_s > 3.0 * both.mean_from_shots_m_s, "{one:?} {both:?}");
    }
    let [one, both] =
        [0, 1].map(|n| by_depth.iter().map(|pair| pair[n].rms_from_shots_m_s).sum::<f64>());
    assert!(one > 3.0 * both, "{one} {both}");

    let folder = tempfile::tempdir().unwrap();
    write(&comparison, folder.path()).unwrap();
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    let json: Value = serde_json::from_str(&read("validation.json")).unwrap();
    assert_eq!(json["shots"], SHOTS);
    // Four profiles along x, three along z.
    assert_eq!(json["differences"].as_array().unwrap().len(), 7);
    let points: usize = comparison
        .instruments
        .iter()
        .flat_map(|instrument| &instrument.profiles)
        .map(|profile| profile.points.len())
        .sum();
    let csv = read("profiles.csv");
    assert_eq!(csv.lines().count(), points + 1);
    assert!(!csv.contains("NaN") && !csv.contains("inf"), "{csv}");
    let page = read("validation.html");
    for picture in ["fig22.svg", "fig23.svg", "fig24.svg", "rms.svg", "depth.svg"] {
        assert!(page.contains(picture), "{picture}");
        let svg = read(picture);
        assert!(svg.starts_with("<svg xmlns=") && !svg.contains("NaN"), "{picture}");
    }
}
