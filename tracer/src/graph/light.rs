//! SDL: `light_source { location, color spotlight ... }`: mirror of `minipov.tracer.lights`.
#![allow(missing_docs)] // the fields are documented where they are mirrored from

use super::values::keywords;
use super::Object;
use crate::color::Rgb;
use crate::math::Vec3;

keywords!(
    /// The shape of a light's beam.
    LightKind { Point = "point", Spotlight = "spotlight", Cylinder = "cylinder" }
);

/// `area_light axis1, axis2, size1, size2`.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct AreaLight {
    pub axis1: Vec3,
    pub axis2: Vec3,
    pub size1: usize,
    pub size2: usize,
    pub adaptive: Option<u32>,
    pub jitter: bool,
    pub circular: bool,
    pub orient: bool,
    pub area_illumination: bool,
}

/// `photons { ... }` of a light.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct LightPhotons {
    pub reflection: Option<bool>,
    pub refraction: Option<bool>,
    pub area_light: bool,
}

/// A light.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct LightSource {
    pub location: Vec3,
    pub color: Rgb,
    pub kind: LightKind,
    pub point_at: Vec3,
    pub radius: f64,
    pub falloff: f64,
    pub tightness: f64,
    pub parallel: bool,
    pub shadowless: bool,
    pub area: Option<AreaLight>,
    pub fade_distance: f64,
    pub fade_power: f64,
    pub pure_power: bool,
    pub media_interaction: bool,
    pub media_attenuation: bool,
    pub looks_like: Option<Object>,
    pub projected_through: Option<Object>,
    pub photons: Option<LightPhotons>,
}
