//! SDL: `pigment { ... }`: mirror of `minipov.tracer.pigment`.
#![allow(missing_docs)] // the fields are documented where they are mirrored from

use super::pattern::{Pattern, PatternModifiers};
use super::{Function, Shared};
use crate::color::Rgbft;

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct ColorMap {
    pub entries: Vec<(f64, Rgbft)>,
    pub blend_mode: u8,
    pub blend_gamma: f64,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct PigmentMap {
    pub entries: Vec<(f64, Shared<Pigment>)>,
    pub blend_mode: u8,
    pub blend_gamma: f64,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct PigmentList {
    pub pigments: Vec<Shared<Pigment>>,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct UserDefinedPigment {
    pub functions: Vec<Option<Shared<Function>>>,
}

/// What the pattern's value looks up.
#[derive(Clone, Debug)]
pub enum PigmentBlend {
    Colors(ColorMap),
    Pigments(PigmentMap),
    List(PigmentList),
    UserDefined(UserDefinedPigment),
}

from_class_name!(PigmentBlend {
    ColorMap => Colors,
    PigmentMap => Pigments,
    PigmentList => List,
    UserDefinedPigment => UserDefined,
});

/// A colour at every point of space.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Pigment {
    pub color: Rgbft,
    pub pattern: Option<Pattern>,
    pub blend: Option<PigmentBlend>,
    pub modifiers: Shared<PatternModifiers>,
    pub quick_color: Option<Rgbft>,
}
