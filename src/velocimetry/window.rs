//! Interrogation windows: cubes cut out of rendered volumes.

/// A rendered volume: one value per voxel, stored z, y, x.
#[derive(Debug, Clone, Copy)]
pub struct Rendered<'a> {
    /// The light of every voxel.
    pub light: &'a [f32],
    /// Voxels along x, y, z.
    pub voxels: [usize; 3],
}

impl Rendered<'_> {
    /// The part of a cube of edge `edge` at `corner` that lies inside, as first voxel and end along
    /// each axis.
    pub fn inside(&self, corner: [i64; 3], edge: usize) -> [[i64; 2]; 3] {
        std::array::from_fn(|axis| {
            let low = corner[axis].clamp(0, self.voxels[axis] as i64);
            let high = (corner[axis] + edge as i64).clamp(low, self.voxels[axis] as i64);
            [low, high]
        })
    }

    /// The voxels `[from, to)` of the row along x at `y`, `z`, all of them inside.
    pub fn row(&self, [from, to]: [i64; 2], y: i64, z: i64) -> &[f32] {
        let start = (z as usize * self.voxels[1] + y as usize) * self.voxels[0];
        &self.light[start + from as usize..start + to as usize]
    }

    /// Copies a cube of edge `window` into a zeroed cube of edge `edge`, less the window's mean;
    /// what lies outside the volume counts as dark. False when all is dark.
    pub fn copy_window(
        &self,
        corner: [i64; 3],
        window: usize,
        cube: &mut [f32],
        edge: usize,
    ) -> bool {
        cube.fill(0.0);
        let [xs, ys, zs] = self.inside(corner, window);
        let start_of = |y: i64, z: i64| {
            let to = [xs[0] - corner[0], y - corner[1], z - corner[2]].map(|c| c as usize);
            (to[2] * edge + to[1]) * edge + to[0]
        };
        let (mut sum, mut count) = (0.0f64, 0);
        for z in zs[0]..zs[1] {
            for y in ys[0]..ys[1] {
                let row = self.row(xs, y, z);
                cube[start_of(y, z)..][..row.len()].copy_from_slice(row);
                sum += row.iter().map(|&v| f64::from(v)).sum::<f64>();
                count += row.len();
            }
        }
        if sum <= 0.0 || count == 0 {
            return false;
        }
        let mean = (sum / count as f64) as f32;
        let length = (xs[1] - xs[0]) as usize;
        for z in zs[0]..zs[1] {
            for y in ys[0]..ys[1] {
                cube[start_of(y, z)..][..length].iter_mut().for_each(|v| *v -= mean);
            }
        }
        true
    }
}

/// The next edge at least `n` with factors 2 and 3 only: fast for the transform.
pub fn fast_edge(n: usize) -> usize {
    let smooth = |mut m: usize| {
        while m.is_multiple_of(2) {
            m /= 2;
        }
        while m.is_multiple_of(3) {
            m /= 3;
        }
        m == 1
    };
    (n..).find(|&m| smooth(m)).unwrap_or(n)
}
