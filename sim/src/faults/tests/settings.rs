use garde::Validate;

use crate::faults::{ClockJump, FaultSettings};

fn read(text: &str) -> Result<FaultSettings, String> {
    let settings: FaultSettings = toml::from_str(text).map_err(|error| error.to_string())?;
    settings.validate().map_err(|report| report.to_string())?;
    Ok(settings)
}

#[test]
fn a_file_says_which_faults_and_how_often() {
    assert_eq!(read("").unwrap(), FaultSettings::default());
    let text = "seed = 3\n\
                [camera]\nlate_ms = 250\nclock_jumps = [{ frame = 8, jump_ns = -5000 }]\nonly = [\"cam2\"]\n\
                [camera.shares]\ndropped = 0.25\nlate = 0.75\n\
                [line]\nslow_ms = 700\ncut_after = 90\n\
                [line.shares]\nunavailable = 0.5\n";
    let settings = read(text).unwrap();
    assert_eq!((settings.seed, settings.camera.late_ms), (3, 250));
    assert_eq!(settings.camera.clock_jumps, [ClockJump { frame: 8, jump_ns: -5000 }]);
    assert_eq!(settings.camera.only, Some(vec![lfpiv_hw::CameraName(1)]));
    assert_eq!((settings.line.slow_ms, settings.line.cut_after), (700, Some(90)));
    assert_eq!(settings.line.shares.unavailable, 0.5);
    assert_eq!(read(&toml::to_string(&settings).unwrap()).unwrap(), settings);
}

#[test]
fn wrong_values_are_refused_by_name() {
    for (text, words) in [
        ("[camera.shares]\ndropped = 1.5", "camera.shares.dropped"),
        ("[camera.shares]\nlate = -0.1", "allowed: 0 to 1"),
        ("[camera.shares]\nlate = nan", "camera.shares.late"),
        ("[camera.shares]\nlate = 0.6\ndropped = 0.6", "together 1.2; allowed"),
        ("[line.shares]\nslow = 0.6\nstray = 0.6", "line.shares: together 1.2"),
        ("[camera]\nreordered_by = 0", "camera.reordered_by"),
        ("[camera]\nclock_drift_ppm = inf", "camera.clock_drift_ppm"),
        ("[camera.shares]\nlost = 0.1", "unknown field `lost`"),
        ("[synchroniser]\nlost = 0.1", "unknown field `synchroniser`"),
    ] {
        let message = read(text).unwrap_err();
        assert!(message.contains(words), "{text}: {message}");
    }
    assert!(read("[camera.shares]\nlate = 0.4\ndropped = 0.6").is_ok());
}
