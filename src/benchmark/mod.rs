//! Speed against error.

pub mod peers;
