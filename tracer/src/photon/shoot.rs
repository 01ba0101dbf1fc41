//! Where photons are aimed: a light's view of the sphere around a target, in rings.

use std::f64::consts::{PI, TAU};

use crate::geometry::NodeId;
use crate::math::{Ray, Vec3};
use crate::render::Random;

/// No light shoots more rings at a target, so that its photons fit into memory.
const MOST_RINGS: f64 = 4000.0;

/// One light, seen from one of its points, and one object that is a target.
#[derive(Clone, Debug)]
pub struct Aim {
    /// Number of the light.
    pub light: u32,
    /// Where photons start; of a parallel light, the middle of its plane.
    pub origin: Vec3,
    /// The share of the light's photons that this point of its area shoots.
    pub share: f64,
    /// The object.
    pub target: NodeId,
    /// The sphere around it.
    pub center: Vec3,
    /// Its radius.
    pub radius: f64,
    /// Where a parallel light shines.
    pub parallel: Option<Vec3>,
    /// Distance between photons on the target.
    pub spacing: f64,
}

/// A photon about to leave.
#[derive(Clone, Copy, Debug)]
pub struct Shot {
    /// Its way.
    pub ray: Ray,
    /// What it stands for: an area per square of the distance travelled, or of a parallel light an area.
    pub spread: f64,
}

impl Aim {
    /// Angle or distance from the axis of the outermost ring, and between rings.
    fn reach(&self) -> (f64, f64) {
        let distance = (self.center - self.origin).length();
        let (reach, step) = if self.parallel.is_some() {
            (self.radius, self.spacing)
        } else if distance > self.radius {
            ((self.radius / distance).asin(), self.spacing / distance)
        } else {
            (PI, self.spacing / self.radius)
        };
        (reach, step.max(reach / MOST_RINGS))
    }

    /// The photons of one ring.
    pub fn ring(&self, number: usize, jitter: f64) -> Vec<Shot> {
        let (reach, step) = self.reach();
        let axis = self.parallel.unwrap_or_else(|| (self.center - self.origin).normalized());
        let across = if axis.x.abs() < 0.6 { Vec3::X } else { Vec3::Y };
        let right = axis.cross(across).normalized();
        let up = axis.cross(right);
        let middle = (number as f64 + 0.5) * step;
        let circle = if self.parallel.is_some() { middle } else { middle.sin() };
        let count = (TAU * circle / step).round().max(1.0);
        // What all photons of the ring stand for is its whole area.
        let spread = TAU * circle * step / count;
        let mut random =
            Random::seeded(number as u64, u64::from(self.light) << 32 | u64::from(self.target), 7);
        let start = random.unit() * TAU;
        let shots = (0..count as usize).filter_map(|i| {
            let mut shake = || (random.unit() - 0.5) * jitter;
            let from_axis = (middle + shake() * step).abs();
            let around = start + (i as f64 + shake()) / count * TAU;
            if from_axis > reach {
                return None;
            }
            let (sin, cos) = around.sin_cos();
            let aside = right * cos + up * sin;
            let ray = match self.parallel {
                Some(direction) => Ray {
                    origin: self.center - direction * ((self.center - self.origin).dot(direction))
                        + aside * from_axis,
                    direction,
                },
                None => Ray {
                    origin: self.origin,
                    direction: (axis * from_axis.cos() + aside * from_axis.sin()).normalized(),
                },
            };
            Some(Shot { ray, spread })
        });
        shots.collect()
    }
}

/// How many rings an aim has.
pub fn rings(aim: &Aim) -> usize {
    let (reach, step) = aim.reach();
    (reach / step).ceil() as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rings_cover_the_sphere_of_directions() {
        let aim = Aim {
            light: 0,
            origin: Vec3::ZERO,
            share: 1.0,
            target: 0,
            center: Vec3::Z * 5.0,
            radius: 2.0,
            parallel: None,
            spacing: 0.02,
        };
        let solid: f64 = (0..rings(&aim)).flat_map(|ring| aim.ring(ring, 0.0)).map(|shot| shot.spread).sum();
        let cap = TAU * (1.0 - (2.0f64 / 5.0).asin().cos());
        assert!((solid / cap - 1.0).abs() < 0.03, "{solid} {cap}");
    }
}
