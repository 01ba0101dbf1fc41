//! SDL: `camera { perspective | orthographic | fisheye | ... }`.

use crate::graph::camera::{Camera, CameraKind};
use crate::math::{Ray, Vec3};

/// The frame of a camera and the law of its rays.
#[derive(Clone, Debug)]
pub struct Projection {
    kind: CameraKind,
    location: Vec3,
    direction: Vec3,
    right: Vec3,
    up: Vec3,
}

impl Projection {
    /// Prepares a camera; kinds not written yet become perspective and are named.
    pub fn new(camera: &Camera) -> (Projection, Option<&'static str>) {
        let Camera { kind, location, direction, right, up, .. } = *camera;
        let unsupported = match kind {
            CameraKind::Perspective | CameraKind::Orthographic => None,
            _ => Some("camera type"),
        };
        (Projection { kind, location, direction, right, up }, unsupported)
    }

    /// The camera's place.
    pub fn location(&self) -> Vec3 {
        self.location
    }

    /// The ray through (u, v), each from -0.5 to 0.5, to the right and up; any length.
    pub fn ray(&self, u: f64, v: f64) -> Option<Ray> {
        let across = self.right * u + self.up * v;
        Some(match self.kind {
            CameraKind::Orthographic => Ray { origin: self.location + across, direction: self.direction },
            _ => Ray { origin: self.location, direction: self.direction + across },
        })
    }
}
