//! `lfpiv process RUN --part K/N` and `--merge`: the shots of a recorded run, measured on several machines.
//!
//! A part measures every N-th shot that has no result in the run, into a folder of its own; the run is only
//! read. Merging verifies that every shot is in one part, measured under the same conditions, and does
//! with the results what `lfpiv process RUN` does with its own.

mod measure;
mod merge;
mod part_file;
mod verify;

pub(super) use measure::process_part;
pub(super) use merge::merge_parts;
pub use part_file::Part;
