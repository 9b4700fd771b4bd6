//! How statistics settle with the number of shots.

use serde::{Deserialize, Serialize};

use super::moments::Moments;

/// Groups of shots: shot n is in group n modulo this, so that the order in which shots come does not matter. A
/// prime number: shots that are some other number apart fill all groups.
pub(super) const GROUPS: usize = 23;

/// Statistics of a part of the shots beside those of all, over the places. Velocities in m/s.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Convergence {
    /// Number of shots in the part.
    pub shots: u64,
    /// Root-mean-square standard uncertainty of the mean of u, v, w from so many shots.
    pub mean_uncertainty_m_s: [f64; 3],
    /// Root-mean-square difference of the means from those of all shots.
    pub mean_difference_m_s: [f64; 3],
    /// What that difference comes to when shots are independent: more says that they are not, or that the flow
    /// changed.
    pub mean_difference_expected_m_s: [f64; 3],
    /// The same difference of the standard deviations.
    pub rms_difference_m_s: [f64; 3],
}

/// From one group of shots to all of them. Groups take shots in turn, so the parts are spread over the run.
/// `moments` are those of each place and group.
pub(super) fn convergence(shots: &[u64; GROUPS], moments: &[Moments]) -> Vec<Convergence> {
    let places = moments.chunks(GROUPS);
    let whole: Vec<Moments> = places
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
    let (mut places, mut fluctuating) = (0.0_f64, 0.0_f64);
    for (part, all) in parts.iter().zip(whole).filter(|(part, _)| part.count > 0) {
        let Some(now) = all.covariances() else { continue };
        places += 1.0;
        let (n, total) = (part.count as f64, all.count as f64);
        for c in 0..3 {
            sums[0][c] += now[c] / n;
            sums[1][c] += (part.mean[c] - all.mean[c]).powi(2);
            // A part of independent samples and the whole that holds it.
            sums[2][c] += now[c] * (1.0 / n - 1.0 / total);
        }
        if let Some(then) = part.covariances() {
            fluctuating += 1.0;
            for c in 0..3 {
                sums[3][c] += (then[c].max(0.0).sqrt() - now[c].max(0.0).sqrt()).powi(2);
            }
        }
    }
    let root =
        |sums: [f64; 3], places: f64| sums.map(|sum| (sum.max(0.0) / places.max(1.0)).sqrt());
    Convergence {
        shots,
        mean_uncertainty_m_s: root(sums[0], places),
        mean_difference_m_s: root(sums[1], places),
        mean_difference_expected_m_s: root(sums[2], places),
        rms_difference_m_s: root(sums[3], fluctuating),
    }
}
