//! SDL: `texture { ... }`, layers, `texture_map`, `material_map`: mirror of `minipov.tracer.texture`.
#![allow(missing_docs)] // the fields are documented where they are mirrored from

use super::finish::Finish;
use super::image::ImageMapping;
use super::normal::Normal;
use super::pattern::{Pattern, PatternModifiers};
use super::pigment::Pigment;
use super::Shared;

/// One pigment, normal and finish.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct PlainTexture {
    pub pigment: Shared<Pigment>,
    pub normal: Option<Shared<Normal>>,
    pub finish: Shared<Finish>,
}

/// Textures on top of each other, the lowest first.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct LayeredTexture {
    pub layers: Vec<PlainTexture>,
}

/// `texture_map { [F texture] ... }`.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct TextureMap {
    pub entries: Vec<(f64, Shared<Texture>)>,
}

/// The textures of a block pattern.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct TextureList {
    pub textures: Vec<Shared<Texture>>,
}

/// What the pattern's value chooses from.
#[derive(Clone, Debug)]
pub enum TextureBlend {
    Map(TextureMap),
    List(TextureList),
}

from_class_name!(TextureBlend { TextureMap => Map, TextureList => List });

/// A pattern chooses between or mixes whole textures.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct PatternTexture {
    pub pattern: Pattern,
    pub blend: TextureBlend,
    pub modifiers: PatternModifiers,
}

/// `material_map { ... }`.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct MaterialMap {
    pub mapping: ImageMapping,
    pub textures: Vec<Shared<Texture>>,
    pub modifiers: PatternModifiers,
}

/// Any texture.
#[derive(Clone, Debug)]
pub enum Texture {
    Plain(PlainTexture),
    Layered(LayeredTexture),
    Pattern(PatternTexture),
    MaterialMap(MaterialMap),
}

from_class_name!(Texture {
    PlainTexture => Plain,
    LayeredTexture => Layered,
    PatternTexture => Pattern,
    MaterialMap => MaterialMap,
});
