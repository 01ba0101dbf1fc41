//! Mirrors of the Python dataclasses of the scene graph, field by field; `prepare` turns them into what is rendered.

#[macro_use]
mod class_name;
pub mod finish;
#[cfg(feature = "python")]
mod from_python;
mod shared;

pub use shared::{Shared, Unsupported};

#[cfg(feature = "python")]
pub use from_python::{collect_unsupported, report_unsupported};
