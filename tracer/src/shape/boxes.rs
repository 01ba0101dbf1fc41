//! SDL: `box { <-1, -1, -1>, <1, 1, 1> }`.

use super::{offer_rising, Crossing, Primitive};
use crate::accel::Counters;
use crate::math::{vec3, Bounds, Ray, Vec3};

const NEAREST: f64 = 1e-6;

/// A box along the axes. Part 2a + s is the face across axis a at its smaller (s = 0) or larger (s = 1) end.
#[derive(Clone, Debug)]
pub struct Cuboid {
    min: Vec3,
    max: Vec3,
}

impl Cuboid {
    /// From two opposite corners.
    pub fn new(a: Vec3, b: Vec3) -> Cuboid {
        Cuboid { min: a.min(b), max: a.max(b) }
    }

    /// Where the line of a ray enters and leaves.
    #[inline]
    pub fn span(&self, ray: &Ray) -> Option<[Crossing; 2]> {
        let mut enter = Crossing::at(f64::NEG_INFINITY);
        let mut leave = Crossing::at(f64::INFINITY);
        for axis in 0..3 {
            let (o, d) = (ray.origin[axis], ray.direction[axis]);
            let face = 2 * axis as u32;
            if d.abs() < 1e-10 {
                if o < self.min[axis] || o > self.max[axis] {
                    return None;
                }
                continue;
            }
            let (low, high) = ((self.min[axis] - o) / d, (self.max[axis] - o) / d);
            let (near, far) = if d > 0.0 {
                (Crossing::on(low, face), Crossing::on(high, face + 1))
            } else {
                (Crossing::on(high, face + 1), Crossing::on(low, face))
            };
            if near.t > enter.t {
                enter = near;
            }
            if far.t < leave.t {
                leave = far;
            }
        }
        (enter.t <= leave.t).then_some([enter, leave])
    }
}

impl Primitive for Cuboid {
    fn bounds(&self) -> Bounds {
        Bounds { min: self.min, max: self.max }
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
        match self.span(ray) {
            Some(span) => offer_rising(span, from.max(NEAREST), limit, offer),
            None => limit,
        }
    }

    fn inside(&self, p: Vec3) -> bool {
        self.bounds().contains(p)
    }

    fn normal(&self, _: Vec3, crossing: &Crossing) -> Vec3 {
        let sign = if crossing.part & 1 == 0 { -1.0 } else { 1.0 };
        let mut normal = Vec3::ZERO;
        normal[(crossing.part / 2) as usize] = sign;
        normal
    }

    /// The six faces on the unfolded cube: four across by three up.
    fn uv(&self, p: Vec3, crossing: &Crossing) -> Option<[f64; 2]> {
        let size = self.max - self.min;
        let q = p - self.min;
        let f = vec3(q.x / size.x, q.y / size.y, q.z / size.z);
        let (column, row, s, t) = match crossing.part {
            0 => (0.0, 1.0, f.z, f.y),
            1 => (2.0, 1.0, 1.0 - f.z, f.y),
            2 => (1.0, 0.0, f.x, f.z),
            3 => (1.0, 2.0, f.x, 1.0 - f.z),
            4 => (3.0, 1.0, 1.0 - f.x, f.y),
            _ => (1.0, 1.0, f.x, f.y),
        };
        Some([(column + s) / 4.0, (row + t) / 3.0])
    }
}
