//! SDL: `plane { <0, 1, 0>, -1 }`: everything against the normal is inside.

use super::{offer_rising, Crossing, Primitive};
use crate::accel::Counters;
use crate::math::{Bounds, Ray, Vec3};

/// Nearer crossings are not seen, and points this near count as inside, as in POV-Ray.
const NEAREST: f64 = 1e-6;
const INSIDE: f64 = 1e-10;

/// A half-space.
#[derive(Clone, Debug)]
pub struct Plane {
    normal: Vec3,
    distance: f64,
}

impl Plane {
    /// Points p with p . normal / |normal| = distance.
    pub fn new(normal: Vec3, distance: f64) -> Plane {
        Plane { normal: normal.normalized(), distance }
    }

    /// Box around all outside.
    pub fn hollow_bounds(&self) -> Bounds {
        Plane { normal: -self.normal, distance: -self.distance }.solid_bounds()
    }
}

impl Primitive for Plane {
    fn bounds(&self) -> Bounds {
        Bounds::INFINITE
    }

    /// Planes across an axis bound the solids that they cut.
    fn solid_bounds(&self) -> Bounds {
        let mut bounds = Bounds::INFINITE;
        for axis in 0..3 {
            if self.normal[axis] == 1.0 {
                bounds.max[axis] = self.distance;
            } else if self.normal[axis] == -1.0 {
                bounds.min[axis] = -self.distance;
            }
        }
        bounds
    }

    #[inline]
    fn intersect(
        &self,
        ray: &Ray,
        from: f64,
        limit: f64,
        _counters: &mut Counters,
        offer: &mut impl FnMut(Crossing, f64) -> f64,
    ) -> f64 {
        let slope = self.normal.dot(ray.direction);
        if slope.abs() < 1e-10 {
            return limit;
        }
        let t = (self.distance - self.normal.dot(ray.origin)) / slope;
        offer_rising([Crossing::at(t)], from.max(NEAREST), limit, offer)
    }

    fn inside(&self, point: Vec3) -> bool {
        self.normal.dot(point) - self.distance < INSIDE
    }

    fn normal(&self, _: Vec3, _: &Crossing) -> Vec3 {
        self.normal
    }
}
