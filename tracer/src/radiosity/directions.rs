//! Directions of a hemisphere, denser towards its pole: as light counts that falls on a matt surface.

use std::f64::consts::TAU;

use crate::math::{vec3, Vec3};
use crate::render::Random;

/// One over the golden ratio: multiples of it spread evenly over the unit interval.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// `count` directions around `normal` (of length one) with density cosine over pi, turned at random as a whole.
pub fn hemisphere(normal: Vec3, count: usize, random: &mut Random) -> impl Iterator<Item = Vec3> {
    let shift = [random.unit(), random.unit()];
    let across = if normal.x.abs() < 0.6 { Vec3::X } else { Vec3::Y };
    let right = normal.cross(across).normalized();
    let up = normal.cross(right);
    (0..count).map(move |i| {
        let height = ((i as f64 + shift[0]) / count as f64).min(1.0);
        let (sin, cos) = ((i as f64 * GOLDEN + shift[1]) * TAU).sin_cos();
        let v = vec3(height.sqrt() * cos, height.sqrt() * sin, (1.0 - height).max(0.0).sqrt());
        (right * v.x + up * v.y + normal * v.z).normalized()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mean_cosine_is_two_thirds() {
        let normal = vec3(0.36, 0.48, 0.8);
        let mut random = Random::seeded(1, 2, 3);
        let mean = hemisphere(normal, 1000, &mut random).map(|d| d.dot(normal)).sum::<f64>() / 1000.0;
        assert!((mean - 2.0 / 3.0).abs() < 1e-3, "{mean}");
        let flat = hemisphere(normal, 1000, &mut random).fold(Vec3::ZERO, |a, d| a + d) / 1000.0;
        assert!((flat - normal * (2.0 / 3.0)).length() < 0.01, "{flat:?}");
    }
}
