//! SDL: `quadric { <A,B,C>, <D,E,F>, <G,H,I>, J }`.

use super::{offer_rising, Crossing, Primitive};
use crate::accel::Counters;
use crate::math::polynomial::quadratic;
use crate::math::{vec3, Bounds, Ray, Vec3};

const NEAREST: f64 = 1e-6;

/// A x² + B y² + C z² + D xy + E xz + F yz + G x + H y + I z + J < 0.
#[derive(Clone, Debug)]
pub struct Quadric {
    /// A, B, C.
    pub squares: Vec3,
    /// D, E, F.
    pub mixed: Vec3,
    /// G, H, I.
    pub linear: Vec3,
    /// J.
    pub constant: f64,
}

impl Quadric {
    /// Twice the symmetric matrix of the second-order terms, times `v`.
    fn second_order(&self, v: Vec3) -> Vec3 {
        let (s, m) = (self.squares * 2.0, self.mixed);
        vec3(
            s.x * v.x + m.x * v.y + m.y * v.z,
            m.x * v.x + s.y * v.y + m.z * v.z,
            m.y * v.x + m.z * v.y + s.z * v.z,
        )
    }

    fn value(&self, p: Vec3) -> f64 {
        0.5 * p.dot(self.second_order(p)) + self.linear.dot(p) + self.constant
    }
}

impl Primitive for Quadric {
    fn bounds(&self) -> Bounds {
        Bounds::INFINITE
    }

    fn intersect(
        &self,
        ray: &Ray,
        from: f64,
        limit: f64,
        _counters: &mut Counters,
        offer: &mut impl FnMut(Crossing, f64) -> f64,
    ) -> f64 {
        let (o, d) = (ray.origin, ray.direction);
        let along = self.second_order(d);
        let a = 0.5 * d.dot(along);
        let b = 0.5 * (o.dot(along) + self.linear.dot(d));
        let roots = quadratic(a, b, self.value(o));
        offer_rising(roots.iter().map(|&t| Crossing::at(t)), from.max(NEAREST), limit, offer)
    }

    fn inside(&self, p: Vec3) -> bool {
        self.value(p) <= 0.0
    }

    fn normal(&self, p: Vec3, _: &Crossing) -> Vec3 {
        self.second_order(p) + self.linear
    }
}
