//! Helpers of the tests: random numbers that are the same on every run.

use crate::math::{vec3, Vec3};

/// A small generator (xorshift).
pub struct Random(u64);

impl Random {
    /// Starts a sequence.
    pub fn new(seed: u64) -> Random {
        Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    /// Between 0 and 1.
    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Each component between -size and size.
    pub fn vector(&mut self, size: f64) -> Vec3 {
        let mut one = || (self.unit() * 2.0 - 1.0) * size;
        vec3(one(), one(), one())
    }
}
