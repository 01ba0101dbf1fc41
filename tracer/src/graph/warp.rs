//! SDL: `warp { ... }`: mirror of `minipov.tracer.warp`.
#![allow(missing_docs)] // the fields are documented where they are mirrored from

use crate::math::{Transform, Vec3};

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Turbulence {
    pub amount: Vec3,
    pub octaves: i64,
    pub omega: f64,
    pub lambda_: f64,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct RepeatWarp {
    pub axis: usize,
    pub width: f64,
    pub offset: Vec3,
    pub flip: [bool; 3],
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct BlackHoleWarp {
    pub center: Vec3,
    pub radius: f64,
    pub strength: f64,
    pub falloff: f64,
    pub inverse: bool,
    pub repeat: Option<Vec3>,
    pub turbulence: Vec3,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct CylindricalWarp {
    pub orientation: Vec3,
    pub dist_exp: f64,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct SphericalWarp {
    pub orientation: Vec3,
    pub dist_exp: f64,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct ToroidalWarp {
    pub orientation: Vec3,
    pub dist_exp: f64,
    pub major_radius: f64,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct PlanarWarp {
    pub normal: Vec3,
    pub distance: f64,
}

/// `cubic`, which has no parameters.
#[derive(Clone, Debug)]
pub struct CubicWarp;

#[cfg(feature = "python")]
impl pyo3::FromPyObject<'_, '_> for CubicWarp {
    type Error = pyo3::PyErr;
    fn extract(_: pyo3::Borrowed<'_, '_, pyo3::PyAny>) -> pyo3::PyResult<CubicWarp> {
        Ok(CubicWarp)
    }
}

#[derive(Clone, Debug)]
pub enum Warp {
    Transform(Transform),
    Turbulence(Turbulence),
    Repeat(RepeatWarp),
    BlackHole(BlackHoleWarp),
    Cylindrical(CylindricalWarp),
    Spherical(SphericalWarp),
    Toroidal(ToroidalWarp),
    Planar(PlanarWarp),
    Cubic(CubicWarp),
}

from_class_name!(Warp {
    Transform => Transform,
    Turbulence => Turbulence,
    RepeatWarp => Repeat,
    BlackHoleWarp => BlackHole,
    CylindricalWarp => Cylindrical,
    SphericalWarp => Spherical,
    ToroidalWarp => Toroidal,
    PlanarWarp => Planar,
    CubicWarp => Cubic,
});
