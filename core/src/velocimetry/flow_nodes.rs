//! Which nodes of a lattice lie in the flow, and which neighbours belong to the same flow.
//!
//! A vector is compared with, replaced by, smoothed with or differentiated against vectors of the same flow
//! only. Neighbouring nodes on opposite sides of a body belong to different flows.

use rayon::prelude::*;

use super::layout::Layout;
use crate::model::VolumeMask;

/// Nodes of a lattice and the flow between them.
#[derive(Debug, Clone, PartialEq)]
pub struct FlowNodes {
    layout: Layout,
    in_flow: Vec<bool>,
    /// Per node, a bit for each neighbour in the surrounding cube (see [`cube_index`]) with a clear line to it.
    seen: Vec<u32>,
    /// Per node, whether the next one along x, y, z belongs to the same flow or is extrapolated from it.
    linked: Vec<[bool; 3]>,
}

/// Direction along an axis of the flow from which a node is extrapolated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Extrapolation {
    /// The node is in the flow.
    Own,
    Before,
    Behind,
    /// There is no flow on that line.
    Nowhere,
}

/// Number of an offset of −1 to 1 along each axis, x fastest.
pub fn cube_index(offset: [i32; 3]) -> usize {
    offset.iter().rev().fold(0, |index, c| index * 3 + (c + 1) as usize)
}

/// Place in the cube of the next node along x, y, z.
const NEXT: [usize; 3] = [14, 16, 22];

impl FlowNodes {
    /// The nodes of `layout`, at the places (mm) that `place_mm` gives for their indices. A node sees a
    /// neighbour if the straight line between them lies in the flow.
    pub fn new(
        layout: Layout,
        mask: &VolumeMask,
        place_mm: impl Fn([usize; 3]) -> [f64; 3] + Sync,
    ) -> Self {
        let in_flow: Vec<bool> =
            (0..layout.len()).map(|n| mask.is_flow(place_mm(layout.place(n)))).collect();
        // Half of the neighbours; the other half follows from symmetry.
        let ahead: Vec<u32> = (0..layout.len())
            .into_par_iter()
            .map(|n| {
                let from = layout.place(n);
                let sees = |place: usize| {
                    let other = neighbour(layout, from, place)?;
                    let sees = in_flow[n]
                        && in_flow[layout.number(other)]
                        && mask.is_clear(place_mm(from), place_mm(other));
                    sees.then_some(1u32 << place)
                };
                (14..27).filter_map(sees).sum()
            })
            .collect();
        let mut seen = ahead.clone();
        for (n, ahead) in ahead.into_iter().enumerate() {
            let from = layout.place(n);
            for place in (14..27).filter(|place| ahead >> place & 1 == 1) {
                if let Some(other) = neighbour(layout, from, place) {
                    seen[layout.number(other)] |= 1 << (26 - place);
                }
            }
        }
        let linked = vec![[false; 3]; layout.len()];
        let mut nodes = Self { layout, in_flow, seen, linked };
        for axis in 0..3 {
            nodes.link(axis);
        }
        nodes
    }

    /// Finds the nodes that are linked to the next one along an axis.
    fn link(&mut self, axis: usize) {
        let (stride, count) = (self.layout.stride(axis), self.layout.nodes[axis]);
        let starts = (0..self.layout.len()).filter(|n| n / stride % count == 0);
        for start in starts {
            let row: Vec<usize> = (0..count).map(|place| start + place * stride).collect();
            let sources = self.sources(&row);
            for (place, pair) in sources.windows(2).enumerate() {
                self.linked[row[place]][axis] = match pair {
                    [Extrapolation::Own, Extrapolation::Own] => self.is_open(row[place], axis),
                    [Extrapolation::Own, other] => *other == Extrapolation::Before,
                    [other, Extrapolation::Own] => *other == Extrapolation::Behind,
                    [one, other] => one == other,
                    _ => false,
                };
            }
        }
    }

    /// Source of each node of a row; the one before if both are equally near.
    fn sources(&self, row: &[usize]) -> Vec<Extrapolation> {
        let apart = |place: usize, from: Option<usize>| from.map(|from| place.abs_diff(from));
        (0..row.len())
            .map(|place| {
                let before = (0..place).rev().find(|&other| self.in_flow[row[other]]);
                let behind = (place + 1..row.len()).find(|&other| self.in_flow[row[other]]);
                match (apart(place, before), apart(place, behind)) {
                    _ if self.in_flow[row[place]] => Extrapolation::Own,
                    (None, None) => Extrapolation::Nowhere,
                    (Some(before), Some(behind)) if behind < before => Extrapolation::Behind,
                    (None, Some(_)) => Extrapolation::Behind,
                    (Some(_), _) => Extrapolation::Before,
                }
            })
            .collect()
    }

    /// Number of nodes in the flow.
    pub fn count(&self) -> usize {
        self.in_flow.iter().filter(|in_flow| **in_flow).count()
    }

    /// Whether node `n` is in the flow.
    pub fn is_flow(&self, n: usize) -> bool {
        self.in_flow[n]
    }

    /// Whether node `n` sees its neighbour at `place` in the cube about it.
    pub fn sees(&self, n: usize, place: usize) -> bool {
        self.seen[n] >> place & 1 == 1
    }

    /// Whether node `n` sees the next one along `axis`.
    pub fn is_open(&self, n: usize, axis: usize) -> bool {
        self.sees(n, NEXT[axis])
    }

    /// Whether node `n` and the next one along `axis` belong to the same flow, or one is extrapolated from the other,
    /// or both from the same side.
    pub fn is_linked(&self, n: usize, axis: usize) -> bool {
        self.linked[n][axis]
    }

    /// Whether the third difference along `axis` that starts at node `n` couples flows on opposite sides of a body.
    ///
    /// A node in a body is extrapolated from the nearest flow along the axis. The two extrapolations meet in the
    /// middle of the body and are not compared there.
    pub fn ties_flows(&self, axis: usize, n: usize) -> bool {
        let stride = self.layout.stride(axis);
        !(0..3).all(|k| self.is_linked(n + k * stride, axis))
    }
}

/// The node at `place` in the cube about another; `None` beyond the lattice.
fn neighbour(layout: Layout, from: [usize; 3], place: usize) -> Option<[usize; 3]> {
    let steps = [place % 3, place / 3 % 3, place / 9];
    let along = |axis: usize| {
        let at = (from[axis] + steps[axis]).checked_sub(1)?;
        (at < layout.nodes[axis]).then_some(at)
    };
    Some([along(0)?, along(1)?, along(2)?])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::VolumeGrid;

    /// Nodes 4 voxels apart, and a plate of `thick` voxels across x between the third and the fourth.
    fn nodes(thick: usize) -> FlowNodes {
        let grid = VolumeGrid { voxels: [32, 12, 12], voxel_mm: 1.0, centre_mm: [15.5, 5.5, 5.5] };
        let plate = 9..9 + thick;
        let flow = (0..grid.len()).map(|n| !plate.contains(&grid.indices(n as u32)[0])).collect();
        let layout = Layout { nodes: [8, 3, 3] };
        let mask = VolumeMask { grid, flow };
        FlowNodes::new(layout, &mask, |place| place.map(|n| 4.0 * n as f64))
    }

    #[test]
    fn nodes_on_both_sides_of_a_plate_do_not_see_each_other() {
        for (thick, first_behind) in [(1, 3), (2, 3), (4, 4)] {
            let nodes = nodes(thick);
            let layout = nodes.layout;
            for n in 0..layout.len() {
                let place = layout.place(n);
                let side = |x: usize| match x {
                    _ if x <= 2 => 0,
                    _ if x < first_behind => 1,
                    _ => 2,
                };
                assert_eq!(nodes.is_flow(n), side(place[0]) != 1);
                for cube in (0..27).filter(|&cube| cube != 13) {
                    let other = neighbour(layout, place, cube);
                    let seen = other.is_some_and(|other| {
                        side(other[0]) == side(place[0]) && side(place[0]) != 1
                    });
                    assert_eq!(nodes.sees(n, cube), seen, "{thick}: {place:?}, {cube}");
                }
            }
        }
    }

    #[test]
    fn differences_end_in_the_middle_of_a_body() {
        let along =
            |thick: usize| -> Vec<bool> { (0..5).map(|n| nodes(thick).ties_flows(0, n)).collect() };
        // Nodes 0 to 2 are before the plate.
        assert_eq!(along(1), [true, true, true, false, false]);
        assert_eq!(along(4), [false, true, true, true, false]);
        assert_eq!(along(12), [false, false, true, true, true]);
    }

    #[test]
    fn offsets_have_the_places_of_their_neighbours() {
        let layout = Layout { nodes: [3; 3] };
        for (axis, place) in NEXT.into_iter().enumerate() {
            let mut offset = [0; 3];
            offset[axis] = 1;
            assert_eq!(cube_index(offset), place);
            assert_eq!(neighbour(layout, [1; 3], place).unwrap()[axis], 2);
        }
    }
}
