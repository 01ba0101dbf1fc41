//! SDL: `torus { 4, 1 }`: about the y axis.

use super::{offer_rising, Crossing, Primitive};
use crate::accel::Counters;
use crate::math::polynomial::{quadratic, roots_within};
use crate::math::{vec3, Bounds, Ray, Vec3};
use std::f64::consts::TAU;

/// Nearer crossings are not seen, as in POV-Ray; in the torus's own measure.
const NEAREST: f64 = 1e-4;

/// A ring; with `minor` > `major` it meets itself.
#[derive(Clone, Debug)]
pub struct Torus {
    /// From the middle to the middle of the tube.
    pub major: f64,
    /// Of the tube.
    pub minor: f64,
}

impl Torus {
    /// The part of the ray within the flat round box around the ring.
    fn span(&self, o: Vec3, d: Vec3) -> Option<(f64, f64)> {
        let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
        let r = self.minor;
        if d.y != 0.0 {
            let (a, b) = ((-r - o.y) / d.y, (r - o.y) / d.y);
            (enter, leave) = (a.min(b), a.max(b));
        } else if o.y.abs() > r {
            return None;
        }
        let rim = self.major + self.minor;
        let a = d.x * d.x + d.z * d.z;
        let c = o.x * o.x + o.z * o.z - rim * rim;
        if a > 0.0 {
            let around = quadratic(a, o.x * d.x + o.z * d.z, c);
            let [near, far] = around[..] else { return None };
            (enter, leave) = (enter.max(near), leave.min(far));
        } else if c > 0.0 {
            return None;
        }
        (enter < leave).then_some((enter, leave))
    }
}

impl Primitive for Torus {
    fn bounds(&self) -> Bounds {
        let r = self.major + self.minor;
        let corner = vec3(r, self.minor, r);
        Bounds { min: -corner, max: corner }
    }

    fn intersect(
        &self,
        ray: &Ray,
        from: f64,
        limit: f64,
        _counters: &mut Counters,
        offer: &mut impl FnMut(Crossing, f64) -> f64,
    ) -> f64 {
        let scale = ray.direction.length();
        let d = ray.direction / scale;
        let Some((enter, leave)) = self.span(ray.origin, d) else { return limit };
        let from = from.max(NEAREST / scale);
        if leave <= from * scale || enter > limit * scale {
            return limit;
        }
        // Along o + t d: (|p|² + R² - r²)² = 4 R² (x² + z²), with o in the middle of the part that matters.
        let start = 0.5 * (enter + leave);
        let half = 0.5 * (leave - enter) * (1.0 + 1e-9) + 1e-12;
        let o = ray.origin + d * start;
        let four = 4.0 * self.major * self.major;
        let k = o.length_squared() + self.major * self.major - self.minor * self.minor;
        let s = o.dot(d);
        let quartic = [
            k * k - four * (o.x * o.x + o.z * o.z),
            4.0 * k * s - 2.0 * four * (o.x * d.x + o.z * d.z),
            4.0 * s * s + 2.0 * k - four * (d.x * d.x + d.z * d.z),
            4.0 * s,
            1.0,
        ];
        let low = (-half).max(from * scale - start);
        let roots = roots_within::<5>(&quartic, low, half);
        offer_rising(roots.iter().map(|t| Crossing::at((t + start) / scale)), from, limit, offer)
    }

    fn inside(&self, p: Vec3) -> bool {
        let from_ring = p.x.hypot(p.z) - self.major;
        from_ring * from_ring + p.y * p.y <= self.minor * self.minor
    }

    fn normal(&self, p: Vec3, _: &Crossing) -> Vec3 {
        let distance = p.x.hypot(p.z);
        if distance == 0.0 {
            return p;
        }
        let share = self.major / distance;
        vec3(p.x - share * p.x, p.y, p.z - share * p.z)
    }

    /// u runs around y against the sense of longitude, v around the tube from its inner side.
    fn uv(&self, p: Vec3, _: &Crossing) -> Option<[f64; 2]> {
        Some([0.5 - p.z.atan2(p.x) / TAU, 0.5 + p.y.atan2(p.x.hypot(p.z) - self.major) / TAU])
    }
}
