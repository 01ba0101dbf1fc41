//! Vectors, transforms, boxes and rays, in double precision.

mod bounds;
pub mod polynomial;
mod ray;
mod transform;
mod vec3;

pub use bounds::Bounds;
pub use ray::Ray;
pub use transform::Transform;
pub use vec3::{vec3, Vec3};
