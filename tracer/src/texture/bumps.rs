//! SDL: `normal { bumps | dents | wrinkles | ripples | waves | quilted | facets | bump_map ... }`: bumps by formula.

use crate::math::Vec3;
use crate::noise::{vector_noise, NoiseGenerator};
use crate::pattern::{quilted_bump, Facets, ImagePattern, WaveSources, Waveform};

/// A pattern that turns normals by itself, with its amount.
#[derive(Clone, Debug)]
pub struct Bumps {
    /// How far, and which way.
    pub amount: f64,
    /// How.
    pub kind: BumpKind,
}

/// Named after their keywords.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub enum BumpKind {
    Bumps,
    Dents(NoiseGenerator),
    Wrinkles,
    Ripples(WaveSources, Waveform),
    Waves(WaveSources, Waveform),
    Quilted { control0: f64, control1: f64 },
    Facets(Facets),
    BumpMap(Box<ImagePattern>),
}

impl Bumps {
    /// The normal `n` at `p`, perturbed; of any length.
    pub fn perturb(&self, p: Vec3, n: Vec3) -> Vec3 {
        let turn = match &self.kind {
            BumpKind::Bumps => vector_noise(p),
            BumpKind::Dents(generator) => vector_noise(p) * generator.noise(p).powi(3),
            BumpKind::Wrinkles => wrinkles(p),
            BumpKind::Ripples(sources, waveform) => sources.ripple_bump(p, waveform),
            BumpKind::Waves(sources, waveform) => sources.wave_bump(p, waveform),
            BumpKind::Quilted { control0, control1 } => quilted_bump(p, *control0, *control1),
            BumpKind::BumpMap(image) => return image.mapping.bump(p, n, image.used, self.amount),
            BumpKind::Facets(facets) => return facets.perturb(p, n),
        };
        n + turn * self.amount
    }
}

/// Ten octaves of creased vector noise.
fn wrinkles(p: Vec3) -> Vec3 {
    let octave = |i: i32| vector_noise(p * f64::from(1 << i)).map(f64::abs) / f64::from(1 << i);
    (0..10).map(octave).fold(Vec3::ZERO, |sum, v| sum + v)
}
