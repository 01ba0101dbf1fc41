//! Directions that cover a sphere evenly.

use crate::math::{vec3, Vec3};
use crate::render::Random;

/// Steps that cover the unit square evenly however many are taken: powers of the plastic number's inverse.
const STEPS: [f64; 2] = [0.754_877_666_246_692_8, 0.569_840_290_998_053_3];

/// Unit vectors, spread evenly from a random start.
pub fn directions(count: usize, random: &mut Random) -> impl Iterator<Item = Vec3> {
    let start = [random.unit(), random.unit()];
    (0..count).map(move |i| {
        let [height, turn]: [f64; 2] = std::array::from_fn(|k| (start[k] + i as f64 * STEPS[k]).fract());
        let z = 1.0 - 2.0 * height;
        let (sin, cos) = (2.0 * std::f64::consts::PI * turn).sin_cos();
        let radius = (1.0 - z * z).max(0.0).sqrt();
        vec3(radius * cos, radius * sin, z)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_cancel_out() {
        let sum = directions(500, &mut Random::seeded(1, 2, 3)).fold(Vec3::ZERO, |sum, d| sum + d);
        assert!(sum.length() < 10.0, "{sum:?}");
        assert!(directions(50, &mut Random::seeded(1, 2, 3)).all(|d| (d.length() - 1.0).abs() < 1e-12));
    }
}
