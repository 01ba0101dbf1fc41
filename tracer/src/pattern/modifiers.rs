//! SDL: transforms, `warp {...}`, `turbulence V octaves I omega F lambda F`, `noise_generator I`, `uv_mapping`.

use super::{SurfaceContext, Waveform};
use crate::math::Vec3;
use crate::noise::{NoiseGenerator, Octaves};
use crate::warp::Warp;

/// Turbulence of a given amount along each axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurbulenceModifier {
    /// Factor of the displacement.
    pub amount: Vec3,
    /// What is summed.
    pub octaves: Octaves,
}

impl TurbulenceModifier {
    /// The point, displaced.
    #[inline]
    pub fn displace(&self, p: Vec3) -> Vec3 {
        p + self.octaves.vector(p).mul_each(self.amount)
    }
}

/// What all patterns share.
#[derive(Clone, Debug, Default)]
pub struct Modifiers {
    /// In source order; the last is undone first.
    pub warps: Vec<Warp>,
    /// The classic modifier: applied after all warps.
    pub turbulence: Option<TurbulenceModifier>,
    /// Frequency, phase and wave.
    pub waveform: Waveform,
    /// For the noise-based patterns.
    pub noise_generator: NoiseGenerator,
    /// Evaluate at the surface's uv coordinates.
    pub uv_mapping: bool,
}

impl Modifiers {
    /// Where in the pattern's own space `p` lies; `without_turbulence` for patterns that treat it themselves.
    #[inline]
    pub fn locate(&self, p: Vec3, surface: &SurfaceContext, without_turbulence: bool) -> Vec3 {
        let start = if self.uv_mapping { surface.uv_point() } else { p };
        let q = self.warps.iter().rev().fold(start, |q, warp| warp.apply(q));
        match &self.turbulence {
            Some(turbulence) if !without_turbulence => turbulence.displace(q),
            _ => q,
        }
    }
}
