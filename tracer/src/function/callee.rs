//! What a call can call: everything that is a function without being an expression.

use super::internal::Internal;
use super::{Program, Spline};
use crate::math::{vec3, Transform, Vec3};
use crate::pattern::{Pattern, SurfaceContext};
use crate::texture::Pigment;

/// A function by kind.
#[derive(Clone, Debug)]
pub enum Callee {
    /// `function { EXPRESSION }`.
    Program(Program),
    /// `function { internal(N) }`.
    Internal(Internal),
    /// `function { pattern {...} }`.
    Pattern(Pattern),
    /// `function { pigment {...} }`.
    Pigment(Pigment),
    /// `function { transform {...} }`.
    Transform(Transform),
    /// `function { spline {...} }`.
    Spline(Spline),
}

/// The first three arguments as a point.
#[inline]
fn point(arguments: &[f64]) -> Vec3 {
    let at = |i: usize| arguments.get(i).copied().unwrap_or(0.0);
    vec3(at(0), at(1), at(2))
}

impl Callee {
    /// Whether a call may take long: a loop says how often it runs.
    pub fn loops(&self) -> bool {
        matches!(self, Callee::Program(program) if program.loops())
    }

    /// The value, or its first component.
    #[inline]
    pub fn value(&self, arguments: &[f64]) -> f64 {
        match self {
            Callee::Program(program) => program.value(arguments),
            Callee::Internal(internal) => internal.value(point(arguments), arguments.get(3..).unwrap_or(&[])),
            Callee::Pattern(pattern) => pattern.value(point(arguments), &SurfaceContext::NONE),
            _ => self.components(arguments)[0],
        }
    }

    /// All components of the value, filled up with zeros.
    pub fn components(&self, arguments: &[f64]) -> [f64; 5] {
        match self {
            Callee::Pigment(pigment) => {
                let c = pigment.color(point(arguments), &SurfaceContext::NONE);
                [c.rgb.r, c.rgb.g, c.rgb.b, c.filter, c.transmit]
            }
            Callee::Transform(transform) => {
                let p = transform.point(point(arguments));
                [p.x, p.y, p.z, 0.0, 0.0]
            }
            Callee::Spline(spline) => spline.point(arguments.first().copied().unwrap_or(0.0)),
            _ => [self.value(arguments), 0.0, 0.0, 0.0, 0.0],
        }
    }
}
