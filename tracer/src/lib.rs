//! The ray tracing core of minipov: a scene graph in, linear colour out.
#![warn(missing_docs)]
#![deny(unsafe_code)]

pub mod accel;
pub mod atmosphere;
pub mod camera;
pub mod color;
pub mod csg;
pub mod function;
pub mod geometry;
pub mod graph;
pub mod image;
pub mod light;
pub mod math;
pub mod media;
pub mod mesh;
pub mod noise;
pub mod pattern;
pub mod photon;
pub mod prepare;
pub mod radiosity;
pub mod render;
pub mod shade;
pub mod shape;
pub mod subsurface;
#[cfg(test)]
mod testing;
pub mod texture;
pub mod warp;

#[cfg(feature = "python")]
mod python;
