//! SDL: `disc { <0,0,0>, <0,1,0>, 2, 0.5 }`: canonical: around the origin in the plane z = 0.

use super::{offer_rising, Crossing, Primitive};
use crate::accel::Counters;
use crate::math::{vec3, Bounds, Ray, Vec3};

const NEAREST: f64 = 1e-6;
/// Of the box around it, as in POV-Ray.
const THICKNESS: f64 = 1e-3;

/// A flat ring.
#[derive(Clone, Debug)]
pub struct Disc {
    /// Of the rim.
    pub radius: f64,
    /// Of the hole.
    pub hole_radius: f64,
}

impl Primitive for Disc {
    fn bounds(&self) -> Bounds {
        let r = self.radius.abs();
        Bounds { min: vec3(-r, -r, -THICKNESS), max: vec3(r, r, THICKNESS) }
    }

    fn solid_bounds(&self) -> Bounds {
        Bounds::INFINITE
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
        if ray.direction.z == 0.0 {
            return limit;
        }
        let t = -ray.origin.z / ray.direction.z;
        let p = ray.at(t);
        let square = p.x * p.x + p.y * p.y;
        if square > self.radius * self.radius || square < self.hole_radius * self.hole_radius {
            return limit;
        }
        offer_rising([Crossing::at(t)], from.max(NEAREST), limit, offer)
    }

    /// Everything behind its plane, as in POV-Ray.
    fn inside(&self, p: Vec3) -> bool {
        p.z < 0.0
    }

    fn normal(&self, _: Vec3, _: &Crossing) -> Vec3 {
        Vec3::Z
    }
}
