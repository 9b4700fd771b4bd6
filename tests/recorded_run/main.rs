//! What a run leaves on disk: after the end, after SIGKILL, on a disk that is full; and the same
//! run played again.

mod bench;
mod connections;
mod damaged;
mod disk;
mod fixture;
mod flood;
mod killed;
mod processed_later;
mod replayed;
mod small_disk;
mod soak;
