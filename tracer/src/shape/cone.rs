//! SDL: `cone { <0,0,0>, 1, <0,2,0>, 0 open }` and `cylinder { <0,0,0>, <0,2,0>, 1 open }`.
//!
//! Canonical: the base in the plane z = 0 around the origin, the cap at z = length.

use super::{offer_rising, Crossing, Primitive};
use crate::accel::Counters;
use crate::math::polynomial::quadratic;
use crate::math::{vec3, Bounds, Ray, Transform, Vec3};

const SIDE: u32 = 0;
const BASE: u32 = 1;
const CAP: u32 = 2;

/// A round column that may taper.
#[derive(Clone, Debug)]
pub struct Cone {
    base_radius: f64,
    cap_radius: f64,
    length: f64,
    open: bool,
}

/// Two directions across `z` (of length one): x and y turned by the shortest way that takes the z axis there.
fn across(z: Vec3) -> (Vec3, Vec3) {
    if z.z < -1.0 + 1e-12 {
        return (Vec3::X, -Vec3::Y);
    }
    let k = 1.0 / (1.0 + z.z);
    (vec3(1.0 - k * z.x * z.x, -k * z.x * z.y, -z.x), vec3(-k * z.x * z.y, 1.0 - k * z.y * z.y, -z.y))
}

fn placed(origin: Vec3, (x, y): (Vec3, Vec3), z: Vec3) -> Option<Transform> {
    Transform::from_matrix([x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z, origin.x, origin.y, origin.z])
}

/// The frame whose z axis runs from `base` towards `cap`; none where they coincide. The other axes are turned as for the
/// opposite direction, so that boxes around a column are POV-Ray's.
pub fn frame(base: Vec3, cap: Vec3) -> Option<Transform> {
    let z = (cap - base).normalized();
    placed(base, across(-z), z)
}

/// The frame of a disc: its z axis is the disc's normal; none where that has no direction.
pub fn disc_frame(center: Vec3, normal: Vec3) -> Option<Transform> {
    let z = normal.normalized();
    placed(center, across(z), z)
}

impl Cone {
    /// Base at z = 0, cap at z = `length`.
    pub fn new(base_radius: f64, cap_radius: f64, length: f64, open: bool) -> Cone {
        Cone { base_radius: base_radius.abs(), cap_radius: cap_radius.abs(), length, open }
    }

    fn slope(&self) -> f64 {
        (self.cap_radius - self.base_radius) / self.length
    }
}

impl Primitive for Cone {
    fn bounds(&self) -> Bounds {
        let r = self.base_radius.max(self.cap_radius);
        Bounds { min: vec3(-r, -r, 0.0), max: vec3(r, r, self.length) }
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
        // Start near the column, for precision.
        let start = -ray.origin.dot(ray.direction) / ray.direction.length_squared();
        let (o, d) = (ray.at(start), ray.direction);
        let slope = self.slope();
        let radius = self.base_radius + slope * o.z;
        let a = d.x * d.x + d.y * d.y - slope * slope * d.z * d.z;
        let b = o.x * d.x + o.y * d.y - slope * d.z * radius;
        let c = o.x * o.x + o.y * o.y - radius * radius;
        let mut crossings = [Crossing::at(f64::INFINITY); 4];
        let mut count = 0;
        let mut add = |t: f64, part: u32| {
            crossings[count] = Crossing::on(start + t, part);
            count += 1;
        };
        for &t in quadratic(a, b, c).iter() {
            let z = o.z + t * d.z;
            if z >= 0.0 && z <= self.length {
                add(t, SIDE);
            }
        }
        if !self.open && d.z != 0.0 {
            for (z, r, part) in [(0.0, self.base_radius, BASE), (self.length, self.cap_radius, CAP)] {
                let t = (z - o.z) / d.z;
                let (x, y) = (o.x + t * d.x, o.y + t * d.y);
                if x * x + y * y <= r * r {
                    add(t, part);
                }
            }
        }
        crossings[..count].sort_unstable_by(|p, q| p.t.total_cmp(&q.t));
        offer_rising(crossings[..count].iter().copied(), from, limit, offer)
    }

    fn inside(&self, p: Vec3) -> bool {
        let radius = self.base_radius + self.slope() * p.z;
        p.z >= 0.0 && p.z <= self.length && p.x * p.x + p.y * p.y <= radius * radius
    }

    fn normal(&self, p: Vec3, crossing: &Crossing) -> Vec3 {
        match crossing.part {
            BASE => -Vec3::Z,
            CAP => Vec3::Z,
            _ => vec3(p.x, p.y, -self.slope() * (self.base_radius + self.slope() * p.z)),
        }
    }
}
