//! SDL: `camera { ... }`: from picture coordinates to rays.

mod lens;
mod projection;

pub use lens::Lens;
use projection::Projection;

use crate::graph::camera as graph;
use crate::math::{Ray, Vec3};
use crate::shade::Interiors;
use crate::texture::Pigment;

/// A camera made ready for rays.
#[derive(Clone, Debug)]
pub struct Camera {
    projection: Projection,
    /// Focal blur, if any.
    pub lens: Option<Lens>,
    /// The objects that the camera's place is in; none where rays start from several places.
    pub interiors: Option<Interiors>,
}

impl Camera {
    /// Prepares a camera; the name of what cannot be rendered comes with it. The pigment is that of `bokeh`.
    pub fn new(camera: &graph::Camera, bokeh: Option<&Pigment>) -> (Camera, Option<&'static str>) {
        let (projection, unsupported) = Projection::new(camera);
        let lens = camera.focal_blur.as_ref().map(|blur| Lens::new(blur, camera, bokeh));
        let fixed = lens.is_none() && projection.has_one_origin();
        (Camera { projection, lens, interiors: fixed.then_some(Interiors::NONE) }, unsupported)
    }

    /// Where the rays start, as far as they share a place.
    pub fn location(&self) -> Vec3 {
        self.projection.location()
    }

    /// The ray through picture point (x, y), each 0 to 1 from the left and from the top; its direction has any length.
    /// `None` where the projection shows nothing.
    pub fn ray(&self, x: f64, y: f64) -> Option<Ray> {
        self.projection.ray(x - 0.5, 0.5 - y)
    }
}
