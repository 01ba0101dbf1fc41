//! SDL: `pigment {...}`, `normal {...}` and the maps they look colours and slopes up in.

mod builder;
mod color_map;
mod default_map;
mod normal;
mod pigment;

pub use builder::Builder;
pub use color_map::{BlendMap, ColorMap};
pub use normal::Normal;
pub use pigment::Pigment;
