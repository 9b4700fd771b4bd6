//! Convergence of statistics with the number of shots.

use serde::{Deserialize, Serialize};

use super::moments::Moments;

/// Number of groups of shots. Shot n is in group n modulo this, so that the order of shots does not matter. It is
/// prime, so that shots with almost any constant stride fill all groups.
pub(super) const GROUPS: usize = 23;

/// Comparison of the statistics of some shots with those of all shots. Velocities in m/s.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Convergence {
    /// Number of these shots.
    pub shots: u64,
    /// Standard uncertainty of the mean of u, v, w from these shots, rms over the nodes.
    pub mean_uncertainty_m_s: [f64; 3],
    /// Difference between their means and those of all shots, rms over the nodes.
    pub mean_difference_m_s: [f64; 3],
    /// Expected value of this difference for independent shots of a stationary flow. A larger difference indicates
    /// correlated shots or a change of the flow.
    pub mean_difference_expected_m_s: [f64; 3],
    /// Difference between the standard deviations, rms over the nodes.
    pub rms_difference_m_s: [f64; 3],
}

/// Convergence from one group of shots to all groups. Each group is spread over the run, because shots are assigned
/// to groups in turn. `moments` are those of each node and group.
pub(super) fn convergence(shots: &[u64; GROUPS], moments: &[Moments]) -> Vec<Convergence> {
    let nodes = moments.chunks(GROUPS);
    let whole: Vec<Moments> = nodes
        .map(|groups| {
            let mut all = Moments::default();
            groups.iter().for_each(|group| all.merge(group));
            all
        })
        .collect();
    let mut parts = vec![Moments::default(); whole.len()];
    let (mut taken, mut steps) = (0, Vec::new());
    for group in (0..GROUPS).filter(|group| shots[*group] > 0) {
        taken += shots[group];
        for (part, groups) in parts.iter_mut().zip(moments.chunks(GROUPS)) {
            part.merge(&groups[group]);
        }
        steps.push(step(taken, &parts, &whole));
    }
    steps
}

fn step(shots: u64, parts: &[Moments], whole: &[Moments]) -> Convergence {
    let mut sums = [[0.0; 3]; 4];
    let (mut nodes, mut fluctuating) = (0.0_f64, 0.0_f64);
    for (part, all) in parts.iter().zip(whole).filter(|(part, _)| part.count > 0) {
        let Some(now) = all.covariances() else { continue };
        nodes += 1.0;
        let (n, total) = (part.count as f64, all.count as f64);
        for c in 0..3 {
            sums[0][c] += now[c] / n;
            sums[1][c] += (part.mean[c] - all.mean[c]).powi(2);
            // Variance of the difference between the mean of a subset and the mean of all samples.
            sums[2][c] += now[c] * (1.0 / n - 1.0 / total);
        }
        if let Some(then) = part.covariances() {
            fluctuating += 1.0;
            for c in 0..3 {
                sums[3][c] += (then[c].max(0.0).sqrt() - now[c].max(0.0).sqrt()).powi(2);
            }
        }
    }
    let root = |sums: [f64; 3], nodes: f64| sums.map(|sum| (sum.max(0.0) / nodes.max(1.0)).sqrt());
    Convergence {
        shots,
        mean_uncertainty_m_s: root(sums[0], nodes),
        mean_difference_m_s: root(sums[1], nodes),
        mean_difference_expected_m_s: root(sums[2], nodes),
        rms_difference_m_s: root(sums[3], fluctuating),
    }
}
