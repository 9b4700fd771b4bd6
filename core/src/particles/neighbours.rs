//! Points near a place.

/// Searches look this much further than their reach for cells, relative to a cell's edge: rounding may put a point
/// into the next one.
const ROUNDING: f32 = 1e-3;

/// Points sorted into cells, so that those near a place are found quickly.
pub struct Neighbours {
    reach: f32,
    /// Edge of a cell: no shorter than the reach, and long enough that there are not many more cells than points.
    edge: f32,
    first: [f32; 3],
    cells: [usize; 3],
    /// Where the points of each cell begin in `sorted`, and where the last ones end.
    starts: Vec<u32>,
    /// The points by cell, with their numbers.
    sorted: Vec<([f32; 3], u32)>,
}

impl Neighbours {
    /// Sorts points for searches within `reach`.
    pub fn new(points: &[[f32; 3]], reach: f32) -> Self {
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
        let (starts, sorted) = (Vec::new(), Vec::new());
        let mut neighbours = Self { reach, edge, first: low, cells, starts, sorted };
        neighbours.sort(points);
        neighbours
    }

    /// Counting sort by cell; points of a cell stay in their order.
    fn sort(&mut self, points: &[[f32; 3]]) {
        let count = self.cells.iter().product::<usize>();
        let cell_of: Vec<usize> = points.iter().map(|&at| self.cell_of(at)).collect();
        let mut ends = vec![0u32; count + 1];
        for &cell in &cell_of {
            ends[cell + 1] += 1;
        }
        for cell in 0..count {
            ends[cell + 1] += ends[cell];
        }
        self.starts = ends.clone();
        self.sorted = vec![([0.0; 3], 0); points.len()];
        for ((number, &point), cell) in (0u32..).zip(points).zip(cell_of) {
            self.sorted[ends[cell] as usize] = (point, number);
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
        if self.sorted.is_empty() {
            return;
        }
        let reach = self.reach / self.edge + ROUNDING;
        let range = |axis: usize| {
            let place = (at[axis] - self.first[axis]) / self.edge;
            let within = |cell: f32| (cell as i64).clamp(0, self.cells[axis] as i64) as usize;
            within((place - reach).floor())..within((place + reach).floor() + 1.0)
        };
        let along = range(0);
        if along.is_empty() {
            return;
        }
        for z in range(2) {
            for y in range(1) {
                let row = (z * self.cells[1] + y) * self.cells[0];
                let cells = self.starts[row + along.start]..self.starts[row + along.end];
                for &(point, number) in &self.sorted[cells.start as usize..cells.end as usize] {
                    let square: f32 = (0..3).map(|axis| (point[axis] - at[axis]).powi(2)).sum();
                    if square <= self.reach * self.reach {
                        found(number as usize, square);
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
