//! How wide the field's error is, over that of its draws, from samples that were left out.

use super::{super::differences::Layout, Sample, field::SplineField, nodes::Nodes};

/// Nodes on either side whose samples tell how wide the error is about a place.
const REACH: usize = 2;

/// All samples count about each place as so many more.
const SHARED: f32 = 30.0;

/// A sample farther off than so many standard deviations counts as so far off: it may be wrong itself.
const FARTHEST: f32 = 4.0;

/// Least and most that a variance is changed by.
const LIMITS: [f32; 2] = [0.01, 100.0];

/// What a sample was missed by, and by what that is explained.
struct Missed {
    node: usize,
    off: f32,
    own_variance: f32,
    field_variance: f32,
}

impl Missed {
    fn deviation(&self) -> f32 {
        (self.own_variance + self.field_variance).sqrt()
    }
}

/// Factors on the field's variance at each coefficient's place, along x, y, z, by what samples were `missed`
/// by when they were left out; `variance` is that of component c of sample n.
pub fn widening(
    nodes: &Nodes,
    field: &SplineField,
    samples: &[Sample],
    missed: &[[f32; 3]],
    variance: impl Fn(usize, usize) -> f32,
) -> Vec<[f32; 3]> {
    let mut factors = vec![[1.0; 3]; nodes.layout.len()];
    for c in 0..3 {
        let of = |(n, (sample, missed)): (usize, (&Sample, &[f32; 3]))| Missed {
            node: nodes.nearest(sample.middle_vox),
            off: missed[c].abs(),
            own_variance: variance(c, n),
            field_variance: field.uncertainty_vox(sample.middle_vox)[c].powi(2),
        };
        let missed: Vec<Missed> = samples.iter().zip(missed).enumerate().map(of).collect();
        for (factors, factor) in factors.iter_mut().zip(of_component(nodes, &missed)) {
            factors[c] = factor;
        }
    }
    factors
}

fn of_component(nodes: &Nodes, missed: &[Missed]) -> Vec<f32> {
    let scale = common_scale(missed);
    let mut sums: [Vec<f32>; 4] = std::array::from_fn(|_| vec![0.0; nodes.layout.len()]);
    for one in missed {
        let deviation = one.deviation();
        let values = [
            (one.off / deviation).min(FARTHEST * scale).powi(2),
            1.0,
            one.own_variance,
            one.field_variance,
        ];
        for (sums, value) in sums.iter_mut().zip(values) {
            sums[one.node] += value;
        }
    }
    sums.iter_mut().for_each(|sums| sums_within(nodes.layout, REACH, sums));
    let [off, numbers, own, field] = &sums;
    (0..nodes.layout.len())
        .map(|n| {
            let square = (off[n] + SHARED * scale * scale) / (numbers[n] + SHARED);
            if square < 1.0 {
                // Samples know more than they state, and the field with them.
                return square.max(LIMITS[0]);
            }
            // (own + field) square = own + factor · field
            let share = if field[n] > 0.0 { own[n] / field[n] } else { 0.0 };
            (square * (1.0 + share) - share).min(LIMITS[1])
        })
        .collect()
}

/// What all samples are missed by over what explains it, root mean square; the farthest are cut off where it
/// says.
fn common_scale(missed: &[Missed]) -> f32 {
    let mut scale = 1.0f32;
    for _ in 0..4 {
        let square = |one: &Missed| (one.off / one.deviation()).min(FARTHEST * scale).powi(2);
        let mean = missed.iter().map(square).sum::<f32>() / missed.len().max(1) as f32;
        scale = if mean > 0.0 { mean.sqrt() } else { 1.0 };
    }
    scale
}

/// Every value replaced by the sum of those within `reach` nodes along each axis.
fn sums_within(layout: Layout, reach: usize, values: &mut [f32]) {
    for axis in 0..3 {
        let (s, count) = (layout.stride(axis), layout.nodes[axis]);
        let mut row = vec![0.0; count];
        for start in (0..values.len()).filter(|n| n / s % count == 0) {
            for (i, entry) in row.iter_mut().enumerate() {
                *entry = values[start + i * s];
            }
            for i in 0..count {
                let (low, high) = (i.saturating_sub(reach), (i + reach).min(count - 1));
                values[start + i * s] = row[low..=high].iter().sum();
            }
        }
    }
}
