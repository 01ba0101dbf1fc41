//! SDL: `camera { ... }`: mirror of `minipov.tracer.camera`.
#![allow(missing_docs)] // the fields are documented where they are mirrored from

use super::normal::Normal;
use super::pigment::Pigment;
use super::values::keywords;
use super::{Function, Object, Shared};
use crate::math::{Transform, Vec3};

keywords!(
    /// How picture coordinates become rays.
    CameraKind {
        Perspective = "perspective",
        Orthographic = "orthographic",
        Fisheye = "fisheye",
        UltraWideAngle = "ultra_wide_angle",
        Omnimax = "omnimax",
        Panoramic = "panoramic",
        Spherical = "spherical",
        Cylinder1 = "cylinder1",
        Cylinder2 = "cylinder2",
        Cylinder3 = "cylinder3",
        Cylinder4 = "cylinder4",
        MeshCamera = "mesh_camera",
        UserDefined = "user_defined",
    }
);

/// `aperture F blur_samples min, max ...`.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct FocalBlur {
    pub aperture: f64,
    pub blur_samples: (usize, usize),
    pub focal_distance: f64,
    pub confidence: f64,
    pub variance: f64,
    pub bokeh: Option<Shared<Pigment>>,
}

/// `mesh_camera { ... }`.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct MeshCamera {
    pub rays_per_pixel: usize,
    pub distribution: u8,
    pub meshes: Vec<Object>,
    pub max_distance: Option<f64>,
    pub smooth: bool,
}

/// 3.8 `user_defined`.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct UserDefinedCamera {
    pub location: Option<[Shared<Function>; 3]>,
    pub direction: Option<[Shared<Function>; 3]>,
    pub transform: Transform,
}

/// From where and how the picture is taken.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Camera {
    pub kind: CameraKind,
    pub location: Vec3,
    pub direction: Vec3,
    pub right: Vec3,
    pub up: Vec3,
    pub angle: f64,
    pub vertical_angle: f64,
    pub focal_blur: Option<FocalBlur>,
    pub normal: Option<Shared<Normal>>,
    pub mesh: Option<MeshCamera>,
    pub user_defined: Option<UserDefinedCamera>,
}
