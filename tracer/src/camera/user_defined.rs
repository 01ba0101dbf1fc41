//! SDL (3.8): `camera { user_defined location { function {..} function {..} function {..} } direction { ... } }`.
//!
//! Functions of picture coordinates, each from -0.5 to 0.5 to the right and up, give where each ray starts and where it
//! goes.

use crate::function::Function;
use crate::graph::camera as graph;
use crate::graph::{function as nodes, Shared};
use crate::math::{vec3, Ray, Transform, Vec3};
use crate::texture::Builder;

/// The laws of a user_defined camera's rays.
#[derive(Clone, Debug)]
pub struct FunctionRays {
    location: Law,
    direction: Law,
    /// Where the camera's transforms carry what the functions give.
    place: Transform,
}

/// A vector that may depend on the point of the picture.
#[derive(Clone, Debug)]
enum Law {
    Fixed(Vec3),
    Functions([Function; 3]),
}

impl FunctionRays {
    /// Compiles the functions; what has none is the camera's vector.
    pub fn new(camera: &graph::Camera, patterns: &mut Builder) -> FunctionRays {
        let laws = camera.user_defined.as_ref();
        let mut law = |functions: Option<&[Shared<nodes::Function>; 3]>, otherwise| {
            let compiled = functions.and_then(|[x, y, z]| {
                Some([patterns.function(x)?, patterns.function(y)?, patterns.function(z)?])
            });
            compiled.map_or(Law::Fixed(otherwise), Law::Functions)
        };
        FunctionRays {
            location: law(laws.and_then(|laws| laws.location.as_ref()), camera.location),
            direction: law(laws.and_then(|laws| laws.direction.as_ref()), camera.direction),
            place: laws.map_or(Transform::IDENTITY, |laws| laws.transform),
        }
    }

    /// Whether all rays start at the camera's place.
    pub fn has_one_origin(&self) -> bool {
        matches!(self.location, Law::Fixed(_))
    }

    /// The ray through (u, v); `None` where the functions give none.
    pub fn ray(&self, u: f64, v: f64) -> Option<Ray> {
        let ray = Ray {
            origin: self.location.at(u, v, |place| self.place.point(place)),
            direction: self.direction.at(u, v, |direction| self.place.direction(direction)),
        };
        let sound = |v: Vec3| v.length_squared().is_finite();
        (sound(ray.origin) && sound(ray.direction) && ray.direction != Vec3::ZERO).then_some(ray)
    }
}

impl Law {
    /// The vector for (u, v); what functions give is still to be `carried` to its place.
    fn at(&self, u: f64, v: f64, carried: impl Fn(Vec3) -> Vec3) -> Vec3 {
        match self {
            Law::Fixed(vector) => *vector,
            Law::Functions([x, y, z]) => {
                let at = |function: &Function| function.value(&[u, v]);
                carried(vec3(at(x), at(y), at(z)))
            }
        }
    }
}
