//! The core's textures against the values that POV-Ray gives.

mod data;
mod noise;
mod patterns;
mod pigments;
mod sdl;
