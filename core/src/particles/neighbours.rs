//! Points near a place.

/// Points sorted into cells, so that those near a place are found quickly.
pub struct Neighbours<'a> {
    points: &'a [[f32; 3]],
    reach: f32,
    /// Edge of a cell: no shorter than the reach, and long enough that there are not many more cells than points.
    edge: f32,
    first: [f32; 3],
    cells: [usize; 3],
    /// Where the points of each cell begin in `order`, and where the last ones end.
    starts: Vec<u32>,
    order: Vec<u32>,
}

impl<'a> Neighbours<'a> {
    /// Sorts points for searches within `reach`.
    pub fn new(points: &'a [[f32; 3]], reach: f32) -> Self {
        let bound = |pick: fn(f32, f32) -> f32, start: f32| -> [f32; 3] {
            std::array::from_fn(|axis| points.iter().map(|p| p[axis]).fold(start, pick))
        };
        let (low, high) = (bound(f32::min, f32::INFINITY), bound(f32::max, f32::NEG_INFINITY));
        let longest = (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f32::max);
        let edge = reach.max(longest / (points.len() as f32).cbrt());
        let cells = if points.is_empty() {
            [0; 3]
        } else {
            std::array::from_fn(|axis| ((high[axis] - low[axis]) / edge) as usize + 1)
        };
        let mut neighbours =
            Self { points, reach, edge, first: low, cells, starts: Vec::new(), order: Vec::new() };
        neighbours.sort();
        neighbours
    }

    /// Counting sort by cell; points of a cell stay in their order.
    fn sort(&mut self) {
        let count = self.cells.iter().product::<usize>();
        let cell_of: Vec<usize> = self.points.iter().map(|&at| self.cell_of(at)).collect();
        let mut ends = vec![0u32; count + 1];
        for &cell in &cell_of {
            ends[cell + 1] += 1;
        }
        for cell in 0..count {
            ends[cell + 1] += ends[cell];
        }
        self.starts = ends.clone();
        self.order = vec![0; self.points.len()];
        for (point, cell) in (0u32..).zip(cell_of) {
            self.order[ends[cell] as usize] = point;
            ends[cell] += 1;
        }
    }

    fn cell_of(&self, at: [f32; 3]) -> usize {
        let place = |axis: usize| {
            (((at[axis] - self.first[axis]) / self.edge) as usize).min(self.cells[axis] - 1)
        };
        (place(2) * self.cells[1] + place(1)) * self.cells[0] + place(0)
    }

    /// Calls `found` with every point within reach of `at` and the square of its distance.
    pub fn visit(&self, at: [f32; 3], mut found: impl FnMut(usize, f32)) {
        if self.points.is_empty() {
            return;
        }
        let range = |axis: usize| {
            let place = ((at[axis] - self.first[axis]) / self.edge).floor() as i64;
            let last = self.cells[axis] as i64;
            (place - 1).clamp(0, last) as usize..(place + 2).clamp(0, last) as usize
        };
        let along = range(0);
        if along.is_empty() {
            return;
        }
        for z in range(2) {
            for y in range(1) {
                let row = (z * self.cells[1] + y) * self.cells[0];
                let cells = self.starts[row + along.start]..self.starts[row + along.end];
                for &point in &self.order[cells.start as usize..cells.end as usize] {
                    let other = self.points[point as usize];
                    let square: f32 = (0..3).map(|axis| (other[axis] - at[axis]).powi(2)).sum();
                    if square <= self.reach * self.reach {
                        found(point as usize, square);
                    }
                }
            }
        }
    }

    /// The nearest point within `reach`, which is at most the reach of all searches; the first of
    /// several.
    pub fn nearest(&self, at: [f32; 3], reach: f32) -> Option<usize> {
        let mut best: Option<(usize, f32)> = None;
        self.visit(at, |point, square| {
            let better = best.is_none_or(|(held, nearest)| {
                square < nearest || (square == nearest && point < held)
            });
            if better && square <= reach * reach {
                best = Some((point, square));
            }
        });
        best.map(|(point, _)| point)
    }
}
