//! Mirrors of the Python dataclasses of the scene graph, field by field; `prepare` turns them into what is rendered.

#[macro_use]
mod class_name;
pub mod finish;
#[cfg(feature = "python")]
mod from_python;
pub mod objects;
mod pending;
pub mod shapes;
mod shared;
mod values;

pub use objects::{Modifiers, Object, PhotonBehaviour, Shape};
pub use pending::{Function, Interior, LightSource, Texture};
pub use shared::{Shared, Unsupported};
pub use values::{Vec2, Vec4};

#[cfg(feature = "python")]
pub use from_python::{collect_unsupported, report_unsupported};
