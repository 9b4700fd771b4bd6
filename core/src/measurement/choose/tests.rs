//! Decisions at both sides of each threshold.

use super::*;
use crate::model::Switch;

/// A scene that needs nothing but fine voxels: the bench at 1 ppm, everything else negligible.
fn easy() -> SceneMeasure {
    SceneMeasure {
        seeding_ppm: 1.0,
        particles_per_mm3: 12.5,
        window_vox: 16.0,
        particles_per_window: 51.2,
        particle_counts: 300.0,
        noise_per_particle: 1e-4,
        saturated_share: 0.0,
        depth_mm: [-4.0, 4.0],
        pitch_vox: 0.25,
        parallax_vox: 3.0,
        pupil_blur_vox: 1e-4,
        diffraction_vox: Some(1e-4),
        partly_open_light: 1e-4,
        partly_open_views: 0.1,
    }
}

fn auto() -> ModelSettings {
    ModelSettings { mode: ModelMode::Auto, wavelength_nm: Some(532.0), ..ModelSettings::default() }
}

fn chosen(scene: &SceneMeasure, settings: &ModelSettings) -> ModelChoice {
    choose(scene, &Allowed { settings, finest: 4 })
}

fn is_on(choice: &ModelChoice, part: Part) -> bool {
    choice.parts.iter().any(|p| p.part == part && p.on)
}

/// The error that a part may add, in voxels.
fn budget() -> f64 {
    SHARE_OF_CORRELATION * correlation_error_vox(16.0, easy().particles_per_window)
}

/// The value at which a part's error equals the whole budget.
fn threshold(part: Part, set: impl Fn(&mut SceneMeasure, f64)) -> f64 {
    let (mut low, mut high) = (0.0, 0.999);
    for _ in 0..60 {
        let middle = (low + high) / 2.0;
        let mut scene = easy();
        set(&mut scene, middle);
        let reached = errors_without(&scene, 4, 4).of(part) > budget();
        (low, high) = if reached { (low, middle) } else { (middle, high) };
    }
    low
}

#[test]
fn a_part_is_taken_just_above_its_threshold_and_not_just_below() {
    type Set = fn(&mut SceneMeasure, f64);
    let parts: [(Part, Set); 3] = [
        (Part::PupilBlur, |scene, width| scene.pupil_blur_vox = width),
        (Part::Diffraction, |scene, width| scene.diffraction_vox = Some(width)),
        (Part::ApertureCoverage, |scene, light| scene.partly_open_light = light),
    ];
    for (part, set) in parts {
        let threshold = threshold(part, set);
        assert!(threshold > 0.02 && threshold < 0.95, "{part}: {threshold}");
        for (times, expected) in [(0.99, false), (1.01, true)] {
            let mut scene = easy();
            set(&mut scene, threshold * times);
            let choice = chosen(&scene, &auto());
            assert_eq!(is_on(&choice, part), expected, "{part} at {times}: {choice:?}");
            assert!(choice.model_error_vox.unwrap() <= budget());
        }
    }
}

#[test]
fn what_costs_nothing_is_taken_whatever_it_buys() {
    let choice = chosen(&SceneMeasure { noise_per_particle: 0.0, ..easy() }, &auto());
    let noise = choice.parts.iter().find(|p| p.part == Part::NoiseWeighting).unwrap();
    assert!(!noise.on || noise.cost == Some(1.0));
    let noisy = chosen(&SceneMeasure { noise_per_particle: 0.05, ..easy() }, &auto());
    assert!(is_on(&noisy, Part::NoiseWeighting));
}

#[test]
fn voxels_are_as_fine_as_the_window_can_tell() {
    // Without seeding noise the correlation's error grows with the window alone.
    let at = |window_vox: f64| {
        chosen(&SceneMeasure { window_vox, particles_per_window: 1e6, ..easy() }, &auto())
    };
    let coarse_vox = errors_without(&easy(), 1, 4).of(Part::FineVoxels);
    let needed =
        |window: &f64| SHARE_OF_CORRELATION * correlation_error_vox(*window, 1e6) < coarse_vox;
    let last = (16..200).map(f64::from).take_while(needed).last().unwrap();
    assert!((17.0..199.0).contains(&last), "{last}");
    assert_eq!((at(last).refinement, at(last + 1.0).refinement), (4, 1));
}

#[test]
fn what_no_clock_could_tell_is_not_worth_an_error() {
    // On a grid of large voxels a narrow blur adds no microlenses.
    let scene = SceneMeasure { pupil_blur_vox: 0.05, pitch_vox: 1.0, ..easy() };
    assert!(errors_without(&scene, 4, 4).of(Part::PupilBlur) < budget());
    let choice = chosen(&scene, &auto());
    assert!(is_on(&choice, Part::PupilBlur), "{choice:?}");
}

#[test]
fn errors_of_parts_left_out_add_up() {
    // Either alone may be left out, both together not.
    let blur = threshold(Part::PupilBlur, |scene, width| scene.pupil_blur_vox = width);
    let waves = threshold(Part::Diffraction, |scene, width| scene.diffraction_vox = Some(width));
    let scene =
        SceneMeasure { pupil_blur_vox: 0.8 * blur, diffraction_vox: Some(0.8 * waves), ..easy() };
    let choice = chosen(&scene, &auto());
    assert!(is_on(&choice, Part::PupilBlur) ^ is_on(&choice, Part::Diffraction), "{choice}");
    assert!(choice.model_error_vox.unwrap() <= budget());
}

#[test]
fn a_forced_part_is_as_forced_and_says_so() {
    for (switch, on) in [(Switch::On, true), (Switch::Off, false)] {
        let settings = ModelSettings {
            pupil_blur: switch,
            aperture_coverage: switch,
            diffraction: switch,
            noise_weighting: switch,
            fine_voxels: switch,
            ..auto()
        };
        let scenes = [easy(), SceneMeasure { pupil_blur_vox: 0.9, ..easy() }];
        let mut choices: Vec<ModelChoice> =
            scenes.iter().map(|scene| chosen(scene, &settings)).collect();
        choices.push(configured(&Allowed { settings: &settings, finest: 4 }));
        for choice in choices {
            for part in &choice.parts {
                assert!(part.on == on && part.forced, "{part:?}");
                assert!(part.reason.contains("forced by the configuration"), "{part:?}");
            }
            assert_eq!(choice.refinement, if on { 4 } else { 1 });
            assert_eq!(choice.model.diffraction_nm, on.then_some(532.0));
        }
    }
}

#[test]
fn without_a_wavelength_there_is_no_diffraction() {
    let settings = ModelSettings { wavelength_nm: None, ..auto() };
    let choice = chosen(&SceneMeasure { diffraction_vox: None, ..easy() }, &settings);
    let part = choice.parts.iter().find(|p| p.part == Part::Diffraction).unwrap();
    assert!(!part.on && part.reason.contains("wavelength_nm"), "{part:?}");
}

#[test]
fn an_explicit_model_is_the_default_one() {
    let settings = ModelSettings::default();
    let choice = configured(&Allowed { settings: &settings, finest: 4 });
    assert_eq!((choice.model, choice.refinement), (ModelParts::default(), 4));
    assert_eq!(choice.scene, None);
}
