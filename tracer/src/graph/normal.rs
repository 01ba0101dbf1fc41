//! SDL: `normal { ... }`: mirror of `minipov.tracer.normal`.
#![allow(missing_docs)] // the fields are documented where they are mirrored from

use super::pattern::{Pattern, PatternModifiers};
use super::{Shared, Vec2};

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct SlopeMap {
    pub entries: Vec<(f64, Vec2)>,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct NormalMap {
    pub entries: Vec<(f64, Shared<Normal>)>,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct NormalList {
    pub normals: Vec<Option<Shared<Normal>>>,
}

/// What the pattern's value looks up.
#[derive(Clone, Debug)]
pub enum NormalBlend {
    Slopes(SlopeMap),
    Normals(NormalMap),
    List(NormalList),
}

from_class_name!(NormalBlend { SlopeMap => Slopes, NormalMap => Normals, NormalList => List });

/// A perturbation of the surface normal.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Normal {
    pub pattern: Option<Pattern>,
    pub amount: f64,
    pub blend: Option<NormalBlend>,
    pub modifiers: Shared<PatternModifiers>,
    pub accuracy: f64,
    pub no_bump_scale: bool,
}
