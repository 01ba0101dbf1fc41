//! The surface of an arc turned about the y axis: the body of `ovus` and `lemon`.

use crate::math::polynomial::{roots_within, Few};
use crate::math::{vec3, Bounds, Ray, Vec3};

use super::torus;

/// A circle in the half plane of (distance from the axis, y), turned about the axis; of it, the side away from the axis
/// between two heights. With `across` < 0 the circle's centre lies beyond the axis and the body is a lemon.
#[derive(Clone, Debug)]
pub struct Arc {
    /// Distance of the circle's centre from the axis.
    pub across: f64,
    /// Height of the circle's centre.
    pub height: f64,
    /// Of the circle.
    pub radius: f64,
    /// Lowest height that counts.
    pub low: f64,
    /// Highest height that counts.
    pub high: f64,
}

impl Arc {
    /// The largest distance from the axis and the heights.
    pub fn bounds(&self) -> Bounds {
        let reach = self.reach(self.height.max(self.low).min(self.high));
        Bounds { min: vec3(-reach, self.low, -reach), max: vec3(reach, self.high, reach) }
    }

    /// Distance of the surface from the axis at a height.
    fn reach(&self, y: f64) -> f64 {
        let up = y - self.height;
        (self.across + (self.radius * self.radius - up * up).max(0.0).sqrt()).max(0.0)
    }

    /// Where the ray, whose direction has length one, meets the surface.
    pub fn crossings(&self, ray: &Ray) -> Few<4> {
        let mut found = Few::new();
        let centered = Ray { origin: ray.origin - Vec3::Y * self.height, ..*ray };
        let heights = [self.low - self.height, self.high - self.height];
        let reach = self.bounds().max.x;
        let Some((enter, leave)) = torus::within_ring(centered.origin, ray.direction, reach, heights) else {
            return found;
        };
        // Solve about the middle of the part that matters, for precision.
        let start = 0.5 * (enter + leave);
        let half = 0.5 * (leave - enter) * (1.0 + 1e-9) + 1e-12;
        let middle = Ray { origin: centered.at(start), ..centered };
        let quartic = torus::quartic(&middle, self.across, self.radius);
        for &t in roots_within::<5>(&quartic, -half, half).iter() {
            let p = middle.at(t);
            if p.y >= heights[0] && p.y <= heights[1] && self.is_outer(p) {
                found.push(t + start);
            }
        }
        found
    }

    /// Of the two distances from the axis that a circle has at one height, whether a point (as seen from the circle's
    /// centre) is at the larger.
    fn is_outer(&self, p: Vec3) -> bool {
        let distance = p.x.hypot(p.z);
        let expected = self.reach(p.y + self.height);
        let other = self.across - (self.radius * self.radius - p.y * p.y).max(0.0).sqrt();
        (distance - expected).abs() <= (distance - other.abs()).abs()
    }

    /// Whether a point between the heights is nearer to the axis than the surface.
    pub fn holds(&self, p: Vec3) -> bool {
        p.y >= self.low && p.y <= self.high && p.x.hypot(p.z) < self.reach(p.y)
    }

    /// Outward, of any length.
    pub fn normal(&self, p: Vec3) -> Vec3 {
        let distance = p.x.hypot(p.z);
        if distance == 0.0 {
            return vec3(0.0, p.y - self.height, 0.0);
        }
        let share = (distance - self.across) / distance;
        vec3(p.x * share, p.y - self.height, p.z * share)
    }
}
