//! The order of a block's children in a camera's orientation.

use super::{BlockLight, aligned_tables::Axes};

/// Reorders the children of a block from the grid's axes to a camera's and back: child c + 2 r + 4 d of the camera
/// has column c, row r and depth d.
///
/// An order of three axes is at most three exchanges of neighbouring axes. Each exchanges the same children in every
/// block, which vector instructions do in registers. Indices from a table would be loaded one by one, and a kernel
/// for each of the six orientations is six times the code at the same speed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct ChildOrder {
    /// Whether to exchange the first two axes, then the last two, then the first two.
    exchanges: [bool; 3],
}

impl ChildOrder {
    /// The order for a camera whose columns, rows and depth are along `axes` of the grid.
    pub fn of(axes: Axes) -> Self {
        let mut order = [axes.column, axes.row, axes.depth];
        // A bubble sort takes the camera's order to the grid's; the same exchanges backwards do the opposite.
        let exchanges = [0, 1, 0].map(|at| {
            let exchanged = order[at] > order[at + 1];
            if exchanged {
                order.swap(at, at + 1);
            }
            exchanged
        });
        Self { exchanges }
    }

    /// The children in the camera's order.
    #[inline(always)]
    pub fn to_camera(self, mut children: BlockLight) -> BlockLight {
        let [first, second, third] = self.exchanges;
        exchange_first_axes(&mut children, third);
        exchange_last_axes(&mut children, second);
        exchange_first_axes(&mut children, first);
        children
    }

    /// The children in the grid's order.
    #[inline(always)]
    pub fn to_grid(self, mut children: BlockLight) -> BlockLight {
        let [first, second, third] = self.exchanges;
        exchange_first_axes(&mut children, first);
        exchange_last_axes(&mut children, second);
        exchange_first_axes(&mut children, third);
        children
    }
}

#[inline(always)]
fn exchange_first_axes(children: &mut BlockLight, exchange: bool) {
    if exchange {
        let [a, b, c, d, e, f, g, h] = *children;
        *children = [a, c, b, d, e, g, f, h];
    }
}

#[inline(always)]
fn exchange_last_axes(children: &mut BlockLight, exchange: bool) {
    if exchange {
        let [a, b, c, d, e, f, g, h] = *children;
        *children = [a, b, e, f, c, d, g, h];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn children_are_at_their_columns_rows_and_depths() {
        let grid: BlockLight = std::array::from_fn(|child| child as f32);
        for axes in Axes::ALL {
            let order = ChildOrder::of(axes);
            let camera = order.to_camera(grid);
            for (r, columns) in axes.children().into_iter().enumerate() {
                for (c, depths) in columns.into_iter().enumerate() {
                    for (d, child) in depths.into_iter().enumerate() {
                        assert_eq!(camera[c + 2 * r + 4 * d], child as f32, "{axes:?}");
                    }
                }
            }
            assert_eq!(order.to_grid(camera), grid, "{axes:?}");
        }
    }
}
