//! How much wider the field's error is than its draws, from samples that were left out.

use super::{Sample, field::SplineField, nodes::Nodes, roughness::sums_within};

/// Nodes on either side whose samples tell how wide the error is about a place.
const REACH: usize = 2;

/// All samples count about each place as so many more.
const SHARED: f32 = 30.0;

/// Mean of |r| of a normal distribution, in standard deviations.
const MEAN: f32 = 0.798;

/// A sample farther off than so many standard deviations counts as so far off: it may be wrong itself.
const FARTHEST: f32 = 4.0;

/// Least and most that a variance is changed by. Draws are never narrowed: samples that were left out are close
/// to others more often than any place is.
const LIMITS: [f32; 2] = [1.0, 100.0];

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
            one.off.min(FARTHEST * scale * deviation) / deviation,
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
            let ratio = (off[n] / MEAN + SHARED * scale) / (numbers[n] + SHARED);
            // (own + field) ratio² = own + factor · field
            let share = if field[n] > 0.0 { own[n] / field[n] } else { 0.0 };
            (ratio * ratio * (1.0 + share) - share).clamp(LIMITS[0], LIMITS[1])
        })
        .collect()
}

/// What all samples are missed by over what explains it; the farthest are cut off where it says.
fn common_scale(missed: &[Missed]) -> f32 {
    let stated: f32 = missed.iter().map(|one| MEAN * one.deviation()).sum();
    let mut scale = 1.0f32;
    if stated > 0.0 {
        for _ in 0..4 {
            let off = |one: &Missed| one.off.min(FARTHEST * scale * one.deviation());
            scale = missed.iter().map(off).sum::<f32>() / stated;
        }
    }
    scale
}
