//! SDL: `pigment { ... }`: mirror of `minipov.tracer.pigment`.
#![allow(missing_docs)] // the fields are documented where they are mirrored from

pub use super::pending::ColorMap;
use crate::color::Rgbft;

/// A colour at every point of space.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Pigment {
    pub color: Rgbft,
    pub quick_color: Option<Rgbft>,
}
