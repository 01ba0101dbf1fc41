//! SDL: `function { ... }` and `spline { ... }`: mirror of `minipov.tracer.function`.
#![allow(missing_docs)] // the fields are documented where they are mirrored from

use super::pattern::{Pattern, PatternModifiers};
use super::pigment::Pigment;
use super::values::keywords;
use super::Shared;
use crate::math::Transform;

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Constant {
    pub value: f64,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Parameter {
    pub index: usize,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Operation {
    pub operator: String,
    pub operands: Vec<Expression>,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Call {
    pub function: Shared<Function>,
    pub arguments: Vec<Expression>,
    pub component: Option<usize>,
}

keywords!(
    /// How the terms of a loop are joined.
    AccumulateKind { Sum = "sum", Product = "prod" }
);

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Accumulate {
    pub operator: AccumulateKind,
    pub index: usize,
    pub first: Expression,
    pub last: Expression,
    pub body: Expression,
}

#[derive(Clone, Debug)]
pub enum Expression {
    Constant(Constant),
    Parameter(Parameter),
    Operation(Operation),
    Call(Call),
    Accumulate(Shared<Accumulate>),
}

from_class_name!(Expression {
    Constant => Constant,
    Parameter => Parameter,
    Operation => Operation,
    Call => Call,
    Accumulate => Accumulate,
});

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct ExpressionFunction {
    pub parameters: Vec<String>,
    pub body: Expression,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct InternalFunction {
    pub number: u32,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct PatternFunction {
    pub pattern: Pattern,
    pub modifiers: PatternModifiers,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct PigmentFunction {
    pub pigment: Shared<Pigment>,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct TransformFunction {
    pub transform: Transform,
}

keywords!(
    /// The curve between a spline's points.
    SplineKind {
        Linear = "linear_spline",
        Quadratic = "quadratic_spline",
        Cubic = "cubic_spline",
        Natural = "natural_spline",
    }
);

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Spline {
    pub kind: SplineKind,
    pub points: Vec<(f64, [f64; 5])>,
    pub size: usize,
}

#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct SplineFunction {
    pub spline: Shared<Spline>,
}

#[derive(Clone, Debug)]
pub enum Function {
    Expression(ExpressionFunction),
    Internal(InternalFunction),
    Pattern(PatternFunction),
    Pigment(PigmentFunction),
    Transform(TransformFunction),
    Spline(SplineFunction),
}

from_class_name!(Function {
    ExpressionFunction => Expression,
    InternalFunction => Internal,
    PatternFunction => Pattern,
    PigmentFunction => Pigment,
    TransformFunction => Transform,
    SplineFunction => Spline,
});
