//! SDL: `fog`, `rainbow`, `sky_sphere`: mirror of `minipov.tracer.atmosphere`.
#![allow(missing_docs)] // the fields are documented where they are mirrored from

pub use super::pigment::ColorMap;
use super::pigment::Pigment;
use super::warp::Turbulence;
use crate::color::{Rgb, Rgbft};
use crate::math::Vec3;

/// `fog { ... }`.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Fog {
    pub distance: f64,
    pub color: Rgbft,
    pub fog_type: u8,
    pub fog_offset: f64,
    pub fog_alt: f64,
    pub up: Vec3,
    pub turbulence: Option<Turbulence>,
    pub turb_depth: f64,
}

/// `rainbow { ... }`, angles in degrees.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Rainbow {
    pub direction: Vec3,
    pub angle: f64,
    pub width: f64,
    pub color_map: Option<ColorMap>,
    pub distance: f64,
    pub jitter: f64,
    pub up: Vec3,
    pub arc_angle: f64,
    pub falloff_angle: f64,
}

/// `sky_sphere { pigment {...} ... }`.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct SkySphere {
    pub pigments: Vec<Pigment>,
    pub emission: Rgb,
}
