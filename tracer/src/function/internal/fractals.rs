//! Sums of noise of many sizes, after Musgrave, and noise by the number of its generator.

use crate::math::Vec3;
use crate::noise::NoiseGenerator;

/// Generator numbers below 2 mean the first.
fn generator(number: f64) -> NoiseGenerator {
    NoiseGenerator::from_number((number as i64).max(1))
}

pub fn noise_generator(p: Vec3, c: &[f64]) -> f64 {
    generator(c[0]).noise(p)
}

/// Noise in -1..=1.
fn signed(generator: NoiseGenerator, p: Vec3) -> f64 {
    2.0 * generator.noise(p) - 1.0
}

/// The size of octave `i`, relative to the first.
fn spectrum(h: f64, lacunarity: f64, octave: i32) -> f64 {
    lacunarity.powi(octave).powf(-h)
}

/// The most octaves summed, so that no number makes a scene hang.
const MOST_OCTAVES: f64 = 1000.0;

/// Ridges: where noise crosses its mean, more so the higher the ridge of the octave before.
pub fn ridged_mf(p: Vec3, c: &[f64]) -> f64 {
    let &[h, lacunarity, octaves, offset, gain, number, ..] = c else { return 0.0 };
    let generator = generator(number);
    let ridge = |q: Vec3| {
        let height = offset - signed(generator, q).abs();
        height * height
    };
    let mut signal = ridge(p);
    let (mut sum, mut q, mut i) = (signal, p, 1);
    while f64::from(i) < octaves.min(MOST_OCTAVES) {
        q = q * lacunarity;
        let weight = (signal * gain).clamp(0.0, 1.0);
        signal = ridge(q) * weight;
        sum += signal * spectrum(h, lacunarity, i);
        i += 1;
    }
    sum
}

/// Terrain that is the rougher the higher it is.
pub fn hetero_mf(p: Vec3, c: &[f64]) -> f64 {
    let &[h, lacunarity, octaves, offset, t, number, ..] = c else { return 0.0 };
    let generator = generator(number);
    let (mut value, mut q, mut i) = (offset + signed(generator, p), p * lacunarity, 1);
    let octaves = octaves.min(MOST_OCTAVES);
    let step = |q: Vec3, i: i32, value: f64| {
        let increment = (signed(generator, q) + offset) * spectrum(h, lacunarity, i);
        increment * value.powi(t as i32)
    };
    while f64::from(i) < octaves {
        value += step(q, i, value);
        q = q * lacunarity;
        i += 1;
    }
    let remainder = octaves - octaves.trunc();
    if remainder != 0.0 {
        value += remainder * value * step(q, i, value);
    }
    value
}

/// A mean of octaves, each folded up at the ridge, then shifted.
pub fn ridge(p: Vec3, c: &[f64]) -> f64 {
    let &[lambda, octaves, omega, offset, ridge, number, ..] = c else { return 0.0 };
    let generator = generator(number);
    // Divided by the larger of what lies below and above.
    let around = |value: f64, middle: f64| (value - middle) / middle.max(1.0 - middle);
    let height = |q: Vec3| around(around(generator.noise(q), ridge).abs(), offset);
    let (mut sum, mut total, mut q, mut weight) = (height(p), 1.0, p, 1.0);
    let mut left = octaves.min(MOST_OCTAVES) - 1.0;
    while left > 0.0 {
        q = q * lambda;
        weight *= omega;
        // The last octave may count in part.
        let share = weight * left.min(1.0);
        sum += share * height(q);
        total += share;
        left -= 1.0;
    }
    sum / total
}
