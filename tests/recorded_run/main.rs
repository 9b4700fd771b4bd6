//! What a run leaves on disk (after its end, after SIGKILL, on a full disk), and its replay.

mod bench;
#[path = "../support/body.rs"]
mod body;
mod connections;
mod damaged;
mod disk;
mod fixture;
mod flood;
mod killed;
mod masked;
mod parts;
mod processed_later;
mod replayed;
mod small_disk;
mod soak;
