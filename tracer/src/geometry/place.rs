//! From a shape of the graph and its transform to a primitive and the place that it needs.

use crate::graph;
use crate::math::Transform;
use crate::shape::{Cuboid, Plane, Shape, Sphere};

/// A primitive with the transform that could not be worked into it.
pub struct PlacedShape {
    pub shape: Shape,
    pub place: Option<Box<Transform>>,
}

/// Makes primitives; shapes that several objects share are made once.
#[derive(Default)]
pub struct Placer {}

/// Factor and shift of a transform that is nothing else.
fn as_scaled_shift(t: &Transform) -> Option<f64> {
    let factor = t.rows[0].x;
    let plain = (0..3).all(|r| (0..3).all(|c| t.rows[r][c] == if r == c { factor } else { 0.0 }));
    (plain && factor > 0.0).then_some(factor)
}

impl Placer {
    /// The primitive for a shape, or the name of what is missing.
    pub fn place(&mut self, shape: &graph::Shape, to_world: &Transform) -> Result<PlacedShape, String> {
        use graph::Shape as S;
        let inline = |shape: Shape| Ok(PlacedShape { shape, place: None });
        let placed = |shape: Shape| {
            let place = (!to_world.is_identity()).then(|| Box::new(*to_world));
            Ok(PlacedShape { shape, place })
        };
        match shape {
            S::Sphere(s) => match as_scaled_shift(to_world) {
                Some(factor) => {
                    inline(Sphere { center: to_world.point(s.center), radius: s.radius * factor }.into())
                }
                None => placed(Sphere { center: s.center, radius: s.radius }.into()),
            },
            S::Box(s) => match as_scaled_shift(to_world) {
                Some(_) => inline(Cuboid::new(to_world.point(s.corner1), to_world.point(s.corner2)).into()),
                None => placed(Cuboid::new(s.corner1, s.corner2).into()),
            },
            S::Plane(s) => {
                let on_plane = to_world.point(s.normal.normalized() * s.distance);
                let normal = to_world.normal(s.normal).normalized();
                inline(Plane::new(normal, normal.dot(on_plane)).into())
            }
            other => Err(other.name().to_lowercase()),
        }
    }
}
