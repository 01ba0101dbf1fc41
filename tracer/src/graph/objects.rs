//! SDL: objects in space: mirror of `minipov.tracer.objects`, which documents the fields.
#![allow(missing_docs)] // the fields are documented where they are mirrored from

use super::shapes::*;
use super::{Interior, LightSource, Shared, Texture};
use crate::math::Transform;

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Union {
    pub children: Vec<Object>,
    pub lights: Vec<Shared<LightSource>>,
    pub split_union: bool,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Merge {
    pub children: Vec<Object>,
    pub lights: Vec<Shared<LightSource>>,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Intersection {
    pub children: Vec<Object>,
    pub lights: Vec<Shared<LightSource>>,
    pub cutaway_textures: bool,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct LightGroup {
    pub children: Vec<Object>,
    pub lights: Vec<Shared<LightSource>>,
    pub global_lights: bool,
}

#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct PhotonBehaviour {
    pub target: Option<f64>,
    pub reflection: Option<bool>,
    pub refraction: Option<bool>,
    pub collect: bool,
    pub pass_through: bool,
}

#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Modifiers {
    pub inverse: bool,
    pub hollow: Option<bool>,
    pub no_shadow: bool,
    pub no_image: bool,
    pub no_reflection: bool,
    pub no_radiosity: bool,
    pub double_illuminate: Option<bool>,
    pub uv_mapping: bool,
    pub photons: Option<PhotonBehaviour>,
    pub radiosity_importance: Option<f64>,
    pub clipped_by: Vec<Object>,
    pub bounded_by: Vec<Object>,
}

/// One placed shape with all that it wears. `modifiers` is shared because most objects have the same.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Object {
    pub shape: Shape,
    pub transform: Transform,
    pub texture: Option<Shared<Texture>>,
    pub interior_texture: Option<Shared<Texture>>,
    pub interior: Option<Shared<Interior>>,
    pub modifiers: Shared<Modifiers>,
    pub source: String,
}

impl Object {
    /// A shape as it stands, without a texture.
    pub fn new(shape: impl Into<Shape>) -> Object {
        Object {
            shape: shape.into(),
            transform: Transform::IDENTITY,
            texture: None,
            interior_texture: None,
            interior: None,
            modifiers: Shared::new(Modifiers::default()),
            source: String::new(),
        }
    }

    /// The same shape, placed.
    pub fn placed(mut self, transform: Transform) -> Object {
        self.transform = self.transform.then(&transform);
        self
    }

    /// The same object with other modifiers.
    pub fn modified(mut self, modifiers: Modifiers) -> Object {
        self.modifiers = Shared::new(modifiers);
        self
    }
}

/// Declares the enum of shapes, its conversions, and the choice by Python class name. Large shapes are shared.
macro_rules! shapes {
    (plain: $($plain:ident),*; shared: $($shared:ident),* $(,)?) => {
        /// Any shape.
        #[derive(Clone, Debug)]
        pub enum Shape {
            $($plain($plain),)*
            $($shared(Shared<$shared>),)*
        }

        impl Shape {
            /// The class's name.
            pub fn name(&self) -> &'static str {
                match self {
                    $(Shape::$plain(_) => stringify!($plain),)*
                    $(Shape::$shared(_) => stringify!($shared),)*
                }
            }
        }

        $(impl From<$plain> for Shape {
            fn from(shape: $plain) -> Shape { Shape::$plain(shape) }
        })*
        $(impl From<$shared> for Shape {
            fn from(shape: $shared) -> Shape { Shape::$shared(Shared::new(shape)) }
        })*

        from_class_name!(Shape { $($plain => $plain,)* $($shared => $shared,)* });
    };
}

shapes! {
    plain: Sphere, Box, Cylinder, Cone, Plane, Disc, Torus, Triangle, Superellipsoid;
    shared: SmoothTriangle, Quadric, Poly, Polygon, Mesh, BicubicPatch, Blob, HeightField, Isosurface, Parametric,
        JuliaFractal, Lathe, Lemon, Ovus, Prism, SphereSweep, Sor, Text, Union, Merge, Intersection, LightGroup,
}
