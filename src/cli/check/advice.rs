//! Advice about a bench, from its configuration.

use lfpiv_core::{
    lightfield::Background,
    measurement::Plan,
    model::{Sight, degrees_apart},
    velocimetry::StageSeconds,
};
use lfpiv_hw::CameraName;

use super::{
    super::{
        doctor::{
            machine::free_memory_bytes,
            need::{Need, cores, mb},
        },
        finding::Finding,
    },
    sample::ASSUMED_PPM,
};
use crate::config::Config;

/// Share of the volume that all cameras should see.
const GOOD_COMMON_VIEW: f64 = 0.9;

/// Cameras at a smaller angle (or a smaller angle to facing each other) measure depth from their
/// own views only.
const GOOD_DEGREES_APART: f64 = 45.0;

/// Diameter of the pupil's image behind a microlens over the pitch: below the first, pixels stay
/// dark, above the second, neighbours overlap.
const GOOD_FILL: [f64; 2] = [0.8, 1.05];

/// Particles that a window should contain: with five pairs, a displacement is found in 95 of 100
/// windows (Keane and Adrian 1992).
const GOOD_PARTICLES: f64 = 5.0;

/// Advice that needs no measurement.
pub fn for_configuration(config: &Config) -> Vec<Finding> {
    let mut findings = vec![view(config), angle(config), f_numbers(config), particles(config)];
    findings.extend(background(config));
    findings.extend(calibration(config));
    findings
}

/// Which parameters of the cameras are calibrated; `None` if all are nominal.
fn calibration(config: &Config) -> Option<Finding> {
    const CHECK: &str = "calibration";
    if config.calibration.is_empty() {
        return None;
    }
    Some(match config.left_nominal() {
        Some(left) => Finding::advice(CHECK, "incomplete", left),
        None => Finding::ok(CHECK, "micro-images, poses and optics of all cameras"),
    })
}

fn view(config: &Config) -> Finding {
    const CHECK: &str = "view";
    let seen = Sight::new(&config.optics, &config.poses(), &config.volume.grid());
    let each = (0..).zip(&seen.each);
    let each: Vec<String> = each
        .map(|(camera, share)| format!("{} sees {:.0} %", CameraName(camera), 100.0 * share))
        .collect();
    let found = match config.camera.len() {
        1 => format!("{} of the volume", each.join(", ")),
        _ => {
            format!(
                "{} of the volume, {:.0} % in the common view",
                each.join(", "),
                100.0 * seen.common
            )
        }
    };
    let finding = if seen.common < GOOD_COMMON_VIEW {
        let todo = "vectors outside the common view will be invalid: make [volume] smaller";
        Finding::advice(CHECK, found, todo)
    } else {
        Finding::ok(CHECK, found)
    };
    finding.with("common_share", seen.common)
}

/// The angle between the cameras.
fn angle(config: &Config) -> Finding {
    const CHECK: &str = "angle";
    let poses = config.poses();
    let [one, other] = poses.as_slice() else {
        let found = "one camera";
        let todo = "depth then comes from the views of one camera and is ten times less accurate: use two cameras";
        return Finding::advice(CHECK, found, todo);
    };
    let degrees = degrees_apart(&config.optics, [one, other], &config.volume.grid());
    let found = format!("{degrees:.0} degrees between the cameras");
    let finding = if degrees.min(180.0 - degrees) < GOOD_DEGREES_APART {
        let todo = "depth is less accurate than the other components: 90 degrees are best";
        Finding::advice(CHECK, found, todo)
    } else {
        Finding::ok(CHECK, found)
    };
    finding.with("degrees", degrees)
}

fn f_numbers(config: &Config) -> Finding {
    const CHECK: &str = "f-numbers";
    let optics = &config.optics;
    let lens = optics.image_distance_mm() / optics.pupil_diameter_mm();
    let microlens = optics.microlens.focal_length_mm / optics.microlens.pitch_mm;
    let fill = microlens / lens;
    let found = format!("microlenses f/{microlens:.1} behind a lens that works at f/{lens:.1}");
    let finding = if fill < GOOD_FILL[0] {
        let todo = format!(
            "micro-images fill {:.0} % of their pixels: open the main lens to f/{:.1} \
             (optics.f_number), or use microlenses of f/{lens:.1}",
            100.0 * fill * fill,
            optics.f_number * fill
        );
        Finding::advice(CHECK, found, todo)
    } else if fill > GOOD_FILL[1] {
        let todo = format!(
            "micro-images overlap, so their light is assigned to neighbours: stop the main \
             lens down to f/{:.1} (optics.f_number)",
            optics.f_number * fill
        );
        Finding::advice(CHECK, found, todo)
    } else {
        Finding::ok(CHECK, found)
    };
    finding.with("fill", fill)
}

fn particles(config: &Config) -> Finding {
    const CHECK: &str = "particles";
    let bench = config.bench_geometry();
    let window_mm =
        config.velocimetry.in_voxels(&config.volume.grid()).window as f64 * config.volume.voxel_mm;
    // Seeding is counted per area of the volume's x and y, as in [simulation].
    let per_mm3 = 1.0 / bench.object_pitch_mm().powi(2) / bench.volume.extents_mm()[2];
    let per_window = per_mm3 * window_mm.powi(3);
    let least_ppm = GOOD_PARTICLES / per_window;
    let (ppm, known) = match &config.simulation {
        Some(scene) => (scene.ppm, "seeding"),
        None => (ASSUMED_PPM, "an assumed seeding"),
    };
    let number = ppm * per_window;
    let found = format!("{number:.1} in a window at {known} of {ppm} per microlens");
    let finding = if number < GOOD_PARTICLES {
        let todo = format!(
            "with {GOOD_PARTICLES} or more most windows are valid: seed {least_ppm:.2} per \
             microlens, or set velocimetry.window_mm to {:.1}",
            window_mm * (GOOD_PARTICLES / number.max(1e-9)).cbrt()
        );
        Finding::advice(CHECK, found, todo)
    } else {
        Finding::ok(CHECK, found)
    };
    finding.with("per_window", number)
}

/// Advice if the background is estimated from many pairs.
fn background(config: &Config) -> Option<Finding> {
    matches!(config.image.background, Background::Minimum | Background::Mean).then(|| {
        Finding::advice(
            "background",
            "estimated from all pairs together",
            "`lfpiv process` needs at least three pairs, and `lfpiv run` refuses this setting: set \
             image.background to \"constant\" or \"images\" for a run",
        )
    })
}

/// Whether windows fit into the flow; `None` without a mask.
pub fn mask(config: &Config, plan: &Plan) -> Option<Finding> {
    const CHECK: &str = "mask";
    let (stored, flow) = (config.mask.as_ref()?, plan.in_flow?);
    let share = stored.mask.flow_share();
    let found = format!(
        "{:.1} % of the volume and {} of {} vectors are in the flow",
        100.0 * share,
        flow.vectors,
        plan.vectors.len()
    );
    let finding = if flow.vectors == 0 {
        let todo = "no vector will be measured: make [volume.mask] smaller, or use smaller windows";
        Finding::problem(CHECK, found, todo)
    } else if flow.around_bodies > 0 {
        let todo = format!(
            "{} windows are next to a body that is thinner than a window and mix the flow on both of its sides: use \
             windows no larger than the body is thick (velocimetry.window_mm)",
            flow.around_bodies
        );
        Finding::advice(CHECK, found, todo)
    } else {
        Finding::ok(CHECK, found)
    };
    Some(finding.with("flow_share", share))
}

/// Memory needed for one pair in process and the pairs that wait.
pub fn memory(config: &Config, plan: &Plan) -> Finding {
    const CHECK: &str = "memory";
    let waiting = Need::of(config).waiting_bytes();
    let pair = (plan.image_bytes + plan.view_bytes + plan.table_bytes) as f64;
    let needed = pair + waiting;
    let found = format!(
        "{} for tables and a pair, {} for images of waiting pairs at {} shots/s",
        mb(pair),
        mb(waiting),
        config.shot.rate_hz
    );
    let finding = match free_memory_bytes() {
        Some(free) if free < needed => {
            let found = format!("{found}; {} free", mb(free));
            let todo = "close other programs, lower pipeline.queue, or make the volume smaller";
            Finding::advice(CHECK, found, todo)
        }
        Some(free) => Finding::ok(CHECK, format!("{found}; {} free", mb(free))),
        None => Finding::ok(CHECK, found),
    };
    finding.with("needed_mb", needed / 1e6)
}

/// Expected processing time of a pair against the rate of shots.
pub fn time(config: &Config, expected: &anyhow::Result<StageSeconds>) -> Finding {
    const CHECK: &str = "time";
    let seconds = match expected {
        Ok(seconds) => seconds,
        Err(error) => {
            let found = format!("unknown: {error:#}");
            return Finding::advice(CHECK, found, "correct [simulation], or process a pair");
        }
    };
    let pair_s = seconds.total_s();
    let assumed = match config.simulation {
        Some(_) => String::new(),
        None => format!(", with {ASSUMED_PPM} particles per microlens"),
    };
    let digits = in_digits(pair_s);
    let found = format!("about {digits} s per pair on {} cores{assumed}", cores());
    let load = pair_s * config.shot.rate_hz;
    let finding = if load > 1.0 {
        let todo = format!(
            "at {} shots/s about one in {:.0} is measured during the run; a run records the images \
             of the others, and `lfpiv process RUN` measures them afterwards",
            config.shot.rate_hz,
            load.ceil()
        );
        Finding::advice(CHECK, found, todo)
    } else {
        Finding::ok(CHECK, found)
    };
    finding.with("pair_s", pair_s)
}

/// Two significant digits, which is the accuracy of an estimate.
fn in_digits(value: f64) -> String {
    match value {
        10.0.. => format!("{value:.0}"),
        1.0..10.0 => format!("{value:.1}"),
        0.1..1.0 => format!("{value:.2}"),
        _ => format!("{value:.3}"),
    }
}
