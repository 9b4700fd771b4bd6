//! The forecast in words and numbers.

use std::fmt::Write as _;

use anyhow::Context;
use serde_json::json;

use super::{
    checks::Check,
    costs::{LINK_SHARE, Measured},
    model::Limit,
};

/// Numbers of machines that the forecast is for.
pub(super) const MACHINES: [usize; 7] = [1, 2, 4, 8, 16, 32, 64];
/// Networks, in Gbit/s.
pub(super) const NETWORKS: [f64; 3] = [1.0, 10.0, 25.0];
/// Rates that a bench may have, in shots a second.
pub(super) const RATES: [f64; 2] = [10.0, 100.0];
/// Machines that are thought of, at most.
const MOST_MACHINES: usize = 4096;

/// A machine of the forecast.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Machine {
    pub cores: usize,
    pub slots: usize,
}

/// What was measured.
pub(super) fn costs_text(measured: &Measured) -> String {
    let Measured { shot, alone, crowd } = measured;
    format!(
        "per shot: {:.3} s of core time ({:.3} s on this machine), {:.3} MB of frames, {:.1} kB of result\n\
         broker: {:.2} ms to fetch and acknowledge a job\n\
         coordinator: {:.2} ms for one worker; at most {:.0} shots a second ({} workers that do not measure)\n",
        shot.core_s,
        shot.wall_s,
        shot.frame_bytes as f64 / 1e6,
        shot.result_bytes as f64 / 1e3,
        1e3 * alone.broker_s,
        1e3 * alone.coordinator_s,
        crowd.shots_per_s,
        super::CROWD
    )
}

/// Tables of the forecast.
pub(super) fn forecast_text(measured: &Measured, machine: Machine) -> String {
    let Machine { cores, slots } = machine;
    let mut text = format!(
        "\nExtrapolated: shots a second of machines with {cores} cores and {slots} slots\n{:>10}",
        "machines"
    );
    for network in NETWORKS {
        let _ = write!(text, "{:>14}", format!("{network} Gbit/s"));
    }
    text.push('\n');
    for machines in MACHINES {
        let _ = write!(text, "{machines:>10}");
        for network in NETWORKS {
            let rate = measured.of_machine(cores, slots, network).shots_per_s(machines * slots);
            let _ = write!(text, "{rate:>14.2}");
        }
        text.push('\n');
    }
    for network in NETWORKS {
        let costs = measured.of_machine(cores, slots, network);
        let what = match costs.limit() {
            Limit::Network => "the coordinator's network",
            Limit::Coordinator => "the coordinator",
        };
        let _ = writeln!(
            text,
            "{network} Gbit/s: {what} limits the rate to {:.1} shots a second, reached with about {:.0} machines; {}",
            costs.most_shots_per_s(),
            (costs.knee() / slots as f64).ceil(),
            RATES.map(|rate| needed(measured, machine, network, rate)).join("; ")
        );
    }
    for rate in RATES {
        let Needs { cores, gbit_per_s, coordinators } = needs(measured, rate);
        let _ = writeln!(
            text,
            "{rate} Hz need {cores:.1} cores for measuring, {gbit_per_s:.2} Gbit/s at the coordinator unless workers share \
             its folder, and {coordinators:.2} times this machine's capacity as a coordinator"
        );
    }
    text
}

/// What a rate takes, whatever the network.
struct Needs {
    cores: f64,
    gbit_per_s: f64,
    coordinators: f64,
}

fn needs(measured: &Measured, rate: f64) -> Needs {
    Needs {
        cores: rate * measured.shot.core_s,
        gbit_per_s: rate * measured.shot.frame_bytes as f64 * 8e-9 / LINK_SHARE,
        coordinators: rate / measured.crowd.shots_per_s,
    }
}

/// How many machines a rate needs on a network.
fn needed(measured: &Measured, machine: Machine, network: f64, rate: f64) -> String {
    match machines_for(measured, machine, network, rate) {
        Some(machines) => format!("{rate} Hz need {machines} machines"),
        None => format!("{rate} Hz cannot be reached"),
    }
}

fn machines_for(measured: &Measured, machine: Machine, network: f64, rate: f64) -> Option<usize> {
    let Machine { cores, slots } = machine;
    let costs = measured.of_machine(cores, slots, network);
    costs.slots_for(rate, MOST_MACHINES * slots).map(|needed| needed.div_ceil(slots))
}

/// The same for programs.
///
/// # Errors
/// None that is known.
pub(super) fn forecast_json(
    measured: &Measured,
    machine: Machine,
    checks: &[Check],
) -> anyhow::Result<String> {
    let Machine { cores, slots } = machine;
    let networks = NETWORKS.map(|network| {
        let costs = measured.of_machine(cores, slots, network);
        let rates = MACHINES.map(|machines| {
            json!({ "machines": machines, "shots_per_s": costs.shots_per_s(machines * slots) })
        });
        let needs = RATES.map(|rate| {
            json!({ "rate_hz": rate, "machines": machines_for(measured, machine, network, rate) })
        });
        json!({
            "gbit_per_s": network,
            "extrapolated": rates,
            "most_shots_per_s": costs.most_shots_per_s(),
            "limit": match costs.limit() {
                Limit::Network => "network",
                Limit::Coordinator => "coordinator",
            },
            "saturates_at_machines": costs.knee() / slots as f64,
            "needed": needs,
        })
    });
    let takes = RATES.map(|rate| {
        let Needs { cores, gbit_per_s, coordinators } = needs(measured, rate);
        json!({
            "rate_hz": rate,
            "cores": cores,
            "gbit_per_s": gbit_per_s,
            "coordinators_like_this_machine": coordinators,
        })
    });
    let forecast = json!({
        "core_s_per_shot": measured.shot.core_s,
        "frame_bytes_per_shot": measured.shot.frame_bytes,
        "result_bytes_per_shot": measured.shot.result_bytes,
        "broker_s_per_shot": measured.alone.broker_s,
        "coordinator_s_for_one_worker": measured.alone.coordinator_s,
        "coordinator_shots_per_s": measured.crowd.shots_per_s,
        "machine": { "cores": cores, "slots": slots },
        "checks": checks,
        "networks": networks,
        "rates": takes,
    });
    serde_json::to_string_pretty(&forecast).context("the forecast cannot be written")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::scale::{costs::ShotCost, trial::Timed};

    /// 20 MB and two seconds of a core for a shot.
    const MEASURED: Measured = Measured {
        shot: ShotCost { core_s: 2.0, wall_s: 1.0, frame_bytes: 20_000_000, result_bytes: 40_000 },
        alone: Timed { shots_per_s: 40.0, broker_s: 0.001, coordinator_s: 0.024 },
        crowd: Timed { shots_per_s: 50.0, broker_s: 0.001, coordinator_s: 0.16 },
    };
    const MACHINE: Machine = Machine { cores: 4, slots: 2 };

    #[test]
    fn a_forecast_names_limits_and_needs() {
        let text = forecast_text(&MEASURED, MACHINE);
        // 0.94 Gbit/s are 5.875 of these shots, and 50 are less than 23.5 Gbit/s.
        assert!(
            text.contains("1 Gbit/s: the coordinator's network limits the rate to 5.9 shots"),
            "{text}"
        );
        assert!(
            text.contains("25 Gbit/s: the coordinator limits the rate to 50.0 shots"),
            "{text}"
        );
        assert!(text.contains("10 Hz need 20.0 cores for measuring, 1.70 Gbit/s"), "{text}");
        assert!(text.contains("100 Hz cannot be reached"), "{text}");
        let machines = machines_for(&MEASURED, MACHINE, 10.0, 10.0).unwrap();
        // Five by their cores alone.
        assert!((5..8).contains(&machines), "{machines}");
        assert_eq!(machines_for(&MEASURED, MACHINE, 1.0, 10.0), None);
    }
}
