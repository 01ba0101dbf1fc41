//! SDL: `media { absorption C emission C scattering { I, C } density { ... } }`: what light meets in a volume.

mod density;
mod phase;

pub use phase::Phase;

use std::sync::Arc;

use crate::color::Rgb;
use crate::graph::interior as graph;
use crate::math::{Transform, Vec3};
use crate::pattern::SurfaceContext;
use crate::texture::{Builder, Pigment};

/// A medium ready for sampling.
#[derive(Debug)]
pub struct Media {
    /// How rays sample it.
    pub sampling: Sampling,
    /// Light of its own per unit of length.
    pub emission: Rgb,
    /// Light that it throws aside per unit of length.
    pub scattering: Rgb,
    /// Whereto it throws light.
    pub phase: Phase,
    /// Light that is lost per unit of length: absorbed, or scattered as far as `extinction` says.
    pub extinction: Rgb,
    /// Whether photons light it up.
    pub collect: bool,
    density: Density,
}

/// `method`, `intervals`, `samples` and what goes with them.
#[derive(Clone, Debug)]
pub struct Sampling {
    /// 1: at random, 2: evenly, 3: adaptively.
    pub method: u8,
    /// Into how many parts a ray is cut.
    pub intervals: usize,
    /// Least and greatest number of samples in each part.
    pub samples: (usize, usize),
    /// Method 3: neighbours that differ by more are looked at more closely.
    pub aa_threshold: f64,
    /// Method 3: how closely at most.
    pub aa_level: usize,
    /// Methods 1 and 2: how sure the mean must be.
    pub confidence: f64,
    /// Methods 1 and 2: the mean's variance that is good enough.
    pub variance: f64,
    /// The share of the parts that lie in light.
    pub ratio: f64,
    /// How far samples are displaced at random.
    pub jitter: f64,
}

/// The product of all densities.
#[derive(Debug)]
enum Density {
    Constant(Rgb),
    Varying { factor: Rgb, patterns: Vec<Pigment>, space: Option<Arc<Transform>> },
}

impl Media {
    /// Makes a medium ready that stands in a space of its own.
    pub fn new(media: &graph::Media, space: Option<Arc<Transform>>, patterns: &mut Builder) -> Media {
        let scattering = media.scattering.as_ref();
        let scattered = scattering.map_or(Rgb::BLACK, |s| s.color * s.extinction);
        let (mut factor, mut varying) = (Rgb::WHITE, Vec::new());
        for density in &media.densities {
            match patterns.density(density) {
                Pigment::Solid(color) => factor = factor.mul_each(color.rgb),
                pattern => varying.push(pattern),
            }
        }
        Media {
            sampling: Sampling {
                method: media.method,
                intervals: media.intervals.max(1),
                samples: (media.samples.0.max(1), media.samples.1),
                aa_threshold: media.aa_threshold,
                aa_level: media.aa_level.max(1),
                confidence: media.confidence,
                variance: media.variance,
                ratio: media.ratio,
                jitter: media.jitter,
            },
            emission: media.emission,
            scattering: scattering.map_or(Rgb::BLACK, |s| s.color),
            phase: scattering.map_or(Phase::Isotropic, |s| Phase::new(s.kind, s.eccentricity)),
            extinction: media.absorption + scattered,
            collect: media.collect,
            density: if varying.is_empty() {
                Density::Constant(factor)
            } else {
                Density::Varying { factor, patterns: varying, space }
            },
        }
    }

    /// The density at a point of the world.
    #[inline]
    pub fn density(&self, point: Vec3) -> Rgb {
        match &self.density {
            Density::Constant(density) => *density,
            Density::Varying { factor, patterns, space } => {
                let point = space.as_ref().map_or(point, |space| space.inverse_point(point));
                let mut density = *factor;
                for pattern in patterns {
                    if density == Rgb::BLACK {
                        break;
                    }
                    density = density.mul_each(pattern.color(point, &SurfaceContext::NONE).rgb);
                }
                density
            }
        }
    }

    /// The density, if it is the same everywhere.
    pub fn constant_density(&self) -> Option<Rgb> {
        match self.density {
            Density::Constant(density) => Some(density),
            Density::Varying { .. } => None,
        }
    }
}
