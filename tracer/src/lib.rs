//! The ray tracing core of minipov: a scene graph in, linear colour out.
#![warn(missing_docs)]

pub mod color;
pub mod graph;
pub mod math;

#[cfg(feature = "python")]
mod python;
