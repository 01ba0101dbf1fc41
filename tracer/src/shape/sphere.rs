//! SDL: `sphere { <0, 1, 0>, 2 }`.

use super::{offer_rising, Crossing, Primitive};
use crate::accel::Counters;
use crate::math::{vec3, Bounds, Ray, Transform, Vec3};
use std::f64::consts::{PI, TAU};

/// Nearer crossings are not seen, as in POV-Ray.
const NEAREST: f64 = 1e-6;

/// All points at one distance from a centre.
#[derive(Clone, Debug)]
pub struct Sphere {
    /// The middle.
    pub center: Vec3,
    /// The distance.
    pub radius: f64,
}

impl Sphere {
    /// Where the line of a ray enters and leaves.
    #[inline]
    pub fn span(&self, ray: &Ray) -> Option<[Crossing; 2]> {
        let to_center = self.center - ray.origin;
        let scale = 1.0 / ray.direction.length_squared();
        let closest = to_center.dot(ray.direction) * scale;
        let apart = (to_center - ray.direction * closest).length_squared();
        let square = self.radius * self.radius - apart;
        if square < 0.0 {
            return None;
        }
        let half = (square * scale).sqrt();
        Some([closest - half, closest + half].map(Crossing::at))
    }
}

impl Sphere {
    /// The box around the sphere in a place that only turns it before it is stretched along the axes.
    /// Where it is not stretched, POV-Ray's box depends on how it was turned: that of a `matrix` is taken.
    pub fn bounds_in(&self, place: &Transform) -> Option<Bounds> {
        let column = |c: usize| vec3(place.rows[0][c], place.rows[1][c], place.rows[2][c]);
        let [x, y, z] = [0, 1, 2].map(column);
        let skew = x.dot(y).abs() + y.dot(z).abs() + z.dot(x).abs();
        let size = x.length_squared() + y.length_squared() + z.length_squared();
        let reach = vec3(x.length(), y.length(), z.length()) * self.radius.abs();
        let center = place.point(self.center);
        let stretched =
            (x.length_squared() - y.length_squared()).abs() + (y.length_squared() - z.length_squared()).abs();
        (skew < 1e-12 * size && stretched > 1e-12 * size)
            .then(|| Bounds { min: center - reach, max: center + reach })
    }
}

/// The angle around y from the x axis towards z, as a number in 0..1.
pub fn longitude(p: Vec3) -> f64 {
    let turns = p.z.atan2(p.x) / TAU;
    if turns < 0.0 {
        turns + 1.0
    } else {
        turns
    }
}

/// Longitude and latitude as two numbers in 0..1: u runs around y from x, v from the bottom to the top.
pub fn spherical_uv(direction: Vec3) -> [f64; 2] {
    [longitude(direction), 0.5 + direction.normalized().y.clamp(-1.0, 1.0).asin() / PI]
}

impl Primitive for Sphere {
    fn bounds(&self) -> Bounds {
        let r = Vec3::splat(self.radius.abs());
        Bounds { min: self.center - r, max: self.center + r }
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

    fn inside(&self, point: Vec3) -> bool {
        (point - self.center).length_squared() < self.radius * self.radius
    }

    fn normal(&self, point: Vec3, _: &Crossing) -> Vec3 {
        (point - self.center) / self.radius
    }

    fn uv(&self, point: Vec3, _: &Crossing) -> Option<[f64; 2]> {
        Some(spherical_uv(point - self.center))
    }
}
