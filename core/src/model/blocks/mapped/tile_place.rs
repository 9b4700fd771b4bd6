//! Size of the tiles of voxels, and position of a tile relative to the microlenses.

/// Voxels along the columns: one bit of a word is needed for the ends of ranges, and the number is
/// even for whole blocks.
pub(super) const MAX_BITS: usize = 60;

/// Lines of voxels across the rows.
pub(super) const MAX_LINES: usize = 96;

/// Largest number of depths, and thus of layers, of a tile.
pub(super) const MAX_THICKNESS: usize = 8;

/// Microlenses along a row of the array that are processed together.
pub(super) const LENSES: usize = 32;

/// Linear positions of a tile's voxels relative to the microlenses, for voxel (bit, line) from the
/// tile's middle.
#[derive(Debug, Clone, Copy)]
pub(super) struct TilePlace {
    /// Position of the middle along columns and rows, in microlenses.
    pub place: [f64; 2],
    /// Change per bit and per line.
    pub by_voxel: [[f64; 2]; 2],
    /// Parallax of the middle, and its change per bit and per line.
    pub parallax: [f64; 2],
    pub parallax_by_voxel: [[f64; 2]; 2],
    /// Change of position and parallax from the middle to the outermost depth.
    pub to_outermost: [f64; 2],
    pub parallax_to_outermost: [f64; 2],
    /// Number of layers, which are equally thick.
    pub layers: usize,
    /// Distance between the outermost depths of a layer, over that of the tile.
    pub layer_share: f64,
    /// Middle of the tile, in voxels from the first.
    pub middle: [f64; 2],
    pub bits: usize,
    pub lines: usize,
}
