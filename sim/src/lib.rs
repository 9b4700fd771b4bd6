//! A bench that is not there.

pub mod scene;

pub use scene::Scene;
