//! Rows put together: means over seeds, groups by method.

use lfpiv_core::statistics;

use crate::Row;

/// A group of rows that differ in nothing but `x` and the seed: x and the mean over the seeds.
#[derive(Debug, Clone, PartialEq)]
pub struct Group<'a> {
    /// The group's first row.
    pub row: &'a Row,
    /// Points (x, mean of y), ascending in x.
    pub points: Vec<[f64; 2]>,
}

/// What is known of a group at one x.
struct Sum {
    x: f64,
    y: f64,
    count: usize,
}

/// Groups rows of equal `key`, method, peer and cameras, in order of appearance, with the mean of
/// `y` at every `x`. Rows without one of them are left out.
pub fn grouped<'a>(
    rows: &[&'a Row],
    key: impl Fn(&Row) -> &str,
    x: impl Fn(&Row) -> Option<f64>,
    y: impl Fn(&Row) -> Option<f64>,
) -> Vec<Group<'a>> {
    let same_group = |a: &Row, b: &Row| {
        key(a) == key(b) && a.method == b.method && a.peer == b.peer && a.cameras == b.cameras
    };
    let mut groups: Vec<(&Row, Vec<Sum>)> = Vec::new();
    for &row in rows {
        let (Some(x), Some(y)) = (x(row), y(row)) else { continue };
        let at = groups.iter().position(|(first, _)| same_group(first, row)).unwrap_or_else(|| {
            groups.push((row, Vec::new()));
            groups.len() - 1
        });
        let sums = &mut groups[at].1;
        match sums.iter_mut().find(|sum| sum.x == x) {
            Some(sum) => {
                sum.y += y;
                sum.count += 1;
            }
            None => sums.push(Sum { x, y, count: 1 }),
        }
    }
    let averaged = |(row, mut sums): (&'a Row, Vec<Sum>)| {
        sums.sort_by(|a, b| a.x.total_cmp(&b.x));
        let points = sums.into_iter().map(|sum| [sum.x, sum.y / sum.count as f64]).collect();
        Group { row, points }
    };
    groups.into_iter().map(averaged).collect()
}

/// Rows of one case belong together.
pub fn by_case(row: &Row) -> &str {
    &row.case
}

/// Rows of volumes of one size belong together, whatever their cases are called.
pub fn by_volume(row: &Row) -> &str {
    &row.voxels
}

/// Mean of what rows have of a figure.
pub fn mean(rows: &[&Row], figure: impl Fn(&Row) -> Option<f64>) -> Option<f64> {
    let values: Vec<f64> = rows.iter().filter_map(|row| figure(row)).collect();
    (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
}

/// Median of what rows have of a figure.
pub fn median(rows: &[&Row], figure: impl Fn(&Row) -> Option<f64>) -> Option<f64> {
    statistics::median(rows.iter().filter_map(|row| figure(row)))
}

/// Mean of what rows have of a figure along x, y, z, each component by itself.
pub fn mean_of_components(
    rows: &[&Row],
    figure: impl Fn(&Row) -> Option<[f64; 3]>,
) -> Option<[f64; 3]> {
    let component = |axis: usize| mean(rows, |row| figure(row).map(|figures| figures[axis]));
    Some([component(0)?, component(1)?, component(2)?])
}

/// Mean of the three components' mean errors, in voxels.
pub fn mean_error(row: &Row) -> Option<f64> {
    row.error_vox().map(|error| error.iter().sum::<f64>() / 3.0)
}

/// The same of the true particles, windows only.
pub fn mean_true_windows(row: &Row) -> Option<f64> {
    row.true_windows_vox().map(|error| error.iter().sum::<f64>() / 3.0)
}

/// The same of the true particles, tracked.
pub fn mean_true_followed(row: &Row) -> Option<f64> {
    row.true_followed_vox().map(|error| error.iter().sum::<f64>() / 3.0)
}

/// "one camera", "two cameras".
pub fn cameras(count: usize) -> String {
    match count {
        1 => "one camera".to_owned(),
        2 => "two cameras".to_owned(),
        n => format!("{n} cameras"),
    }
}

/// Points that no other point beats in both coordinates, ascending in the first; smaller is better
/// in both.
pub fn pareto_front(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let mut best = f64::INFINITY;
    sorted.retain(|point| {
        let better = point[1] < best;
        best = best.min(point[1]);
        better
    });
    sorted
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_holds_what_nothing_beats() {
        let points = [[2.0, 0.5], [1.0, 1.0], [3.0, 0.7], [1.5, 1.0], [4.0, 0.1]];
        assert_eq!(pareto_front(&points), [[1.0, 1.0], [2.0, 0.5], [4.0, 0.1]]);
    }

    #[test]
    fn seeds_are_averaged_at_each_density() {
        let row = |ppm, q, seed| Row { ppm, q: Some(q), seed, ..Row::default() };
        let rows = [row(1.0, 0.5, 1), row(0.5, 0.9, 1), row(1.0, 0.7, 2)];
        let rows: Vec<&Row> = rows.iter().collect();
        let groups = grouped(&rows, by_volume, |row| Some(row.ppm), |row| row.q);
        assert_eq!(groups.len(), 1);
        assert_eq!(groups[0].points, [[0.5, 0.9], [1.0, 0.6]]);
        assert_eq!(median(&rows, |row| row.q), Some(0.7));
    }
}
