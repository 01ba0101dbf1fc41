//! A whole scene: mirror of `minipov.tracer.scene`.
#![allow(missing_docs)] // the fields are documented where they are mirrored from

use super::atmosphere::{Fog, Rainbow, SkySphere};
use super::camera::Camera;
use super::interior::Media;
use super::light::LightSource;
use super::settings::GlobalSettings;
use super::texture::Texture;
use super::{Object, Shared};
use crate::color::Rgbft;

/// What the interpreter makes and the core renders.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Scene {
    pub objects: Vec<Object>,
    pub lights: Vec<Shared<LightSource>>,
    pub camera: Camera,
    pub background: Rgbft,
    pub fogs: Vec<Fog>,
    pub rainbows: Vec<Rainbow>,
    pub sky_sphere: Option<SkySphere>,
    pub media: Vec<Shared<Media>>,
    pub settings: GlobalSettings,
    pub default_texture: Shared<Texture>,
    pub version: f64,
}
