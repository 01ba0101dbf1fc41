//! SDL: `trace(object, point, direction)`, `inside(object, point)`, `min_extent(object)`, `max_extent(object)`.

use super::{prepare, Geometry};
use crate::accel::{AcceleratorKind, Counters, RayKind};
use crate::graph::Object;
use crate::math::{Bounds, Ray, Vec3};
use crate::texture::Builder;

/// Nearer than this, and farther than that, nothing is found.
const NEAR: f64 = 1e-4;
const FAR: f64 = 1e7;
/// What POV-Ray gives as the extent of the infinite.
const HUGE: f64 = 1e10;

/// One object that the scene itself asks about while it is read.
#[derive(Debug)]
pub struct Questioned {
    geometry: Geometry,
}

impl Questioned {
    /// Makes an object ready for questions.
    pub fn new(object: &Object) -> Questioned {
        let (geometry, _) =
            prepare(std::slice::from_ref(object), AcceleratorKind::Octree, &mut Builder::default());
        Questioned { geometry }
    }

    /// The first point of the surface along a ray, and its normal.
    pub fn trace(&self, origin: Vec3, direction: Vec3) -> Option<(Vec3, Vec3)> {
        let ray = Ray { origin, direction: direction.normalized() };
        let hit = self.geometry.nearest(&ray, NEAR, FAR, RayKind::Question, &mut Counters::default())?;
        let surface = self.geometry.surface(&ray, &hit);
        Some((surface.point, surface.normal))
    }

    /// Whether a point lies inside.
    pub fn inside(&self, point: Vec3) -> bool {
        self.geometry.top().any(|node| self.geometry.inside(point, node))
    }

    /// The box around it, in single precision as in POV-Ray.
    pub fn extents(&self) -> Bounds {
        let all = self.geometry.top().map(|id| {
            let node = self.geometry.node(id);
            // What is infinite in one direction is so in all, for POV-Ray, unless bounds are given.
            let own = node.extent.surface;
            let own = if own.is_finite() { own } else { Bounds::INFINITE };
            let bounds = node.bounded_by.iter().map(|&bound| self.geometry.node(bound).extent.surface);
            bounds.filter(Bounds::is_finite).fold(own, |all, bound| all.intersection(&bound))
        });
        let bounds = all.fold(Bounds::EMPTY, |sum, b| sum.union(&b));
        let printed = |v: f64, infinite: f64| if v.abs() < HUGE { f64::from(v as f32) } else { infinite };
        Bounds { min: bounds.min.map(|v| printed(v, -HUGE)), max: bounds.max.map(|v| printed(v, HUGE)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::objects::Intersection;
    use crate::graph::shapes::{Box, Cylinder, Plane, Sphere};
    use crate::math::vec3;

    fn close(a: Vec3, b: Vec3) -> bool {
        (a - b).length() < 1e-4
    }

    /// Values printed by POV-Ray 3.7.
    #[test]
    fn answers_are_those_of_povray() {
        let sphere = Questioned::new(&Object::new(Sphere { center: Vec3::ZERO, radius: 1.0 }));
        let (point, normal) = sphere.trace(vec3(0.1, 0.2, -5.0), vec3(0.0, 0.0, 3.0)).unwrap();
        assert!(close(point, vec3(0.1, 0.2, -0.974679)) && close(normal, point));
        let (point, _) = sphere.trace(vec3(0.0, 0.0, -1.00001), Vec3::Z).unwrap();
        assert!(close(point, Vec3::Z), "{point:?}: what is nearer than 1e-4 is not seen");
        assert!(sphere.trace(vec3(0.1, 0.2, -5.0), Vec3::X).is_none());
        assert!(sphere.inside(Vec3::ZERO) && !sphere.inside(Vec3::X * 1.1));

        let tube = Cylinder { base: Vec3::ZERO, cap: vec3(1.0, 1.0, 0.0), radius: 1.0, open: false };
        let extents = Questioned::new(&Object::new(tube)).extents();
        assert!(
            close(extents.min, vec3(-1.0, -1.0, -2f64.sqrt()))
                && close(extents.max, vec3(2.0, 2.0, 2f64.sqrt()))
        );

        let plane = |normal, distance| Object::new(Plane { normal, distance });
        assert_eq!(Questioned::new(&plane(Vec3::Y, 0.0)).extents().max.y, 1e10);
        let block = Object::new(Box { corner1: Vec3::splat(-3.0), corner2: Vec3::splat(3.0) });
        let cut = |children| Object::new(Intersection { children, lights: vec![], cutaway_textures: false });
        let extents = Questioned::new(&cut(vec![plane(Vec3::Y, 0.0), block])).extents();
        assert_eq!((extents.min, extents.max), (Vec3::splat(-3.0), vec3(3.0, 0.0, 3.0)));
        let axes = [(Vec3::X, 1.0), (Vec3::Y, 2.0), (Vec3::Z, 3.0)];
        let six = axes.iter().flat_map(|&(n, d)| [plane(n, d), plane(-n, d)]).collect();
        let extents = Questioned::new(&cut(six)).extents();
        assert_eq!((extents.min, extents.max), (vec3(-1.0, -2.0, -3.0), vec3(1.0, 2.0, 3.0)));
    }
}
