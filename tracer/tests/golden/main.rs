//! The core's textures against the values that POV-Ray gives.

mod data;
mod functions;
mod noise;
mod patterns;
mod pigments;
mod sdl;
