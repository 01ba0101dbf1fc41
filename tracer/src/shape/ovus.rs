//! SDL: `ovus { 1, 0.6 }`: an egg about the y axis.
//!
//! The lower ball stands at the origin, the upper one at the height of the lower one's radius (3.8: `distance`); an arc
//! of twice the larger radius (3.8: `radius`) touches both from outside. An upper ball that holds all the rest is a ball.

use super::arc::Arc;
use super::sphere::spherical_uv;
use super::{offer_rising, Crossing, Primitive};
use crate::accel::Counters;
use crate::graph::shapes::Ovus as Description;
use crate::math::polynomial::quadratic;
use crate::math::{Bounds, Ray, Vec3};

/// Nearer crossings are not seen, as in POV-Ray.
const NEAREST: f64 = 1e-4;

const BOTTOM: u32 = 0;
const TOP: u32 = 1;
const SIDE: u32 = 2;

/// An egg. A crossing's part says whether it is on a ball or on the arc.
#[derive(Clone, Debug)]
pub struct Ovus {
    bottom_radius: f64,
    top_radius: f64,
    /// Height of the upper ball's centre.
    distance: f64,
    /// None where one ball holds the other.
    arc: Option<Arc>,
}

impl Ovus {
    /// From SDL's numbers.
    pub fn new(egg: &Description) -> Ovus {
        let (bottom, top) = (egg.bottom_radius, egg.top_radius);
        let distance = egg.distance.unwrap_or(bottom);
        let radius = egg.radius.unwrap_or(2.0 * bottom.max(top));
        // The arc's centre is this far from the balls' centres.
        let (to_bottom, to_top) = (radius - bottom, radius - top);
        let height = (to_bottom * to_bottom - to_top * to_top + distance * distance) / (2.0 * distance);
        let square = to_bottom * to_bottom - height * height;
        // It touches a ball on the line through both centres.
        let contact = |center: f64, to_center: f64| height + (center - height) * radius / to_center;
        let (low, high) = (contact(0.0, to_bottom), contact(distance, to_top));
        let apart = distance > (bottom - top).abs() && square > 0.0 && low < high;
        let arc = apart.then(|| Arc { across: -square.sqrt(), height, radius, low, high });
        Ovus { bottom_radius: bottom, top_radius: top, distance, arc }
    }

    fn top(&self) -> Vec3 {
        Vec3::Y * self.distance
    }

    /// The heights above which the lower ball ends and below which the upper one does.
    fn ends(&self) -> (f64, f64) {
        match &self.arc {
            Some(arc) => (arc.low, arc.high),
            None if self.top_radius > self.bottom_radius => (f64::NEG_INFINITY, f64::NEG_INFINITY),
            None => (f64::INFINITY, f64::INFINITY),
        }
    }
}

impl Primitive for Ovus {
    fn bounds(&self) -> Bounds {
        let ball = |center: Vec3, radius: f64| Bounds {
            min: center - Vec3::splat(radius),
            max: center + Vec3::splat(radius),
        };
        let (bottom, top) = (ball(Vec3::ZERO, self.bottom_radius), ball(self.top(), self.top_radius));
        match &self.arc {
            Some(arc) => bottom.union(&top).union(&arc.bounds()),
            None if self.top_radius > self.bottom_radius => top,
            None => bottom,
        }
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
        let unit = Ray { direction: ray.direction / scale, ..*ray };
        let mut crossings = [Crossing::at(f64::INFINITY); 8];
        let mut count = 0;
        let mut add = |t: f64, part: u32| {
            crossings[count] = Crossing::on(t / scale, part);
            count += 1;
        };
        let (low, high) = self.ends();
        let balls = [(Vec3::ZERO, self.bottom_radius, BOTTOM), (self.top(), self.top_radius, TOP)];
        for (center, radius, part) in balls {
            let to_ray = unit.origin - center;
            let square = to_ray.length_squared() - radius * radius;
            for &t in quadratic(1.0, to_ray.dot(unit.direction), square).iter() {
                let y = unit.at(t).y;
                if if part == BOTTOM { y < low } else { y > high } {
                    add(t, part);
                }
            }
        }
        if let Some(arc) = &self.arc {
            arc.crossings(&unit).iter().for_each(|&t| add(t, SIDE));
        }
        crossings[..count].sort_unstable_by(|p, q| p.t.total_cmp(&q.t));
        offer_rising(crossings[..count].iter().copied(), from.max(NEAREST / scale), limit, offer)
    }

    fn inside(&self, p: Vec3) -> bool {
        let (low, high) = self.ends();
        let in_ball = |center: Vec3, radius: f64| (p - center).length_squared() < radius * radius;
        (p.y < low && in_ball(Vec3::ZERO, self.bottom_radius))
            || (p.y > high && in_ball(self.top(), self.top_radius))
            || self.arc.as_ref().is_some_and(|arc| arc.holds(p))
    }

    fn normal(&self, p: Vec3, crossing: &Crossing) -> Vec3 {
        match (crossing.part, &self.arc) {
            (SIDE, Some(arc)) => arc.normal(p),
            (TOP, _) => p - self.top(),
            _ => p,
        }
    }

    /// Longitude and latitude as seen from the middle of its height.
    fn uv(&self, p: Vec3, _: &Crossing) -> Option<[f64; 2]> {
        let bounds = self.bounds();
        Some(spherical_uv(p - Vec3::Y * (0.5 * (bounds.min.y + bounds.max.y))))
    }
}
