//! SDL: `interior { ior 1.5 fade_distance 2 media { ... } }`: mirror of `minipov.tracer.interior`.
#![allow(missing_docs)] // the fields are documented where they are mirrored from

use super::pattern::{Pattern, PatternModifiers};
use super::pigment::ColorMap;
use super::Shared;
use crate::color::Rgb;

/// `density_map { [F density] ... }`.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct DensityMap {
    pub entries: Vec<(f64, Density)>,
}

/// The densities of a block pattern.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct DensityList {
    pub densities: Vec<Density>,
}

/// What a density's pattern value looks up.
#[derive(Clone, Debug)]
pub enum DensityBlend {
    Colors(ColorMap),
    Map(DensityMap),
    List(DensityList),
}

from_class_name!(DensityBlend { ColorMap => Colors, DensityMap => Map, DensityList => List });

/// A factor at every point of space.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Density {
    pub color: Rgb,
    pub pattern: Option<Pattern>,
    pub blend: Option<DensityBlend>,
    pub modifiers: PatternModifiers,
}

/// `scattering { kind, color eccentricity F extinction F }`.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Scattering {
    pub kind: u8,
    pub color: Rgb,
    pub eccentricity: f64,
    pub extinction: f64,
}

/// `media { ... }`.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Media {
    pub method: u8,
    pub intervals: usize,
    pub samples: (usize, usize),
    pub aa_threshold: f64,
    pub aa_level: usize,
    pub confidence: f64,
    pub variance: f64,
    pub ratio: f64,
    pub jitter: f64,
    pub absorption: Rgb,
    pub emission: Rgb,
    pub scattering: Option<Scattering>,
    pub densities: Vec<Density>,
    pub collect: bool,
}

/// What fills an object.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Interior {
    pub ior: f64,
    pub dispersion: f64,
    pub dispersion_samples: usize,
    pub caustics: f64,
    pub refraction: f64,
    pub fade_distance: f64,
    pub fade_power: f64,
    pub fade_color: Rgb,
    pub media: Vec<Shared<Media>>,
}
