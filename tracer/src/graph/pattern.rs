//! SDL: `bozo`, `checker`, `gradient x` and their modifiers: mirror of `minipov.tracer.pattern`.
#![allow(missing_docs)] // the fields are documented where they are mirrored from

use super::image::ImageMapping;
use super::pigment::Pigment;
use super::values::keywords;
use super::warp::{Turbulence, Warp};
use super::{Function, Object, Shared, Vec2};
use crate::math::Vec3;

keywords!(
    /// The shape of one period.
    WaveKind {
        Ramp = "ramp_wave",
        Triangle = "triangle_wave",
        Sine = "sine_wave",
        Scallop = "scallop_wave",
        Cubic = "cubic_wave",
        Poly = "poly_wave",
    }
);

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct PatternModifiers {
    pub warps: Vec<Warp>,
    pub turbulence: Option<Turbulence>,
    pub frequency: Option<f64>,
    pub phase: f64,
    pub wave: Option<WaveKind>,
    pub poly_exponent: f64,
    pub noise_generator: Option<i64>,
    pub uv_mapping: bool,
}

keywords!(
    /// Patterns without parameters of their own.
    SimpleKind {
        Aoi = "aoi",
        Average = "average",
        Boxed = "boxed",
        Bozo = "bozo",
        Bumps = "bumps",
        Cells = "cells",
        Checker = "checker",
        Cubic = "cubic",
        Cylindrical = "cylindrical",
        Dents = "dents",
        Granite = "granite",
        Hexagon = "hexagon",
        Leopard = "leopard",
        Marble = "marble",
        Onion = "onion",
        Planar = "planar",
        Radial = "radial",
        Ripples = "ripples",
        Spherical = "spherical",
        Spotted = "spotted",
        Square = "square",
        Triangular = "triangular",
        Waves = "waves",
        Wood = "wood",
        Wrinkles = "wrinkles",
    }
);

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct SimplePattern {
    pub name: SimpleKind,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Agate {
    pub agate_turb: f64,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Brick {
    pub brick_size: Vec3,
    pub mortar: f64,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Crackle {
    pub form: Vec3,
    pub metric: f64,
    pub offset: f64,
    pub solid: bool,
    pub repeat: Vec3,
}

/// Voxels, z slowest, x fastest.
#[derive(Clone, Debug)]
pub struct DensityFile {
    /// Along z, y, x.
    pub size: [usize; 3],
    pub voxels: Vec<f32>,
    pub interpolate: u8,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Facets {
    pub coords: f64,
    pub size: f64,
    pub metric: f64,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct FunctionPattern {
    pub function: Shared<Function>,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Gradient {
    pub direction: Vec3,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct ImageMap {
    pub mapping: ImageMapping,
    pub filter: Vec<(Option<usize>, f64)>,
    pub transmit: Vec<(Option<usize>, f64)>,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct ImagePattern {
    pub mapping: ImageMapping,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct BumpMap {
    pub mapping: ImageMapping,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Fractal {
    pub max_iteration: u32,
    pub coordinate: Option<Vec2>,
    pub magnet: u8,
    pub exponent: u32,
    pub exterior: (u8, f64),
    pub interior: (u8, f64),
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct ObjectPattern {
    pub object: Shared<Object>,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Pavement {
    pub number_of_sides: u8,
    pub number_of_tiles: u8,
    pub pattern: u8,
    pub form: u8,
    pub interior: u8,
    pub exterior: u8,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct PigmentPattern {
    pub pigment: Shared<Pigment>,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Potential {
    pub object: Shared<Object>,
    pub threshold: bool,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Quilted {
    pub control0: f64,
    pub control1: f64,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Slope {
    pub direction: Vec3,
    pub low: f64,
    pub high: f64,
    pub point_at: bool,
    pub altitude: Option<Vec3>,
    pub altitude_low: f64,
    pub altitude_high: f64,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Spiral {
    pub kind: u8,
    pub arms: i64,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Tiling {
    pub number: u8,
}

#[derive(Clone, Debug)]
pub enum Pattern {
    Simple(SimplePattern),
    Agate(Agate),
    Brick(Brick),
    BumpMap(BumpMap),
    Crackle(Crackle),
    DensityFile(Shared<DensityFile>),
    Facets(Facets),
    Function(FunctionPattern),
    Gradient(Gradient),
    ImageMap(ImageMap),
    ImagePattern(ImagePattern),
    Fractal(Fractal),
    Object(ObjectPattern),
    Pavement(Pavement),
    PigmentPattern(PigmentPattern),
    Potential(Potential),
    Quilted(Quilted),
    Slope(Slope),
    Spiral(Spiral),
    Tiling(Tiling),
}

from_class_name!(Pattern {
    SimplePattern => Simple,
    Agate => Agate,
    Brick => Brick,
    BumpMap => BumpMap,
    Crackle => Crackle,
    DensityFile => DensityFile,
    Facets => Facets,
    FunctionPattern => Function,
    Gradient => Gradient,
    ImageMap => ImageMap,
    ImagePattern => ImagePattern,
    Fractal => Fractal,
    ObjectPattern => Object,
    Pavement => Pavement,
    PigmentPattern => PigmentPattern,
    Potential => Potential,
    Quilted => Quilted,
    Slope => Slope,
    Spiral => Spiral,
    Tiling => Tiling,
});

#[cfg(feature = "python")]
impl<'py> pyo3::FromPyObject<'_, 'py> for DensityFile {
    type Error = pyo3::PyErr;

    fn extract(object: pyo3::Borrowed<'_, 'py, pyo3::PyAny>) -> pyo3::PyResult<DensityFile> {
        use pyo3::types::PyAnyMethods;
        let voxels: numpy::PyReadonlyArray3<f32> = object.getattr("voxels")?.extract()?;
        let voxels = voxels.as_array();
        let (z, y, x) = voxels.dim();
        let interpolate = object.getattr("interpolate")?.extract()?;
        Ok(DensityFile { size: [z, y, x], voxels: voxels.iter().copied().collect(), interpolate })
    }
}
