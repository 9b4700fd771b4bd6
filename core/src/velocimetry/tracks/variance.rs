//! Uncertainty of a fitted spline.

use std::f64::consts::PI;

/// Wave numbers along an axis, between 0 and π per node.
const COUNT: usize = 4;

/// Contributions of one wave number k (per node) along an axis.
#[derive(Debug, Clone, Copy)]
struct Wave {
    /// Square of the values on the nodes that coefficients of size 1 make: ((4 + 2 cos k)/6)².
    on_nodes: f64,
    /// Mean square of the values between the nodes, from the samples of the B-spline of seventh order.
    between: f64,
    /// Square of the coefficients' third difference: (2 sin k/2)⁶.
    difference: f64,
}

/// Plane waves of a spline's error.
#[derive(Debug, Clone)]
pub struct Waves([Wave; COUNT]);

impl Waves {
    /// Waves between 0 and π per node.
    pub fn new() -> Self {
        Self(std::array::from_fn(|n| Wave::of((n as f64 + 0.5) * PI / COUNT as f64)))
    }

    /// Variance of a spline's value on a node under uniform conditions: weight `density` per cell from samples at
    /// random positions, weight `on_node` from one sample on each node, and penalty `stiffness` of the
    /// coefficients' third differences along x, y, z.
    ///
    /// The equations are then diagonal in plane waves. The variance is the mean over all waves of the squared
    /// value on a node divided by the weight of the wave.
    pub fn variance(&self, density: f64, on_node: f64, stiffness: [f64; 3]) -> f64 {
        let mut sum = 0.0;
        for z in self.0 {
            for y in self.0 {
                let value = z.on_nodes * y.on_nodes;
                let between = density * z.between * y.between;
                let stiff = z.difference * stiffness[2] + y.difference * stiffness[1];
                for x in self.0 {
                    let value = value * x.on_nodes;
                    let data = between * x.between + on_node * value;
                    sum += value / (data + stiff + x.difference * stiffness[0]);
                }
            }
        }
        sum / COUNT.pow(3) as f64
    }
}

/// Ratio of the variance on a node to that in the middle of the `nodes`: it is larger on the first and last node of
/// each axis and on those next to them, which have neighbours on fewer sides. The full inverse matrix agrees to
/// 15 % (`tests`).
pub fn near_faces(nodes: [usize; 3], place: [usize; 3]) -> f64 {
    let along = |axis: usize| match place[axis].min(nodes[axis] - 1 - place[axis]) {
        0 => 3.6,
        1 => 1.25,
        _ => 1.0,
    };
    (0..3).map(along).product()
}

impl Wave {
    fn of(k: f64) -> Self {
        let cosine = |n: f64| (n * k).cos();
        let septic = 2416.0 + 2382.0 * cosine(1.0) + 240.0 * cosine(2.0) + 2.0 * cosine(3.0);
        Self {
            on_nodes: ((4.0 + 2.0 * cosine(1.0)) / 6.0).powi(2),
            between: septic / 5040.0,
            difference: (2.0 * (k / 2.0).sin()).powi(6),
        }
    }
}
