//! Several fields solved at once, one per SIMD lane. Their equations differ only in right-hand sides or sample
//! weights, so one memory load serves all of them.

use rayon::prelude::*;

/// Fields that are solved for together.
pub const LANES: usize = 8;

/// One coefficient, or the value of one sample, of all fields.
pub type Lane = [f32; LANES];

/// Coefficients: a vector for each component, or one whose lanes are the components.
pub type Vectors = Vec<Vec<Lane>>;

/// Values of the three components in the first three lanes; zero in the others.
pub fn packed(of: impl Fn(usize) -> f32) -> Lane {
    std::array::from_fn(|l| if l < 3 { of(l) } else { 0.0 })
}

/// Sums over all coefficients of all vectors of the products of two fields, lane by lane.
pub fn dot(a: &Vectors, b: &Vectors) -> [f64; LANES] {
    // Blocks of fixed length: the order of the sum does not depend on the number of threads.
    let of_vector = |c: usize| {
        let mut sum = [0.0f64; LANES];
        for (a, b) in a[c].chunks(256).zip(b[c].chunks(256)) {
            let mut part = [0.0f32; LANES];
            for (a, b) in a.iter().zip(b) {
                for l in 0..LANES {
                    part[l] += a[l] * b[l];
                }
            }
            for l in 0..LANES {
                sum[l] += f64::from(part[l]);
            }
        }
        sum
    };
    let parts: Vec<[f64; LANES]> = (0..a.len()).into_par_iter().map(of_vector).collect();
    std::array::from_fn(|l| parts.iter().map(|part| part[l]).sum())
}

/// Adds `values` times a factor for each lane.
pub fn add(to: &mut Vectors, factors: Lane, values: &Vectors) {
    to.par_iter_mut().zip(values).for_each(|(to, values)| {
        for (to, value) in to.iter_mut().zip(values) {
            for l in 0..LANES {
                to[l] += factors[l] * value[l];
            }
        }
    });
}

/// `to` = `values` + factor × `to`, lane by lane.
pub fn scale_and_add(to: &mut Vectors, factors: Lane, values: &Vectors) {
    to.par_iter_mut().zip(values).for_each(|(to, values)| {
        for (to, value) in to.iter_mut().zip(values) {
            for l in 0..LANES {
                to[l] = value[l] + factors[l] * to[l];
            }
        }
    });
}

/// Zero fields: `vectors` vectors of `count` coefficients.
pub fn zeros(vectors: usize, count: usize) -> Vectors {
    vec![vec![[0.0; LANES]; count]; vectors]
}
