//! SDL: `finish { ambient 0.1 diffuse 0.7 phong 1 reflection { 0.1, 0.6 fresnel } }`.

use crate::color::Rgb;

/// `reflection { minimum, maximum fresnel falloff F exponent F metallic F }`: minimum head-on, maximum grazing.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
#[allow(missing_docs)]
pub struct Reflection {
    pub minimum: Rgb,
    pub maximum: Rgb,
    pub fresnel: bool,
    pub falloff: f64,
    pub exponent: f64,
    pub metallic: f64,
}

/// `irid { amount thickness F turbulence F }`.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
#[allow(missing_docs)]
pub struct Iridescence {
    pub amount: f64,
    pub thickness: f64,
    pub turbulence: f64,
}

/// `subsurface { translucency C anisotropy C }`.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
#[allow(missing_docs)]
pub struct Subsurface {
    pub translucency: Rgb,
    pub anisotropy: Rgb,
}

/// How a surface answers light.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
#[allow(missing_docs)]
pub struct Finish {
    pub ambient: Rgb,
    pub emission: Rgb,
    pub diffuse: f64,
    pub diffuse_back: f64,
    pub diffuse_albedo: bool,
    pub brilliance: f64,
    pub crand: f64,
    pub phong: f64,
    pub phong_albedo: bool,
    pub phong_size: f64,
    pub specular: f64,
    pub specular_albedo: bool,
    pub roughness: f64,
    pub metallic: f64,
    pub reflection: Reflection,
    pub conserve_energy: bool,
    pub irid: Option<Iridescence>,
    pub subsurface: Option<Subsurface>,
    pub fresnel: f64,
    pub use_alpha: bool,
}
