//! SDL: `camera { ... }`: from picture coordinates to rays.

mod face_map;
mod faces;
mod lens;
mod projection;
mod user_defined;

use faces::FaceRays;
pub use lens::Lens;
use projection::Projection;
use user_defined::FunctionRays;

use crate::graph::camera as graph;
use crate::math::{vec3, Ray, Vec3};
use crate::pattern::SurfaceContext;
use crate::shade::Interiors;
use crate::texture::{Builder, Normal};

/// The size of the whole picture, in pixels.
#[derive(Clone, Copy, Debug)]
pub struct Size {
    /// Pixels per row.
    pub width: usize,
    /// Number of rows.
    pub height: usize,
}

/// A camera made ready for rays.
#[derive(Clone, Debug)]
pub struct Camera {
    projection: Projection,
    law: Law,
    /// Bumps that the rays are turned by, in the picture's plane.
    normal: Option<Normal>,
    /// Focal blur, if any.
    pub lens: Option<Lens>,
    /// The objects that the camera's place is in; none where rays start from several places.
    pub interiors: Option<Interiors>,
}

/// Where rays come from.
#[derive(Clone, Debug)]
enum Law {
    /// The camera's frame.
    Projection,
    /// The faces of meshes.
    Faces(FaceRays),
    /// Functions.
    Functions(FunctionRays),
}

impl Camera {
    /// Prepares a camera.
    pub fn new(camera: &graph::Camera, patterns: &mut Builder) -> Camera {
        let projection = Projection::new(camera);
        let law = match (camera.kind, &camera.mesh) {
            (graph::CameraKind::MeshCamera, Some(mesh)) => Law::Faces(FaceRays::new(mesh, camera)),
            (graph::CameraKind::UserDefined, _) => Law::Functions(FunctionRays::new(camera, patterns)),
            _ => Law::Projection,
        };
        let lens = camera.focal_blur.as_ref().map(|blur| {
            let bokeh = blur.bokeh.as_ref().map(|pigment| patterns.pigment(pigment));
            Lens::new(blur, camera, bokeh.as_ref())
        });
        let normal = camera.normal.as_ref().map(|normal| patterns.normal(normal));
        let has_one_origin = match &law {
            Law::Projection => projection.has_one_origin(),
            Law::Faces(_) => false,
            Law::Functions(functions) => functions.has_one_origin(),
        };
        let fixed = lens.is_none() && has_one_origin;
        Camera { projection, law, normal, lens, interiors: fixed.then_some(Interiors::NONE) }
    }

    /// Where the rays start, as far as they share a place.
    pub fn location(&self) -> Vec3 {
        self.projection.location()
    }

    /// How many rays every point of the picture gets.
    pub fn rays_per_pixel(&self) -> usize {
        match &self.law {
            Law::Faces(faces) => faces.rays_per_pixel,
            _ => 1,
        }
    }

    /// How far the rays see.
    pub fn reach(&self) -> f64 {
        match &self.law {
            Law::Faces(faces) => faces.reach,
            _ => f64::INFINITY,
        }
    }

    /// A ray through picture point (x, y), in pixels from the left and from the top; its direction has any length.
    /// `None` where the camera shows nothing.
    pub fn ray(&self, x: f64, y: f64, size: Size, number: usize) -> Option<Ray> {
        let (u, v) = (x / size.width as f64 - 0.5, 0.5 - y / size.height as f64);
        let ray = match &self.law {
            Law::Projection => self.projection.ray(u, v),
            Law::Faces(faces) => faces.ray(x, y, size, number),
            Law::Functions(functions) => functions.ray(u, v),
        }?;
        Some(match &self.normal {
            None => ray,
            Some(bumps) => {
                let ahead = ray.direction.normalized();
                let [x, y] = match &self.law {
                    Law::Faces(_) => [0.0; 2],
                    _ => self.projection.bump_place(u, v),
                };
                let direction = bumps.perturb(vec3(x, y, 0.0), ahead, &SurfaceContext::NONE);
                Ray { direction, ..ray }
            }
        })
    }
}
