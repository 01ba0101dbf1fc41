//! From a shape of the graph and its transform to a primitive and the place that it needs.

use std::collections::HashMap;
use std::sync::Arc;

use crate::graph;
use crate::math::{Transform, Vec3};
use crate::mesh::Mesh;
use crate::shape::{
    closed_curves, disc_frame, frame, segments, BicubicPatch, Blob, Cone, Cuboid, Disc, HeightField,
    Isosurface, JuliaFractal, Lathe, Lemon, Ovus, Parametric, Plane, Poly, Polygon, Prism, Quadric, Shape,
    Sor, Sphere, SphereSweep, Superellipsoid, Text, Torus, Triangle,
};
use crate::texture::Builder;

/// A primitive with the transform that could not be worked into it.
pub struct PlacedShape {
    pub shape: Shape,
    pub place: Option<Box<Transform>>,
}

/// Makes primitives; shapes that several objects share are made once.
pub struct Placer<'a> {
    patterns: &'a mut Builder,
    meshes: HashMap<usize, Arc<Mesh>>,
}

/// Factor and shift of a transform that is nothing else.
fn as_scaled_shift(t: &Transform) -> Option<f64> {
    let factor = t.rows[0].x;
    let plain = (0..3).all(|r| (0..3).all(|c| t.rows[r][c] == if r == c { factor } else { 0.0 }));
    (plain && factor > 0.0).then_some(factor)
}

impl<'a> Placer<'a> {
    /// With the builder that compiles the functions of isosurfaces.
    pub fn new(patterns: &'a mut Builder) -> Placer<'a> {
        Placer { patterns, meshes: HashMap::new() }
    }

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
                at(disc.into(), disc_frame(s.center, s.normal))
            }
            S::Torus(s) => {
                placed(Torus { major: s.major_radius, minor: s.minor_radius, spindle: s.spindle }.into())
            }
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
            S::Prism(s) => {
                let curves = closed_curves(s.spline, &s.points);
                let conic = s.sweep == graph::shapes::Sweep::Conic;
                let prism = Prism::new(curves, [s.height1, s.height2], conic, s.open);
                let bezier = s.spline == graph::shapes::SplineKind::Bezier;
                placed(Shape::Prism(Arc::new(if bezier { prism.reversed() } else { prism })))
            }
            S::Lathe(s) => placed(Shape::Lathe(Arc::new(Lathe::new(segments(s.spline, &s.points))))),
            S::Sor(s) => match Sor::new(&s.points, s.open) {
                Some(sor) => placed(Shape::Sor(Arc::new(sor))),
                None => Err("sor without a piece".into()),
            },
            S::Superellipsoid(s) => placed(Superellipsoid::new(s.e, s.n).into()),
            S::Blob(s) => placed(Shape::Blob(Arc::new(Blob::new(s)))),
            S::HeightField(s) => {
                let field = HeightField::new(&s.heights, s.columns, s.rows, s.water_level, s.smooth);
                placed(Shape::HeightField(Arc::new(field.ok_or("height_field without a cell")?)))
            }
            S::Text(s) => {
                let text = Text::new(&s.font, &s.text, s.thickness, s.offset)?;
                placed(Shape::Text(Arc::new(text)))
            }
            S::SphereSweep(s) => {
                placed(Shape::SphereSweep(Arc::new(SphereSweep::new(s.spline, &s.spheres, s.tolerance))))
            }
            S::BicubicPatch(s) => {
                let patch = BicubicPatch::new(s).ok_or("bicubic_patch without 16 points")?;
                placed(Shape::BicubicPatch(Arc::new(patch)))
            }
            S::Ovus(s) => placed(Shape::Ovus(Box::new(Ovus::new(s)))),
            S::Lemon(s) => {
                let length = (s.cap - s.base).length();
                let lemon = Lemon::new(s.base_radius, s.cap_radius, length, s.inner_radius, s.open);
                at(Shape::Lemon(Box::new(lemon)), frame(s.base, s.cap))
            }
            S::Parametric(s) => {
                let mut compiled = |i: usize| self.patterns.function(&s.functions[i]);
                let (Some(x), Some(y), Some(z)) = (compiled(0), compiled(1), compiled(2)) else {
                    return Err("parametric of such functions".into());
                };
                placed(Shape::Parametric(Arc::new(Parametric::new(s, [x, y, z]))))
            }
            S::Isosurface(s) => {
                let function = self.patterns.function(&s.function).ok_or("isosurface of such a function")?;
                placed(Shape::Isosurface(Arc::new(Isosurface::new(s, function))))
            }
            S::JuliaFractal(s) => {
                let fractal = JuliaFractal::new(s)
                    .ok_or("julia_fractal of an unknown function, or of what is no number")?;
                placed(Shape::JuliaFractal(Box::new(fractal)))
            }
            other => Err(other.name().to_lowercase()),
        }
    }
}
