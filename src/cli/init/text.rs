//! Fills the template of the configuration with the answers.

use super::questions::{Answers, decimal, rounded, voxel_mm};

const TEMPLATE: &str = include_str!("template.toml");

/// Start of the simulated scene in the template.
const SCENE: &str = "\n# What `lfpiv simulate` makes";

/// Edge of an interrogation window, in voxels.
const WINDOW_VOX: f64 = 16.0;

/// The filled template.
pub(super) fn configuration(answers: &Answers) -> anyhow::Result<String> {
    let voxel_mm = voxel_mm(answers)?;
    let size_mm: [f64; 3] = answers.numbers("volume_mm")?;
    let voxels = size_mm.map(|size| ((size / voxel_mm).round() as u64).max(1));
    let (fastest, dt_us) = (answers.number("fastest_m_s")?, answers.number("dt_us")?);
    let displacement_vox = fastest * dt_us * 1e-3 / voxel_mm;
    let longest_mm = size_mm.into_iter().fold(0.0, f64::max);
    let made: [(&str, String); 13] = [
        ("working_f_number", rounded(answers.working_f_number()?, 2).to_string()),
        ("object_pitch_mm", rounded(voxel_mm, 4).to_string()),
        ("second_camera", second_camera(answers)?),
        ("size_mm", format!("{} x {} x {}", size_mm[0], size_mm[1], size_mm[2])),
        ("voxels", format!("{voxels:?}")),
        ("voxel_mm", decimal(voxel_mm)),
        ("displacement_vox", rounded(displacement_vox, 1).to_string()),
        ("window_mm", decimal(rounded(WINDOW_VOX * voxel_mm, 3))),
        ("max_displacement_vox", decimal((1.5 * displacement_vox).ceil().max(1.0))),
        ("wavelength_mm", decimal(rounded(longest_mm, 1).max(0.1))),
        ("amplitude_m_s", decimal(fastest / 2.0)),
        ("timing", timing(answers)),
        ("instruments", instruments(answers)),
    ];
    let mut text = TEMPLATE.to_owned();
    // A run uses one bench only.
    if !answers.text("addresses").is_empty()
        && let Some(scene) = text.find(SCENE)
    {
        text.truncate(scene);
    }
    for (key, value) in made {
        text = text.replace(&format!("{{{key}}}"), &value);
    }
    for question in super::questions::questions() {
        let answer = answers.text(question.key);
        // Counts must stay integers in TOML.
        let value = match answer.parse::<f64>() {
            Ok(number) if !WHOLE.contains(&question.key) => decimal(number),
            _ => answer.to_owned(),
        };
        text = text.replace(&format!("{{{}}}", question.key), &value);
    }
    Ok(text)
}

/// Keys whose values are integers.
const WHOLE: [&str; 5] =
    ["sensor_columns", "sensor_rows", "microlens_columns", "microlens_rows", "bits"];

fn second_camera(answers: &Answers) -> anyhow::Result<String> {
    if answers.text("cameras") == "1" {
        return Ok(String::new());
    }
    let (words, [right, up, axis]) = match answers.text("second_camera") {
        "y" => {
            ("looks down along y".to_owned(), [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
        }
        "x" => ("looks along x".to_owned(), [[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]),
        _ => {
            let degrees = answers.number("second_camera")?;
            let (sin, cos) = degrees.to_radians().sin_cos();
            (
                format!("stands {degrees} degrees from camera 1, about y"),
                [[cos, 0.0, -sin], [0.0, 1.0, 0.0], [sin, 0.0, cos]],
            )
        }
    };
    Ok(format!(
        "\n# Camera 2 {words}.\n[[camera]]\nright = {right:?}\nup = {up:?}\naxis = {axis:?}\n"
    ))
}

fn timing(answers: &Answers) -> String {
    if answers.text("addresses").is_empty() {
        return String::new();
    }
    "\n[timing]\n\
     # Limits of laser and cameras; `lfpiv timing` draws the resulting schedule. These are the defaults:\n\
     # laser_rate_limit_hz = 10.0\n\
     # lamp_1_us = 100.0                       # lamp of head 1 after T0\n\
     # lamp_to_q_switch_us = [180.0, 180.0]    # per laser head\n\
     # camera_latency_us = 3.0                 # trigger to start of exposure 1\n\
     # exposure_1_us = 200.0\n\
     # gap_us = 2.0                            # between exposures 1 and 2\n\
     # readout_us = 40000.0                    # of one frame; exposure 2 lasts as long\n\
     # lamp_warm_up_s = 10.0                   # lamps only, before Q-switches are enabled\n"
        .to_owned()
}

fn instruments(answers: &Answers) -> String {
    let addresses: Vec<&str> = answers.text("addresses").split_whitespace().collect();
    if addresses.is_empty() {
        return String::new();
    }
    let wanted: usize = if answers.text("cameras") == "1" { 1 } else { 2 };
    let format = match answers.text("bits") {
        "8" => "Mono8",
        "10" => "Mono10",
        "12" => "Mono12Packed",
        _ => "Mono16",
    };
    let mut text = "\n[instruments]\nframe_patience_s = 1.0          # how long to wait for a due frame\n\
                    after_bench_loss = \"wait_for_arm\"       # or \"go_on\" (the laser fires again by \
                    itself), \"end\"\n\n# One table per [[camera]] table, in the same order.\n"
        .to_owned();
    for camera in 0..wanted {
        let address = addresses.get(camera).copied().unwrap_or("192.168.0.0");
        text += &format!(
            "[[instruments.camera]]\nip = \"{address}\"\npixel_format = \"{format}\"\n\
             packet_size_bytes = 1500        # 9000 with jumbo frames\n\n"
        );
    }
    text += &format!(
        "[instruments.synchroniser]\ndriver = \"bnc-575\"              # \"quantum-composers\", \
         \"oltsync\"\nport = \"{}\"\npacing_ms = 50                  # between commands\n",
        answers.text("serial_port")
    );
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        cli::init::questions::questions,
        config::{Config, ConfigFile, Purpose},
    };

    fn answers(set: &[(&'static str, &str)]) -> Answers {
        let mut answers = Answers::default();
        for question in questions() {
            let given = set.iter().find(|(key, _)| *key == question.key);
            let answer = match given {
                Some((_, answer)) => (*answer).to_owned(),
                None => (question.default)(&answers).unwrap(),
            };
            (question.check)(&answer).unwrap();
            answers.set(question.key, answer);
        }
        answers
    }

    fn parsed(set: &[(&'static str, &str)]) -> (String, Config) {
        let text = configuration(&answers(set)).unwrap();
        assert!(!text.contains('{'), "{text}");
        let config = Config::parse("init", &text).unwrap_or_else(|error| panic!("{error}\n{text}"));
        (text, config)
    }

    /// The defaults describe the shipped bench.
    #[test]
    fn the_defaults_are_consistent() {
        let (text, config) = parsed(&[]);
        let optics = &config.optics;
        assert_eq!((optics.microlens.columns, optics.microlens.rows), (128, 96));
        assert!((optics.microlens.focal_length_mm - 0.8).abs() < 1e-9);
        assert_eq!(config.velocimetry.max_displacement_vox, 6.0);
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("bench.toml");
        std::fs::write(&path, text).unwrap();
        ConfigFile::load_for(Purpose::Images, &path).unwrap();
    }

    #[test]
    fn other_lenses_and_angles_appear_in_the_configuration() {
        let (_, config) = parsed(&[
            ("cameras", "2"),
            ("focal_length_mm", "200"),
            ("object_distance_mm", "600"),
            ("second_camera", "60"),
            ("volume_mm", "12, 10, 8"),
            ("bits", "8"),
        ]);
        // Magnification 1/2: a microlens sees 0.2 mm.
        assert!((config.volume.voxel_mm - 0.2).abs() < 1e-9);
        assert_eq!(config.volume.voxels, [60, 50, 40]);
        let axis = config.camera[1].axis;
        assert!((axis.x - 60f64.to_radians().sin()).abs() < 1e-12, "{axis}");
        assert_eq!(parsed(&[("cameras", "1")]).1.camera.len(), 1);
    }

    #[test]
    fn addresses_give_a_real_bench() {
        let (text, config) = parsed(&[
            ("addresses", "192.168.10.11 192.168.10.12"),
            ("serial_port", "/dev/ttyUSB0"),
        ]);
        assert!(text.contains("ip = \"192.168.10.12\"") && text.contains("/dev/ttyUSB0"));
        assert!(config.instruments.is_some());
    }

    #[test]
    fn impossible_answers_are_refused() {
        let questions = questions();
        let check = |key: &str, answer: &str| {
            (questions.iter().find(|question| question.key == key).unwrap().check)(answer)
        };
        assert!(check("f_number", "-4").is_err() && check("f_number", "four").is_err());
        assert!(check("cameras", "3").is_err() && check("second_camera", "z").is_err());
        assert!(check("volume_mm", "10 8").is_err());
        assert!(check("volume_mm", "10, 8 ,8").is_ok());
        let mut wrong = answers(&[]);
        wrong.set("object_distance_mm", "50".to_owned());
        assert!(configuration(&wrong).unwrap_err().to_string().contains("focal length"));
    }
}
