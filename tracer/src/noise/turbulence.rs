//! SDL: `turbulence V octaves I omega F lambda F`, `vturbulence(lambda, omega, octaves, V)`: noise of many sizes.

use super::{vector_noise, NoiseGenerator};
use crate::math::Vec3;

/// Size and number of the octaves summed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Octaves {
    /// How many, 1..=10.
    pub octaves: u32,
    /// Each octave's amplitude relative to the one before.
    pub omega: f64,
    /// Each octave's frequency relative to the one before.
    pub lambda: f64,
}

impl Default for Octaves {
    fn default() -> Octaves {
        Octaves { octaves: 6, omega: 0.5, lambda: 2.0 }
    }
}

impl Octaves {
    /// Limits `octaves` to 1..=10; POV-Ray keeps the other two in single precision, and so the sums come out.
    pub fn new(octaves: i64, omega: f64, lambda: f64) -> Octaves {
        let single = |v: f64| f64::from(v as f32);
        Octaves { octaves: octaves.clamp(1, 10) as u32, omega: single(omega), lambda: single(lambda) }
    }

    /// The vector sum, as warps and `vturbulence` use it; the same for every noise generator.
    pub fn vector(&self, p: Vec3) -> Vec3 {
        let (mut sum, mut size, mut amplitude) = (vector_noise(p), self.lambda, self.omega);
        for _ in 1..self.octaves {
            sum += vector_noise(p * size) * amplitude;
            size *= self.lambda;
            amplitude *= self.omega;
        }
        sum
    }

    /// The scalar sum, as `agate`, `marble` and the spirals use it.
    pub fn scalar(&self, p: Vec3, generator: NoiseGenerator) -> f64 {
        let (mut sum, mut size, mut amplitude) =
            (generator.spread(p).clamp(0.0, 1.0), self.lambda, self.omega);
        for _ in 1..self.octaves {
            sum += generator.spread(p * size) * amplitude;
            size *= self.lambda;
            amplitude *= self.omega;
        }
        sum
    }
}
