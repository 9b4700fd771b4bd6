//! Bars on ratios: against other programs, and against the paper's solvers.

use super::{
    super::{Report, figures::convergence::accelerations, svg::number},
    Candidate, at_most,
};
use crate::benchmark::{Bar, Row};

/// The row of the least time.
fn fastest<'a>(rows: impl Iterator<Item = &'a Row>) -> Option<&'a Row> {
    let seconds = |row: &Row| row.seconds.unwrap_or(f64::INFINITY);
    rows.min_by(|a, b| seconds(a).total_cmp(&seconds(b)))
}

/// Ours against a peer's rows on the same case; the fastest of ours that is at least as good.
pub(super) fn against_astra(report: &Report, active: bool, least: f64) -> Vec<Candidate> {
    let ours = report.held_against(Bar::AgainstAstra);
    let peers = report.peers.iter().filter(|row| {
        let astra = row.peer.as_deref().is_some_and(|peer| peer.to_lowercase().contains("astra"));
        astra && row.method.contains("active") == active
    });
    peers
        .filter_map(|peer| {
            let (peer_s, peer_q) = (peer.seconds?, peer.q?);
            let good = |row: &&Row| row.case == peer.case && row.q.is_some_and(|q| q >= peer_q);
            let fastest = fastest(ours.iter().copied().filter(good))?;
            let gain = peer_s / fastest.seconds?;
            let measured = format!(
                "{} × at Q {} against {} ({})",
                number(gain),
                number(fastest.q?),
                number(peer_q),
                report.label(fastest)
            );
            Some(at_most(measured, &[(least, gain)]))
        })
        .collect()
}

/// SART's time over OS-SART's at Q = 0.75; the least over the densities counts.
pub(super) fn acceleration(report: &Report) -> Vec<Candidate> {
    let gains = accelerations(report);
    let ratios: Option<Vec<f64>> = gains.iter().map(|gain| gain.ratio).collect();
    let Some(ratios) = ratios.filter(|ratios| !ratios.is_empty()) else { return Vec::new() };
    let least = ratios.iter().copied().fold(f64::INFINITY, f64::min);
    let each: Vec<String> = gains
        .iter()
        .zip(&ratios)
        .map(|(gain, ratio)| format!("{} × at {} ppm", number(*ratio), gain.ppm))
        .collect();
    vec![at_most(each.join(", "), &[(2.0, least)])]
}

/// The fastest method outside of the SART family that reaches OS-SART's final Q.
pub(super) fn against_os_sart(report: &Report) -> Vec<Candidate> {
    let rows = report.held_against(Bar::AgainstOsSart);
    let paper = rows.iter().filter(|row| report.label(row).starts_with("OS-SART"));
    paper
        .filter_map(|slow| {
            let (slow_s, slow_q) = (slow.seconds?, slow.q?);
            let better = |row: &&Row| {
                !report.label(row).contains("SART")
                    && (row.ppm, row.cameras, &row.case) == (slow.ppm, slow.cameras, &slow.case)
                    && row.q.is_some_and(|q| q >= slow_q)
            };
            let Some(fast) = fastest(rows.iter().copied().filter(better)) else {
                let measured = format!("none reaches its Q {} at {} ppm", number(slow_q), slow.ppm);
                return Some(Candidate { measured, met: false, distance: f64::MAX });
            };
            let gain = slow_s / fast.seconds?;
            let measured = format!(
                "{} × at {} ppm, Q {} against {} ({})",
                number(gain),
                slow.ppm,
                number(fast.q?),
                number(slow_q),
                report.label(fast)
            );
            Some(at_most(measured, &[(100.0, gain)]))
        })
        // The hardest density counts.
        .max_by(|a, b| a.distance.total_cmp(&b.distance))
        .into_iter()
        .collect()
}

/// Our correlation's time per vector and error over OpenPIV's on the same volumes.
pub(super) fn against_openpiv(report: &Report) -> Vec<Candidate> {
    let ours = report.held_against(Bar::AgainstOpenpiv);
    let per_vector = |seconds: f64, row: &Row| Some(seconds / row.vectors? as f64);
    let error = |row: &Row| row.error_vox().map(|e| e.iter().sum::<f64>() / 3.0);
    let peers = report
        .peers
        .iter()
        .filter(|row| row.peer.as_deref().is_some_and(|p| p.to_lowercase().contains("openpiv")));
    peers
        .filter_map(|peer| {
            let row = ours.iter().find(|row| row.case == peer.case)?;
            let gain = per_vector(peer.seconds?, peer)? / per_vector(row.correlate_s?, row)?;
            let share = error(row)? / error(peer)?;
            let measured = format!("{} × per vector, {} of the error", number(gain), number(share));
            Some(at_most(measured, &[(10.0, gain), (share, 0.5)]))
        })
        .collect()
}
