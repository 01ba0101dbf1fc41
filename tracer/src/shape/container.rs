//! SDL: `contained_by { sphere { 0, 1 } }`: the box or sphere outside of which a surface is not looked for.

use super::{Crossing, Cuboid, Primitive, Sphere};
use crate::graph::shapes as graph;
use crate::math::{Bounds, Ray, Vec3};

/// A box or a sphere around a surface.
#[derive(Clone, Debug)]
pub enum Container {
    /// `sphere { V, F }`.
    Sphere(Sphere),
    /// `box { V, V }`.
    Cuboid(Cuboid),
}

impl From<&graph::Container> for Container {
    fn from(container: &graph::Container) -> Container {
        match container {
            graph::Container::Sphere(s) => Container::Sphere(Sphere { center: s.center, radius: s.radius }),
            graph::Container::Box(b) => Container::Cuboid(Cuboid::new(b.corner1, b.corner2)),
        }
    }
}

impl Container {
    /// Where the line of a ray enters and leaves.
    #[inline]
    pub fn span(&self, ray: &Ray) -> Option<[Crossing; 2]> {
        match self {
            Container::Sphere(sphere) => sphere.span(ray),
            Container::Cuboid(cuboid) => cuboid.span(ray),
        }
    }

    /// The box around it.
    pub fn bounds(&self) -> Bounds {
        match self {
            Container::Sphere(sphere) => sphere.bounds(),
            Container::Cuboid(cuboid) => cuboid.bounds(),
        }
    }

    /// Whether it holds a point.
    pub fn inside(&self, point: Vec3) -> bool {
        match self {
            Container::Sphere(sphere) => sphere.inside(point),
            Container::Cuboid(cuboid) => cuboid.inside(point),
        }
    }

    /// Its outward normal.
    pub fn normal(&self, point: Vec3, crossing: &Crossing) -> Vec3 {
        match self {
            Container::Sphere(sphere) => sphere.normal(point, crossing),
            Container::Cuboid(cuboid) => cuboid.normal(point, crossing),
        }
    }
}
