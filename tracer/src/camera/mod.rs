//! SDL: `camera { ... }`: from picture coordinates to rays.

mod lens;
mod projection;

pub use lens::Lens;
use projection::Projection;

use crate::graph::camera as graph;
use crate::math::{vec3, Ray, Vec3};
use crate::pattern::SurfaceContext;
use crate::shade::Interiors;
use crate::texture::{Builder, Normal};

/// A camera made ready for rays.
#[derive(Clone, Debug)]
pub struct Camera {
    projection: Projection,
    /// Bumps that the rays are turned by, in the picture's plane.
    normal: Option<Normal>,
    /// Focal blur, if any.
    pub lens: Option<Lens>,
    /// The objects that the camera's place is in; none where rays start from several places.
    pub interiors: Option<Interiors>,
}

impl Camera {
    /// Prepares a camera; the name of what cannot be rendered comes with it.
    pub fn new(camera: &graph::Camera, patterns: &mut Builder) -> (Camera, Option<&'static str>) {
        let (projection, unsupported) = Projection::new(camera);
        let lens = camera.focal_blur.as_ref().map(|blur| {
            let bokeh = blur.bokeh.as_ref().map(|pigment| patterns.pigment(pigment));
            Lens::new(blur, camera, bokeh.as_ref())
        });
        let normal = camera.normal.as_ref().map(|normal| patterns.normal(normal));
        let fixed = lens.is_none() && projection.has_one_origin();
        (Camera { projection, normal, lens, interiors: fixed.then_some(Interiors::NONE) }, unsupported)
    }

    /// Where the rays start, as far as they share a place.
    pub fn location(&self) -> Vec3 {
        self.projection.location()
    }

    /// The ray through picture point (x, y), each 0 to 1 from the left and from the top; its direction has any length.
    /// `None` where the projection shows nothing.
    pub fn ray(&self, x: f64, y: f64) -> Option<Ray> {
        let (u, v) = (x - 0.5, 0.5 - y);
        let ray = self.projection.ray(u, v)?;
        Some(match &self.normal {
            None => ray,
            Some(bumps) => {
                let ahead = ray.direction.normalized();
                let [x, y] = self.projection.bump_place(u, v);
                let direction = bumps.perturb(vec3(x, y, 0.0), ahead, &SurfaceContext::NONE);
                Ray { direction, ..ray }
            }
        })
    }
}
