//! SDL: `pigment {...}`, `normal {...}` and the maps they look colours and slopes up in.

mod build_normal;
mod builder;
mod bumps;
mod color_map;
mod default_map;
mod image_map;
mod normal;
mod pigment;
mod slope_map;

pub use builder::Builder;
pub use color_map::{BlendMap, ColorMap};
pub use image_map::ImageMap;
pub use normal::Normal;
pub use pigment::Pigment;
