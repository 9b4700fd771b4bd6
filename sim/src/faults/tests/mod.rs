//! Injectors around prepared devices, on a manual clock.

mod camera;
mod line;
mod settings;
