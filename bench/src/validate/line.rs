//! Places of a lattice that are averaged into a profile.

use lfpiv_core::{
    ensemble::{Sample, Snapshot},
    velocimetry::VectorGrid,
};

use super::{Region, layers_nearest};

/// A profile along an axis through a lattice, each of its places averaged along y over the common region.
pub(super) struct Line {
    /// 0 is x.
    pub axis: usize,
    /// Where its places are, as a lattice of one place across.
    pub grid: VectorGrid,
    /// The lattice's places that each of its own is the average of.
    pub members: Vec<Vec<usize>>,
}

impl Line {
    /// Along x through the middle of the common region's depth, or along z through the middle of its width.
    pub fn through(grid: &VectorGrid, axis: usize, region: &Region) -> Self {
        let across = 2 - axis;
        let middle_mm = region.range_mm[across].iter().sum::<f64>() / 2.0;
        let layers = layers_nearest(grid, across, middle_mm);
        let along_y = grid.axis_mm(1);
        let [low, high] = region.range_mm[1];
        let slack_mm = 1e-6 * grid.spacing_mm;
        let rows: Vec<usize> = (0..along_y.len())
            .filter(|&n| (low - slack_mm..=high + slack_mm).contains(&along_y[n]))
            .collect();
        let [nx, ny, _] = grid.vectors;
        let members = (0..grid.vectors[axis])
            .map(|place| {
                let number = |layer: usize, row: usize| {
                    let mut at = [0, row, 0];
                    (at[axis], at[across]) = (place, layer);
                    (at[2] * ny + at[1]) * nx + at[0]
                };
                layers
                    .iter()
                    .flat_map(|&layer| rows.iter().map(move |&row| number(layer, row)))
                    .collect()
            })
            .collect();
        let mut vectors = [1; 3];
        vectors[axis] = grid.vectors[axis];
        Self { axis, grid: VectorGrid { vectors, ..grid.clone() }, members }
    }

    /// The averages of a shot, over what is there of each place's members. Their errors are taken for independent.
    pub fn averaged(&self, snapshot: &Snapshot) -> Snapshot {
        let average = |members: &Vec<usize>| {
            let there: Vec<&Sample> =
                members.iter().filter_map(|&n| snapshot.samples[n].as_ref()).collect();
            let count = there.len() as f64;
            (!there.is_empty()).then(|| Sample {
                velocity_m_s: std::array::from_fn(|c| {
                    there.iter().map(|sample| sample.velocity_m_s[c]).sum::<f64>() / count
                }),
                uncertainty_m_s: std::array::from_fn(|c| {
                    let squares = there.iter().map(|sample| sample.uncertainty_m_s[c].powi(2));
                    squares.sum::<f64>().sqrt() / count
                }),
            })
        };
        let samples = self.members.iter().map(average).collect();
        Snapshot { shot: snapshot.shot, samples }
    }

    /// The mean over a place's members.
    pub fn mean_of(&self, place: usize, of: impl Fn(usize) -> Option<f64>) -> Option<f64> {
        let known: Vec<f64> = self.members[place].iter().filter_map(|&n| of(n)).collect();
        (!known.is_empty()).then(|| known.iter().sum::<f64>() / known.len() as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid() -> VectorGrid {
        VectorGrid { vectors: [3, 4, 2], first_mm: [-1.0, 0.0, -0.5], spacing_mm: 1.0 }
    }

    #[test]
    fn a_profile_takes_the_rows_of_the_region_in_the_layers_next_to_its_middle() {
        let region = Region { range_mm: [[-1.0, 1.0], [1.0, 2.0], [-0.5, 0.5]] };
        let line = Line::through(&grid(), 0, &region);
        assert_eq!(line.grid.vectors, [3, 1, 1]);
        // Rows 1 and 2 of both layers, which are as far from z = 0.
        assert_eq!(line.members[1], [4, 7, 16, 19]);
        let along_z = Line::through(&grid(), 2, &region);
        assert_eq!(along_z.members, [vec![4, 7], vec![16, 19]]);
    }

    #[test]
    fn averages_are_of_what_is_there() {
        let region = Region { range_mm: [[-1.0, 1.0], [1.0, 2.0], [-0.5, 0.5]] };
        let line = Line::through(&grid(), 2, &region);
        let sample = |v: f64| Sample { velocity_m_s: [0.0, v, 0.0], uncertainty_m_s: [0.3; 3] };
        let mut samples = vec![None; 24];
        (samples[4], samples[7]) = (Some(sample(2.0)), Some(sample(4.0)));
        let averaged = line.averaged(&Snapshot { shot: 9, samples });
        assert_eq!(averaged.shot, 9);
        let first = averaged.samples[0].unwrap();
        assert_eq!(first.velocity_m_s[1], 3.0);
        assert!((first.uncertainty_m_s[1] - 0.3 / 2f64.sqrt()).abs() < 1e-12);
        assert_eq!(averaged.samples[1], None);
    }
}
