//! The bricks that overlapping windows share.

use super::profile::Span;

/// An axis cut so that every window is some whole bricks, each of one weight.
#[derive(Debug, Clone, PartialEq)]
pub struct Bricks {
    bounds: Vec<usize>,
    windows: Vec<Vec<Share>>,
}

/// A brick in a window.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Share {
    /// Number of the brick.
    pub brick: usize,
    /// Weight of its cells.
    pub weight: f32,
}

impl Bricks {
    /// The bricks of the windows along an axis.
    pub fn of(windows: &[Span]) -> Self {
        let mut bounds: Vec<usize> = windows.iter().flat_map(changes).collect();
        bounds.sort_unstable();
        bounds.dedup();
        let shares = |span: &Span| {
            let first = bounds.partition_point(|&bound| bound < span.first);
            let within = bounds[first..].iter().map_while(|&at| span.weights.get(at - span.first));
            (first..).zip(within).map(|(brick, &weight)| Share { brick, weight }).collect()
        };
        let windows = windows.iter().map(shares).collect();
        Self { bounds, windows }
    }

    /// Number of bricks.
    pub fn count(&self) -> usize {
        self.bounds.len() - 1
    }

    /// First cell of a brick, and how many it has.
    pub fn cells(&self, brick: usize) -> [usize; 2] {
        [self.bounds[brick], self.bounds[brick + 1] - self.bounds[brick]]
    }

    /// What makes up each window.
    pub fn windows(&self) -> &[Vec<Share>] {
        &self.windows
    }
}

/// Where a window begins, where its weight changes, and where it ends.
fn changes(span: &Span) -> impl Iterator<Item = usize> {
    let inside = span.weights.windows(2).enumerate();
    let changing = inside.filter(|(_, pair)| pair[0] != pair[1]).map(|(n, _)| n + 1);
    [0].into_iter().chain(changing).chain([span.weights.len()]).map(|n| span.first + n)
}

#[cfg(test)]
mod tests {
    use super::{super::profile::Profile, *};
    use crate::velocimetry::windows::Windows;

    #[test]
    fn bricks_make_up_the_weights_of_every_window() {
        for (edge, step) in [(16, 8), (13, 5), (6, 6), (2, 1), (9, 12)] {
            let nodes = [4, 1, 2];
            let windows = Windows { nodes, edge, step, cell_vox: 1.0, first_vox: [0.0; 3] };
            let spans = Profile::peaked(edge).spans(&windows);
            for (axis, spans) in spans.iter().enumerate() {
                let bricks = Bricks::of(spans);
                for (span, shares) in spans.iter().zip(bricks.windows()) {
                    let mut cells = vec![0.0f32; windows.span(axis)];
                    for share in shares {
                        let [first, count] = bricks.cells(share.brick);
                        cells[first..first + count].iter_mut().for_each(|c| *c += share.weight);
                    }
                    let mut expected = vec![0.0; cells.len()];
                    expected[span.first..][..edge].copy_from_slice(&span.weights);
                    assert_eq!(cells, expected);
                }
            }
        }
    }
}
