//! SDL: `camera { ... }`: from picture coordinates to rays.

mod projection;

use projection::Projection;

use crate::accel::RayKind;
use crate::graph::camera as graph;
use crate::math::{Ray, Vec3};
use crate::shade::{Interiors, Path};

/// A camera made ready for rays.
#[derive(Clone, Debug)]
pub struct Camera {
    projection: Projection,
    /// The objects that the camera stands in.
    pub interiors: Interiors,
}

impl Camera {
    /// Prepares a camera; the name of what cannot be rendered comes with it.
    pub fn new(camera: &graph::Camera) -> (Camera, Option<&'static str>) {
        let (projection, unsupported) = Projection::new(camera);
        (Camera { projection, interiors: Interiors::NONE }, unsupported)
    }

    /// Where the rays start, as far as they share a place.
    pub fn location(&self) -> Vec3 {
        self.projection.location()
    }

    /// The ray through picture point (x, y), each 0 to 1 from the left and from the top.
    /// `None` where the projection shows nothing.
    pub fn path(&self, x: f64, y: f64) -> Option<Path> {
        let Ray { origin, direction } = self.projection.ray(x - 0.5, 0.5 - y)?;
        let ray = Ray { origin, direction: direction.normalized() };
        Some(Path { ray, interiors: self.interiors, kind: RayKind::Camera, band: None })
    }
}
