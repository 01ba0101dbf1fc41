//! SDL: `prism { linear_spline linear_sweep 0, 1, 5, <0,0>, <1,0>, <1,1>, <0,1>, <0,0> }`, and the glyphs of `text`.
//!
//! A figure in (x, z) swept along y; `conic_sweep` scales it by y.

use super::curve::{crossings_beyond, unit_roots, Segment};
use super::{Crossing, Primitive};
use crate::accel::Counters;
use crate::math::{vec3, Bounds, Ray, Vec3};

/// Nearer crossings are not seen, as in POV-Ray; in the prism's own measure.
const NEAREST: f64 = 1e-4;
/// The part that is the lower end.
pub const BASE: u32 = u32::MAX;
const CAP: u32 = u32::MAX - 1;

/// A figure swept along a line. A crossing's part is the number of the piece of the curve, `u` the place on it.
#[derive(Clone, Debug)]
pub struct Prism {
    segments: Vec<Segment>,
    /// Ranges of x and z of each piece.
    ranges: Vec<[[f64; 2]; 2]>,
    low: f64,
    high: f64,
    conic: bool,
    open: bool,
    /// The sides' normals are turned round, as in POV-Ray for `bezier_spline`.
    reversed: bool,
    bounds: Bounds,
}

impl Prism {
    /// From the pieces of closed curves and two heights.
    pub fn new(segments: Vec<Segment>, heights: [f64; 2], conic: bool, open: bool) -> Prism {
        let (low, high) = (heights[0].min(heights[1]), heights[0].max(heights[1]));
        let ranges: Vec<_> = segments.iter().map(Segment::range).collect();
        let flat =
            Bounds::around(ranges.iter().flat_map(|[x, z]| [vec3(x[0], 0.0, z[0]), vec3(x[1], 0.0, z[1])]));
        let at = |y: f64| {
            let scale = if conic { y } else { 1.0 };
            Bounds::around([flat.min * scale + Vec3::Y * y, flat.max * scale + Vec3::Y * y])
        };
        let bounds = if flat.is_empty() { flat } else { at(low).union(&at(high)) };
        Prism { segments, ranges, low, high, conic, open, reversed: false, bounds }
    }

    /// The same with its sides' normals turned round.
    pub fn reversed(self) -> Prism {
        Prism { reversed: true, ..self }
    }

    /// Whether the figure covers a point of the plane y = 1.
    fn covers(&self, x: f64, z: f64) -> bool {
        crossings_beyond(&self.segments, x, z) % 2 == 1
    }

    fn scale_at(&self, y: f64) -> f64 {
        if self.conic {
            y
        } else {
            1.0
        }
    }
}

impl Primitive for Prism {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn intersect(
        &self,
        ray: &Ray,
        from: f64,
        mut limit: f64,
        _counters: &mut Counters,
        offer: &mut impl FnMut(Crossing, f64) -> f64,
    ) -> f64 {
        let (o, d) = (ray.origin, ray.direction);
        let from = from.max(NEAREST / d.length());
        // The part of the ray between the two heights.
        let (mut enter, mut leave) = (from, limit);
        if d.y != 0.0 {
            let (a, b) = ((self.low - o.y) / d.y, (self.high - o.y) / d.y);
            (enter, leave) = (enter.max(a.min(b)), leave.min(a.max(b)));
        } else if o.y < self.low || o.y > self.high {
            return limit;
        }
        if enter > leave {
            return limit;
        }
        if !self.open && d.y != 0.0 {
            for (y, part) in [(self.low, BASE), (self.high, CAP)] {
                let t = (y - o.y) / d.y;
                let scale = self.scale_at(y);
                if t > from && t <= limit && scale != 0.0 {
                    let p = ray.at(t);
                    if self.covers(p.x / scale, p.z / scale) {
                        limit = offer(Crossing::on(t, part), limit);
                    }
                }
            }
        }
        // The ray lies in a plane through the sweep's direction (or apex); where it cuts the curve, n . (a, 1, b) = 0.
        let n = if self.conic { o.cross(d) } else { vec3(-d.z, o.x * d.z - o.z * d.x, d.x) };
        for (i, (segment, [[x0, x1], [z0, z1]])) in self.segments.iter().zip(&self.ranges).enumerate() {
            let middle = n.x * (x0 + x1) + n.z * (z0 + z1) + 2.0 * n.y;
            if middle.abs() > n.x.abs() * (x1 - x0) + n.z.abs() * (z1 - z0) + 1e-12 * n.y.abs() {
                continue;
            }
            let mut cubic: [f64; 4] = std::array::from_fn(|k| n.x * segment.a[k] + n.z * segment.b[k]);
            cubic[0] += n.y;
            for &u in unit_roots(&cubic).iter() {
                let [x, z] = segment.at(u);
                // Along x or z, whichever the ray changes more; for a cone in proportion to y.
                let (px, pz) = if self.conic { (d.x - x * d.y, d.z - z * d.y) } else { (d.x, d.z) };
                let (qx, qz) = if self.conic { (x * o.y - o.x, z * o.y - o.z) } else { (x - o.x, z - o.z) };
                let t = if px.abs() > pz.abs() { qx / px } else { qz / pz };
                let y = o.y + t * d.y;
                if t > from && t <= limit && y >= self.low && y <= self.high {
                    limit = offer(Crossing { t, part: i as u32, u, v: 0.0 }, limit);
                }
            }
        }
        limit
    }

    fn inside(&self, p: Vec3) -> bool {
        let scale = self.scale_at(p.y);
        p.y >= self.low && p.y <= self.high && scale != 0.0 && self.covers(p.x / scale, p.z / scale)
    }

    /// The base's normal leads inward, and a side's one where the order of points wants it, as in POV-Ray.
    fn normal(&self, _: Vec3, crossing: &Crossing) -> Vec3 {
        match crossing.part {
            BASE | CAP => Vec3::Y,
            part => {
                let [x, z] = self.segments[part as usize].tangent(crossing.u);
                let sign = if self.reversed { -1.0 } else { 1.0 };
                if self.conic {
                    // The side leads through the apex: no part of the normal along the point.
                    let [a, b] = self.segments[part as usize].at(crossing.u);
                    vec3(z, x * b - z * a, -x) * sign
                } else {
                    vec3(z, 0.0, -x) * sign
                }
            }
        }
    }
}
