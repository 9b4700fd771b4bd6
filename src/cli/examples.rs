//! The examples in `--help` of each command.

use clap::Command;

/// A command line and its explanation.
type Example = (&'static str, &'static str);

const EXAMPLES: [(&str, &[Example]); 23] = [
    (
        "init",
        &[
            ("lfpiv init --out bench.toml", "ask about the optics and write a commented file"),
            (
                "lfpiv init --defaults --set focal_length_mm=200 --set f_number=4 --out bench.toml",
                "ask nothing",
            ),
            ("lfpiv init --camera 192.168.10.11 --out bench.toml", "read the sensor's size"),
        ],
    ),
    (
        "check",
        &[(
            "lfpiv check --config config/bench.toml",
            "check a configuration and show what could be better",
        )],
    ),
    (
        "plan",
        &[
            (
                "lfpiv plan --config config/bench.toml",
                "the uncertainty over the volume, and what would reduce it",
            ),
            (
                "lfpiv plan --config bench.toml --ppm 0.3 --svg plan.svg",
                "with less seeding, and a chart",
            ),
        ],
    ),
    ("timing", &[("lfpiv timing --config config/jet.toml --svg timing.svg", "the timing diagram")]),
    (
        "simulate",
        &[
            ("lfpiv simulate --config config/sim.toml --out pairs --shots 3", "three pairs"),
            (
                "lfpiv simulate --config config/imperfect.toml --out images --shots 0 --white 5 \
                 --dark 5",
                "white and dark images, for a calibration",
            ),
        ],
    ),
    (
        "process",
        &[
            (
                "lfpiv process --config config/sim.toml --out results pairs",
                "measure pairs of images",
            ),
            (
                "lfpiv process --config config/sim.toml --out results --resume pairs",
                "measure the pairs without results",
            ),
            (
                "lfpiv process results/run-20261121T090000Z",
                "measure the unmeasured shots of a recorded run",
            ),
            (
                "lfpiv process results/run-20261121T090000Z --part 2/8 --out parts/2",
                "an eighth of that, on one of eight machines",
            ),
            (
                "lfpiv process results/run-20261121T090000Z --merge parts/1 parts/2 parts/3",
                "the results of all parts, verified, into the run",
            ),
            (
                "lfpiv process results/run-20261121T090000Z --cluster nats://10.0.0.1:4222 --serve \
                 10.0.0.1:8700",
                "by workers on any machines",
            ),
        ],
    ),
    (
        "work",
        &[
            (
                "lfpiv work --url nats://10.0.0.1:4222 --slots 2",
                "measure two shots at a time, with frames from the coordinator",
            ),
            (
                "lfpiv work --url nats://10.0.0.1:4222 --shared /data/results",
                "with frames from a folder that all machines share",
            ),
        ],
    ),
    (
        "scale",
        &[(
            "lfpiv scale results/run-20261121T090000Z --url nats://127.0.0.1:4222 --out scale",
            "1 to 64 machines, from costs measured here, with a chart",
        )],
    ),
    (
        "correlate",
        &[(
            "lfpiv correlate --config config/sim.toml --out results volumes.nc",
            "vectors from two volumes",
        )],
    ),
    (
        "run",
        &[
            ("lfpiv run --config config/sim.toml --shots 5", "five shots of the simulated bench"),
            ("lfpiv run --config bench.toml", "until Ctrl-C; the page is at server.address"),
        ],
    ),
    (
        "replay",
        &[(
            "lfpiv replay results/run-20261121T090000Z",
            "replay a run and compare its results bit for bit",
        )],
    ),
    ("serve", &[("lfpiv serve results/run-20261121T090000Z", "show a finished run in a browser")]),
    (
        "compare",
        &[(
            "lfpiv compare results/run-20261121T090000Z results/run-20261121T100000Z",
            "compare two runs number by number",
        )],
    ),
    (
        "statistics",
        &[
            (
                "lfpiv statistics results/run-20261121T090000Z",
                "all shots; writes statistics.nc into the run's folder",
            ),
            (
                "lfpiv statistics results/run-20261121T090000Z --shots 100..299 --out later.nc",
                "some shots only",
            ),
        ],
    ),
    (
        "export",
        &[
            (
                "lfpiv export results/run-20261121T090000Z --out pairs",
                "the recorded images as TIFF",
            ),
            (
                "lfpiv export results/run-20261121T090000Z --out tables --format csv --shots 0..9",
                "vectors of ten shots",
            ),
        ],
    ),
    ("merge", &[("lfpiv merge results/run-20261121T090000Z", "merge many NetCDF files into few")]),
    (
        "sim-bench",
        &[(
            "lfpiv sim-bench --config config/loopback-bench.toml",
            "simulated instruments for a daemon",
        )],
    ),
    ("devices", &[("lfpiv devices", "cameras on the network, their addresses and sensors")]),
    (
        "doctor",
        &[("lfpiv doctor --config bench.toml", "network, disk, clock, serial port, priorities")],
    ),
    (
        "calibrate",
        &[
            (
                "lfpiv calibrate focus --config bench.toml --camera 1 --live",
                "the plane in focus, live from the camera",
            ),
            (
                "lfpiv calibrate grid --white white/cam1_00.tif --dark dark/cam1_00.tif --out grid.json",
                "the centres of the micro-images",
            ),
            (
                "lfpiv calibrate volume --card card/card.toml --config bench.toml --grid cam1.json cam2.json --out calibration.json",
                "the cameras in the volume",
            ),
        ],
    ),
    ("bench", &[("lfpiv bench --set speed", "a report of speed against error")]),
    (
        "validate",
        &[(
            "lfpiv validate --shots 20 --out validation",
            "light-field and planar PIV of a simulated jet, beside the truth",
        )],
    ),
    ("peers", &[("lfpiv peers --help", "cases to compare with other programs")]),
];

/// Adds the examples to the help of every command.
pub(super) fn with_examples(command: Command) -> Command {
    EXAMPLES.iter().fold(command, |command, (name, examples)| {
        if command.find_subcommand(name).is_none() {
            return command;
        }
        command.mut_subcommand(name, |command| command.after_help(text(examples)))
    })
}

fn text(examples: &[Example]) -> String {
    let title = if examples.len() == 1 { "Example:" } else { "Examples:" };
    let lines = examples.iter().map(|(line, what)| format!("\n  {line}\n      {what}"));
    format!("{title}{}", lines.collect::<String>())
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;
    use crate::cli::Cli;

    #[test]
    fn every_command_has_examples_that_the_command_line_understands() {
        let command = with_examples(Cli::command());
        let shown = command.get_subcommands().filter(|command| !command.is_hide_set());
        for command in shown.map(Command::get_name).filter(|name| *name != "help") {
            assert!(EXAMPLES.iter().any(|(name, _)| *name == command), "{command} has no example");
        }
        for (name, examples) in EXAMPLES {
            assert!(Cli::command().find_subcommand(name).is_some(), "{name} is not a command");
            for (line, _) in examples {
                let words = line.split_whitespace();
                let read = Cli::command().try_get_matches_from(words);
                assert!(read.is_ok(), "{line}: {}", read.unwrap_err());
                assert_eq!(line.split_whitespace().nth(1), Some(name), "{line}");
            }
        }
    }

    #[test]
    fn help_shows_examples() {
        let mut command = with_examples(Cli::command());
        let help = command.find_subcommand_mut("export").unwrap().render_help().to_string();
        assert!(help.contains("Examples:\n  lfpiv export results/"), "{help}");
    }
}
