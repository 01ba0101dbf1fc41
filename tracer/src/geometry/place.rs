//! From a shape of the graph and its transform to a primitive and the place that it needs.

use std::collections::HashMap;
use std::sync::Arc;

use crate::graph;
use crate::math::{Transform, Vec3};
use crate::mesh::Mesh;
use crate::shape::{
    frame, Cone, Cuboid, Disc, Plane, Poly, Polygon, Quadric, Shape, Sphere, Torus, Triangle,
};

/// A primitive with the transform that could not be worked into it.
pub struct PlacedShape {
    pub shape: Shape,
    pub place: Option<Box<Transform>>,
}

/// Makes primitives; shapes that several objects share are made once.
#[derive(Default)]
pub struct Placer {
    meshes: HashMap<usize, Arc<Mesh>>,
}

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
        let at = |shape: Shape, frame: Option<Transform>| {
            let frame = frame.ok_or("shape without a direction")?;
            Ok(PlacedShape { shape, place: Some(Box::new(frame.then(to_world))) })
        };
        let column = |base: Vec3, cap: Vec3, base_radius, cap_radius, open| {
            at(Cone::new(base_radius, cap_radius, (cap - base).length(), open).into(), frame(base, cap))
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
            S::Cylinder(s) => column(s.base, s.cap, s.radius, s.radius, s.open),
            S::Cone(s) => column(s.base, s.cap, s.base_radius, s.cap_radius, s.open),
            S::Disc(s) => {
                let disc = Disc { radius: s.radius, hole_radius: s.hole_radius };
                at(disc.into(), frame(s.center, s.center + s.normal))
            }
            S::Torus(s) => placed(Torus { major: s.major_radius, minor: s.minor_radius }.into()),
            S::Quadric(s) => placed(Shape::Quadric(Box::new(Quadric {
                squares: s.squares,
                mixed: s.mixed,
                linear: s.linear,
                constant: s.constant,
            }))),
            S::Poly(s) => placed(Shape::Poly(Arc::new(Poly::new(s.order, &s.coefficients)))),
            S::Triangle(s) => inline(Shape::Triangle(Box::new(Triangle::flat([s.a, s.b, s.c], to_world)))),
            S::SmoothTriangle(s) => {
                let normals = [s.normal_a, s.normal_b, s.normal_c];
                inline(Shape::Triangle(Box::new(Triangle::smooth([s.a, s.b, s.c], normals, to_world))))
            }
            S::Polygon(s) => match Polygon::new(&s.points, to_world) {
                Some(polygon) => inline(Shape::Polygon(Box::new(polygon))),
                None => Err("degenerate polygon".into()),
            },
            S::Mesh(s) => {
                let mesh = self.meshes.entry(s.address()).or_insert_with(|| Arc::new(Mesh::new(s)));
                placed(Shape::Mesh(mesh.clone()))
            }
            other => Err(other.name().to_lowercase()),
        }
    }
}
