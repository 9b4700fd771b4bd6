//! Variance of a statistic by the delete-a-group jackknife.
//!
//! It assumes no distribution. Samples within a group need not be independent. Groups of unequal size are weighted
//! according to Busing, Meijer and van der Leeden (1999).

use super::moments::Moments;

/// For each group with samples: its size, and the moments of all other groups. Prefixes and suffixes are merged
/// only once.
pub(super) fn left_out(groups: &[Moments]) -> Vec<(u64, Moments)> {
    let groups: Vec<&Moments> = groups.iter().filter(|group| group.count > 0).collect();
    let mut after = vec![Moments::default(); groups.len() + 1];
    for at in (0..groups.len()).rev() {
        after[at] = after[at + 1];
        after[at].merge(groups[at]);
    }
    let mut before = Moments::default();
    let without = groups.iter().enumerate().map(|(at, group)| {
        let mut others = before;
        others.merge(&after[at + 1]);
        before.merge(group);
        (group.count, others)
    });
    without.collect()
}

/// Variance of the estimate `whole`, from size and leave-one-out estimate of each group. `None` with fewer than two
/// groups.
pub(super) fn variance(
    whole: f64,
    without: impl Iterator<Item = (u64, f64)> + Clone,
) -> Option<f64> {
    let total: u64 = without.clone().map(|(size, _)| size).sum();
    let groups = without.clone().count();
    if groups < 2 {
        return None;
    }
    let share = |size: u64| total as f64 / size as f64;
    let pseudo = |(size, estimate): (u64, f64)| {
        let h = share(size);
        (h, h * whole - (h - 1.0) * estimate)
    };
    let mean = without.clone().map(pseudo).map(|(h, value)| value / h).sum::<f64>();
    let squares = without.map(pseudo).map(|(h, value)| (value - mean).powi(2) / (h - 1.0));
    Some(squares.sum::<f64>() / groups as f64)
}
