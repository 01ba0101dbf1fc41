//! SDL: `function (a, b) { sin(a)*b }`, `function { pattern {...} }`, `f_torus(x, y, z, 1, 0.3)`: functions of numbers.
//!
//! Expressions become a [`Program`]: a straight list of steps over numbered registers, in which equal parts are computed
//! once and called functions are worked in. All arithmetic is that of IEEE doubles, without errors: 1/0 is infinite.

mod builder;
mod callee;
mod compile;
mod internal;
mod operators;
pub mod patience;
mod program;
mod registers;
mod spline;
#[cfg(test)]
mod tests;

pub use callee::Callee;
pub use program::Program;
pub use spline::Spline;

use std::sync::Arc;

use crate::math::Vec3;

/// A function ready to be called; cheap to clone.
#[derive(Clone, Debug)]
pub struct Function {
    callee: Arc<Callee>,
    size: usize,
}

impl Function {
    /// How many components its value has, 1..=5.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Whether a call may take long.
    pub fn loops(&self) -> bool {
        self.callee.loops()
    }

    /// The value; components that it has not are 0. Missing arguments are 0.
    pub fn components(&self, arguments: &[f64]) -> [f64; 5] {
        self.callee.components(arguments)
    }

    /// The value, or its first component.
    #[inline]
    pub fn value(&self, arguments: &[f64]) -> f64 {
        self.callee.value(arguments)
    }

    /// The value at a point.
    #[inline]
    pub fn at(&self, p: Vec3) -> f64 {
        self.callee.value(&[p.x, p.y, p.z])
    }
}
