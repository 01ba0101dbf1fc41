//! SDL: `torus { 4, 1 }`: about the y axis; 3.8 `torus { 1, 2 difference }` where it meets itself.

use super::{offer_rising, Crossing, Primitive};
use crate::accel::Counters;
use crate::graph::shapes::Spindle;
use crate::math::polynomial::{quadratic, roots_within};
use crate::math::{vec3, Bounds, Ray, Vec3};
use std::f64::consts::TAU;

/// Nearer crossings are not seen, as in POV-Ray; in the torus's own measure.
const NEAREST: f64 = 1e-4;

/// A ring; with `minor` > `major` it meets itself, and the part around the axis is its spindle.
#[derive(Clone, Debug)]
pub struct Torus {
    /// From the middle to the middle of the tube.
    pub major: f64,
    /// Of the tube.
    pub minor: f64,
    /// What counts as inside where it meets itself. None: ring and spindle, as before 3.8.
    pub spindle: Option<Spindle>,
}

/// Where a ray enters and leaves the flat round box of the given radius and heights.
pub fn within_ring(o: Vec3, d: Vec3, reach: f64, [low, high]: [f64; 2]) -> Option<(f64, f64)> {
    let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
    if d.y != 0.0 {
        let (a, b) = ((low - o.y) / d.y, (high - o.y) / d.y);
        (enter, leave) = (a.min(b), a.max(b));
    } else if o.y < low || o.y > high {
        return None;
    }
    let a = d.x * d.x + d.z * d.z;
    let c = o.x * o.x + o.z * o.z - reach * reach;
    if a > 0.0 {
        let around = quadratic(a, o.x * d.x + o.z * d.z, c);
        let [near, far] = around[..] else { return None };
        (enter, leave) = (enter.max(near), leave.min(far));
    } else if c > 0.0 {
        return None;
    }
    (enter <= leave).then_some((enter, leave))
}

/// Along a ray of unit direction: (|p|² + R² - r²)² - 4 R² (x² + z²), by rising power.
pub fn quartic(ray: &Ray, major: f64, minor: f64) -> [f64; 5] {
    let (o, d) = (ray.origin, ray.direction);
    let four = 4.0 * major * major;
    let k = o.length_squared() + major * major - minor * minor;
    let s = o.dot(d);
    [
        k * k - four * (o.x * o.x + o.z * o.z),
        4.0 * k * s - 2.0 * four * (o.x * d.x + o.z * d.z),
        4.0 * s * s + 2.0 * k - four * (d.x * d.x + d.z * d.z),
        4.0 * s,
        1.0,
    ]
}

impl Torus {
    /// Whether a point of the surface is on the spindle.
    fn on_spindle(&self, p: Vec3) -> bool {
        p.length_squared() + self.major * self.major < self.minor * self.minor
    }

    /// Whether the surface counts at a point of it.
    fn shows(&self, p: Vec3) -> bool {
        match self.spindle {
            None | Some(Spindle::Union | Spindle::Difference) => true,
            Some(Spindle::Intersection) => self.on_spindle(p),
            Some(Spindle::Merge) => !self.on_spindle(p),
        }
    }
}

impl Primitive for Torus {
    fn bounds(&self) -> Bounds {
        let (major, minor) = (self.major.abs(), self.minor.abs());
        if self.spindle == Some(Spindle::Intersection) {
            let (r, y) = ((minor - major).max(0.0), (minor * minor - major * major).max(0.0).sqrt());
            return Bounds { min: vec3(-r, -y, -r), max: vec3(r, y, r) };
        }
        let corner = vec3(major + minor, minor, major + minor);
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
        let (reach, up) = (self.major.abs() + self.minor.abs(), self.minor.abs());
        let Some((enter, leave)) = within_ring(ray.origin, d, reach, [-up, up]) else { return limit };
        let from = from.max(NEAREST / scale);
        if leave <= from * scale || enter > limit * scale {
            return limit;
        }
        // Solve about the middle of the part that matters, for precision.
        let start = 0.5 * (enter + leave);
        let half = 0.5 * (leave - enter) * (1.0 + 1e-9) + 1e-12;
        let middle = Ray { origin: ray.origin + d * start, direction: d };
        let low = (-half).max(from * scale - start);
        let roots = roots_within::<5>(&quartic(&middle, self.major, self.minor), low, half);
        let shown = roots.iter().filter(|&&t| self.shows(middle.at(t)));
        offer_rising(shown.map(|t| Crossing::at((t + start) / scale)), from, limit, offer)
    }

    fn inside(&self, p: Vec3) -> bool {
        let distance = p.x.hypot(p.z);
        let (near, far) = (distance - self.major.abs(), distance + self.major.abs());
        let square = self.minor * self.minor - p.y * p.y;
        match self.spindle {
            Some(Spindle::Intersection) => far * far <= square,
            Some(Spindle::Difference) => near * near <= square && far * far > square,
            _ => near * near <= square,
        }
    }

    /// Before 3.8 the spindle is shaded as if it belonged to the ring.
    fn normal(&self, p: Vec3, _: &Crossing) -> Vec3 {
        let distance = p.x.hypot(p.z);
        if distance == 0.0 {
            return p;
        }
        let spindle = self.spindle.is_some() && self.on_spindle(p);
        let share = self.major.abs() / distance * if spindle { -1.0 } else { 1.0 };
        let normal = vec3(p.x - share * p.x, p.y, p.z - share * p.z);
        if spindle && self.spindle == Some(Spindle::Difference) {
            -normal
        } else {
            normal
        }
    }

    /// u runs around y against the sense of longitude, v around the tube from its inner side.
    fn uv(&self, p: Vec3, _: &Crossing) -> Option<[f64; 2]> {
        Some([0.5 - p.z.atan2(p.x) / TAU, 0.5 + p.y.atan2(p.x.hypot(p.z) - self.major) / TAU])
    }
}
