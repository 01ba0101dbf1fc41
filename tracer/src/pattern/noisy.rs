//! SDL: `agate`, `granite`, `wrinkles`, `dents`: sums and powers of noise.

use super::wave::cycloidal;
use super::Modifiers;
use crate::math::Vec3;
use crate::noise::{NoiseGenerator, Octaves};

/// Bands along z, bent by turbulence of strength `agate_turb`.
pub(super) fn agate(p: Vec3, agate_turb: f64, modifiers: &Modifiers) -> f64 {
    let octaves = modifiers.turbulence.map_or(Octaves::default(), |t| t.octaves);
    let turbulence = agate_turb * octaves.scalar(p, modifiers.noise_generator);
    let band = 0.5 * (cycloidal(1.3 * turbulence + 1.1 * p.z) + 1.0);
    band.clamp(0.0, 1.0).powf(0.77)
}

/// Six octaves of creased noise, from frequency 4 up.
pub(super) fn granite(p: Vec3, generator: NoiseGenerator) -> f64 {
    let creased = |q: Vec3| match generator {
        NoiseGenerator::Original => (0.5 - generator.noise(q)).abs(),
        _ => (1.0 - 2.0 * generator.noise(q)).abs().min(0.5),
    };
    (0..6).map(|octave| f64::from(1 << octave)).map(|f| creased(p * (4.0 * f)) / f).sum()
}

/// Ten octaves of stretched noise, halved.
pub(super) fn wrinkles(p: Vec3, generator: NoiseGenerator) -> f64 {
    let octave = |i: i32| generator.spread(p * f64::from(1 << i)).clamp(0.0, 1.0) / f64::from(1 << i);
    (0..10).map(octave).sum::<f64>() / 2.0
}

/// Noise, cubed.
pub(super) fn dents(p: Vec3, generator: NoiseGenerator) -> f64 {
    generator.noise(p).powi(3)
}
