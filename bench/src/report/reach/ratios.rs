//! Bars on ratios: against other programs, and against the paper's solvers.

use lfpiv_core::reconstruction::Solver;

use super::{
    super::{Report, figures::convergence::accelerations, tables::mean_error, text::number},
    Candidate, all_of, at_most, missed,
};
use crate::{Bar, Row};

/// This program's name in the peers' run, which has rows of its own for comparison.
const OURS: &str = "lfpiv";

/// The row of the least time.
pub(super) fn fastest<'a>(rows: impl Iterator<Item = &'a Row>) -> Option<&'a Row> {
    let seconds = |row: &Row| row.seconds.unwrap_or(f64::INFINITY);
    rows.min_by(|a, b| seconds(a).total_cmp(&seconds(b)))
}

/// How near to its best Q a peer counts as arrived: the last hundredth may take most of the sweeps.
const ARRIVED: f64 = 0.99;

/// Our reconstruction against ASTRA's SART, on the full volume or on active voxels only, where ASTRA
/// is as good as it gets: in every case of the peers' run its fastest row, over all settings and
/// numbers of sweeps, that is within a hundredth of its best Q, and the fastest of ours that is at
/// least as good, on as many threads.
pub(super) fn against_astra(report: &Report, active: bool, least: f64) -> Vec<Candidate> {
    let theirs: Vec<&Row> =
        of(report, "astra").filter(|row| row.method.contains("active") == active).collect();
    let best_q = |case: &str| {
        let here = theirs.iter().filter(|row| row.case == case);
        here.filter_map(|row| row.q).reduce(f64::max).unwrap_or_default()
    };
    let mut cases: Vec<&str> = theirs.iter().map(|row| row.case.as_str()).collect();
    cases.dedup();
    let candidates = cases.into_iter().filter_map(|case| {
        let arrived =
            |row: &&Row| row.case == case && row.q.is_some_and(|q| q >= ARRIVED * best_q(case));
        let peer = fastest(theirs.iter().copied().filter(arrived))?;
        let (peer_s, peer_q) = (peer.seconds?, peer.q?);
        let good = ours_beside(report, peer).filter(|row| row.q.is_some_and(|q| q >= peer_q));
        let Some(own) = fastest(good) else {
            return Some(missed(format!(
                "{}: none of ours reaches Q {}",
                peer.case,
                number(peer_q)
            )));
        };
        let gain = peer_s / own.seconds?;
        let measured = format!(
            "{}: {} × at Q {} against {} ({} s, {} sweeps)",
            peer.case,
            number(gain),
            number(own.q?),
            number(peer_q),
            number(peer_s),
            peer.iterations.unwrap_or_default()
        );
        Some(at_most(measured, &[(least, gain)]))
    });
    all_of(candidates.collect())
}

/// SART's time over OS-SART's at Q = 0.75; the least over the densities counts.
pub(super) fn acceleration(report: &Report) -> Vec<Candidate> {
    let each = accelerations(report).into_iter().map(|gain| match gain.ratio {
        Some(ratio) => at_most(format!("{} × at {} ppm", number(ratio), gain.ppm), &[(2.0, ratio)]),
        None => missed(format!("not both reach it at {} ppm", gain.ppm)),
    });
    all_of(each.collect())
}

/// The fastest method outside of the SART family that reaches OS-SART's final Q.
pub(super) fn against_os_sart(report: &Report) -> Vec<Candidate> {
    let rows = report.held_against(Bar::AgainstOsSart);
    let solver = |row: &Row| report.suite.solver_of(&row.method);
    let paper = rows.iter().filter(|row| solver(row) == Some(Solver::OsSart));
    let candidates = paper.filter_map(|slow| {
        let (slow_s, slow_q) = (slow.seconds?, slow.q?);
        let better = |row: &&Row| {
            !matches!(solver(row), Some(Solver::Sart | Solver::OsSart | Solver::PrSart))
                && (row.ppm, row.cameras, &row.case) == (slow.ppm, slow.cameras, &slow.case)
                && row.q.is_some_and(|q| q >= slow_q)
        };
        let Some(fast) = fastest(rows.iter().copied().filter(better)) else {
            let measured = format!("none reaches its Q {} at {} ppm", number(slow_q), slow.ppm);
            return Some(missed(measured));
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
    });
    all_of(candidates.collect())
}

/// Our correlation's time per vector and error over OpenPIV's, in every case of the peers' run; of
/// ours the one that is nearest to the bar, on as many threads.
pub(super) fn against_openpiv(report: &Report) -> Vec<Candidate> {
    let per_vector = |row: &Row| Some(row.seconds? / row.vectors? as f64);
    let candidates = of(report, "openpiv").filter_map(|peer| {
        let judged = ours_beside(report, peer).filter_map(|own| {
            let gain = per_vector(peer)? / per_vector(own)?;
            let share = mean_error(own)? / mean_error(peer)?;
            let measured = format!(
                "{}: {} × per vector, {} of the error ({}; OpenPIV: {})",
                peer.case,
                number(gain),
                number(share),
                own.method,
                peer.method
            );
            Some(at_most(measured, &[(10.0, gain), (share, 0.5)]))
        });
        judged.min_by(|a, b| a.distance.total_cmp(&b.distance))
    });
    all_of(candidates.collect())
}

/// Rows of a program in the peers' run.
fn of<'a>(report: &'a Report, program: &str) -> impl Iterator<Item = &'a Row> {
    report.peers.iter().filter(move |row| {
        row.peer.as_deref().is_some_and(|peer| peer.eq_ignore_ascii_case(program))
    })
}

/// Our own rows in the peers' run that a peer's row can be compared with.
fn ours_beside<'a>(report: &'a Report, peer: &'a Row) -> impl Iterator<Item = &'a Row> {
    of(report, OURS).filter(|row| row.case == peer.case && row.threads == peer.threads)
}
