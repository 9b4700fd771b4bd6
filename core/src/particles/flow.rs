//! Displacement of particles between the frames.

/// The displacement from frame a to frame b, which is corrected during the fit of particles.
pub trait Flow: Sync {
    /// Displacement of the particle with this mid-pair position, both in mm.
    fn displacement_mm(&self, at_mm: [f64; 3]) -> [f64; 3];

    /// Corrects it by particles. `near` are pairs that roughly agree with it, some of which are mismatched. `far` are
    /// pairs that disagree with it, but agree with each other.
    fn correct(&mut self, near: &[MovedParticle], far: &[MovedParticle]);
}

/// A particle of both frames.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MovedParticle {
    /// Mid-pair position, in mm.
    pub middle_mm: [f64; 3],
    /// Displacement from frame a to frame b, in mm.
    pub moved_mm: [f64; 3],
}

impl MovedParticle {
    /// The particle at these places in frames a and b.
    pub fn between([a, b]: [[f64; 3]; 2]) -> Self {
        Self {
            middle_mm: std::array::from_fn(|axis| (a[axis] + b[axis]) / 2.0),
            moved_mm: std::array::from_fn(|axis| b[axis] - a[axis]),
        }
    }
}

/// Fixed-point iterations for the middle of a path.
const ROUNDS: usize = 3;

/// Mid-pair position of a particle of frame a (`sign` 1) or b (−1).
pub fn middle(at_mm: [f64; 3], flow: &dyn Flow, sign: f64) -> [f64; 3] {
    let mut middle = at_mm;
    for _ in 0..ROUNDS {
        let moved = flow.displacement_mm(middle);
        middle = std::array::from_fn(|axis| at_mm[axis] + sign * moved[axis] / 2.0);
    }
    middle
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Turning;

    impl Flow for Turning {
        fn displacement_mm(&self, at: [f64; 3]) -> [f64; 3] {
            [0.2 + 0.05 * at[1], -0.1 * at[0], 0.03]
        }

        fn correct(&mut self, _: &[MovedParticle], _: &[MovedParticle]) {}
    }

    #[test]
    fn the_middle_of_a_path_is_met_from_both_ends() {
        let at_mm = [1.0, -2.0, 0.5];
        let moved = Turning.displacement_mm(at_mm);
        for (sign, end) in [(1.0, -0.5), (-1.0, 0.5)] {
            let start = std::array::from_fn(|axis| at_mm[axis] + end * moved[axis]);
            let found = middle(start, &Turning, sign);
            assert!((0..3).all(|axis| (found[axis] - at_mm[axis]).abs() < 1e-5), "{found:?}");
        }
    }
}
