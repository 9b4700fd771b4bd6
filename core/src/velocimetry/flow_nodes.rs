//! Which nodes of a lattice lie in the flow, and which of their neighbours they see through it.
//!
//! What a vector is compared with, replaced by, smoothed with or differentiated against must be of the same
//! flow: two nodes on either side of a body are neighbours on the lattice and strangers in the flow.

use rayon::prelude::*;

use super::differences::Layout;
use crate::model::VolumeMask;

/// Nodes of a lattice and the flow between them.
#[derive(Debug, Clone, PartialEq)]
pub struct FlowNodes {
    layout: Layout,
    in_flow: Vec<bool>,
    /// Per node, a bit for each place in the cube about it (see [`cube_index`]) whose node it sees.
    seen: Vec<u32>,
}

/// Number of an offset of −1 to 1 along each axis, x fastest.
pub fn cube_index(offset: [i32; 3]) -> usize {
    offset.iter().rev().fold(0, |index, c| index * 3 + (c + 1) as usize)
}

/// Place in the cube of the next node along x, y, z.
const NEXT: [usize; 3] = [14, 16, 22];

impl FlowNodes {
    /// The nodes of `layout`, at the places (mm) that `place_mm` gives for their indices. A node sees a
    /// neighbour if the straight line between them runs through flow.
    pub fn new(
        layout: Layout,
        mask: &VolumeMask,
        place_mm: impl Fn([usize; 3]) -> [f64; 3] + Sync,
    ) -> Self {
        let in_flow: Vec<bool> =
            (0..layout.len()).map(|n| mask.is_flow(place_mm(layout.place(n)))).collect();
        // Half of the neighbours; the other half is seen in return.
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
        Self { layout, in_flow, seen }
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

    /// Whether the third difference along `axis` that starts at node `n` has flow on both sides of what is
    /// not flow.
    pub fn crosses(&self, axis: usize, n: usize) -> bool {
        let stride = self.layout.stride(axis);
        let (mut flow_before, mut is_parted) = (false, false);
        for node in (0..4).map(|k| n + k * stride) {
            if self.is_flow(node) {
                if flow_before && is_parted {
                    return true;
                }
                (flow_before, is_parted) = (true, false);
            }
            is_parted |= !self.is_open(node, axis);
        }
        false
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
    fn differences_may_end_in_a_body_but_not_pass_it() {
        let along =
            |thick: usize| -> Vec<bool> { (0..5).map(|n| nodes(thick).crosses(0, n)).collect() };
        // Nodes 0 to 2 are before the plate.
        assert_eq!(along(1), [true, true, true, false, false]);
        assert_eq!(along(4), [false, true, true, false, false]);
        assert_eq!(along(12), [false; 5]);
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
