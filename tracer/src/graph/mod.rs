//! Mirrors of the Python dataclasses of the scene graph, field by field; `prepare` turns them into what is rendered.

#[macro_use]
mod class_name;
pub mod atmosphere;
pub mod camera;
pub mod finish;
#[cfg(feature = "python")]
mod from_python;
pub mod function;
pub mod image;
pub mod interior;
pub mod light;
#[cfg(feature = "python")]
pub(crate) mod nesting;
pub mod normal;
pub mod objects;
pub mod pattern;
pub mod pigment;
pub mod scene;
pub mod settings;
pub mod shapes;
mod shared;
pub mod texture;
mod values;
pub mod warp;

pub use function::Function;
pub use interior::Interior;
pub use light::LightSource;
pub use objects::{Modifiers, Object, PhotonBehaviour, Shape};
pub use shared::{Shared, Unsupported};
pub use texture::Texture;
pub use values::{Vec2, Vec4};

#[cfg(feature = "python")]
pub use from_python::{collect_unsupported, report_unsupported};

/// What a thread needs as stack to walk the deepest graph that is allowed (`nesting`).
pub const STACK_BYTES: usize = 256 << 20;
