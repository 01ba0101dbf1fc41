//! SDL: 3.8 `lemon { <0,0,0>, 0.5, <0,2,0>, 0.2, 3 open }`: an arc between two discs, turned about the line of their
//! centres.
//!
//! Canonical: the base in the plane z = 0 around the origin, the cap at z = length.

use super::arc::Arc;
use super::{offer_rising, Crossing, Primitive};
use crate::accel::Counters;
use crate::math::{vec3, Bounds, Ray, Vec3};

/// Nearer crossings are not seen.
const NEAREST: f64 = 1e-4;

const SIDE: u32 = 0;
const BASE: u32 = 1;
const CAP: u32 = 2;

/// A spindle.
#[derive(Clone, Debug)]
pub struct Lemon {
    /// About y, from 0 to the length.
    arc: Arc,
    base_radius: f64,
    cap_radius: f64,
    open: bool,
}

/// The arc stands upright: its y is the lemon's z.
fn upright(v: Vec3) -> Vec3 {
    vec3(v.x, v.z, v.y)
}

impl Lemon {
    /// Base at z = 0, cap at z = `length`. An arc too narrow to reach from rim to rim becomes half a circle.
    pub fn new(base_radius: f64, cap_radius: f64, length: f64, inner_radius: f64, open: bool) -> Lemon {
        let (base_radius, cap_radius) = (base_radius.abs(), cap_radius.abs());
        let narrowing = cap_radius - base_radius;
        let half = 0.5 * length.hypot(narrowing);
        let radius = inner_radius.abs().max(half);
        // From the middle between the rims towards the axis.
        let back = (radius * radius - half * half).sqrt() / (2.0 * half);
        let arc = Arc {
            across: 0.5 * (base_radius + cap_radius) - back * length,
            height: 0.5 * length + back * narrowing,
            radius,
            low: 0.0,
            high: length,
        };
        Lemon { arc, base_radius, cap_radius, open }
    }

    fn ends(&self) -> [(f64, f64, u32); 2] {
        [(0.0, self.base_radius, BASE), (self.arc.high, self.cap_radius, CAP)]
    }
}

impl Primitive for Lemon {
    fn bounds(&self) -> Bounds {
        let Bounds { min, max } = self.arc.bounds();
        Bounds { min: upright(min), max: upright(max) }
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
        let (o, d) = (ray.origin, ray.direction / scale);
        let mut crossings = [Crossing::at(f64::INFINITY); 6];
        let mut count = 0;
        let mut add = |t: f64, part: u32| {
            crossings[count] = Crossing::on(t / scale, part);
            count += 1;
        };
        let standing = Ray { origin: upright(o), direction: upright(d) };
        self.arc.crossings(&standing).iter().for_each(|&t| add(t, SIDE));
        if !self.open && d.z != 0.0 {
            for (z, radius, part) in self.ends() {
                let t = (z - o.z) / d.z;
                let (x, y) = (o.x + t * d.x, o.y + t * d.y);
                if x * x + y * y <= radius * radius {
                    add(t, part);
                }
            }
        }
        crossings[..count].sort_unstable_by(|p, q| p.t.total_cmp(&q.t));
        offer_rising(crossings[..count].iter().copied(), from.max(NEAREST / scale), limit, offer)
    }

    fn inside(&self, p: Vec3) -> bool {
        self.arc.holds(upright(p))
    }

    fn normal(&self, p: Vec3, crossing: &Crossing) -> Vec3 {
        match crossing.part {
            BASE => -Vec3::Z,
            CAP => Vec3::Z,
            _ => upright(self.arc.normal(upright(p))),
        }
    }
}
