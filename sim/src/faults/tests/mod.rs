//! Injectors around devices that are prepared in advance, by a clock that is set by hand.

mod camera;
mod line;
mod settings;
