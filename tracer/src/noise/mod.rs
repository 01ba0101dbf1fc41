//! SDL: `noise_generator 1|2|3`, `f_noise3d`, `f_noise_generator`: POV-Ray's noise, to the digit.
//!
//! The tables follow from a seeded shuffle (`random`) and from coefficients read off at lattice points.

mod coefficients;
mod lattice;
mod mersenne;
mod perlin;
mod random;
mod turbulence;

use crate::math::Vec3;

pub use lattice::{hash3, vector_noise};
pub use mersenne::MersenneTwister;
pub use random::Lcg;
pub use turbulence::Octaves;

/// `noise_generator`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum NoiseGenerator {
    /// 1: signed noise plus one half, cut off at 0 and 1 (plateaus).
    Original,
    /// 2: rescaled to fit 0..1.
    #[default]
    RangeCorrected,
    /// 3: Perlin's gradient noise.
    Perlin,
}

impl NoiseGenerator {
    /// By SDL's number; anything else is generator 2.
    pub fn from_number(number: i64) -> NoiseGenerator {
        match number {
            1 => NoiseGenerator::Original,
            3 => NoiseGenerator::Perlin,
            _ => NoiseGenerator::RangeCorrected,
        }
    }

    /// Noise in 0..=1.
    #[inline]
    pub fn noise(self, p: Vec3) -> f64 {
        match self {
            NoiseGenerator::Original => (lattice::signed_noise(p) + 0.5).clamp(0.0, 1.0),
            // Shift and scale map the extremes of the signed noise to 0 and 1.
            NoiseGenerator::RangeCorrected => {
                ((lattice::signed_noise(p) + 1.05242) * 0.48985582).clamp(0.0, 1.0)
            }
            NoiseGenerator::Perlin => perlin::noise(p),
        }
    }

    /// Noise for sums of octaves: generators 2 and 3 are spread to reach as far as generator 1, beyond 0..=1.
    #[inline]
    pub fn spread(self, p: Vec3) -> f64 {
        match self {
            NoiseGenerator::Original => self.noise(p),
            _ => 2.0 * self.noise(p) - 0.5,
        }
    }
}
